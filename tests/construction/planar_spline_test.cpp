// SPDX-License-Identifier: MIT
#include "hodograph/construction/planar_spline.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include "hodograph/path/continuity.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_golden.hpp"
#include "tests/support/planar_points.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::agrees;
using test::complex_of;
using test::Json;
using test::Points;
using test::Random;

PlanarSpline spline(const Points& points, const PlanarSplineOptions& options = {}) {
  return planar_spline(points, options).value();
}
PlanarSplineOptions with_energy(bool closed) {
  PlanarSplineOptions options;
  options.closed = closed;
  options.with_energy = true;
  return options;
}
PlanarSplineOptions closed_options() {
  PlanarSplineOptions options;
  options.closed = true;
  return options;
}

/// The curve goes through the points, is C², its preimage C¹, and the closure sign is what the
/// path's preimage does.
void expect_c2_through(const PlanarSpline& made, const Points& points) {
  const auto& path = made.path;
  ASSERT_EQ(path.segment_count(), path.is_closed() ? points.size() : points.size() - 1);
  for (std::size_t i = 0; i < path.segment_count(); ++i) {
    EXPECT_EQ(path.segment(i).start(), points[i]);
  }
  const auto found = continuity(path);
  EXPECT_GE(found.position.order(), 2);
  EXPECT_GE(found.preimage.order(), 1);
  EXPECT_EQ(found.antiperiodic, made.report.closure_sign == -1);
}

void expect_golden(const Json& set, const Points& points, const Json& z, std::size_t wrong_by) {
  const double tolerance = set["rel_tol"].number();
  const bool closed = set["closed"].number() != 0.0;
  const auto made = spline(points, with_energy(closed));
  expect_c2_through(made, points);
  EXPECT_EQ(made.report.closure_sign, static_cast<int>(set["closure_sign"].number()));
  EXPECT_TRUE(agrees(made.path.arc_length(), set["length"].number(), tolerance));
  EXPECT_TRUE(agrees(made.report.energy.value(), set["energy"].number(), tolerance))
      << *made.report.energy << " " << set["energy"].number();
  EXPECT_LE(made.report.newton_steps,
            static_cast<std::size_t>(set["newton_steps"].number()) + wrong_by);
  // z up to a common sign; the preimage itself may be off by the error of the data over |z|.
  const auto first = made.path.segment(0).preimage()[1];
  const double sign = dot(first, complex_of(z[0])) < 0.0 ? -1.0 : 1.0;
  for (std::size_t i = 0; i < z.size(); ++i) {
    const auto difference = sign * made.path.segment(i).preimage()[1] - complex_of(z[i]);
    EXPECT_LE(largest_component(difference), tolerance) << i;
  }
}

TEST(PlanarSpline, MeetsTheReferenceValues) {
  const Json golden = test::golden_file("planar_spline.json");
  for (const Json& set : golden["spline"].list()) {
    SCOPED_TRACE(set["name"].string());
    Points points;
    for (const Json& q : set["nodes"].list()) points.push_back(test::vector2_of(q));
    if (set["closed"].number() != 0.0) points.pop_back();  // may be given or not
    expect_golden(set, points, set["z"], 1);
  }
}

Points generated(const std::string& name, std::size_t count) {
  constexpr double pi = std::numbers::pi;
  const double n = static_cast<double>(count);
  const bool closed = name != "sine" && name != "spiral";
  Points points;
  for (std::size_t i = 0; i < (closed ? count : count + 1); ++i) {
    const double k = static_cast<double>(i), t = 2 * pi * k / n;
    if (name == "ellipse") points.push_back({3 * std::cos(t), std::sin(t)});
    if (name == "figure eight") {
      points.push_back({std::sin(2 * pi * (k + 0.5) / n), std::sin(4 * pi * (k + 0.5) / n)});
    }
    if (name == "flower") {
      const double r = 2 + std::cos(10 * pi * k / n);
      points.push_back({r * std::cos(t), r * std::sin(t)});
    }
    if (name == "sine") points.push_back({6 * k / n, std::sin(6 * k / n)});
    if (name == "spiral") {
      const double r = 0.1 + k / n, angle = 12 * k / n;
      points.push_back({r * std::cos(angle), r * std::sin(angle)});
    }
  }
  return points;
}

TEST(PlanarSpline, MeetsTheReferenceValuesOfManyPoints) {
  const Json golden = test::golden_file("planar_spline.json");
  for (const Json& set : golden["spline_large"].list()) {
    const auto count = static_cast<std::size_t>(set["N"].number());
    SCOPED_TRACE(set["name"].string() + " " + std::to_string(count));
    expect_golden(set, generated(set["name"].string(), count), set["z_first"], 2);
  }
}

