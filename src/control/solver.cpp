// SPDX-License-Identifier: MIT
#include "hodograph/control/solver.hpp"

#include <IpIpoptApplication.hpp>
#include <IpSolveStatistics.hpp>
#include <IpTNLP.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <span>
#include <string_view>
#include <utility>

namespace hodograph {
namespace {

using Ipopt::Index;
using Ipopt::Number;
using Clock = std::chrono::steady_clock;

/// Ipopt takes a bound of this size or more as none.
constexpr double no_bound = 2e19;
/// How far a warm start is moved off its ranges, as a share of the barrier parameter.
constexpr double warm_push = 1.0;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool all_finite(std::span<const double> numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

/// How far outside its range a number is.
double violation(const Range& range, double x) {
  return std::max({range.lower - x, x - range.upper, 0.0});
}

/// Counts the derivatives that Ipopt's checker marks as wrong: lines that begin with a star.
class DerivativeJournal final : public Ipopt::Journal {
 public:
  DerivativeJournal() : Ipopt::Journal("derivatives", Ipopt::J_WARNING) {}
  std::size_t marked = 0;

 protected:
  void PrintImpl(Ipopt::EJournalCategory, Ipopt::EJournalLevel, const char* text) override {
    read(text);
  }
  void PrintfImpl(Ipopt::EJournalCategory, Ipopt::EJournalLevel, const char* format,
                  va_list arguments) override {
    std::array<char, 512> line{};
    std::vsnprintf(line.data(), line.size(), format, arguments);
    read(line.data());
  }
  void FlushBufferImpl() override {}

 private:
  void read(std::string_view text) {
    if (text.starts_with("* grad_f") || text.starts_with("* jac_g") || text.find("obj_hess") == 2 ||
        (text.starts_with("*") && text.find("_hess") != std::string_view::npos)) {
      ++marked;
    }
  }
};

/// Our program as Ipopt sees it.
class Adapter final : public Ipopt::TNLP {
 public:
  explicit Adapter(NonlinearProgram& program) : program_(program) {}

  SolverPoint start;
  Solution answer;
  std::function<bool(const SolverIteration&)> progress;
  double time_limit_s = 0.0;
  Clock::time_point begin;
  bool out_of_time = false, cancelled = false;
  std::exception_ptr thrown;

  bool get_nlp_info(Index& n, Index& m, Index& nnz_jac_g, Index& nnz_h_lag,
                    IndexStyleEnum& index_style) override {
    n = static_cast<Index>(program_.variable_ranges().size());
    m = static_cast<Index>(program_.constraint_ranges().size());
    nnz_jac_g = static_cast<Index>(program_.jacobian_pattern().size());
    nnz_h_lag = static_cast<Index>(program_.hessian_pattern().size());
    index_style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Index, Number* x_l, Number* x_u, Index, Number* g_l, Number* g_u) override {
    const auto put = [](std::span<const Range> ranges, Number* lower, Number* upper) {
      for (const Range& range : ranges) {
        *lower++ = std::max(range.lower, -no_bound);
        *upper++ = std::min(range.upper, no_bound);
      }
    };
    put(program_.variable_ranges(), x_l, x_u);
    put(program_.constraint_ranges(), g_l, g_u);
    return true;
  }
  bool get_starting_point(Index, bool init_x, Number* x, bool init_z, Number* z_l, Number* z_u,
                          Index, bool init_lambda, Number* lambda) override {
    const auto put = [](const std::vector<double>& from, Number* to) {
      std::copy(from.begin(), from.end(), to);
    };
    if (init_x) put(start.variables, x);
    if (init_z) {
      put(start.lower_multipliers, z_l);
      put(start.upper_multipliers, z_u);
    }
    if (init_lambda) put(start.constraint_multipliers, lambda);
    return true;
  }
  bool eval_f(Index n, const Number* x, bool new_x, Number& value) override {
    move(n, x, new_x);
    value = program_.objective();
    return std::isfinite(value);
  }
  bool eval_grad_f(Index n, const Number* x, bool new_x, Number* result) override {
    move(n, x, new_x);
    const std::span<double> out(result, static_cast<std::size_t>(n));
    program_.gradient(out);
    return all_finite(out);
  }
  bool eval_g(Index n, const Number* x, bool new_x, Index m, Number* result) override {
    move(n, x, new_x);
    const std::span<double> out(result, static_cast<std::size_t>(m));
    program_.constraints(out);
    return all_finite(out);
  }
  bool eval_jac_g(Index n, const Number* x, bool new_x, Index, Index count, Index* rows,
                  Index* columns, Number* entries) override {
    if (!entries) return put(program_.jacobian_pattern(), rows, columns);
    move(n, x, new_x);
    const std::span<double> out(entries, static_cast<std::size_t>(count));
    program_.jacobian(out);
    return all_finite(out);
  }
  bool eval_h(Index n, const Number* x, bool new_x, Number factor, Index m, const Number* lambda,
              bool, Index count, Index* rows, Index* columns, Number* entries) override {
    if (!entries) return put(program_.hessian_pattern(), rows, columns);
    move(n, x, new_x);
    const std::span<double> out(entries, static_cast<std::size_t>(count));
    program_.hessian(factor, {lambda, static_cast<std::size_t>(m)}, out);
    return all_finite(out);
  }
  bool intermediate_callback(Ipopt::AlgorithmMode mode, Index iteration, Number objective,
                             Number primal, Number dual, Number barrier, Number, Number, Number,
                             Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    answer.iterations = static_cast<std::size_t>(iteration);
    if (progress) {
      try {
        cancelled = !progress({static_cast<std::size_t>(iteration), objective, primal, dual,
                               barrier, mode == Ipopt::RestorationPhaseMode});
      } catch (...) {  // must not pass through the solver
        thrown = std::current_exception();
        cancelled = true;
      }
      if (cancelled) return false;
    }
    out_of_time = time_limit_s > 0.0 && seconds_since(begin) > time_limit_s;
    return !out_of_time;
  }
  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* x, const Number* z_l,
                         const Number* z_u, Index m, const Number* g, const Number* lambda,
                         Number objective, const Ipopt::IpoptData*,
                         Ipopt::IpoptCalculatedQuantities*) override {
    answer.point.variables.assign(x, x + n);
    answer.point.lower_multipliers.assign(z_l, z_l + n);
    answer.point.upper_multipliers.assign(z_u, z_u + n);
    answer.point.constraint_multipliers.assign(lambda, lambda + m);
    answer.constraints.assign(g, g + m);
    answer.objective = objective;
  }

 private:
  void move(Index n, const Number* x, bool new_x) {
    if (new_x) program_.move_to({x, static_cast<std::size_t>(n)});
  }
  static bool put(const SparsePattern& pattern, Index* rows, Index* columns) {
    std::copy(pattern.rows.begin(), pattern.rows.end(), rows);
    std::copy(pattern.columns.begin(), pattern.columns.end(), columns);
    return true;
  }

  NonlinearProgram& program_;
};

Fault option_fault(FaultCode code, std::string sentence, const std::string& name) {
  return {code, std::move(sentence), std::nullopt, name, std::nullopt, std::nullopt};
}

std::optional<Fault> check_share(const char* name, double value) {
  if (value > 0.0 && value < 1.0) return std::nullopt;
  return Fault{FaultCode::outside_domain,
               std::string(name) + " is " + to_text(value) + "; it must be between 0 and 1",
               std::nullopt,
               name,
               value,
               std::nullopt};
}

/// Options that would replace exact derivatives by something else, or write files.
bool is_refused(std::string_view name) {
  constexpr std::array<std::string_view, 8> beginnings{
      "hessian_approx", "limited_memory",  "derivative_test", "jacobian_approx",
      "findiff",        "gradient_approx", "output_file",     "option_file"};
  // A prefix up to a point names a part of the solver, such as its restoration phase.
  const std::string_view bare = name.substr(name.rfind('.') + 1);
  return std::any_of(beginnings.begin(), beginnings.end(),
                     [&](std::string_view beginning) { return bare.starts_with(beginning); });
}

/// What the solver's status means, in words.
const char* words_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded:
      return "optimal solution found";
    case Ipopt::Solved_To_Acceptable_Level:
      return "solved to an acceptable level only";
    case Ipopt::Infeasible_Problem_Detected:
      return "converged to a point where the constraints cannot be met: the problem may be "
             "infeasible, or needs another initial guess";
    case Ipopt::Search_Direction_Becomes_Too_Small:
      return "the search direction became too small";
    case Ipopt::Diverging_Iterates:
      return "the iterates diverge";
    case Ipopt::User_Requested_Stop:
      return "stopped on request";
    case Ipopt::Feasible_Point_Found:
      return "a feasible point was found";
    case Ipopt::Maximum_Iterations_Exceeded:
      return "the largest number of iterations was reached";
    case Ipopt::Restoration_Failed:
      return "no point nearer to the constraints could be found";
    case Ipopt::Error_In_Step_Computation:
      return "a step could not be computed";
    case Ipopt::Maximum_CpuTime_Exceeded:
      return "the time limit was reached";
    case Ipopt::Not_Enough_Degrees_Of_Freedom:
      return "there are more constraints than free variables";
    case Ipopt::Invalid_Problem_Definition:
      return "the problem is inconsistent";
    case Ipopt::Invalid_Option:
      return "an option is not valid";
    case Ipopt::Invalid_Number_Detected:
      return "a value or derivative is not finite";
    case Ipopt::Insufficient_Memory:
      return "memory ran out";
    default:
      return "the solver failed";
  }
}

}  // namespace

