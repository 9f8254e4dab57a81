// SPDX-License-Identifier: MIT
// Places on the Earth, and the user's local metres on the plane that touches it at a datum.
//
// The axes of the plane are east (x), north (y) and up (z) at the datum, which is its origin; the
// Earth is the ellipsoid WGS 84. The transformation is a rotation and a translation in space: exact
// lengths and angles, nothing is projected. Since the Earth curves away below its plane, a point d
// from the datum with z = 0 has the height d²/(2 R) above the datum's, R = 6371 km: 0.08 m at 1 km,
// 7.8 m at 10 km. Source: C. F. F. Karney's GeographicLib, class LocalCartesian.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// A place near the Earth: latitude and longitude in degrees, the altitude in metres.
///
/// Altitudes are heights above the ellipsoid. Where they are given above sea level instead, as
/// ground stations do, altitudes that come back are above sea level, too, and places shift sideways
/// by the geoid's height over the Earth's radius: at most 1.7e-5 of their distance from the datum.
struct GeodeticPoint {
  double latitude = 0.0, longitude = 0.0, altitude = 0.0;
  friend bool operator==(const GeodeticPoint&, const GeodeticPoint&) = default;
};

/// Altitudes of places and of datums are between these (metres).
inline constexpr double lowest_altitude = -12e3, highest_altitude = 100e3;
/// Points further than this from the datum, sideways (metres), have no place here: the plane is
/// 785 m above the Earth there.
inline constexpr double farthest_from_datum = 100e3;

/// The fault of a place that is none: not_finite, or outside_domain (a latitude outside [-90, 90],
/// a longitude outside [-180, 180], an altitude outside its limits). `what` is its name in
/// sentences: "the datum".
std::optional<Fault> fault_of(const GeodeticPoint& point, const std::string& what);

/// Whether this build can turn metres into degrees (it was built with GeographicLib).
bool has_geodesy();

/// The plane of local metres at a datum. A value; copies share what does not change.
class LocalTangentPlane {
 public:
  /// Faults: those of fault_of; unsupported where has_geodesy() is false.
  static Result<LocalTangentPlane> create(const GeodeticPoint& datum);

  const GeodeticPoint& datum() const { return datum_; }

  /// The place of a local point (metres: east, north, up). Accuracy: to 1e-8 m, twice the rounding
  /// of a longitude in degrees. Faults: not_finite; outside_domain (further from the datum than
  /// farthest_from_datum, an altitude outside its limits).
  Result<GeodeticPoint> to_geodetic(const Vector3<double>& local) const;

  /// The local point of a place, to the same accuracy. Faults: those of fault_of; outside_domain
  /// (too far from the datum).
  Result<Vector3<double>> to_local(const GeodeticPoint& place) const;

 private:
  struct Transformation;
  LocalTangentPlane(const GeodeticPoint& datum,
                    std::shared_ptr<const Transformation> transformation);
  GeodeticPoint datum_;
  std::shared_ptr<const Transformation> transformation_;
};

}  // namespace hodograph
