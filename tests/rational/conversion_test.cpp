// SPDX-License-Identifier: MIT
// Rational PH curves in floating point: points, rational Bézier curves, paths.
#include "hodograph/rational/conversion.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

// Products of degree up to 12 with binomial weights, two square roots and one sum of the terms of a
// curve: some hundred roundings.
constexpr double roundings = 256.0 * std::numeric_limits<double>::epsilon();

const RationalPolynomial& t() {
  static const auto variable = RationalPolynomial::monomial(1, 1);
  return variable;
}
/// A of Examples 5.1 and 5.3.
QuaternionPolynomial example() { return {t() * t(), -t(), -t(), 1}; }

/// ∫ λ F for a polynomial λ.
RationalPhCurve polynomial_curve(const QuaternionPolynomial& a, const RationalPolynomial& lambda) {
  const VectorPolynomial f = indicatrix(a);
  return RationalPhCurve::create(
             a, VectorFunction({(lambda * f.x).integral() + 1, (lambda * f.y).integral() - 2,
                                (lambda * f.z).integral()},
                               1))
      .value();
}

double distance(const Vector3<double>& a, const Vector3<double>& b) {
  return largest_component(a - b);
}

TEST(RationalConversion, PointsAreTheExactOnesRounded) {
  const auto curve = RationalPhCurve::create(example(), t().power(3),
                                             solve(example(), t().power(3), 6).value().basis()[0])
                         .value();
  const auto p = position(curve, 0.5).value();
  const RationalVector exact = curve.position().value(Rational(1, 2));
  EXPECT_EQ(p.x, exact.x.to_double());
  EXPECT_EQ(position(curve, 0.0).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(position(curve, std::nan("")).fault().code, FaultCode::not_finite);
  EXPECT_EQ(position(curve, std::numeric_limits<double>::denorm_min()).fault().code,
            FaultCode::outside_domain);
}

TEST(RationalConversion, BezierPiecesFollowTheCurve) {
  Random random("rational Bezier pieces");
  for (int i = 0; i < 20; ++i) {
    const auto a = random_quaternion_polynomial(random, 2, 3);
    // Complex poles near the interval make one piece too few.
    const auto alpha = (t() * t() + Rational(1, random.integer(1, 60))).power(3);
    const auto space = solve(a, alpha, 10).value();
    const auto curve = RationalPhCurve::create(space.preimage(), alpha, space.basis()[0]).value();
    const auto pieces = rational_bezier(curve, -1.0, 2.0).value();
    double end = -1.0;
    for (const auto& piece : pieces) {
      EXPECT_EQ(piece.begin, end);
      end = piece.end;
      double size = 0.0;
      for (const auto& p : piece.control_points) size = std::max(size, largest_component(p));
      for (const double w : piece.weights) EXPECT_GT(w, 0.0);
      for (const double u : {0.0, 0.25, 0.7, 1.0}) {
        const double at = piece.begin + u * (piece.end - piece.begin);
        const auto smallest = *std::min_element(piece.weights.begin(), piece.weights.end());
        // The weighted sum has rounding relative to its largest term, the weights reach down to
        // `smallest`; u itself is rounded when the point is compared.
        EXPECT_LE(distance(piece.position(u), position(curve, at).value()),
                  roundings * size / smallest);
      }
    }
    EXPECT_EQ(end, 2.0);
  }
  const auto curve = RationalPhCurve::create(example(), t().power(3),
                                             solve(example(), t().power(3), 6).value().basis()[0])
                         .value();
  const auto refused = rational_bezier(curve, -1.0, 1.0);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.fault().sentence.find("pole at t = 0"), std::string::npos);
  EXPECT_EQ(rational_bezier(curve, 2.0, 1.0).fault().code, FaultCode::not_increasing);
  EXPECT_EQ(rational_bezier(curve, 1.0, std::numeric_limits<double>::infinity()).fault().code,
            FaultCode::not_finite);
  EXPECT_TRUE(rational_bezier(curve, 0.001, 1.0));
}

TEST(RationalConversion, PolynomialCurvesBecomePaths) {
  const std::vector<RationalPolynomial> lambdas{
      1, -3, (t() - 5) * (t() - 5), RationalPolynomial(-2) * t().power(2) * (t() * t() + 1),
      (t() * t() + t() + 1) * (t() * t() + 3)};
  for (const RationalPolynomial& lambda : lambdas) {
    SCOPED_TRACE(to_text(lambda));
    const auto curve = polynomial_curve(example(), lambda);
    const auto path = AnyPath::create(path_numbers(curve, -1.0, 1.5).value()).value();
    EXPECT_EQ(path.knots(), (std::vector<double>{-1.0, 1.5}));
    double size = path.arc_length();
    for (const double at : {-1.0, 0.0, 1.5}) {
      size = std::max(size, largest_component(position(curve, at).value()));
    }
    for (const double at : {-1.0, -0.3, 0.0, 0.8, 1.5}) {
      std::array<double, 3> p{};
      path.position(at, p);
      EXPECT_LE(distance({p[0], p[1], p[2]}, position(curve, at).value()), roundings * size);
      const Rational speed = curve.speed().value(Rational::exactly(at).value());
      EXPECT_LE(std::abs(path.speed(at) - std::abs(speed.to_double())), roundings * size);
    }
  }
}

TEST(RationalConversion, RefusesWhatNoPathHolds) {
  const auto turning = path_numbers(polynomial_curve(example(), t() - 7), 0.0, 1.0);
  ASSERT_FALSE(turning);
  EXPECT_NE(turning.fault().sentence.find("changes its sign at t = 7"), std::string::npos);
  const auto rational =
      RationalPhCurve::create(example(), t().power(3),
                              solve(example(), t().power(3), 6).value().basis()[0])
          .value();
  EXPECT_NE(path_numbers(rational, 1.0, 2.0).fault().sentence.find("t^3"), std::string::npos);
  const auto point = RationalPhCurve::create(example(), VectorFunction()).value();
  EXPECT_EQ(path_numbers(point, 0.0, 1.0).fault().code, FaultCode::outside_domain);
  const auto large = path_numbers(polynomial_curve(example(), t().power(40)), 0.0, 1.0);
  EXPECT_EQ(large.fault().code, FaultCode::unsupported);
}

}  // namespace
}  // namespace hodograph
