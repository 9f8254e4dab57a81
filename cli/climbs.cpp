// SPDX-License-Identifier: MIT
#include "cli/climbs.hpp"

#include <cmath>
#include <numbers>

#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "cli/requests/batch.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

constexpr double radians = std::numbers::pi / 180.0;

/// Reads places as local coordinates, or as longitude, latitude and altitude.
class Places {
 public:
  explicit Places(const std::optional<GeodeticPoint>& datum) {
    if (datum) plane_ = LocalTangentPlane::create(*datum).value();
  }
  Vector3<double> operator()(double x, double y, double z) const {
    if (!plane_) return {x, y, z};
    return plane_->to_local({y, x, z}).value();
  }

 private:
  std::optional<LocalTangentPlane> plane_;
};

Vector3<double> place_of(const Json& list, const std::string& where, const Places& places) {
  const bool three = list.is_array() && list.size() == 3 && list[0].is_number() &&
                     list[1].is_number() && list[2].is_number();
  if (!three) {
    refuse(where + ": a waypoint is three numbers [x, y, z]; here is " + in_quotes(list.dump()),
           "waypoints");
  }
  return places(list[0].get<double>(), list[1].get<double>(), list[2].get<double>());
}

/// The optional members of a waypoint.
void add_wishes(Members& members, ClimbWaypoint& waypoint) {
  if (members.has("heading") && members.has("direction")) {
    members.refuse("direction", "give the heading as \"heading\" or as \"direction\", one of them");
  }
  if (const auto heading = members.maybe_number("heading")) {
    waypoint.heading = direction_of_angle(*heading);
  }
  if (members.has("direction")) {
    const auto numbers = members.numbers("direction", 2);
    waypoint.heading = Vector2<double>{numbers[0], numbers[1]};
  }
  waypoint.climb_angle = members.maybe_number("climb_angle");
  waypoint.ground_length = members.maybe_number("ground_length");
  if (waypoint.climb_angle && waypoint.ground_length) {
    members.refuse("ground_length",
                   "a climb angle and a length over ground "
                   "exclude each other; give one of them");
  }
}

