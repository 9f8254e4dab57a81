// SPDX-License-Identifier: MIT
// Paths in a world as GeoJSON: what is written reads back as the same world.
#ifdef HODOGRAPH_HAS_PLANNING
#include "hodograph/io/geojson_scene.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>

#include "hodograph/io/geojson.hpp"

namespace hodograph {
namespace {

using Json = nlohmann::json;
constexpr GeodeticPoint datum{47.3976, 8.5456, 488.0};

GeoJsonScene sample() {
  GeoJsonScene scene;
  scene.world =
      World::create({{{{0, 0}, {0, 4.1}, {4, 4}, {4, 0}}, {{{1, 1}, {2, 1}, {1, 2}}}, "y\"d"},
                     {{{9, 9}, {10, 9}, {0.0625, 1e3}}, {}, ""}},
                    Ring{{-50, -50}, {50, -50}, {50, 2e3}, {-50, 2e3}})
          .value();
  scene.start = Vector2<double>{-1, -2};
  scene.goal = Vector2<double>{20, 1.0 / 3.0};
  GeoJsonPath path;
  path.name = "way";
  path.kind = "G2 corners";
  path.points = {{-1, -2, 0}, {5, -3, 0}, {20, 1.0 / 3.0, 0}};
  path.chord_tolerance = 0.25;
  path.promises.arc_length = Enclosure(21, 22);
  path.promises.curvature_bound = 0.5;
  path.promises.largest_curvature = Enclosure(0.25, 0.375);
  path.promises.clearance =
      ClearancePromise{"", 7.0, {{0, Enclosure(2, 2.5)}, {1, Enclosure(1, 3)}}, {}};
  scene.paths = {path};
  return scene;
}

TEST(GeoJsonScene, ReadsBackAsTheSameWorld) {
  const GeoJsonScene scene = sample();
  const auto text = to_geojson(scene);
  ASSERT_TRUE(text) << text.fault().sentence;
  const auto read = parse_world(*text);
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_EQ(read->world.obstacles(), scene.world.obstacles());
  EXPECT_EQ(read->world.bounds(), scene.world.bounds());
  EXPECT_TRUE(read->world.repairs().empty());
  EXPECT_EQ(read->start, scene.start);
  EXPECT_EQ(read->goal, scene.goal);
}

TEST(GeoJsonScene, TellsWhatAPathPromises) {
  const Json json = Json::parse(to_geojson(sample()).value());
  EXPECT_EQ(json["coordinates"], "local");
  const Json& line = json["features"].back();
  EXPECT_EQ(line["geometry"]["type"], "LineString");
  EXPECT_EQ(line["geometry"]["coordinates"],
            Json::parse("[[-1,-2],[5,-3],[20,0.3333333333333333]]"));
  EXPECT_EQ(line["properties"], Json::parse(R"({"role": "ignored", "name": "way",
    "kind": "G2 corners", "chord_tolerance": 0.25, "arc_length": [21, 22], "curvature_bound": 0.5,
    "largest_curvature": [0.25, 0.375], "clearance": [1, 3], "reach": 7})"));
}

TEST(GeoJsonScene, StandsOnTheEarthWithADatum) {
  ASSERT_TRUE(has_geodesy()) << "the tests need GeographicLib (libgeographiclib-dev)";
  GeoJsonScene scene = sample();
  scene.datum = datum;
  scene.altitude = 25.0;
  scene.paths.push_back(scene.paths[0]);
  scene.paths[1].spatial = true;
  scene.paths[1].points[1].z = 60.0;
  const Json json = Json::parse(to_geojson(scene).value());
  EXPECT_EQ(json["datum"]["latitude"], datum.latitude);
  const auto plane = LocalTangentPlane::create(datum);
  constexpr double accuracy = 1e-8;  // not a tolerance: what to_local states
  const auto expect = [&](const Json& position, const Vector3<double>& local) {
    const auto found = plane->to_local({position[1], position[0], position[2]});
    ASSERT_TRUE(found);
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR((*found)[j], local[j], 2 * accuracy);
  };
  const Json& features = json["features"];
  const Json& planar = features[features.size() - 2]["geometry"]["coordinates"];
  const Json& spatial = features.back()["geometry"]["coordinates"];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<double>& p = scene.paths[0].points[i];
    expect(planar[i], {p.x, p.y, 25.0});
    expect(spatial[i], scene.paths[1].points[i]);
  }
  EXPECT_EQ(features[0]["geometry"]["coordinates"][0][0].size(), 2U);  // places have no height
}

TEST(GeoJsonScene, RefusesLinesThatAreNone) {
  GeoJsonScene scene = sample();
  scene.paths[0].points.resize(1);
  EXPECT_EQ(to_geojson(scene).fault().code, FaultCode::too_few);
  EXPECT_EQ(to_geojson(scene).fault().index, 0U);
  scene = sample();
  scene.paths[0].points[1].x = std::numeric_limits<double>::infinity();
  EXPECT_EQ(to_geojson(scene).fault().code, FaultCode::not_finite);
  scene = sample();
  scene.datum = GeodeticPoint{99, 0, 0};
  EXPECT_EQ(to_geojson(scene).fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
#endif  // HODOGRAPH_HAS_PLANNING
