// SPDX-License-Identifier: MIT
// Rolls of every kind: against quadrature in long double, double reflection and the Frenet frame;
// over knots; near singularities; invariances; refusals.
#include "hodograph/frame/roll.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/lift.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/frenet.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/quadrature.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;

/// ∫ χ₁ over [a, b] in long double: 64 panels of 12 nodes on each segment, exact to its rounding
/// for tame preimages (the nearest zero of σ is 0.1 away, which 1/64 of the segment leaves far
/// behind).
template <std::size_t n>
long double erf_turn(const SpatialPath<n>& path, std::size_t k, double begin, double end) {
  using Wide = long double;
  static const auto rule = gauss_legendre<Wide, 12>();
  const auto preimage = path.segment(k).preimage().mapped(
      [](const Quaternion<double>& a) { return converted<Wide>(a); });
  constexpr int panels = 64;
  Wide total(0);
  const Wide width = (Wide(end) - Wide(begin)) / panels;
  for (int i = 0; i < panels; ++i) {
    for (const auto& [node, weight] : rule) {
      const Wide u = Wide(begin) + width * (static_cast<Wide>(i) + node);
      const auto jet = preimage.template jet<1>(u);
      total += weight * width * 2 * twist_form(jet[0], jet[1]) / dot(jet[0], jet[0]);
    }
  }
  return total;
}

template <std::size_t n>
void expect_minimising(const SpatialPath<n>& path, RollIntegration integration, Random& random) {
  const FrameRoll roll = rotation_minimising_roll(path, 0.3, integration).value();
  // The bounds of series are some hundred roundings of the largest speed over the least, what is
  // allowed to partial fractions 2^13.
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (int i = 0; i <= 200; ++i) {
    const double speed = path.speed(
        std::min(path.xi_end(), path.xi_begin() + (path.xi_end() - path.xi_begin()) * i / 200.0));
    least = std::min(least, speed);
  }
  for (const auto& curve : path.segments()) {
    for (const auto& a : curve.preimage().coefficients()) most = std::max(most, dot(a, a));
  }
  EXPECT_LE(roll.error_bound(), (integration == RollIntegration::series ? 2048 : 32768) *
                                    (most / least) * epsilon<double>() *
                                    static_cast<double>(path.segment_count()));
  const AdaptedFrame frame(path, roll);
  EXPECT_EQ(roll.angle(path.xi_begin()), 0.3);
  long double expected = 0.3L;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const double u = random.unit();
    const double xi = path.xi_of({k, u});
    const double at = path.locate(xi).u;
    EXPECT_LE(std::abs(roll.angle(xi) - static_cast<double>(expected - erf_turn(path, k, 0.0, at))),
              roll.error_bound());
    expected -= erf_turn(path, k, 0.0, 1.0);
    EXPECT_LE(std::abs(roll.angle_at_end(k) - static_cast<double>(expected)), roll.error_bound());

    // No rotation about the tangent: 2 (A' · A i)/σ and its opposite, each some roundings of its
    // terms.
    const auto jet = path.template preimage_jet<1>(xi);
    const double terms = 2.0 * norm(jet[1]) / norm(jet[0]);
    constexpr double roundings = 64;
    EXPECT_LE(std::abs(frame.body_rate_per_xi(xi).x), roundings * epsilon<double>() * terms);
    const auto world = frame.world_rate_per_xi(xi);
    EXPECT_LE(std::abs(dot(world, frame.at(xi).e1)), 4 * roundings * epsilon<double>() * terms);
  }
}

TEST(RotationMinimising, AgreesWithQuadratureAndDoesNotTurnAboutTheTangent) {
  Random random("rotation minimising");
  for (int repeat = 0; repeat < 8; ++repeat) {
    for (const auto integration : {RollIntegration::series, RollIntegration::closed_form}) {
      expect_minimising(random_path<SpatialPath<1>>(random, 3), integration, random);
      expect_minimising(random_path<SpatialPath<2>>(random, 3), integration, random);
      expect_minimising(random_path<SpatialPath<3>>(random, 3), integration, random);
      expect_minimising(random_path<SpatialPath<8>>(random, 2, 3), integration, random);
      expect_minimising(random_path<SpatialPath<12>>(random, 2, 3), integration, random);
    }
  }
}

