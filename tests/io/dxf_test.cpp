// SPDX-License-Identifier: MIT
// DXF drawings, read back by a reader of their groups and evaluated by de Boor's algorithm.
#include "hodograph/io/dxf.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <sstream>

#include "hodograph/surface/offset.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;

struct Group {
  int code;
  std::string value;
};

std::vector<Group> groups_of(const std::string& text) {
  std::vector<Group> groups;
  std::istringstream lines(text);
  std::string code, value;
  while (std::getline(lines, code)) {
    EXPECT_TRUE(static_cast<bool>(std::getline(lines, value))) << "a code without a value";
    EXPECT_LE(code.find_first_not_of(" 0123456789"), std::string::npos);
    groups.push_back({std::stoi(code), value});
  }
  return groups;
}

/// A rational B-spline as a drawing has it.
struct ReadSpline {
  std::string layer;
  int flags = 0;
  std::size_t degree = 0, knot_count = 0, point_count = 0;
  std::vector<double> knots, weights, x, y, z;

  /// de Boor's algorithm on homogeneous coordinates, in long double.
  Vector2<double> position(double t) const {
    struct Point {
      long double x, y, w;
    };
    std::size_t k = degree;
    while (k + 1 < point_count && knots[k + 1] <= t) ++k;
    std::vector<Point> d(degree + 1);
    for (std::size_t j = 0; j <= degree; ++j) {
      const std::size_t i = k - degree + j;
      const long double w = weights[i];
      d[j] = {w * x[i], w * y[i], w};
    }
    for (std::size_t r = 1; r <= degree; ++r) {
      for (std::size_t j = degree; j >= r; --j) {
        const std::size_t i = k - degree + j;
        const long double low = knots[i], high = knots[i + 1 + degree - r];
        const long double a = (t - low) / (high - low);
        d[j] = {(1 - a) * d[j - 1].x + a * d[j].x, (1 - a) * d[j - 1].y + a * d[j].y,
                (1 - a) * d[j - 1].w + a * d[j].w};
      }
    }
    return {static_cast<double>(d[degree].x / d[degree].w),
            static_cast<double>(d[degree].y / d[degree].w)};
  }
};

std::vector<ReadSpline> splines_of(const std::vector<Group>& groups) {
  std::vector<ReadSpline> splines;
  bool inside = false;
  for (const auto& [code, value] : groups) {
    if (code == 0) {
      inside = value == "SPLINE";
      if (inside) splines.emplace_back();
      continue;
    }
    if (!inside) continue;
    ReadSpline& one = splines.back();
    switch (code) {
      case 8:
        one.layer = value;
        break;
      case 70:
        one.flags = std::stoi(value);
        break;
      case 71:
        one.degree = std::stoul(value);
        break;
      case 72:
        one.knot_count = std::stoul(value);
        break;
      case 73:
        one.point_count = std::stoul(value);
        break;
      case 40:
        one.knots.push_back(std::stod(value));
        break;
      case 41:
        one.weights.push_back(std::stod(value));
        break;
      case 10:
        one.x.push_back(std::stod(value));
        break;
      case 20:
        one.y.push_back(std::stod(value));
        break;
      case 30:
        one.z.push_back(std::stod(value));
        break;
      default:
        break;
    }
  }
  return splines;
}

void expect_well_formed(const ReadSpline& spline) {
  EXPECT_EQ(spline.flags, 4 + 8);  // rational, planar
  const std::size_t m = spline.degree;
  ASSERT_EQ(spline.knots.size(), spline.knot_count);
  ASSERT_EQ(spline.knot_count, spline.point_count + m + 1);
  ASSERT_EQ(spline.weights.size(), spline.point_count);
  ASSERT_EQ(spline.x.size(), spline.point_count);
  ASSERT_EQ(spline.y.size(), spline.point_count);
  EXPECT_EQ(spline.z, std::vector<double>(spline.point_count, 0.0));
  std::map<double, std::size_t> multiplicity;
  for (std::size_t i = 0; i < spline.knot_count; ++i) {
    if (i > 0) {
      EXPECT_LE(spline.knots[i - 1], spline.knots[i]);
    }
    ++multiplicity[spline.knots[i]];
  }
  for (const auto& [knot, count] : multiplicity) {
    const bool end = knot == spline.knots.front() || knot == spline.knots.back();
    EXPECT_EQ(count, end ? m + 1 : m);
  }
  for (const double w : spline.weights) {
    EXPECT_GT(w, 0.0);
    EXPECT_LT(w, 2.0);
  }
}

