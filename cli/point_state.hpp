// SPDX-License-Identifier: MIT
// Everything there is to know at one point of a path of any dimension and degree, as plain numbers.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph::cli {

/// A vector and its derivatives: [order][component].
using Derivatives = std::vector<std::vector<double>>;

/// A rate of rotation with its first two derivatives; one component in the plane, three in space.
struct RotationRates {
  Derivatives body_per_xi, world_per_xi;                  ///< derivatives with respect to ξ
  Derivatives body_per_arc_length, world_per_arc_length;  ///< derivatives with respect to s
};

struct FrenetNumbers {
  std::vector<double> tangent, normal, binormal;
  double curvature = 0.0, torsion = 0.0, roll = 0.0;
};

/// Derivatives are with respect to ξ. What needs a tangent is absent where the path stands still.
struct PointState {
  double xi = 0.0, arc_length = 0.0;
  Derivatives position;       ///< orders 0 to 4
  Derivatives preimage;       ///< orders 0 to 4
  std::vector<double> speed;  ///< orders 0 to 4
  bool moves = false;
  std::vector<double> tangent;
  double curvature = 0.0;            ///< signed in the plane
  std::optional<double> torsion{};   ///< in space, where the curvature is not zero
  std::vector<Derivatives> frame{};  ///< [order 0 to 2][axis][component], rolled where asked for
  RotationRates rates{};             ///< of that frame
  std::optional<FrenetNumbers> frenet{};
};

/// The state at ξ; the frame is the Euler-Rodrigues frame turned by `roll`, if there is one.
/// Throws Error (outside_domain) outside the knots.
PointState state_at(const AnyPath& path, double xi,
                    const std::optional<LinearRoll<double>>& roll = std::nullopt);

}  // namespace hodograph::cli
