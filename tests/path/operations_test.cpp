// SPDX-License-Identifier: MIT
// Paths from paths: each operation against what it does to the points, and its refusals.
#include "hodograph/path/operations.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

#include "hodograph/frame/adapted_frame.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// Two paths that are equal but for rounding agree in a point to this many ε of the largest
/// coordinate: two evaluations of degree d = 2n + 1, (3d + 2)/2 each, of coefficients that are sums
/// of 2n + 1 hodograph coefficients with n + 6 roundings each, plus one mapping of the start.
template <class P>
constexpr double position_tolerance = 9.0 * P::preimage_degree + 16.0;
/// The same for a preimage of degree n mapped by one product (4 terms).
template <class P>
constexpr double preimage_tolerance = 3.0 * P::preimage_degree + 12.0;

template <class P>
double scale_of(const P& path) {
  double scale = 1.0;
  for (const auto& curve : path.segments()) {
    scale = std::max(scale, largest_component(curve.start()));
  }
  return scale + path.arc_length();
}

/// ξ at the knots and inside the segments.
template <class P>
std::vector<double> parameters(const P& path) {
  std::vector<double> result;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const double a = path.knots()[k], b = path.knots()[k + 1];
    for (const double u : {0.0, 0.125, 0.4, 0.9375}) result.push_back(a + u * (b - a));
  }
  result.push_back(path.xi_end());
  return result;
}

/// `to` is `from` with its points mapped and its parameter ξ̃ = parameter(ξ).
template <class P, class Q, class PointMap, class ParameterMap>
void expect_image(const P& from, const Q& to, const PointMap& map, const ParameterMap& parameter) {
  ASSERT_EQ(from.segment_count(), to.segment_count());
  for (const double xi : parameters(from)) {
    EXPECT_CLOSE(to.position(parameter(xi)), map(from.position(xi)), position_tolerance<Q>,
                 scale_of(from) + scale_of(to));
  }
}

template <class P>
class Operations : public testing::Test {};
using Paths = testing::Types<PlanarPath<1>, PlanarPath<4>, SpatialPath<2>, SpatialPath<8>>;
TYPED_TEST_SUITE(Operations, Paths);

const auto same = [](double xi) { return xi; };

TYPED_TEST(Operations, ReversedRunsBackwardsAndTwiceIsTheSamePath) {
  Random random("reversed");
  const auto path = random_path<TypeParam>(random, 4);
  const auto back = reversed(path).value();
  expect_image(
      path, back, [](const auto& p) { return p; }, [](double xi) { return -xi; });
  EXPECT_CLOSE(back.arc_length(), path.arc_length(), position_tolerance<TypeParam>,
               path.arc_length());
  for (const double xi : parameters(path)) {
    if (xi == path.xi_begin()) continue;  // the tangent at a knot is that of the later segment
    EXPECT_CLOSE(tangent(back.template preimage_jet<0>(-xi)),
                 -tangent(path.template preimage_jet<0>(xi)), preimage_tolerance<TypeParam>, 1.0);
  }
  const auto again = reversed(back).value();
  EXPECT_EQ(again.knots(), path.knots());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    EXPECT_EQ(again.segment(k).preimage(), -1.0 * path.segment(k).preimage());
  }
}

TYPED_TEST(Operations, SubpathKeepsPointsPreimageAndParameter) {
  Random random("subpath");
  const auto path = random_path<TypeParam>(random, 4);
  const auto& knots = path.knots();
  const double inside = 0.5 * (knots[1] + knots[2]), later = 0.25 * knots[2] + 0.75 * knots[3];
  const std::vector<std::pair<double, double>> parts = {{path.xi_begin(), path.xi_end()},
                                                        {inside, later},
                                                        {knots[1], knots[3]},
                                                        {inside, knots[2]},
                                                        {knots[1], inside},
                                                        {inside, std::nextafter(inside, later)},
                                                        {path.xi_begin(), inside},
                                                        {inside, path.xi_end()},
                                                        {knots[2], later}};
  for (const auto& [a, b] : parts) {
    const auto part = subpath(path, a, b).value();
    EXPECT_EQ(part.xi_begin(), a);
    EXPECT_EQ(part.xi_end(), b);
    EXPECT_FALSE(part.is_closed());
    EXPECT_CLOSE(part.arc_length(), path.arc_length(b) - path.arc_length(a),
                 position_tolerance<TypeParam>, path.arc_length());
    for (const double u : {0.0, 0.3, 0.8, 1.0}) {
      const double xi = u == 1.0 ? b : a + u * (b - a);
      EXPECT_CLOSE(part.position(xi), path.position(xi), position_tolerance<TypeParam>,
                   scale_of(path));
      if (u < 1.0) {
        // Coefficients are below 2; two runs of de Casteljau double the error of evaluation, and
        // the rounding of ξ moves the local parameter, which meets a derivative below 4n.
        EXPECT_CLOSE(part.preimage(xi), path.preimage(xi),
                     3 * preimage_tolerance<TypeParam> + 8 * TypeParam::preimage_degree, 2.0);
      }
    }
  }
  EXPECT_EQ(subpath(path, path.xi_begin(), path.xi_end()).value(), path);
  EXPECT_EQ(subpath(path, knots[1], knots[3]).value().segment(1), path.segment(2));
}

