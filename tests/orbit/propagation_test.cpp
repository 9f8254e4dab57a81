// SPDX-License-Identifier: MIT
// Following a motion: what it conserves, what its first variation says, what is refused.
#include "hodograph/orbit/propagation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace hodograph {
namespace {

using State = OrbitState<long double>;

constexpr long double eps = std::numeric_limits<long double>::epsilon();

// The near-rectilinear halo orbit of the JPL catalogue, one revolution.
const State apolune{{1.02731322944525L, 0.0L, -0.18551533506611556L},
                    {0.0L, -0.114498861101236L, 0.0L}};
constexpr long double period = 1.58092382295613L;

// One revolution takes at most 1000 steps of local error 16 eps; nothing grows by more than 2^8 on
// the way (the transition matrices between any two of its points stay below).
constexpr long double revolution_error = 1000 * 16 * 256 * eps;

TEST(Propagation, ConservesTheJacobiConstant) {
  const long double before = jacobi_constant(earth_moon_system, apolune);
  for (const long double part : {0.25L, 0.5L, 0.75L, 1.0L, -0.5L}) {
    const auto result = propagate(earth_moon_system, apolune, part * period);
    ASSERT_TRUE(result) << result.fault().sentence;
    EXPECT_LE(std::abs(jacobi_constant(earth_moon_system, result->state) - before),
              revolution_error);
  }
}

TEST(Propagation, GoesBackTheWayItCame) {
  const auto there = propagate(earth_moon_system, apolune, 0.5L * period);
  ASSERT_TRUE(there);
  const auto back = propagate(earth_moon_system, there->state, -0.5L * period);
  ASSERT_TRUE(back);
  EXPECT_LE(largest_component(back->state.position - apolune.position), revolution_error);
  EXPECT_LE(largest_component(back->state.velocity - apolune.velocity), revolution_error);
  const auto nowhere = propagate(earth_moon_system, apolune, 0.0L);
  ASSERT_TRUE(nowhere);
  EXPECT_EQ(nowhere->state, apolune);
  EXPECT_EQ(nowhere->steps, 0U);
}

TEST(Propagation, FindsTheClosestApproachBetweenSteps) {
  // Past perilune, with coarse steps and with fine ones: the cubic's relative error is below
  // 1/10^5.
  constexpr long double cubic_error = 1e-5L;  // promised in propagation.hpp
  PropagationOptions coarse;
  coarse.step_tolerance = std::sqrt(eps);
  const auto fine = propagate(earth_moon_system, apolune, period);
  const auto rough = propagate(earth_moon_system, apolune, period, coarse);
  const auto perilune = propagate(earth_moon_system, apolune, 0.5L * period);
  ASSERT_TRUE(fine && rough && perilune);
  EXPECT_LT(rough->steps, fine->steps / 4);
  const long double least = norm(offset_from_smaller(earth_moon_system, perilune->state.position));
  EXPECT_LE(std::abs(fine->closest_approach_smaller - least), cubic_error * least);
  EXPECT_LE(std::abs(rough->closest_approach_smaller - least), cubic_error * least);
}

TEST(Propagation, TransitionMatrixIsTheDerivativeOfTheMotion) {
  const long double duration = 0.6L * period;
  const auto result = propagate_variations(earth_moon_system, apolune, duration);
  ASSERT_TRUE(result) << result.fault().sentence;
  constexpr long double h = 0x1p-16L;  // the difference's error, measured below, is of order h²
  const auto component = [](State& s, std::size_t i) -> long double& {
    return i < 3 ? s.position[i] : s.velocity[i - 3];
  };
  for (std::size_t j = 0; j < 6; ++j) {
    const auto difference = [&](long double step) {
      State plus = apolune, minus = apolune;
      component(plus, j) += step;
      component(minus, j) -= step;
      State a = propagate(earth_moon_system, plus, duration).value().state;
      State b = propagate(earth_moon_system, minus, duration).value().state;
      std::array<long double, 6> column{};
      for (std::size_t i = 0; i < 6; ++i) {
        column[i] = (component(a, i) - component(b, i)) / (2.0L * step);
      }
      return column;
    };
    const auto wide = difference(h), narrow = difference(0.5L * h);
    // The wide difference is wrong by c h² + O(h⁴), the narrow one by a quarter of it: their
    // difference is three times what is wrong with the narrow one. Rounding: errors of both ends
    // over the step.
    long double narrow_error = 0.0L;
    for (std::size_t i = 0; i < 6; ++i) {
      narrow_error = std::max(narrow_error, std::abs(wide[i] - narrow[i]) / 3.0L);
    }
    const long double bound = 2.0L * narrow_error + 2.0L * revolution_error / h;
    EXPECT_LT(bound, h) << "the differences are too rough to test anything";
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_LE(std::abs(narrow[i] - result->transition[i][j]), bound) << i << ' ' << j;
    }
  }
}

