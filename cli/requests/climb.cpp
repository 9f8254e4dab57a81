// SPDX-License-Identifier: MIT
// The requests "climb", "climb_route" and "helix".
#include "cli/climbs.hpp"
#include "cli/requests/handlers.hpp"

namespace hodograph::cli {
namespace {

Json json_of_segment(const SpatialPhCurve<2>& curve) {
  Json json = {{"arc_length", curve.arc_length()}};
  json["preimage"] = Json::array();
  for (const auto& a : curve.preimage().coefficients()) json["preimage"].push_back(list_of(a));
  json["control_points"] = Json::array();
  const auto displacement = curve.displacement();
  for (const auto& c : displacement.coefficients()) {
    json["control_points"].push_back(list_of(curve.start() + c));
  }
  return json;
}

HeadedPoint headed_end(Members end) {
  const ClimbWaypoint waypoint = waypoint_of(end);
  if (!waypoint.heading) {
    end.refuse("heading", "give the heading as \"heading\" (an angle) or as \"direction\"");
  }
  if (waypoint.climb_angle || waypoint.ground_length) {
    end.refuse("climb_angle",
               "the climb angle and the length belong to the request, not to an end");
  }
  end.require_all_known();
  return {waypoint.position, *waypoint.heading};
}

DirectedPoint3 climbing_end(Members end) {
  const DirectedPoint3 point{end.point("position"), end.point("direction")};
  end.require_all_known();
  return point;
}

}  // namespace

Answer answer_climb(Members& request) {
  const double step = request.number("step", 1.0);
  const LengthSolutions among =
      request.word("among", {"published", "all"}, "published") == "published"
          ? LengthSolutions::published
          : LengthSolutions::all;
  const bool all = request.truth("all", false);
  const auto answered = [&](const ClimbCurve& chosen, const std::vector<ClimbSolution>& solutions) {
    Answer answer;
    answer.result = json_of_segment(chosen.curve);
    answer.result["climb_angle"] = chosen.climb_angle;
    answer.result["ground_length"] = chosen.ground_length;
    answer.result["rotation_index"] = chosen.rotation_index;
    answer.result["margin"] = chosen.margin;
    answer.result["loop_free"] = chosen.loop_free;
    if (all) {
      answer.result["solutions"] = Json::array();
      for (const ClimbSolution& one : solutions) {
        Json json = json_of_segment(one.curve);
        json["rotation_index"] = one.rotation_index;
        answer.result["solutions"].push_back(std::move(json));
      }
    }
    answer.document =
        to_json(made_climb(SpatialPath<2>::create({0.0, step}, {chosen.curve}, false).value(), "",
                           "constant climb")
                    .document);
    return answer;
  };
  if (request.has("axis")) {
    const Vector3<double> axis = request.point("axis");
    const DirectedPoint3 begin = climbing_end(request.object("begin"));
    const DirectedPoint3 end = climbing_end(request.object("end"));
    request.require_all_known();
    const ClimbCurve chosen = helical_curve(axis, begin, end, step, among).value();
    return answered(chosen, all ? helical_solutions(axis, begin, end, step, among).value()
                                : std::vector<ClimbSolution>());
  }
  const HeadedPoint begin = headed_end(request.object("begin"));
  const HeadedPoint end = headed_end(request.object("end"));
  const auto angle = request.maybe_number("climb_angle");
  const auto length = request.maybe_number("ground_length");
  request.require_all_known();
  if (angle.has_value() == length.has_value()) {
    request.refuse("climb_angle", "give \"climb_angle\" or \"ground_length\", one of them");
  }
  if (length) {
    if (all) {
      request.refuse("all", "all solutions are given for a climb angle or an axis, not a length");
    }
    return answered(climb_curve_of_ground_length(begin, end, *length, step, among).value(), {});
  }
  const ClimbCurve chosen = climb_curve(begin, end, *angle, step, among).value();
  return answered(chosen, all ? climb_solutions(begin, end, *angle, step, among).value()
                              : std::vector<ClimbSolution>());
}

Answer answer_climb_route(Members& request) {
  std::vector<ClimbWaypoint> waypoints;
  for (Members& item : request.objects("waypoints")) {
    waypoints.push_back(waypoint_of(item));
    item.require_all_known();
  }
  request.require_at_most("waypoints", waypoints.size(), most_places);
  ClimbRouteOptions options;
  options.limits.climb_angle = request.number("most_climb_angle", 0.0);
  options.limits.descent_angle = request.number("most_descent_angle", options.limits.climb_angle);
  options.limits.turn_radius = request.number("turn_radius", 0.0);
  options.headings = request.word("headings", {std::begin(heading_words), std::end(heading_words)},
                                  heading_words[0]) == heading_words[0]
                         ? TangentRule::t1
                         : TangentRule::t2;
  options.most_detour = request.number("most_detour", options.most_detour);
  request.require_all_known();
  ClimbRoute route = climb_route(waypoints, options).value();
  Answer answer;
  answer.result = json_of(route);
  answer.document =
      to_json(made_climb(AnyPath(std::move(route.path)), "", "constant climb").document);
  return answer;
}

Answer answer_helix(Members& request) {
  const PathDocument document = request.document();
  request.require_all_known();
  if (document.path.dimension() != 3) {
    request.refuse("document",
                   "a path in the plane has no helix axis; the path should be in space");
  }
  Answer answer;
  answer.result = json_of(recognised_helix(document.path.numbers()));
  return answer;
}

}  // namespace hodograph::cli
