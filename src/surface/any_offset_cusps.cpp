// SPDX-License-Identifier: MIT
// Of hodograph/surface/any_offset.hpp the cusps.
#include "hodograph/path/detail/any_degree.hpp"
#include "hodograph/surface/any_offset.hpp"

namespace hodograph {

std::vector<OffsetCusp> offset_cusps(const AnyPath& path, double distance) {
  return path_detail::planar(path, "an offset",
                             [&](const auto& p) { return offset_cusps(p, distance); });
}

}  // namespace hodograph
