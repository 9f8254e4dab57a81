// SPDX-License-Identifier: MIT
// Both ascents from the Moon: derivatives against 40 digits and the solver's checker, and solutions
// against those known from independent computations.
#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <string>

#include "hodograph/control/powered_ascent.hpp"
#include "hodograph/control/tracking_ascent.hpp"
#include "src/control/powered_model.hpp"
#include "src/control/tracking_model.hpp"
#include "support/ascent_judge.hpp"
#include "support/compare.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>,
                                           boost::multiprecision::et_off>;

/// One interval's step and values at `point`, on any scalar: next state, path values, stage cost.
template <class Program, class S, std::size_t count>
std::vector<S> interval(const Program& program, const std::array<S, count>& point) {
  std::array<S, Program::n> x;
  std::array<S, Program::m> u;
  std::array<S, Program::q> p;
  for (std::size_t i = 0; i < count; ++i) {
    (i < Program::n                ? x[i]
     : i < Program::n + Program::m ? u[i - Program::n]
                                   : p[i - Program::n - Program::m]) = point[i];
  }
  const auto next = program.template shoot<S>(1, x, u, p);
  const auto path = program.model().path_values(1, x, u, p);
  std::vector<S> all(next.begin(), next.end());
  all.insert(all.end(), path.begin(), path.end());
  all.push_back(program.model().stage_cost(1, x, u, p));
  return all;
}

/// Gradients and Hessians of all of them against central differences in 40 digits.
template <class Program>
void expect_right_derivatives(const Program& program, const std::array<double, Program::local>& at,
                              double operations) {
  constexpr std::size_t count = Program::local;
  using Jet = SecondOrder<double, count>;
  const Wide h("1e-10");  // not a tolerance: leaves errors of 1e-20
  std::array<Jet, count> jets;
  std::array<Wide, count> wide;
  for (std::size_t i = 0; i < count; ++i) {
    jets[i] = Jet::variable(at[i], i);
    wide[i] = at[i];
  }
  const auto exact = interval<Program, Jet, count>(program, jets);
  const auto moved = [&](std::size_t i, int di, std::size_t j, int dj) {
    std::array<Wide, count> z = wide;
    z[i] += di * h;
    z[j] += dj * h;
    return interval<Program, Wide, count>(program, z);
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto after = moved(i, 1, i, 0), before = moved(i, -1, i, 0);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      double size = 0.0;
      for (std::size_t c = 0; c < Jet::size; ++c) {
        size = std::max(size, std::abs(exact[k].data()[c]));
      }
      const Wide slope = (after[k] - before[k]) / (2 * h);
      EXPECT_CLOSE(exact[k].gradient(i), static_cast<double>(slope), operations, size);
    }
    for (std::size_t j = 0; j <= i; ++j) {
      const auto pp = moved(i, 1, j, 1), pm = moved(i, 1, j, -1);
      const auto mp = moved(i, -1, j, 1), mm = moved(i, -1, j, -1);
      for (std::size_t k = 0; k < exact.size(); ++k) {
        double size = 0.0;
        for (std::size_t c = 0; c < Jet::size; ++c) {
          size = std::max(size, std::abs(exact[k].data()[c]));
        }
        const Wide bend = (pp[k] - pm[k] - mp[k] + mm[k]) / (4 * h * h);
        EXPECT_CLOSE(exact[k].hessian(i, j), static_cast<double>(bend), operations, size);
      }
    }
  }
}

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
    expect_right_derivatives(program, at, step_operations);
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
    expect_right_derivatives(program, at, step_operations);
  }
}

template <class Program>
std::size_t wrong_derivatives(Program& program, std::size_t first, double size) {
  SolverPoint start;
  const std::size_t count = program.variable_ranges().size();
  for (std::size_t i = 0; i < count; ++i) {
    start.variables.push_back(1.0 + size * std::sin(static_cast<double>(3 * i + first)));
  }
  SolverOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;
  options.keep_unfinished = true;
  return solve(program, start, options).value().wrong_derivatives;
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