TEST(RotationMinimising, SaysHowItFoundTheAngle) {
  Random random("methods");
  const auto quintic = random_path<SpatialPath<2>>(random, 1);
  EXPECT_EQ(rotation_minimising_roll(quintic).value().method(0), RollMethod::quadrature);
  const auto closed = rotation_minimising_roll(quintic, 0.0, RollIntegration::closed_form).value();
  EXPECT_EQ(closed.method(0), RollMethod::partial_fractions);
  // Every cubic preimage of degree 1 is helical.
  const auto cubic = random_path<SpatialPath<1>>(random, 1);
  EXPECT_EQ(rotation_minimising_roll(cubic).value().method(0), RollMethod::argument);
  EXPECT_EQ(FrameRoll::none(quintic).method(0), RollMethod::polynomial);
}

/// (33) of the helical paper on a lifted path of several segments: θ = -2 sin(climb) arg w with the
/// continuous argument of the plan's preimage, which is twice round here.
TEST(RotationMinimising, HelicalPathsInClosedForm) {
  for (const double slope : {-2.0, -0.1, 0.3, 5.0}) {
    // A ring is closed, so that its lift is made of its segments twice over.
    const auto once = ring(7);
    std::vector<PlanarPhCurve<1>> segments;
    std::vector<double> knots{0.0};
    for (std::size_t k = 0; k < 14; ++k) {
      const double sign = k < 7 ? 1.0 : -1.0;  // the preimage returns to its negative
      segments.emplace_back(
          k == 0 ? once.segment(0).start() : segments.back().end(),
          once.segment(k % 7).preimage().mapped([&](const Complex<double>& w) { return sign * w; }),
          1.0);
      knots.push_back(static_cast<double>(k + 1));
    }
    const auto plan = PlanarPath<1>::create(knots, segments, false).value();
    const auto path = lifted(plan, 0.0, slope).value();
    const FrameRoll roll = rotation_minimising_roll(path).value();
    const double sine = slope / std::hypot(1.0, slope);
    // Twice round is a turn of 4π of the direction and of 2π of arg w; ring() knows π to 16 digits.
    EXPECT_NEAR(roll.angle(14.0), -2.0 * sine * 2.0 * pi,
                roll.error_bound() + 64 * epsilon<double>());
    for (std::size_t k = 0; k < 14; ++k) EXPECT_EQ(roll.method(k), RollMethod::argument);
  }
}

/// A = p B with a real quadratic p without real zeros: σ = p² |B|² has double roots, where partial
/// fractions lose their digits.
TEST(RotationMinimising, KeepsTheAccuracyThatIsEnough) {
  Random random("accuracy of rolls");
  const auto expect_within = [&](const auto& path, double accuracy) {
    const FrameRoll fine = rotation_minimising_roll(path).value();
    const FrameRoll roll = rotation_minimising_roll_within(path, accuracy).value();
    EXPECT_LE(roll.error_bound(), accuracy);
    std::size_t pieces = 0, fine_pieces = 0;
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      pieces += roll.pieces(k).size();
      fine_pieces += fine.pieces(k).size();
      for (int i = 0; i < 16; ++i) {
        const double xi = path.xi_of({k, random.unit()});
        EXPECT_LE(std::abs(roll.angle(xi) - fine.angle(xi)),
                  roll.error_bound() + fine.error_bound());
      }
    }
    return pieces < fine_pieces;
  };
  int fewer = 0;
  // Asked for: for short and for long series.
  constexpr double accuracies[] = {0x1.0p-6, 0x1.0p-20, 0x1.0p-30, 0x1.0p-36};
  for (const double accuracy : accuracies) {
    fewer += expect_within(random_path<SpatialPath<2>>(random, 3), accuracy) ? 1 : 0;
    fewer += expect_within(random_path<SpatialPath<3>>(random, 20), accuracy) ? 1 : 0;
    fewer += expect_within(random_path<SpatialPath<8>>(random, 2, 3), accuracy) ? 1 : 0;
  }
  EXPECT_GT(fewer, 6);
  const PreimageTable path(random_path<SpatialPath<2>>(random, 3));
  EXPECT_EQ(rotation_minimising_roll_within(path, 0.0).fault().quantity, "accuracy");
  EXPECT_EQ(rotation_minimising_roll_within(path, std::nan("")).fault().code,
            FaultCode::outside_domain);
  const auto finer = rotation_minimising_roll_within(path, epsilon<double>());
  ASSERT_FALSE(finer);
  EXPECT_EQ(finer.fault().code, FaultCode::tolerance_not_reached);
  EXPECT_TRUE(rotation_minimising_roll_within(path, 2.0 * *finer.fault().bound));
}

