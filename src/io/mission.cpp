// SPDX-License-Identifier: MIT
// Mission files: the plan files of QGroundControl and "QGC WPL 110".
#include "hodograph/io/mission.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>

#include "hodograph/foundation/version.hpp"
#include "number.hpp"

namespace hodograph {
namespace {

// MAVLink's numbers.
constexpr int navigate_to_waypoint = 16, change_speed = 178;
constexpr int global_frame = 0, height_above_home_frame = 3, mission_frame = 2;
constexpr int ground_speed = 1;
constexpr double default_speed = 5.0;  // m/s, where waypoints have none

Fault not_finite(std::size_t index, const char* quantity, double value) {
  return Fault{FaultCode::not_finite,
               "the " + std::string(quantity) + " of waypoint " + std::to_string(index) +
                   " is not finite: " + to_text(value),
               index, quantity, value};
}

std::optional<Fault> count_fault(std::size_t count) {
  if (count == 0) {
    return Fault{FaultCode::too_few,
                 "a mission needs a waypoint; there is none",
                 std::nullopt,
                 "waypoints",
                 0.0,
                 1.0};
  }
  if (count > most_waypoints) {
    return Fault{FaultCode::unsupported,
                 "a mission has at most " + std::to_string(most_waypoints) +
                     " waypoints; these are " + std::to_string(count) +
                     ": a larger chord tolerance needs fewer",
                 std::nullopt,
                 "waypoints",
                 static_cast<double>(count),
                 static_cast<double>(most_waypoints)};
  }
  return std::nullopt;
}

std::optional<Fault> speed_fault(const std::optional<double>& speed, std::size_t index) {
  if (!speed) return std::nullopt;
  if (!std::isfinite(*speed)) return not_finite(index, "speed", *speed);
  if (*speed > 0.0) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the speed on the way to waypoint " + std::to_string(index) + " is " +
                   to_text(*speed) + " m/s; it should be positive",
               index,
               "speed",
               *speed,
               0.0};
}

/// Calls waypoint(w) for each, and speed(v) before it where another speed than before is asked for.
template <class OnSpeed, class OnWaypoint>
void each_item(const Mission& mission, const OnSpeed& speed, const OnWaypoint& waypoint) {
  std::optional<double> current;
  for (const MissionWaypoint& one : mission.waypoints) {
    if (one.speed && one.speed != current) {
      speed(*one.speed);
      current = one.speed;
    }
    waypoint(one);
  }
}

/// The shortest decimal without an exponent.
void append_fixed(std::string& out, double value) {
  constexpr std::size_t longest = 400;  // the digits of the smallest and the largest double
  std::array<char, longest> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
                                          value == 0.0 ? 0.0 : value, std::chars_format::fixed);
  out.append(buffer.data(), error == std::errc{} ? end : buffer.data());
}

}  // namespace

std::optional<Fault> fault_of(const Mission& mission) {
  if (auto fault = fault_of(mission.home, "home")) return fault;
  if (auto fault = count_fault(mission.waypoints.size())) return fault;
  if (!(mission.acceptance_radius >= 0.0) || !std::isfinite(mission.acceptance_radius)) {
    return Fault{FaultCode::outside_domain,
                 "the acceptance radius is " + to_text(mission.acceptance_radius) +
                     " m; it should be 0 (the autopilot's own) or a positive number",
                 std::nullopt,
                 "acceptance_radius",
                 mission.acceptance_radius,
                 0.0};
  }
  for (std::size_t i = 0; i < mission.waypoints.size(); ++i) {
    const MissionWaypoint& one = mission.waypoints[i];
    if (!std::isfinite(one.height)) return not_finite(i, "height", one.height);
    auto fault =
        fault_of(GeodeticPoint{one.latitude, one.longitude, one.height + mission.home.altitude},
                 "waypoint " + std::to_string(i));
    if (!fault) fault = speed_fault(one.speed, i);
    if (fault) {
      fault->index = i;
      return fault;
    }
  }
  return std::nullopt;
}

