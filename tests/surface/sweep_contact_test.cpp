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

/// A quintic that bends and twists.
SpatialPath<2> random_bend() {
  BernsteinPolynomial<Quaternion<double>, 2> a;
  a[0] = {1.0, 0.2, 0.1, 0.0};
  a[1] = {0.9, 0.0, 0.3, 0.2};
  a[2] = {1.0, -0.2, 0.2, 0.5};
  return SpatialPath<2>::create({0.0, 1.0}, {{Vector3<double>{}, a, 1.0}}, false).value();
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

TEST(SweepContact, HoldsInFramesThatAreNotRational) {
  const AnyPath path(closed_loop({1.0, 2.0}).value());
  const PreimageTable table = PreimageTable::of(path).value();
  constexpr double width = 0.3, height = 0.06;
  std::size_t certain = 0, refused = 0;
  const AnyPath open_path(random_bend());
  const PreimageTable of_open = PreimageTable::of(open_path).value();
  const Sweep sweeps[] = {
      {Motion::along(path, least_twist_roll(table).value()).value(), rectangle(width, height)},
      {Motion::along(open_path, FrameRoll::linear(of_open, 0.4, 2.0 * std::numbers::pi)).value(),
       rectangle(10.0 * width, 10.0 * height)}};
  for (const Sweep& sweep : sweeps) {
    const double size = sweep.motion.is_closed() ? 1.0 : 10.0;
    for (const double factor : {0.05, 0.2, 0.5, 0.8, 1.0, 1.5, 3.0}) {
      const SweepContact contact = contact_of(sweep, factor);
      const bool meet = sections_meet(sweep, size * width, size * height, factor, 60);
      EXPECT_FALSE(contact.free && meet) << factor;
      certain += contact.free ? 1 : 0;
      refused += meet ? 1 : 0;
    }
  }
  EXPECT_GE(certain, 4U);
  EXPECT_GE(refused, 2U);
  // Rolled by nothing, it is the sweep in the Euler-Rodrigues frame.
  const Sweep still{Motion::along(open_path, FrameRoll::linear(of_open, 0.0, 0.0)).value(),
                    rectangle(0.1, 0.2)};
  EXPECT_EQ(contact_of(still).free, contact_of(along(open_path, rectangle(0.1, 0.2))).free);
}

using Vectors = DynamicPolynomial<Vector3<double>>;
using Quaternions = DynamicPolynomial<Quaternion<double>>;

/// A square of side 1 about the origin in the plane across an axis, carried.
Sweep family(std::size_t normal, const std::vector<Vector3<double>>& position,
             const std::vector<Quaternion<double>>& rotation, const Vector2<double>& off = {}) {
  const std::vector<Vector2<double>> square{{off.x - 0.5, off.y - 0.5},
                                            {off.x + 0.5, off.y - 0.5},
                                            {off.x + 0.5, off.y + 0.5},
                                            {off.x - 0.5, off.y + 0.5}};
  // A polygon is given across e₁; the rotation takes that to the axis wanted.
  const Quaternion<double> to_axis =
      normal == 0 ? Quaternion<double>{1.0, 0.0, 0.0, 0.0} : Quaternion<double>{1.0, 1.0, 1.0, 1.0};
  std::vector<Quaternion<double>> turned;
  for (const auto& q : rotation) turned.push_back(q * to_axis);
  return {Motion::polynomial(Vectors(position), Quaternions(turned), DynamicPolynomial<double>{1.0})
              .value(),
          Profile::polygon(square).value()};
}

TEST(SweepContact, DecidesTubularFamilies) {
  const Quaternion<double> one{1.0, 0.0, 0.0, 0.0};
  // Moved across its plane, either way; within its plane; back to where it was.
  EXPECT_TRUE(contact_of(family(0, {{0, 0, 0}, {2, 0.5, 0}}, {one})).free);
  EXPECT_TRUE(contact_of(family(0, {{0, 0, 0}, {-2, 0.5, 0}}, {one})).free);
  EXPECT_TRUE(contact_of(family(1, {{0, 0, 0}, {0, 2, 0}}, {one})).free);
  EXPECT_FALSE(contact_of(family(0, {{0, 0, 0}, {0, 2, 0}}, {one})).free);
  EXPECT_FALSE(contact_of(family(0, {{0, 0, 0}, {2, 0, 0}, {0, 0, 0}}, {one})).free);
  // A screw about the way it goes: half a turn, w = cos, x = sin of a quarter.
  const Quaternion<double> quarter{1.0, 1.0, 0.0, 0.0};
  EXPECT_TRUE(contact_of(family(0, {{0, 0, 0}, {3, 0, 0}}, {one, quarter})).free);
  // Turned by a quarter about k: as a ring where the axis is outside of it, which c = 0 makes so by
  // the profile's place.
  const Quaternion<double> about_k{1.0, 0.0, 0.0, 1.0};
  EXPECT_TRUE(contact_of(family(0, {{0, 0, 0}}, {one, about_k}, {2.0, 0.0})).free);
  EXPECT_FALSE(contact_of(family(0, {{0, 0, 0}}, {one, about_k}, {0.2, 0.0})).free);
}

}  // namespace
}  // namespace hodograph::test
