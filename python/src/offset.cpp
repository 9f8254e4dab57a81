// SPDX-License-Identifier: MIT
// Offsets of planar paths: surface/any_offset.hpp.
#include "hodograph/surface/any_offset.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

void bind_offset(py::module_& m) {
  Record<RationalOffsetPiece>(m, "OffsetPiece", "A piece of an offset, with positive weights.")
      .field("segment", &RationalOffsetPiece::segment, "Of the path.")
      .field("curve", &RationalOffsetPiece::curve, "Over the path's parameters.");
  Record<OffsetCusp>(m, "OffsetCusp", "Where an offset has a cusp.")
      .field("xi", &OffsetCusp::xi)
      .field("xi_range", &OffsetCusp::xi_range, "Contains the true parameter.")
      .field("kind", &OffsetCusp::kind, "simple: certainly a cusp.");
  Record<CuspFreeOffsets>(m, "CuspFreeOffsets",
                          "The largest distances to either side whose offsets have no cusp.")
      .field("right", &CuspFreeOffsets::right)
      .field("left", &CuspFreeOffsets::left);
  m.def(
      "rational_offset",
      [](const AnyPath& path, double distance) {
        return unlocked([&] { return rational_offset(path, distance).value(); });
      },
      py::arg("path"), py::arg("distance"),
      "The offset of a planar path, positive to the left, as exact rational Bezier curves in "
      "sequence.\nRaises HodographError: unsupported (a path in space), not_finite, zero_speed.");
  m.def(
      "offset_cusps",
      [](const AnyPath& path, double distance) {
        if (!std::isfinite(distance)) {
          throw Error(Fault{FaultCode::not_finite,
                            "the offset distance should be finite; got " + to_text(distance),
                            std::nullopt, "distance", distance, std::nullopt});
        }
        return unlocked([&] { return offset_cusps(path, distance); });
      },
      py::arg("path"), py::arg("distance"), "Where 1 - distance kappa vanishes, ascending.");
  m.def(
      "cusp_free_offsets",
      [](const AnyPath& path, double relative_width) {
        return unlocked([&] { return cusp_free_offsets(path, RangeGoal{relative_width}); });
      },
      py::arg("path"), py::kw_only(), py::arg("relative_width") = 0x1p-40,
      "The largest distances to the right and to the left up to which offsets have no cusp.");
  m.def(
      "offset_position",
      [](const AnyPath& path, const Doubles& xi, double distance) {
        return filled_like(xi, {2},
                           [&](auto from, auto to) { offset_positions(path, distance, from, to); });
      },
      py::arg("path"), py::arg("xi"), py::arg("distance"),
      "The points r + distance n of the offset, (..., 2). Raises HodographError: outside_domain, "
      "zero_speed,\nunsupported.");
}

}  // namespace hodograph::python