TEST(RotationMinimising, DoubleRootsOfTheSpeedGoToTheSeries) {
  Random random("double roots");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const BernsteinPolynomial<double, 2> p({0.5, 0.0, 0.5});  // (u - 1/2)² + 1/4
    const auto a = product(p, tame_preimage<Quaternion<double>, 2>(random),
                           [](double x, const Quaternion<double>& q) { return x * q; });
    const auto path = SpatialPath<4>::create({0.0, 1.0}, {{{}, a, 1.0}}, false).value();
    EXPECT_EQ(rotation_minimising_roll(path, 0.0, RollIntegration::closed_form)->method(0),
              RollMethod::quadrature);
    expect_minimising(path, RollIntegration::closed_form, random);
  }
}

template <std::size_t n>
Frame3<double> doubly_reflected(const SpatialPath<n>& path, std::size_t steps) {
  Frame3<double> frame = euler_rodrigues_frame(path.template preimage_jet<0>(path.xi_begin()));
  Vector3<double> place = path.position(path.xi_begin());
  for (std::size_t i = 1; i <= steps; ++i) {
    const double xi = i == steps ? path.xi_end()
                                 : path.xi_begin() + (path.xi_end() - path.xi_begin()) *
                                                         static_cast<double>(i) /
                                                         static_cast<double>(steps);
    const Vector3<double> next = path.position(xi), v1 = next - place;
    const Vector3<double> tangent = euler_rodrigues_frame(path.template preimage_jet<0>(xi)).e1;
    const auto reflected = [](const Vector3<double>& x, const Vector3<double>& v) {
      return x - (2.0 * dot(v, x) / dot(v, v)) * v;
    };
    const Vector3<double> v2 = tangent - reflected(frame.e1, v1);
    frame.e2 = reflected(reflected(frame.e2, v1), v2);
    frame.e1 = tangent;
    place = next;
  }
  frame.e3 = cross(frame.e1, frame.e2);
  return frame;
}

TEST(RotationMinimising, DoubleReflectionConvergesToItWithOrderFour) {
  Random random("double reflection");
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto path = random_path<SpatialPath<3>>(random, 1);
    const FrameRoll roll = rotation_minimising_roll(path).value();
    const auto expected = AdaptedFrame(path, roll).at(path.xi_end());
    double before = 0.0;
    for (const std::size_t steps : {200UL, 400UL}) {
      const double error = norm(doubly_reflected(path, steps).e2 - expected.e2);
      constexpr double fourth_order = 1e-5;  // not a tolerance: what 200 steps at most leave
      EXPECT_LE(error, fourth_order);
      if (before > 0.0) {
        EXPECT_LT(error, before / 12.0);  // 16 in the limit
      }
      before = error;
    }
  }
}

TEST(RotationMinimising, TheFrameGoesOnWhereThePreimageRolls) {
  Random random("knots");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto path = random_path<SpatialPath<3>>(random, 4);
    auto segments = path.segments();
    // The same curve; from the second segment on the preimage is rolled, and by its sign.
    for (std::size_t k = 1; k < 4; ++k) {
      const double half = random.uniform(-3.0, 3.0);
      const Quaternion<double> turn{std::cos(half), std::sin(half), 0.0, 0.0};
      segments[k] =
          SpatialPhCurve<3>(segments[k - 1].end(),
                            segments[k].preimage().mapped([&](const auto& a) { return a * turn; }),
                            segments[k].parameter_step());
    }
    const auto turned = SpatialPath<3>::create(path.knots(), segments, false).value();
    const FrameRoll plain = rotation_minimising_roll(path).value();
    const FrameRoll again = rotation_minimising_roll(turned).value();
    for (int i = 0; i <= 40; ++i) {
      const double xi = path.xi_begin() + (path.xi_end() - path.xi_begin()) * i / 40.0;
      const auto a = AdaptedFrame(path, plain).at(std::min(xi, path.xi_end()));
      const auto b = AdaptedFrame(turned, again).at(std::min(xi, path.xi_end()));
      const double allowed = plain.error_bound() + again.error_bound();
      EXPECT_LE(largest_component(a.e2 - b.e2), allowed + 64 * epsilon<double>());
    }
  }
}

