// SPDX-License-Identifier: MIT
// Certified separations: golden values, references in 50 digits that no enclosure may miss, motions
// that meet, stand, follow each other or fly side by side, and the stepping method.
#include "hodograph/planning/swarm/separation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "hodograph/construction/corner.hpp"
#include "hodograph/path/any_path.hpp"
#include "hodograph/path/curvature_limited_timing.hpp"
#include "tests/support/moving_judge.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph {
namespace {

using test::cases;
using test::Random;
using test::Wide;
using test::WideMotion;

constexpr double ulp = std::numeric_limits<double>::epsilon();
constexpr double goal_width = 0x1.0p-30;  // not a tolerance: the default of SeparationGoal

template <class A, std::size_t n>
TimedMotion motion_of(const Path<A, n>& path, const TimingLaw& law, Presence presence = {}) {
  return TimedMotion::create(path, law, presence).value();
}
template <class A, std::size_t n>
TimedMotion at_unit_speed(const Path<A, n>& path, double start = 0.0) {
  return motion_of(path, TimingLaw::constant_speed(path.arc_length(), 1.0, start).value());
}

/// A straight path.
PlanarPath<0> line(const Vector2<double>& from, const Vector2<double>& to) {
  const Vector2<double> d = to - from;
  const double length = norm(d);
  const double angle = 0.5 * std::atan2(d.y, d.x);
  const PlanarPhCurve<0>::Preimage w({Complex<double>{std::cos(angle), std::sin(angle)}});
  return PlanarPath<0>::create({0.0, length}, {{from, w, length}}, false).value();
}

TEST(Separation, AgreesWithTheGoldenValues) {
  const test::Json file = test::golden_file("planar_separation.json");
  ASSERT_EQ(file["separation"].size(), 10u);
  for (const test::Json& entry : file["separation"].list()) {
    SCOPED_TRACE(entry["name"].string());
    const test::Json &in = entry["input"], &expected = entry["expected"];
    const auto a = test::path_of<2>(test::quintic_preimage(in["w_a"]), test::vector2_of(in["p_a"]));
    const auto b = test::path_of<2>(test::quintic_preimage(in["w_b"]), test::vector2_of(in["p_b"]));
    // The golden values end with the shorter path: whoever has arrived is absent.
    const Presence absent{false, false};
    const auto law = [](const auto& path) {
      return TimingLaw::constant_speed(path.arc_length(), 1.0).value();
    };
    const TimedMotion first = motion_of(a, law(a), absent), second = motion_of(b, law(b), absent);
    const double tolerance = entry["rel_tol"].number();
    const Separation found = least_separation(first, second).value();
    const double shorter = std::min(a.arc_length(), b.arc_length());
    EXPECT_LE(found.distance.width(), 2.0 * goal_width * shorter);
    // The reference carries 17 digits.
    const double truth = expected["true_min"].number(), last = 4.0 * ulp * std::max(1.0, truth);
    EXPECT_LE(found.distance.lower(), truth + last);
    EXPECT_GE(found.distance.upper(), truth - last);
    const double at = expected["s_true_min"].number();
    EXPECT_TRUE(found.time_range.lower() <= at + last && at - last <= found.time_range.upper())
        << at;
    EXPECT_EQ(norm(found.first - first.position(found.time)) < 64 * ulp, true);

    const double step = expected["ds"].number();
    const auto stepped = stepped_separation(first, second, step).value();
    EXPECT_TRUE(test::agrees(stepped.sampled, expected["min_sampled"].number(), tolerance));
    EXPECT_EQ(static_cast<double>(stepped.index), expected["k_min"].number());
    EXPECT_TRUE(stepped.distance.lower() <= truth + last &&
                truth - last <= stepped.distance.upper());
    EXPECT_TRUE(test::agrees(stepped.distance.lower(), stepped.sampled - step, tolerance) ||
                stepped.distance.lower() == 0.0);
  }
}

/// A random motion both ways: certified, and in 50 digits.
struct Both {
  TimedMotion motion;
  std::shared_ptr<WideMotion> wide;
};

template <class P>
Both both_of(Random& random, const P& path) {
  const double length = path.arc_length(), start = random.chance(0.5) ? 0.0 : random.uniform(-1, 1);
  const Presence presence{random.chance(0.5), random.chance(0.5)};
  const double speed = std::exp(random.uniform(-0.7, 0.7));
  const TrapezoidalSpeed limits{.cruise_speed = speed,
                                .acceleration = std::exp(random.uniform(-1, 1)),
                                .deceleration = std::exp(random.uniform(-1, 1))};
  TimingLaw law = TimingLaw::constant_speed(length, speed, start).value();
  if (random.chance(0.3)) law = TimingLaw::trapezoidal(length, limits, start).value();
  if (random.chance(0.2)) {
    if (auto limited = curvature_limited_timing(
            path, LateralLimit{.lateral_acceleration = 0.5, .along = limits}, start)) {
      law = *limited;
    }
  }
  return {motion_of(path, law, presence), std::make_shared<WideMotion>(path, law, presence)};
}

Both random_motion(Random& random) {
  switch (random.integer(0, 6)) {
    case 0:
    case 1:
      return both_of(random, test::random_path<PlanarPath<2>>(random, 1));
    case 2:
      return both_of(random, test::random_path<SpatialPath<2>>(random, 3));
    case 3:
      return both_of(random, test::random_path<SpatialPath<8>>(random, 1));
    case 4: {  // cusps, sharp corners at the joins
      const auto wild = [&] { return test::wild_preimage<Complex<double>, 2>(random); };
      std::vector<PlanarPhCurve<2>> curves{{random.vector2(0.5), wild(), 1.0}};
      curves.push_back({curves.back().end(), wild(), 0.5});
      return both_of(random, PlanarPath<2>::create({0.0, 1.0, 1.5}, curves, false).value());
    }
    case 5: {  // a polyline with rounded corners
      const std::vector<Vector2<double>> points{
          {random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2)},
          {1.0, random.uniform(-0.2, 0.2)},
          {random.uniform(0.8, 1.2), 1.0}};
      return both_of(random, rounded_polyline(points, CornerRule{}).value());
    }
    default:
      return both_of(random,
                     line(random.vector2(0.5), Vector2<double>{1.0, 0.5} + random.vector2(0.3)));
  }
}

