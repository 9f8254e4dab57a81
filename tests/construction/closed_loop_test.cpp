// SPDX-License-Identifier: MIT
// Closed loops: the paper's figures and examples with further golden members, the closed-form
// control points, symmetries, planar and limit members, certified regularity, placement, refusals.
#include "hodograph/construction/closed_loop.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/detail/closed_loop_kernel.hpp"
#include "hodograph/frame/frenet.hpp"
#include "hodograph/frame/holonomy.hpp"
#include "hodograph/path/any_operations.hpp"
#include "hodograph/path/bounds.hpp"
#include "hodograph/path/continuity.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double infinity = std::numeric_limits<double>::infinity();
/// Roundings of a coefficient of the preimage (some ten operations and two square roots), and of a
/// control point, a sum of up to seven of their products.
constexpr double preimage_roundings = 32.0, point_roundings = 128.0;
/// The length of the loop of length 1: c0 = 4 - 3 cos ψ ≥ 1 within 4 ε, the sizes of α and β within
/// 6 ε more in the square, their products and the mean of seven within 6 ε (5.5 ε is the most seen
/// on 2·10⁵ members).
constexpr double length_roundings = 16.0;

std::vector<Vector3<double>> control_points(const SpatialPath<3>& path) {
  const auto& curve = path.segment(0);
  std::vector<Vector3<double>> points;
  for (const auto& c : curve.integral().coefficients()) {
    points.push_back(curve.start() + c.displacement);
  }
  return points;
}

/// The largest number that the golden tolerance is relative to, at least 1.
double size_of(const Json& points) {
  double size = 1.0;
  for (const Json& p : points.list()) size = std::max(size, largest_component(p.vector()));
  return size;
}

void expect_points(const std::vector<Vector3<double>>& actual, const Json& expected,
                   double tolerance) {
  ASSERT_EQ(actual.size(), expected.size());
  const double allowed = tolerance * size_of(expected);
  for (std::size_t i = 0; i < actual.size(); ++i) {
    EXPECT_LE(largest_component(actual[i] - expected[i].vector()), allowed) << i;
  }
}

LoopShape golden_shape(const Json& input) { return {input["xi"].number(), input["psi"].number()}; }

TEST(ClosedLoop, MeetsTheGoldenMembers) {
  const Json golden = golden_file("closed_loops.json");
  ASSERT_EQ(golden["loop"].size(), 28U);
  for (const Json& item : golden["loop"].list()) {
    SCOPED_TRACE(item["name"].string());
    const LoopShape shape = golden_shape(item["input"]);
    const Json& expected = item["expected"];
    const double tolerance = item["rel_tol"].number();
    const auto path = closed_loop(shape);
    ASSERT_TRUE(path) << path.fault().sentence;
    expect_points(control_points(*path), expected["control_points"], tolerance);
    const auto& preimage = path->segment(0).preimage();
    for (std::size_t i = 0; i < 4; ++i) {
      const Json &alpha = expected["alpha"][i], &beta = expected["beta"][i];
      const Quaternion<double> a{alpha[0].number(), alpha[1].number(), beta[1].number(),
                                 beta[0].number()};
      EXPECT_LE(largest_component(preimage[i] - a), tolerance * std::max(1.0, norm(a))) << i;
    }
    for (const Json& sample : expected["samples"].list()) {
      const double t = sample["t"].number();
      EXPECT_LE(largest_component(path->position(t) - sample["point"].vector()), tolerance);
      EXPECT_NEAR(path->speed(t), sample["sigma"].number(),
                  tolerance * std::max(1.0, sample["sigma"].number()));
      EXPECT_NEAR(path->arc_length(t), sample["s"].number(), tolerance);
      const auto frenet_state = frenet(*path, t);
      ASSERT_TRUE(frenet_state);
      const double curvature = sample["curvature"].number();
      EXPECT_NEAR(frenet_state->curvature, curvature, tolerance * std::max(1.0, curvature));
      const double torsion = sample["torsion"].number();
      EXPECT_NEAR(frenet_state->torsion, torsion,
                  tolerance * std::max({1.0, std::abs(torsion), curvature}));
      EXPECT_LE(largest_component(frenet_state->frame.e2 - sample["normal"].vector()), tolerance);
    }
    const auto juncture = closed_loop_juncture(shape);
    ASSERT_TRUE(juncture);
    for (const auto& [actual, name] : {std::pair{juncture->curvature, "curvature_0"},
                                       std::pair{juncture->torsion_begin, "torsion_0"},
                                       std::pair{juncture->torsion_end, "torsion_1"}}) {
      const double number = expected[name].number();
      EXPECT_NEAR(actual, number, tolerance * std::max(1.0, std::abs(number))) << name;
    }
  }
}

