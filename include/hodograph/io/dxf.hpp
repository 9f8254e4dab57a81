// SPDX-License-Identifier: MIT
// Rational Bézier curves of the plane as a DXF drawing: exact SPLINE entities, as CAD programs read
// them.
//
// Pieces that join become one SPLINE, the single object that its user selects, trims and cuts
// along: degree m, clamped, every inner knot of multiplicity m, so that neighbours share the
// control point where they meet. That also needs equal weights there: all weights of a piece may be
// multiplied by one number without changing the curve, and are. A new SPLINE begins where a piece
// starts elsewhere than the one before it ends (an offset at a corner) or has another degree. The
// knots are the pieces' parameters: the parameter of the SPLINE is theirs.
//
// Degrees are not limited here, but some programs limit them: AutoCAD and Rhino read up to 11,
// FreeCAD up to 25, LibreCAD leaves out a SPLINE above 3. (The offset of a planar quintic has
// degree 9.) A curve that returns to its start is written clamped, without the flag "closed", which
// some programs take for a periodic knot vector.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/surface/rational_bezier.hpp"

namespace hodograph {

template <std::size_t n>
struct OffsetPiece;

/// A piece of an offset (surface/offset.hpp) as such a curve, over its parameters ξ.
template <std::size_t n>
RationalBezier rational_bezier(const OffsetPiece<n>& piece) {
  const auto points = piece.curve.control_points();
  const auto& weights = piece.curve.weight.coefficients();
  return {piece.xi_begin,
          piece.xi_end,
          {points.begin(), points.end()},
          {weights.begin(), weights.end()}};
}

/// Curves on one layer.
struct DxfCurves {
  std::string layer{};  ///< its name; characters that no layer may have become '_'; empty: "0"
  int color = 7;        ///< of the layer, 1 to 255 in AutoCAD's index; 7 is black on white
  std::vector<RationalBezier> pieces{};  ///< in sequence
};

/// The unit of a drawing's coordinates, by the numbers of the variable $INSUNITS.
enum class DxfUnit {
  none = 0,
  inch = 1,
  foot = 2,
  millimetre = 4,
  centimetre = 5,
  metre = 6,
  kilometre = 7
};

/// The unit that a name means: "mm", "cm", "m", "km", "in", "ft"; none for any other.
DxfUnit dxf_unit(std::string_view name);

/// The drawing: a complete ASCII DXF of version AC1015 (release 2000), with line feeds. Numbers are
/// the shortest decimals that read back to the same doubles, so that control points and knots are
/// exact; weights are after one multiplication each.
///
/// Faults, with the index of the piece, counted through all curves: mismatched_size (as many
/// weights as control points, two or more); outside_domain (a weight that is not positive, begin
/// not before end); not_finite (a number).
Result<std::string> to_dxf(std::span<const DxfCurves> curves, DxfUnit unit = DxfUnit::none);

}  // namespace hodograph
