// SPDX-License-Identifier: MIT
// Contact of sweeps with themselves: against cross-sections cut in normal planes, against tubes,
// and in cases whose answer is known.
#include "hodograph/surface/sweep_contact.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/turn_limited.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

/// The tube's radius to a thousandth, as the program has it.
constexpr RangeGoal tube_goal{0x1.0p-10};

Profile rectangle(double width, double height) {
  const double x = 0.5 * width, y = 0.5 * height;
  return Profile::polygon(std::vector<Vector2<double>>{{-x, -y}, {x, -y}, {x, y}, {-x, y}}).value();
}

Sweep along(const AnyPath& path, const Profile& profile, const std::vector<double>& scale = {1.0}) {
  const auto frame = path.is_closed() ? MotionFrame::closing : MotionFrame::euler_rodrigues;
  return {Motion::along(path, frame, scale).value(), profile};
}

TubeRadius tube_of(const AnyPath& path) {
  return path.visit([](const auto& p) { return largest_tube_radius(p, tube_goal); });
}

/// Whether some point of a section, by a grid of the rectangle's points, lies inside another one.
bool sections_meet(const Sweep& sweep, double width, double height, double factor, int steps) {
  const double x = 0.5 * factor * width, y = 0.5 * factor * height;
  std::vector<MotionState> states;
  for (int i = 0; i < steps; ++i) states.push_back(sweep.motion.at(0, (i + 0.5) / steps));
  for (const auto& a : states) {
    for (const auto& b : states) {
      if (&a == &b) continue;
      // The line of points of a's rectangle in the plane of b.
      for (int k = 0; k <= 40; ++k) {
        for (const bool across : {false, true}) {
          const double t = (across ? y : x) * (k - 20) / 20.0;
          const Vector3<double> from = a.position + t * (across ? a.frame.e3 : a.frame.e2);
          const Vector3<double>& way = across ? a.frame.e2 : a.frame.e3;
          const double slope = dot(way, b.frame.e1);
          if (slope == 0.0) continue;
          const double s = dot(b.position - from, b.frame.e1) / slope;
          if (std::abs(s) > (across ? x : y)) continue;
          const Vector3<double> off = from + s * way - b.position;
          if (std::abs(dot(off, b.frame.e2)) < x && std::abs(dot(off, b.frame.e3)) < y) return true;
        }
      }
    }
  }
  return false;
}

TEST(SweepContact, CertifiesMoreThanTheTubeAndNoSectionsMeetThere) {
  Random random("contact of sweeps");
  double best = 1.0;
  for (int i = 0; i < 6; ++i) {
    const AnyPath path(closed_loop({random.uniform(-1.5, 1.5), random.uniform(0.5, 2.8)}).value());
    const TubeRadius tube = tube_of(path);
    const double width = random.uniform(0.02, 0.3), height = random.uniform(0.02, 0.3);
    const Sweep sweep = along(path, rectangle(width, height));
    const double factor = largest_free_factor(sweep, tube);
    const double by_tube = tube.radius.lower() / outer_radius(sweep);
    EXPECT_GE(factor, by_tube);
    best = std::max(best, factor / by_tube);
    EXPECT_FALSE(sections_meet(sweep, width, height, factor, 120));
    EXPECT_FALSE(contact_of(sweep, 64.0).free);
    // A fold that is certain is never certified.
    const Sweep large = along(path, rectangle(16.0 * width, 16.0 * height));
    if (fold_of(large).kind == SweepFold::Kind::certain) {
      EXPECT_FALSE(contact_of(large).free);
    }
  }
  EXPECT_GT(best, 1.1);
}

TEST(SweepContact, DependsOnTheDirectionAtABend) {
  // Round a quarter turn of radius 1, legs of 4: (tangent, left normal, k).
  const auto plan =
      shortest_turn_limited_path({{0.0, 0.0}, {1.0, 0.0}}, {{5.0, 5.0}, {0.0, 1.0}}, 1.0, {})
          .value();
  const AnyPath path = in_space(AnyPath(plan.path));
  const double radius = tube_of(path).radius.lower();
  // Tall and thin: no limit but that across the bend. A wide one folds on the inner side.
  EXPECT_TRUE(contact_of(along(path, rectangle(radius, 100.0 * radius))).free);
  EXPECT_FALSE(contact_of(along(path, rectangle(100.0 * radius, radius))).free);
  // A band outside of the bend only.
  const std::vector<Vector2<double>> outside{
      {-8.0 * radius, -0.1}, {0.0, -0.1}, {0.0, 0.1}, {-8.0 * radius, 0.1}};
  const std::vector<Vector2<double>> inside{
      {0.0, -0.1}, {8.0 * radius, -0.1}, {8.0 * radius, 0.1}, {0.0, 0.1}};
  EXPECT_TRUE(contact_of(along(path, Profile::polygon(outside).value())).free);
  EXPECT_FALSE(contact_of(along(path, Profile::polygon(inside).value())).free);
}

TEST(SweepContact, LetsATubeBeThickWhereThePathIsStraight) {
  const auto plan =
      shortest_turn_limited_path({{0.0, 0.0}, {1.0, 0.0}}, {{9.0, 3.0}, {0.0, 1.0}}, 0.5, {})
          .value();
  const AnyPath path = in_space(AnyPath(plan.path));
  const TubeRadius tube = tube_of(path);
  const double radius = tube.radius.lower();
  const Sweep tapered = along(path, Profile::circle(1.0).value(), {2.0 * radius, 0.4 * radius});
  EXPECT_FALSE(is_certainly_free(tapered, tube));
  EXPECT_TRUE(contact_of(tapered).free);
  EXPECT_FALSE(contact_fault(tapered, tube));
  const Sweep thick = along(path, Profile::circle(1.0).value(), {0.4 * radius, 2.0 * radius});
  EXPECT_FALSE(contact_of(thick).free);
}

TEST(SweepContact, AsksForARationalFrameAndAPathItIsAdaptedTo) {
  const AnyPath path(closed_loop({1.0, 2.0}).value());
  const PreimageTable table = PreimageTable::of(path).value();
  const Sweep turned{Motion::along(path, least_twist_roll(table).value()).value(),
                     rectangle(0.01, 0.01)};
  EXPECT_FALSE(contact_of(turned).free);
}

}  // namespace
}  // namespace hodograph::test