TEST(ClosedLoop, MeetsTheGoldenLimitMembers) {
  const Json golden = golden_file("closed_loops.json");
  for (const Json& item : golden["limit_loop"].list()) {
    SCOPED_TRACE(item["name"].string());
    const double xi = item["input"]["sign"].number() * infinity;
    const auto path = closed_loop({xi, item["input"]["psi"].number()});
    ASSERT_TRUE(path) << path.fault().sentence;
    const double tolerance = item["rel_tol"].number();
    expect_points(control_points(*path), item["expected"]["control_points"], tolerance);
    // The path nearest to the limit that doubles can name is the limit.
    const auto near = closed_loop(
        {std::copysign(std::numeric_limits<double>::max(), xi), item["input"]["psi"].number()});
    ASSERT_TRUE(near);
    expect_points(control_points(*near), item["expected"]["control_points"], tolerance);
  }
}

TEST(ClosedLoop, MeetsTheGoldenPlacements) {
  const Json golden = golden_file("closed_loops.json");
  for (const Json& item : golden["placement"].list()) {
    SCOPED_TRACE(item["name"].string());
    const Json& in = item["input"];
    const auto frame = frame_towards(in["tangent"].vector(), in["normal"].vector());
    ASSERT_TRUE(frame);
    const auto path =
        closed_loop(golden_shape(in), {in["S"].number(), in["start"].vector(), *frame});
    ASSERT_TRUE(path) << path.fault().sentence;
    expect_points(control_points(*path), item["expected"]["control_points"],
                  item["rel_tol"].number());
    const auto rotation = scaled_frame(*frame);
    const Json& expected = item["expected"]["rotation"];
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_CLOSE(rotation.e1[i], expected[i][0].number(), preimage_roundings, 1.0);
      EXPECT_CLOSE(rotation.e2[i], expected[i][1].number(), preimage_roundings, 1.0);
      EXPECT_CLOSE(rotation.e3[i], expected[i][2].number(), preimage_roundings, 1.0);
    }
  }
}

/// A random member: any, nearly special, or special in one parameter or both.
LoopShape random_shape(Random& random) {
  const double choice = random.unit();
  const double wild = random.spread(-40, 40);
  const double xi = choice < 0.2 ? 0.0 : choice < 0.4 ? wild : random.uniform(-4.0, 4.0);
  const double special = 0.5 * pi * static_cast<double>(random.integer(-2, 2));
  const double psi = random.chance(0.3) ? special : random.uniform(-pi, pi);
  return {xi, psi};
}

TEST(ClosedLoop, HasTheControlPointsInClosedForm) {
  Random random("loop control points");
  for (int i = 0; i < 2000; ++i) {
    const LoopShape shape = random_shape(random);
    SCOPED_TRACE(testing::Message() << "xi " << shape.xi << ", psi " << shape.psi);
    const auto closed_form = closed_loop_control_points(shape);
    ASSERT_TRUE(closed_form);
    const auto integrated = control_points(closed_loop(shape).value());
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_CLOSE(integrated[k], (*closed_form)[k], point_roundings, 1.0) << k;
    }
    EXPECT_CLOSE(closed_loop(shape).value().arc_length(), 1.0, length_roundings, 1.0);
  }
}

