// SPDX-License-Identifier: MIT
// Random sweeps of every kind: closed, oriented, within the tolerance, and the same surface from
// the exact patches.
#include <gtest/gtest.h>

#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/surface/sweep_mesh.hpp"
#include "support/paths.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

AnyPath random_path(test::Random& random, int kind) {
  const std::size_t segments = 1 + random.index(5);
  switch (kind) {
    case 0:
      return test::random_path<SpatialPath<3>>(random, segments, 1);
    case 1:
      return test::random_path<SpatialPath<8>>(random, segments, 2);
    case 2:
      return test::random_path<PlanarPath<2>>(random, segments, 0);
    default:
      return closed_loop({random.uniform(-2.0, 2.0), random.uniform(-3.0, 3.0)},
                         {random.uniform(0.1, 100.0),
                          {random.uniform(-1000.0, 1000.0), 0.0, 0.0},
                          {1.0, 0.0, 0.0, 0.0}})
          .value();
  }
}

Profile random_profile(test::Random& random, int kind, double size) {
  if (kind == 0) return Profile::circle(size).value();
  if (kind == 1) return Profile::ellipse(size, size * random.uniform(0.1, 1.0)).value();
  std::vector<Vector2<double>> star;
  const std::size_t corners = 3 + random.index(9);
  for (std::size_t k = 0; k < corners; ++k) {
    const double angle =
        2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(corners);
    const double r = size * random.uniform(0.3, 1.0);
    star.push_back({r * std::cos(angle), r * std::sin(angle)});
  }
  return Profile::polygon(star).value();
}

TEST(SweepRandom, MeshesAreClosedOrientedAndWithinTheirTolerance) {
  test::Random random("SweepRandom");
  for (int i = 0; i < 60; ++i) {
    SCOPED_TRACE(i);
    const AnyPath path = random_path(random, i % 4);
    const double size = path.arc_length() * random.uniform(0.002, 0.05);
    const Profile profile = random_profile(random, i % 3, size);
    std::vector<double> scale{1.0};
    if (i % 5 == 0) scale = {1.0, random.uniform(0.3, 2.0), 1.0};
    Motion motion = Motion::along(path, MotionFrame::closing, scale).value();
    if (i % 7 == 0 && !path.is_closed()) {
      const AnyPath spatial = in_space(path);
      const auto roll = rotation_minimising_roll(PreimageTable::of(spatial).value()).value();
      motion = Motion::along(spatial, roll, scale).value();
    }
    const Sweep sweep{motion, profile};
    const double tolerance = size * std::pow(10.0, random.uniform(-3.0, -0.5));
    const auto made = mesh_of(sweep, {tolerance}).value();
    EXPECT_LE(made.deviation, tolerance);
    const MeshFacts facts = facts_of(made.mesh);
    EXPECT_TRUE(facts.is_manifold() && facts.is_closed());
    EXPECT_EQ(facts.euler_characteristic, path.is_closed() ? 0 : 2);
    EXPECT_GT(facts.volume, 0.0);
    for (const auto& p : made.mesh.positions) ASSERT_TRUE(is_finite(p));

    const auto patches = rational_patches(sweep);
    ASSERT_EQ(patches.has_value(), motion.roll() == nullptr);
    if (!patches || profile.circle_radius()) continue;
    const auto& patch = (*patches)[random.index(patches->size())];
    const double v = random.unit(), u = random.unit();
    const double xi = patch.begin_v + v * (patch.end_v - patch.begin_v);
    std::size_t k = 0, side = 0;
    while (k + 1 < motion.pieces().size() && motion.pieces()[k].end <= xi) ++k;
    while (profile.pieces()[side].begin != patch.begin_u) ++side;
    const MotionPiece& piece = motion.pieces()[k];
    const Vector3<double> expected =
        point_of(sweep, k, (xi - piece.begin) / (piece.end - piece.begin), side, u).position;
    EXPECT_LE(largest_component(patch.position(v, u) - expected),
              256 * epsilon<double>() * (largest_component(expected) + path.arc_length()));
  }
}

}  // namespace
}  // namespace hodograph