TEST(PlanarSpline, ReportsTheSameEnergyWithoutThePath) {
  const Points points = generated("flower", 50);
  const auto numbers = planar_spline_preimage(points, with_energy(true)).value();
  const double digits = 1e-8;  // as the report's comment says
  EXPECT_NEAR(*numbers.report.energy, *spline(points, with_energy(true)).report.energy,
              digits * *numbers.report.energy);
}

TEST(PlanarSpline, OneSpanIsALine) {
  const auto made = spline({{1, 2}, {4, 6}});
  EXPECT_EQ(made.path.arc_length(), 5.0);
  EXPECT_EQ(made.path.segment(0).preimage()[0], made.path.segment(0).preimage()[2]);
}

TEST(PlanarSpline, TakesUpTheClosingPointOrNot) {
  const Points open = generated("flower", 40);
  Points repeated = open;
  repeated.push_back(open.front());
  EXPECT_EQ(spline(open, closed_options()).path, spline(repeated, closed_options()).path);
}

TEST(PlanarSpline, ClosesFewPoints) {
  for (const Points& points : {Points{{0, 0}, {1, 0}}, Points{{0, 0}, {1, 0}, {0.2, 0.7}},
                               Points{{0, 0}, {1, 0}, {2, 0}}}) {
    for (const auto parameters : {SplineParameters::uniform, SplineParameters::chord_length}) {
      PlanarSplineOptions options = closed_options();
      options.parameters = parameters;
      expect_c2_through(spline(points, options), points);
    }
  }
}

TEST(PlanarSpline, ChoosesTheClosureSignByTheTurningNumber) {
  // A k-fold circle: an odd number of turns changes the sign of the preimage.
  for (int turns = 1; turns <= 4; ++turns) {
    Points points;
    for (int i = 0; i < 40; ++i) {
      const double t = 2 * std::numbers::pi * turns * (i + 0.5) / 40;
      points.push_back({(2 + std::cos(t / turns)) * std::cos(t), 2 * std::sin(t)});
    }
    const auto made = spline(points, closed_options());
    EXPECT_EQ(made.report.closure_sign, turns % 2 == 1 ? -1 : 1);
    expect_c2_through(made, points);
  }
}

TEST(PlanarSpline, ScalesExactlyWithPowersOfFour) {
  Random random("planar spline scaling");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const Points points = test::random_walk(random, 12, 1.0);
    for (const auto parameters : {SplineParameters::uniform, SplineParameters::chord_length}) {
      PlanarSplineOptions options;
      options.parameters = parameters;
      const auto made = spline(points, options);
      for (const int exponent : {-249, -30, 7, 249}) {  // 4^249 is 1e150
        Points scaled = points;
        const double factor = std::ldexp(1.0, 2 * exponent);
        for (auto& q : scaled) q = factor * q;
        const auto other = spline(scaled, options);
        EXPECT_EQ(other.report.newton_steps, made.report.newton_steps);
        EXPECT_EQ(other.path.arc_length(), factor * made.path.arc_length());
      }
    }
  }
}

TEST(PlanarSpline, TurnsAndReversesWithThePoints) {
  Random random("planar spline symmetry");
  for (int repeat = 0; repeat < 50; ++repeat) {
    const bool closed = repeat % 2 == 1;
    const Points points = test::random_walk(random, 15, 0.6);
    const auto made = spline(points, with_energy(closed));
    if (made.report.alternatives_tried > 0) continue;  // not the only solution
    const double length = made.path.arc_length();
    // A rotation by 90° is exact in the data, not in the square roots; a reversal changes the order
    // of every sum. Rounding of each span's length, a few ε, times a condition of about 10.
    Points turned, reversed(points.rbegin(), points.rend());
    for (const auto& q : points) turned.push_back({-q.y, q.x});
    EXPECT_CLOSE(spline(turned, with_energy(closed)).path.arc_length(), length, 200, length);
    EXPECT_CLOSE(spline(reversed, with_energy(closed)).path.arc_length(), length, 200, length);
  }
}

TEST(PlanarSpline, ChordLengthParametersAreC2OnUnevenPoints) {
  Random random("planar spline chord length");
  PlanarSplineOptions options;
  options.parameters = SplineParameters::chord_length;
  for (int repeat = 0; repeat < 200; ++repeat) {
    options.closed = repeat % 2 == 1;
    const Points points = test::random_walk(random, 3 + random.index(20), 0.7, 6.0);
    const auto made = spline(points, options);
    expect_c2_through(made, points);
    for (std::size_t i = 0; i < made.path.segment_count(); ++i) {
      const auto chord = points[(i + 1) % points.size()] - points[i];
      EXPECT_CLOSE(made.path.segment(i).parameter_step(), std::hypot(chord.x, chord.y), 1,
                   made.path.xi_end());
    }
  }
}