/// The jumps of r, r', r'', r''' where the loop closes, over rounding of its coefficients.
TEST(ClosedLoop, ClosesWithTwoDerivativesAndWithTorsionWhereXiVanishes) {
  Random random("loop closing");
  for (int i = 0; i < 500; ++i) {
    LoopShape shape = random_shape(random);
    SCOPED_TRACE(testing::Message() << "xi " << shape.xi << ", psi " << shape.psi);
    const LoopPlacement placement{std::abs(random.spread(-100, 100)), random.vector3(1.0),
                                  random.rotation()};
    const auto path = closed_loop(shape, placement);
    ASSERT_TRUE(path) << path.fault().sentence;
    EXPECT_TRUE(path->is_closed());
    EXPECT_CLOSE(path->arc_length(), placement.length, length_roundings, placement.length);
    // In a placement far from the origin and small, positions round; derivatives do not.
    const auto jumps = continuity(*path).position;
    for (std::size_t r = 0; r < 3; ++r) {
      EXPECT_LE(jumps.jump[r], 8.0 * jumps.allowed[r]) << r;
    }
    shape.xi = 0.0;
    const auto juncture = closed_loop_juncture(shape);
    ASSERT_TRUE(juncture);
    EXPECT_EQ(juncture->torsion_begin, juncture->torsion_end);
    const auto smooth = closed_loop(shape, {placement.length, {}, placement.frame}).value();
    const auto first = frenet(smooth, 0.0), last = frenet(smooth, 1.0);
    ASSERT_TRUE(first && last);
    const double unit = first->curvature;
    EXPECT_CLOSE(first->torsion, last->torsion, 64.0 * point_roundings, unit);
    EXPECT_CLOSE(first->torsion * placement.length, juncture->torsion_begin, 64.0 * point_roundings,
                 unit * placement.length);
  }
}

TEST(ClosedLoop, StaysTwiceContinuousInEveryDegree) {
  // The end is integrated from the preimage: its rounding counts by the size of that, which the
  // loop itself, turning back, does not have.
  Random random("ClosedLoop degrees");
  for (std::size_t i = 0; i < cases<std::size_t>(120); ++i) {
    const AnyPath loop(
        closed_loop({random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0)},
                    {random.uniform(0.1, 10.0), {random.uniform(-1.0, 1.0), 0.0, 0.0}})
            .value());
    for (std::size_t degree = 3; degree <= 12; ++degree) {
      const AnyPath same = with_preimage_degree(loop, degree).value();
      EXPECT_GE(same.visit([](const auto& p) { return continuity(p).position.order(); }), 2)
          << "degree " << degree;
    }
  }
}

TEST(ClosedLoop, TurnsItsTorsionFromEndToEndAsThePaperSays) {
  // (34) and (35).
  Random random("loop torsion");
  for (int i = 0; i < 200; ++i) {
    const LoopShape shape{random.uniform(-3.0, 3.0), random.uniform(-pi, pi)};
    const auto path = closed_loop(shape).value();
    const auto juncture = closed_loop_juncture(shape).value();
    const double unit =
        std::abs(juncture.torsion_begin) + std::abs(juncture.torsion_end) + juncture.curvature;
    EXPECT_CLOSE(frenet(path, 0.0)->torsion, juncture.torsion_begin, 64.0 * point_roundings, unit);
    EXPECT_CLOSE(frenet(path, 1.0)->torsion, juncture.torsion_end, 64.0 * point_roundings, unit);
    EXPECT_CLOSE(frenet(path, 0.0)->curvature, juncture.curvature, point_roundings, unit);
  }
}

Vector3<double> flipped(const Vector3<double>& v, double x, double y, double z) {
  return {x * v.x, y * v.y, z * v.z};
}

