// SPDX-License-Identifier: MIT
// The transcription and the solver on problems whose discrete answers are known, and their
// derivatives against Ipopt's own checker.
#include "hodograph/control/multiple_shooting.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "hodograph/control/solver.hpp"
#include "support/compare.hpp"

namespace hodograph {
namespace {

/// A cart: x'' = u over a free time T, from rest to rest.
struct Cart {
  static constexpr std::size_t states = 2, controls = 1, parameters = 1;
  static constexpr std::size_t path_constraints = 0, end_constraints = 0;
  double intervals = 1.0, time_weight = 0.0, energy_weight = 0.0;

  template <class S>
  std::array<S, 2> derivative(double, const std::array<S, 2>& x, const std::array<S, 1>& u,
                              const std::array<S, 1>& p) const {
    return {p[0] * x[1], p[0] * u[0]};
  }
  template <class S>
  S stage_cost(std::size_t, const std::array<S, 2>&, const std::array<S, 1>& u,
               const std::array<S, 1>& p) const {
    return (energy_weight / intervals) * (p[0] * u[0] * u[0]);
  }
  template <class S>
  S end_cost(const std::array<S, 2>&, const std::array<S, 1>& p) const {
    return time_weight * p[0];
  }
  template <class S>
  std::array<S, 0> path_values(std::size_t, const std::array<S, 2>&, const std::array<S, 1>&,
                               const std::array<S, 1>&) const {
    return {};
  }
  template <class S>
  std::array<S, 0> end_values(const std::array<S, 2>&, const std::array<S, 1>&) const {
    return {};
  }
};

MultipleShooting<Cart> cart(std::size_t intervals, double time_weight, double energy_weight) {
  MultipleShooting<Cart> program(Cart{static_cast<double>(intervals), time_weight, energy_weight},
                                 intervals);
  program.fix_start({0.0, 0.0});
  program.state_ranges(intervals)[0] = Range::only(1.0);
  program.state_ranges(intervals)[1] = Range::only(0.0);
  return program;
}

SolverPoint guess(const NonlinearProgram& program, double value) {
  SolverPoint start;
  start.variables.assign(program.variable_ranges().size(), value);
  return start;
}

TEST(MultipleShooting, FindsTheLeastTimeOfACart) {
  constexpr std::size_t intervals = 20;
  MultipleShooting<Cart> program = cart(intervals, 1.0, 0.0);
  for (std::size_t k = 0; k < intervals; ++k) program.control_ranges(k)[0] = {-1.0, 1.0};
  program.parameter_ranges()[0] = {0.1, 10.0};
  const auto solution = solve(program, guess(program, 0.5)).value();
  // Bang-bang, one switch at T/2; each range of a control may keep a complementarity of the
  // tolerance.
  EXPECT_NEAR(solution.objective, 2.0, 2 * intervals * default_solver_tolerance);
  EXPECT_LE(solution.constraint_error, default_constraint_tolerance);
  EXPECT_TRUE(solution.finished);
  EXPECT_NEAR(solution.point.variables[program.control_at(3)], 1.0, default_solver_tolerance * 100);
}

TEST(MultipleShooting, FindsTheLeastEnergyOfACart) {
  // Constant on N intervals the best control is linear in their midpoints: 12 / (1 - 1/N²).
  for (const std::size_t intervals : {2U, 3U, 10U}) {
    MultipleShooting<Cart> program = cart(intervals, 0.0, 1.0);
    program.parameter_ranges()[0] = Range::only(1.0);
    const auto solution = solve(program, guess(program, 1.0)).value();
    const double n = static_cast<double>(intervals);
    EXPECT_NEAR(solution.objective, 12.0 / (1.0 - 1.0 / (n * n)), 12 * default_solver_tolerance);
    EXPECT_LE(solution.iterations, 2U);  // a quadratic program
  }
}

/// Everything at once: two states, one control, two parameters, path and end constraints, and a
/// derivative that depends on τ.
struct Bent {
  static constexpr std::size_t states = 2, controls = 1, parameters = 2;
  static constexpr std::size_t path_constraints = 1, end_constraints = 1;