void check_against_reference(const Both& a, const Both& b, double vertical_scale) {
  SeparationGoal goal;
  goal.vertical_scale = vertical_scale;
  const auto window = common_window(a.motion, b.motion);
  const auto result = least_separation(a.motion, b.motion, goal);
  ASSERT_EQ(window.has_value(), result.has_value());
  if (!window) return;
  const Separation& found = *result;
  const auto coarse = [&](double t) {
    Vector3<double> d = a.motion.position(t) - b.motion.position(t);
    d.z *= vertical_scale;
    return norm(d);
  };
  const auto truth = test::least_wide_distance(*a.wide, *b.wide, window->begin, window->end,
                                               Wide(vertical_scale), coarse);
  EXPECT_LE(Wide(found.distance.lower()), truth.distance);
  EXPECT_GE(Wide(found.distance.upper()), truth.distance);
  // Two roundings of the ends of the enclosure beside what was asked for.
  const double shorter = std::min(a.motion.length(), b.motion.length());
  EXPECT_LE(found.distance.width(), 1e-9 * shorter)  // not a tolerance: what is promised
      << found.evaluations;
  // The time reported is one at which the distance is at most the upper end.
  EXPECT_LE(test::wide_distance(*a.wide, *b.wide, Wide(found.time), Wide(vertical_scale)),
            Wide(found.distance.upper()) + Wide(64 * ulp));
  EXPECT_TRUE(found.time_range.contains(found.time));
  EXPECT_LE(Wide(found.time_range.lower()), truth.time);
  EXPECT_GE(Wide(found.time_range.upper()), truth.time);

  // The threshold form, just below and just above, and far off.
  const double low = found.distance.lower(), high = found.distance.upper();
  const double width = goal_width * shorter;
  EXPECT_NE(separated_by(a.motion, b.motion, low, goal), Answer::no);
  EXPECT_EQ(separated_by(a.motion, b.motion, high + width, goal), Answer::no);
  if (low > 2.0 * width) {
    EXPECT_EQ(separated_by(a.motion, b.motion, low - 2.0 * width, goal), Answer::yes);
    EXPECT_EQ(separated_by(a.motion, b.motion, 0.5 * low, goal), Answer::yes);
  }
  // The stepping method's enclosure holds, too.
  const double step = std::max(window->end - window->begin, 1.0) / 57.0;
  const auto stepped = stepped_separation(a.motion, b.motion, step, goal).value();
  EXPECT_LE(Wide(stepped.distance.lower()), truth.distance);
  EXPECT_GE(Wide(stepped.distance.upper()), truth.distance);
}

TEST(Separation, ContainsTheReferenceIn50Digits) {
  Random random("Separation.ContainsTheReferenceIn50Digits");
  for (int trial = 0; trial < cases(30); ++trial) {
    SCOPED_TRACE(trial);
    const Both a = random_motion(random), b = random_motion(random);
    check_against_reference(a, b, random.chance(0.7) ? 1.0 : std::exp(random.uniform(-1.5, 0.5)));
  }
}