TEST(ClosedLoop, HasTheSymmetriesOfTheFamily) {
  Random random("loop symmetries");
  for (int i = 0; i < 500; ++i) {
    const LoopShape shape = random_shape(random);
    SCOPED_TRACE(testing::Message() << "xi " << shape.xi << ", psi " << shape.psi);
    const auto p = control_points(closed_loop(shape).value());
    const auto minus_psi = control_points(closed_loop({shape.xi, -shape.psi}).value());
    const auto minus_xi = control_points(closed_loop({-shape.xi, shape.psi}).value());
    const auto minus_both = control_points(closed_loop({-shape.xi, -shape.psi}).value());
    for (std::size_t k = 0; k < 8; ++k) {
      EXPECT_CLOSE(minus_psi[k], flipped(p[7 - k], -1, 1, 1), point_roundings, 1.0);
      EXPECT_CLOSE(minus_both[k], flipped(p[k], 1, 1, -1), point_roundings, 1.0);
      EXPECT_CLOSE(minus_xi[k], flipped(p[7 - k], -1, 1, -1), point_roundings, 1.0);
    }
  }
}

TEST(ClosedLoop, IsSymmetricWhereTheLemmaSaysSo) {
  // Lemma 2: r(t) = r(1-t) diag(-1, 1, -1) for xi = 0, diag(-1, 1, 1) for psi = 0 or pi, with
  // symmetric speed and curvature and (anti)symmetric torsion; and for no other member.
  Random random("loop lemma 2");
  for (int i = 0; i < 200; ++i) {
    const bool first = random.chance(0.5);
    const LoopShape shape = first ? LoopShape{0.0, random.uniform(-pi, pi)}
                                  : LoopShape{random.uniform(-3.0, 3.0),
                                              pi * static_cast<double>(random.integer(-1, 1))};
    const auto path = closed_loop(shape).value();
    const double t = random.uniform(0.0, 1.0), sign = first ? -1.0 : 1.0;
    EXPECT_CLOSE(path.position(t), flipped(path.position(1.0 - t), -1, 1, sign), point_roundings,
                 1.0);
    EXPECT_CLOSE(path.speed(t), path.speed(1.0 - t), point_roundings, 4.0);
    const auto here = frenet(path, t), there = frenet(path, 1.0 - t);
    if (!here || !there) continue;
    const double size = here->curvature + std::abs(here->torsion) + 1.0;
    // Rates are quotients by powers of the speed and by the square of the curvature.
    const double least = std::min(path.speed(t), 1.0), bend = std::min(here->curvature, 1.0);
    const double amplified = 64.0 * point_roundings / (least * least * least * bend * bend);
    EXPECT_CLOSE(here->curvature, there->curvature, amplified, size);
    EXPECT_CLOSE(here->torsion, (first ? 1.0 : -1.0) * there->torsion, amplified, size);
  }
  // Of the control points p3 and p4, z is even by 6 c0 xi and odd by 36 sin psi + 6 sin 2 psi, over
  // c0 √(105 c0)/w: neither vanishes elsewhere.
  for (int i = 0; i < 200; ++i) {
    const LoopShape shape{random.sign() * random.uniform(0.1, 3.0),
                          random.sign() * random.uniform(0.1, 3.0)};
    const auto p = control_points(closed_loop(shape).value());
    EXPECT_GT(std::abs(p[3].z + p[4].z), 0.01);
    EXPECT_GT(std::abs(p[3].z - p[4].z), 0.01);
  }
}

