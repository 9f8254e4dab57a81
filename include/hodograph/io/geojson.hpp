// SPDX-License-Identifier: MIT
// Worlds from GeoJSON (RFC 7946), coordinates taken as they stand: plane, in any unit of length.
//
// Read are Polygon, MultiPolygon, GeometryCollection, Feature and FeatureCollection. A polygon is
// an obstacle; each part of a MultiPolygon is an obstacle of its own. What a feature's properties
// say: "role": "obstacle" (the default), "bounds" (one Polygon without holes that the vehicle stays
// in), "start" or "goal" (one Point), "ignored"; "name" is the obstacle's name, or else the
// feature's "id". A third coordinate (height) is left out; other members mean nothing here.
// Longitudes and latitudes are no plane coordinates: project them before.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "hodograph/foundation/result.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph {

/// A world, and the places that its file names.
struct WorldDocument {
  World world{};
  std::optional<Vector2<double>> start{}, goal{};
};

/// The world that a text holds. Rings may repeat their first point as the last, as GeoJSON asks, or
/// not. Memory: some hundred bytes a vertex while reading.
///
/// Faults: malformed_document (broken JSON, with line and column; a wrong type, a number beyond the
/// range of double, a missing member, a second start, goal or bounds: with the place as a JSON
/// pointer, also in Fault::quantity); unsupported (points and lines that are no start or goal, an
/// unknown role, bounds with holes); those of World::create. Nothing is thrown.
/// `source` is how sentences call the text.
Result<WorldDocument> parse_world(std::string_view text, const std::string& source = "the world");

/// The same from a file ("-": standard input; see file.hpp for the faults).
Result<WorldDocument> load_world(const std::string& path);

}  // namespace hodograph
