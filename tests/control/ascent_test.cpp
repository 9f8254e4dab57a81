// SPDX-License-Identifier: MIT
// Both ascents from the Moon: derivatives against 40 digits and the solver's checker, and solutions
// against those known from independent computations.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/control/tracking_ascent.hpp"
#include "src/control/powered_model.hpp"
#include "src/control/tracking_model.hpp"
#include "support/ascent_judge.hpp"
#include "support/derivative_judge.hpp"
#include "support/exact_reference.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

using test::expect_right_stage_derivatives;

MultipleShooting<ascent_detail::Lander> lander(std::size_t intervals) {
  ascent_detail::Lander model{0.08, std::vector<Vector3<double>>(intervals, {0.99, 0.02, 0.01})};
  return MultipleShooting<ascent_detail::Lander>(model, intervals);
}
MultipleShooting<ascent_detail::PoweredModel> powered(std::size_t intervals, bool least_time) {
  const AscentReference& reference = test::gateway();
  return MultipleShooting<ascent_detail::PoweredModel>(
      {reference, ascent_detail::PoweredUnits(reference.orbit().system), least_time,
       static_cast<double>(intervals)},
      intervals);
}

/// Four stages of some hundred operations each.
constexpr double step_operations = 2000.0;

TEST(AscentDerivatives, OfTheLanderAgreeWithFortyDigits) {
  test::Random random("ascent: lander");
  const auto program = lander(100);
  for (int round = 0; round < 3; ++round) {
    std::array<double, 9> at;
    for (double& number : at) number = random.uniform(-1, 1);
    at[3] = random.uniform(0.01, 50);
    at[6] = random.uniform(-1000, 1000);
    at[7] = random.uniform(-500, 500);
    at[8] = random.uniform(-500, 500);
    expect_right_stage_derivatives(program, at, step_operations);
  }
}

TEST(AscentDerivatives, OfThePoweredFlightAgreeWithFortyDigits) {
  test::Random random("ascent: powered");
  const auto program = powered(100, false);
  for (int round = 0; round < 2; ++round) {
    std::array<double, 11> at;
    for (double& number : at) number = random.uniform(-2, 2);
    at[0] = random.uniform(1.8, 4);  // away from the Moon's centre
    at[9] = random.uniform(1, 6);
    at[10] = random.uniform(0, 1);
    expect_right_stage_derivatives(program, at, step_operations);
  }
}

// Where the powered flight meets the orbit, by the phase: the orbit's place and velocity.
TEST(AscentDerivatives, OfTheMeetingWithTheOrbitAgreeWithFortyDigits) {
  test::Random random("ascent: meeting");
  const auto program = powered(100, true);
  const AscentReference& reference = test::gateway();
  const test::ExactReference<Quaternion<double>, 8> path(AnyPath(reference.path()));
  const ascent_detail::PoweredUnits units(reference.orbit().system);
  const double rate = 1000.0 / reference.period_s();
  const auto ends = [&]<class S>(const std::array<S, 1>& phase) {
    std::vector<S> all;
    if constexpr (std::is_same_v<S, test::Wide>) {
      const auto at = path.on(phase[0]);
      const Vector3<S> place = at.position - Vector3<S>{S(reference.moon().x), S(0), S(0)};
      for (std::size_t i = 0; i < 3; ++i) all.push_back(-S(units.length) * place[i]);
      for (std::size_t i = 0; i < 3; ++i) {
        all.push_back(-S(units.length) * S(rate) * at.speed * at.frame.e1[i]);
      }
    } else {
      const std::array<S, 2> p{S(1.0), phase[0]};
      for (const S& x : program.model().end_values(std::array<S, 6>{}, p)) all.push_back(x);
    }
    return all;
  };
  // The velocity's second derivative takes that of the preimage: by n (n - 1)/h² second differences
  // of its coefficients, of degree n = 8, on 30 segments.
  constexpr double operations = 8.0 * 7.0 * 30.0 * 30.0;
  for (int round = 0; round < 5; ++round) {
    test::expect_right_derivatives(ends, std::array<double, 1>{random.uniform(0.1, 0.9)},
                                   operations);
  }
}