TEST(ClosedLoop, HasTwoPlanarMembers) {
  const auto eight = closed_loop({0.0, 0.0}).value(), oval = closed_loop({0.0, pi}).value();
  for (int i = 0; i <= 64; ++i) {
    const double t = i / 64.0, bump = t * (1 - t), t2 = t * t;
    const double p0 = -60 * t2 * t2 + 120 * t2 * t - 63 * t2 + 3 * t + 1;
    const double p1 = 8 * t2 * t2 - 16 * t2 * t - 13 * t2 + 21 * t + 7;
    EXPECT_CLOSE(eight.position(t),
                 (Vector3<double>{bump * (0.5 - t) * p0, std::sqrt(52.5) * bump * bump, 0.0}),
                 point_roundings, 1.0);
    EXPECT_CLOSE(oval.position(t),
                 (Vector3<double>{
                     5.0 / 17.0 * bump * (0.5 - t) * p1,
                     -5.0 * std::sqrt(7.0 / 102.0) * bump * bump * (2 * t - 3) * (2 * t + 1), 0.0}),
                 point_roundings, 1.0);
    EXPECT_EQ(eight.position(t).z, 0.0);
    EXPECT_EQ(oval.position(t).z, 0.0);
  }
  // The figure of eight crosses itself at t0.
  const double t0 = 0.5 * (1.0 - std::sqrt((27.0 - std::sqrt(249.0)) / 30.0));
  EXPECT_CLOSE(t0, 0.19421867614883535, 4.0, 1.0);
  EXPECT_CLOSE(eight.position(t0), eight.position(1.0 - t0), point_roundings, 1.0);
  // The oval's speed and its distance from the middle of the circle of length 1, as printed.
  const Extremes speed = speed_extremes(oval, {accuracy::join_error<double>()});
  constexpr double printed = 1e-6;  // half a unit and the digits cut off: six are printed
  EXPECT_TRUE(speed.minimum.contains(0.9375));
  EXPECT_NEAR(speed.maximum.middle(), 1.039541, printed);
  const double radius = 0.5 / pi;
  double least = 2.0, most = 0.0;
  for (int i = 0; i <= 4096; ++i) {
    const auto d = oval.position(i / 4096.0) - Vector3<double>{0.0, radius, 0.0};
    least = std::min(least, std::sqrt(dot(d, d)) / radius);
    most = std::max(most, std::sqrt(dot(d, d)) / radius);
  }
  EXPECT_NEAR(least, 0.964917, printed);
  EXPECT_NEAR(most, 1.057495, printed);
}

TEST(ClosedLoop, HasPlanarLimitMembersWithAStandstill) {
  Random random("loop limits");
  for (int i = 0; i < 100; ++i) {
    const double psi = random.uniform(-pi, pi);
    const double sign = random.chance(0.5) ? 1.0 : -1.0;
    const auto path = closed_loop({sign * infinity, psi}).value();
    // r̂ turned about z by the angle of (37), clockwise for psi > 0 and anticlockwise for psi < 0;
    // for -infinity turned besides by pi about x.
    const double c = (4 * std::cos(psi) - 3) / (4 - 3 * std::cos(psi));
    const double s = std::copysign(std::sqrt(std::max(0.0, 1 - c * c)), psi);
    for (int k = 0; k <= 16; ++k) {
      const double t = k / 16.0, f = 30 * std::pow(t * (1 - t), 3);
      const Vector3<double> expected{f * (2 * t - 1) * c, -sign * f * (2 * t - 1) * s,
                                     sign * f * std::sqrt(7.0) / 3};
      // 1 - c² loses half of the digits where it vanishes.
      const double lost = 1.0 / std::max(std::abs(s), std::sqrt(epsilon<double>()));
      EXPECT_CLOSE(path.position(t), expected, point_roundings + lost, 1.0);
    }
    EXPECT_EQ(path.speed(0.0), 0.0);
    EXPECT_CLOSE(path.arc_length(), 1.0, length_roundings, 1.0);
  }
}

