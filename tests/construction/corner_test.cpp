// SPDX-License-Identifier: MIT
// The G² corner and rounded polylines: golden values, placement, the four ways to choose the size,
// continuity, and refusals.
#include "hodograph/construction/corner.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/bounds.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_judge.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;

double curvature(const PlanarPhCurve<2>& curve, double u) {
  const auto jet = curve.preimage_jet<1>(u);
  const double speed = curve.speed(u);
  return 2 * body_rate_form(jet[0], jet[1]) / (speed * speed);
}

/// The corner at (leg, 0) after which the line turns by theta.
Corner canonical(double theta, double leg) {
  return {{0, 0}, {leg, 0}, {leg + leg * std::cos(theta), leg * std::sin(theta)}};
}

TEST(Corner, AgreesWithTheGoldenValues) {
  const Json golden = golden_file("planar_corner.json");
  for (const Json& item : golden["corner"].list()) {
    const Json &in = item["input"], &expected = item["expected"];
    const double theta = in["theta"].number(), leg = in["L"].number();
    const auto found = corner_of_leg(canonical(theta, leg), leg);
    ASSERT_TRUE(found) << item["name"].string();
    // The turn is known from points: to a rounding of their coordinates, which 1/cos(θ/2)
    // amplifies.
    const double tolerance = item["rel_tol"].number() + 8 * epsilon<double>() / std::cos(theta / 2);
    const auto w = golden_preimage(expected["w"]);
    EXPECT_LE(preimage_difference(found->curve.preimage().coefficients(), w),
              tolerance * preimage_size(w))
        << item["name"].string();
    const double kappa = expected["kappa_e"].number();
    const double relative = tolerance + 8 * epsilon<double>() / std::abs(theta);
    EXPECT_NEAR(found->shape.turning_angle, theta, tolerance * pi);
    EXPECT_NEAR(found->shape.peak_curvature, std::abs(kappa), relative * std::abs(kappa));
    EXPECT_NEAR(curvature(found->curve, 0.5), kappa, relative * std::abs(kappa));
    EXPECT_NEAR(found->shape.arc_length, expected["S"].number(), tolerance * leg);
    EXPECT_NEAR(found->curve.arc_length(), expected["S"].number(), tolerance * leg);
    EXPECT_NEAR(found->shape.deviation, expected["delta"].number(), tolerance * leg);
    const Vector2<double> middle = golden_plane_point(expected["mid_point"]);
    EXPECT_LE(largest_component(found->curve.position(0.5) - middle), tolerance * leg);
    for (const Json& sample : expected["kappa_samples"].list()) {
      EXPECT_NEAR(curvature(found->curve, sample["xi"].number()), sample["kappa"].number(),
                  4 * relative * std::abs(kappa));
    }
    // (19), (20) and (21).
    const double d = in["d"].number(), rmin = in["rmin"].number();
    EXPECT_NEAR(corner_clearance_factor(theta) * rmin, expected["d_min"].number(),
                item["rel_tol"].number() * expected["d_min"].number());
    const double least = expected["L_min"].number(), most = expected["L_max"].number();
    const double room = 2 * std::max({least, most, leg});
    const auto tight = corner_of_curvature(canonical(theta, room), 1 / rmin);
    ASSERT_TRUE(tight) << tight.fault().sentence;
    EXPECT_NEAR(tight->leg, least, relative * least);
    const auto wide = corner_of_deviation(canonical(theta, room), d / std::cos(theta / 2));
    ASSERT_TRUE(wide) << wide.fault().sentence;
    EXPECT_NEAR(wide->leg, most, (relative + tolerance) * most);
    EXPECT_NEAR(tight->shape.peak_curvature, 1 / rmin, 8 * epsilon<double>() / rmin);
  }
}

TEST(Corner, AnywhereMeetsItsLinesWithZeroCurvature) {
  Random random("corners");
  for (int i = 0; i < 20000; ++i) {
    const Corner corner{random.vector2(2), random.vector2(2), random.vector2(2)};
    const double leg = random.uniform(0.01, 3), h = random.uniform(0.2, 5);
    const auto found = corner_of_leg(corner, leg, h);
    ASSERT_TRUE(found) << found.fault().sentence;
    const Vector2<double> in = corner.corner - corner.before, out = corner.after - corner.corner;
    const Vector2<double> start = corner.corner - (leg / norm(in)) * in;
    const Vector2<double> end = corner.corner + (leg / norm(out)) * out;
    const auto& curve = found->curve;
    EXPECT_CLOSE(curve.start(), start, 16.0, 5.0);
    EXPECT_CLOSE(curve.end(), end, 64.0, 5.0);
    const auto first = hodograph_form(curve.preimage().front(), curve.preimage().front());
    const auto last = hodograph_form(curve.preimage().back(), curve.preimage().back());
    EXPECT_GT(dot(first, in), 0.0);
    EXPECT_GT(dot(last, out), 0.0);
    EXPECT_CLOSE(cross(first, in), 0.0, 16.0, norm(first) * norm(in));
    EXPECT_CLOSE(cross(last, out), 0.0, 16.0, norm(last) * norm(out));
    EXPECT_EQ(curve.preimage()[1], (Complex<double>{}));
    EXPECT_EQ(found->shape.turning_angle > 0, cross(in, out) > 0);
    EXPECT_CLOSE(curve.arc_length(), found->shape.arc_length, 16.0, leg);
    const auto path = PlanarPath<2>::create({0.0, h}, {curve}, false).value();
    if (i % 200 == 0) {
      constexpr RangeGoal goal{std::numeric_limits<float>::epsilon()};
      const auto extremes = curvature_extremes(path, goal);
      const double peak = std::max(extremes.maximum.upper(), -extremes.minimum.lower());
      EXPECT_GE(peak, found->shape.peak_curvature * (1 - 64 * epsilon<double>()));
      EXPECT_LE(peak, found->shape.peak_curvature * (1 + 4 * goal.relative_width));
    }
    // Dividing by the leg again.
    const auto shape = corner_shape(corner);
    ASSERT_TRUE(shape);
    EXPECT_CLOSE(shape->peak_curvature, leg * found->shape.peak_curvature, 8.0,
                 shape->peak_curvature);
  }
}

