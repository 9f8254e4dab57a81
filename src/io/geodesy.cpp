// SPDX-License-Identifier: MIT
// The plane that touches the Earth, by GeographicLib where the build has it.
#include "hodograph/io/geodesy.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#ifdef HODOGRAPH_WITH_GEOGRAPHICLIB
#include <GeographicLib/LocalCartesian.hpp>
#endif

namespace hodograph {
namespace {

std::optional<Fault> outside(double value, double low, double high, const std::string& what,
                             const char* quantity, const char* unit) {
  if (!std::isfinite(value)) {
    return Fault{
        FaultCode::not_finite,
        "the " + std::string(quantity) + " of " + what + " is not finite: " + to_text(value),
        std::nullopt, quantity, value};
  }
  if (low <= value && value <= high) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               "the " + std::string(quantity) + " of " + what + " is " + to_text(value) +
                   "; it should be from " + to_text(low) + " to " + to_text(high) + unit,
               std::nullopt,
               quantity,
               value,
               value < low ? low : high};
}

std::optional<Fault> too_far(const Vector3<double>& local, const std::string& what) {
  const double distance = std::max(std::abs(local.x), std::abs(local.y));
  if (distance <= farthest_from_datum) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               what + " is " + to_text(distance) +
                   " m from the datum; a local plane serves up to " + to_text(farthest_from_datum) +
                   " m: take a nearer datum",
               std::nullopt,
               "distance",
               distance,
               farthest_from_datum};
}

}  // namespace

std::optional<Fault> fault_of(const GeodeticPoint& point, const std::string& what) {
  if (auto fault = outside(point.latitude, -90.0, 90.0, what, "latitude", " degrees")) return fault;
  if (auto fault = outside(point.longitude, -180.0, 180.0, what, "longitude", " degrees")) {
    return fault;
  }
  return outside(point.altitude, lowest_altitude, highest_altitude, what, "altitude", " m");
}

#ifdef HODOGRAPH_WITH_GEOGRAPHICLIB

struct LocalTangentPlane::Transformation {
  GeographicLib::LocalCartesian plane;
};

bool has_geodesy() { return true; }

Result<LocalTangentPlane> LocalTangentPlane::create(const GeodeticPoint& datum) {
  if (auto fault = fault_of(datum, "the datum")) return *fault;
  return LocalTangentPlane(
      datum, std::make_shared<const Transformation>(Transformation{
                 GeographicLib::LocalCartesian(datum.latitude, datum.longitude, datum.altitude)}));
}

Result<GeodeticPoint> LocalTangentPlane::to_geodetic(const Vector3<double>& local) const {
  for (std::size_t j = 0; j < 3; ++j) {
    if (!std::isfinite(local[j])) {
      return Fault{FaultCode::not_finite, "a local point is not finite", std::nullopt, "position",
                   local[j]};
    }
  }
  if (auto fault = too_far(local, "a point")) return *fault;
  GeodeticPoint place;
  transformation_->plane.Reverse(local.x, local.y, local.z, place.latitude, place.longitude,
                                 place.altitude);
  if (auto fault = fault_of(place, "a point")) return *fault;
  return place;
}

Result<Vector3<double>> LocalTangentPlane::to_local(const GeodeticPoint& place) const {
  if (auto fault = fault_of(place, "a place")) return *fault;
  Vector3<double> local;
  transformation_->plane.Forward(place.latitude, place.longitude, place.altitude, local.x, local.y,
                                 local.z);
  if (auto fault = too_far(local, "a place")) return *fault;
  return local;
}

#else

struct LocalTangentPlane::Transformation {};

namespace {

Fault not_built_in() {
  return Fault{FaultCode::unsupported,
               "this build has no GeographicLib, which latitudes and longitudes need: install it "
               "(Debian: libgeographiclib-dev) and build again"};
}

}  // namespace

bool has_geodesy() { return false; }

Result<LocalTangentPlane> LocalTangentPlane::create(const GeodeticPoint& datum) {
  if (auto fault = fault_of(datum, "the datum")) return *fault;
  return not_built_in();
}
Result<GeodeticPoint> LocalTangentPlane::to_geodetic(const Vector3<double>& local) const {
  if (auto fault = too_far(local, "a point")) return *fault;
  return not_built_in();
}
Result<Vector3<double>> LocalTangentPlane::to_local(const GeodeticPoint& place) const {
  if (auto fault = fault_of(place, "a place")) return *fault;
  return not_built_in();
}

#endif

LocalTangentPlane::LocalTangentPlane(const GeodeticPoint& datum,
                                     std::shared_ptr<const Transformation> transformation)
    : datum_(datum), transformation_(std::move(transformation)) {}

}  // namespace hodograph