TEST(ClosedLoop, IsCertifiedToBeRegular) {
  Random random("loop regularity");
  for (int i = 0; i < 200; ++i) {
    LoopShape shape = random_shape(random);
    shape.xi = std::clamp(shape.xi, -1e3, 1e3);
    const auto path = closed_loop(shape).value();
    const Extremes speed = speed_extremes(path, {0.01});
    EXPECT_GT(speed.minimum.lower(), 0.0) << shape.xi << " " << shape.psi;
    EXPECT_LE(speed.minimum.lower(), path.speed(random.unit()));
  }
  EXPECT_EQ(speed_extremes(closed_loop({infinity, 1.0}).value(), {0.01}).minimum.lower(), 0.0);
}

TEST(ClosedLoop, TurnsItsFrameByTwicePsi) {
  Random random("loop holonomy");
  for (int i = 0; i < 200; ++i) {
    const LoopShape shape{random.uniform(-3.0, 3.0), random.uniform(-pi, pi)};
    const auto path = closed_loop(shape, {2.0, {}, random.rotation()}).value();
    const auto turn = holonomy(path);
    ASSERT_TRUE(turn);
    EXPECT_CLOSE(std::sin(turn->roll - 2 * shape.psi), 0.0, 64.0, 1.0);
    EXPECT_CLOSE(std::cos(turn->roll - 2 * shape.psi), 1.0, 64.0, 1.0);
  }
}

TEST(ClosedLoop, RunsInWiderScalars) {
  using Wide = long double;
  const loop_detail::Member<Wide> member{1.0L, 1.0L, std::cos(Wide(0.6)), std::sin(Wide(0.6))};
  const SpatialPhCurve<3, Wide> curve({}, loop_detail::canonical_preimage(member), 1.0L);
  const auto closed_form = loop_detail::canonical_control_points(member);
  const auto displacement = curve.displacement();
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_CLOSE(displacement[k], closed_form[k], point_roundings, Wide(1));
  }
}

TEST(ClosedLoop, IsFiniteOrRefusedForHostileNumbers) {
  Random random("hostile loops");
  for (int i = 0; i < 20000; ++i) {
    const LoopShape shape{random.hostile(),
                          random.chance(0.5) ? random.uniform(-pi, pi) : random.hostile()};
    const LoopPlacement placement{random.hostile(),
                                  {random.hostile(), random.hostile(), random.hostile()},
                                  random.rotation()};
    const auto path = closed_loop(shape, placement);
    if (!path) {
      EXPECT_FALSE(path.fault().sentence.empty());
      continue;
    }
    for (const double t : {0.0, 0.3, 0.5, 1.0}) EXPECT_TRUE(is_finite(path->position(t)));
    EXPECT_TRUE(std::isfinite(path->arc_length()));
  }
}

TEST(ClosedLoop, RefusesWhatIsNoLoop) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto code = [](const LoopShape& shape, const LoopPlacement& placement) {
    const auto path = closed_loop(shape, placement);
    EXPECT_FALSE(path);
    return path ? FaultCode::cancelled : path.fault().code;
  };
  const Quaternion<double> one{1.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(code({nan, 1.0}, {}), FaultCode::not_finite);
  EXPECT_EQ(code({0.0, nan}, {}), FaultCode::not_finite);
  EXPECT_EQ(code({0.0, infinity}, {}), FaultCode::not_finite);
  EXPECT_EQ(code({0.0, 3.2}, {}), FaultCode::outside_domain);
  EXPECT_EQ(code({0.0, -108.0}, {}), FaultCode::outside_domain);
  EXPECT_EQ(code({}, {0.0, {}, one}), FaultCode::outside_domain);
  EXPECT_EQ(code({}, {-1.0, {}, one}), FaultCode::outside_domain);
  EXPECT_EQ(code({}, {nan, {}, one}), FaultCode::not_finite);
  EXPECT_EQ(code({}, {infinity, {}, one}), FaultCode::not_finite);
  EXPECT_EQ(code({}, {1.0, {nan, 0.0, 0.0}, one}), FaultCode::not_finite);
  EXPECT_EQ(code({}, {1.0, {}, {}}), FaultCode::outside_domain);
  EXPECT_EQ(code({}, {1.0, {}, {nan, 0.0, 0.0, 0.0}}), FaultCode::not_finite);
  EXPECT_EQ(code({}, {1.0, {}, {1.1, 0.0, 0.0, 0.0}}), FaultCode::outside_domain);
  constexpr double most = std::numeric_limits<double>::max();
  EXPECT_EQ(code({}, {most, {}, one}), FaultCode::not_finite);
  EXPECT_EQ(code({}, {most / 2, {most, 0.0, 0.0}, one}), FaultCode::not_finite);
  EXPECT_FALSE(closed_loop_control_points({nan, 0.0}));
  EXPECT_FALSE(closed_loop_juncture({0.0, 4.0}));
  EXPECT_EQ(closed_loop({0.0, 3.2}).fault().sentence,
            "psi must be in [-pi, pi] (radians); got 3.2");
  EXPECT_TRUE(closed_loop({0.0, -pi}, {std::numeric_limits<double>::min(), {}, one}));
}

