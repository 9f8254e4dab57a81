// SPDX-License-Identifier: MIT
// The residue system: its matrix, its null space, and the antiderivatives.
#include "hodograph/rational/solution_space.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdlib>
#include <utility>

#include "echelon.hpp"
#include "flint.hpp"
#include "hermite_reduction.hpp"
#include "hodograph/foundation/interruption.hpp"
#include "hodograph/rational/motion_polynomial.hpp"
#include "input_faults.hpp"

namespace hodograph {

using rational_detail::HermiteReduction;
using rational_detail::IntegerMatrix;
using rational_detail::RationalMatrix;
using rational_detail::raw;
using rational_detail::signed_size;

namespace {

std::size_t degree_of(const RationalPolynomial& p) {
  return static_cast<std::size_t>(std::max(p.degree(), 0));
}

/// The h of degree below `unknowns` ≤ deg α + deg rad α for which ∫ h F_c / (α rad α) has no part
/// with simple poles, for every component F_c.
std::vector<RationalPolynomial> residue_free(const HermiteReduction& reduction,
                                             const std::vector<RationalPolynomial>& components,
                                             std::size_t unknowns) {
  const std::size_t rho = degree_of(reduction.radical());
  // What t^k leaves for every k that occurs; the components are combinations of these.
  std::size_t longest = 0;
  for (const auto& p : components) longest = std::max(longest, degree_of(p));
  std::vector<RationalPolynomial> residues;
  RationalPolynomial power(1);
  for (std::size_t k = 0; k < unknowns + longest; ++k) {
    power = power % reduction.denominator();
    residues.push_back(reduction.reduce(power).logarithmic);
    power = power.times_power(1);
  }
  // Columns by falling degree: the null space then comes in that echelon form. Whole numbers: all
  // residues are multiplied by one number, every component by another.
  const auto common = [](const std::vector<RationalPolynomial>& all) {
    fmpz_t denominator;
    fmpz_init_set_ui(denominator, 1);
    for (const auto& p : all) fmpz_lcm(denominator, denominator, fmpq_poly_denref(raw(p)));
    Rational result;
    fmpz_swap(&raw(result)->num, denominator);
    fmpz_clear(denominator);
    return RationalPolynomial(result);
  };
  const RationalPolynomial residue_scale = common(residues), scale = common(components);
  for (RationalPolynomial& residue : residues) residue *= residue_scale;
  IntegerMatrix equations(components.size() * rho, unknowns);
  for (std::size_t c = 0; c < components.size(); ++c) {
    const RationalPolynomial whole = scale * components[c];
    if (whole.is_zero()) continue;
    const fmpz* f = fmpq_poly_numref(raw(whole));
    for (std::size_t k = 0; k < unknowns; ++k) {
      check_interruption();
      for (std::size_t i = 0; i <= degree_of(whole); ++i) {
        const auto length = static_cast<std::size_t>(fmpq_poly_length(raw(residues[k + i])));
        for (std::size_t r = 0; r < length; ++r) {
          fmpz_addmul(equations.at(c * rho + r, unknowns - 1 - k), f + i,
                      fmpq_poly_numref(raw(residues[k + i])) + r);
        }
      }
    }
  }
  const RationalMatrix solutions = equations.null_space();
  std::vector<RationalPolynomial> result(solutions.rows());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t j = 0; j < unknowns; ++j) {
      fmpq_poly_set_coeff_fmpq(raw(result[i]), signed_size(unknowns - 1 - j), solutions.at(i, j));
    }
  }
  return result;
}

