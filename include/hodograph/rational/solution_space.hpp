// SPDX-License-Identifier: MIT
// All rational PH curves r = -2 B / α with a given tangent indicatrix, denominator and degree: the
// vector space of the polynomials B, exactly.
//
// Notation, as in "Rational Framing Motions and Spatial Rational Pythagorean Hodograph Curves":
// F = A i A*, e = deg F, m = deg α, ρ = deg rad α; r' = λ F with λ = h / (α rad α).
//
// Method. λ F has a rational antiderivative exactly when the part of ∫ h F / (α rad α) with simple
// poles vanishes: 3 ρ linear equations in the coefficients of h, found by Hermite's reduction. A
// multiple of α rad α satisfies them always (those are the polynomial curves), so that at most
// m + ρ coefficients remain unknown, whatever the degree of B.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/rational/polynomial.hpp"
#include "hodograph/rational/reduction.hpp"

namespace hodograph {

/// The largest degrees that solve accepts: of A and of α, and of B. They keep a request whose
/// answer would take hours from being taken for one that takes milliseconds.
inline constexpr std::size_t largest_input_degree = 64;
inline constexpr std::size_t largest_solution_degree = 512;

/// The largest canonical_basis_work() that the program takes on: coefficients of 64 bits, deg A =
/// 4, deg B = 60 need a tenth of it.
inline constexpr double largest_canonical_basis_work = 0x1p35;

/// What kind of curve -2 B / α is.
enum class CurveKind {
  constant,    ///< a point; "trivial" in the paper
  polynomial,  ///< α divides B, and B / α is not constant
  rational,    ///< truly rational
};
std::string_view name_of(CurveKind kind);
/// The kind of -2 B / α, α ≠ 0.
CurveKind kind_of(const VectorPolynomial& b, const RationalPolynomial& alpha);

/// The space V_d = {B vectorial : deg B ≤ d, (α B' - α' B) × A i A* = 0}. A value; immutable.
class SolutionSpace {
 public:
  /// A reduced with respect to i, and what was divided out.
  const QuaternionPolynomial& preimage() const { return reduction_.reduced; }
  const Reduction& preimage_reduction() const { return reduction_; }
  const RationalPolynomial& alpha() const { return alpha_; }
  /// rad α, monic.
  const RationalPolynomial& radical() const { return radical_; }
  /// F = A i A* of the reduced A.
  const VectorPolynomial& indicatrix() const { return indicatrix_; }
  /// d.
  std::size_t degree() const { return degree_; }

  /// dim V_d, and its invariant parts: the points 3 [d ≥ m]; the polynomial curves that are no
  /// points max(0, d - m - e); and what remains.
  std::size_t dimension() const { return basis_.size(); }
  std::size_t constant_dimension() const { return constants_; }
  std::size_t polynomial_dimension() const { return polynomials_; }
  std::size_t rational_dimension() const { return basis_.size() - constants_ - polynomials_; }

  /// A basis of V_d, adapted to its parts: first the truly rational elements, then the polynomial
  /// ones α ∫ t^k F by decreasing k, then α e_1, α e_2, α e_3.
  const std::vector<VectorPolynomial>& basis() const { return basis_; }

  /// The numerators h of λ = h / (α rad α): the reduced echelon basis by falling degree, leading
  /// coefficients 1.
  std::vector<RationalPolynomial> lambda_numerators() const;
  /// The same for the curves whose arc length ∫ λ |A|² is rational.
  std::vector<RationalPolynomial> rational_length_numerators() const;

  /// The canonical basis: the reduced row echelon form in the order b_d.x, b_d.y, b_d.z,
  /// b_{d-1}.x, ..., b_0.z of the coefficients. Two spaces are equal exactly when these are.
  std::vector<VectorPolynomial> canonical_basis() const;
  /// About what that costs: (dim V_d)² · 3 (d + 1) · the bits that the numbers may reach, the sum
  /// of those of the rows. A processor does some 2^34 to 2^36 of it in a second.
  double canonical_basis_work() const;

 private:
  friend Result<SolutionSpace> solve(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                                     std::size_t degree);
  SolutionSpace() = default;

  Reduction reduction_;
  RationalPolynomial alpha_, radical_;
  VectorPolynomial indicatrix_;
  std::size_t degree_ = 0, constants_ = 0, polynomials_ = 0;
  std::vector<VectorPolynomial> basis_;
  std::vector<RationalPolynomial> rational_numerators_;  ///< h of the truly rational elements
};

/// The space V_degree for A and α. A need not be reduced with respect to i: it is reduced first.
/// Exact; a few milliseconds for one-digit coefficients and degrees up to 30.
/// Faults: outside_domain (A = 0 or α = 0), unsupported (a degree above largest_input_degree or
/// largest_solution_degree).
Result<SolutionSpace> solve(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                            std::size_t degree);

/// μ with α B' - α' B = μ F (equation (8)), for B of the space of A reduced and α.
/// Domain: F ≠ 0 and B a solution (contract).
RationalPolynomial mu_of(const VectorPolynomial& b, const RationalPolynomial& alpha,
                         const VectorPolynomial& indicatrix);

}  // namespace hodograph