TEST(Separation, IsSymmetricAndMovesWithTime) {
  Random random("Separation.IsSymmetricAndMovesWithTime");
  for (int trial = 0; trial < cases(100); ++trial) {
    const TimedMotion a = random_motion(random).motion, b = random_motion(random).motion;
    const auto one = least_separation(a, b), other = least_separation(b, a);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_EQ(one->distance, other->distance);
    // Both later by a power of two: nothing changes but times, which are rounded.
    const auto later = least_separation(a.delayed(64.0), b.delayed(64.0)).value();
    EXPECT_LE(later.distance.lower(), one->distance.upper());
    EXPECT_GE(later.distance.upper(), one->distance.lower());
    // As late as clocks are (seconds since 1970): the bounds hold, a little wider.
    const auto clock = least_separation(a.delayed(1.8e9), b.delayed(1.8e9)).value();
    const double rounded = 8.0 * 1.8e9 * ulp * (a.law().most_speed() + b.law().most_speed());
    EXPECT_LE(clock.distance.lower(), one->distance.upper() + rounded);
    EXPECT_GE(clock.distance.upper(), one->distance.lower() - rounded);
  }
}

TEST(Separation, OfMotionsThatMeetIsZero) {
  // Two lines that cross, both half-way at the same time.
  const auto a = at_unit_speed(line({-1.0, 0.0}, {1.0, 0.0}));
  const auto b = at_unit_speed(line({0.0, -1.0}, {0.0, 1.0}));
  const Separation found = least_separation(a, b).value();
  EXPECT_EQ(found.distance.lower(), 0.0);
  EXPECT_LE(found.distance.upper(), 2.0 * goal_width * 2.0);
  EXPECT_TRUE(found.time_range.contains(1.0));
  EXPECT_EQ(separated_by(a, b, goal_width * 64.0), Answer::no);
  // The same, one later by 0.5: they pass at distance 0.5/√2, when both are 0.25 from the crossing.
  const Separation passing = least_separation(a, b.delayed(0.5)).value();
  EXPECT_TRUE(passing.distance.contains(0.5 * std::sqrt(0.5)));
  EXPECT_NEAR(passing.time, 1.25, std::sqrt(8.0 * goal_width));  // a minimum is flat
  EXPECT_EQ(separated_by(a, b.delayed(0.5), 0.35), Answer::yes);
  EXPECT_EQ(separated_by(a, b.delayed(0.5), 0.36), Answer::no);
  // Height counts by its scale.
  const SpatialPhCurve<1>::Preimage along({Quaternion<double>{1.0}, Quaternion<double>{1.0}});
  const auto above = SpatialPath<1>::create({0.0, 2.0}, {{{-1.0, 0.0, 3.0}, along, 2.0}}, false);
  SeparationGoal downwash;
  downwash.vertical_scale = 1.0 / 3.0;
  const auto stacked = least_separation(a, at_unit_speed(above.value()), downwash).value();
  EXPECT_TRUE(stacked.distance.contains(1.0));
  EXPECT_LE(stacked.distance.width(), 2.0 * goal_width * 2.0);
}

TEST(Separation, KnowsWhoIsThere) {
  const auto path = line({0.0, 0.0}, {1.0, 0.0});
  const TimingLaw law = TimingLaw::constant_speed(1.0, 1.0).value();
  const TimingLaw late = TimingLaw::constant_speed(1.0, 1.0, 3.0).value();
  const TimedMotion stays = motion_of(path, law), waits = motion_of(path, late);
  // One has arrived where the other will come.
  EXPECT_EQ(least_separation(stays, waits).value().distance.lower(), 0.0);
  EXPECT_TRUE(least_separation(stays, waits).value().time_range.contains(4.0));
  const TimedMotion leaves = motion_of(path, law, {true, false});
  const TimedMotion comes = motion_of(path, late, {false, true});
  const auto never = least_separation(leaves, comes);
  ASSERT_FALSE(never);
  EXPECT_EQ(never.fault().code, FaultCode::outside_domain);
  EXPECT_EQ(never.fault().sentence,
            "the motions have no common time: one ends at 1, the other starts at 3");
  EXPECT_EQ(separated_by(leaves, comes, 100.0), Answer::yes);
  // The first stands at the start of the second's path until it leaves: 0 at time 0.
  const TimedMotion opposite = motion_of(line({1.0, 0.0}, {2.0, 0.0}), late, {false, true});
  EXPECT_TRUE(least_separation(stays, opposite).value().distance.contains(0.0));
  EXPECT_FALSE(least_separation(leaves, opposite));
  // A single common instant.
  const TimedMotion next =
      motion_of(path, TimingLaw::constant_speed(1.0, 1.0, 1.0).value(), {false, true});
  const auto touch = least_separation(leaves, next).value();
  EXPECT_TRUE(touch.distance.contains(1.0));
  EXPECT_EQ(touch.evaluations, 1u);
}

