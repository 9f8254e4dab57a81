// SPDX-License-Identifier: MIT
#include "hodograph/path/any_planar.hpp"

#include "hodograph/path/detail/any_degree.hpp"

namespace hodograph {

using path_detail::planar;

namespace {

template <class P>
inline constexpr bool is_straight = P::preimage_degree == 0;

}  // namespace

std::vector<CurvatureStationaryPoint> curvature_stationary_points(const AnyPath& path) {
  return planar(path, "signed curvature", []<class P>(const P& p) {
    if constexpr (is_straight<P>) {
      return std::vector<CurvatureStationaryPoint>{};
    } else {
      return curvature_stationary_points(p);
    }
  });
}

std::vector<Inflection> inflections(const AnyPath& path) {
  return planar(path, "signed curvature", []<class P>(const P& p) {
    if constexpr (is_straight<P>) {
      return std::vector<Inflection>{};
    } else {
      return inflections(p);
    }
  });
}

Answer curvature_stays_within(const AnyPath& path, double limit) {
  return planar(path, "signed curvature",
                [&](const auto& p) { return curvature_stays_within(p, limit); });
}

}  // namespace hodograph
