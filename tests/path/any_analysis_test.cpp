// SPDX-License-Identifier: MIT
// Analyses of paths whose degree is known when the program runs: those of the functions for known
// types, and the same, within rounding, in every degree.
#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/frame/any_continuity.hpp"
#include "hodograph/path/any_bounds.hpp"
#include "hodograph/path/any_nearest.hpp"
#include "hodograph/path/any_operations.hpp"
#include "hodograph/path/any_planar.hpp"
#include "hodograph/path/any_sampling.hpp"
#include "hodograph/path/bounds.hpp"

namespace hodograph {
namespace {

/// Far below what a wrong degree would change, far above rounding.
constexpr double relative_width = 0x1p-20;
constexpr RangeGoal goal{relative_width};
/// Elevation moves coefficients by a few ε, and conditions of the answers enlarge that.
constexpr double agreement = 0x1p-30;

PlanarPath<2> wave() {
  const std::vector<Vector2<double>> points{{0, 0}, {1, 2}, {3, 1}, {4, 4}, {7, 3}};
  return planar_spline(points).value().path;
}
SpatialPath<3> loop() { return closed_loop({0.3, 1.0}).value(); }

TEST(AnyAnalysis, BoundsAreThoseOfTheStaticType) {
  EXPECT_EQ(curvature_extremes(AnyPath(wave()), goal), curvature_extremes(wave(), goal));
  EXPECT_EQ(speed_extremes(AnyPath(loop()), goal), speed_extremes(loop(), goal));
  EXPECT_EQ(bounding_box(AnyPath(loop()), goal).size(), 3U);
  EXPECT_EQ(continuity(AnyPath(loop())).position.order(), continuity(loop()).position.order());
}

TEST(AnyAnalysis, EveryDegreeOfAPlanarPathHasTheSameAnswers) {
  const AnyPath path = wave();
  const double energy = bending_energy(path).value(), turn = rotation_index(path);
  const std::array q{2.0, 3.0};
  const double distance = nearest_point(path, q).value().distance.middle();
  const auto box = bounding_box(path, goal);
  for (std::size_t n = 2; n <= maximum_dynamic_degree; ++n) {
    const AnyPath same = with_preimage_degree(path, n).value();
    EXPECT_NEAR(bending_energy(same).value(), energy, agreement * energy) << n;
    EXPECT_NEAR(rotation_index(same), turn, agreement) << n;
    EXPECT_EQ(inflections(same).size(), inflections(path).size()) << n;
    EXPECT_NEAR(nearest_point(same, q).value().distance.middle(), distance, agreement) << n;
    EXPECT_NEAR(bounding_box(same, goal)[0].maximum.middle(), box[0].maximum.middle(),
                2.0 * goal.relative_width * box[0].maximum.magnitude())
        << n;
    EXPECT_EQ(curvature_stays_within(same, 100.0), Answer::yes) << n;
  }
}

TEST(AnyAnalysis, EveryDegreeOfAPathInSpaceHasTheSameAnswers) {
  const AnyPath path = loop();
  const Enclosure energy = bending_energy_enclosure(path).value();
  const double radius = largest_tube_radius(path, goal).radius.middle();
  for (std::size_t n = 3; n <= maximum_dynamic_degree; ++n) {
    const AnyPath same = with_preimage_degree(path, n).value();
    EXPECT_NEAR(largest_tube_radius(same, goal).radius.middle(), radius,
                2.0 * goal.relative_width * radius)
        << n;
    constexpr std::size_t most = 8;
    if (n > most) {
      EXPECT_EQ(torsion_extremes(same, goal).fault().code, FaultCode::unsupported) << n;
      EXPECT_EQ(bending_energy(same).fault().code, FaultCode::unsupported) << n;
    } else {
      EXPECT_NEAR(bending_energy(same).value(), energy.middle(), agreement * energy.middle()) << n;
    }
  }
}

TEST(AnyAnalysis, RefusesTheOtherDimension) {
  const AnyPath plane = wave(), space = loop();
  const std::array three{0.0, 0.0, 0.0};
  EXPECT_EQ(torsion_extremes(plane, goal).fault().code, FaultCode::unsupported);
  EXPECT_EQ(nearest_point(plane, three).fault().code, FaultCode::mismatched_size);
  EXPECT_EQ(holonomy(plane).fault().code, FaultCode::unsupported);
  EXPECT_EQ(line_intersections(space, {0, 0}, {1, 0}).fault().code, FaultCode::unsupported);
  EXPECT_EQ(jumps_at_knot(plane, 9).fault().code, FaultCode::outside_domain);
  EXPECT_THROW(inflections(space), Error);
  EXPECT_THROW(intersections(plane, space), Error);
  EXPECT_THROW(signed_area(space), Error);
}

TEST(AnyAnalysis, ParametersAreThoseOfTheStaticType) {
  EXPECT_EQ(parameters_even_in_arc_length(AnyPath(wave()), 20).value(),
            parameters_even_in_arc_length(wave(), 20).value());
  EXPECT_EQ(polyline_parameters(AnyPath(wave()), 0.01).value(),
            polyline_parameters(wave(), 0.01).value());
}

}  // namespace
}  // namespace hodograph
