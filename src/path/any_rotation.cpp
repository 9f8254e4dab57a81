// SPDX-License-Identifier: MIT
// Of hodograph/path/any_planar.hpp the rotation indices and areas.
#include "hodograph/path/any_planar.hpp"
#include "hodograph/path/detail/any_degree.hpp"
#include "hodograph/path/signed_area.hpp"

namespace hodograph {

using path_detail::planar;

RotationIndices rotation_index_enclosures(const AnyPath& path) {
  return planar(path, "a rotation index",
                [](const auto& p) { return rotation_index_enclosures(p); });
}

double absolute_rotation_index(const AnyPath& path) {
  return planar(path, "a rotation index", [](const auto& p) { return absolute_rotation_index(p); });
}

double rotation_index(const AnyPath& path) {
  return planar(path, "a rotation index", [](const auto& p) { return rotation_index(p); });
}

double signed_area(const AnyPath& path) {
  return planar(path, "a signed area", [](const auto& p) { return signed_area(p); });
}

Enclosure signed_area_enclosure(const AnyPath& path) {
  return planar(path, "a signed area", [](const auto& p) { return signed_area_enclosure(p); });
}

}  // namespace hodograph
