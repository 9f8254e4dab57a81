// SPDX-License-Identifier: MIT
// An optimal control problem as a nonlinear program: direct multiple shooting with Runge-Kutta
// steps of order four, exact sparse Jacobian and exact sparse Hessian of the Lagrangian.
//
// Horizon τ in [0, 1] in N equal intervals, the control constant on each:
//   minimise  Σ_{k<N} stage_cost(k, x_k, u_k, p) + end_cost(x_N, p)
//   subject to  x_{k+1} = Φ_k(x_k, u_k, p)         (the defects; Φ: steps_per_interval RK4 steps)
//               path_values(k, x_k, u_k, p) in their ranges, k < N
//               end_values(x_N, p) in their ranges, and every x, u, p in its range.
// A fixed start is a range of one number; a free final time T is a parameter with which the model
// multiplies its derivative.
//
// Variables z: x_0, u_0, x_1, u_1, ..., x_{N-1}, u_{N-1}, x_N, p. Constraints g: for each k the
// defects Φ_k - x_{k+1}, then its path values; last the end values.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/control/nonlinear_program.hpp"
#include "hodograph/control/runge_kutta.hpp"
#include "hodograph/foundation/second_order.hpp"

namespace hodograph {

/// What a model consists of. Every function is a template on the scalar S (double and
/// SecondOrder<double, N>); x, u and p are std::array<S, states / controls / parameters>:
///   derivative(double τ, x, u, p)            → std::array<S, states>, dx/dτ
///   stage_cost(std::size_t k, x, u, p)       → S
///   end_cost(x, p)                           → S
///   path_values(std::size_t k, x, u, p)      → std::array<S, path_constraints>
///   end_values(x, p)                         → std::array<S, end_constraints>
/// Sizes may be 0 except that of the states. Twice continuously differentiable where the solver
/// goes; outside their domain they return what is not finite.
template <class M>
concept ShootingModel = requires {
  { M::states } -> std::convertible_to<std::size_t>;
  { M::controls } -> std::convertible_to<std::size_t>;
  { M::parameters } -> std::convertible_to<std::size_t>;
  { M::path_constraints } -> std::convertible_to<std::size_t>;
  { M::end_constraints } -> std::convertible_to<std::size_t>;
} && (M::states > 0);

/// The program of a model. Cost of all second derivatives: N steps of the model on a scalar of
/// states + controls + parameters variables.
template <ShootingModel Model>
class MultipleShooting final : public NonlinearProgram {
 public:
  static constexpr std::size_t n = Model::states, m = Model::controls, q = Model::parameters;
  static constexpr std::size_t c = Model::path_constraints, e = Model::end_constraints;
  static constexpr std::size_t width = n + m, local = n + m + q;

  /// N = intervals ≥ 1, steps_per_interval ≥ 1 (contract). All ranges are those of Range{}, end and
  /// path ranges included.
  MultipleShooting(Model model, std::size_t intervals, std::size_t steps_per_interval = 1)
      : model_(std::move(model)),
        intervals_(intervals),
        steps_(steps_per_interval),
        ranges_(intervals * width + n + q),
        constraint_ranges_(intervals * (n + c) + e),
        point_(ranges_.size()),
        stages_(intervals),
        values_(constraint_ranges_.size()) {
    for (std::size_t k = 0; k < intervals; ++k) {
      for (std::size_t i = 0; i < n; ++i) constraint_ranges_[k * (n + c) + i] = Range::only(0.0);
    }
    make_patterns();
  }

  std::size_t intervals() const { return intervals_; }
  const Model& model() const { return model_; }
  /// To change what a model refers to (a moved reference) between solutions; forgets the values.
  Model& change_model() {
    values_known_ = derivatives_known_ = false;
    return model_;
  }

