// SPDX-License-Identifier: MIT
// What a solver of nonlinear programs asks: values, exact first and second derivatives, and where
// their entries stand.
//
//   minimise f(z)   subject to   lower ≤ z ≤ upper,   g_lower ≤ g(z) ≤ g_upper
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <vector>

namespace hodograph {

/// An interval that a number must lie in; by default all numbers.
struct Range {
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();

  /// The interval of one number.
  static constexpr Range only(double value) { return {value, value}; }
  friend constexpr bool operator==(const Range&, const Range&) = default;
};

/// Where the entries of a sparse matrix stand: entry e in row rows[e] and column columns[e],
/// counted from 0. No place appears twice.
struct SparsePattern {
  std::vector<int> rows, columns;
  std::size_t size() const { return rows.size(); }
};

/// A nonlinear program at a point that moves: the solver calls move_to, then asks for what it needs
/// there; values and derivatives are computed when first asked for. Sizes, ranges and patterns do
/// not change during a solution. One solution at a time uses an object.
class NonlinearProgram {
 public:
  virtual ~NonlinearProgram() = default;

  /// Bounds of the variables z and of the constraints g; their sizes are those of the program.
  /// A variable with lower = upper is a constant to the solver.
  virtual std::span<const Range> variable_ranges() const = 0;
  virtual std::span<const Range> constraint_ranges() const = 0;
  /// Places of ∂g_row/∂z_column.
  virtual const SparsePattern& jacobian_pattern() const = 0;
  /// Places of the Lagrangian's second derivatives, column ≤ row.
  virtual const SparsePattern& hessian_pattern() const = 0;

  /// Makes z the point of all that follows.
  virtual void move_to(std::span<const double> z) = 0;
  /// f; not finite where the point is outside the domain.
  virtual double objective() = 0;
  /// ∂f/∂z, dense.
  virtual void gradient(std::span<double> result) = 0;
  virtual void constraints(std::span<double> result) = 0;
  /// Entries in the order of jacobian_pattern().
  virtual void jacobian(std::span<double> entries) = 0;
  /// Entries of ∇²(factor f + Σ multipliers_i g_i), in the order of hessian_pattern().
  virtual void hessian(double factor, std::span<const double> multipliers,
                       std::span<double> entries) = 0;
};

}  // namespace hodograph