  template <class S>
  std::array<S, 2> derivative(double tau, const std::array<S, 2>& x, const std::array<S, 1>& u,
                              const std::array<S, 2>& p) const {
    using std::sin;
    return {p[0] * x[1] * u[0] + tau * x[0], p[1] * sin(x[0]) - u[0] * u[0]};
  }
  template <class S>
  S stage_cost(std::size_t k, const std::array<S, 2>& x, const std::array<S, 1>& u,
               const std::array<S, 2>& p) const {
    return x[0] * x[0] * u[0] * u[0] + static_cast<double>(k) * p[0] * p[1] * p[1] + x[1] * p[0];
  }
  template <class S>
  S end_cost(const std::array<S, 2>& x, const std::array<S, 2>& p) const {
    return x[0] * x[1] * p[0] + x[1] * x[1] * p[1];
  }
  template <class S>
  std::array<S, 1> path_values(std::size_t, const std::array<S, 2>& x, const std::array<S, 1>& u,
                               const std::array<S, 2>& p) const {
    return {x[0] * u[0] * p[1] + u[0] * u[0]};
  }
  template <class S>
  std::array<S, 1> end_values(const std::array<S, 2>& x, const std::array<S, 2>& p) const {
    return {x[0] * x[0] + p[0] * p[1] * x[1]};
  }
};

TEST(MultipleShooting, DerivativesPassTheSolversCheck) {
  MultipleShooting<Bent> program(Bent{}, 5, 2);
  SolverPoint start = guess(program, 0.0);
  for (std::size_t i = 0; i < start.variables.size(); ++i) {
    start.variables[i] = 0.7 + 0.3 * std::sin(static_cast<double>(3 * i));
  }
  SolverOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;
  options.keep_unfinished = true;
  EXPECT_EQ(solve(program, start, options).value().wrong_derivatives, 0U);
}

/// The checker must see a wrong derivative, or the test above proves nothing.
struct Wrong : Cart {
  template <class S>
  S stage_cost(std::size_t, const std::array<S, 2>& x, const std::array<S, 1>&,
               const std::array<S, 1>&) const {
    S cost = x[1] * x[1];
    if constexpr (!std::is_same_v<S, double>) {
      cost.gradient(1) *= 1.5;
      cost.hessian(1, 1) *= 2.0;
    }
    return cost;
  }
};
TEST(MultipleShooting, TheSolversCheckSeesWrongDerivatives) {
  MultipleShooting<Wrong> program(Wrong{}, 4);
  SolverOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;
  options.keep_unfinished = true;
  EXPECT_GE(solve(program, guess(program, 0.6), options).value().wrong_derivatives, 8U);
}

TEST(Solver, StopsOnRequestAndSaysSo) {
  MultipleShooting<Cart> program = cart(20, 1.0, 0.0);
  program.parameter_ranges()[0] = {0.1, 10.0};
  for (std::size_t k = 0; k < 20; ++k) program.control_ranges(k)[0] = {-1.0, 1.0};
  SolverOptions options;
  options.progress = [](const SolverIteration& at) { return at.iteration < 3; };
  auto result = solve(program, guess(program, 0.5), options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().code, FaultCode::cancelled);
  options.progress = [](const SolverIteration&) -> bool { throw std::string("thrown"); };
  EXPECT_THROW((void)solve(program, guess(program, 0.5), options), std::string);

  options.progress = nullptr;
  options.max_iterations = 2;
  result = solve(program, guess(program, 0.5), options);
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().code, FaultCode::no_convergence);
  EXPECT_NE(result.fault().sentence.find("2 iterations"), std::string::npos);
  options.keep_unfinished = true;
  const auto kept = solve(program, guess(program, 0.5), options).value();
  EXPECT_FALSE(kept.finished);
  EXPECT_EQ(kept.point.variables.size(), program.variable_ranges().size());
}

TEST(Solver, SaysThatNothingIsFeasible) {
  MultipleShooting<Cart> program = cart(5, 1.0, 0.0);
  program.parameter_ranges()[0] = {0.1, 1.0};  // too short for |u| ≤ 1
  for (std::size_t k = 0; k < 5; ++k) program.control_ranges(k)[0] = {-1.0, 1.0};
  const auto result = solve(program, guess(program, 0.5));
  ASSERT_FALSE(result);
  EXPECT_EQ(result.fault().code, FaultCode::no_convergence);
}

TEST(Solver, RefusesBadInput) {
  MultipleShooting<Cart> program = cart(3, 1.0, 0.0);
  SolverPoint start = guess(program, 0.5);
  start.variables[4] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(solve(program, start).fault().code, FaultCode::not_finite);
  start.variables.pop_back();
  EXPECT_EQ(solve(program, start).fault().code, FaultCode::mismatched_size);
  start = guess(program, 0.5);
  const auto code_with = [&](auto&& change) {
    SolverOptions options;
    change(options);
    return solve(program, start, options).fault().code;
  };
  using O = SolverOptions;
  EXPECT_EQ(code_with([](O& o) { o.tolerance = 0.0; }), FaultCode::outside_domain);
  EXPECT_EQ(code_with([](O& o) { o.time_limit_s = -1.0; }), FaultCode::outside_domain);
  EXPECT_EQ(code_with([](O& o) { o.warm_barrier = 2.0; }), FaultCode::outside_domain);
  for (const char* name : {"hessian_approximation", "derivative_test", "output_file", "nonsense"}) {
    EXPECT_EQ(code_with([&](O& o) { o.more = {{name, "none"}}; }), FaultCode::unsupported) << name;
  }
  SolverOptions warm;
  warm.warm_barrier = 0.001;
  EXPECT_EQ(solve(program, start, warm).fault().code, FaultCode::mismatched_size);
}

TEST(Solver, SolvesAgainFromItsAnswerWithOtherRanges) {
  constexpr std::size_t intervals = 20;
  MultipleShooting<Cart> program = cart(intervals, 1.0, 0.0);
  for (std::size_t k = 0; k < intervals; ++k) program.control_ranges(k)[0] = {-1.0, 1.0};
  program.parameter_ranges()[0] = {0.1, 10.0};
  Solver solver = Solver::make(program).value();
  const Solution cold = solver.solve(guess(program, 0.5)).value();
  SolverOptions options;
  options.warm_barrier = 1e-4;  // not a tolerance: a barrier parameter
  ASSERT_FALSE(solver.change(options));
  program.fix_start({0.02, 0.0});
  const Solution warm = solver.solve(cold.point).value();
  EXPECT_NEAR(warm.objective, 2.0 * std::sqrt(0.98), default_solver_tolerance * 10);
  EXPECT_EQ(warm.point.variables[0], 0.02);
  EXPECT_LT(warm.iterations, cold.iterations);
}

}  // namespace
}  // namespace hodograph
