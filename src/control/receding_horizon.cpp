// SPDX-License-Identifier: MIT
#include "hodograph/control/receding_horizon.hpp"

#include <chrono>
#include <cmath>
#include <utility>

#include "follow_program.hpp"
#include "follow_stretch.hpp"

namespace hodograph {

namespace {

using namespace control_detail;
using Clock = std::chrono::steady_clock;

/// What a plan asks of a vehicle's program.
struct Planner {
  virtual ~Planner() = default;
  virtual Result<HorizonPlan> plan(const FollowStart& measured) = 0;
  virtual FollowStart predicted() const = 0;
};

/// The barrier parameter that a warm start begins with.
constexpr double warm_barrier = 1e-4;  // not a tolerance: between that of a guess and of an answer

/// How much of the path's tube a car may use that was pushed out of its own.
constexpr double soft_share = 0.9;

double clamped(double x, double most) { return std::clamp(x, -most, most); }

/// The nearest state that keeps the limits, for a solver that may start on them.
FollowStart within(const FollowStart& measured, const FollowLimits& limits, double tube, bool soft,
                   bool& moved) {
  constexpr double inside = 0.999;
  FollowStart start = measured;
  const double off = std::hypot(start.offset[0], start.offset[1]);
  const double widest = soft ? soft_share * tube : inside * limits.offset;
  if (off > widest) {
    for (double& offset : start.offset) offset *= widest / off;
  }
  constexpr double quarter = 0.5 * std::numbers::pi;
  start.heading = clamped(start.heading, inside * quarter);
  start.speed = std::clamp(start.speed, 0.0, limits.speed);
  if (start.velocity) {
    const double speed = norm(*start.velocity);
    if (speed > inside * limits.speed) {
      *start.velocity = (inside * limits.speed / speed) * *start.velocity;
    }
  }
  moved = start.offset != measured.offset || start.heading != measured.heading ||
          start.speed != measured.speed || start.velocity != measured.velocity;
  return start;
}

template <class Vehicle>
class Horizon final : public Planner {
 public:
  using Program = FollowProgram<Vehicle, false>;
  using Path = ReferencePath<typename Vehicle::A>;

  Horizon(std::shared_ptr<const Path> path, const FollowedStretch& stretch,
          const FollowLimits& limits, const FollowStart& start, const FollowOptions& options,
          double centre)
      : path_(path),
        limits_(limits),
        options_(options),
        program_(path, stretch, limits, start, options),
        tube_(stretch.tube) {
    program_.program().change_model().centre_weight =
        centre * options.duration / (limits.offset * limits.offset);
  }

  Result<HorizonPlan> plan(const FollowStart& measured) override {
    const auto begin = Clock::now();
    HorizonPlan plan;
    const FollowStart start = within(measured, limits_, tube_, Program::soft, plan.recovered);
    program_.set_start(start);
    program_.end_slowly();
    if (!solver_) {
      auto made = Solver::make(program_.program(), options_.solver);
      if (!made) return made.fault();
      solver_.emplace(*std::move(made));
    }
    std::optional<Result<Solution>> solution;
    if (known_) {
      SolverPoint from = program_.shifted(answer_.point);
      program_.place_start(from);
      SolverOptions warm = options_.solver;
      warm.warm_barrier = warm_barrier;
      if (auto fault = solver_->change(warm)) return *fault;
      solution = solver_->solve(from);
      plan.warm = solution->has_value();
    }
    if (!plan.warm) {
      plan.recovered = plan.recovered || known_;
      if (auto fault = solver_->change(options_.solver)) return *fault;
      solution = solver_->solve(program_.guess());
      if (!solution->has_value()) return solution->fault();
    }
    answer_ = **solution;
    known_ = true;
    plan.iterations = answer_.iterations;
    plan.finished = answer_.finished;
    plan.latency_s = std::chrono::duration<double>(Clock::now() - begin).count();
    plan.following = program_.following(answer_);
    return plan;
  }

  FollowStart predicted() const override { return program_.start_after(answer_, 1); }

 private:
  std::shared_ptr<const Path> path_;
  FollowLimits limits_;
  FollowOptions options_;
  Program program_;
  std::optional<Solver> solver_;
  Solution answer_;
  bool known_ = false;
  double tube_;
};

Fault number_fault(const char* name, double value) {
  return {FaultCode::outside_domain,
          std::string("the ") + name + " is " + to_text(value) + "; it must be positive and finite",
          std::nullopt,
          name,
          value,
          0.0};
}

}  // namespace

struct RecedingHorizon::State {
  std::unique_ptr<Planner> planner;
};

RecedingHorizon::RecedingHorizon(std::unique_ptr<State> state) : state_(std::move(state)) {}
RecedingHorizon::RecedingHorizon(RecedingHorizon&&) noexcept = default;
RecedingHorizon& RecedingHorizon::operator=(RecedingHorizon&&) noexcept = default;
RecedingHorizon::~RecedingHorizon() = default;

Result<RecedingHorizon> RecedingHorizon::make(const AnyPath& path, const FollowLimits& limits,
                                              const HorizonOptions& options) {
  if (!(options.step > 0.0 && std::isfinite(options.step))) {
    return number_fault("step", options.step);
  }
  if (!(options.centre >= 0.0 && std::isfinite(options.centre))) {
    return number_fault("centre", options.centre);
  }
  FollowOptions follow;
  follow.aim = FollowAim::most_progress;
  follow.intervals = options.intervals;
  follow.duration = options.step * static_cast<double>(options.intervals);
  follow.effort = options.effort;
  follow.solver.tolerance = horizon_tolerance;
  follow.solver.constraint_tolerance = horizon_tolerance;
  follow.solver.time_limit_s = options.time_limit_s;
  follow.solver.max_iterations = options.max_iterations;
  follow.solver.keep_unfinished = options.time_limit_s > 0.0;
  FollowStart start;
  start.xi = path.xi_begin();
  const auto stretch = followed_stretch(path, limits, start, follow);
  if (!stretch) return stretch.fault();
  auto state = std::make_unique<State>();
  const auto put = [&]<class Vehicle>(Vehicle) -> std::optional<Fault> {
    using Path = ReferencePath<typename Vehicle::A>;
    auto reference = Path::of(path, stretch->progress_by);
    if (!reference) return reference.fault();
    state->planner =
        std::make_unique<Horizon<Vehicle>>(std::make_shared<const Path>(*std::move(reference)),
                                           *stretch, limits, start, follow, options.centre);
    return std::nullopt;
  };
  if (path.dimension() == 3) {
    if (const auto fault = put(Glider{})) return *fault;
  } else if (const auto fault = options.hard ? put(Car{}) : put(SoftCar{})) {
    return *fault;
  }
  return RecedingHorizon(std::move(state));
}

Result<HorizonPlan> RecedingHorizon::plan(const FollowStart& measured) {
  for (const double x :
       {measured.xi, measured.offset[0], measured.offset[1], measured.heading, measured.speed}) {
    if (!std::isfinite(x)) return number_fault("measured state", x);
  }
  return state_->planner->plan(measured);
}

FollowStart RecedingHorizon::predicted() const { return state_->planner->predicted(); }

}  // namespace hodograph
