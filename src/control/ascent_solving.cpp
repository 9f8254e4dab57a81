// SPDX-License-Identifier: MIT
#include "ascent_solving.hpp"

namespace hodograph::ascent_detail {
namespace {

/// Objectives that agree to six digits are one minimum, and the guess that found it first counts.
/// (Objectives here are positive.)
constexpr double same_minimum = 1e-6;

}  // namespace

std::optional<Fault> check_number(const char* name, double value, double low, double high) {
  if (value >= low && value <= high) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               std::string(name) + " is " + to_text(value) + "; it must be from " + to_text(low) +
                   " to " + to_text(high),
               std::nullopt,
               name,
               value,
               value < low ? low : high};
}

std::optional<Fault> check(const AscentSolving& solving, std::size_t intervals) {
  constexpr double most_intervals = 100'000, most_guesses = 1000;
  if (auto fault = check_number("intervals", static_cast<double>(intervals), 2, most_intervals)) {
    return fault;
  }
  return check_number("guesses", static_cast<double>(solving.guesses), 1, most_guesses);
}

Result<Best> best_of(NonlinearProgram& program, const AscentSolving& solving,
                     const std::function<SolverPoint(std::size_t)>& guess) {
  SolverOptions options;
  options.max_iterations = solving.max_iterations;
  options.time_limit_s = solving.time_limit_s;
  options.more = {{"mu_strategy", "adaptive"}};
  options.more.insert(options.more.end(), solving.more.begin(), solving.more.end());
  std::size_t now = 0;
  if (solving.progress) {
    options.progress = [&](const SolverIteration& at) { return solving.progress(now, at); };
  }
  Result<Solver> solver = Solver::make(program, options);
  if (!solver) return solver.fault();

  std::optional<Best> best;
  std::optional<Fault> last;
  std::size_t converged = 0;
  for (now = 0; now < solving.guesses; ++now) {
    Result<Solution> answer = solver->solve(guess(now));
    if (!answer) {
      if (answer.fault().code == FaultCode::cancelled) return answer.fault();
      last = answer.fault();
      continue;
    }
    ++converged;
    if (best && !(answer->objective < (1.0 - same_minimum) * best->facts.objective)) continue;
    best = Best{*std::move(answer), {}};
    const Solution& kept = best->solution;
    best->facts = {kept.objective,        now,        0, 0, kept.iterations, kept.seconds,
                   kept.constraint_error, kept.status};
  }
  if (!best) return *std::move(last);
  best->facts.tried = solving.guesses;
  best->facts.converged = converged;
  return *std::move(best);
}

}  // namespace hodograph::ascent_detail