template <std::size_t n>
DxfCurves offset_curves(const PlanarPath<n>& path, double distance) {
  DxfCurves curves;
  curves.layer = "offset " + to_text(distance);
  for (const auto& piece : rational_offset(path, distance).value()) {
    curves.pieces.push_back(rational_bezier(piece));
  }
  return curves;
}

/// A straight piece over [begin, begin + 1].
RationalBezier line(double begin, Vector2<double> from, Vector2<double> to, double weight = 1.0) {
  return {begin, begin + 1.0, {from, to}, {weight, weight}};
}

TEST(Dxf, EvaluatesToTheOffset) {
  Random random("dxf: offsets");
  for (int round = 0; round < 20; ++round) {
    const auto path = test::random_path<PlanarPath<2>>(random, 5, 1);
    const std::vector<DxfCurves> layers = {offset_curves(path, 0.25), offset_curves(path, -1.5)};
    const auto splines = splines_of(groups_of(to_dxf(layers).value()));
    ASSERT_EQ(splines.size(), 2u);  // the tangent is continuous: one object each
    for (std::size_t i = 0; i < 2; ++i) {
      const ReadSpline& spline = splines[i];
      expect_well_formed(spline);
      EXPECT_EQ(spline.degree, 9u);
      EXPECT_EQ(spline.layer, layers[i].layer);
      EXPECT_EQ(spline.knots.front(), path.xi_begin());
      EXPECT_EQ(spline.knots.back(), path.xi_end());
      const double distance = i == 0 ? 0.25 : -1.5;
      for (int sample = 0; sample < 40; ++sample) {
        const double xi = random.uniform(path.xi_begin(), path.xi_end());
        // A control point carries some twenty roundings, amplified where the speed is small.
        EXPECT_CLOSE(spline.position(xi), offset_position(path, xi, distance), 4096,
                     1.0 + std::abs(distance) + path.arc_length());
      }
    }
  }
}

TEST(Dxf, JoinsAcrossAJumpOfTheSpeed) {
  // The same line, with weights 4 after 1: the second piece is brought to the first one's.
  const std::vector<DxfCurves> curves = {
      {"", 7, {line(0, {0, 0}, {1, 0}, 1.0), line(1, {1, 0}, {1, 1}, 4.0)}}};
  const auto splines = splines_of(groups_of(to_dxf(curves).value()));
  ASSERT_EQ(splines.size(), 1u);
  expect_well_formed(splines[0]);
  EXPECT_EQ(splines[0].layer, "0");
  EXPECT_EQ(splines[0].weights, (std::vector<double>{1, 1, 1}));
  EXPECT_EQ(splines[0].position(1.5), (Vector2<double>{1.0, 0.5}));
}

TEST(Dxf, BeginsAnewWherePiecesDoNotMeet) {
  constexpr double visible_gap = 0x1p-20;  // of coordinates near 1: no rounding
  constexpr double far_weight = 0x1p-40;   // beyond what neighbours are scaled by
  const RationalBezier first = line(0, {0, 0}, {1, 0});
  const RationalBezier arc{1.0, 2.0, {{1, 0}, {1, 1}, {0, 1}}, {1, std::sqrt(0.5), 1}};
  const RationalBezier elsewhere = line(1, {1, visible_gap}, {2, 0});
  const RationalBezier later = line(1.5, {1, 0}, {2, 0});
  const RationalBezier heavy = line(1, {1, 0}, {2, 0}, far_weight);
  for (const RationalBezier& next : {arc, elsewhere, later, heavy}) {
    const std::vector<DxfCurves> curves = {{"cut", 1, {first, next}}};
    const auto splines = splines_of(groups_of(to_dxf(curves).value()));
    ASSERT_EQ(splines.size(), 2u);
    for (const ReadSpline& spline : splines) expect_well_formed(spline);
  }
  const std::vector<DxfCurves> quarter = {{"arc", 1, {arc}}};
  const auto circle = splines_of(groups_of(to_dxf(quarter).value()));
  for (const double t : {1.0, 1.25, 1.5, 1.75, 2.0}) {
    const Vector2<double> p = circle.at(0).position(std::min(t, std::nextafter(2.0, 0.0)));
    EXPECT_CLOSE(std::hypot(p.x, p.y), 1.0, 8, 1.0);
  }
}

