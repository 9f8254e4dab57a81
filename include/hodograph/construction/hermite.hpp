// SPDX-License-Identifier: MIT
// Hermite interpolation by spatial PH curves, in closed form: C¹ quintics (m = 1), C² curves of
// degree 9 (m = 2), C⁴ curves of degree 17 (m = 4), one algorithm for every m.
//
// Sources: PHODCOS, Algorithm 1 (order_six, and all free parameters); the choice of order ten is
// this project's, see docs/constructions/hermite.md. Preimage degree n = 2m.
#pragma once

#include <span>
#include <vector>

#include "hodograph/construction/hermite_data.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

/// The curve with the given position and m derivatives (with respect to ξ) at both ends of a
/// parameter interval of length h > 0.
///
/// Properties of both choices: exact on data of a straight line at constant speed; planar data give
/// a planar curve; invariant under rotation, reflection, scaling (1e-150 to 1e150) and reversal.
/// The preimage is unique up to one constant factor cos a + i sin a on the right. Faults:
/// not_finite, zero_speed (index 0: start, 1: end), outside_domain (h ≤ 0), no_interpolant (the
/// data ask the curve to turn back or to wander, see accuracy.hpp; order_six finds no reference
/// direction; or the numbers differ so much in size that their products overflow; the fault's
/// quantity says which). Accuracy: the end data are met to a few ε of the largest coefficient.
template <std::size_t m, class S>
Result<SpatialPhCurve<2 * m, S>> hermite_curve(const HermitePoint<m, S>& begin,
                                               const HermitePoint<m, S>& end, const S& h = S(1),
                                               HermiteChoice choice = HermiteChoice::order_ten);

/// The same with the free parameters of PHODCOS; all zero gives order_six.
template <std::size_t m, class S>
Result<SpatialPhCurve<2 * m, S>> hermite_curve(const HermitePoint<m, S>& begin,
                                               const HermitePoint<m, S>& end, const S& h,
                                               const HermiteParameters<m, S>& parameters);

/// The path through the given points with their derivatives at the knots: C^m, with a C^{m-1}
/// preimage and frame and a C^{m-2} angular velocity, on any knots. Every segment is rolled by one
/// constant so that the preimage continues, sign included; the roll follows from the algebra, Q =
/// A_0* A_n / |...|, without an angle. A closed path returns to its first point; what roll is left
/// over there is reported by holonomy(). Faults: as above with the index of the segment or knot,
/// mismatched_size, too_few, and those of Path::create.
template <std::size_t m, class S>
Result<SpatialPath<2 * m, S>> hermite_path(std::vector<S> knots,
                                           std::span<const HermitePoint<m, S>> points,
                                           HermiteChoice choice = HermiteChoice::order_ten,
                                           bool closed = false);

}  // namespace hodograph

#include "hodograph/construction/detail/hermite_impl.hpp"

namespace hodograph {

// Compiled once, in src/construction/hermite.cpp.
#define HODOGRAPH_DECLARE(m, S)                                                       \
  extern template Result<SpatialPhCurve<2 * m, S>> hermite_curve<m, S>(               \
      const HermitePoint<m, S>&, const HermitePoint<m, S>&, const S&, HermiteChoice); \
  extern template Result<SpatialPhCurve<2 * m, S>> hermite_curve<m, S>(               \
      const HermitePoint<m, S>&, const HermitePoint<m, S>&, const S&,                 \
      const HermiteParameters<m, S>&);                                                \
  extern template Result<SpatialPath<2 * m, S>> hermite_path<m, S>(                   \
      std::vector<S>, std::span<const HermitePoint<m, S>>, HermiteChoice, bool);

HODOGRAPH_DECLARE(1, double)
HODOGRAPH_DECLARE(2, double)
HODOGRAPH_DECLARE(4, double)
HODOGRAPH_DECLARE(1, long double)
HODOGRAPH_DECLARE(2, long double)
HODOGRAPH_DECLARE(4, long double)

#undef HODOGRAPH_DECLARE

}  // namespace hodograph
