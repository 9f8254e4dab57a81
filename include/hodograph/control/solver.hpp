// SPDX-License-Identifier: MIT
// Solving a nonlinear program by an interior-point method (Ipopt with MUMPS), with exact first and
// second derivatives always: there is no way to ask for finite differences or for an
// approximate Hessian, which stop at wrong points with a success status.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/control/nonlinear_program.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// The default of SolverOptions::tolerance, Ipopt's own: the optimality error after scaling.
inline constexpr double default_solver_tolerance = 1e-8;
/// The default of SolverOptions::constraint_tolerance: two digits below the defects of 1e-8 that a
/// multiple-shooting answer may have.
inline constexpr double default_constraint_tolerance = 1e-10;

/// One iteration, as it is reported while the solver works.
struct SolverIteration {
  std::size_t iteration = 0;
  double objective{};
  double primal_infeasibility{};  ///< largest violation of a constraint
  double dual_infeasibility{};
  double barrier{};        ///< the barrier parameter μ
  bool restoring = false;  ///< in the phase that looks for feasibility alone
};

/// One of Ipopt's own options by its name, for what the members below do not cover. Refused:
/// unknown names and values, and every option that would touch the derivatives.
struct SolverSetting {
  std::string name, value;
};

struct SolverOptions {
  double tolerance = default_solver_tolerance;                 ///< in (0, 1)
  double constraint_tolerance = default_constraint_tolerance;  ///< in (0, 1), unscaled
  std::size_t max_iterations = 1000;
  double time_limit_s = 0.0;  ///< of one solution, wall clock; 0: none
  /// Start from multipliers, and from a barrier parameter of this size (see SolverPoint); for
  /// problems that hardly differ from one already solved.
  std::optional<double> warm_barrier{};
  /// Where iterations or time run out, return the point reached, with `finished` false, instead of
  /// a Fault; for real-time use.
  bool keep_unfinished = false;
  /// Check all derivatives by differences before solving and count what differs (slow; for tests).
  bool check_derivatives = false;
  /// Called after every iteration; false stops the solver with the fault `cancelled`.
  std::function<bool(const SolverIteration&)> progress{};
  std::vector<SolverSetting> more{};
};

/// A point with its multipliers: where a solution starts, and what it ends with. Multipliers may be
/// empty where a solution starts cold.
struct SolverPoint {
  std::vector<double> variables;                             ///< z
  std::vector<double> constraint_multipliers;                ///< λ, of g
  std::vector<double> lower_multipliers, upper_multipliers;  ///< ≥ 0, of the ranges of z
};

struct Solution {
  SolverPoint point;
  double objective{};
  std::vector<double> constraints;  ///< g at the point
  std::size_t iterations = 0;
  double seconds{};                   ///< wall clock
  double constraint_error{};          ///< largest violation of a range by g or z, unscaled
  double optimality_error{};          ///< scaled, as tolerance bounds it
  bool finished = true;               ///< false: stopped early (keep_unfinished)
  std::string status;                 ///< the solver's words
  std::size_t wrong_derivatives = 0;  ///< found by check_derivatives
};

/// A solver that keeps what it knows about the structure of one program from one solution to the
/// next: the places of all entries and the order of elimination.
class Solver {
 public:
  /// The program must outlive the solver. Faults: outside_domain (an option), unsupported (a
  /// setting that is unknown or not allowed), mismatched_size (patterns that point outside the
  /// program).
  static Result<Solver> make(NonlinearProgram& program, const SolverOptions& options = {});
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;
  ~Solver();

  /// A local minimum near `start`, to the tolerances of the options; deterministic. The program's
  /// ranges may have changed since the last call, its sizes and patterns not.
  /// Faults: mismatched_size, not_finite (the start); no_convergence with the solver's words (no
  /// feasible point near by, iterations or time used up, a step that cannot be computed);
  /// cancelled.
  Result<Solution> solve(const SolverPoint& start);
  /// The options of the following solutions. Faults as make; the solver is then unchanged.
  std::optional<Fault> change(const SolverOptions& options);

 private:
  struct State;
  explicit Solver(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// One solution by a solver made for it.
Result<Solution> solve(NonlinearProgram& program, const SolverPoint& start,
                       const SolverOptions& options = {});

}  // namespace hodograph
