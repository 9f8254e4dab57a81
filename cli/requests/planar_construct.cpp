// SPDX-License-Identifier: MIT
// Requests that make planar paths: planar_hermite, prescribed_length, least_peak_curvature, corner,
// rounded_polyline, waypoint_path, planar_spline.
#include "cli/made_path.hpp"
#include "cli/requests/handlers.hpp"
#include "hodograph/construction/corner.hpp"
#include "hodograph/construction/least_peak_curvature.hpp"
#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/construction/waypoint_tangents.hpp"

namespace hodograph::cli {
namespace {

Vector2<double> plane_vector(Members& members, std::string_view name) {
  const auto numbers = members.numbers(name, 2);
  return {numbers[0], numbers[1]};
}

std::vector<Vector2<double>> plane_points(Members& members, std::string_view name) {
  std::vector<Vector2<double>> points;
  for (const auto& p : members.vectors(name, 2)) points.push_back({p[0], p[1]});
  members.require_at_most(name, points.size(), most_points);
  return points;
}

const char* name_of(TieBreak tie) {
  switch (tie) {
    case TieBreak::none:
      return "none";
    case TieBreak::regularity:
      return "regularity";
    case TieBreak::left_turn:
      return "left_turn";
    case TieBreak::order:
      return "order";
  }
  return "";
}

const char* name_of(PeakMinimum kind) {
  switch (kind) {
    case PeakMinimum::interior:
      return "interior";
    case PeakMinimum::at_length_bound:
      return "at_length_bound";
    case PeakMinimum::at_range_end:
      return "at_range_end";
    case PeakMinimum::straight_line:
      return "straight_line";
  }
  return "";
}

/// The preimage, control points and length of a planar curve.
Json json_of_curve(const PlanarPhCurve<2>& curve) {
  Json json = {{"arc_length", curve.arc_length()}};
  json["preimage"] = Json::array();
  for (const auto& w : curve.preimage().coefficients()) json["preimage"].push_back(list_of(w));
  json["control_points"] = Json::array();
  const auto displacement = curve.displacement();
  for (const auto& c : displacement.coefficients()) {
    json["control_points"].push_back(list_of(curve.start() + c));
  }
  return json;
}

template <class Solutions>
Json json_of_solutions(const Solutions& solutions) {
  Json list = Json::array();
  for (const PlanarSolution& one : solutions) {
    Json json = json_of_curve(one.curve);
    json["rotation_index"] = one.rotation_index;
    list.push_back(std::move(json));
  }
  return list;
}

std::string document_of(const PlanarPhCurve<2>& curve, const std::string& method) {
  return to_json(
      made_path(PlanarPath<2>::create({0.0, curve.parameter_step()}, {curve}, false).value(), "",
                method)
          .document);
}

PlanarHermitePoint hermite_end(Members end) {
  const PlanarHermitePoint point{plane_vector(end, "position"), plane_vector(end, "derivative")};
  end.require_all_known();
  return point;
}

/// A position, and a direction given as a vector or as an angle.
DirectedPoint directed_end(Members end) {
  if (end.has("direction") == end.has("angle")) {
    end.refuse("direction", "give the direction as \"direction\" or as \"angle\", one of them");
  }
  DirectedPoint point{plane_vector(end, "position"), {}};
  point.direction =
      end.has("angle") ? direction_of_angle(end.number("angle")) : plane_vector(end, "direction");
  end.require_all_known();
  return point;
}

}  // namespace

Answer answer_planar_hermite(Members& request) {
  const double step = request.number("step", 1.0);
  PlanarHermitePoint begin, end;
  if (request.has("control_points")) {
    const auto p = request.vectors("control_points", 2);
    if (p.size() != 4) {
      request.refuse("control_points", "there should be four of them, p0, p1, p4 and p5; got " +
                                           std::to_string(p.size()));
    }
    const auto data = hermite_data_of_control_points({p[0][0], p[0][1]}, {p[1][0], p[1][1]},
                                                     {p[2][0], p[2][1]}, {p[3][0], p[3][1]}, step);
    begin = data[0];
    end = data[1];
  } else {
    begin = hermite_end(request.object("begin"));
    end = hermite_end(request.object("end"));
  }
  const bool all = request.truth("all", false);
  request.require_all_known();
  const PlanarHermite chosen = planar_hermite(begin, end, step).value();
  Answer answer;
  answer.result = json_of_curve(chosen.curve);
  answer.result["rotation_index"] = chosen.rotation_index;
  answer.result["margin"] = chosen.margin;
  answer.result["tie"] = name_of(chosen.tie);
  if (all) {
    answer.result["solutions"] =
        json_of_solutions(planar_hermite_solutions(begin, end, step).value());
  }
  answer.document = document_of(chosen.curve, "C1 Hermite in the plane");
  return answer;
}

Answer answer_prescribed_length(Members& request) {
  const DirectedPoint begin = directed_end(request.object("begin"));
  const DirectedPoint end = directed_end(request.object("end"));
  const double length = request.number("length"), step = request.number("step", 1.0);
  const LengthSolutions among =
      request.word("among", {"published", "all"}, "published") == "published"
          ? LengthSolutions::published
          : LengthSolutions::all;
  const bool all = request.truth("all", false);
  request.require_all_known();
  const PrescribedLength chosen = prescribed_length_curve(begin, end, length, step, among).value();
  Answer answer;
  answer.result = json_of_curve(chosen.curve);
  answer.result["rotation_index"] = chosen.rotation_index;
  answer.result["margin"] = chosen.margin;
  answer.result["tie"] = name_of(chosen.tie);
  answer.result["unavoidable_rotation"] = chosen.unavoidable_rotation;
  answer.result["crosses_itself"] = crosses_itself(chosen.curve);
  answer.result["loop_free"] = chosen.loop_free;
  if (all) {
    answer.result["solutions"] =
        json_of_solutions(prescribed_length_solutions(begin, end, length, step, among).value());
  }
  answer.document = document_of(chosen.curve, "G1 Hermite of prescribed length");
  return answer;
}

Answer answer_corner(Members& request) {
  const Corner corner{plane_vector(request, "before"), plane_vector(request, "corner"),
                      plane_vector(request, "after")};
  const double step = request.number("step", 1.0);
  const auto leg = request.maybe_number("leg");
  const auto curvature = request.maybe_number("most_curvature");
  const auto deviation = request.maybe_number("most_deviation");
  request.require_all_known();
  if (static_cast<int>(leg.has_value()) + static_cast<int>(curvature.has_value()) +
          static_cast<int>(deviation.has_value()) >
      1) {
    request.refuse("leg",
                   "give one of \"leg\", \"most_curvature\" and \"most_deviation\", or none: the "
                   "corner then takes all the room there is");
  }
  const RoundedCorner rounded = (leg         ? corner_of_leg(corner, *leg, step)
                                 : curvature ? corner_of_curvature(corner, *curvature, step)
                                 : deviation ? corner_of_deviation(corner, *deviation, step)
                                             : corner_of_room(corner, step))
                                    .value();
  Answer answer;
  answer.result = json_of_curve(rounded.curve);
  answer.result["leg"] = rounded.leg;
  answer.result["turning_angle"] = rounded.shape.turning_angle;
  answer.result["peak_curvature"] = rounded.shape.peak_curvature;
  answer.result["deviation"] = rounded.shape.deviation;
  answer.document = document_of(rounded.curve, "G2 corner");
  return answer;
}

Answer answer_rounded_polyline(Members& request) {
  const auto points = plane_points(request, "points");
  CornerRule rule;
  rule.most_curvature = request.maybe_number("most_curvature");
  rule.most_deviation = request.maybe_number("most_deviation");
  rule.closed = request.truth("closed", false);
  request.require_all_known();
  const PlanarPath<2> path = rounded_polyline(points, rule).value();
  Answer answer;
  answer.result = {{"segments", path.segment_count()}, {"arc_length", path.arc_length()}};
  answer.document = to_json(made_path(path, "", "G2 corners").document);
  return answer;
}

Answer answer_waypoint_path(Members& request) {
  const auto points = plane_points(request, "points");
  WaypointOptions options;
  options.rule =
      request.word("rule", {"t1", "t2"}, "t2") == "t1" ? TangentRule::t1 : TangentRule::t2;
  options.closed = request.truth("closed", false);
  options.speed = request.number("speed", options.speed);
  request.require_all_known();
  const auto tangents = waypoint_tangents(points, options).value();
  const PlanarPath<2> path = waypoint_path(points, options).value();
  Answer answer;
  answer.result = {{"segments", path.segment_count()}, {"arc_length", path.arc_length()}};
  Json& list = answer.result["tangents"] = Json::array();
  for (const auto& tangent : tangents) list.push_back(list_of(tangent));
  answer.document =
      to_json(made_path(path, "", "G1 through waypoints",
                        options.rule == TangentRule::t1 ? "tangents by T1" : "tangents by T2")
                  .document);
  return answer;
}

Answer answer_least_peak_curvature(Members& request) {
  const DirectedPoint begin = directed_end(request.object("begin"));
  const DirectedPoint end = directed_end(request.object("end"));
  const double most_length = request.number("most_length");
  const std::string over = request.word("over", {"equal_speeds", "speeds", "length"}, "speeds");
  SpeedRange range;
  if (over != "length" && request.has("speed_range")) {
    const auto numbers = request.numbers("speed_range", 2);
    range = {numbers[0], numbers[1]};
  }
  request.require_all_known();
  const LeastPeakCurvature found =
      (over == "length"   ? least_peak_curvature_of_length(begin, end, most_length)
       : over == "speeds" ? least_peak_curvature_of_speeds(begin, end, most_length, range)
                          : least_peak_curvature_of_equal_speeds(begin, end, most_length, range))
          .value();
  Answer answer;
  answer.result = json_of_curve(found.curve);
  answer.result["peak_curvature"] = cli::json_of(found.peak_curvature);
  answer.result["begin_speed"] = found.begin_speed;
  answer.result["end_speed"] = found.end_speed;
  answer.result["kind"] = name_of(found.kind);
  answer.result["interior"] = found.interior
                                  ? Json{{"parameter", found.interior->parameter},
                                         {"peak_curvature", found.interior->peak_curvature}}
                                  : Json();
  answer.document = document_of(found.curve, "least peak curvature");
  return answer;
}

Answer answer_planar_spline(Members& request) {
  const auto points = plane_points(request, "points");
  PlanarSplineOptions options;
  options.closed = request.truth("closed", false);
  options.parameters = request.word("knots", {"uniform", "chord"}, "uniform") == "chord"
                           ? SplineParameters::chord_length
                           : SplineParameters::uniform;
  options.repeated = request.word("repeated", {"refuse", "merge"}, "refuse") == "merge"
                         ? RepeatedPoints::merge
                         : RepeatedPoints::refuse;
  options.most_alternatives = request.count("most_alternatives", options.most_alternatives);
  options.with_energy = true;
  request.require_all_known();
  PlanarSpline spline = planar_spline(points, options).value();
  const PlanarSplineReport& report = spline.report;
  Answer answer;
  answer.result = {{"segments", spline.path.segment_count()},
                   {"arc_length", spline.path.arc_length()},
                   {"newton_steps", report.newton_steps},
                   {"residual", report.residual},
                   {"closure_sign", report.closure_sign},
                   {"continued", report.continued},
                   {"alternatives_tried", report.alternatives_tried},
                   {"alternatives_taken", report.alternatives_taken},
                   {"solutions_found", report.solutions_found},
                   {"merged_points", report.merged_points},
                   {"bending_energy", report.energy ? Json(*report.energy) : Json()}};
  answer.document = to_json(
      made_path(AnyPath(std::move(spline.path)), "", "C2 spline of planar quintics",
                options.parameters == SplineParameters::uniform ? "uniform knots" : "chord knots")
          .document);
  return answer;
}

}  // namespace hodograph::cli
