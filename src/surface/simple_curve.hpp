// SPDX-License-Identifier: MIT
// Whether a planar curve of rational pieces meets itself.
#pragma once

#include <optional>
#include <span>

#include "hodograph/surface/rational_bezier.hpp"

namespace hodograph::surface_detail {

/// A point near which the curve touches or crosses itself, or comes so near that rounding cannot
/// tell; nothing where it is certainly simple.
///
/// Method: parts of the curve are separated by their boxes; neighbours are simple together where
/// both advance along one direction (for positive weights the derivative is a positive combination
/// of the steps of the control polygon); what neither settles is halved. Domain: joined pieces,
/// positive weights.
std::optional<Vector2<double>> self_contact(std::span<const RationalBezier> pieces, bool closed);

}  // namespace hodograph::surface_detail
