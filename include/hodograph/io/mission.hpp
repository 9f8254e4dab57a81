// SPDX-License-Identifier: MIT
// Missions of drones: waypoints in the user's local metres as the files that ground stations read.
//
// Two formats: the plan files of QGroundControl (JSON, "fileType": "Plan", version 1) and the older
// text "QGC WPL 110", which Mission Planner and ArduPilot read as well. Both hold a home, and
// waypoints (MAVLink command 16) at latitude, longitude and an altitude above home (frame 3), with
// changes of speed (command 178) between them. Home is the datum of the local plane, see
// geodesy.hpp. An autopilot receives latitudes and longitudes in units of 1e-7 degrees: 1.1 cm.
// Between waypoints it flies straight lines, so waypoints along a path are chosen by their chords.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/io/geodesy.hpp"
#include "hodograph/path/sampling.hpp"

namespace hodograph {

/// A waypoint in local metres: x east, y north, z up from home.
struct LocalWaypoint {
  Vector3<double> position{};
  std::optional<double> speed{};  ///< over ground (m/s), on the way here; absent: as before
};

/// A waypoint on the Earth.
struct MissionWaypoint {
  double latitude = 0.0, longitude = 0.0;  ///< degrees
  double height = 0.0;                     ///< above home, metres
  std::optional<double> speed{};           ///< over ground (m/s), on the way here
  friend bool operator==(const MissionWaypoint&, const MissionWaypoint&) = default;
};

/// What a mission file holds.
struct Mission {
  GeodeticPoint home{};
  std::vector<MissionWaypoint> waypoints{};
  /// Within this distance (metres) a waypoint counts as reached; 0: the autopilot's own.
  double acceptance_radius = 0.0;
};

/// More waypoints than this fit into no autopilot: items are counted in 16 bits.
inline constexpr std::size_t most_waypoints = 32767;

/// The mission through the waypoints, home at the datum. Positions: those of the plane, see
/// LocalTangentPlane. Faults, with the index of the waypoint: those of LocalTangentPlane;
/// outside_domain (a speed that is not positive); not_finite; too_few (no waypoint at all);
/// unsupported (more than most_waypoints).
Result<Mission> mission(std::span<const LocalWaypoint> waypoints, const GeodeticPoint& datum);

/// The mission as a plan file of QGroundControl. Numbers are the shortest decimals that read back
/// to the same doubles. What the file asks for besides: the vehicle is a generic one (vehicle type
/// 2, firmware type 0), no fence, no rally points; the speeds of cruise and hover are the first
/// speed of the waypoints, or 5 m/s where they have none.
/// Faults: those of fault_of(mission).
Result<std::string> to_qgroundcontrol_plan(const Mission& mission);

/// The mission as "QGC WPL 110": fields separated by tabs, home in line 0, numbers as above without
/// exponents. Faults: as above.
Result<std::string> to_waypoint_file(const Mission& mission);

/// The fault of a mission that no file can hold: too_few, unsupported, not_finite and
/// outside_domain, as above, with the waypoint's index; also a negative acceptance radius.
std::optional<Fault> fault_of(const Mission& mission);

/// Waypoints along a path, every knot among them, so that every point of the path is within
/// `tolerance` (metres) of the polyline through them: certified, see polyline_parameters. A planar
/// path is flown at the height z = `altitude`; a spatial one has it added. Local coordinates.
/// Faults: those of polyline_parameters.
template <PreimageAlgebra A, std::size_t n>
Result<std::vector<LocalWaypoint>> waypoints_along(const Path<A, n>& path, double tolerance,
                                                   double altitude = 0.0) {
  const auto parameters = polyline_parameters(path, tolerance);
  if (!parameters) return parameters.fault();
  std::vector<LocalWaypoint> waypoints;
  waypoints.reserve(parameters->size());
  for (const double xi : *parameters) {
    const auto point = path.position(xi);
    Vector3<double> place{point.x, point.y, altitude};
    if constexpr (std::remove_cvref_t<decltype(point)>::dimension == 3) place.z += point.z;
    waypoints.push_back({place, std::nullopt});
  }
  return waypoints;
}

}  // namespace hodograph