std::vector<ClimbWaypoint> from_list(const Json& list, const std::string& pointer,
                                     const std::string& name, const Places& places) {
  if (!list.is_array()) {
    refuse(name +
               " has no list of waypoints; JSON should be a list of [x, y, "
               "z], alone or as the "
               "member \"waypoints\" of an object, or GeoJSON",
           "waypoints");
  }
  std::vector<ClimbWaypoint> waypoints;
  for (const Json& item : list) {
    std::string where = pointer;
    where.append("/").append(std::to_string(waypoints.size()));
    if (!item.is_object()) {
      waypoints.push_back(
          {place_of(item, std::string(name).append(", at ").append(where), places), {}, {}, {}});
      continue;
    }
    Members members(item, where, name);
    ClimbWaypoint waypoint = waypoint_of(members);
    members.require_all_known();
    const auto& p = waypoint.position;
    waypoint.position = places(p.x, p.y, p.z);
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

/// The waypoints of GeoJSON, in the order of the text.
class GeoJsonWaypoints {
 public:
  GeoJsonWaypoints(const std::string& name, const Places& places) : name_(name), places_(places) {}

  void read(const Json& value, const std::string& pointer, const Json* properties, int depth) {
    constexpr int deepest = 32;
    if (depth > deepest) refuse(name_ + ": collections are nested too deeply", "waypoints");
    const std::string type =
        value.is_object() && value.contains("type") && value["type"].is_string()
            ? value["type"].get<std::string>()
            : "";
    if (type == "FeatureCollection" || type == "GeometryCollection") {
      const char* const items = type == "FeatureCollection" ? "features" : "geometries";
      for (std::size_t i = 0; value.contains(items) && i < value[items].size(); ++i) {
        read(value[items][i], pointer + "/" + items + "/" + std::to_string(i), properties,
             depth + 1);
      }
    } else if (type == "Feature") {
      const Json* const own = value.contains("properties") && value["properties"].is_object()
                                  ? &value["properties"]
                                  : nullptr;
      if (value.contains("geometry") && !value["geometry"].is_null()) {
        read(value["geometry"], pointer + "/geometry", own, depth + 1);
      }
    } else if (type == "Point" || type == "LineString") {
      add(value, type, pointer, properties);
    } else {
      refuse(name_ + ", at " + (pointer.empty() ? "/" : pointer) +
                 ": waypoints are 'Point' and 'LineString'; here is " + in_quotes(type),
             "waypoints");
    }
  }
  std::vector<ClimbWaypoint> waypoints;

 private:
  void add(const Json& geometry, const std::string& type, const std::string& pointer,
           const Json* properties) {
    const std::string place = pointer + "/coordinates";
    if (!geometry.contains("coordinates"))
      refuse(name_ + ", at " + place + ": there are none", "waypoints");
    const Json& coordinates = geometry["coordinates"];
    if (type == "LineString") {
      for (auto& waypoint : from_list(coordinates, place, name_, places_)) {
        waypoints.push_back(waypoint);
      }
      return;
    }
    ClimbWaypoint waypoint{place_of(coordinates, name_ + ", at " + place, places_), {}, {}, {}};
    if (properties != nullptr) {
      Members members(*properties, pointer, name_);
      add_wishes(members, waypoint);
    }
    waypoints.push_back(waypoint);
  }

  const std::string& name_;
  const Places& places_;
};

std::vector<ClimbWaypoint> from_table(const Table& table, const Places& places) {
  if (table.column_count < 3)
    refuse("a table of waypoints needs three columns, x, y and z", "waypoints");
  const auto named = [&](const char* name) -> std::optional<std::size_t> {
    const auto found = table.column(name);
    return found && !table.names.empty() ? std::optional(*found) : std::nullopt;
  };
  const auto x = named("x"), y = named("y"), z = named("z");
  const bool by_name = x && y && z;
  const auto heading = named("heading"), heading_degrees = named("heading_deg");
  const auto angle = named("climb_angle"), degrees = named("climb_deg");
  std::vector<ClimbWaypoint> waypoints;
  for (std::size_t row = 0; row < table.row_count(); ++row) {
    const auto at = [&](std::size_t column) { return table.at(row, column); };
    ClimbWaypoint waypoint{
        by_name ? places(at(*x), at(*y), at(*z)) : places(at(0), at(1), at(2)), {}, {}, {}};
    if (heading_degrees) waypoint.heading = direction_of_angle(radians * at(*heading_degrees));
    if (heading) waypoint.heading = direction_of_angle(at(*heading));
    if (degrees) waypoint.climb_angle = radians * at(*degrees);
    if (angle) waypoint.climb_angle = at(*angle);
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

std::string degrees_text(double angle) { return to_six_digits(angle / radians) + " deg"; }

}  // namespace

const char* name_of(TurnLimitedShape shape) {
  switch (shape) {
    case TurnLimitedShape::one_span:
      return "one_span";
    case TurnLimitedShape::arcs:
      return "arcs";
    case TurnLimitedShape::swerve:
      return "swerve";
    case TurnLimitedShape::loiter:
      return "loiter";
  }
  return "";
}

ClimbWaypoint waypoint_of(Members& members) {
  const auto p = members.numbers("position", 3);
  ClimbWaypoint waypoint{{p[0], p[1], p[2]}, {}, {}, {}};
  add_wishes(members, waypoint);
  return waypoint;
}

std::vector<ClimbWaypoint> read_waypoints(const std::string& file,
                                          const std::optional<GeodeticPoint>& datum) {
  const std::string name = input_name(file);
  const std::string text = read_file(file).value();
  const Places places(datum);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string::npos || (text[first] != '[' && text[first] != '{')) {
    return from_table(read_table(text, name).value(), places);
  }
  const Json json = parsed_json(text, name);
  if (json.is_object() && json.contains("type")) {
    GeoJsonWaypoints reader(name, places);
    reader.read(json, "", nullptr, 0);
    return std::move(reader.waypoints);
  }
  const bool named = json.is_object() && json.contains("waypoints");
  return from_list(named ? json["waypoints"] : json, named ? "/waypoints" : "", name, places);
}

MadePath made_climb(AnyPath path, const std::string& source, const std::string& method,
                    const std::string& choice) {
  const HelixFit fit = recognised_helix(path.numbers());
  MadePath made = made_path(std::move(path), source, method, choice);
  if (!fit.is_helical()) return made;
  HelixPromise promise{fit.axis, {}};
  for (const HelixStretch& stretch : fit.stretches) {
    if (!is_finite(stretch.sine_range)) return made;
    promise.sines.push_back({stretch.first, stretch.sine_range});
  }
  made.document.promises.helix = std::move(promise);
  return made;
}

Json json_of(const ClimbRoute& route) {
  Json json = {{"arc_length", route.path.arc_length()},
               {"segments", route.path.segment_count()},
               {"xi_end", route.path.xi_end()}};
  json["headings"] = Json::array();
  for (const auto& heading : route.headings) {
    json["headings"].push_back(std::atan2(heading.y, heading.x));
  }
  json["spans"] = Json::array();
  for (const ClimbSpan& span : route.spans) {
    json["spans"].push_back({{"first_segment", span.first},
                             {"last_segment", span.last},
                             {"climb_angle", span.climb_angle},
                             {"ground_length", span.ground_length},
                             {"shape", name_of(span.shape)},
                             {"whole_turns", span.whole_turns},
                             {"most_ground_curvature", span.most_ground_curvature}});
  }
  json["joints"] = Json::array();
  for (const ClimbJoint& joint : route.joints) {
    json["joints"].push_back({{"waypoint", joint.waypoint},
                              {"knot", joint.knot},
                              {"pitch_change", joint.pitch_change},
                              {"continuity",
                               {{"position", joint.position},
                                {"preimage", joint.preimage},
                                {"frame", joint.frame},
                                {"angular_velocity", joint.angular_velocity}}}});
  }
  return json;
}

Json json_of(const HelixFit& fit) {
  Json json = {{"helical", fit.is_helical()},
               {"helix", fit.is_helix()},
               {"axis", list_of(fit.axis)},
               {"residual", fit.residual},
               {"freedom", fit.freedom}};
  json["stretches"] = Json::array();
  for (const HelixStretch& stretch : fit.stretches) {
    json["stretches"].push_back({{"first_segment", stretch.first},
                                 {"last_segment", stretch.last},
                                 {"climb_angle", std::asin(stretch.sine)},
                                 {"sine", stretch.sine},
                                 {"sine_bounds", json_of(stretch.sine_range)}});
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const ClimbRoute& route) {
  std::vector<std::pair<std::string, std::string>> rows;
  for (std::size_t i = 0; i < route.spans.size(); ++i) {
    const ClimbSpan& span = route.spans[i];
    std::string text = degrees_text(span.climb_angle) + " over " +
                       to_six_digits(span.ground_length) + " of ground, ";
    switch (span.shape) {
      case TurnLimitedShape::one_span:
        text += "one quintic";
        break;
      case TurnLimitedShape::arcs:
        text += "arcs";
        break;
      case TurnLimitedShape::swerve:
        text += "arcs and a swerve";
        break;
      case TurnLimitedShape::loiter:
        text += std::to_string(span.whole_turns) +
                (span.whole_turns == 1 ? " whole turn" : " whole turns");
        break;
    }
    if (span.most_ground_curvature > 0.0) {
      text += ", turn radius at least " + to_six_digits(1.0 / span.most_ground_curvature);
    }
    rows.emplace_back("Climb " + std::to_string(i + 1), text);
  }
  for (const ClimbJoint& joint : route.joints) {
    const bool corner = joint.position < 1;
    rows.emplace_back("At waypoint " + std::to_string(joint.waypoint + 1),
                      corner ? "a corner in pitch, " + degrees_text(joint.pitch_change)
                             : "position C" + std::to_string(joint.position) + ", frame C" +
                                   std::to_string(joint.frame));
  }
  return rows;
}

}  // namespace hodograph::cli
