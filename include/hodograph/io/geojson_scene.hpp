// SPDX-License-Identifier: MIT
// Paths in a world as GeoJSON (RFC 7946), for maps and for other programs.
//
// Every obstacle is a Feature with a Polygon, the bounds, start and goal have their "role", and
// every path is a LineString whose "role" is "ignored": what is written in local coordinates reads
// back as the same world (geojson.hpp). Coordinates are local, as in the world, unless a datum is
// given: then they are longitude, latitude and (of paths) the height above the ellipsoid WGS 84, as
// RFC 7946 asks, with the datum as a member of the collection. Local coordinates are no RFC 7946
// positions; the collection then says so in its member "coordinates".
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/geodesy.hpp"
#include "hodograph/planning/world.hpp"

namespace hodograph {

/// A path as a line, with what its properties say.
struct GeoJsonPath {
  std::string name{};
  std::string kind{};                     ///< what it is: "G2 corners", "rule T1"
  std::vector<Vector3<double>> points{};  ///< two or more, local metres
  bool spatial = false;                   ///< local coordinates have three numbers
  /// No point of the path is further from the line than this; absent: not known.
  std::optional<double> chord_tolerance{};
  /// The properties "arc_length", "largest_curvature" and "clearance", the distance from the
  /// nearest obstacle, are the lower and the upper ends of enclosures; "curvature_bound" and
  /// "reach" are numbers: obstacles that the clearance does not count are at least at reach.
  Promises promises{};
};

struct GeoJsonScene {
  World world{};
  std::optional<Vector2<double>> start{}, goal{};
  std::vector<GeoJsonPath> paths{};
  /// With it, coordinates become longitudes and latitudes; those of the world at height `altitude`
  /// over the plane (metres), which is also the height of the points of paths that are not spatial.
  std::optional<GeodeticPoint> datum{};
  double altitude = 0.0;
};

/// The scene as a FeatureCollection, one feature a line. Numbers are the shortest decimals that
/// read back to the same doubles; with a datum, positions are those of LocalTangentPlane. A line
/// across longitude 180 is not cut. Faults: too_few (a path of fewer than 2 points: its index),
/// not_finite, those of LocalTangentPlane.
Result<std::string> to_geojson(const GeoJsonScene& scene);

}  // namespace hodograph
