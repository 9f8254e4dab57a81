// SPDX-License-Identifier: MIT
// Samples as a smooth curve: the spline of odd degree p ≥ 5 through points in space, C^{p-1}, so
// that it gives genuine C⁴ data (a spline of degree 4 does not: its fourth derivative jumps).
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/construction/hermite_data.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/interval_index.hpp"

namespace hodograph {

/// How a spline behaves at its ends.
enum class SplineEnds {
  not_a_knot,  ///< open: the (p - 1)/2 samples next to each end are not knots
  periodic,    ///< closed: the last sample repeats the first, one period later
};

/// The spline of degree p through the samples (t_i, P_i), a polynomial between its breakpoints and
/// C^{p-1} there. Accuracy: the samples are met to a few ε of the largest coordinate; the error
/// against a smooth curve is O(spacing^{p+1}).
template <std::size_t p = 5>
class InterpolatingSpline {
  static_assert(p >= 5 && p % 2 == 1, "C⁴ needs an odd degree of at least 5");

 public:
  using Piece = BernsteinPolynomial<Vector3<double>, p>;

  /// Through the samples. Method: B-splines; a banded (cyclic banded) system without pivoting.
  /// Faults: mismatched_size; too_few (p + 1 samples); not_finite and not_increasing (with the
  /// index); not_continuous (periodic samples whose last point is not the first, to √ε of the
  /// extent); no_convergence (parameters so uneven that the system cannot be solved).
  static Result<InterpolatingSpline> through(std::span<const double> parameters,
                                             std::span<const Vector3<double>> points,
                                             SplineEnds ends = SplineEnds::not_a_knot);

  /// The position and its first four derivatives at t, t_0 ≤ t ≤ t_M (throws Error outside).
  HermitePoint<4> operator()(double t) const;

  double begin() const { return breakpoints_.front(); }
  double end() const { return breakpoints_.back(); }
  bool is_periodic() const { return periodic_; }
  /// The parameters where one polynomial ends and the next begins, and the polynomials.
  const std::vector<double>& breakpoints() const { return breakpoints_; }
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  InterpolatingSpline() = default;
  bool periodic_ = false;
  std::vector<double> breakpoints_;
  std::vector<Piece> pieces_;
  IntervalIndex<double> index_;
};

extern template class InterpolatingSpline<5>;
extern template class InterpolatingSpline<7>;

}  // namespace hodograph
