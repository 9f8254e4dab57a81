// SPDX-License-Identifier: MIT
// The certificate of contact is never given where two sections really meet:
// tubes about their path's reach, known from its definition, and random sweeps
// in all frames about the size at which their sections, cut as polygons, first
// meet.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/turn_limited.hpp"
#include "hodograph/path/any_bounds.hpp"
#include "hodograph/surface/sweep_contact.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<MotionState> states_of(const Motion& motion, std::size_t count) {
  std::vector<MotionState> states;
  const std::size_t pieces = motion.pieces().size(), each = (count + pieces - 1) / pieces;
  for (std::size_t k = 0; k < pieces; ++k) {
    for (std::size_t i = 0; i < each; ++i) {
      states.push_back(motion.at(k, (static_cast<double>(i) + 0.5) / static_cast<double>(each)));
    }
  }
  return states;
}

/// The least |d|²/(2 |d - (d·t) t|), d from a point with tangent t to another:
/// from above the reach of a closed path (Federer), whose normal discs of any
/// larger radius meet.
double sampled_reach(const Motion& motion, std::size_t count) {
  const auto states = states_of(motion, count);
  double least = infinity;
  for (const auto& a : states) {
    for (const auto& b : states) {
      const Vector3<double> d = b.position - a.position;
      const double across = norm(d - dot(d, a.frame.e1) * a.frame.e1);
      if (&a != &b && across > 0.0) least = std::min(least, 0.5 * dot(d, d) / across);
    }
  }
  return least;
}

/// The width of a radius: small against the hundredth by which the tests stay away from it.
constexpr double narrow = 1.0 / 4096.0;

TEST(SweepFirstContact, OfTubesIsAtTheReachOfThePath) {
  Random random("tubes about the reach");
  const std::size_t count = cases<std::size_t>(16);
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const LoopShape shape{random.uniform(-2.5, 2.5), random.uniform(0.2, 3.0)};
    const AnyPath path(closed_loop(shape, {random.uniform(0.1, 100.0),
                                           {random.uniform(-1e3, 1e3), 0.0, 0.0},
                                           {1.0, 0.0, 0.0, 0.0}})
                           .value());
    const Motion motion = Motion::along(path).value();
    const double reach = sampled_reach(motion, 300);
    const auto tube = [&](double radius) {
      return contact_of({motion, Profile::circle(radius).value()}).free;
    };
    EXPECT_FALSE(tube(1.0001 * reach));
    EXPECT_FALSE(tube(1.1 * reach));
    EXPECT_FALSE(tube(3.0 * reach));
    // The polygon round the circle is half a percent larger, the samples some
    // thousandth off.
    EXPECT_TRUE(tube(0.98 * reach));
  }
}

using Polygon = std::vector<Vector2<double>>;

/// A convex polygon, counterclockwise, somewhere about the path.
Polygon random_polygon(Random& random) {
  const std::size_t corners = 3 + random.index(4);
  const Vector2<double> middle{random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0)};
  const double first = random.uniform(0.0, 1.0), flat = random.uniform(0.05, 1.0);
  Polygon polygon;
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2.0 * std::numbers::pi * (first + static_cast<double>(k)) / static_cast<double>(corners);
    polygon.push_back({middle.x + std::cos(angle), middle.y + flat * std::sin(angle)});
  }
  return polygon;
}

/// Whether an edge of one section goes through another one, among `states`.
bool sections_meet(const std::vector<MotionState>& states, const Polygon& polygon, double factor) {
  const std::size_t n = polygon.size();
  for (const auto& a : states) {
    for (const auto& b : states) {
      if (&a == &b) continue;
      // Corners of a in the frame of b, over its scale.
      double before = 0.0;
      Vector2<double> last{};
      for (std::size_t k = 0; k <= n; ++k) {
        const Vector2<double>& p = polygon[k % n];
        const double size = a.scale * factor;
        const Vector3<double> x =
            a.position - b.position + size * (p.x * a.frame.e2 + p.y * a.frame.e3);
        const double height = dot(x, b.frame.e1);
        const Vector2<double> at{dot(x, b.frame.e2), dot(x, b.frame.e3)};
        if (k > 0 && before * height < 0.0) {
          const double share = before / (before - height);
          const Vector2<double> hit = (1.0 / (b.scale * factor)) * (last + share * (at - last));
          bool inside = true;
          for (std::size_t j = 0; j < n && inside; ++j) {
            const Vector2<double>& q = polygon[j];
            inside = cross(polygon[(j + 1) % n] - q, hit - q) > 0.0;
          }
          if (inside) return true;
        }
        before = height;
        last = at;
      }
    }
  }
  return false;
}