TEST(RotationMinimising, DoesNotDependOnPlaceSizeOrParameter) {
  Random random("invariances");
  for (int repeat = 0; repeat < 10; ++repeat) {
    const auto path = random_path<SpatialPath<3>>(random, 2);
    const FrameRoll roll = rotation_minimising_roll(path, 0.5).value();
    const auto rotation = random.rotation();
    const auto other = moved(path, rotation, {1, 2, 3}).value();
    const auto big = scaled(path, 0x1.0p+200).value();
    for (const double part : {0.0, 0.3, 0.77, 1.0}) {
      const double xi =
          std::min(path.xi_end(), path.xi_begin() + part * (path.xi_end() - path.xi_begin()));
      const double allowed = 4 * roll.error_bound();
      EXPECT_NEAR(rotation_minimising_roll(other, 0.5).value().angle(xi), roll.angle(xi), allowed);
      EXPECT_NEAR(rotation_minimising_roll(big, 0.5).value().angle(xi), roll.angle(xi), allowed);
    }
    // Backwards: the tangent and with it the sense of angles turn round, and so does the way.
    const auto back = reversed(path).value();
    const FrameRoll backwards = rotation_minimising_roll(back).value();
    EXPECT_NEAR(std::abs(backwards.angle_at_end(1) - backwards.angle_at_begin(0)),
                std::abs(roll.angle_at_end(1) - roll.angle_at_begin(0)), 8 * roll.error_bound());
  }
}

TEST(FrenetRoll, AgreesWithTheFrenetFrame) {
  Random random("frenet roll");
  for (int repeat = 0; repeat < 30; ++repeat) {
    const auto path = random_path<SpatialPath<3>>(random, 3);
    const FrameRoll roll = frenet_roll(path).value();
    EXPECT_TRUE(roll.inflections().empty());
    const AdaptedFrame frame(path, roll);
    for (int i = 0; i < 20; ++i) {
      const double xi = random.uniform(path.xi_begin(), path.xi_end());
      const auto state = frenet(path, xi);
      ASSERT_TRUE(state);
      const auto jet = path.preimage_jet<1>(xi);
      const auto v = body_rate_form(jet[0], jet[1]);
      const double loss = norm(jet[0]) * norm(jet[1]) / std::hypot(v.y, v.z);
      constexpr double roundings = 256;
      EXPECT_CLOSE(frame.at(xi), state->frame, roundings, loss);
      const auto rate = frame.body_rate_per_arc_length(xi);
      EXPECT_CLOSE(
          rate.x, state->torsion, roundings * loss,
          std::abs(state->torsion) + state->curvature * loss * norm(jet[1]) / norm(jet[0]));
      EXPECT_CLOSE(rate.z, state->curvature, roundings, loss * state->curvature);
    }
  }
}

/// A planar path with inflections, lifted into space and turned there: its normal changes sides.
TEST(FrenetRoll, ChangesSidesAtInflections) {
  constexpr double nearly_straight = 0x1.0p-20;  // not a tolerance: far above rounding
  Random random("inflections");
  int seen = 0;
  for (int repeat = 0; repeat < 200; ++repeat) {
    // In the plane spanned by the images of i and j the preimage has w and k parts alone.
    BernsteinPolynomial<Quaternion<double>, 2> a;
    const auto rotation = random.rotation();
    for (std::size_t i = 0; i <= 2; ++i) {
      a[i] = rotation *
             Quaternion<double>{1 + random.uniform(-0.5, 0.5), 0, 0, random.uniform(-0.5, 0.5)};
    }
    const auto path = SpatialPath<2>::create({0.0, 2.0}, {{{}, a, 2.0}}, false).value();
    const auto roll = frenet_roll(path);
    ASSERT_TRUE(roll) << roll.fault().sentence;
    // The true inflections: the zeros of the signed curvature, of degree 2.
    const auto normal = [&](double xi) { return AdaptedFrame(path, *roll).at(xi).e2; };
    const Vector3<double> binormal_axis = scaled_frame(rotation).e3;
    for (const auto& inflection : roll->inflections()) {
      ++seen;
      const double step = 0x1.0p-12;  // not a tolerance: how far to either side it is looked
      if (inflection.xi < 2 * step || inflection.xi > 2.0 - 2 * step) continue;
      bool alone = true;
      for (const auto& other : roll->inflections()) {
        if (other.xi != inflection.xi && std::abs(other.xi - inflection.xi) < 4 * step)
          alone = false;
      }
      if (!alone) continue;
      const auto before = normal(inflection.xi - step), after = normal(inflection.xi + step);
      EXPECT_LT(dot(before, after), -0.5);
      if (const auto there = frenet(path, inflection.xi)) {
        EXPECT_LT(there->curvature, nearly_straight);
      }
    }
    // Everywhere the normal is in the plane, and the curve bends towards it.
    for (int i = 0; i < 10; ++i) {
      const double xi = random.uniform(0.0, 2.0);
      const auto r = path.position_derivatives<2>(xi);
      const auto e2 = normal(xi);
      constexpr double across = 0x1.0p-40;  // not a tolerance: far above rounding, far below 1
      EXPECT_LT(std::abs(dot(e2, binormal_axis)), across);
      const double bend = dot(r[2], e2);
      if (norm(cross(r[1], r[2])) > nearly_straight) {
        EXPECT_GT(bend, 0.0);
      }
    }
  }
  EXPECT_GT(seen, 20);
}