struct Solver::State {
  NonlinearProgram& program;
  SolverOptions options;
  Ipopt::SmartPtr<Ipopt::IpoptApplication> application;
  Ipopt::SmartPtr<Adapter> adapter;
  Ipopt::SmartPtr<DerivativeJournal> journal;
  bool solved_before = false;

  explicit State(NonlinearProgram& wanted) : program(wanted), adapter(new Adapter(wanted)) {}
  std::optional<Fault> configure(const SolverOptions& wanted);
  std::optional<Fault> check_start(const SolverPoint& start) const;
};

std::optional<Fault> Solver::State::configure(const SolverOptions& wanted) {
  if (auto fault = check_share("tolerance", wanted.tolerance)) return fault;
  if (auto fault = check_share("constraint_tolerance", wanted.constraint_tolerance)) return fault;
  if (wanted.warm_barrier) {
    if (auto fault = check_share("warm_barrier", *wanted.warm_barrier)) return fault;
  }
  if (!(wanted.time_limit_s >= 0.0)) {
    return Fault{FaultCode::outside_domain,
                 "time_limit_s is " + to_text(wanted.time_limit_s) +
                     "; it must be positive, or 0 for no limit",
                 std::nullopt,
                 "time_limit_s",
                 wanted.time_limit_s,
                 0.0};
  }
  constexpr std::size_t most_iterations = 1'000'000'000;
  if (wanted.max_iterations > most_iterations) {
    return Fault{FaultCode::outside_domain,
                 "max_iterations is " + std::to_string(wanted.max_iterations) +
                     "; at most 1000000000 can be asked for",
                 std::nullopt,
                 "max_iterations",
                 static_cast<double>(wanted.max_iterations),
                 static_cast<double>(most_iterations)};
  }

  // A fresh set of options: what an earlier change set must not linger.
  Ipopt::SmartPtr<Ipopt::OptionsList> list = application->Options();
  const Ipopt::SmartPtr<Ipopt::OptionsList> before = new Ipopt::OptionsList(*list);
  list->clear();
  list->SetStringValue("sb", "yes");
  list->SetIntegerValue("print_level", 0);
  list->SetStringValue("linear_solver", "mumps");
  list->SetStringValue("hessian_approximation", "exact");
  list->SetIntegerValue("acceptable_iter", 0);  // solved or not: nothing in between
  list->SetNumericValue("tol", wanted.tolerance);
  list->SetNumericValue("constr_viol_tol", wanted.constraint_tolerance);
  list->SetNumericValue("bound_relax_factor", 0.0);
  list->SetIntegerValue("max_iter", static_cast<Index>(wanted.max_iterations));
  list->SetStringValue("warm_start_same_structure", solved_before ? "yes" : "no");
  if (wanted.warm_barrier) {
    const double push = warm_push * *wanted.warm_barrier;
    list->SetStringValue("warm_start_init_point", "yes");
    list->SetNumericValue("mu_init", *wanted.warm_barrier);
    for (const char* name :
         {"warm_start_bound_push", "warm_start_bound_frac", "warm_start_slack_bound_push",
          "warm_start_slack_bound_frac", "warm_start_mult_bound_push"}) {
      list->SetNumericValue(name, push);
    }
  }
  if (wanted.check_derivatives) list->SetStringValue("derivative_test", "second-order");
  for (const SolverSetting& setting : wanted.more) {
    std::optional<Fault> fault;
    if (is_refused(setting.name)) {
      fault = option_fault(FaultCode::unsupported,
                           "the setting '" + setting.name +
                               "' is not offered: derivatives are exact, and no files are written",
                           setting.name);
    } else if (!list->SetStringValue(setting.name, setting.value)) {
      // Numbers have setters of their own.
      char* end = nullptr;
      const double number = std::strtod(setting.value.c_str(), &end);
      const bool is_number = end != setting.value.c_str() && *end == '\0';
      if (!is_number || !(list->SetNumericValue(setting.name, number) ||
                          (number == std::floor(number) && std::abs(number) <= most_iterations &&
                           list->SetIntegerValue(setting.name, static_cast<Index>(number))))) {
        fault = option_fault(FaultCode::unsupported,
                             "the solver has no setting '" + setting.name + "' with the value '" +
                                 setting.value + "'",
                             setting.name);
      }
    }
    if (fault) {
      *list = *before;
      return fault;
    }
  }
  options = wanted;
  return std::nullopt;
}