TEST(Separation, OfAFormationIsItsDistance) {
  // The same curve beside itself: the distance is constant, and the enclosure narrow all the same.
  Random random("Separation.OfAFormationIsItsDistance");
  const auto preimage = test::tame_preimage<Complex<double>, 2>(random);
  const auto a = test::path_of<2>(preimage, {0.0, 0.0}),
             b = test::path_of<2>(preimage, {0.0, 0.25});
  const Separation found = least_separation(at_unit_speed(a), at_unit_speed(b)).value();
  EXPECT_TRUE(found.distance.contains(0.25));
  EXPECT_LE(found.distance.width(), 1e-9 * a.arc_length());  // not a tolerance: what is promised
  EXPECT_EQ(found.evaluations, 1u);
  EXPECT_EQ(separated_by(at_unit_speed(a), at_unit_speed(b), 0.24), Answer::yes);
  EXPECT_EQ(separated_by(at_unit_speed(a), at_unit_speed(b), 0.26), Answer::no);
  // One number different in its last digit: found by the search.
  auto other = preimage;
  other[1].re = std::nextafter(other[1].re, 2.0);
  const auto near = test::path_of<2>(other, {0.0, 0.25});
  const Separation searched = least_separation(at_unit_speed(a), at_unit_speed(near)).value();
  EXPECT_GT(searched.evaluations, 1u);
  EXPECT_LT(searched.evaluations, 100000u);
  EXPECT_NEAR(searched.distance.upper(), 0.25, 2.0 * goal_width * a.arc_length());
  EXPECT_LE(searched.distance.width(),
            1e-9 * a.arc_length());  // not a tolerance: what is promised
  // The same curve with another law is no formation.
  const auto slower = motion_of(b, TimingLaw::constant_speed(b.arc_length(), 0.5).value());
  EXPECT_GT(least_separation(at_unit_speed(a), slower).value().evaluations, 1u);
  // Following each other on one path.
  const auto behind = least_separation(at_unit_speed(a), at_unit_speed(a, 0.125)).value();
  EXPECT_LE(behind.distance.upper(), 0.125);
}

TEST(Separation, HoldsOnLongPathsFarFromTheOrigin) {
  Random random("Separation.HoldsOnLongPathsFarFromTheOrigin");
  std::vector<double> knots{0.0};
  std::vector<PlanarPhCurve<2>> first, second;
  Vector2<double> p{4.5e5, 5.2e6}, q{4.5e5 + 3.0, 5.2e6 - 2.0};  // as in a map
  for (int k = 0; k < 200; ++k) {
    knots.push_back(k + 1.0);
    first.push_back({p, test::tame_preimage<Complex<double>, 2>(random), 1.0});
    second.push_back({q, test::tame_preimage<Complex<double>, 2>(random), 1.0});
    p = first.back().end();
    q = second.back().end();
  }
  const auto a = PlanarPath<2>::create(knots, first, false).value();
  const auto b = PlanarPath<2>::create(knots, second, false).value();
  const TimedMotion one = at_unit_speed(a), other = at_unit_speed(b);
  const Separation found = least_separation(one, other).value();
  EXPECT_LE(found.distance.width(),
            1e-9 * std::min(a.arc_length(), b.arc_length()));  // not a tolerance: what is promised
  const auto stepped = stepped_separation(one, other, 0.01).value();
  EXPECT_LE(found.distance.lower(), stepped.sampled);
  EXPECT_LE(stepped.distance.lower(), found.distance.upper());
}