TEST(Dxf, HasEveryPartThatTheFormatAsksFor) {
  const std::vector<DxfCurves> curves = {
      {"a", 1, {line(0, {-3, 2}, {1, 5})}}, {"b<:>", 300, {}}, {"a", 2, {line(0, {0, 0}, {1, 0})}}};
  const std::string text = to_dxf(curves, dxf_unit("mm")).value();
  const auto groups = groups_of(text);
  std::vector<std::string> sections, tables, blocks, layers;
  std::map<std::string, std::vector<std::string>> header;
  std::set<std::string> handles, owners;
  std::string type, variable;
  int depth = 0;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const auto& [code, value] = groups[i];
    if (code == 0) type = value;
    if (code == 0 && (value == "SECTION" || value == "TABLE")) ++depth;
    if (code == 0 && (value == "ENDSEC" || value == "ENDTAB")) --depth;
    if (code == 2 && type == "SECTION") sections.push_back(value);
    if (code == 2 && type == "TABLE") tables.push_back(value);
    if (code == 2 && type == "BLOCK") blocks.push_back(value);
    if (code == 2 && type == "LAYER") layers.push_back(value);
    if (code == 9) variable = value;
    if (sections.size() == 1 && code != 9) header[variable].push_back(value);
    if (sections.size() > 1 && (code == 5 || code == 105)) {
      EXPECT_TRUE(handles.insert(value).second) << "the handle " << value << " is given twice";
    }
    if (code == 330 && value != "0") owners.insert(value);
  }
  EXPECT_EQ(depth, 0);
  EXPECT_EQ(groups.back().value, "EOF");
  EXPECT_EQ(sections, (std::vector<std::string>{"HEADER", "CLASSES", "TABLES", "BLOCKS", "ENTITIES",
                                                "OBJECTS"}));
  EXPECT_EQ(std::set<std::string>(tables.begin(), tables.end()),
            (std::set<std::string>{"VPORT", "LTYPE", "LAYER", "STYLE", "VIEW", "UCS", "APPID",
                                   "DIMSTYLE", "BLOCK_RECORD"}));
  EXPECT_EQ(blocks, (std::vector<std::string>{"*Model_Space", "*Paper_Space"}));
  EXPECT_EQ(layers, (std::vector<std::string>{"0", "a", "b___"}));
  EXPECT_EQ(header["$ACADVER"].front(), "AC1015");
  EXPECT_EQ(header["$INSUNITS"].front(), "4");
  EXPECT_EQ(header["$EXTMIN"], (std::vector<std::string>{"-3", "0", "0"}));
  EXPECT_EQ(header["$EXTMAX"], (std::vector<std::string>{"1", "5", "0"}));
  const auto number = [](const std::string& handle) { return std::stoul(handle, nullptr, 16); };
  for (const std::string& handle : handles) {
    EXPECT_LT(number(handle), number(header["$HANDSEED"].front()));
  }
  for (const std::string& owner : owners) EXPECT_TRUE(handles.count(owner)) << owner;
  for (const auto& spline : splines_of(groups)) EXPECT_EQ(spline.layer, "a");

  const auto empty = groups_of(to_dxf({}).value());
  EXPECT_TRUE(splines_of(empty).empty());
  EXPECT_EQ(dxf_unit("parsec"), DxfUnit::none);
}

TEST(Dxf, RefusesWhatIsNoCurve) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const RationalBezier good = line(0, {0, 0}, {1, 0});
  const auto refused = [&](const RationalBezier& bad, FaultCode code) {
    const std::vector<DxfCurves> curves = {{"", 7, {good}}, {"", 7, {bad}}};
    const auto text = to_dxf(curves);
    ASSERT_FALSE(text);
    EXPECT_EQ(text.fault().code, code);
    EXPECT_EQ(text.fault().index, 1u);
  };
  RationalBezier bad = good;
  bad.weights.pop_back();
  refused(bad, FaultCode::mismatched_size);
  refused({0.0, 1.0, {{0, 0}}, {1}}, FaultCode::mismatched_size);
  refused({0.0, 1.0, {}, {}}, FaultCode::mismatched_size);
  bad = good;
  bad.weights[1] = 0.0;
  refused(bad, FaultCode::outside_domain);
  bad.weights[1] = infinity;
  refused(bad, FaultCode::not_finite);
  bad = good;
  bad.control_points[0].y = -infinity;
  refused(bad, FaultCode::not_finite);
  bad = good;
  bad.end = bad.begin;
  refused(bad, FaultCode::outside_domain);
  bad.end = infinity;
  refused(bad, FaultCode::not_finite);
}

}  // namespace
}  // namespace hodograph