TEST(Propagation, TransitionMatrixIsSymplectic) {
  // dx∧dpx + dy∧dpy + dz∧dpz is conserved, with momenta px = vx - y, py = vy + x, pz = vz.
  TransitionMatrix form{};
  for (std::size_t i = 0; i < 3; ++i) {
    form[i][i + 3] = 1.0L;
    form[i + 3][i] = -1.0L;
  }
  form[0][1] = -2.0L;
  form[1][0] = 2.0L;
  const auto result = propagate_variations(earth_moon_system, apolune, 0.8L * period);
  ASSERT_TRUE(result) << result.fault().sentence;
  const TransitionMatrix& phi = result->transition;
  for (std::size_t i = 0; i < 6; ++i) {
    for (std::size_t j = 0; j < 6; ++j) {
      long double sum = 0.0L, size = 0.0L;
      for (std::size_t k = 0; k < 6; ++k) {
        for (std::size_t l = 0; l < 6; ++l) {
          sum += phi[k][i] * form[k][l] * phi[l][j];
          size += std::abs(phi[k][i] * form[k][l] * phi[l][j]);
        }
      }
      EXPECT_LE(std::abs(sum - form[i][j]), revolution_error * (1.0L + size)) << i << ' ' << j;
    }
  }
  const auto plain = propagate(earth_moon_system, apolune, 0.8L * period);
  ASSERT_TRUE(plain);
  EXPECT_LE(largest_component(plain->state.position - result->motion.state.position),
            revolution_error);
}

TEST(Propagation, FindsTheNextCrossing) {
  // The period is printed to 15 digits; half of it is right to half a unit of the last one.
  constexpr long double printed = 0.5e-14L;
  const auto half = next_plane_crossing(earth_moon_system, apolune, period);
  ASSERT_TRUE(half) << half.fault().sentence;
  EXPECT_LE(std::abs(*half - 0.5L * period), 2.0L * printed);
  const auto later = propagate(earth_moon_system, apolune, 0.125L * period);
  ASSERT_TRUE(later);
  const auto rest = next_plane_crossing(earth_moon_system, later->state, period);
  ASSERT_TRUE(rest);
  EXPECT_LE(std::abs(*rest + 0.125L * period - *half), revolution_error);
}

template <class T>
std::string sentence(const Result<T>& result) {
  return result ? std::string("accepted") : result.fault().sentence;
}

TEST(Propagation, RefusesWhatIsNotANumber) {
  State start = apolune;
  start.velocity.z = std::nanl("");
  const auto result = propagate(earth_moon_system, start, 1.0L);
  EXPECT_EQ(sentence(result),
            "the initial state's velocity z is nan; all six components must be finite");
  EXPECT_EQ(result.fault().code, FaultCode::not_finite);
  EXPECT_EQ(result.fault().index, 5U);
  EXPECT_EQ(sentence(propagate(earth_moon_system, apolune, HUGE_VALL)),
            "the duration is inf; it must be finite");
  EXPECT_EQ(sentence(propagate_variations(earth_moon_system, apolune, -HUGE_VALL)),
            "the duration is -inf; it must be finite");
  EXPECT_EQ(sentence(next_plane_crossing(earth_moon_system, apolune, HUGE_VALL)),
            "the time limit is inf; it must be positive and finite");
}

