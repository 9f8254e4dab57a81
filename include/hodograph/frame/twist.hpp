// SPDX-License-Identifier: MIT
// How much an adapted frame rotates about its tangent: the twist and the absolute twist, enclosed,
// and the frame's inflections, where that rotation changes its sense.
//
//   T = ∫ ω₁ ds,  T_abs = ∫ |ω₁| ds,  ω₁ σ = χ₁ + θ', χ₁ = 2N/σ (' = d/dξ).
// Source: "Spatial C² closed loops of prescribed arc length ...", section 5; the closed form of the
// twist of the Euler-Rodrigues frame by partial fractions is in its errata.
#pragma once

#include <optional>
#include <vector>

#include "hodograph/bernstein/roots.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/preimage_table.hpp"
#include "hodograph/frame/roll.hpp"

namespace hodograph {

/// Where ω₁ vanishes: a simple root is a change of sense, certainly; a cluster is undecided (a
/// double root, or a stretch where ω₁ is rounding).
struct TwistInflection {
  Enclosure xi;
  RootKind kind = RootKind::cluster;
};

/// Radians. The jumps of a Frenet roll at inflections of the path and at knots are not part of it.
struct FrameTwist {
  Enclosure total, absolute;
  std::vector<TwistInflection> inflections;  ///< ascending
};

/// The twist of the frame with this roll, of the exact curve of the stored numbers: rounding and
/// the error of the quadrature included; about 1e-13 rad wide for one loop. Exactly 0 for a
/// rotation-minimising roll, k times the arc length for a least twist.
/// Method: ω₁ σ is a quotient of polynomials. The roots of its numerator are isolated; between them
/// it has one sign, and its integral is that of certified series (src/frame/rate_series.hpp).
/// Faults: mismatched_size (a roll made for other knots), zero_speed (with the index of the
/// segment: σ may vanish there); for a periodic or a Frenet roll those of making it.
Result<FrameTwist> frame_twist(const PreimageTable& path, const FrameRoll& roll);

/// The twist of the ERF by partial fractions over the roots of σ, and an estimate of its error from
/// above: closed form. Nothing where the roots are too close to each other or to the real line for
/// that to keep half of the digits, or where σ vanishes.
struct ClosedFormTwist {
  double value = 0.0, error = 0.0;
};
std::optional<ClosedFormTwist> erf_twist_in_closed_form(const PreimageTable& path);

}  // namespace hodograph
