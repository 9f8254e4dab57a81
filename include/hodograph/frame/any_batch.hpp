// SPDX-License-Identifier: MIT
// The state of a path whose dimension and degree are known only when the program runs, at many
// parameters or arc lengths in one call: flat spans in, flat spans out, no allocation. The numbers
// are those of frame/batch.hpp and path/batch.hpp, bit for bit. Compiled once, in the library.
//
// All functions throw Error before anything is written: mismatched_size where a span has the wrong
// length, outside_domain (with the index) where a parameter or arc length is outside the path.
#pragma once

#include <span>

#include "hodograph/curve/preimage_jet.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// Where evaluate() puts what, d = dimension of the path: each span is empty (not wanted) or holds
/// the named count of numbers for every parameter. See PathState for the quantities.
struct AnyPathStateSpans {
  std::span<double> positions{};          ///< d
  std::span<double> frames{};             ///< d²: e₁, then e₂, then (in space) e₃
  std::span<double> body_rates_per_xi{};  ///< 1 in the plane, 3 in space
  std::span<double> speeds{};             ///< 1
  std::span<double> arc_lengths{};        ///< 1
};

/// evaluate(path, xi[i]) for every i. Also throws zero_speed, as PathState's evaluate, where frames
/// or rates are wanted and the path stands still; what was written is unspecified then.
void evaluate(const AnyPath& path, std::span<const double> xi, const AnyPathStateSpans& out);

/// A and its first four derivatives with respect to ξ at every ξ: all that tangents, curvatures and
/// rates are made of. Also throws unsupported where the path has the other dimension.
void preimage_jets(const AnyPath& path, std::span<const double> xi,
                   std::span<PreimageJet<Complex<double>, 4>> jets);
void preimage_jets(const AnyPath& path, std::span<const double> xi,
                   std::span<PreimageJet<Quaternion<double>, 4>> jets);

/// The ξ at which the path has come each arc length, correct to rounding.
void parameters_at_arc_lengths(const AnyPath& path, std::span<const double> s,
                               std::span<double> xi);
/// The point at each arc length, d numbers each.
void points_at_arc_lengths(const AnyPath& path, std::span<const double> s,
                           std::span<double> points);

}  // namespace hodograph