/// The reduced row echelon form of the coefficients of some vectors of polynomials, in the order
/// (t^d of the first component, t^d of the second, ..., t^(d-1) of the first, ...), d the largest
/// degree.
template <std::size_t components>
std::vector<std::array<RationalPolynomial, components>> echelon(
    const std::vector<std::array<const RationalPolynomial*, components>>& span) {
  std::size_t count = 0;
  for (const auto& row : span) {
    for (const RationalPolynomial* p : row) count = std::max(count, degree_of(*p) + 1);
  }
  IntegerMatrix matrix(span.size(), components * count);
  fmpz_t common, factor;
  fmpz_init(common);
  fmpz_init(factor);
  for (std::size_t i = 0; i < span.size(); ++i) {
    fmpz_one(common);
    for (const RationalPolynomial* p : span[i]) {
      fmpz_lcm(common, common, fmpq_poly_denref(raw(*p)));
    }
    for (std::size_t c = 0; c < components; ++c) {
      const fmpq_poly_struct* p = raw(*span[i][c]);
      fmpz_divexact(factor, common, fmpq_poly_denref(p));
      for (slong k = 0; k < fmpq_poly_length(p); ++k) {
        const std::size_t column = components * (count - 1 - static_cast<std::size_t>(k)) + c;
        fmpz_mul(matrix.at(i, column), fmpq_poly_numref(p) + k, factor);
      }
    }
  }
  fmpz_clear(common);
  fmpz_clear(factor);
  rational_detail::Echelon form = rational_detail::reduced_echelon(std::move(matrix));
  std::vector<std::array<RationalPolynomial, components>> result(form.pivots.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    for (std::size_t c = 0; c < components; ++c) {
      fmpq_poly_struct* p = raw(result[i][c]);
      fmpq_poly_fit_length(p, signed_size(count));
      for (std::size_t k = 0; k < count; ++k) {
        fmpz_set(fmpq_poly_numref(p) + k, form.rows.at(i, components * (count - 1 - k) + c));
      }
      fmpz_set(fmpq_poly_denref(p), form.rows.at(i, form.pivots[i]));
      _fmpq_poly_set_length(p, signed_size(count));
      fmpq_poly_canonicalise(p);
    }
  }
  return result;
}

/// The reduced echelon basis by falling degree of the span of some polynomials.
std::vector<RationalPolynomial> echelon(const std::vector<RationalPolynomial>& span) {
  std::vector<std::array<const RationalPolynomial*, 1>> rows;
  for (const RationalPolynomial& p : span) rows.push_back({&p});
  std::vector<RationalPolynomial> result;
  for (auto& row : echelon<1>(rows)) result.push_back(std::move(row[0]));
  return result;
}

/// The numerator over α of the antiderivative of h F_c / (α rad α) that has no constant.
RationalPolynomial antiderivative(const HermiteReduction& reduction, const RationalPolynomial& p) {
  const auto parts = reduction.reduce(p % reduction.denominator());
  assert(parts.logarithmic.is_zero());
  return parts.rational + reduction.alpha() * (p / reduction.denominator()).integral();
}

}  // namespace

std::string_view name_of(CurveKind kind) {
  switch (kind) {
    case CurveKind::constant:
      return "constant";
    case CurveKind::polynomial:
      return "polynomial";
    case CurveKind::rational:
      return "rational";
  }
  return "";
}

CurveKind kind_of(const VectorPolynomial& b, const RationalPolynomial& alpha) {
  for (std::size_t c = 0; c < 3; ++c) {
    if (!divides(alpha, b[c])) return CurveKind::rational;
  }
  return degree(b) <= alpha.degree() ? CurveKind::constant : CurveKind::polynomial;
}

Result<SolutionSpace> solve(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                            std::size_t degree) {
  if (auto fault = rational_detail::input_fault(a, alpha)) return *fault;
  if (degree > largest_solution_degree) {
    return rational_detail::degree_fault("B", degree, largest_solution_degree);
  }

  const HermiteReduction hermite(alpha);
  SolutionSpace space;
  space.reduction_ = *reduction(a);
  space.alpha_ = alpha;
  space.radical_ = hermite.radical();
  space.indicatrix_ = indicatrix(space.reduction_.reduced);
  space.degree_ = degree;

  const VectorPolynomial& f = space.indicatrix_;
  const std::size_t m = degree_of(alpha), rho = degree_of(space.radical_);
  const std::size_t e = 2 * static_cast<std::size_t>(hodograph::degree(space.reduction_.reduced));
  const std::size_t unknowns = degree + rho > e ? std::min(degree + rho - e, m + rho) : 0;

  const RationalPolynomial half(Rational(-1, 2));
  space.rational_numerators_ = residue_free(hermite, {f.x, f.y, f.z}, unknowns);
  for (const RationalPolynomial& h : space.rational_numerators_) {
    const VectorPolynomial r{antiderivative(hermite, h * f.x), antiderivative(hermite, h * f.y),
                             antiderivative(hermite, h * f.z)};
    space.basis_.push_back(half * r);
  }
  if (degree > m + e) {
    space.polynomials_ = degree - m - e;
    for (std::size_t k = space.polynomials_; k-- > 0;) {
      const VectorPolynomial r{f.x.times_power(k).integral(), f.y.times_power(k).integral(),
                               f.z.times_power(k).integral()};
      space.basis_.push_back(alpha * r);
    }
  }
  if (degree >= m) {
    space.constants_ = 3;
    space.basis_.push_back({alpha, {}, {}});
    space.basis_.push_back({{}, alpha, {}});
    space.basis_.push_back({{}, {}, alpha});
  }
  return space;
}

