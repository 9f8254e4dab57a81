// SPDX-License-Identifier: MIT
// How long does the space of all rational PH curves take, by the residue system, and what does its
// canonical basis cost, against the plain way: elimination of system (7) of "Rational Framing
// Motions and Spatial Rational Pythagorean Hodograph Curves" over the rationals?
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/rational_ph_curve.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

/// Whole coefficients of up to `bits` bits.
RationalPolynomial random_polynomial(bench::Numbers& numbers, std::size_t degree, int bits) {
  std::vector<Rational> c;
  const double size = std::ldexp(1.0, bits - 1);
  for (std::size_t k = 0; k <= degree; ++k) {
    c.push_back(Rational::exactly(std::floor(numbers.within(-size, size))).value() + Rational(1));
  }
  return RationalPolynomial(c);
}
QuaternionPolynomial random_preimage(std::size_t degree, int bits) {
  bench::Numbers numbers;
  QuaternionPolynomial a;
  for (std::size_t i = 0; i < 4; ++i) a[i] = random_polynomial(numbers, degree, bits);
  return a;
}

/// The nullity of system (7), by elimination row by row.
std::size_t plain_dimension(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                            std::size_t d) {
  const VectorPolynomial fj = vector_part(a * QuaternionPolynomial{{}, {}, 1, {}} * conjugate(a));
  const VectorPolynomial fk = vector_part(a * QuaternionPolynomial{{}, {}, {}, 1} * conjugate(a));
  std::vector<std::vector<Rational>> rows;  // one an unknown: the rank is the same
  for (std::size_t unknown = 0; unknown < 3 * (d + 1); ++unknown) {
    VectorPolynomial b;
    b[unknown % 3] = RationalPolynomial::monomial(1, unknown / 3);
    const VectorPolynomial left = alpha * derivative(b) - alpha.derivative() * b;
    const RationalPolynomial first = dot(left, fj), second = dot(left, fk);
    const std::size_t length =
        d + static_cast<std::size_t>(alpha.degree() + degree(fj) + degree(fk) + 1);
    std::vector<Rational> row;
    for (std::size_t k = 0; k < length; ++k) {
      row.push_back(first.coefficient(k));
      row.push_back(second.coefficient(k));
    }
    rows.push_back(std::move(row));
  }
  std::size_t rank = 0;
  for (std::size_t j = 0; j < rows[0].size() && rank < rows.size(); ++j) {
    std::size_t pivot = rank;
    while (pivot < rows.size() && rows[pivot][j].is_zero()) ++pivot;
    if (pivot == rows.size()) continue;
    std::swap(rows[rank], rows[pivot]);
    for (std::size_t i = rank + 1; i < rows.size(); ++i) {
      if (rows[i][j].is_zero()) continue;
      const Rational factor = rows[i][j] / rows[rank][j];
      for (std::size_t k = j; k < rows[i].size(); ++k) rows[i][k] -= factor * rows[rank][k];
    }
    ++rank;
  }
  return rows.size() - rank;
}

/// (t + 2)^3 (t^2 + 1)^2, or the square of a cubic whose coefficients have as many bits as those of
/// A.
void run(std::size_t preimage_degree, int bits, std::size_t d, bool plain, int repetitions,
         bool wide_alpha = false) {
  const auto t = RationalPolynomial::monomial(1, 1);
  bench::Numbers numbers;
  const RationalPolynomial alpha = wide_alpha ? random_polynomial(numbers, 3, bits).power(2)
                                              : (t + 2).power(3) * (t * t + 1).power(2);
  const QuaternionPolynomial a = random_preimage(preimage_degree, bits);
  const SolutionSpace space = solve(a, alpha, d).value();
  std::vector<bench::Rival> rivals;
  if (plain) {
    rivals.push_back(
        {"system (7), plain elimination", [&] { bench::keep(plain_dimension(a, alpha, d)); }, 1.0});
  }
  rivals.push_back(
      {"solve: the space and its parts", [&] { bench::keep(solve(a, alpha, d)); }, 1.0});
  rivals.push_back({"its canonical basis", [&] { bench::keep(space.canonical_basis()); }, 1.0});
  bench::compare("deg A = " + std::to_string(preimage_degree) + ", " + std::to_string(bits) +
                     " bits, deg B <= " + std::to_string(d) +
                     (wide_alpha ? ", alpha of as many bits" : ""),
                 rivals, repetitions);
  std::size_t size = 0;
  for (const VectorPolynomial& b : space.canonical_basis()) {
    for (std::size_t c = 0; c < 3; ++c) size = std::max(size, b[c].bits());
  }
  std::printf("  dimension %zu (%zu truly rational), canonical basis of %zu bits\n\n",
              space.dimension(), space.rational_dimension(), size);
}

/// Where every curve of the indicatrix A i A* has torsion zero: det(F, F', F''), of degree 6 deg A
/// - 6.
void run_torsion_zeros(std::size_t preimage_degree, int bits) {
  const QuaternionPolynomial a = random_preimage(preimage_degree, bits);
  const RationalPhCurve curve = RationalPhCurve::create(a, VectorFunction()).value();
  bench::compare("torsion zeros, deg A = " + std::to_string(preimage_degree) + ", " +
                     std::to_string(bits) + " bits",
                 {{"isolated", [&] { bench::keep(curve.torsion_zeros()); }, 1.0}}, 3);
}

}  // namespace

int main() {
  for (std::size_t n = 2; n <= 8; n += 2) run(n, 4, 30, n == 2, n == 2 ? 3 : 11);
  run(4, 64, 20, false, 5);
  run(4, 64, 30, false, 5);
  run(4, 64, 60, false, 5);
  run(4, 64, 60, false, 5, true);
  run_torsion_zeros(32, 10);
  run_torsion_zeros(32, 64);
  run_torsion_zeros(64, 64);
}