TEST(PlanarSpline, FollowsACircleToHighOrder) {
  // The error of C² PH quintic splines is O(h⁴) at least: 16 times as many points, 16⁴ = 65536.
  const auto error = [](std::size_t count) {
    Points points;
    for (std::size_t i = 0; i < count; ++i) {
      const double t = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
      points.push_back({std::cos(t), std::sin(t)});
    }
    const auto made = spline(points, closed_options());
    return std::abs(made.path.arc_length() - 2 * std::numbers::pi);
  };
  EXPECT_LT(error(128), error(8) / 10000);
}

TEST(PlanarSpline, LongRunsOfEqualStepsOnALineStayStraight) {
  Points points;
  for (int i = 0; i < 100; ++i) points.push_back({static_cast<double>(i), 0.0});
  const auto made = spline(points);
  EXPECT_EQ(made.path.arc_length(), 99.0);
  expect_c2_through(made, points);
}

TEST(PlanarSpline, RefusesWhatItCannotUse) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto fault = [](const Points& points, const PlanarSplineOptions& options = {}) {
    return planar_spline(points, options).fault();
  };
  EXPECT_EQ(fault({}).code, FaultCode::too_few);
  EXPECT_EQ(fault({{1, 1}}).code, FaultCode::too_few);
  EXPECT_EQ(fault({{1, 1}, {1, 1}}, closed_options()).code, FaultCode::too_few);
  const Fault finite = fault({{0, 0}, {1, 0}, {1, infinity}});
  EXPECT_EQ(finite.code, FaultCode::not_finite);
  EXPECT_EQ(finite.index, 2U);
  EXPECT_EQ(fault({{0, 0}, {NAN, 0}, {1, 1}}).index, 1U);
  const Fault repeated = fault({{0, 0}, {1, 0}, {2, 1}, {2, 1}, {3, 0}});
  EXPECT_EQ(repeated.code, FaultCode::outside_domain);
  EXPECT_EQ(repeated.index, 3U);
  EXPECT_NE(repeated.sentence.find("point 3"), std::string::npos);
  const double huge = std::numeric_limits<double>::max();
  const Fault far = fault({{0, 0}, {-huge, 0}, {huge, 0}});
  EXPECT_EQ(far.code, FaultCode::not_finite);
  EXPECT_EQ(far.index, 1U);
  PlanarSplineOptions chord;
  chord.parameters = SplineParameters::chord_length;
  const double tiny = 1e-20;  // not a tolerance: lost beside a chord of length 1
  const Fault lost = fault({{0, 0}, {1, 0}, {1, tiny}, {2, 1}}, chord);
  EXPECT_EQ(lost.code, FaultCode::outside_domain);
  EXPECT_EQ(lost.index, 2U);
  EXPECT_TRUE(planar_spline(Points{{0, 0}, {1, 0}, {1, tiny}, {2, 1}}).has_value());
}

TEST(PlanarSpline, MergesRepeatedPointsWhenAsked) {
  const Points points{{0, 0}, {1, 0}, {2, 1}, {1, 2}, {0, 1}};
  Points repeated{{0, 0}, {0, 0}, {1, 0}, {2, 1}, {2, 1}, {2, 1}, {1, 2}, {0, 1}, {0, 0}, {0, 0}};
  PlanarSplineOptions options = closed_options();
  options.repeated = RepeatedPoints::merge;
  const auto made = spline(repeated, options);
  EXPECT_EQ(made.path, spline(points, closed_options()).path);
  EXPECT_EQ(made.report.merged_points, 4U);  // and the closing point
  const auto numbers = planar_spline_preimage(repeated, options).value();
  EXPECT_EQ(numbers.kept, (std::vector<std::size_t>{0, 2, 3, 6, 7}));
}

TEST(PlanarSpline, TakesTheSolutionOfLessEnergy) {
  Random random("planar spline alternatives");
  PlanarSplineOptions first, all;
  first.with_energy = all.with_energy = true;
  first.most_alternatives = 0;
  std::size_t better = 0;
  for (int repeat = 0; repeat < 100; ++repeat) {
    first.closed = all.closed = repeat % 2 == 1;
    Points points;
    for (int i = 0; i < 12; ++i) points.push_back(random.vector2(1.0));
    const auto plain = spline(points, first), chosen = spline(points, all);
    expect_c2_through(chosen, points);
    EXPECT_EQ(plain.report.alternatives_tried, 0U);
    const double slack = 1e-5;  // ten times what the search counts as less
    EXPECT_LE(*chosen.report.energy, (1 + slack) * *plain.report.energy);
    if (chosen.report.alternatives_taken > 0) {
      EXPECT_LT(*chosen.report.energy, *plain.report.energy);
      EXPECT_GT(chosen.report.solutions_found, 1U);
      ++better;
    }
  }
  EXPECT_GT(better, 0U);
}

}  // namespace
}  // namespace hodograph
