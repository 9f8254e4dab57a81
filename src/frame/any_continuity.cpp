// SPDX-License-Identifier: MIT
#include "hodograph/frame/any_continuity.hpp"

#include <string>

namespace hodograph {

namespace {

std::optional<Fault> knot_fault(const AnyPath& path, std::size_t k) {
  const std::size_t first = path.is_closed() ? 0 : 1, last = path.segment_count() - 1;
  if (first <= k && k <= last) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               last < first ? "no segments meet on an open path of one segment; got knot " +
                                  std::to_string(k)
                            : "segments meet at the knots " + std::to_string(first) + " to " +
                                  std::to_string(last) + " of this path; got " + std::to_string(k),
               std::nullopt,
               "knot",
               static_cast<double>(k),
               static_cast<double>(k < first ? first : last)};
}

Fault planar_fault(const char* what) {
  return {FaultCode::unsupported,
          std::string(what) + " is of a path in space; this one is planar",
          std::nullopt,
          "dimension",
          2.0,
          3.0};
}

}  // namespace

PathContinuity<double> continuity(const AnyPath& path) {
  return path.visit([](const auto& p) { return continuity(p); });
}

FrameContinuity<double> frame_continuity(const AnyPath& path) {
  return path.visit([](const auto& p) { return frame_continuity(p); });
}

Result<KnotJumps<double>> jumps_at_knot(const AnyPath& path, std::size_t k) {
  if (auto fault = knot_fault(path, k)) return *fault;
  return path.visit([&](const auto& p) { return jumps_at_knot(p, k); });
}

Result<FrameKnotJumps<double>> frame_jumps_at_knot(const AnyPath& path, std::size_t k) {
  if (auto fault = knot_fault(path, k)) return *fault;
  return path.visit([&](const auto& p) { return frame_jumps_at_knot(p, k); });
}

Result<Holonomy<double>> holonomy(const AnyPath& path) {
  return path.visit([]<class P>(const P& p) -> Result<Holonomy<double>> {
    if constexpr (P::Point::dimension == 3) {
      return holonomy(p);
    } else {
      return planar_fault("holonomy");
    }
  });
}

Result<LinearRoll<double>> closing_roll(const AnyPath& path) {
  return path.visit([]<class P>(const P& p) -> Result<LinearRoll<double>> {
    if constexpr (P::Point::dimension == 3) {
      return closing_roll(p);
    } else {
      return planar_fault("a roll");
    }
  });
}

std::optional<FrenetState<double>> frenet(const AnyPath& path, double xi) {
  return path.visit([&]<class P>(const P& p) -> std::optional<FrenetState<double>> {
    if constexpr (P::Point::dimension == 3) {
      return frenet(p, xi);
    } else {
      throw Error(planar_fault("a Frenet frame"));
    }
  });
}

}  // namespace hodograph
