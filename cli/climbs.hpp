// SPDX-License-Identifier: MIT
// Climbs of a vehicle: their waypoints, documents and facts. What the subcommand `climb` and the
// requests have in common.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "cli/made_path.hpp"
#include "hodograph/construction/climb_path.hpp"
#include "hodograph/io/geodesy.hpp"
#include "hodograph/path/helix.hpp"

namespace hodograph::cli {

class Members;

/// The words for turn-limited shapes, and for the rules that give headings.
const char* name_of(TurnLimitedShape shape);
inline constexpr const char* heading_words[] = {"t1", "t2"};

/// The waypoints that a file ("-": standard input) holds.
/// - CSV: columns x, y, z (or the first three), optionally heading (radians from the x axis) or
///   heading_deg, climb_angle or climb_deg of the span that begins there.
/// - JSON: a list, alone or as the member "waypoints" of an object, of [x, y, z] or of objects with
///   "position" and optionally "heading" (an angle) or "direction" ([x, y]), "climb_angle" and
///   "ground_length" of the span that begins there.
/// - GeoJSON: LineStrings and Points with altitudes, in order; properties "heading", "climb_angle"
///   and "ground_length" of Points.
/// With a datum, places are longitude, latitude (degrees) and altitude, and become metres east,
/// north and up of it. Throws Error: malformed_document with the line or the JSON pointer.
std::vector<ClimbWaypoint> read_waypoints(const std::string& file,
                                          const std::optional<GeodeticPoint>& datum);

/// One waypoint of JSON, as above.
ClimbWaypoint waypoint_of(Members& members);

/// The document of a path that climbs, with the promise of its angles.
MadePath made_climb(AnyPath path, const std::string& source, const std::string& method,
                    const std::string& choice = "");

Json json_of(const ClimbRoute& route);
Json json_of(const HelixFit& fit);
/// The rows of the table that people read.
std::vector<std::pair<std::string, std::string>> rows_of(const ClimbRoute& route);

}  // namespace hodograph::cli