  /// Where the parts of z begin: x_k (k ≤ N), u_k (k < N), p.
  std::size_t state_at(std::size_t k) const { return k * width; }
  std::size_t control_at(std::size_t k) const { return k * width + n; }
  std::size_t parameters_at() const { return intervals_ * width + n; }
  /// Where the parts of g begin: defects and path values of interval k, and end values.
  std::size_t defect_at(std::size_t k) const { return k * (n + c); }
  std::size_t path_value_at(std::size_t k) const { return k * (n + c) + n; }
  std::size_t end_value_at() const { return intervals_ * (n + c); }

  /// Ranges to set, of the parts of z and g.
  std::span<Range, n> state_ranges(std::size_t k) {
    return std::span<Range, n>(ranges_.data() + state_at(k), n);
  }
  std::span<Range, m> control_ranges(std::size_t k) {
    return std::span<Range, m>(ranges_.data() + control_at(k), m);
  }
  std::span<Range, q> parameter_ranges() {
    return std::span<Range, q>(ranges_.data() + parameters_at(), q);
  }
  std::span<Range, c> path_ranges(std::size_t k) {
    return std::span<Range, c>(constraint_ranges_.data() + path_value_at(k), c);
  }
  std::span<Range, e> end_ranges() {
    return std::span<Range, e>(constraint_ranges_.data() + end_value_at(), e);
  }
  /// x_0 = start.
  void fix_start(const std::array<double, n>& start) {
    for (std::size_t i = 0; i < n; ++i) ranges_[i] = Range::only(start[i]);
  }

  /// Φ_k on any scalar: the state at the end of interval k.
  template <class S>
  std::array<S, n> shoot(std::size_t k, std::array<S, n> x, const std::array<S, m>& u,
                         const std::array<S, q>& p) const {
    const double h = 1.0 / static_cast<double>(intervals_ * steps_);
    const auto slope = [&](double tau, const std::array<S, n>& at) {
      return model_.derivative(tau, at, u, p);
    };
    for (std::size_t s = 0; s < steps_; ++s) {
      x = runge_kutta_step<S, n>(slope, static_cast<double>(k * steps_ + s) * h, h, x);
    }
    return x;
  }

  std::span<const Range> variable_ranges() const override { return ranges_; }
  std::span<const Range> constraint_ranges() const override { return constraint_ranges_; }
  const SparsePattern& jacobian_pattern() const override { return jacobian_; }
  const SparsePattern& hessian_pattern() const override { return hessian_; }

  void move_to(std::span<const double> z) override {
    point_.assign(z.begin(), z.end());
    values_known_ = derivatives_known_ = false;
  }
  double objective() override {
    find_values();
    return cost_;
  }
  void constraints(std::span<double> result) override {
    find_values();
    std::copy(values_.begin(), values_.end(), result.begin());
  }
  void gradient(std::span<double> result) override;
  void jacobian(std::span<double> entries) override;
  void hessian(double factor, std::span<const double> multipliers,
               std::span<double> entries) override;

 private:
  using Jet = SecondOrder<double, local>;
  using EndJet = SecondOrder<double, n + q>;
  struct Stage {
    std::array<Jet, n> next;
    std::array<Jet, c> path;
    Jet cost;
  };
  struct End {
    std::array<EndJet, e> values;
    EndJet cost;
  };

  template <class S, std::size_t count>
  std::array<S, count> part(std::size_t begin, std::size_t first_variable) const {
    std::array<S, count> result;
    for (std::size_t i = 0; i < count; ++i) {
      if constexpr (std::same_as<S, double>) {
        result[i] = point_[begin + i];
      } else {
        result[i] = S::variable(point_[begin + i], first_variable + i);
      }
    }
    return result;
  }
  void make_patterns();
  void find_values();
  void find_derivatives();

  Model model_;
  std::size_t intervals_, steps_;
  std::vector<Range> ranges_, constraint_ranges_;
  SparsePattern jacobian_, hessian_;
  std::vector<double> point_;
  std::vector<Stage> stages_;
  End end_;
  std::vector<double> values_;
  double cost_ = 0.0;
  bool values_known_ = false, derivatives_known_ = false;
};

}  // namespace hodograph

#include "hodograph/control/detail/multiple_shooting_program.hpp"