TYPED_TEST(Operations, SubpathRefusesWhatIsNotInside) {
  Random random("subpath refused");
  const auto path = random_path<TypeParam>(random, 2);
  const double a = path.xi_begin(), b = path.xi_end();
  EXPECT_EQ(subpath(path, a, b + 1).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(subpath(path, a - 1, b).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(subpath(path, not_a_number, b).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(subpath(path, a, infinity).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(subpath(path, b, a).fault().code, FaultCode::not_increasing);
  EXPECT_EQ(subpath(path, a, a).fault().code, FaultCode::not_increasing);
}

TYPED_TEST(Operations, JoinedPartsAreTheWhole) {
  Random random("joined");
  const auto path = random_path<TypeParam>(random, 4, 0);
  for (const double xi : {path.knots()[2], 0.3 * path.knots()[1] + 0.7 * path.knots()[2]}) {
    const auto before = subpath(path, path.xi_begin(), xi).value();
    const auto after = subpath(path, xi, path.xi_end()).value();
    const auto whole = joined(before, after).value();
    EXPECT_EQ(whole.xi_end(), path.xi_end());
    for (const double at : parameters(path)) {
      EXPECT_CLOSE(whole.position(at), path.position(at), position_tolerance<TypeParam>,
                   scale_of(path));
    }
  }
}

TEST(JoinedSpatial, TheFrameContinuesThroughAnyRollAndSign) {
  Random random("joined roll");
  const auto path = random_path<SpatialPath<4>>(random, 4, 2);
  const double xi = path.knots()[2];
  const auto before = subpath(path, path.xi_begin(), xi).value();
  const auto after = subpath(path, xi, path.xi_end()).value();
  const auto further = reparametrised(after, 100.0, 100.0 + (after.xi_end() - xi)).value();
  for (const double half_roll : {0.0, 0.4, 1.5707963267948966, 2.5, -3.0}) {
    const Roll<double> roll{std::cos(half_roll), std::sin(half_roll)};
    std::vector<SpatialPhCurve<4>> segments;
    for (const auto& curve : further.segments()) {
      segments.emplace_back(curve.start(),
                            curve.preimage().mapped([&](const auto& a) { return a * roll; }),
                            curve.parameter_step());
    }
    const auto rolled_after = SpatialPath<4>::create(further.knots(), segments, false).value();
    const auto whole = joined(before, rolled_after).value();
    ASSERT_EQ(whole.segment_count(), 4U);
    for (std::size_t k = 0; k < 4; ++k) {
      // The steps 100 + h lose log₂(100) bits, the roll is two products and a division.
      EXPECT_CLOSE(whole.segment(k).preimage().coefficients(),
                   path.segment(k).preimage().coefficients(), 256.0, 2.0);
    }
  }
}

TEST(JoinedPlanar, TheSignOfThePreimageContinues) {
  Random random("joined sign");
  const auto path = random_path<PlanarPath<3>>(random, 2, 1);
  const auto before = subpath(path, path.xi_begin(), path.knots()[1]).value();
  const auto back = reversed(subpath(path, path.knots()[1], path.xi_end()).value()).value();
  const auto after = reversed(back).value();  // its preimage has the other sign
  const auto whole = joined(before, after).value();
  EXPECT_EQ(whole.segment(1).preimage(), path.segment(1).preimage());
}

TEST(Joined, TakesTheLargerDegree) {
  Random random("joined degrees");
  const auto path = random_path<SpatialPath<2>>(random, 2, 1);
  const auto before = subpath(path, path.xi_begin(), path.knots()[1]).value();
  const auto after = subpath(path, path.knots()[1], path.xi_end()).value();
  const auto whole = joined(before, with_preimage_degree<5>(after).value()).value();
  static_assert(std::is_same_v<decltype(whole), const SpatialPath<5>>);
  for (const double xi : parameters(path)) {
    EXPECT_CLOSE(whole.position(xi), path.position(xi), position_tolerance<SpatialPath<5>>,
                 scale_of(path));
  }
}

TEST(Joined, RefusesAGapACornerAndAStandstill) {
  const auto line = [](Vector2<double> start, Complex<double> w0, Complex<double> w1) {
    BernsteinPolynomial<Complex<double>, 1> w({w0, w1});
    return PlanarPath<1>::create({0.0, 1.0}, {PlanarPhCurve<1>(start, w, 1.0)}, false).value();
  };
  const auto a = line({0, 0}, {1, 0}, {1, 0});
  const auto gap = joined(a, line({2, 0}, {1, 0}, {1, 0}));
  ASSERT_FALSE(gap);
  EXPECT_EQ(gap.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(gap.fault().sentence.find("the path is torn at knot 1: the segments are 1 apart"), 0U)
      << gap.fault().sentence;
  const auto corner = joined(a, line({1, 0}, {1, 1}, {1, 1}));
  ASSERT_FALSE(corner);
  EXPECT_EQ(corner.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(corner.fault().index, 1U);
  EXPECT_NE(corner.fault().sentence.find("meet at an angle of 1.5707963267948966 rad"),
            std::string::npos)
      << corner.fault().sentence;
  const auto back = joined(a, line({1, 0}, {0, 1}, {0, 1}));
  ASSERT_FALSE(back);
  EXPECT_EQ(back.fault().quantity, "tangent");
  const auto standing = joined(a, line({1, 0}, {0, 0}, {1, 0}));
  ASSERT_FALSE(standing);
  EXPECT_EQ(standing.fault().code, FaultCode::zero_speed);
  EXPECT_EQ(standing.fault().sentence.find("the second path stands still at the join"), 0U);
  const auto faster = joined(a, line({1, 0}, {3, 0}, {1, 0}));  // the speed may jump
  EXPECT_TRUE(faster);
  const auto far = reparametrised(a, 0.0, 0x1p60).value();
  EXPECT_EQ(joined(far, line({1, 0}, {1, 0}, {1, 0})).fault().code, FaultCode::not_increasing);
}

TYPED_TEST(Operations, ScaledScalesLengthsAndNotTheParameter) {
  Random random("scaled");
  const auto path = random_path<TypeParam>(random, 3);
  const double tiny = std::ldexp(1.0, -498), huge = std::ldexp(1.0, 498);  // about 1e±150
  for (const double c : {1.0, 2.5, 0.3, tiny, huge}) {
    const auto image = scaled(path, c).value();
    expect_image(
        path, scaled(image, 1 / c).value(), [](const auto& p) { return p; }, same);
    EXPECT_EQ(image.knots(), path.knots());
    EXPECT_CLOSE(image.arc_length(), c * path.arc_length(), position_tolerance<TypeParam>,
                 c * path.arc_length());
  }
  for (const double c : {0.0, -1.0, infinity, not_a_number}) {
    EXPECT_EQ(scaled(path, c).fault().code, FaultCode::outside_domain);
  }
  EXPECT_EQ(scaled(path, -2.0).fault().sentence, "a scale is a finite positive number; got -2");
}

TEST(MovedSpatial, TurnsAndShifts) {
  Random random("moved");
  const auto path = random_path<SpatialPath<3>>(random, 3, 1);
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto q = random.rotation();
    const auto t = random.vector3(repeat < 5 ? 1.0 : 1000.0);
    const auto image = moved(path, q, t).value();
    expect_image(
        path, image, [&](const auto& p) { return sandwich(q, p) + t; }, same);
    for (const double xi : parameters(path)) {
      EXPECT_CLOSE(image.preimage(xi), q * path.preimage(xi), preimage_tolerance<SpatialPath<3>>,
                   2.0);
    }
  }
  EXPECT_EQ(moved(path, {2, 0, 0, 0}, {}).fault().sentence,
            "a rotation is a unit quaternion; this one has length 2");
  EXPECT_EQ(moved(path, {0, 0, 0, 0}, {}).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(moved(path, {not_a_number, 0, 0, 0}, {}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(moved(path, {1, 0, 0, 0}, {0, infinity, 0}).fault().code, FaultCode::not_finite);
}

TEST(MovedPlanar, TurnsCounterClockwiseAndShifts) {
  Random random("moved in the plane");
  const auto path = random_path<PlanarPath<2>>(random, 3);
  const double quarter = std::numbers::pi / 2;
  const auto image = moved(path, quarter, {10, 20}).value();
  expect_image(
      path, image,
      [](const auto& p) {
        return Vector2<double>{10 - p.y, 20 + p.x};
      },
      same);
  EXPECT_EQ(moved(path, infinity, {}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(moved(path, 0.0, {not_a_number, 0}).fault().code, FaultCode::not_finite);
}

TYPED_TEST(Operations, ReflectedMirrorsThePointsAndTwiceIsTheSame) {
  using Point = typename TypeParam::Point;
  Random random("reflected");
  const auto path = random_path<TypeParam>(random, 3);
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto normal = random.components<Point>(repeat == 0 ? std::ldexp(1.0, -600) : 1.0);
    const auto point = random.components<Point>(2.0);
    const auto image = reflected(path, normal, point).value();
    const Point unit = (1.0 / norm((1.0 / largest_component(normal)) * normal)) *
                       ((1.0 / largest_component(normal)) * normal);
    expect_image(
        path, image, [&](const Point& p) { return p - (2 * dot(p - point, unit)) * unit; }, same);
    expect_image(
        path, reflected(image, normal, point).value(), [](const Point& p) { return p; }, same);
  }
  EXPECT_EQ(reflected(path, Point{}, Point{}).fault().sentence,
            "the normal of a mirror must not be zero");
  EXPECT_EQ(reflected(path, Point{infinity}, Point{}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(reflected(path, Point{1}, Point{not_a_number}).fault().code, FaultCode::not_finite);
}

TEST(ReflectedSpatial, TheFrameIsMirroredAndItsThirdAxisTurned) {
  Random random("reflected frame");
  const auto path = random_path<SpatialPath<2>>(random, 1);
  const auto image = reflected(path, {0, 0, 3}, {0, 0, 5}).value();
  const auto mirror = [](const Vector3<double>& v) { return Vector3<double>{v.x, v.y, -v.z}; };
  for (const double xi : parameters(path)) {
    const auto before = euler_rodrigues_frame(path.preimage_jet<0>(xi));
    const auto after = euler_rodrigues_frame(image.preimage_jet<0>(xi));
    const Frame3<double> expected{mirror(before.e1), mirror(before.e2), -mirror(before.e3)};
    EXPECT_CLOSE(after, expected, preimage_tolerance<SpatialPath<2>>, 4.0);
  }
}

TEST(Lifted, LiesInThePlaneWithTheZAxisAsThirdAxis) {
  Random random("lifted");
  const auto path = random_path<PlanarPath<4>>(random, 3);
  const auto image = lifted(path).value();
  for (const double xi : parameters(path)) {
    const auto p = path.position(xi);
    EXPECT_EQ(image.position(xi), (Vector3<double>{p.x, p.y, 0}));
    EXPECT_EQ(image.speed(xi), path.speed(xi));
    const auto frame = euler_rodrigues_frame(image.preimage_jet<0>(xi));
    const auto planar = euler_rodrigues_frame(path.preimage_jet<0>(xi));
    EXPECT_EQ(frame.e1, (Vector3<double>{planar.e1.x, planar.e1.y, 0}));
    EXPECT_EQ(frame.e2.z, 0.0);
    EXPECT_CLOSE(frame.e2.x, planar.e2.x, 4.0, 1.0);
    EXPECT_CLOSE(frame.e3.z, 1.0, 4.0, 1.0);
  }
}

TYPED_TEST(Operations, ElevatedAndReparametrisedAreTheSameCurve) {
  Random random("reparametrised");
  const auto path = random_path<TypeParam>(random, 3);
  const auto elevated = with_preimage_degree<9>(path).value();
  expect_image(
      path, elevated, [](const auto& p) { return p; }, same);

  const auto slow = reparametrised(path, 5.0, 25.0).value();
  EXPECT_EQ(slow.xi_begin(), 5.0);
  EXPECT_EQ(slow.xi_end(), 25.0);
  const double stretch = 20.0 / (path.xi_end() - path.xi_begin());
  EXPECT_CLOSE(slow.arc_length(), path.arc_length(), position_tolerance<TypeParam>,
               path.arc_length());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    EXPECT_CLOSE(slow.segment(k).position(0.4), path.segment(k).position(0.4),
                 position_tolerance<TypeParam>, scale_of(path));
    // Knots up to 25 over steps of about 5 keep the stretch to 8 ε.
    EXPECT_CLOSE(slow.segment(k).speed(0.4), path.segment(k).speed(0.4) / stretch,
                 4 * preimage_tolerance<TypeParam>, 4.0);
  }
  EXPECT_EQ(reparametrised(path, 1.0, 1.0).fault().code, FaultCode::not_increasing);
  EXPECT_EQ(reparametrised(path, 0.0, infinity).fault().code, FaultCode::not_finite);
  EXPECT_EQ(reparametrised(path, 0x1p60, 0x1p60 + 256).fault().code, FaultCode::not_increasing);
}

TEST(WithClosure, ClosesWhatMeetsAndRefusesTheRest) {
  Random random("closure");
  const auto open = random_path<SpatialPath<2>>(random, 2);
  ASSERT_FALSE(with_closure(open, true));
  EXPECT_EQ(with_closure(open, true).fault().code, FaultCode::not_continuous);
  EXPECT_EQ(with_closure(open, false).value(), open);
}

}  // namespace
}  // namespace hodograph
