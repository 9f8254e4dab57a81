// SPDX-License-Identifier: MIT
// Differential correction and continuation of halo orbits.
#include "hodograph/orbit/periodic_orbit.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hodograph {
namespace {

constexpr long double seconds_per_day = 86400.0L;

long double days(long double time) {
  return time * static_cast<long double>(earth_moon_system.time_unit_s) / seconds_per_day;
}

// The growth over a revolution of these orbits is below 2^4 (their monodromy matrices' entries are
// below 8), so that is how much of a crossing's residual can reach the closure.
constexpr long double closure_bound = 16 * crossing_tolerance;

void expect_closed(const PeriodicOrbit& orbit) {
  EXPECT_EQ(orbit.initial.position.y, 0.0L);
  EXPECT_EQ(orbit.initial.velocity.x, 0.0L);
  EXPECT_EQ(orbit.initial.velocity.z, 0.0L);
  EXPECT_LE(orbit.crossing_residual, crossing_tolerance);
  EXPECT_LE(orbit.closure, closure_bound);
  const auto half = propagate(orbit.system, orbit.initial, 0.5L * orbit.period);
  ASSERT_TRUE(half);
  EXPECT_LE(std::abs(half->state.position.y), crossing_tolerance);
  EXPECT_LE(std::abs(half->state.velocity.x), crossing_tolerance);
  EXPECT_LE(std::abs(half->state.velocity.z), crossing_tolerance);
  const auto turn = propagate(orbit.system, orbit.initial, orbit.period);
  ASSERT_TRUE(turn);
  EXPECT_LE(largest_component(turn->state.position - orbit.initial.position), closure_bound);
  EXPECT_LE(largest_component(turn->state.velocity - orbit.initial.velocity), closure_bound);
}

TEST(PeriodicOrbit, TheCatalogueOrbitCloses) {
  const auto orbit = lunar_gateway_nrho();
  ASSERT_TRUE(orbit) << orbit.fault().sentence;
  expect_closed(*orbit);
  // Recomputed in forty digits elsewhere and printed to fifteen decimals (the last ones to 14):
  // half a unit of the last digit.
  constexpr long double fourteen = 0.5e-14L;  // decimals of x and of the period
  constexpr long double fifteen = 0.5e-15L;   // decimals of vy
  EXPECT_LE(std::abs(orbit->initial.position.x - 1.02731322944525L), fourteen);
  EXPECT_EQ(orbit->initial.position.z, -0.18551533506611556L);
  EXPECT_LE(std::abs(orbit->initial.velocity.y + 0.114498861101236L), fifteen);
  EXPECT_LE(std::abs(orbit->period - 1.58092382295613L), fourteen);
  // JPL three-body periodic orbit catalogue, Earth-Moon halo L2: its own first row and period.
  constexpr long double catalogue = 1e-11L;  // LU, LU/TU, TU: the accuracy the table is held to
  EXPECT_LE(std::abs(orbit->initial.position.x - 1.0273132294452039L), catalogue);
  EXPECT_LE(std::abs(orbit->initial.velocity.y + 0.11449886110106612L), catalogue);
  EXPECT_LE(std::abs(orbit->period - 1.5809238229558025L), catalogue);
  constexpr long double printed_days = 0.0005L;  // 7.008 d to three decimals
  EXPECT_LE(std::abs(days(orbit->period) - 7.008L), printed_days);
}

TEST(PeriodicOrbit, TheResonantOrbitHasTwoNinthsOfASynodicMonth) {
  const auto orbit = synodic_9_2_nrho();
  ASSERT_TRUE(orbit) << orbit.fault().sentence;
  expect_closed(*orbit);
  constexpr long double printed_days = 0.0005L;  // 6.562 d to three decimals
  EXPECT_LE(std::abs(days(orbit->period) - 6.562L), printed_days);
  const long double rounding = 16 * std::numeric_limits<long double>::epsilon();
  EXPECT_LE(std::abs(days(orbit->period) * 4.5L - mean_synodic_month_days), rounding * 32.0L);
  // Still a southern near-rectilinear orbit about the Moon: apolune below, perilune near.
  EXPECT_LT(orbit->initial.position.z, -0.17L);
  EXPECT_LT(orbit->closest_approach_smaller, 0.01L);
  EXPECT_GT(orbit->closest_approach_smaller, 0.005L);
}

TEST(PeriodicOrbit, EveryHeldQuantityLeadsToTheSameOrbit) {
  const auto orbit = lunar_gateway_nrho();
  ASSERT_TRUE(orbit);
  const SymmetricGuess rough{orbit->initial.position.x, orbit->initial.position.z,
                             orbit->initial.velocity.y * 1.001L};
  for (const HeldQuantity held : {HeldQuantity::x, HeldQuantity::z, HeldQuantity::period}) {
    SymmetricGuess guess = rough;
    if (held == HeldQuantity::period) guess.period = orbit->period;
    const auto again = correct_symmetric_orbit(earth_moon_system, guess, held);
    ASSERT_TRUE(again) << again.fault().sentence;
    expect_closed(*again);
    // Where the family is followed by the held quantity, the others are determined by it; the
    // slowest, z by x, changes four times as fast.
    EXPECT_LE(std::abs(again->initial.position.x - orbit->initial.position.x), closure_bound);
    EXPECT_LE(std::abs(again->initial.position.z - orbit->initial.position.z), closure_bound);
    EXPECT_LE(std::abs(again->initial.velocity.y - orbit->initial.velocity.y), closure_bound);
    EXPECT_LE(std::abs(again->period - orbit->period), closure_bound);
  }
}

TEST(PeriodicOrbit, TheMonodromyMatrixHasTheEigenvalueOne) {
  const auto orbit = lunar_gateway_nrho();
  ASSERT_TRUE(orbit);
  // The velocity in phase space comes back: M f = f.
  const Vector3<long double> a = three_body_acceleration(earth_moon_system, orbit->initial);
  const Vector3<long double>& v = orbit->initial.velocity;
  const std::array<long double, 6> flow{v.x, v.y, v.z, a.x, a.y, a.z};
  for (std::size_t i = 0; i < 6; ++i) {
    long double sum = 0.0L;
    for (std::size_t j = 0; j < 6; ++j) sum += orbit->monodromy[i][j] * flow[j];
    EXPECT_LE(std::abs(sum - flow[i]), 8 * closure_bound) << i;
  }
  // This orbit is mildly unstable in one pair and stable in the other. Repeated multiplication
  // finds the eigenvalue of largest modulus, -2.52 against 1: sixty times leave 2.52^-60 < 10^-24.
  std::array<long double, 6> direction{1.0L, 2.0L, 3.0L, 4.0L, 5.0L, 6.0L};
  long double eigenvalue = 0.0L;
  for (int n = 0; n < 80; ++n) {
    std::array<long double, 6> image{};
    std::size_t largest = 0;
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) image[i] += orbit->monodromy[i][j] * direction[j];
      if (std::abs(image[i]) > std::abs(image[largest])) largest = i;
    }
    eigenvalue = image[largest] / direction[largest];
    for (std::size_t i = 0; i < 6; ++i) direction[i] = image[i] / image[largest];
  }
  EXPECT_EQ(orbit->stability_indices[0].imag(), 0.0);
  const long double index = 0.5L * (eigenvalue + 1.0L / eigenvalue);
  EXPECT_LE(std::abs(orbit->stability_indices[0].real() - static_cast<double>(index)),
            4.0 * std::numeric_limits<double>::epsilon());
  EXPECT_LT(index, -1.0L);
  EXPECT_EQ(orbit->stability_indices[1].imag(), 0.0);
  EXPECT_LT(std::abs(orbit->stability_indices[1]), 1.0);
}