std::optional<Fault> Solver::State::check_start(const SolverPoint& start) const {
  const auto check = [](const char* name, const std::vector<double>& numbers, std::size_t size,
                        bool may_be_empty) -> std::optional<Fault> {
    if (may_be_empty && numbers.empty()) return std::nullopt;
    if (numbers.size() != size) {
      return Fault{FaultCode::mismatched_size,
                   std::string("the start has ") + std::to_string(numbers.size()) + " " + name +
                       "; the program has " + std::to_string(size),
                   std::nullopt,
                   name,
                   static_cast<double>(numbers.size()),
                   static_cast<double>(size)};
    }
    for (std::size_t i = 0; i < size; ++i) {
      if (std::isfinite(numbers[i])) continue;
      return Fault{FaultCode::not_finite,
                   "the start's " + std::string(name) + " " + std::to_string(i) + " is " +
                       to_text(numbers[i]) + "; it must be a finite number",
                   i,
                   name,
                   numbers[i],
                   std::nullopt};
    }
    return std::nullopt;
  };
  const std::size_t n = program.variable_ranges().size();
  const std::size_t m = program.constraint_ranges().size();
  const bool cold = !options.warm_barrier;
  if (auto fault = check("variables", start.variables, n, false)) return fault;
  if (auto fault = check("lower_multipliers", start.lower_multipliers, n, cold)) return fault;
  if (auto fault = check("upper_multipliers", start.upper_multipliers, n, cold)) return fault;
  return check("constraint_multipliers", start.constraint_multipliers, m, cold);
}

