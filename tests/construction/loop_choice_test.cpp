// SPDX-License-Identifier: MIT
// Loops chosen for a purpose: known optima, against brute force on a fine grid, points that lie on
// a loop, boxes that fit and that do not, refusals.
#include "hodograph/construction/loop_choice.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/nearest_point.hpp"
#include "hodograph/path/torsion.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
constexpr RangeGoal goal{0x1.0p-20};  // as fine as loops are chosen
/// What some steps of Newton leave of the distance from a point, over the length.
constexpr double newton = 0x1.0p-30;
/// A coarse bound of the torsion and twice its width, for many loops.
constexpr RangeGoal coarse{0x1.0p-10};

LoopPlacement random_placement(Random& random) {
  return {std::abs(random.spread(-10, 10)), random.vector3(5.0), random.rotation()};
}

bool is_in(const SpatialPath<3>& path, const LoopBox& within) {
  const auto box = bounding_box(path, goal);
  for (std::size_t j = 0; j < 3; ++j) {
    if (box[j].minimum.lower() < within.low[j] || box[j].maximum.upper() > within.high[j]) {
      return false;
    }
  }
  return true;
}

TEST(LoopChoice, OfLeastEnergyAndOfLeastTorsionIsTheOval) {
  const auto energy = choose_loop({}, {}).value();
  EXPECT_EQ(energy.shape, (LoopShape{0.0, pi}));
  constexpr double printed = 5e-3;  // half a unit of the last digit
  EXPECT_NEAR(energy.value.middle(), 39.64, printed);
  EXPECT_EQ(bending_energy_enclosure(energy.path).value(), energy.value);
  LoopWish wish;
  wish.purpose = LoopPurpose::least_torsion_range;
  const auto torsion = choose_loop({2.0, {1.0, 2.0, 3.0}}, wish).value();
  EXPECT_EQ(torsion.shape, (LoopShape{0.0, pi}));
  EXPECT_EQ(torsion.value, Enclosure(0.0));
}

TEST(LoopChoice, WithOneNumberHeldIsAsGoodAsAFineGrid) {
  Random random("loops with one number held");
  for (int i = 0; i < 6; ++i) {
    const double psi = random.uniform(-3.0, 3.0);
    LoopWish wish;
    wish.psi = psi;
    const auto energy = choose_loop({}, wish).value();
    EXPECT_EQ(energy.shape, (LoopShape{0.0, psi}));  // by symmetry
    wish.purpose = LoopPurpose::least_torsion_range;
    const auto torsion = choose_loop({}, wish).value();
    for (int k = -50; k <= 50; ++k) {
      const auto other = closed_loop({0.08 * k, psi}).value();
      const Extremes tau = torsion_extremes(other, coarse);
      EXPECT_LE(torsion.value.lower(),
                (tau.maximum.upper() - tau.minimum.lower()) * (1.0 + 2.0 * coarse.relative_width))
          << 0.08 * k;
    }
  }
}

TEST(LoopChoice, PassesThroughAPointOfALoop) {
  Random random("loops through a point");
  for (int i = 0; i < cases(12); ++i) {
    const LoopPlacement placement = random_placement(random);
    const LoopShape shape{random.uniform(-2.0, 2.0), random.uniform(-pi, pi)};
    const auto loop = closed_loop(shape, placement).value();
    LoopWish wish;
    wish.purpose = LoopPurpose::near_point;
    wish.point = loop.position(random.uniform(0.2, 0.8));
    const auto chosen = choose_loop(placement, wish).value();
    EXPECT_LE(chosen.value.upper(), newton * placement.length);
    EXPECT_LE(nearest_point(chosen.path, wish.point)->distance.lower(), chosen.value.upper());
    EXPECT_EQ(chosen.roll, 0.0);
    // The roll found where it is not known.
    LoopPlacement rolled = placement;
    rolled.frame = placement.frame * Roll<double>{std::cos(1.0), std::sin(1.0)};
    wish.free_roll = true;
    if (i < 3) {
      const auto free = choose_loop(rolled, wish).value();
      EXPECT_LE(free.value.upper(), newton * placement.length);
    }
  }
}

TEST(LoopChoice, NearAPointOutOfReachIsAsGoodAsAFineGrid) {
  Random random("loops near a point");
  for (int i = 0; i < 3; ++i) {
    const LoopPlacement placement{1.0, {}, random.rotation()};
    LoopWish wish;
    wish.purpose = LoopPurpose::near_point;
    wish.point = random.uniform(0.6, 2.0) * random.unit_vector3();  // no loop reaches beyond 1/2
    const auto chosen = choose_loop(placement, wish).value();
    EXPECT_GT(chosen.value.lower(), 0.09);
    for (int a = -12; a <= 12; ++a) {
      for (int b = -12; b <= 12; ++b) {
        const auto other =
            closed_loop({std::tan(std::atan(8.0) * a / 12.0), pi * b / 12.0}, placement).value();
        EXPECT_LE(chosen.value.lower(),
                  nearest_point(other, wish.point)->distance.upper() * (1.0 + goal.relative_width));
      }
    }
  }
}