std::size_t wrong_derivatives(NonlinearProgram& program, std::size_t first, double size) {
  SolverPoint start;
  const std::size_t count = program.variable_ranges().size();
  for (std::size_t i = 0; i < count; ++i) {
    start.variables.push_back(1.0 + size * std::sin(static_cast<double>(3 * i + first)));
  }
  return test::wrong_derivatives(program, start);
}

TEST(AscentDerivatives, PassTheSolversCheck) {
  auto tracking = lander(2);
  EXPECT_EQ(wrong_derivatives(tracking, 0, 0.9), 0U);
  for (const bool least_time : {false, true}) {
    auto program = powered(2, least_time);
    program.parameter_ranges()[1] = {0.48, 0.52};
    EXPECT_EQ(wrong_derivatives(program, 1, 0.4), 0U);
  }
}

TEST(TrackingAscent, ReachesTheOrbitAtTheKnownMinima) {
  for (const std::size_t k : {0U, 5U}) test::judge_tracking(k, 1);
}
TEST(TrackingAscent, DoesNotArriveInTheSettingOfTheFigure) {
  TrackingOptions options;
  options.setting = TrackingSetting::four_revolutions;
  options.solving.guesses = 1;
  const auto answer = tracking_ascent(test::gateway(), ascent_starts()[1], options).value();
  EXPECT_FALSE(answer.arrives);
  EXPECT_GT(answer.end_error_km, 600.0);  // 741 and more, by the independent computation
  EXPECT_NEAR(answer.solved.objective, 0.012463, 0.001 * 0.012463);
}

TEST(PoweredAscent, FindsTheKnownLeastEnergyAndSurvivesRepropagation) {
  for (const std::size_t k : {0U, 1U}) test::judge_least_energy(k, 1);
}
TEST(PoweredAscent, FindsTheKnownLeastTime) { test::judge_least_time(4, 1); }

TEST(Ascent, StopsOnRequest) {
  PoweredOptions options;
  options.solving.progress = [](std::size_t, const SolverIteration& at) {
    return at.iteration < 2;
  };
  const auto answer = powered_ascent(test::gateway(), ascent_starts()[0], options);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.fault().code, FaultCode::cancelled);
}

TEST(Ascent, SaysThatTimeOrThrustDoNotDo) {
  PoweredOptions options;
  options.duration_s = 300.0;
  options.solving.guesses = 1;
  options.solving.max_iterations = 60;
  const auto answer = powered_ascent(test::gateway(), ascent_starts()[0], options);
  ASSERT_FALSE(answer);
  EXPECT_EQ(answer.fault().code, FaultCode::no_convergence);
}

TEST(Ascent, RefusesBadOptions) {
  EXPECT_EQ(ascent_start("up").fault().code, FaultCode::unsupported);
  const auto powered_code = [](auto&& change) {
    PoweredOptions options;
    change(options);
    return powered_ascent(test::gateway(), ascent_starts()[0], options).fault().code;
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  using P = PoweredOptions;
  EXPECT_EQ(powered_code([](P& o) { o.duration_s = 0.0; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([&](P& o) { o.duration_s = nan; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.thrust_limit_m_s2 = -1.0; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.margin_km = -1.0; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.surface_km = 0.0; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.intervals = 1; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.solving.guesses = 0; }), FaultCode::outside_domain);
  EXPECT_EQ(powered_code([](P& o) { o.solving.time_limit_s = -1; }), FaultCode::outside_domain);
  TrackingOptions options;
  options.singular_theta = nan;
  EXPECT_EQ(tracking_ascent(test::gateway(), ascent_starts()[4], options).fault().code,
            FaultCode::outside_domain);
}

}  // namespace
}  // namespace hodograph