TEST(Propagation, RefusesCollisions) {
  const long double mu = earth_moon_system.mass_ratio;
  const State inside{{-mu, 0.0L, 0.0L}, {0.0L, 1.0L, 0.0L}};
  const auto start = propagate(earth_moon_system, inside, 1.0L);
  EXPECT_EQ(sentence(start),
            "the motion comes within 0 length units of the larger primary at time 0; it must stay "
            "at least 1e-06 away");
  EXPECT_EQ(start.fault().code, FaultCode::outside_domain);
  // Falling from rest above the Moon: nearly head on; with the Moon's own radius it is a hit.
  const State falling{{1.0L - mu, 0.0L, 0.05L}, {0.0L, 0.0L, 0.0L}};
  PropagationOptions surface;
  surface.collision_distance = 1737.4 / earth_moon_system.length_unit_km;
  const auto hit = propagate(earth_moon_system, falling, 1.0L, surface);
  EXPECT_NE(sentence(hit).find("of the smaller primary at time 0."), std::string::npos)
      << sentence(hit);
  const auto crossing = next_plane_crossing(earth_moon_system, falling, 1.0L);
  EXPECT_TRUE(crossing || !crossing.fault().sentence.empty());
  surface.collision_distance = 0.0;
  EXPECT_EQ(sentence(propagate(earth_moon_system, apolune, 1.0L, surface)),
            "the collision distance is 0; it must be positive and finite, for the equations are "
            "singular at the primaries");
}

TEST(Propagation, SeesADipBetweenTwoSteps) {
  // The step ends straddle perilune; a limit just above the least distance must refuse all the
  // same.
  const auto free = propagate(earth_moon_system, apolune, period);
  ASSERT_TRUE(free);
  PropagationOptions options;
  options.step_tolerance = std::sqrt(eps);
  constexpr double margin = 1e-4;  // ten times the cubic's promised relative error
  options.collision_distance = static_cast<double>(free->closest_approach_smaller) * (1.0 + margin);
  EXPECT_FALSE(propagate(earth_moon_system, apolune, period, options));
  options.collision_distance = static_cast<double>(free->closest_approach_smaller) * (1.0 - margin);
  EXPECT_TRUE(propagate(earth_moon_system, apolune, period, options));
}

TEST(Propagation, StopsAtTheStepLimit) {
  PropagationOptions options;
  options.max_steps = 100;
  const auto result = propagate(earth_moon_system, apolune, 1000.0L, options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().code, FaultCode::no_convergence);
  EXPECT_NE(sentence(result).find(" of 1000 in the 100 steps allowed; ask for a shorter time or "
                                  "allow more steps"),
            std::string::npos)
      << sentence(result);
  options.step_tolerance = 0.0L;
  EXPECT_NE(sentence(propagate(earth_moon_system, apolune, 1.0L, options))
                .find("the step tolerance is 0; it must be at least "),
            std::string::npos);
}

TEST(Propagation, SurvivesHostileStates) {
  PropagationOptions options;
  options.max_steps = 2000;
  for (const long double size :
       {1e-300L, 1e-30L, 1e30L, 1e300L, 1e4000L}) {  // not a tolerance: hostile input
    for (const long double speed : {0.0L, 1.0L, 1e30L, 1e4000L}) {
      for (const long double duration : {1.0L, -1e300L}) {
        const State start{{size, size, -size}, {speed, -speed, speed}};
        const auto result = propagate(earth_moon_system, start, duration, options);
        if (result) {
          EXPECT_TRUE(is_finite(result->state.position));
          EXPECT_TRUE(is_finite(result->state.velocity));
        } else {
          EXPECT_FALSE(result.fault().sentence.empty());
        }
        const auto crossing = next_plane_crossing(earth_moon_system, start, 10.0L, options);
        EXPECT_TRUE(!crossing || is_finite(*crossing));
      }
    }
  }
}

TEST(Propagation, SaysWhereThereIsNoCrossing) {
  const State far{{1.02731322944525L, -0.01L, -0.18551533506611556L}, {0.0L, -0.5L, 0.0L}};
  const auto result = next_plane_crossing(earth_moon_system, far, 0.25L);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().code, FaultCode::no_convergence);
  EXPECT_EQ(sentence(result),
            "the motion does not cross the plane y = 0 within 0.25 time units; a symmetric orbit "
            "must");
}

}  // namespace
}  // namespace hodograph
