// SPDX-License-Identifier: MIT
// Hermite interpolation against the reference values of PHODCOS, and what is refused.
#include "hodograph/construction/hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "hodograph/construction/derivative_curve.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/curves.hpp"
#include "tests/support/hermite_golden.hpp"

namespace hodograph {
namespace {

using test::Json;

const Json& golden() {
  static const Json file = test::golden_file("phodcos.json");
  return file;
}
const Json& golden_order_ten() {
  static const Json file = test::golden_file("phodcos_order_ten.json");
  return file;
}

// A fair tolerance is this many times what a plain double-precision run deviates by.
constexpr double fair = 4.0;
constexpr double eps = epsilon<double>();

std::vector<double> knots_of(const Json& curve) {
  std::vector<double> knots;
  for (const Json& knot : curve["knots"].list()) knots.push_back(knot.number());
  return knots;
}

SpatialPath<8> path_of_curve23(const std::vector<double>& knots, HermiteChoice choice) {
  std::vector<HermitePoint<4>> points;
  for (const double xi : knots) points.push_back(derivatives_of<4, double>(test::Curve23{}, xi));
  return hermite_path<4, double>(knots, std::span<const HermitePoint<4>>(points), choice).value();
}

/// The path turned so that its frame starts as the reference does, after comparing the preimages.
SpatialPath<8> compared_preimage(const SpatialPath<8>& path,
                                 const std::vector<Quaternion<double>>& expected,
                                 double deviation) {
  const auto actual = test::local_coefficients(path);
  const Roll<double> roll = test::matching_roll(actual, expected);
  const SpatialPath<8> turned = test::rolled_path(path, roll);
  EXPECT_CLOSE(test::local_coefficients(turned), expected, fair * deviation / eps,
               test::largest_of(expected));
  return turned;
}

/// Compares everything a golden sample lists; a derivative of order r carries the deviation of the
/// coefficients times what r differences of degree d make of it, over the size of the derivative.
void compare_sample(const SpatialPath<8>& path, const Json& sample, double deviation) {
  const double xi = sample["t"].number();
  SCOPED_TRACE("xi = " + std::to_string(xi));
  const auto at = path.locate(xi);
  const auto& segment = path.segment(at.segment);
  const double h = segment.parameter_step();
  const auto growth = [h](std::size_t degree, std::size_t r) {
    return test::growth(degree, r) / std::pow(h, static_cast<double>(r));
  };
  const double tolerance = fair * deviation / eps;
  double position_size = 0.0, preimage_size = 0.0;
  for (const auto& c : segment.displacement().coefficients()) {
    position_size = std::max(position_size, largest_component(c));
  }
  for (const auto& a : segment.preimage().coefficients()) {
    preimage_size = std::max(preimage_size, largest_component(a));
  }
  position_size = std::max(position_size, largest_component(segment.start()));

  const auto p = path.position_derivatives<4>(xi);
  for (std::size_t r = 0; r <= 4; ++r) {
    EXPECT_CLOSE(p[r], sample["p"][r].vector(), tolerance, position_size * growth(17, r));
  }
  const auto jet = path.preimage_jet<3>(xi);
  const double sigma = norm(p[1]);
  double relative = preimage_size / std::sqrt(sigma);  // conditioning of what is divided by |A|
  for (std::size_t r = 0; r <= 3; ++r) {
    EXPECT_CLOSE(jet[r], sample["A_global"][r].quaternion(), tolerance,
                 preimage_size * growth(8, r));
  }
  const auto speeds = speed_derivatives(jet);
  for (std::size_t r = 0; r <= 3; ++r) {
    EXPECT_CLOSE(speeds[r], sample["sigma"][r].number(), 2.0 * tolerance,
                 preimage_size * preimage_size * growth(16, r));
  }
  const AdaptedFrame frame(path);
  const auto frames = frame.derivatives<2>(xi);
  const auto world = frame.world_rate_per_xi_derivatives<2>(xi);
  const auto body = frame.body_rate_per_xi_derivatives<2>(xi);
  // |A^(r)| h^r/|A| is at most 2^r 8!/(8-r)! relative; products of at most three such, and their
  // sum over the quotient rule, stay below growth(16, r) relative^(r+1), doubled.
  for (std::size_t r = 0; r < 3; ++r) {
    const double scale = 2.0 * growth(16, r) * std::pow(relative, static_cast<double>(r + 1));
    for (std::size_t k = 0; k < 3; ++k) {
      if (!sample["R"].size() || r > 1) continue;
      const auto expected = (r == 0 ? sample["R"] : sample["R_d1"])[k].vector();
      const auto& actual = k == 0 ? frames[r].e1 : k == 1 ? frames[r].e2 : frames[r].e3;
      EXPECT_CLOSE(actual, expected, tolerance, scale);
    }
    EXPECT_CLOSE(world[r], sample["omega"][r].vector(), tolerance,
                 scale * growth(16, 1) * relative);
    EXPECT_CLOSE(body[r], sample["chi"][r].vector(), tolerance, scale * growth(16, 1) * relative);
  }
  EXPECT_CLOSE(frame.world_rate_per_arc_length(xi), sample["omega_s"].vector(), tolerance,
               2.0 * growth(16, 1) * relative * relative / sigma);
  EXPECT_CLOSE(path.arc_length(xi), sample["s"].number(), tolerance, path.arc_length());
}

TEST(HermiteGolden, Curve23OnUniformAndNonUniformKnots) {
  ASSERT_EQ(golden()["curves"].size(), 4U);
  for (const Json& curve : golden()["curves"].list()) {
    SCOPED_TRACE(std::to_string(curve["segments"].size()) + " segments");
    const auto path = path_of_curve23(knots_of(curve), HermiteChoice::order_six);
    ASSERT_EQ(path.segment_count(), curve["segments"].size());
    std::vector<Quaternion<double>> expected;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      const Json& segment = curve["segments"][k];
      EXPECT_EQ(path.segment(k).parameter_step(), segment["h"].number());
      EXPECT_CLOSE(path.segment(k).start(), segment["p0"].vector(), 1.0, 3.0);
      for (const auto& a : test::golden_quaternions(segment["A"])) expected.push_back(a);
    }
    const double deviation = curve["float64_deviation"]["A"].number();
    const auto turned = compared_preimage(path, expected, deviation);
    for (const Json& sample : curve["samples"].list()) compare_sample(turned, sample, deviation);
    EXPECT_CLOSE(path.arc_length(), curve["length"].number(), fair * deviation / eps,
                 path.arc_length());
    double worst = 0.0;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      for (int i = 0; i <= 50; ++i) {
        const double u = i / 50.0;
        const double xi = path.xi_of({k, u});
        worst = std::max(worst, norm(test::Curve23{}(xi)-path.segment(k).position(u)));
      }
    }
    EXPECT_CLOSE(worst, curve["max_error"].number(), fair * deviation / eps, 3.0);
  }
}

