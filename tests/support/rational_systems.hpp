// SPDX-License-Identifier: MIT
// Systems (6), (7), (8) of "Rational Framing Motions and Spatial Rational Pythagorean Hodograph
// Curves" against the residue system, on random and special input; what the suite samples and the
// campaign runs at length.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "support/rational_golden.hpp"

namespace hodograph::test {

// Ranks modulo the system_prime 2^61 - 1 bound ranks over ℚ from below, so nullities from above.
inline constexpr std::uint64_t system_prime = (std::uint64_t{1} << 61) - 1;
__extension__ using Wide = unsigned __int128;
inline std::uint64_t times(std::uint64_t a, std::uint64_t b) {
  return static_cast<std::uint64_t>(Wide(a) * b % system_prime);
}
inline std::uint64_t inverse(std::uint64_t a) {
  std::uint64_t result = 1;
  for (std::uint64_t k = system_prime - 2; k > 0; k >>= 1, a = times(a, a)) {
    if ((k & 1) != 0) result = times(result, a);
  }
  return result;
}
inline std::uint64_t residue(const std::string& digits) {
  std::uint64_t r = 0;
  for (const char c : digits) {
    if (c != '-') r = (times(r, 10) + static_cast<std::uint64_t>(c - '0')) % system_prime;
  }
  return !digits.empty() && digits[0] == '-' && r != 0 ? system_prime - r : r;
}
inline std::uint64_t residue(const Rational& x) {
  const std::string text = to_text(x);
  const std::size_t slash = text.find('/');
  const std::uint64_t top = residue(text.substr(0, slash));
  return slash == std::string::npos ? top : times(top, inverse(residue(text.substr(slash + 1))));
}

using Row = std::vector<std::uint64_t>;
inline std::size_t rank(std::vector<Row> m) {
  std::size_t rank = 0;
  const std::size_t columns = m.empty() ? 0 : m[0].size();
  for (std::size_t j = 0; j < columns && rank < m.size(); ++j) {
    std::size_t pivot = rank;
    while (pivot < m.size() && m[pivot][j] == 0) ++pivot;
    if (pivot == m.size()) continue;
    std::swap(m[rank], m[pivot]);
    const std::uint64_t scale = inverse(m[rank][j]);
    for (std::size_t i = rank + 1; i < m.size(); ++i) {
      if (m[i][j] == 0) continue;
      const std::uint64_t factor = times(m[i][j], scale);
      for (std::size_t k = j; k < columns; ++k) {
        m[i][k] = (m[i][k] + system_prime - times(factor, m[rank][k])) % system_prime;
      }
    }
    ++rank;
  }
  return rank;
}

/// The nullity, modulo the system_prime, of the linear map that takes each of the unknowns to
/// polynomials.
template <class Image>
std::size_t nullity(std::size_t unknowns, const Image& image) {
  std::vector<Row> rows(unknowns);
  std::size_t length = 0;
  for (std::size_t k = 0; k < unknowns; ++k) {
    std::vector<RationalPolynomial> parts = image(k);
    for (std::size_t c = 0; c < parts.size(); ++c) {
      for (int i = 0; i <= parts[c].degree(); ++i) {
        const std::size_t at = parts.size() * static_cast<std::size_t>(i) + c;
        if (rows[k].size() <= at) rows[k].resize(at + 1);
        rows[k][at] = residue(parts[c].coefficient(static_cast<std::size_t>(i)));
      }
    }
    length = std::max(length, rows[k].size());
  }
  for (Row& row : rows) row.resize(length);
  return unknowns - rank(std::move(rows));
}

struct Nullities {
  std::size_t six, seven, eight;
};
/// The nullities of systems (6), (7), (8) for deg B ≤ d.
inline Nullities nullities(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                           std::size_t d) {
  const VectorPolynomial f = indicatrix(a);
  const QuaternionPolynomial j{{}, {}, 1, {}}, k{{}, {}, {}, 1};
  const VectorPolynomial fj = vector_part(a * j * conjugate(a));
  const VectorPolynomial fk = vector_part(a * k * conjugate(a));
  const auto left = [&](std::size_t unknown) {
    VectorPolynomial b;
    b[unknown % 3] = RationalPolynomial::monomial(1, unknown / 3);
    return alpha * derivative(b) - alpha.derivative() * b;
  };
  const std::size_t unknowns = 3 * (d + 1);
  Nullities result{};
  result.six = nullity(unknowns, [&](std::size_t u) {
    const VectorPolynomial c = cross(left(u), f);
    return std::vector<RationalPolynomial>{c.x, c.y, c.z};
  });
  result.seven = nullity(unknowns, [&](std::size_t u) {
    return std::vector<RationalPolynomial>{dot(left(u), fj), dot(left(u), fk)};
  });
  const int most = std::max(-1, alpha.degree() + static_cast<int>(d) - 1 - degree(f));
  result.eight = nullity(unknowns + static_cast<std::size_t>(most + 1), [&](std::size_t u) {
    const VectorPolynomial c =
        u < unknowns ? left(u) : RationalPolynomial::monomial(-1, u - unknowns) * f;
    return std::vector<RationalPolynomial>{c.x, c.y, c.z};
  });
  return result;
}

/// Every element solves (6), (7) and (8), and the elements are as many as any system has.
inline void expect_all_systems_agree(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                                     std::size_t d) {
  SCOPED_TRACE("alpha = " + to_text(alpha) + ", d = " + std::to_string(d));
  const SolutionSpace space = solve(a, alpha, d).value();
  const VectorPolynomial& f = space.indicatrix();
  for (const VectorPolynomial& b : space.basis()) {
    EXPECT_LE(degree(b), static_cast<int>(d));
    const VectorPolynomial left = alpha * derivative(b) - alpha.derivative() * b;
    EXPECT_LT(degree(cross(left, f)), 0);
    EXPECT_EQ(mu_of(b, alpha, f) * f, left);
    EXPECT_TRUE(is_framing(framing_motion(space.preimage(), alpha, b)));
  }
  // The basis is independent: its canonical form has as many elements.
  EXPECT_EQ(space.canonical_basis().size(), space.dimension());
  const Nullities other = nullities(space.preimage(), alpha, d);
  EXPECT_EQ(other.six, space.dimension());
  EXPECT_EQ(other.seven, space.dimension());
  EXPECT_EQ(other.eight, space.dimension());
}

/// Small A, α = p^a q^b and a degree; the first half of what solutions can be.
inline void compare_systems_on_random_input(Random& random, std::size_t count) {
  for (std::size_t n = 0; n < count; ++n) {
    const auto a = random_quaternion_polynomial(random, random.index(4), 3);
    auto alpha = random_polynomial(random, random.index(3), 3).power(1 + random.index(3));
    if (random.chance(0.5)) alpha *= random_polynomial(random, 1, 3).power(1 + random.index(4));
    const auto e = static_cast<std::size_t>(degree(indicatrix(reduction(a).value().reduced)));
    const std::size_t d = random.index(static_cast<std::size_t>(alpha.degree()) + e + 4);
    expect_all_systems_agree(a, alpha, d);
  }
}

/// A cusp of the indicatrix at a pole, a planar indicatrix, poles at all inflections, in turns.
inline void compare_systems_on_special_input(Random& random, std::size_t count) {
  const auto t = RationalPolynomial::monomial(1, 1);
  for (std::size_t n = 0; n < count; ++n) {
    auto a = random_quaternion_polynomial(random, 1 + random.index(3), 3);
    RationalPolynomial alpha = t * random_polynomial(random, 1, 3);
    if (n % 3 == 0) {  // A = 1 + (x + y i) t + ...
      a = QuaternionPolynomial{1, {}, {}, {}} + (t * t) * a;
    } else if (n % 3 == 1) {
      a.x = a.y = RationalPolynomial();
    } else {
      const auto f = indicatrix(reduction(a).value().reduced);
      const auto torsion = determinant(f, derivative(f), taylor_coefficient(f, 2));
      alpha = torsion.is_zero() ? t.power(2) : radical(torsion).power(2);
    }
    const std::size_t d = static_cast<std::size_t>(alpha.degree()) + random.index(8);
    expect_all_systems_agree(a, alpha, d);
  }
}

}  // namespace hodograph::test
