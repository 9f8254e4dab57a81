// SPDX-License-Identifier: MIT
// docs/conventions.md, one test a sign. The data are small integers, so the results are exact.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "hodograph/construction/start_frame.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/angular_velocity.hpp"
#include "hodograph/path/path.hpp"
#ifdef HODOGRAPH_HAS_ORBIT
#include "hodograph/orbit/reference_frame.hpp"
#endif

namespace hodograph {
namespace {

using Q = Quaternion<double>;
using C = Complex<double>;
using V3 = Vector3<double>;
using V2 = Vector2<double>;
using Curve = SpatialPhCurve<1>;
using Line = Path<Q, 1>;

constexpr Q quarter_turn_left{1, 0, 0, 1};  // about z, with |A|² = 2

// The preimage A0 (1-u) + A1 u from a start, over a parameter step.
Curve curve(const V3& start, const Q& a0, const Q& a1, double step) {
  return Curve(start, Curve::Preimage({a0, a1}), step);
}

// Along x with speed 4 on [10, 12] and speed 1 on [12, 13].
Line straight_line() {
  const Curve first = curve({0, 0, 0}, {2, 0, 0, 0}, {2, 0, 0, 0}, 2);
  const Curve second = curve({8, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, 1);
  return Line::create({10, 12, 13}, {first, second}, false).value();
}

TEST(Conventions, LocalParameterRunsFromZeroToOne) {
  const Line line = straight_line();
  EXPECT_EQ(line.locate(10).u, 0.0);
  EXPECT_EQ(line.locate(11).u, 0.5);
  EXPECT_EQ(line.xi_of({0, 1.0}), 12.0);
}

TEST(Conventions, AKnotBelongsToTheLaterSegment) {
  const Line line = straight_line();
  EXPECT_EQ(line.locate(12).segment, 1u);
  EXPECT_EQ(line.locate(12).u, 0.0);
  EXPECT_EQ(line.speed(12), 1.0);
}

TEST(Conventions, OutsideTheKnotsIsAnError) {
  const Line line = straight_line();
  for (const double xi : {std::nextafter(10.0, 0.0), std::nextafter(13.0, 14.0),
                          std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_THROW((void)line.position(xi), Error) << xi;
  }
}

TEST(Conventions, ClampingAndWrappingAreNamed) {
  const Line line = straight_line();
  EXPECT_EQ(line.clamped(9), 10.0);
  EXPECT_EQ(line.clamped(14), 13.0);
  EXPECT_EQ(line.wrapped(14), 11.0);
  EXPECT_EQ(line.wrapped(9), 12.0);
}

TEST(Conventions, ArcLengthCountsFromTheFirstKnot) {
  const Line line = straight_line();
  EXPECT_EQ(line.arc_length(10.0), 0.0);
  EXPECT_EQ(line.arc_length(12.0), 8.0);
  EXPECT_EQ(line.arc_length(), 9.0);
}

TEST(Conventions, RatesPerArcLengthAreRatesOverTheSpeed) {
  const std::array<Q, 2> jet{Q{2, 0, 0, 0}, Q{0, 0, 0, 4}};  // σ = 4
  EXPECT_EQ(body_rate_per_xi(jet)[0], (V3{0, 0, 4}));
  EXPECT_EQ(body_rate_per_arc_length(jet)[0], (V3{0, 0, 1}));
}

TEST(Conventions, PolynomialsAreInBernsteinForm) {
  const BernsteinPolynomial<double, 2> f({1, 6, 3});
  EXPECT_EQ(f.value(0), 1.0);
  EXPECT_EQ(f.value(1), 3.0);
  EXPECT_EQ(f.value(0.5), (1.0 + 2 * 6.0 + 3.0) / 4);
}

TEST(Conventions, PreimagesAreInTheGlobalScaling) {
  // On a parameter step of 2 the constant preimage 1 has dr/dξ = 1 and covers a distance of 2.
  const Curve straight = curve({0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, 2);
  EXPECT_EQ(straight.speed(0.5), 1.0);
  EXPECT_EQ(straight.end(), (V3{2, 0, 0}));
  // A' is per unit ξ as well: from 1 to 3 over a step of 2.
  const Curve faster = curve({0, 0, 0}, {1, 0, 0, 0}, {3, 0, 0, 0}, 2);
  EXPECT_EQ(faster.preimage_jet<1>(0.5)[1], (Q{1, 0, 0, 0}));
}

TEST(Conventions, QuaternionsAreScalarFirst) {
  const Q q{1, 2, 3, 4};
  EXPECT_EQ(q.w, 1.0);
  EXPECT_EQ(q[0], 1.0);
  EXPECT_EQ(vector_part(q), (V3{2, 3, 4}));
}

TEST(Conventions, QuaternionProductIsHamiltons) {
  const Q i{0, 1, 0, 0}, j{0, 0, 1, 0}, k{0, 0, 0, 1};
  EXPECT_EQ(i * j, k);
  EXPECT_EQ(j * i, -k);
}

TEST(Conventions, AnglesAreRadians) {
  const Frame3<double> identity{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Frame3<double> half_turn = rolled(identity, std::numbers::pi);
  EXPECT_EQ(half_turn.e2.y, -1.0);
  EXPECT_EQ(half_turn.e3.z, -1.0);
}

TEST(Conventions, ScalingTheLengthsScalesThePath) {
  const Curve small = curve({1, 0, 0}, {1, 0, 0, 1}, {1, 2, 0, 0}, 1);
  const Curve large = curve({4, 0, 0}, {2, 0, 0, 2}, {2, 4, 0, 0}, 1);
  EXPECT_EQ(large.position(0.5), 4.0 * small.position(0.5));
  EXPECT_EQ(large.arc_length(), 4.0 * small.arc_length());
}

TEST(Conventions, PlanarHodographIsTheSquare) {
  const C w{1, 1};
  EXPECT_EQ(hodograph_form(w, w), (V2{0, 2}));
  EXPECT_EQ(speed_form(w, w), 2.0);
}

TEST(Conventions, TangentIsTheImageOfI) {
  const Q one{1, 0, 0, 0};
  EXPECT_EQ(hodograph_form(one, one), (V3{1, 0, 0}));
  EXPECT_EQ(hodograph_form(quarter_turn_left, quarter_turn_left), (V3{0, 2, 0}));
  EXPECT_EQ(sandwich(quarter_turn_left, V3{1, 0, 0}), (V3{0, 2, 0}));
  EXPECT_EQ(speed_form(quarter_turn_left, quarter_turn_left), 2.0);
}

TEST(Conventions, PlanarNormalIsToTheLeft) {
  const std::array<C, 1> jet{C{1, 0}};
  EXPECT_EQ(euler_rodrigues_frame(jet).e1, (V2{1, 0}));
  EXPECT_EQ(euler_rodrigues_frame(jet).e2, (V2{0, 1}));
  EXPECT_EQ(cross(V2{1, 0}, V2{0, 1}), 1.0);
}

TEST(Conventions, PlanarCurvatureIsPositiveToTheLeft) {
  const std::array<C, 2> left{C{1, 0}, C{0, 1}}, right{C{1, 0}, C{0, -1}};
  EXPECT_EQ(hodograph_derivatives(left)[1], (V2{0, 2}));  // the tangent turns towards +y
  EXPECT_EQ(curvature(left), 2.0);
  EXPECT_EQ(curvature(right), -2.0);
}

TEST(Conventions, SpatialCurvatureIsNotNegative) {
  const std::array<Q, 2> left{Q{1, 0, 0, 0}, Q{0, 0, 0, 1}}, right{Q{1, 0, 0, 0}, Q{0, 0, 0, -1}};
  EXPECT_EQ(curvature(left), 2.0);
  EXPECT_EQ(curvature(right), 2.0);
}

TEST(Conventions, TorsionIsPositiveOnARightHandedHelix) {
  // At (cos t, sin t, t), t = 0, the definition gives 1/2.
  const V3 velocity{0, 1, 1}, acceleration{-1, 0, 0}, jerk{0, -1, 0};
  const V3 binormal = cross(velocity, acceleration);
  EXPECT_EQ(dot(binormal, jerk) / dot(binormal, binormal), 0.5);
  // A curve whose frame turns left while it rolls forwards; compared with the definition.
  const std::array<Q, 3> jet{Q{1, 0, 0, 0}, Q{0, 1, 0, 1}, Q{}};
  const auto r = hodograph_derivatives(jet);
  const V3 b = cross(r[0], r[1]);
  ASSERT_TRUE(torsion(jet).has_value());
  EXPECT_EQ(*torsion(jet), dot(b, r[2]) / dot(b, b));
  EXPECT_EQ(*torsion(jet), 2.0);
}

TEST(Conventions, ErfAxesAreTheImagesOfIJK) {
  const Frame3<double> frame = euler_rodrigues_frame(std::array<Q, 1>{quarter_turn_left});
  EXPECT_EQ(frame.e1, (V3{0, 1, 0}));
  EXPECT_EQ(frame.e2, (V3{-1, 0, 0}));
  EXPECT_EQ(frame.e3, (V3{0, 0, 1}));
}

TEST(Conventions, BodyRateComponents) {
  const std::array<Q, 2> jet{Q{1, 0, 0, 0}, Q{0, 1, 2, 3}};
  const V3 chi = body_rate_per_xi(jet)[0];
  EXPECT_EQ(chi, (V3{2, 4, 6}));
  // The derivative of the frame by the product rule, without the rate.
  const Q a = jet[0], b = jet[1];
  const auto turned = [&](const Q& unit) {
    return vector_part(b * unit * conjugate(a) + a * unit * conjugate(b));
  };
  const V3 e1_rate = turned({0, 1, 0, 0}), e2_rate = turned({0, 0, 1, 0}),
           e3_rate = turned({0, 0, 0, 1});
  const Frame3<double> frame = euler_rodrigues_frame(jet);
  EXPECT_EQ(chi.x, dot(e2_rate, frame.e3));
  EXPECT_EQ(chi.y, dot(e3_rate, frame.e1));
  EXPECT_EQ(chi.z, dot(e1_rate, frame.e2));
}

TEST(Conventions, WorldRateIsTheFrameTimesTheBodyRate) {
  const std::array<Q, 2> jet{quarter_turn_left, Q{0, 1, 2, 3}};
  const V3 chi = body_rate_per_xi(jet)[0];
  const Frame3<double> frame = euler_rodrigues_frame(jet);
  EXPECT_EQ(world_rate_per_xi(jet)[0], chi.x * frame.e1 + chi.y * frame.e2 + chi.z * frame.e3);
}

TEST(Conventions, RollIsPositiveFromE2ToE3) {
  const Frame3<double> identity{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  const Frame3<double> quarter = rolled(identity, std::numbers::pi / 2);
  EXPECT_EQ(quarter.e1, identity.e1);
  EXPECT_EQ(quarter.e2.z, 1.0);
  EXPECT_EQ(quarter.e3.y, -1.0);
}

TEST(Conventions, RollIsARightFactorOfHalfTheAngle) {
  // cos φ + i sin φ at φ = π/4, times √2: a roll by π/2.
  const Q rolled_preimage = Q{1, 0, 0, 0} * Roll<double>{1, 1};
  EXPECT_EQ(rolled_preimage, (Q{1, 1, 0, 0}));
  const Frame3<double> frame = euler_rodrigues_frame(std::array<Q, 1>{rolled_preimage});
  EXPECT_EQ(frame.e1, (V3{1, 0, 0}));
  EXPECT_EQ(frame.e2, (V3{0, 0, 1}));
  EXPECT_EQ(frame.e3, (V3{0, -1, 0}));
}

TEST(Conventions, LevelNormalIsToTheLeft) {
  EXPECT_EQ(level_frame({2, 0, 0}).value(), (Q{1, 0, 0, 0}));
  // Half a turn about z: the direction -x has its left at -y.
  const Frame3<double> back = scaled_frame(level_frame({-1, 0, 0}).value());
  EXPECT_EQ(back.e1, (V3{-1, 0, 0}));
  EXPECT_EQ(back.e2, (V3{0, -1, 0}));
}

#ifdef HODOGRAPH_HAS_ORBIT
TEST(Conventions, EarthIsAtMinusMu) {
  EXPECT_LT(earth_moon_system.mass_ratio, 0.5);  // the Moon is the lighter one
  const ThreeBodySystem system{0.25, 1, 1};
  EXPECT_EQ(offset_from_larger(system, V3{-0.25, 0, 0}), (V3{0, 0, 0}));
  EXPECT_EQ(offset_from_smaller(system, V3{0.75, 0, 0}), (V3{0, 0, 0}));
}

TEST(Conventions, TheMoonGoesRoundAtOneRadianPerTimeUnit) {
  const ThreeBodySystem system{0.25, 1, 1};
  const MotionJet<double, 2> moon{V3{0.75, 0, 0}, V3{0, 0, 0}};
  EXPECT_EQ(to_earth_centred_inertial(system, moon, 0.0)[0], (V3{1, 0, 0}));
  EXPECT_EQ(to_earth_centred_inertial(system, moon, 0.0)[1], (V3{0, 1, 0}));
  const double time = 2;
  const V3 later = to_earth_centred_inertial(system, moon, time)[0];
  EXPECT_EQ(later, (V3{std::cos(time), std::sin(time), 0}));
}
#endif

TEST(Conventions, FaultsAreBadInputOrNoSolution) {
  EXPECT_FALSE(is_no_solution(FaultCode::not_finite));
  EXPECT_FALSE(is_no_solution(FaultCode::malformed_document));
  EXPECT_TRUE(is_no_solution(FaultCode::no_interpolant));
  EXPECT_TRUE(is_no_solution(FaultCode::tolerance_not_reached));
}

}  // namespace
}  // namespace hodograph
