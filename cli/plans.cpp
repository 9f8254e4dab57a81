// SPDX-License-Identifier: MIT
#include "cli/plans.hpp"

#include <algorithm>
#include <iterator>
#include <type_traits>

namespace hodograph::cli {

CornerAim corner_aim(const std::string& word) {
  const auto* const found = std::find(std::begin(corner_words), std::end(corner_words), word);
  return static_cast<CornerAim>(found - std::begin(corner_words));
}

namespace {

/// A plan's path: quintics of the plane.
const PlanarPath<2>& quintics(const AnyPath& path) {
  const PlanarPath<2>* found = nullptr;
  path.visit([&](const auto& p) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(p)>, PlanarPath<2>>) found = &p;
  });
  if (found != nullptr) return *found;
  throw Error(Fault{FaultCode::unsupported,
                    "curvature and clearance can be proven again of quintics in the plane alone",
                    std::nullopt, "path", std::nullopt, std::nullopt});
}

}  // namespace

Enclosure largest_curvature(const AnyPath& path) {
  return hodograph::largest_curvature(quintics(path));
}

PathClearance clearance_of(const AnyPath& path, const ClearanceIndex& index, double reach) {
  return index.clearance(quintics(path), reach).value();
}

ClearancePromise promise_of(const PathClearance& clearance, const std::string& world) {
  ClearancePromise promise;
  promise.world = world;
  promise.reach = clearance.reach;
  for (const ObstacleClearance& near : clearance.near) {
    if (near.obstacle == WorldVertex::bounds) {
      promise.bounds = near.distance;
    } else {
      promise.obstacles.push_back({near.obstacle, near.distance});
    }
  }
  return promise;
}

MadePath made_plan(const Plan& plan, const VehicleLimits& limits, CornerAim aim,
                   const std::string& world) {
  const std::string choice = "turn radius " + to_text(limits.turn_radius) + ", clearance " +
                             to_text(limits.clearance) + ", width " + to_text(limits.width) +
                             ", corners " + corner_words[static_cast<std::size_t>(aim)];
  MadePath made = made_path(AnyPath(plan.path), world.empty() ? "" : "world: " + world,
                            "shortest polyline with G2 corners", choice);
  Promises& promises = made.document.promises;
  promises.curvature_bound = std::min(promises.curvature_bound.value_or(1.0 / limits.turn_radius),
                                      1.0 / limits.turn_radius);
  promises.largest_curvature = plan.certificate.curvature;
  promises.clearance = promise_of(plan.certificate.clearance, world);
  return made;
}

Json json_of(const Plan& plan, const World& world) {
  Json json = {{"arc_length", json_of(plan.certificate.arc_length)},
               {"largest_curvature", json_of(plan.certificate.curvature)},
               {"polyline_length", plan.polyline.length},
               {"attempts", plan.attempts}};
  Json& points = json["polyline"] = Json::array();
  for (const auto& point : plan.polyline.points) points.push_back(list_of(point));
  Json& corners = json["corners"] = Json::array();
  for (std::size_t k = 0; k < plan.polyline.corners.size(); ++k) {
    const PolylineCorner& corner = plan.polyline.corners[k];
    Json one = {{"leg", plan.legs[k]},
                {"offset", plan.offsets[k]},
                {"side", corner.side == TurnSide::left ? "left" : "right"},
                {"vertex", world.source_vertex(corner.vertex)},
                {"ring", corner.vertex.ring}};
    one["obstacle"] =
        corner.vertex.obstacle == WorldVertex::bounds ? Json() : Json(corner.vertex.obstacle);
    corners.push_back(std::move(one));
  }
  const PathClearance& clearance = plan.certificate.clearance;
  Json& list = json["clearance"] = {{"reach", clearance.reach}};
  list["obstacles"] = Json::array();
  list["bounds"] = Json();
  for (const ObstacleClearance& near : clearance.near) {
    if (near.obstacle == WorldVertex::bounds) {
      list["bounds"] = json_of(near.distance);
    } else {
      Json one = {{"obstacle", near.obstacle}, {"xi", near.xi}};
      one["distance"] = json_of(near.distance);
      one["nearest"] = list_of(near.nearest);
      list["obstacles"].push_back(std::move(one));
    }
  }
  Json& given_up = json["given_up"] = Json::array();
  for (const CrowdedCorner& corner : plan.given_up) {
    given_up.push_back({{"corner", list_of(corner.point)},
                        {"turning_angle", corner.turning_angle},
                        {"turn_radius", corner.turn_radius}});
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const Plan& plan, const World& world) {
  std::vector<std::pair<std::string, std::string>> rows;
  const std::size_t corners = plan.polyline.corners.size();
  rows.emplace_back("Polyline", to_six_digits(plan.polyline.length) + " long, " +
                                    std::to_string(corners) +
                                    (corners == 1 ? " corner" : " corners"));
  rows.emplace_back("Largest curvature",
                    "at most " + to_six_digits(plan.certificate.curvature.upper()) + ", certified");
  const PathClearance& clearance = plan.certificate.clearance;
  const ObstacleClearance* nearest = nullptr;
  for (const ObstacleClearance& near : clearance.near) {
    if (nearest == nullptr || near.distance.lower() < nearest->distance.lower()) nearest = &near;
  }
  rows.emplace_back("Clearance", nearest == nullptr
                                     ? "at least " + to_six_digits(clearance.reach) + ", certified"
                                     : "at least " + to_six_digits(nearest->distance.lower()) +
                                           ", certified; " + world.name_of(nearest->obstacle) +
                                           " is nearest");
  if (plan.attempts > 1) {
    rows.emplace_back("Attempts", std::to_string(plan.attempts) + ", for corners without room");
  }
  return rows;
}

std::vector<Series> outlines(const World& world) {
  std::vector<Series> series;
  const auto add = [&](const Ring& ring, SeriesStyle style) {
    Series one;
    one.style = style;
    one.color = PlotColor::grey;
    for (std::size_t i = 0; i <= ring.size(); ++i) {
      one.x.push_back(ring[i % ring.size()].x);
      one.y.push_back(ring[i % ring.size()].y);
    }
    series.push_back(std::move(one));
  };
  for (const Polygon& polygon : world.obstacles()) {
    add(polygon.outer, SeriesStyle::line);
    for (const Ring& hole : polygon.holes) add(hole, SeriesStyle::line);
  }
  if (world.bounds()) add(*world.bounds(), SeriesStyle::dashed_line);
  return series;
}

}  // namespace hodograph::cli