TEST(FrenetRoll, RefusesStraightSegments) {
  BernsteinPolynomial<Quaternion<double>, 2> a;
  for (std::size_t i = 0; i <= 2; ++i) a[i] = {1.0 + static_cast<double>(i), 0.5, 0, 0};
  a[1] = {2.0, 1.0, 0, 0};
  const auto path = SpatialPath<2>::create({0.0, 1.0}, {{{}, a, 1.0}}, false).value();
  const auto roll = frenet_roll(path);
  ASSERT_FALSE(roll);
  EXPECT_EQ(roll.fault().code, FaultCode::outside_domain);
  EXPECT_NE(roll.fault().sentence.find("straight"), std::string::npos);
  EXPECT_TRUE(rotation_minimising_roll(path));
}

TEST(PeriodicRoll, ReturnsToItselfAndIsSmoothWhereAsked) {
  Random random("periodic");
  for (int repeat = 0; repeat < 30; ++repeat) {
    const LoopShape shape{random.uniform(-3, 3), random.uniform(-pi, pi)};
    const auto path = closed_loop(shape).value();
    for (const double gamma : {random.uniform(0.05, 20), -random.uniform(0.05, 20)}) {
      const FrameRoll roll = periodic_roll(path, gamma).value();
      EXPECT_NEAR(roll.psi(), shape.psi, 64 * epsilon<double>() * pi);
      const AdaptedFrame frame(path, roll);
      EXPECT_CLOSE(frame.at(1.0), frame.at(0.0), 256, 1.0);
    }
    const auto smooth = smooth_periodic_gammas(path).value();
    EXPECT_LT(smooth.negative, 0.0);
    EXPECT_GT(smooth.positive, 0.0);
    for (const double gamma : {smooth.negative, smooth.positive}) {
      const FrameRoll roll = periodic_roll(path, gamma).value();
      const AdaptedFrame frame(path, roll);
      const double begin = frame.body_rate_per_arc_length(0.0).x;
      const double end = frame.body_rate_per_arc_length(1.0).x;
      const double terms =
          std::abs(roll.derivatives<1>(0.0)[1]) + std::abs(roll.derivatives<1>(1.0)[1]) + 1.0;
      EXPECT_NEAR(begin, end,
                  1024 * epsilon<double>() * terms / std::min(path.speed(0.0), path.speed(1.0)));
    }
    // The paper's equation γ² sin ψ - 3 γ ξ - sin ψ = 0.
    const double s = std::sin(shape.psi), root = std::sqrt(9 * shape.xi * shape.xi + 4 * s * s);
    const double one = (3 * shape.xi + root) / (2 * s), two = (3 * shape.xi - root) / (2 * s);
    EXPECT_CLOSE(smooth.negative, std::min(one, two), 1024, std::abs(one) + std::abs(two));
    EXPECT_CLOSE(smooth.positive, std::max(one, two), 1024, std::abs(one) + std::abs(two));
  }
}

