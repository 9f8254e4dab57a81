// SPDX-License-Identifier: MIT
// Missions: metres to degrees and back, waypoints whose chords keep a tolerance, and both formats
// as a ground station reads them.
#include "hodograph/io/mission.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "hodograph/algebra/preimage_algebra.hpp"

#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using Json = nlohmann::json;
using test::Random;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr GeodeticPoint zurich{47.3976, 8.5456, 488.0};
/// Twice the rounding of 180 degrees, in metres (1.6e-9 m), for each of the conversions and for the
/// coordinates from the centre of the Earth that they pass through.
constexpr double conversion_error = 8e-9;

/// WGS 84 by its definition: the half axis and the flattening.
constexpr long double half_axis = 6378137.0L, flattening = 1.0L / 298.257223563L;
constexpr long double degree = 0.017453292519943295769236907684886127L;

/// The local point of a place, from the definition of latitude, longitude and height.
Vector3<double> by_definition(const GeodeticPoint& place, const GeodeticPoint& datum) {
  const long double e2 = flattening * (2.0L - flattening);
  const auto centred = [&](const GeodeticPoint& p, long double out[3]) {
    const long double phi = p.latitude * degree, lambda = p.longitude * degree;
    const long double n = half_axis / std::sqrt(1.0L - e2 * std::sin(phi) * std::sin(phi));
    out[0] = (n + p.altitude) * std::cos(phi) * std::cos(lambda);
    out[1] = (n + p.altitude) * std::cos(phi) * std::sin(lambda);
    out[2] = (n * (1.0L - e2) + p.altitude) * std::sin(phi);
  };
  long double a[3], b[3];
  centred(place, a);
  centred(datum, b);
  const long double dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
  const long double phi = datum.latitude * degree, lambda = datum.longitude * degree;
  const long double outward = std::cos(lambda) * dx + std::sin(lambda) * dy;
  return {static_cast<double>(-std::sin(lambda) * dx + std::cos(lambda) * dy),
          static_cast<double>(-std::sin(phi) * outward + std::cos(phi) * dz),
          static_cast<double>(std::cos(phi) * outward + std::sin(phi) * dz)};
}

double distance(const Vector3<double>& a, const Vector3<double>& b) { return norm(a - b); }

TEST(Geodesy, TakesMetresToDegreesAndBack) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  Random random("metres to degrees and back");
  for (int i = 0; i < 400; ++i) {
    const GeodeticPoint datum{random.uniform(-90, 90), random.uniform(-180, 180),
                              random.uniform(-400, 9000)};
    const auto plane = LocalTangentPlane::create(datum);
    ASSERT_TRUE(plane) << plane.fault().sentence;
    const double size = std::ldexp(1.0, static_cast<int>(random.integer(-4, 16)));
    Vector3<double> local = random.vector3(size);
    local.z = random.uniform(-100, 500);
    const auto place = plane->to_geodetic(local);
    ASSERT_TRUE(place) << place.fault().sentence;
    EXPECT_LE(distance(by_definition(*place, datum), local), conversion_error);
    const auto back = plane->to_local(*place);
    ASSERT_TRUE(back) << back.fault().sentence;
    EXPECT_LE(distance(*back, local), conversion_error);
  }
  const auto plane = LocalTangentPlane::create(zurich);
  EXPECT_EQ(plane->datum(), zurich);
  const auto origin = plane->to_geodetic({0, 0, 0});
  EXPECT_NEAR(origin->latitude, zurich.latitude, 360 * std::numeric_limits<double>::epsilon());
  EXPECT_NEAR(origin->altitude, zurich.altitude, conversion_error);
}

TEST(Geodesy, KnowsThePolesAndTheDateLine) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  for (const GeodeticPoint& datum :
       {GeodeticPoint{90, 0, 0}, {-90, 30, 0}, {0, 180, 0}, {12, -180, 5}}) {
    const auto plane = LocalTangentPlane::create(datum);
    ASSERT_TRUE(plane);
    for (const Vector3<double>& local : {Vector3<double>{5, 7, 1}, {-5, -7, 0}, {0, 0, 0}}) {
      const auto place = plane->to_geodetic(local);
      ASSERT_TRUE(place) << place.fault().sentence;
      EXPECT_LE(distance(by_definition(*place, datum), local), conversion_error);
    }
  }
}

