// SPDX-License-Identifier: MIT
// Theorem 4.6 by greatest common divisors.
#include "hodograph/rational/existence.hpp"

#include <algorithm>
#include <string_view>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "input_faults.hpp"

namespace hodograph {

namespace {

std::size_t degree_of(const RationalPolynomial& p) {
  return static_cast<std::size_t>(std::max(p.degree(), 0));
}

VectorPolynomial remainder(const VectorPolynomial& a, const RationalPolynomial& s) {
  return {a.x % s, a.y % s, a.z % s};
}

/// The part of s at whose roots v vanishes.
RationalPolynomial common_zeros(const RationalPolynomial& s, const VectorPolynomial& v) {
  RationalPolynomial result = s;
  for (std::size_t c = 0; c < 3 && !result.is_one(); ++c) result = gcd(result, v[c] % result);
  return result;
}

PoleStratum stratum(const PolynomialFactor& factor, const VectorPolynomial& f) {
  const RationalPolynomial& s = factor.factor;
  const std::size_t n = factor.multiplicity;
  PoleStratum result{n, s, s, s};
  const auto last = std::min(n, static_cast<std::size_t>(degree(f)));
  std::vector<VectorPolynomial> taylor;
  for (std::size_t k = 0; k <= last; ++k) {
    taylor.push_back(remainder(taylor_coefficient(f, k), s));
  }
  // f_0 ≠ 0 at every root (A is reduced): the rank is 1 where every f_k is a multiple of f_0, and
  // at most 2 where no two of them span the space with f_0.
  for (std::size_t j = 1; j <= last && !result.rank_two.is_one(); ++j) {
    const VectorPolynomial normal = remainder(cross(taylor[0], taylor[j]), s);
    result.rank_one = common_zeros(result.rank_one, normal);
    for (std::size_t k = j + 1; k <= last && !result.rank_two.is_one(); ++k) {
      result.rank_two = gcd(result.rank_two, dot(normal, taylor[k]) % result.rank_two);
    }
  }
  if (result.rank_two.is_one()) result.rank_one = RationalPolynomial(1);
  return result;
}

std::size_t rank(std::vector<RationalVector> vectors) {
  std::size_t rank = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    std::size_t pivot = rank;
    while (pivot < vectors.size() && vectors[pivot][c].is_zero()) ++pivot;
    if (pivot == vectors.size()) continue;
    std::swap(vectors[rank], vectors[pivot]);
    for (std::size_t i = rank + 1; i < vectors.size(); ++i) {
      vectors[i] -= (vectors[i][c] / vectors[rank][c]) * vectors[rank];
    }
    ++rank;
  }
  return rank;
}

/// "the pole t = -1 has order 2", or of the roots of a factor of higher degree.
std::string poles_in_words(const RationalPolynomial& q, std::size_t order) {
  const std::string tail = " order " + std::to_string(order);
  if (q.degree() == 1) {
    return "the pole t = " + to_text(-q.coefficient(0) / q.coefficient(1)) + " has" + tail;
  }
  return "the poles at the roots of " + to_text(q) + " have" + tail;
}

/// Why the poles at the roots of the irreducible q do or do not admit a rational curve.
std::string reason_at(const RationalPolynomial& q, const PoleStratum& s) {
  const std::string there = poles_in_words(q, s.order) + " and the indicatrix has ";
  const std::string place = q.degree() == 1 ? " there" : " at each of them";
  const std::string nowhere = q.degree() == 1 ? " there" : " at any of them";
  const bool one = divides(q, s.rank_one), two = divides(q, s.rank_two);
  if (s.order == 1) return there + (one ? "a cusp" + place : "no cusp" + nowhere);
  if (one) return there + "a flat point" + place;
  if (s.order == 2) return there + (two ? "an inflection" + place : "no inflection" + nowhere);
  return poles_in_words(q, s.order) + ", and order 3 or more always admits one";
}

std::string reason(const Existence& answer, bool planar) {
  if (answer.strata.empty()) return "alpha is constant, so every curve is polynomial";
  std::string found, missing;
  for (const PoleStratum& s : answer.strata) {
    for (const PolynomialFactor& q : irreducible_factors(s.poles)) {
      const bool admits = s.order >= 3 || divides(q.factor, s.order == 1 ? s.rank_one : s.rank_two);
      std::string& text = admits ? found : missing;
      if (!text.empty()) text += "; ";
      if (planar && admits && s.order == 2 && !divides(q.factor, s.rank_one)) {
        text += poles_in_words(q.factor, s.order) +
                ", which is enough since the indicatrix lies in a plane";
      } else {
        text += reason_at(q.factor, s);
      }
    }
  }
  if (answer.exists) return "truly rational curves exist: " + found;
  return "every curve is polynomial: " + missing;
}

}  // namespace

std::size_t PoleStratum::freedom() const {
  const std::size_t rank_drops = degree_of(rank_two) + degree_of(rank_one);
  return degree_of(poles) * order + rank_drops - 2 * degree_of(poles);
}

Existence::Dimension Existence::dimension(std::size_t d) const {
  const std::size_t m = alpha_degree, e = indicatrix_degree;
  if (d >= m + e) return {3 + (d - m - e) + freedom, true};
  const std::size_t k = m + e - d;
  const std::size_t tail = k <= e ? tail_ranks[k] : 0;
  const std::size_t kappa = k + tail - std::min(k + tail, tail_ranks[0]);
  return {(d >= m ? 3u : 0u) + freedom - std::min(freedom, kappa), freedom == 0};
}

Result<Existence> existence(const QuaternionPolynomial& a, const RationalPolynomial& alpha) {
  if (auto fault = rational_detail::input_fault(a, alpha)) return *fault;
  const Reduction reduced = *reduction(a);
  const VectorPolynomial f = indicatrix(reduced.reduced);
  Existence answer;
  answer.alpha_degree = degree_of(alpha);
  answer.indicatrix_degree = static_cast<std::size_t>(degree(f));
  for (const PolynomialFactor& factor : square_free_factors(alpha)) {
    answer.strata.push_back(stratum(factor, f));
    answer.freedom += answer.strata.back().freedom();
  }
  answer.exists = answer.freedom > 0;
  std::vector<RationalVector> tail;
  answer.tail_ranks.resize(answer.indicatrix_degree + 1);
  for (std::size_t k = answer.indicatrix_degree + 1; k-- > 0;) {
    tail.push_back({f.x.coefficient(k), f.y.coefficient(k), f.z.coefficient(k)});
    answer.tail_ranks[k] = rank(tail);
  }
  answer.reason = reason(answer, answer.tail_ranks[0] < 3);
  return answer;
}

}  // namespace hodograph