Result<Mission> mission(std::span<const LocalWaypoint> waypoints, const GeodeticPoint& datum) {
  const auto plane = LocalTangentPlane::create(datum);
  if (!plane) return plane.fault();
  if (auto fault = count_fault(waypoints.size())) return *fault;
  Mission result;
  result.home = datum;
  result.waypoints.reserve(waypoints.size());
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    const auto place = plane->to_geodetic(waypoints[i].position);
    if (!place) {
      Fault fault = place.fault();
      fault.sentence = "waypoint " + std::to_string(i) + ": " + fault.sentence;
      fault.index = i;
      return fault;
    }
    if (auto fault = speed_fault(waypoints[i].speed, i)) return *fault;
    result.waypoints.push_back(
        {place->latitude, place->longitude, place->altitude - datum.altitude, waypoints[i].speed});
  }
  return result;
}

Result<std::string> to_qgroundcontrol_plan(const Mission& mission) {
  if (auto fault = fault_of(mission)) return *fault;
  double first_speed = default_speed;
  for (const MissionWaypoint& one : mission.waypoints) {
    if (one.speed) {
      first_speed = *one.speed;
      break;
    }
  }
  std::string out;
  const auto number = [&](double value) {
    io_detail::append_number(out, value == 0.0 ? 0.0 : value);
  };
  out = "{\n  \"fileType\": \"Plan\",\n  \"version\": 1,\n  \"groundStation\": \"Hodograph " +
        std::string(version) +
        "\",\n  \"geoFence\": {\"version\": 2, \"circles\": [], \"polygons\": []},\n"
        "  \"rallyPoints\": {\"version\": 2, \"points\": []},\n"
        "  \"mission\": {\n    \"version\": 2,\n    \"firmwareType\": 0,\n    \"vehicleType\": 2,\n"
        "    \"globalPlanAltitudeMode\": 1,\n    \"cruiseSpeed\": ";
  number(first_speed);
  out += ",\n    \"hoverSpeed\": ";
  number(first_speed);
  out += ",\n    \"plannedHomePosition\": [";
  number(mission.home.latitude);
  out += ", ";
  number(mission.home.longitude);
  out += ", ";
  number(mission.home.altitude);
  out += "],\n    \"items\": [";
  std::size_t id = 0;
  const auto begin = [&](int command, int frame) {
    out += id == 0 ? "\n" : ",\n";
    out += "      {\"type\": \"SimpleItem\", \"autoContinue\": true, \"command\": " +
           std::to_string(command) + ", \"doJumpId\": " + std::to_string(++id) +
           ", \"frame\": " + std::to_string(frame) + ", ";
  };
  each_item(
      mission,
      [&](double speed) {
        begin(change_speed, mission_frame);
        out += "\"params\": [" + std::to_string(ground_speed) + ", ";
        number(speed);
        out += ", -1, 0, 0, 0, 0]}";
      },
      [&](const MissionWaypoint& one) {
        begin(navigate_to_waypoint, height_above_home_frame);
        out += "\"AMSLAltAboveTerrain\": null, \"Altitude\": ";
        number(one.height);
        out += ", \"AltitudeMode\": 1, \"params\": [0, ";
        number(mission.acceptance_radius);
        out += ", 0, null, ";
        number(one.latitude);
        out += ", ";
        number(one.longitude);
        out += ", ";
        number(one.height);
        out += "]}";
      });
  out += "\n    ]\n  }\n}\n";
  return out;
}

Result<std::string> to_waypoint_file(const Mission& mission) {
  if (auto fault = fault_of(mission)) return *fault;
  std::string out = "QGC WPL 110\n";
  std::size_t index = 0;
  // index, current, frame, command, four parameters, latitude, longitude, altitude, autocontinue
  const auto item = [&](int frame, int command, const std::array<double, 7>& parameters) {
    out += std::to_string(index) + (index == 0 ? "\t1\t" : "\t0\t") + std::to_string(frame) + "\t" +
           std::to_string(command);
    for (const double parameter : parameters) {
      out += "\t";
      append_fixed(out, parameter);
    }
    out += "\t1\n";
    ++index;
  };
  item(global_frame, navigate_to_waypoint,
       {0.0, 0.0, 0.0, 0.0, mission.home.latitude, mission.home.longitude, mission.home.altitude});
  each_item(
      mission,
      [&](double speed) {
        item(height_above_home_frame, change_speed,
             {static_cast<double>(ground_speed), speed, -1.0, 0.0, 0.0, 0.0, 0.0});
      },
      [&](const MissionWaypoint& one) {
        item(height_above_home_frame, navigate_to_waypoint,
             {0.0, mission.acceptance_radius, 0.0, 0.0, one.latitude, one.longitude, one.height});
      });
  return out;
}

}  // namespace hodograph