TEST(HermiteGolden, RandomSetsWithTheChoiceOfThePaper) {
  ASSERT_EQ(golden()["hermite"].size(), 5U);
  for (const Json& set : golden()["hermite"].list()) {
    SCOPED_TRACE(set["name"].string());
    const auto begin = test::golden_point(set["b"]), end = test::golden_point(set["e"]);
    const auto parameters = test::golden_parameters(set["phi"]);
    const auto path = test::single(hermite_curve<4, double>(begin, end, 1.0, parameters).value());
    const double deviation = set["float64_deviation"]["A"].number();
    const auto turned = compared_preimage(path, test::golden_quaternions(set["A"]), deviation);
    std::vector<Vector3<double>> control, expected;
    for (const auto& c : path.segment(0).displacement().coefficients()) {
      control.push_back(path.segment(0).start() + c);
    }
    for (const Json& c : set["path_control_points"].list()) expected.push_back(c.vector());
    EXPECT_CLOSE(control, expected, fair * set["float64_deviation"]["P"].number() / eps,
                 test::largest_of(expected));
    EXPECT_CLOSE(path.arc_length(), set["length"].number(), fair * deviation / eps,
                 path.arc_length());
    for (const Json& sample : set["samples"].list()) compare_sample(turned, sample, deviation);
    if (set["phi"].has("th0")) continue;
    // All parameters zero is the same as the named choice, to the bit.
    EXPECT_EQ(path.segment(0),
              (hermite_curve<4, double>(begin, end, 1.0, HermiteChoice::order_six).value()));
  }
}

TEST(HermiteGolden, RandomSetsWithTheChoiceOfOrderTen) {
  ASSERT_EQ(golden_order_ten()["hermite"].size(), 5U);
  for (std::size_t k = 0; k < 5; ++k) {
    const Json& set = golden_order_ten()["hermite"][k];
    SCOPED_TRACE(set["name"].string());
    const double deviation = golden()["hermite"][k]["float64_deviation"]["A"].number();
    const auto path = test::single(
        hermite_curve<4, double>(test::golden_point(set["b"]), test::golden_point(set["e"]))
            .value());
    const auto turned = compared_preimage(path, test::golden_quaternions(set["A"]), deviation);
    std::vector<Vector3<double>> control, expected;
    for (const auto& c : path.segment(0).displacement().coefficients()) {
      control.push_back(path.segment(0).start() + c);
    }
    for (const Json& c : set["path_control_points"].list()) expected.push_back(c.vector());
    EXPECT_CLOSE(control, expected, fair * deviation / eps, test::largest_of(expected));
    const Json& third = set["at_one_third"];
    const double u = 1.0 / 3.0;
    EXPECT_CLOSE(path.position(u), third["p"].vector(), fair * deviation / eps,
                 test::largest_of(expected));
    EXPECT_CLOSE(path.speed(u), third["sigma"].number(), 2.0 * fair * deviation / eps,
                 path.speed(u));
    EXPECT_CLOSE(path.arc_length(u), third["s"].number(), fair * deviation / eps,
                 path.arc_length());
    const AdaptedFrame frame(turned);
    EXPECT_CLOSE(frame.at(u).e1, third["e1"].vector(), 2.0 * fair * deviation / eps, 1.0);
    EXPECT_CLOSE(frame.body_rate_per_xi(u).x, third["chi_1"].number(), 2.0 * fair * deviation / eps,
                 16.0);
  }
}