TEST(PeriodicRoll, RefusesWhatHasNone) {
  Random random("periodic faults");
  EXPECT_EQ(periodic_roll(random_path<SpatialPath<3>>(random, 2), 1.0).fault().code,
            FaultCode::unsupported);
  const auto path = closed_loop({1.0, 1.0}).value();
  for (const double gamma : {0.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    const auto roll = periodic_roll(path, gamma);
    ASSERT_FALSE(roll);
    EXPECT_EQ(roll.fault().code, FaultCode::outside_domain);
  }
  // ψ = π: w vanishes for γ > 0; ψ = 0: for γ < 0. No γ is smoother than another.
  const auto oval = closed_loop({1.0, pi}).value();
  EXPECT_FALSE(periodic_roll(oval, 1.0));
  EXPECT_TRUE(periodic_roll(oval, -1.0));
  EXPECT_EQ(smooth_periodic_gammas(oval).fault().code, FaultCode::no_interpolant);
  const auto eight = closed_loop({1.0, 0.0}).value();
  EXPECT_TRUE(periodic_roll(eight, 1.0));
  EXPECT_FALSE(periodic_roll(eight, -1.0));
  EXPECT_TRUE(least_twist_gamma(eight));
  EXPECT_TRUE(least_twist_gamma(oval));
}

TEST(LeastTwist, ClosesTheRotationMinimisingFrame) {
  Random random("least twist");
  for (int repeat = 0; repeat < 30; ++repeat) {
    const auto path = closed_loop({random.uniform(-3, 3), random.uniform(-pi, pi)}).value();
    const FrameRoll roll = least_twist_roll(path, 0.4).value();
    const AdaptedFrame frame(path, roll);
    EXPECT_CLOSE(frame.at(1.0), frame.at(0.0), 256, 1.0 + roll.error_bound() / epsilon<double>());
    EXPECT_LE(std::abs(roll.twist_rate()), pi);  // the length is 1
    for (const double t : {0.0, 0.2, 0.5, 0.9}) {
      EXPECT_NEAR(
          frame.body_rate_per_arc_length(t).x, roll.twist_rate(),
          1024 * epsilon<double>() * (1.0 + std::abs(roll.derivatives<1>(t)[1]) / path.speed(t)));
    }
  }
  // An open path with a given end.
  const auto open = random_path<SpatialPath<3>>(random, 3);
  const FrameRoll minimising = rotation_minimising_roll(open, 0.2).value();
  EXPECT_NEAR(least_twist_roll(open, 0.2).value().angle(open.xi_end()),
              minimising.angle(open.xi_end()), minimising.error_bound());
  const FrameRoll given = least_twist_roll(open, 0.2, 1.0).value();
  EXPECT_NEAR(std::remainder(given.angle(open.xi_end()) - 1.0, 2 * pi), 0.0,
              4 * given.error_bound());
  EXPECT_LE(std::abs(given.twist_rate()) * open.arc_length(), pi);
}

TEST(Roll, FitsBatchesPointByPoint) {
  Random random("rolled frames");
  const auto path = random_path<SpatialPath<3>>(random, 5);
  const std::vector<FrameRoll> rolls{
      FrameRoll::none(path), FrameRoll::linear(path, 0.1, 2.0), frenet_roll(path).value(),
      rotation_minimising_roll(path, 1.0).value(), least_twist_roll(path, 0.0, 2.0).value()};
  std::vector<double> xi;
  for (int i = 0; i <= 500; ++i) {
    xi.push_back(
        std::min(path.xi_end(), path.xi_begin() + (path.xi_end() - path.xi_begin()) * i / 500.0));
  }
  for (int i = 0; i < 100; ++i) xi.push_back(random.uniform(path.xi_begin(), path.xi_end()));
  for (const FrameRoll& roll : rolls) {
    const RolledFrames batch(path, roll);
    std::vector<Frame3<double>> frames(xi.size());
    batch.at(xi, frames);
    const AdaptedFrame frame(path, roll);
    for (std::size_t i = 0; i < xi.size(); ++i) {
      // x is one rounding of ξ apart, by which the frame turns.
      const double rate = norm(frame.body_rate_per_xi(xi[i]));
      EXPECT_CLOSE(frames[i], frame.at(xi[i]), 64, 1.0 + rate * std::abs(xi[i]));
      EXPECT_EQ(batch.at(xi[i]), frames[i]);
    }
  }
  const RolledFrames batch(path, rolls[0]);
  EXPECT_THROW(batch.at(path.xi_end() + 1.0), Error);
  std::vector<Frame3<double>> few(3);
  EXPECT_THROW(batch.at(xi, few), Error);
  const auto other = random_path<SpatialPath<3>>(random, 5);
  EXPECT_THROW(RolledFrames(other, rolls[0]), Error);
}

TEST(Roll, DerivativesAreThoseOfTheAngle) {
  Random random("derivatives");
  const auto path = random_path<SpatialPath<3>>(random, 1);
  for (const FrameRoll& roll :
       {frenet_roll(path).value(), rotation_minimising_roll(path).value(),
        least_twist_roll(path, 0.0, 1.0).value(), FrameRoll::linear(path, 1.0, -2.0)}) {
    const double h = 0x1.0p-13;  // not a tolerance: the step of differences
    for (int i = 0; i < 20; ++i) {
      const double xi = random.uniform(path.xi_begin() + h, path.xi_end() - h);
      const auto at = roll.derivatives<3>(xi);
      const auto before = roll.derivatives<3>(xi - h), after = roll.derivatives<3>(xi + h);
      for (std::size_t r = 0; r < 3; ++r) {
        // Differences of second order: h²/6 times the third derivative, and rounding over h.
        double scale = 1.0;
        for (const double d : at) scale = std::max(scale, std::abs(d));
        EXPECT_NEAR((after[r] - before[r]) / (2 * h), at[r + 1],
                    4096 * h * h * scale * scale * scale);
      }
    }
  }
}

TEST(Roll, HostileInputIsRefusedOrRight) {
  Random random("hostile rolls");
  int made = 0;
  for (int repeat = 0; repeat < 300; ++repeat) {
    // Speeds that come close to zero, exactly zero at an end or inside, of extreme sizes.
    BernsteinPolynomial<Quaternion<double>, 3> a;
    for (std::size_t i = 0; i <= 3; ++i)
      for (std::size_t c = 0; c < 4; ++c) a[i][c] = random.spread(-30, 30);
    const double h =
        std::ldexp(random.uniform(0.5, 1.0), static_cast<int>(random.integer(-60, 60)));
    const auto path = SpatialPath<3>::create({0.0, h}, {{{}, a, h}}, false);
    if (!path) continue;
    for (const auto& roll :
         {rotation_minimising_roll(*path), frenet_roll(*path), least_twist_roll(*path, 0.0, 1.0)}) {
      if (!roll) {
        EXPECT_FALSE(roll.fault().sentence.empty());
        continue;
      }
      ++made;
      for (const double u : {0.0, 0.25, 0.999, 1.0}) {
        EXPECT_TRUE(std::isfinite(roll->angle(std::min(h, u * h))));
      }
      EXPECT_TRUE(std::isfinite(roll->error_bound()));
    }
  }
  EXPECT_GT(made, 100);
  // Zero speed inside: A = (2u - 1) B.
  const auto b = tame_preimage<Quaternion<double>, 1>(random);
  const auto zero = product(BernsteinPolynomial<double, 1>({-1.0, 1.0}), b,
                            [](double x, const Quaternion<double>& q) { return x * q; });
  const auto still = SpatialPath<2>::create({0.0, 1.0}, {{{}, zero, 1.0}}, false).value();
  const auto roll = rotation_minimising_roll(still);
  ASSERT_FALSE(roll);
  EXPECT_EQ(roll.fault().code, FaultCode::zero_speed);
  EXPECT_FALSE(rotation_minimising_roll(still, std::nan("")));
}

TEST(Roll, RefusesBrokenTangents) {
  Random random("broken tangents");
  const auto torn = random_path<SpatialPath<2>>(random, 3, -1);
  const auto roll = rotation_minimising_roll(torn);
  ASSERT_FALSE(roll);
  EXPECT_EQ(roll.fault().code, FaultCode::not_continuous);
  EXPECT_EQ(roll.fault().index, 1U);
  EXPECT_TRUE(frenet_roll(torn));
  EXPECT_THROW((void)frenet_roll(torn)->angle(torn.xi_end() + 1.0), Error);
}

TEST(Roll, ThePlaneHasNone) {
  EXPECT_EQ(PreimageTable::of(AnyPath(ring(5))).fault().code, FaultCode::unsupported);
  Random random("any path");
  const auto path = random_path<SpatialPath<2>>(random, 3);
  const auto table = PreimageTable::of(AnyPath(path)).value();
  EXPECT_EQ(rotation_minimising_roll(table)->angle(path.xi_end()),
            rotation_minimising_roll(path)->angle(path.xi_end()));
}

}  // namespace
}  // namespace hodograph::test
