// SPDX-License-Identifier: MIT
// A path of any degree in one of a few: what is compiled for 13 or 26 kinds of path takes minutes,
// and most of the kinds are rare.
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "hodograph/path/any_operations.hpp"

namespace hodograph::path_detail {

inline Fault of_other_dimension(const char* what, std::size_t dimension) {
  return {FaultCode::unsupported,
          std::string(what) + (dimension == 2 ? " is of a path in space; this one is planar"
                                              : " is of a planar path; this one is in space"),
          std::nullopt,
          "dimension",
          static_cast<double>(dimension),
          dimension == 2 ? 3.0 : 2.0};
}

/// visitor(path) in the first of the degrees that is at least the path's own, to which it is
/// elevated; the last one is maximum_dynamic_degree, or the path's degree is at most the last.
template <template <std::size_t> class Kind, std::size_t first, std::size_t... others,
          class Visitor>
decltype(auto) in_degree(const AnyPath& path, const Visitor& visitor) {
  if constexpr (sizeof...(others) > 0) {
    if (path.preimage_degree() > first) return in_degree<Kind, others...>(path, visitor);
  }
  if (const auto* own = path.get_if<Kind<first>>()) return visitor(*own);
  const AnyPath raised = with_preimage_degree(path, first).value();
  return visitor(*raised.get_if<Kind<first>>());
}

template <std::size_t n>
using Planar = PlanarPath<n>;
template <std::size_t n>
using Spatial = SpatialPath<n>;

/// The degrees of planar paths: straight lines, quintics, and two for the rare ones.
template <class Visitor>
decltype(auto) in_planar_degree(const AnyPath& path, const Visitor& visitor) {
  return in_degree<Planar, 0, 2, 4, maximum_dynamic_degree>(path, visitor);
}
/// The same; throws Error (unsupported) for a path in space, of which there is no `what`.
template <class Visitor>
decltype(auto) planar(const AnyPath& path, const char* what, const Visitor& visitor) {
  if (path.dimension() != 2) throw Error(of_other_dimension(what, 3));
  return in_planar_degree(path, visitor);
}
/// The degrees of paths in space that constructions make.
template <class Visitor>
decltype(auto) in_spatial_degree(const AnyPath& path, const Visitor& visitor) {
  return in_degree<Spatial, 2, 3, 4, 8, maximum_dynamic_degree>(path, visitor);
}
/// Those of either dimension.
template <class Visitor>
decltype(auto) in_any_degree(const AnyPath& path, const Visitor& visitor) {
  if (path.dimension() == 2) return in_planar_degree(path, visitor);
  return in_spatial_degree(path, visitor);
}

}  // namespace hodograph::path_detail