TEST(PeriodicOrbit, ContinuationStaysOnItsFamily) {
  const auto orbit = lunar_gateway_nrho();
  ASSERT_TRUE(orbit);
  // At period 3 the planar Lyapunov family is not far; the halo orbit is the one out of the plane.
  const auto larger = continue_to_period(*orbit, 3.0L);
  ASSERT_TRUE(larger) << larger.fault().sentence;
  EXPECT_EQ(larger->period, 3.0L);
  EXPECT_LT(larger->initial.position.z, -0.1L);
  const auto back = continue_to_period(*larger, orbit->period);
  ASSERT_TRUE(back) << back.fault().sentence;
  EXPECT_LE(largest_component(back->initial.position - orbit->initial.position),
            64 * closure_bound);
  // Beyond the end of the family, at the branch off the planar one (period 3.415):
  const auto none = continue_to_period(*orbit, 4.0L);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.fault().code, FaultCode::no_convergence);
  EXPECT_NE(none.fault().sentence.find("the family could be followed from period 1.58092382295613 "
                                       "to 3.4"),
            std::string::npos)
      << none.fault().sentence;
}

TEST(PeriodicOrbit, RefusalsSayWhy) {
  const auto sentence = [](const Result<PeriodicOrbit>& r) {
    return r ? std::string("accepted") : r.fault().sentence;
  };
  const SymmetricGuess good{1.0273L, -0.1855L, -0.1145L, 1.58L};
  SymmetricGuess guess = good;
  guess.vy = std::nanl("");
  EXPECT_EQ(sentence(correct_symmetric_orbit(earth_moon_system, guess, HeldQuantity::z)),
            "the guess's vy is nan; it must be finite");
  guess = good;
  guess.period = -1.0L;
  EXPECT_EQ(sentence(correct_symmetric_orbit(earth_moon_system, guess, HeldQuantity::z)),
            "the period is -1; it must be positive");
  guess.period.reset();
  EXPECT_EQ(sentence(correct_symmetric_orbit(earth_moon_system, guess, HeldQuantity::period)),
            "the period is to be held, but the guess has none; state it");
  guess = good;
  guess.vy = 0.0L;
  EXPECT_NE(sentence(correct_symmetric_orbit(earth_moon_system, guess, HeldQuantity::z))
                .find("the velocity at the crossing of y = 0 is 0; a periodic orbit must leave"),
            std::string::npos);
  CorrectionOptions once;
  once.max_iterations = 1;
  const auto unsettled = correct_symmetric_orbit(earth_moon_system, good, HeldQuantity::z, once);
  EXPECT_NE(sentence(unsettled).find("no periodic orbit found from this guess: the correction did "
                                     "not settle after 1 corrections, with a residual of "),
            std::string::npos)
      << sentence(unsettled);
  EXPECT_EQ(unsettled.fault().code, FaultCode::no_convergence);
  const auto orbit = lunar_gateway_nrho();
  ASSERT_TRUE(orbit);
  EXPECT_EQ(sentence(continue_to_period(*orbit, 0.0L)),
            "the period asked for is 0; it must be positive and finite");
  EXPECT_EQ(sentence(correct_symmetric_orbit({0.9, 1.0, 1.0}, good, HeldQuantity::z)),
            "the mass ratio is 0.9; it is the smaller primary's share of the mass, in (0, 0.5]");
}

TEST(PeriodicOrbit, WildGuessesEndInAFaultOrAnOrbit) {
  CorrectionOptions options;
  options.max_iterations = 10;
  options.propagation.max_steps = 2000;
  for (const long double x : {-3.0L, 0.2L, 1.0L, 1.3L}) {
    for (const long double z : {0.0L, 0.4L}) {
      for (const long double vy : {-2.0L, 0.05L}) {
        const auto orbit =
            correct_symmetric_orbit(earth_moon_system, {x, z, vy, {}}, HeldQuantity::z, options);
        if (orbit) {
          EXPECT_LE(orbit->crossing_residual, crossing_tolerance);
          EXPECT_TRUE(is_finite(orbit->initial.position) && is_finite(orbit->closure));
        } else {
          EXPECT_FALSE(orbit.fault().sentence.empty());
        }
      }
    }
  }
}

}  // namespace
}  // namespace hodograph