Solver::Solver(std::unique_ptr<State> state) : state_(std::move(state)) {}
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;
Solver::~Solver() = default;

Result<Solver> Solver::make(NonlinearProgram& program, const SolverOptions& options) {
  const auto inside = [](const SparsePattern& pattern, std::size_t rows, std::size_t columns) {
    const auto within = [](const std::vector<int>& places, std::size_t size) {
      return std::all_of(places.begin(), places.end(), [size](int place) {
        return place >= 0 && static_cast<std::size_t>(place) < size;
      });
    };
    return pattern.rows.size() == pattern.columns.size() && within(pattern.rows, rows) &&
           within(pattern.columns, columns);
  };
  const std::size_t n = program.variable_ranges().size();
  if (!inside(program.jacobian_pattern(), program.constraint_ranges().size(), n) ||
      !inside(program.hessian_pattern(), n, n)) {
    return option_fault(FaultCode::mismatched_size,
                        "a pattern of derivatives points outside the program", "pattern");
  }
  auto state = std::make_unique<State>(program);
  state->application = new Ipopt::IpoptApplication(options.check_derivatives);
  if (options.check_derivatives) {
    state->journal = new DerivativeJournal;
    state->application->Jnlst()->AddJournal(Ipopt::GetRawPtr(state->journal));
  }
  // No file of options is read.
  if (state->application->Initialize("") != Ipopt::Solve_Succeeded) {
    return option_fault(FaultCode::unsupported, "the solver could not be initialised", "solver");
  }
  if (auto fault = state->configure(options)) return *std::move(fault);
  return Solver(std::move(state));
}