/// The least factor, to a thousandth, at which sampled sections meet: they
/// really do there.
double first_contact(const std::vector<MotionState>& states, const Polygon& polygon, double low,
                     double high) {
  while (low < high && !sections_meet(states, polygon, low)) low *= 1.5;
  if (low >= high) return infinity;
  double clear = low / 1.5;
  while (low > 1.001 * clear) {
    const double middle = std::sqrt(clear * low);
    (sections_meet(states, polygon, middle) ? low : clear) = middle;
  }
  return low;
}

TEST(SweepFirstContact, OfRandomSweepsInAnyFrameIsNeverExcluded) {
  Random random("first contact of random sweeps");
  std::size_t met = 0, close = 0;
  const std::size_t count = cases<std::size_t>(24);
  for (std::size_t i = 0; i < count; ++i) {
    SCOPED_TRACE(i);
    const AnyPath path =
        i % 3 == 0
            ? AnyPath(closed_loop({random.uniform(-1.5, 1.5), random.uniform(0.5, 2.8)}).value())
        : i % 3 == 1 ? AnyPath(random_path<SpatialPath<2>>(random, 1 + i % 4, 1))
                     : AnyPath(random_path<SpatialPath<4>>(random, 1 + i % 2, 1));
    const PreimageTable table = PreimageTable::of(path).value();
    const std::vector<double> scale =
        i % 4 == 0 ? std::vector<double>{1.0, 0.5, 1.0} : std::vector<double>{1.0};
    const double length = path.arc_length(), span = path.xi_end() - path.xi_begin();
    Result<Motion> motion = Motion::along(path, MotionFrame::closing, scale);
    switch (i % 4) {
      case 0:
        if (!path.is_closed()) {
          motion = Motion::along(path, rotation_minimising_roll(table).value(), scale);
        }
        break;
      case 1:
        motion = Motion::along(path, least_twist_roll(table).value(), scale);
        break;
      case 2:
        if (!path.is_closed()) {
          // Some turns, as of a screw.
          const double turns = random.uniform(-6.0, 6.0) * std::numbers::pi;
          motion = Motion::along(path, FrameRoll::linear(table, 0.3, turns / span), scale);
        }
        break;
      default:
        break;
    }
    ASSERT_TRUE(motion) << motion.fault().sentence;
    const Polygon polygon = random_polygon(random);
    const Sweep sweep{*motion, Profile::polygon(polygon).value()};
    const double first =
        first_contact(states_of(*motion, 90), polygon, length / 1024.0, 3.0 * length);
    if (first == infinity) continue;
    ++met;
    for (const double factor : {1.0, 1.03, 1.3, 2.0, 5.0}) {
      EXPECT_FALSE(contact_of(sweep, factor * first).free) << factor;
    }
    // Not for want of trying: mostly the certificate comes near.
    double certified = 0.0;
    for (const double factor : {0.95, 0.8, 0.5, 0.25}) {
      if (certified == 0.0 && contact_of(sweep, factor * first).free) certified = factor;
    }
    EXPECT_GT(certified, 0.0);
    close += certified >= 0.8 ? 1 : 0;
  }
  EXPECT_GE(met, count * 3 / 4);
  EXPECT_GE(close, met / 2);
}

