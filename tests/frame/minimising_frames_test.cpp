// SPDX-License-Identifier: MIT
// Rotation-minimising frames in one go: against the frames of the roll, within the bounds of both,
// wherever the parameters lie; over knots; faults.
#include "hodograph/frame/minimising_frames.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph::test {
namespace {

// Accuracies asked for, not tolerances: for short and for long series.
constexpr double coarse = 0x1.0p-4;     // not a tolerance
constexpr double moderate = 0x1.0p-20;  // not a tolerance
constexpr double fine = 0x1.0p-30;      // not a tolerance
constexpr double finest = 0x1.0p-36;    // not a tolerance

/// As far apart as the bounds allow: a chord is shorter than its angle; the axes of both are within
/// 2^-49 of orthonormal.
void expect_within(const PreimageTable& path, double accuracy, const std::vector<double>& xi,
                   double begin = 0.0) {
  const FrameRoll roll = rotation_minimising_roll(path, begin).value();
  std::vector<Frame3<double>> frames(xi.size()), expected(xi.size());
  RolledFrames(path, roll).at(xi, expected);
  const auto bound = rotation_minimising_frames(path, accuracy, xi, frames, begin);
  ASSERT_TRUE(bound) << bound.fault().sentence;
  EXPECT_LE(*bound, accuracy);
  const double last_knot = std::abs(path.knots.back()) + std::abs(path.knots.front());
  // ξ itself is known to a rounding, by which the frames turn at their rate.
  const double allowed =
      *bound + roll.error_bound() + epsilon<double>() * (64.0 + 64.0 * last_knot);
  for (std::size_t i = 0; i < xi.size(); ++i) {
    EXPECT_LE(norm(frames[i].e1 - expected[i].e1), 64.0 * epsilon<double>() * (1.0 + last_knot))
        << i;
    EXPECT_LE(norm(frames[i].e2 - expected[i].e2), allowed) << "at " << xi[i];
    EXPECT_LE(norm(frames[i].e3 - expected[i].e3), allowed) << "at " << xi[i];
  }
}

std::vector<double> spread(const PreimageTable& path, std::size_t count) {
  std::vector<double> xi(count);
  const double begin = path.knots.front(), end = path.knots.back();
  for (std::size_t i = 0; i < count; ++i) {
    xi[i] = std::min(end, begin + (end - begin) * static_cast<double>(i) /
                                      static_cast<double>(std::max<std::size_t>(count, 2) - 1));
  }
  return xi;
}

template <std::size_t n>
void expect_everywhere(Random& random, std::size_t segments) {
  const PreimageTable path(random_path<SpatialPath<n>>(random, segments));
  constexpr double accuracies[] = {coarse, moderate, fine, finest};
  for (const double accuracy : accuracies) {
    for (const std::size_t count : {1UL, 2UL, 7UL, 40UL, 700UL}) {
      expect_within(path, accuracy, spread(path, count), random.uniform(-9.0, 9.0));
    }
    expect_within(path, accuracy, path.knots);
    // Crowded together, at the same place, and out of order.
    std::vector<double> crowd(300);
    const double center = random.uniform(path.knots.front(), path.knots.back());
    for (double& x : crowd) {
      x = std::clamp(center + random.uniform(-0.01, 0.01), path.knots.front(), path.knots.back());
    }
    expect_within(path, accuracy, crowd);
    std::sort(crowd.begin(), crowd.end());
    expect_within(path, accuracy, crowd);
    expect_within(path, accuracy, std::vector<double>(20, center));
    expect_within(path, accuracy, {path.knots.back()});
  }
}

TEST(MinimisingFrames, AreThoseOfTheRollWithinTheirBounds) {
  Random random("minimising frames");
  expect_everywhere<1>(random, 5);
  expect_everywhere<2>(random, 1);
  expect_everywhere<2>(random, 9);
  expect_everywhere<3>(random, 3);
  expect_everywhere<4>(random, 2);
  expect_everywhere<5>(random, 2);  // by the roll
  expect_everywhere<8>(random, 2);
}

/// Packs of frames are written whole where later frames follow: never beyond the last.
TEST(MinimisingFrames, AreWrittenWhereTheyWereAskedForAndNowhereElse) {
  Random random("ends of packs");
  const PreimageTable path(random_path<SpatialPath<2>>(random, 3));
  const FrameRoll roll = rotation_minimising_roll(path, 0.0).value();
  const Vector3<double> untouched{-7.0, -8.0, -9.0};
  for (std::size_t count = 1; count <= 40; ++count) {
    const auto xi = spread(path, count);
    const Frame3<double> mark{untouched, untouched, untouched};
    std::vector<Frame3<double>> frames(count + 10, mark), expected(count);
    ASSERT_TRUE(rotation_minimising_frames(path, fine, xi, std::span(frames).first(count)));
    for (std::size_t i = count; i < frames.size(); ++i) {
      EXPECT_EQ(frames[i].e1, untouched);
      EXPECT_EQ(frames[i].e3, untouched);
    }
    RolledFrames(path, roll).at(xi, expected);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_LE(norm(frames[i].e2 - expected[i].e2), 2.0 * fine) << i << " of " << count;
    }
  }
}

