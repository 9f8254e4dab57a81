// SPDX-License-Identifier: MIT
// Hermite data inside a space of rational PH curves: the curves that run from one point to another,
// if wished with given derivatives there, as an affine space, exactly.
//
// With r' = λ F and λ = Σ c_i h_i / (α rad α), the end points are the linear conditions
// Σ c_i (r_i(end) - r_i(begin)) = P_1 - P_0, and derivatives at the ends, which are multiples of
// F there, are λ = v · F / F · F. The directions at the ends are those of F: they belong to A.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "hodograph/rational/rational_ph_curve.hpp"

namespace hodograph {

/// What the curves should do at the ends of [begin, end]. Without derivatives: G¹ data, whose
/// directions A carries (hermite_preimage.hpp).
struct RationalHermiteData {
  RationalVector begin_point, end_point;
  std::optional<RationalVector> begin_derivative, end_derivative;  ///< with respect to t
  Rational begin = 0, end = 1;
};

/// All curves r = -2 B / α + constant, B in V_d, that meet such data: λ = λ_0 + Σ x_k λ_k, k <
/// freedom(). Immutable.
class HermiteCurves {
 public:
  /// Faults: not_increasing (begin ≥ end); zero_speed (a derivative 0); outside_domain (α has a
  /// root in [begin, end]; a derivative that is no positive multiple of F there, index 0 begin, 1
  /// end). Conditions that contradict each other are no fault: see solvable().
  static Result<HermiteCurves> create(const SolutionSpace& space, RationalHermiteData data);

  const SolutionSpace& space() const { return space_; }
  const RationalHermiteData& data() const { return data_; }

  /// The numbers c_i, and the equations for them: 3, and one more for every derivative.
  std::size_t unknowns() const { return numerators_.size(); }
  std::size_t equations() const { return equations_; }
  /// True when the equations have a solution.
  bool solvable() const { return contradiction_.empty(); }
  /// Where they have none: numbers y_j, one an equation, for which Σ y_j equation_j reads 0 = 1.
  const std::vector<Rational>& contradiction() const { return contradiction_; }
  /// The number of free parameters x_k; 0 where the curve is the only one, or there is none.
  std::size_t freedom() const { return directions_.size(); }

  /// The matrix of the equations, one row each, and their right sides last.
  const std::vector<std::vector<Rational>>& system() const { return system_; }

  /// h of λ = h / (α rad α) for the parameters x. Domain: solvable, as many parameters as
  /// freedom() (contract), as everything below.
  RationalPolynomial lambda_numerator(std::span<const Rational> x) const;
  /// α rad α.
  const RationalPolynomial& lambda_denominator() const { return denominator_; }
  /// λ and σ = λ |A|², positive where the curve runs along F.
  RationalFunction lambda(std::span<const Rational> x) const;
  RationalFunction speed(std::span<const Rational> x) const;
  /// σ(t) for x = 0, and what each parameter adds to it. Domain: α(t) ≠ 0.
  std::vector<Rational> speeds(const Rational& t) const;
  /// True when the curve has no cusp: λ > 0 on the whole of [begin, end], by Sturm's sequence.
  bool is_cusp_free(std::span<const Rational> x) const;
  RationalPhCurve curve(std::span<const Rational> x) const;

  /// The parameters whose speed at some parameters t is nearest to `target`: the least sum of
  /// squares, exactly; unique where the nodes are more than the degrees of freedom. Such a curve
  /// may well have cusps.
  std::vector<Rational> nearest_to_speed(const Rational& target,
                                         std::span<const Rational> nodes) const;

 private:
  explicit HermiteCurves(const SolutionSpace& space) : space_(space) {}

  SolutionSpace space_;
  RationalHermiteData data_;
  std::size_t equations_ = 0;
  RationalPolynomial norm_, denominator_;
  int denominator_sign_ = 1;                    // on [begin, end]
  std::vector<VectorPolynomial> solutions_;     // -2 B_i
  std::vector<RationalPolynomial> numerators_;  // h_i
  std::vector<std::vector<Rational>> system_;
  std::vector<Rational> contradiction_;
  std::vector<Rational> particular_;  // the c_i for x = 0
  std::vector<std::vector<Rational>> directions_;
  RationalPolynomial particular_numerator_;
  std::vector<RationalPolynomial> direction_numerators_;

  std::vector<Rational> coefficients(std::span<const Rational> x) const;
};

/// begin + k (end - begin) / (count - 1), k < count. Domain: count ≥ 2 (contract).
std::vector<Rational> equidistant(const Rational& begin, const Rational& end, std::size_t count);

/// |x| + |y| + |z|, the length that needs no root.
Rational taxicab_length(const RationalVector& v);

}  // namespace hodograph
