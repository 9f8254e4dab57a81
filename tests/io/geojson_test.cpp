// SPDX-License-Identifier: MIT
// Worlds from GeoJSON: what is read, and one clear fault for everything else.
#ifdef HODOGRAPH_HAS_PLANNING
#include "hodograph/io/geojson.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/random.hpp"

namespace hodograph {
namespace {

const std::string square = "[[[0,0],[2,0],[2,2],[0,2],[0,0]]]";

std::string polygon_text(const std::string& coordinates) {
  return R"({"type":"Polygon","coordinates":)" + coordinates + "}";
}
std::string feature(const std::string& geometry, const std::string& properties,
                    const std::string& more = "") {
  return R"({"type":"Feature","geometry":)" + geometry + R"(,"properties":)" + properties + more +
         "}";
}
std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","features":[)" + features + "]}";
}

Fault fault_of(const std::string& text) {
  const auto result = parse_world(text);
  EXPECT_FALSE(result.has_value()) << text;
  return result.has_value() ? Fault{} : result.fault();
}

TEST(GeoJson, ReadsAWorldWithItsPlaces) {
  const auto read = parse_world(collection(
      feature(polygon_text("[[[0,0,9],[8,0,9],[8,8,9],[0,8,9]],[[1,1],[1,2],[2,2],[2,1],[1,1]]]"),
              R"({"name":"yard","other":[1]})") +
      "," +
      feature(R"({"type":"MultiPolygon","coordinates":[)" + square + "," + square + "]}", "null",
              R"(,"id":"twins")") +
      "," +
      feature(R"({"type":"GeometryCollection","geometries":[)" + polygon_text(square) + "]}", "{}",
              R"(,"id":7,"bbox":[0,0,1,1])") +
      "," + feature(polygon_text("[[[-9,-9],[9,-9],[9,9],[-9,9]]]"), R"({"role":"bounds"})") + "," +
      feature(R"({"type":"Point","coordinates":[3,4]})", R"({"role":"start"})") + "," +
      feature(R"({"type":"Point","coordinates":[5,6.5,1]})", R"({"role":"goal"})") + "," +
      feature(R"({"type":"LineString","coordinates":[]})", R"({"role":"ignored"})") + "," +
      feature("null", "{}")));
  ASSERT_TRUE(read) << read.fault().sentence;
  const auto& obstacles = read->world.obstacles();
  ASSERT_EQ(obstacles.size(), 4U);
  EXPECT_EQ(obstacles[0].name, "yard");
  EXPECT_EQ(obstacles[0].outer, (Ring{{0, 0}, {8, 0}, {8, 8}, {0, 8}}));
  EXPECT_EQ(obstacles[0].holes, (std::vector<Ring>{{{1, 1}, {1, 2}, {2, 2}, {2, 1}}}));
  EXPECT_EQ(obstacles[1].name, "twins");
  EXPECT_EQ(obstacles[2].outer, obstacles[1].outer);
  EXPECT_EQ(obstacles[3].name, "7");
  ASSERT_TRUE(read->world.bounds());
  EXPECT_EQ(read->world.bounds()->size(), 4U);
  EXPECT_EQ(read->start, (Vector2<double>{3, 4}));
  EXPECT_EQ(read->goal, (Vector2<double>{5, 6.5}));
  EXPECT_TRUE(read->world.repairs().empty());
}

TEST(GeoJson, ReadsABareGeometryAndEmptyOnes) {
  EXPECT_EQ(parse_world(polygon_text(square))->world.obstacles().size(), 1U);
  EXPECT_TRUE(parse_world(polygon_text("[]"))->world.obstacles().empty());
  EXPECT_TRUE(parse_world(collection(""))->world.obstacles().empty());
}

TEST(GeoJson, RefusesWithThePlace) {
  EXPECT_EQ(fault_of("{\"type\":\n \"Polygon\",]").sentence,
            "the world: broken JSON at line 2, column 12");
  EXPECT_EQ(fault_of("").sentence, "the world: broken JSON at line 1, column 1");
  EXPECT_EQ(fault_of(polygon_text("[[[0,0],[1e999,0],[2,2]]]")).sentence,
            "the world: it has a number beyond the range of double");
  EXPECT_EQ(fault_of("[]").sentence, "the world: a GeoJSON object is needed");
  EXPECT_EQ(fault_of("{}").sentence, "the world: the member \"type\" is missing");
  EXPECT_EQ(fault_of(R"({"type":"Polygon"})").sentence,
            "the world: the member \"coordinates\" is missing");
  EXPECT_EQ(fault_of(polygon_text("[[[0,0],[1],[2,2]]]")).sentence,
            "the world, at /coordinates/0/1: a position needs two numbers");
  EXPECT_EQ(fault_of(polygon_text("[[[0,0],[1,null],[2,2]]]")).quantity, "/coordinates/0/1");
  EXPECT_EQ(fault_of(collection(feature(polygon_text("[3]"), "{}"))).sentence,
            "the world, at /features/0/geometry/coordinates/0: an array of positions is needed");
  EXPECT_EQ(fault_of(collection(R"({"type":"Feature"})")).sentence,
            "the world, at /features/0: the member \"geometry\" is missing");
  const Fault line = fault_of(R"({"type":"Line\nString","coordinates":[]})");
  EXPECT_EQ(line.code, FaultCode::unsupported);
  EXPECT_EQ(
      line.sentence,
      "the world: 'Line\\x0aString' is no obstacle; obstacles are 'Polygon' or 'MultiPolygon'");
  EXPECT_EQ(fault_of(R"({"type":"Point","coordinates":[0,0]})").code, FaultCode::unsupported);
  EXPECT_EQ(fault_of(feature(polygon_text(square), R"({"role":"wall"})")).sentence,
            "the world, at /properties/role: 'wall' is unknown; a role is 'obstacle', 'bounds', "
            "'start', 'goal' or 'ignored'");
  const std::string bounds = feature(polygon_text(square), R"({"role":"bounds"})");
  EXPECT_EQ(fault_of(collection(bounds + "," + bounds)).sentence,
            "the world, at /features/1/geometry/coordinates: there are bounds already");
  EXPECT_EQ(
      fault_of(polygon_text("[[[0,0],[2,2],[2,0],[0,3],[0,0]]]")).sentence,
      "the world: obstacle 0, outer ring crosses itself between the edges from point 0 and from "
      "point 2 near (2, 0)");
}

TEST(GeoJson, SurvivesDepthAndDamage) {
  EXPECT_EQ(fault_of(std::string(300000, '[')).code, FaultCode::malformed_document);
  EXPECT_EQ(fault_of(polygon_text(std::string(300000, '[') + std::string(300000, ']'))).code,
            FaultCode::malformed_document);
  std::string nested = polygon_text(square);
  for (int i = 0; i < 2000; ++i) {
    nested = R"({"type":"GeometryCollection","geometries":[)" + nested + "]}";
  }
  EXPECT_EQ(fault_of(nested).code, FaultCode::malformed_document);
  test::Random random("damaged worlds");
  const std::string whole = collection(feature(polygon_text(square), R"({"role":"obstacle"})"));
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string text = whole;
    for (std::int64_t i = random.integer(1, 3); i > 0; --i) {
      text[random.index(text.size())] = static_cast<char>(random.integer(0, 255));
    }
    const auto result = parse_world(text);
    if (result) continue;
    ++refused;
    EXPECT_FALSE(result.fault().sentence.empty());
    EXPECT_EQ(result.fault().sentence.find('\n'), std::string::npos);
  }
  EXPECT_GT(refused, 1000);
}

}  // namespace
}  // namespace hodograph
#endif  // HODOGRAPH_HAS_PLANNING