std::optional<Fault> Solver::change(const SolverOptions& options) {
  return state_->configure(options);
}

Result<Solution> Solver::solve(const SolverPoint& start) {
  State& state = *state_;
  if (auto fault = state.check_start(start)) return *std::move(fault);
  Adapter& adapter = *state.adapter;
  adapter.start = start;
  adapter.answer = {};
  adapter.progress = state.options.progress;
  adapter.time_limit_s = state.options.time_limit_s;
  adapter.out_of_time = adapter.cancelled = false;
  adapter.thrown = nullptr;
  adapter.begin = Clock::now();

  Ipopt::SmartPtr<Ipopt::TNLP> tnlp = Ipopt::GetRawPtr(state.adapter);
  Ipopt::IpoptApplication& application = *state.application;
  const Ipopt::ApplicationReturnStatus status =
      state.solved_before ? application.ReOptimizeTNLP(tnlp) : application.OptimizeTNLP(tnlp);
  if (adapter.thrown) std::rethrow_exception(adapter.thrown);

  Solution& answer = adapter.answer;
  answer.seconds = seconds_since(adapter.begin);
  const bool has_point = !answer.point.variables.empty();
  if (has_point) {
    if (!state.solved_before) {
      state.solved_before = true;
      application.Options()->SetStringValue("warm_start_same_structure", "yes");
    }
    // Where the point was moved into its ranges, the constraints are those of the moved point.
    NonlinearProgram& program = state.program;
    program.move_to(answer.point.variables);
    program.constraints(answer.constraints);
    answer.objective = program.objective();
    for (std::size_t i = 0; i < answer.constraints.size(); ++i) {
      answer.constraint_error =
          std::max(answer.constraint_error,
                   violation(program.constraint_ranges()[i], answer.constraints[i]));
    }
    for (std::size_t i = 0; i < answer.point.variables.size(); ++i) {
      answer.constraint_error =
          std::max(answer.constraint_error,
                   violation(program.variable_ranges()[i], answer.point.variables[i]));
    }
  }
  if (Ipopt::IsValid(application.Statistics())) {
    Number dual = 0.0, primal = 0.0, complementarity = 0.0;
    application.Statistics()->ScaledInfeasibilities(dual, primal, complementarity,
                                                    answer.optimality_error);
    answer.iterations = static_cast<std::size_t>(application.Statistics()->IterationCount());
  }
  if (Ipopt::IsValid(state.journal)) answer.wrong_derivatives = state.journal->marked;
  answer.status = adapter.out_of_time ? "the time limit was reached" : words_of(status);
  if (status == Ipopt::Solve_Succeeded) return std::move(answer);

  answer.finished = false;
  const bool out_of_budget = adapter.out_of_time || status == Ipopt::Maximum_Iterations_Exceeded;
  if (out_of_budget && has_point && state.options.keep_unfinished) return std::move(answer);
  return Fault{adapter.cancelled ? FaultCode::cancelled : FaultCode::no_convergence,
               adapter.cancelled
                   ? "stopped on request after " + std::to_string(answer.iterations) + " iterations"
                   : "no solution after " + std::to_string(answer.iterations) +
                         " iterations: " + answer.status,
               std::nullopt,
               "iterations",
               static_cast<double>(answer.iterations),
               std::nullopt};
}

Result<Solution> solve(NonlinearProgram& program, const SolverPoint& start,
                       const SolverOptions& options) {
  Result<Solver> solver = Solver::make(program, options);
  if (!solver) return solver.fault();
  return solver->solve(start);
}

}  // namespace hodograph