TEST(SweepFirstContact, OfAWayBackIsAtHalfTheDistance) {
  // From one point to another beside it and back: the sections at the two ends
  // lie in one plane.
  const auto bulb =
      shortest_turn_limited_path({{0.0, 0.0}, {1.0, 0.0}}, {{0.0, 0.3}, {-1.0, 0.0}}, 0.25, {})
          .value();
  const Motion there_and_back = Motion::along(in_space(AnyPath(bulb.path))).value();
  for (const double up : {0.1, 10.0}) {
    const auto reaching = [&](double left) {
      const Polygon p{{-0.1, -up}, {left, -up}, {left, up}, {-0.1, up}};
      return contact_of({there_and_back, Profile::polygon(p).value()}).free;
    };
    EXPECT_TRUE(reaching(0.1499));
    EXPECT_FALSE(reaching(0.1501));
  }
  for (const double apart : {1.0, 2.0, 7.0}) {
    const auto plan =
        shortest_turn_limited_path({{0.0, 0.0}, {1.0, 0.0}}, {{0.0, apart}, {-1.0, 0.0}}, 0.25, {})
            .value();
    const AnyPath path = in_space(AnyPath(plan.path));
    const Motion motion = Motion::along(path).value();
    // Upwards nothing limits a band.
    const auto band = [&](double left, double right, double up) {
      const Polygon p{{-right, -up}, {left, -up}, {left, up}, {-right, up}};
      return contact_of({motion, Profile::polygon(p).value()}).free;
    };
    const double least = largest_tube_radius(path, RangeGoal{narrow}).radius.lower();
    EXPECT_TRUE(band(0.99 * least, 0.99 * least, 50.0)) << apart;
    // To the left, into the bend, it folds just above; on the outside it may go
    // on.
    EXPECT_FALSE(band(1.01 * least, 0.1 * least, 0.1)) << apart;
    EXPECT_TRUE(band(0.5 * least, 20.0, 0.1)) << apart;
  }
}

TEST(SweepFirstContact, HasNoneOnStraightWaysAndIsNotMissedOnNarrowBends) {
  const SpatialPath<0> straight =
      SpatialPath<0>::create(
          {0.0, 1.0},
          {{Vector3<double>{},
            BernsteinPolynomial<Quaternion<double>, 0>({Quaternion<double>{1.0, 0.0, 0.0, 0.0}}),
            1.0}},
          false)
          .value();
  const Motion along = Motion::along(AnyPath(straight)).value();
  EXPECT_TRUE(contact_of({along, Profile::circle(1e6).value()}).free);
  // Screwed round by a hundred turns, too.
  const PreimageTable table = PreimageTable::of(AnyPath(straight)).value();
  const Sweep screw{
      Motion::along(AnyPath(straight), FrameRoll::linear(table, 0.0, 200.0 * std::numbers::pi))
          .value(),
      Profile::polygon(Polygon{{-9.0, -0.1}, {9.0, -0.1}, {9.0, 0.1}, {-9.0, 0.1}}).value()};
  EXPECT_TRUE(contact_of(screw).free);
  // A ribbon without height: to the left it folds at the bend's radius,
  // whatever its frame's unit.
  constexpr double million = 1e6;
  for (const double radius : {1.0 / million, 1.0, million}) {
    const auto plan =
        shortest_turn_limited_path({{0.0, 0.0}, {1.0, 0.0}},
                                   {{4.0 * radius, 4.0 * radius}, {0.0, 1.0}}, radius, {})
            .value();
    const AnyPath path = in_space(AnyPath(plan.path));
    const Motion motion = Motion::along(path).value();
    const double bend = largest_tube_radius(path, RangeGoal{narrow}).radius.lower();
    const auto ribbon = [&](double left, double right) {
      return contact_of({motion, Profile::polyline(Polygon{{-right, 0.0}, {left, 0.0}}).value()})
          .free;
    };
    EXPECT_TRUE(ribbon(0.99 * bend, 5.0 * bend)) << radius;
    EXPECT_FALSE(ribbon(1.01 * bend, 0.0)) << radius;
  }
}

}  // namespace
}  // namespace hodograph::test
