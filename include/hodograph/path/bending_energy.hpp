// SPDX-License-Identifier: MIT
// The bending energy ∫ κ² ds of curves and paths in the plane and in space.
//
// With the curvature κ = h/σ², h = 2 Im(w* w') (in space 2 |(V₂, V₃)|, V = vec(A* A')), and
// ds = σ dξ it is ∫ h²/σ³ dξ. It scales with the
// inverse of lengths and is that of the exact curve of the stored numbers (see path/bounds.hpp).
#pragma once

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/energy_fractions.hpp"
#include "hodograph/path/detail/energy_integral.hpp"
#include "hodograph/path/detail/sum_by_halves.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph {

namespace path_detail {

inline Fault infinite_energy(std::size_t segment) {
  return {FaultCode::zero_speed,
          "the speed of segment " + std::to_string(segment) +
              " comes to zero within rounding, where the bending energy may be infinite; it needs "
              "a regular curve",
          segment,
          "speed",
          0.0,
          std::nullopt};
}

template <class S, class A, std::size_t n, class Energy>
Result<S> sum_over_segments(const Path<A, n>& path, const Energy& energy) {
  std::vector<S> energies;
  energies.reserve(path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const Result<S> share = energy(path.segment(k));
    if (!share) return infinite_energy(k);
    energies.push_back(*share);
  }
  return sum_by_halves(std::move(energies));
}

}  // namespace path_detail

/// The bending energy of one curve in an enclosure, rounding and the remainder of the quadrature
/// included: a few hundred roundings wide, more only where the speed nearly vanishes or where the
/// curve is so nearly straight that its curvature is known to few digits.
/// Exactly 0 for a curve in the plane that is exactly straight, about 2^-100 in space.
/// Faults: zero_speed where σ may vanish on a curve that is not straight, within rounding: the
/// integral is infinite unless h vanishes there as well.
/// Method: path/detail/energy_integral.hpp. Cost: 20 to 60 µs for a planar quintic.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<Enclosure> bending_energy_enclosure(const PhCurve<A, n>& curve) {
  if constexpr (n == 0) {
    return Enclosure(0.0);
  } else {
    using Exact = path_detail::EnclosedCurve<A, n>;
    const Exact exact(curve);
    const auto integral =
        path_detail::EnergyIntegral<typename Exact::Algebra, n>(exact.preimage()).value();
    if (!integral) return path_detail::infinite_energy(0);
    const Enclosure unit = path_detail::power_of_two(-exact.exponent());
    constexpr double m = static_cast<double>(n);
    const Enclosure energy = (((Enclosure(4.0 * m * m) * *integral) / exact.step()) * unit) * unit;
    return Enclosure(std::max(0.0, energy.lower()), energy.upper());
  }
}

/// The bending energy of a path, the sum of those of its segments. A corner at a knot (a jump of
/// the direction) counts for nothing here, though no finite bending makes it.
/// Faults: zero_speed, with the index of the segment.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<Enclosure> bending_energy_enclosure(const Path<A, n>& path) {
  return path_detail::sum_over_segments<Enclosure>(
      path, [](const auto& curve) { return bending_energy_enclosure(curve); });
}

/// The bending energy of one curve in double precision: a small multiple of rounding, amplified
/// only by cancellation in h (nearly straight curves) and in σ (near a cusp), as the enclosure.
/// Faults: zero_speed, not_finite (sizes whose energy is out of the range of numbers).
/// Method: for planar cubics and quintics partial fractions over the roots of w, in closed form,
/// where an estimate says that they keep their digits (roots near the curve, simple, and neither
/// near the conjugate of the other); else, and in higher degrees, Gauss-Legendre quadrature on
/// pieces chosen by the distance of the roots. Cost: 0.2 to 1.5 µs for a quintic.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<double> bending_energy(const PhCurve<A, n>& curve) {
  if constexpr (n == 0) {
    return 0.0;
  } else {
    double size = 0.0;
    for (const A& w : curve.preimage().coefficients()) {
      size = std::max(size, largest_component(w));
    }
    const int exponent = path_detail::exponent_of(size);
    const auto scaled = curve.preimage().mapped([exponent](const A& w) {
      A result;
      for (std::size_t j = 0; j < A::dimension; ++j) result[j] = std::ldexp(w[j], -exponent);
      return result;
    });
    std::optional<double> integral;
    if constexpr (n <= 2 && A::dimension == 2) integral = path_detail::energy_by_fractions(scaled);
    if (!integral) integral = path_detail::EnergyIntegral<A, n>(scaled).value();
    if (!integral) return path_detail::infinite_energy(0);
    constexpr double m = static_cast<double>(n);
    const double energy =
        std::ldexp(4.0 * m * m * *integral / curve.parameter_step(), -2 * exponent);
    if (!std::isfinite(energy)) {
      return Fault{FaultCode::not_finite, "the bending energy exceeds the range of numbers",
                   std::nullopt,          "bending_energy",
                   std::nullopt,          std::nullopt};
    }
    return energy;
  }
}

/// The sum over the segments of a path. Faults: as for a curve, with the index of the segment.
template <class A, std::size_t n>
  requires std::same_as<typename A::Scalar, double>
Result<double> bending_energy(const Path<A, n>& path) {
  return path_detail::sum_over_segments<double>(
      path, [](const auto& curve) { return bending_energy(curve); });
}

}  // namespace hodograph