TEST(StartFrame, HasTheGivenDirectionAndNormal) {
  Random random("start frames");
  for (int i = 0; i < 2000; ++i) {
    const double size = std::abs(random.spread(-300, 300));
    const double other = std::abs(random.spread(-300, 300));
    const auto turn = scaled_frame(random.rotation());
    const double angle = random.uniform(-pi, pi);
    const auto d = turn.e1;
    const auto n = std::cos(angle) * turn.e2 + std::sin(angle) * turn.e3;
    const auto q = frame_towards(size * d, other * (n + random.uniform(-2.0, 2.0) * d));
    ASSERT_TRUE(q);
    EXPECT_GE(q->w, 0.0);
    EXPECT_CLOSE(dot(*q, *q), 1.0, 8.0, 1.0);
    const auto frame = scaled_frame(*q);
    EXPECT_CLOSE(frame.e1, d, preimage_roundings, 1.0);
    EXPECT_CLOSE(frame.e2, n, preimage_roundings, 1.0);
    const double roll = random.uniform(-pi, pi);
    const auto level = scaled_frame(level_frame(size * d).value());
    EXPECT_CLOSE(level.e2.z, 0.0, 4.0, 1.0);
    const auto rolled = scaled_frame(level_frame(size * d, roll).value());
    EXPECT_CLOSE(rolled.e1, d, preimage_roundings, 1.0);
    EXPECT_CLOSE(rolled.e2, std::cos(roll) * level.e2 + std::sin(roll) * level.e3,
                 preimage_roundings, 1.0);
    EXPECT_GE(level.e3.z, 0.0);
  }
}

TEST(StartFrame, LevelNormalIsToTheLeft) {
  EXPECT_EQ(level_frame({2.0, 0.0, 0.0}).value(), (Quaternion<double>{1.0, 0.0, 0.0, 0.0}));
  const auto up = scaled_frame(level_frame({0.0, 0.0, 3.0}).value());
  EXPECT_CLOSE(up.e1, (Vector3<double>{0, 0, 1}), 8.0, 1.0);
  EXPECT_CLOSE(up.e2, (Vector3<double>{0, 1, 0}), 8.0, 1.0);
  const auto north = scaled_frame(level_frame({0.0, 2.0, 0.0}).value());
  EXPECT_CLOSE(north.e2, (Vector3<double>{-1, 0, 0}), 8.0, 1.0);
}

TEST(StartFrame, RefusesWhatIsNoFrame) {
  const Vector3<double> x{1.0, 0.0, 0.0}, none{};
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(frame_towards(none, x).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(frame_towards(x, none).fault().index, 1U);
  EXPECT_EQ(frame_towards(x, 3.0 * x).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(frame_towards({nan, 0.0, 0.0}, x).fault().code, FaultCode::not_finite);
  EXPECT_EQ(level_frame(none).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(level_frame(x, nan).fault().code, FaultCode::not_finite);
}

}  // namespace
}  // namespace hodograph::test