TEST(MinimisingFrames, GoRoundClosedLoops) {
  for (const double xi : {0.3, 1.0}) {
    for (const double psi : {0.7, 2.0}) {
      const auto loop = closed_loop({xi, psi}).value();
      for (const double accuracy : {coarse, fine, finest}) {
        expect_within(loop, accuracy, spread(loop, 50));
      }
    }
  }
}

/// The preimage jumps by a factor cos a + i sin a, and in sign: the frame goes on.
TEST(MinimisingFrames, GoOnWhereTheEulerRodriguesFrameJumps) {
  Random random("jumps of the ERF");
  PreimageTable path(random_path<SpatialPath<2>>(random, 6));
  for (std::size_t k = 1; k < path.segment_count(); ++k) {
    const double a = k == 3 ? 0.0 : random.uniform(-3.0, 3.0), sign = k % 2 == 0 ? 1.0 : -1.0;
    // The join is exact first, then turned.
    path.coefficients[3 * k] = path.coefficients[3 * k - 1];
    const Quaternion<double> turn{sign * std::cos(a), sign * std::sin(a), 0.0, 0.0};
    for (std::size_t i = 0; i < 3; ++i) {
      path.coefficients[3 * k + i] = path.coefficients[3 * k + i] * turn;
    }
  }
  for (const std::size_t count : {7UL, 100UL}) expect_within(path, fine, spread(path, count));
}

TEST(MinimisingFrames, KeepTheirBoundOnWildAndOnScaledPreimages) {
  Random random("wild preimages");
  for (int trial = 0; trial < 40; ++trial) {
    PreimageTable path(random_path<SpatialPath<3>>(random, 2));
    const double size = std::ldexp(1.0, static_cast<int>(random.uniform(-300.0, 300.0)));
    for (auto& a : path.coefficients) {
      for (std::size_t c = 1; c < 4; ++c) a[c] *= 3.0;
      a = size * a;
    }
    for (std::size_t i = 0; i < 4; ++i) {
      if (i == 0) path.coefficients[4] = path.coefficients[3];
    }
    expect_within(path, moderate, spread(path, 30));
  }
  // Straight on: no rate at all.
  PreimageTable straight(random_path<SpatialPath<2>>(random, 2));
  for (auto& a : straight.coefficients) a = {2.0, 0.0, 0.0, 0.0};
  expect_within(straight, fine, spread(straight, 30));
}

TEST(MinimisingFrames, RefuseWhatTheRollRefuses) {
  Random random("refusals");
  const PreimageTable path(random_path<SpatialPath<2>>(random, 3));
  const auto xi = spread(path, 10);
  std::vector<Frame3<double>> frames(10);
  const auto code = [&](const auto& result) {
    EXPECT_FALSE(result);
    return result ? FaultCode::unsupported : result.fault().code;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code(rotation_minimising_frames(path, 0.0, xi, frames)), FaultCode::outside_domain);
  EXPECT_EQ(code(rotation_minimising_frames(path, nan, xi, frames)), FaultCode::outside_domain);
  EXPECT_EQ(code(rotation_minimising_frames(path, 0.5, xi, frames, nan)), FaultCode::not_finite);
  for (const double tiny : {epsilon<double>(), std::numeric_limits<double>::denorm_min()}) {
    EXPECT_EQ(code(rotation_minimising_frames(path, tiny, xi, frames)),
              FaultCode::tolerance_not_reached);
  }
  EXPECT_EQ(code(rotation_minimising_frames(path, 0.5, xi, std::span(frames).first(9))),
            FaultCode::mismatched_size);
  for (const double outside : {path.knots.back() + 1.0, path.knots.front() - 1.0, nan}) {
    auto wrong = xi;
    wrong[4] = outside;
    const auto result = rotation_minimising_frames(path, 0.5, wrong, frames);
    EXPECT_EQ(code(result), FaultCode::outside_domain);
    EXPECT_EQ(result.fault().index, 4U);
  }
  const auto nothing = rotation_minimising_frames(path, 0.5, {}, {});
  ASSERT_TRUE(nothing);
  EXPECT_LE(*nothing, 0.5);
  // A corner at a knot, and a preimage that vanishes within a segment.
  PreimageTable corner = path;
  corner.coefficients[3] = Quaternion<double>{0.0, 0.0, 1.0, 0.0} * corner.coefficients[2];
  EXPECT_EQ(code(rotation_minimising_frames(corner, 0.5, xi, frames)), FaultCode::not_continuous);
  PreimageTable still = path;
  for (std::size_t i = 0; i < 3; ++i) {
    still.coefficients[3 + i] = (1.0 - static_cast<double>(i)) * path.coefficients[3];
  }
  still.coefficients[2] = still.coefficients[3];
  still.coefficients[6] = still.coefficients[5];
  EXPECT_EQ(code(rotation_minimising_frames(still, 0.5, xi, frames)), FaultCode::zero_speed);
}

}  // namespace
}  // namespace hodograph::test