TEST(LoopChoice, StaysInABox) {
  Random random("loops in a box");
  for (int i = 0; i < 8; ++i) {
    const LoopPlacement placement = random_placement(random);
    const LoopShape shape{random.uniform(-2.0, 2.0), random.uniform(-pi, pi)};
    const auto loop = closed_loop(shape, placement).value();
    const auto box = bounding_box(loop, goal);
    LoopWish wish;
    const double room = 0.002 * placement.length;
    LoopBox within;
    for (std::size_t j = 0; j < 3; ++j) {
      within.low[j] = box[j].minimum.lower() - room;
      within.high[j] = box[j].maximum.upper() + room;
    }
    wish.within = within;
    const auto chosen = choose_loop(placement, wish);
    ASSERT_TRUE(chosen) << chosen.fault().sentence;
    EXPECT_TRUE(is_in(chosen->path, within));
    EXPECT_LE(chosen->value.lower(), bending_energy_enclosure(loop)->upper());
    // A box too small for any loop of this length.
    for (std::size_t j = 0; j < 3; ++j) {
      within.low[j] = placement.start[j] - 0.05 * placement.length;
      within.high[j] = placement.start[j] + 0.05 * placement.length;
    }
    wish.within = within;
    const auto none = choose_loop(placement, wish);
    ASSERT_FALSE(none);
    EXPECT_EQ(none.fault().code, FaultCode::no_interpolant);
    EXPECT_GT(*none.fault().value, 0.0);
  }
}

TEST(LoopChoice, HasTheExtentsOfALoop) {
  Random random("loops of given extents");
  for (int i = 0; i < 6; ++i) {
    const LoopPlacement placement{1.0, random.vector3(5.0), random.rotation()};
    const LoopShape shape{random.uniform(-2.0, 2.0), random.uniform(-pi, pi)};
    const auto box = bounding_box(closed_loop(shape, placement).value(), goal);
    LoopWish wish;
    wish.purpose = LoopPurpose::extents;
    for (std::size_t j = 0; j < 3; ++j) {
      wish.extents[j] = box[j].maximum.middle() - box[j].minimum.middle();
    }
    const auto chosen = choose_loop(placement, wish).value();
    // Three sides by two numbers, from samples: the search ends on the edge of a maximum.
    constexpr double edge = 0x1.0p-12;
    EXPECT_LE(chosen.value.upper(), edge);
  }
}

TEST(LoopChoice, IsTheSameEveryTime) {
  LoopWish wish;
  wish.purpose = LoopPurpose::near_point;
  wish.point = {0.1, 0.3, 0.05};
  const auto first = choose_loop({}, wish).value(), second = choose_loop({}, wish).value();
  EXPECT_EQ(first.shape, second.shape);
  EXPECT_EQ(first.value, second.value);
  EXPECT_EQ(first.evaluations, second.evaluations);
}

TEST(LoopChoice, RefusesWhatIsNoWish) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto code = [](const LoopPlacement& placement, const auto& change) {
    LoopWish wish;
    change(wish);
    const auto chosen = choose_loop(placement, wish);
    EXPECT_FALSE(chosen);
    return chosen ? FaultCode::cancelled : chosen.fault().code;
  };
  const auto nothing = [](LoopWish&) {};
  EXPECT_EQ(code({0.0}, nothing), FaultCode::outside_domain);
  EXPECT_EQ(code({nan}, nothing), FaultCode::not_finite);
  EXPECT_EQ(code({}, [&](LoopWish& w) { w.largest_xi = 0.0; }), FaultCode::outside_domain);
  EXPECT_EQ(code({}, [&](LoopWish& w) { w.largest_xi = nan; }), FaultCode::outside_domain);
  EXPECT_EQ(code({}, [&](LoopWish& w) { w.xi = nan; }), FaultCode::not_finite);
  EXPECT_EQ(code({}, [&](LoopWish& w) { w.xi = infinity; }), FaultCode::not_finite);
  EXPECT_EQ(code({}, [&](LoopWish& w) { w.psi = 7.0; }), FaultCode::outside_domain);
  EXPECT_EQ(code({},
                 [&](LoopWish& w) {
                   w.purpose = LoopPurpose::near_point;
                   w.point.y = nan;
                 }),
            FaultCode::not_finite);
  EXPECT_EQ(code({},
                 [&](LoopWish& w) {
                   w.purpose = LoopPurpose::extents;
                   w.extents.z = -1.0;
                 }),
            FaultCode::outside_domain);
  EXPECT_EQ(code({},
                 [&](LoopWish& w) {
                   w.within = LoopBox{{1, 1, 1}, {2, 2, 2}};
                 }),
            FaultCode::outside_domain);
  EXPECT_EQ(code({},
                 [&](LoopWish& w) {
                   w.within = LoopBox{{nan, 1, 1}, {2, 2, 2}};
                 }),
            FaultCode::not_finite);
}

}  // namespace
}  // namespace hodograph::test