TEST(Corner, OfNoTurnIsStraightAndOfATurnBackIsRefused) {
  const auto straight = corner_of_leg({{0, 0}, {1, 2}, {3, 6}}, 0.5);
  ASSERT_TRUE(straight);
  EXPECT_EQ(straight->shape.peak_curvature, 0.0);
  EXPECT_CLOSE(straight->curve.arc_length(), 1.0, 16.0, 1.0);
  EXPECT_EQ(corner_of_curvature({{0, 0}, {1, 2}, {3, 6}}, 1.0).fault().code,
            FaultCode::no_interpolant);
  EXPECT_EQ(corner_of_deviation({{0, 0}, {1, 2}, {3, 6}}, 1.0).fault().code,
            FaultCode::no_interpolant);
  EXPECT_EQ(corner_shape({{0, 0}, {1, 2}, {0.5, 1}}).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(corner_shape({{0, 0}, {0, 0}, {0.5, 1}}).fault().index, 0U);
  EXPECT_EQ(corner_shape({{0, 0}, {1, 0}, {1, 0}}).fault().index, 1U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(corner_shape({{0, 0}, {1, 0}, {1, nan}}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(corner_shape({{0, 0}, {1, 0}, {1, nan}}).fault().index, 2U);
  const Corner right{{0, 0}, {1, 0}, {1, 2}};
  for (const double wrong : {0.0, -1.0, nan}) {
    EXPECT_EQ(corner_of_leg(right, wrong).fault().code, FaultCode::outside_domain);
    EXPECT_EQ(corner_of_curvature(right, wrong).fault().code, FaultCode::outside_domain);
    EXPECT_EQ(corner_of_deviation(right, wrong).fault().code, FaultCode::outside_domain);
    EXPECT_EQ(corner_of_room(right, wrong).fault().code, FaultCode::outside_domain);
  }
  const auto room = corner_of_room(right);
  ASSERT_TRUE(room);
  EXPECT_EQ(room->leg, 1.0);
  const auto sharp = corner_of_curvature(right, 0.1);
  ASSERT_FALSE(sharp);
  EXPECT_EQ(sharp.fault().bound, 1.0);
}

TEST(Corner, ClearanceFactorKeepsItsDigitsAndItsLimit) {
  EXPECT_EQ(corner_clearance_factor(0.0), 0.0);
  EXPECT_CLOSE(corner_clearance_factor(pi), 32.0 / 15.0, 8.0, 2.0);
  for (double theta = 1.0; theta > std::numeric_limits<float>::epsilon(); theta /= 2) {
    const long double c = std::cos(0.5L * theta), s = std::sin(0.25L * theta);
    const long double expected = 8 * (3 * c + 8) * s * s / (15 * (1 + c));
    EXPECT_CLOSE(corner_clearance_factor(theta), expected, 8.0, expected);
  }
}

TEST(RoundedPolyline, AgreesWithTheGoldenValues) {
  const Json golden = golden_file("planar_corner.json");
  for (const Json& item : golden["corner_path"].list()) {
    std::vector<Vector2<double>> points;
    for (const Json& vertex : item["input"]["vertices"].list())
      points.push_back(golden_plane_point(vertex));
    const double most = item["input"]["kappa_max"].number();
    const Json& expected = item["expected"];
    const double tolerance = 16 * item["rel_tol"].number();
    const auto path = rounded_polyline(points, {most, std::nullopt, false});
    for (std::size_t k = 0; k + 2 < points.size(); ++k) {
      const auto corner = corner_shape({points[k], points[k + 1], points[k + 2]});
      ASSERT_TRUE(corner);
      EXPECT_NEAR(corner->turning_angle, expected["turning"][k].number(), tolerance);
      EXPECT_NEAR(corner->peak_curvature / most, expected["L"][k].number(), tolerance);
    }
    if (expected["fits"].number() == 0.0) {
      ASSERT_FALSE(path) << item["name"].string();
      EXPECT_EQ(path.fault().code, FaultCode::no_interpolant);
      continue;
    }
    ASSERT_TRUE(path) << item["name"].string() << ": " << path.fault().sentence;
    EXPECT_NEAR(path->arc_length(), expected["rounded_length"].number(),
                tolerance * path->arc_length());
    EXPECT_EQ(path->segment_count(), 2 * points.size() - 3);
  }
}

TEST(RoundedPolyline, IsCurvatureContinuousAndAsLargeAsThereIsRoom) {
  Random random("rounded polylines");
  for (int i = 0; i < 500; ++i) {
    std::vector<Vector2<double>> points;
    for (int k = 0; k < 8; ++k) points.push_back(random.vector2(3));
    const bool closed = random.chance(0.5);
    std::optional<double> deviation;
    if (random.chance(0.5)) deviation = 0.1;
    const auto path = rounded_polyline(points, {std::nullopt, deviation, closed});
    ASSERT_TRUE(path) << path.fault().sentence;
    EXPECT_EQ(path->is_closed(), closed);
    for (std::size_t k = 0; k < path->segment_count(); ++k) {
      if (k + 1 == path->segment_count() && !closed) break;
      const auto& a = path->segment(k);
      const auto& b = path->segment((k + 1) % path->segment_count());
      EXPECT_CLOSE(a.end(), b.start(), 64.0, 4.0);
      const auto &u = a.preimage().back(), &v = b.preimage().front();
      EXPECT_CLOSE(body_rate_form(u, v), 0.0, 32.0, std::sqrt(dot(u, u) * dot(v, v)));
      EXPECT_NEAR(curvature(a, 1.0) * a.arc_length(), 0.0, 64 * epsilon<double>());
      EXPECT_NEAR(curvature(b, 0.0) * b.arc_length(), 0.0, 64 * epsilon<double>());
    }
    EXPECT_EQ(path->xi_end(), path->knots().back());
    EXPECT_CLOSE(path->arc_length(), path->xi_end(), 64.0, path->xi_end());
  }
}

TEST(RoundedPolyline, TakesEveryLegAsGiven) {
  const std::vector<Vector2<double>> points{{0, 0}, {4, 0}, {4, 3}, {8, 3}, {10, 3}};
  const std::vector<double> legs{1.0, 1.5, 0.0};  // the last corner is none
  const auto path = rounded_polyline_of_legs(points, legs);
  ASSERT_TRUE(path) << path.fault().sentence;
  // line, corner, line, corner, line: legs[1] ends the second line with no room to spare but 0.5.
  double length = 3.0 + (3.0 - 2.5) + (4.0 - 1.5) + 2.0;
  for (std::size_t k = 0; k < 2; ++k) {
    const auto corner = corner_of_leg({points[k], points[k + 1], points[k + 2]}, legs[k]);
    length += corner->shape.arc_length;
  }
  EXPECT_NEAR(path->arc_length(), length, 32.0 * epsilon<double>() * length);

  const auto few = rounded_polyline_of_legs(points, std::vector<double>{1.0});
  ASSERT_FALSE(few);
  EXPECT_EQ(few.fault().code, FaultCode::mismatched_size);
  const auto none = rounded_polyline_of_legs(points, std::vector<double>{1.0, 0.0, 0.0});
  ASSERT_FALSE(none);
  EXPECT_EQ(none.fault().code, FaultCode::outside_domain);
  EXPECT_EQ(none.fault().index, 2U);
  const auto many = rounded_polyline_of_legs(points, std::vector<double>{2.0, 1.5, 0.0});
  ASSERT_FALSE(many);
  EXPECT_EQ(many.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(many.fault().index, 1U);
}

TEST(RoundedPolyline, RefusesWhatItCannotRound) {
  using Points = std::vector<Vector2<double>>;
  const auto fault = [](const Points& points, const CornerRule& rule) {
    const auto path = rounded_polyline(points, rule);
    EXPECT_FALSE(path);
    return path ? Fault{} : path.fault();
  };
  EXPECT_EQ(fault({{0, 0}}, {}).code, FaultCode::too_few);
  EXPECT_EQ(fault({{0, 0}, {1, 0}}, {std::nullopt, std::nullopt, true}).code, FaultCode::too_few);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 0}, {2, 2}}, {}).index, 1U);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {0.5, 0}, {2, 2}}, {}).index, 1U);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 1}}, {-1.0, std::nullopt, false}).code,
            FaultCode::outside_domain);
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 1}}, {100.0, 1.0 / 1024, false}).quantity, "deviation");
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, 1}, {2, 1}}, {4.0, std::nullopt, false}).index, 1U);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(fault({{0, 0}, {1, 0}, {1, nan}}, {}).index, 2U);
  // Points on a line are passed straight.
  const auto line = rounded_polyline(Points{{0, 0}, {1, 1}, {3, 3}}, {});
  ASSERT_TRUE(line);
  EXPECT_CLOSE(line->arc_length(), 3 * std::sqrt(2.0), 16.0, 5.0);
  const auto two = rounded_polyline(Points{{0, 0}, {1, 1}}, {});
  ASSERT_TRUE(two);
}

}  // namespace
}  // namespace hodograph::test