TEST(HermiteGolden, OrderTenOnCurve23) {
  for (const Json& row : golden_order_ten()["errors"].list()) {
    const int segments = static_cast<int>(row["segments"].number());
    std::vector<double> knots;
    for (int k = 0; k <= segments; ++k) knots.push_back(static_cast<double>(k) / segments);
    const auto path = path_of_curve23(knots, HermiteChoice::order_ten);
    double worst = 0.0;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      for (int i = 0; i <= 50; ++i) {
        const double u = i / 50.0;
        worst = std::max(worst, norm(test::Curve23{}((static_cast<double>(k) + u) / segments) -
                                     path.segment(k).position(u)));
      }
    }
    // Positions of size 3 are rounded in the curve, the data and the path.
    EXPECT_CLOSE(worst, row["max_error_50_samples"].number(), 8.0, 3.0) << segments;
  }
}

// ---- what is refused
// -----------------------------------------------------------------------------

using Point = HermitePoint<4>;
const Point start_point{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}}};
const Point end_point{{{1, 0.5, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}, {0, 0, 0}}};

template <class R>
Fault fault_of(const R& result) {
  EXPECT_FALSE(result.has_value());
  return result ? Fault{} : result.fault();
}

TEST(HermiteRefusals, NumbersThatAreNotFinite) {
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    for (std::size_t r = 0; r <= 4; ++r) {
      Point end = end_point;
      end[r].y = bad;
      const Fault fault = fault_of(hermite_curve<4, double>(start_point, end));
      EXPECT_EQ(fault.code, FaultCode::not_finite);
      EXPECT_EQ(fault.index, 1U);
      EXPECT_EQ(fault.sentence,
                r == 0 ? "the position of point 1 is not finite"
                       : "derivative " + std::to_string(r) + " of point 1 is not finite");
    }
    const Fault fault = fault_of(hermite_curve<4, double>(start_point, end_point, bad));
    EXPECT_EQ(fault.code, FaultCode::outside_domain);
  }
}

TEST(HermiteRefusals, ZeroSpeed) {
  Point begin = start_point;
  begin[1] = {0, 0, 0};
  Fault fault = fault_of(hermite_curve<4, double>(begin, end_point));
  EXPECT_EQ(fault.code, FaultCode::zero_speed);
  EXPECT_EQ(fault.index, 0U);
  EXPECT_EQ(
      fault.sentence,
      "the velocity of point 0 is zero: a PH curve has no direction there; give it a speed or "
      "split the data at the stop");
  fault = fault_of(hermite_curve<4, double>(end_point, begin, 1.0, HermiteParameters<4>{}));
  EXPECT_EQ(fault.code, FaultCode::zero_speed);
  EXPECT_EQ(fault.index, 1U);
}

TEST(HermiteRefusals, StepsAndKnots) {
  for (const double h : {0.0, -1.5}) {
    const Fault fault = fault_of(hermite_curve<4, double>(start_point, end_point, h));
    EXPECT_EQ(fault.code, FaultCode::outside_domain);
    EXPECT_EQ(fault.sentence, "the parameter step must be positive; got " + to_text(h));
    EXPECT_EQ(fault.value, h);
  }
  const std::vector<Point> points{start_point, end_point};
  const std::span<const Point> span(points);
  Fault fault = fault_of(hermite_path<4, double>({0.0, 0.0}, span));
  EXPECT_EQ(fault.code, FaultCode::not_increasing);
  EXPECT_EQ(fault.sentence, "knots must increase strictly; knot 1 is 0 after 0");
  fault = fault_of(hermite_path<4, double>({-1e308, 1e308}, span));
  EXPECT_EQ(fault.code, FaultCode::not_finite);
  EXPECT_EQ(fault.sentence, "the step from knot -1e+308 to 1e+308 exceeds the range of numbers");
  fault = fault_of(hermite_path<4, double>({0.0, 1.0, 2.0}, span));
  EXPECT_EQ(fault.code, FaultCode::mismatched_size);
  EXPECT_EQ(fault.sentence, "2 points need as many knots; got 3");
  fault = fault_of(hermite_path<4, double>({0.0}, span.first(1)));
  EXPECT_EQ(fault.code, FaultCode::too_few);
  EXPECT_EQ(fault.sentence, "a path needs at least 2 points; got 1");
  // Declared closed, but open.
  fault = fault_of(hermite_path<4, double>({0.0, 1.0}, span, HermiteChoice::order_ten, true));
  EXPECT_EQ(fault.code, FaultCode::not_continuous);
}

}  // namespace
}  // namespace hodograph