TEST(Geodesy, RefusesWhatIsNoPlace) {
  const auto refuse = [](const GeodeticPoint& datum, FaultCode code, const char* quantity) {
    const auto plane = LocalTangentPlane::create(datum);
    ASSERT_FALSE(plane);
    EXPECT_EQ(plane.fault().code, code);
    EXPECT_EQ(plane.fault().quantity, quantity);
    EXPECT_NE(plane.fault().sentence.find("the datum"), std::string::npos);
  };
  refuse({90.5, 0, 0}, FaultCode::outside_domain, "latitude");
  refuse({-91, 0, 0}, FaultCode::outside_domain, "latitude");
  refuse({0, 181, 0}, FaultCode::outside_domain, "longitude");
  refuse({0, 0, 1e6}, FaultCode::outside_domain, "altitude");
  refuse({0, nan, 0}, FaultCode::not_finite, "longitude");
  if (!has_geodesy()) {
    EXPECT_EQ(LocalTangentPlane::create(zurich).fault().code, FaultCode::unsupported);
    return;
  }
  const auto plane = LocalTangentPlane::create(zurich);
  EXPECT_EQ(plane->to_geodetic({2e5, 0, 0}).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(plane->to_geodetic({0, nan, 0}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(plane->to_geodetic({0, 0, 2e5}).fault().quantity, "altitude");
  EXPECT_EQ(plane->to_local({-47, 8, 0}).fault().quantity, "distance");
}

// ---- missions -----------------------------------------------------------------------------------

/// A mission without the conversion, for the formats.
Mission sample() {
  constexpr double tiny = 1e-7;  // not a tolerance: its shortest decimal has an exponent
  Mission mission;
  mission.home = zurich;
  mission.acceptance_radius = 2.5;
  mission.waypoints = {{47.3977, 8.5456, 20.0, 4.0},
                       {47.39775, 8.54561, 20.125, 4.0},
                       {47.39785, -tiny, tiny, std::nullopt},
                       {-47.0, 8.0, -3.0, 6.5}};
  return mission;
}

TEST(Mission, WritesPlansOfQGroundControl) {
  const Mission mission = sample();
  const auto text = to_qgroundcontrol_plan(mission);
  ASSERT_TRUE(text) << text.fault().sentence;
  const Json plan = Json::parse(*text);
  EXPECT_EQ(plan["fileType"].get<std::string>(), "Plan");
  EXPECT_EQ(plan["version"].get<double>(), 1);
  EXPECT_EQ(plan["geoFence"]["version"].get<double>(), 2);
  EXPECT_EQ(plan["rallyPoints"]["version"].get<double>(), 2);
  EXPECT_EQ(plan["groundStation"].get<std::string>().find("Hodograph"), 0U);
  const Json& inside = plan["mission"];
  EXPECT_EQ(inside["version"].get<double>(), 2);
  EXPECT_EQ(inside["cruiseSpeed"].get<double>(), 4.0);
  EXPECT_EQ(inside["hoverSpeed"].get<double>(), 4.0);
  const Json& home = inside["plannedHomePosition"];
  EXPECT_EQ(home, Json({zurich.latitude, zurich.longitude, zurich.altitude}));
  const Json& items = inside["items"];
  ASSERT_EQ(items.size(), 6U);  // 4 waypoints, 2 changes of speed
  std::size_t waypoint = 0;
  std::vector<double> speeds;
  for (std::size_t i = 0; i < items.size(); ++i) {
    EXPECT_EQ(items[i]["type"].get<std::string>(), "SimpleItem");
    EXPECT_EQ(items[i]["doJumpId"].get<double>(), static_cast<double>(i + 1));
    const Json& params = items[i]["params"];
    ASSERT_EQ(params.size(), 7U);
    if (items[i]["command"].get<double>() == 178) {
      EXPECT_EQ(params[0].get<double>(), 1);
      EXPECT_EQ(params[2].get<double>(), -1);
      EXPECT_EQ(items[i]["frame"].get<double>(), 2);
      speeds.push_back(params[1].get<double>());
      EXPECT_EQ(mission.waypoints[waypoint].speed, speeds.back());
      continue;
    }
    EXPECT_EQ(items[i]["command"].get<double>(), 16);
    EXPECT_EQ(items[i]["frame"].get<double>(), 3);
    const MissionWaypoint& wanted = mission.waypoints[waypoint++];
    EXPECT_EQ(params[1].get<double>(), 2.5);
    EXPECT_EQ(params[4].get<double>(), wanted.latitude);
    EXPECT_EQ(params[5].get<double>(), wanted.longitude);
    EXPECT_EQ(params[6].get<double>(), wanted.height);
    EXPECT_EQ(items[i]["Altitude"].get<double>(), wanted.height);
    EXPECT_EQ(items[i]["AltitudeMode"].get<double>(), 1);
  }
  EXPECT_EQ(waypoint, mission.waypoints.size());
  EXPECT_EQ(speeds, (std::vector<double>{4.0, 6.5}));
}

TEST(Mission, WritesWaypointFiles) {
  const Mission mission = sample();
  const auto text = to_waypoint_file(mission);
  ASSERT_TRUE(text) << text.fault().sentence;
  std::istringstream lines(*text);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "QGC WPL 110");
  std::size_t index = 0, waypoint = 0;
  std::vector<double> speeds;
  while (std::getline(lines, line)) {
    EXPECT_EQ(line.find_first_of("eE "), std::string::npos) << line;
    std::vector<double> fields;
    std::istringstream cells(line);
    std::string cell;
    while (std::getline(cells, cell, '\t')) fields.push_back(std::strtod(cell.c_str(), nullptr));
    ASSERT_EQ(fields.size(), 12U) << line;
    EXPECT_EQ(fields[0], static_cast<double>(index));
    EXPECT_EQ(fields[1], index == 0 ? 1 : 0);
    EXPECT_EQ(fields[11], 1);
    if (index++ == 0) {
      EXPECT_EQ(fields[2], 0);
      EXPECT_EQ(fields[3], 16);
      EXPECT_EQ(fields[8], zurich.latitude);
      EXPECT_EQ(fields[9], zurich.longitude);
      EXPECT_EQ(fields[10], zurich.altitude);
      continue;
    }
    EXPECT_EQ(fields[2], 3);
    if (fields[3] == 178) {
      EXPECT_EQ(fields[4], 1);
      speeds.push_back(fields[5]);
      continue;
    }
    EXPECT_EQ(fields[3], 16);
    const MissionWaypoint& wanted = mission.waypoints[waypoint++];
    EXPECT_EQ(fields[5], 2.5);
    EXPECT_EQ(fields[8], wanted.latitude);
    EXPECT_EQ(fields[9], wanted.longitude);
    EXPECT_EQ(fields[10], wanted.height);
  }
  EXPECT_EQ(waypoint, mission.waypoints.size());
  EXPECT_EQ(speeds, (std::vector<double>{4.0, 6.5}));
}

TEST(Mission, RefusesWhatNoFileCanHold) {
  const auto refuse = [](const Mission& mission, FaultCode code, std::optional<std::size_t> index,
                         const char* quantity) {
    for (const auto& text : {to_qgroundcontrol_plan(mission), to_waypoint_file(mission)}) {
      ASSERT_FALSE(text);
      EXPECT_EQ(text.fault().code, code) << text.fault().sentence;
      EXPECT_EQ(text.fault().index, index);
      EXPECT_EQ(text.fault().quantity, quantity);
    }
  };
  const auto with = [](std::size_t i, const MissionWaypoint& waypoint) {
    Mission mission = sample();
    mission.waypoints[i] = waypoint;
    return mission;
  };
  refuse(with(1, {91, 0, 0, {}}), FaultCode::outside_domain, 1, "latitude");
  refuse(with(2, {0, -200, 0, {}}), FaultCode::outside_domain, 2, "longitude");
  refuse(with(3, {0, 0, 2e5, {}}), FaultCode::outside_domain, 3, "altitude");
  refuse(with(0, {0, 0, nan, {}}), FaultCode::not_finite, 0, "height");
  refuse(with(0, {0, 0, 1, -2.0}), FaultCode::outside_domain, 0, "speed");
  refuse(with(3, {0, 0, 1, nan}), FaultCode::not_finite, 3, "speed");
  Mission mission = sample();
  mission.acceptance_radius = -1.0;
  refuse(mission, FaultCode::outside_domain, std::nullopt, "acceptance_radius");
  mission = sample();
  mission.waypoints.clear();
  refuse(mission, FaultCode::too_few, std::nullopt, "waypoints");
  mission.waypoints.assign(most_waypoints + 1, {1, 2, 3, {}});
  refuse(mission, FaultCode::unsupported, std::nullopt, "waypoints");
  mission = sample();
  mission.home.latitude = 100;
  refuse(mission, FaultCode::outside_domain, std::nullopt, "latitude");
}

TEST(Mission, FollowsAPathWithinItsChordTolerance) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  Random random("missions along paths");
  const auto follow = [&](const auto& path, double tolerance) {
    constexpr double altitude = 30.0;
    const auto waypoints = waypoints_along(path, tolerance, altitude);
    ASSERT_TRUE(waypoints) << waypoints.fault().sentence;
    const auto planned = mission(*waypoints, zurich);
    ASSERT_TRUE(planned) << planned.fault().sentence;
    const auto text = to_qgroundcontrol_plan(*planned);
    ASSERT_TRUE(text);
    // The polyline as it is read back from the file, in local metres.
    const Json plan = Json::parse(*text);
    const auto plane = LocalTangentPlane::create(zurich);
    const Json& items = plan["mission"]["items"];
    std::vector<Vector3<double>> polyline;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const Json& params = items[i]["params"];
      const auto point = plane->to_local({params[4].get<double>(), params[5].get<double>(),
                                          zurich.altitude + params[6].get<double>()});
      ASSERT_TRUE(point);
      EXPECT_LE(distance(*point, (*waypoints)[i].position), 2.0 * conversion_error);
      polyline.push_back(*point);
    }
    constexpr int samples = 2000;
    for (int i = 0; i <= samples; ++i) {
      const auto p = path.position(path.clamped(
          path.xi_begin() + (path.xi_end() - path.xi_begin()) * (i / double{samples})));
      Vector3<double> at{p.x, p.y, altitude};
      if constexpr (std::remove_cvref_t<decltype(p)>::dimension == 3) at.z += p.z;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t k = 0; k + 1 < polyline.size(); ++k) {
        const Vector3<double> leg = polyline[k + 1] - polyline[k], from = at - polyline[k];
        const double t = std::clamp(dot(from, leg) / dot(leg, leg), 0.0, 1.0);
        least = std::min(least, norm(from - t * leg));
      }
      EXPECT_LE(least, tolerance + 2.0 * conversion_error);
    }
  };
  for (const double tolerance : {1.0, 0.01}) {
    follow(test::random_path<PlanarPath<2>>(random, 4), tolerance);
    follow(test::random_path<SpatialPath<2>>(random, 3), tolerance);
  }
}

TEST(Mission, NamesTheWaypointThatHasNoPlace) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  const auto refuse = [](const LocalWaypoint& waypoint, FaultCode code) {
    const LocalWaypoint waypoints[] = {{{1, 2, 3}, 4.0}, waypoint};
    const auto result = mission(waypoints, zurich);
    ASSERT_FALSE(result);
    EXPECT_EQ(result.fault().code, code) << result.fault().sentence;
    EXPECT_EQ(result.fault().index, 1U);
    EXPECT_NE(result.fault().sentence.find("waypoint 1"), std::string::npos);
  };
  refuse({{3e5, 0, 0}, {}}, FaultCode::outside_domain);
  refuse({{nan, 0, 0}, {}}, FaultCode::not_finite);
  refuse({{1, 0, 0}, 0.0}, FaultCode::outside_domain);
  EXPECT_EQ(mission({}, zurich).fault().code, FaultCode::too_few);
}

}  // namespace
}  // namespace hodograph