TEST(Separation, FindsThePassages) {
  Random random("Separation.FindsThePassages");
  for (int trial = 0; trial < cases(30); ++trial) {
    const TimedMotion a = random_motion(random).motion, b = random_motion(random).motion;
    const auto window = common_window(a, b);
    if (!window) continue;
    const double distance = random.uniform(0.05, 0.5),
                 resolution = 0x1.0p-12;  // not a tolerance: of time
    const auto passages = close_passages(a, b, distance, resolution).value();
    const Separation least = least_separation(a, b).value();
    if (least.distance.upper() < distance) {
      EXPECT_FALSE(passages.empty());
    }
    if (least.distance.lower() > distance) {
      EXPECT_TRUE(passages.empty());
    }
    double before = -std::numeric_limits<double>::infinity();
    for (const ClosePassage& p : passages) {
      EXPECT_LE(p.begin, p.end);
      EXPECT_LT(before, p.begin);
      before = p.end;
    }
    const double error = a.position_error() + b.position_error();
    for (int k = 0; k <= 500; ++k) {
      const double t =
          std::min(window->begin + (window->end - window->begin) * k / 500.0, window->end);
      const double d = norm(a.position(t) - b.position(t));
      const auto inside = [&] {
        return std::any_of(passages.begin(), passages.end(),
                           [&](const ClosePassage& p) { return p.begin <= t && t <= p.end; });
      };
      if (d + error < distance) {
        EXPECT_TRUE(inside()) << t;
      }
      // Outside by more than what the distance changes in twice the resolution: not reported.
      const double speed = a.law().most_speed() + b.law().most_speed();
      if (d - error > distance + 4.0 * speed * resolution) {
        EXPECT_FALSE(inside()) << t;
      }
    }
  }
}

TEST(Separation, TakesPathsOfAnyType) {
  Random random("Separation.TakesPathsOfAnyType");
  const auto planar = test::random_path<PlanarPath<3>>(random, 2);
  const auto spatial = test::random_path<SpatialPath<6>>(random, 2);
  const auto law = [](const auto& path) {
    return TimingLaw::constant_speed(path.arc_length(), 1.0).value();
  };
  const TimedMotion a = TimedMotion::create(AnyPath(planar), law(planar)).value();
  const TimedMotion b = TimedMotion::create(AnyPath(spatial), law(spatial)).value();
  EXPECT_TRUE(a.is_planar());
  EXPECT_FALSE(b.is_planar());
  EXPECT_EQ(least_separation(a, b).value().distance,
            least_separation(motion_of(planar, law(planar)), motion_of(spatial, law(spatial)))
                .value()
                .distance);
}

TEST(Separation, RefusesBadRequests) {
  const TimedMotion a = at_unit_speed(line({0.0, 0.0}, {1.0, 0.0}));
  SeparationGoal goal;
  goal.relative_width = 0.0;
  EXPECT_EQ(least_separation(a, a, goal).fault().code, FaultCode::outside_domain);
  goal = {};
  goal.vertical_scale = std::nan("");
  EXPECT_EQ(least_separation(a, a, goal).fault().code, FaultCode::not_finite);
  EXPECT_EQ(stepped_separation(a, a, 0.0).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(stepped_separation(a, a, 1.0 / 1e12).fault().quantity, "step");
  EXPECT_EQ(close_passages(a, a, 1.0, -1.0).fault().code, FaultCode::outside_domain);
  const auto wrong = TimedMotion::create(line({0.0, 0.0}, {1.0, 0.0}),
                                         TimingLaw::constant_speed(2.0, 1.0).value());
  EXPECT_EQ(wrong.fault().sentence, "the timing law covers a length of 2; the path is 1 long");
}

// A planar path at an altitude moves as the same path in space does.
TEST(Separation, CountsAltitudes) {
  Random random("planar paths at altitudes");
  for (int i = 0; i < 40; ++i) {
    const auto a = test::random_path<PlanarPath<2>>(random, 2);
    const auto b = test::random_path<PlanarPath<2>>(random, 2);
    const TimingLaw first = TimingLaw::constant_speed(a.arc_length(), 1.0).value();
    const TimingLaw second = TimingLaw::constant_speed(b.arc_length(), 1.0).value();
    const double height = random.uniform(-3, 3);
    const SeparationGoal goal{};
    const TimedMotion level = TimedMotion::create(a, first).value();
    const TimedMotion flat = TimedMotion::create(b, second).value();
    const TimedMotion above = TimedMotion::create(b, second, {}, height).value();
    const Separation beside = least_separation(level, flat, goal).value();
    const Separation over = least_separation(level, above, goal).value();
    // √(d² + h²) of the least distance d in the plane, at the same time.
    const Enclosure expected = sqrt(square(beside.distance) + square(Enclosure(height)));
    EXPECT_LE(over.distance.lower(), expected.upper());
    EXPECT_GE(over.distance.upper(), expected.lower());
    EXPECT_EQ(above.position(0.5 * b.arc_length()).z, height);
  }
  const auto path = test::random_path<SpatialPath<2>>(random, 2);
  const TimingLaw law = TimingLaw::constant_speed(path.arc_length(), 1.0).value();
  EXPECT_EQ(TimedMotion::create(path, law, {}, 1.0).fault().code, FaultCode::unsupported);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(TimedMotion::create(path, law, {}, infinity).fault().code, FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