std::vector<RationalPolynomial> SolutionSpace::lambda_numerators() const {
  std::vector<RationalPolynomial> span = rational_numerators_;
  const RationalPolynomial common = alpha_.monic() * radical_;
  for (std::size_t k = 0; k < polynomials_; ++k) span.push_back(common.times_power(k));
  return echelon(span);
}

std::vector<RationalPolynomial> SolutionSpace::rational_length_numerators() const {
  const HermiteReduction hermite(alpha_);
  const RationalPolynomial speed = norm_polynomial(preimage());
  // ∫ λ |A|² is linear in λ: combinations of the truly rational elements without residues.
  const std::size_t rho = degree_of(radical_), count = rational_numerators_.size();
  RationalMatrix equations(rho, count);
  for (std::size_t k = 0; k < count; ++k) {
    const RationalPolynomial residue =
        hermite.reduce((rational_numerators_[k] * speed) % hermite.denominator()).logarithmic;
    for (std::size_t i = 0; i < rho; ++i) equations.set_coefficient(i, k, residue, i);
  }
  const RationalMatrix solutions = equations.null_space();
  std::vector<RationalPolynomial> span(solutions.rows());
  for (std::size_t i = 0; i < span.size(); ++i) {
    for (std::size_t k = 0; k < count; ++k) {
      Rational c;
      fmpq_set(raw(c), solutions.at(i, k));
      span[i] += RationalPolynomial(c) * rational_numerators_[k];
    }
  }
  const RationalPolynomial common = alpha_.monic() * radical_;
  for (std::size_t k = 0; k < polynomials_; ++k) span.push_back(common.times_power(k));
  return echelon(span);
}

std::vector<VectorPolynomial> SolutionSpace::canonical_basis() const {
  std::vector<std::array<const RationalPolynomial*, 3>> rows;
  for (const VectorPolynomial& b : basis_) rows.push_back({&b.x, &b.y, &b.z});
  std::vector<VectorPolynomial> result;
  for (auto& [x, y, z] : echelon<3>(rows)) {
    result.push_back({std::move(x), std::move(y), std::move(z)});
  }
  assert(result.size() == basis_.size());
  return result;
}

double SolutionSpace::canonical_basis_work() const {
  double bits = 0.0;
  for (const VectorPolynomial& b : basis_) {
    slong largest = 0, denominator = 0;
    for (std::size_t c = 0; c < 3; ++c) {
      const fmpq_poly_struct* p = raw(b[c]);
      largest =
          std::max(largest, std::abs(_fmpz_vec_max_bits(fmpq_poly_numref(p), fmpq_poly_length(p))));
      denominator = std::max(denominator, static_cast<slong>(fmpz_bits(fmpq_poly_denref(p))));
    }
    bits += static_cast<double>(largest + denominator);
  }
  const auto rows = static_cast<double>(basis_.size());
  return rows * rows * static_cast<double>(3 * (degree_ + 1)) * bits;
}

RationalPolynomial mu_of(const VectorPolynomial& b, const RationalPolynomial& alpha,
                         const VectorPolynomial& indicatrix) {
  const VectorPolynomial left = alpha * derivative(b) - alpha.derivative() * b;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!indicatrix[c].is_zero()) return left[c] / indicatrix[c];
  }
  return {};
}

}  // namespace hodograph
