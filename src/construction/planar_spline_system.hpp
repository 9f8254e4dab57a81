// SPDX-License-Identifier: MIT
// The equations of the C² PH quintic spline in the plane: one complex quadratic equation a span,
// each with its two neighbours, and Newton's step for them.
//
// Span i has the preimage a (1-u)² + 2 z_i (1-u) u + b u², in the global scaling, with
//   a = g_i z_{i-1} + (1 - g_i) z_i,   b = g_{i+1} z_i + (1 - g_{i+1}) z_{i+1},
//   g_i = h_i/(h_{i-1} + h_i)          at the node between the spans i - 1 and i,
// which makes the preimage C¹ and the curve C². That h_i ∫ w² is the chord Δq_i says
//   3a² + 3b² + 2z² + 3z(a + b) + ab = 15 Δq_i/h_i.
// With g = 1/2 and multiplied by 4 this is the equation of Farouki, Kuspa, Manni and Sestini,
// 3x² + 27z² + 3y² + xy + 13xz + 13zy = 60 Δq_i. A straight end (a linear preimage, a cubic span)
// has a = 2z - b, so that 20z² - 10zb + 5b² = 15 Δq/h; a span alone has 15z² = 15 Δq/h.
#pragma once

#include <cstddef>
#include <vector>

#include "hodograph/algebra/complex.hpp"

namespace hodograph::planar_spline_detail {

using Number = Complex<double>;

inline double squared(const Number& a) { return dot(a, a); }
inline Number reciprocal(const Number& a) {
  const double scale = 1.0 / squared(a);
  return {a.re * scale, -(a.im * scale)};
}

/// What stands before the first and after the last span.
enum class SplineEnd {
  straight,  ///< nothing: the preimage of the end span is linear
  fixed,     ///< a span whose z is given
  periodic,  ///< the other end, times the closure sign (both ends, or none)
};

/// What is to be solved.
struct SplineProblem {
  std::vector<Number> target;  ///< 15 Δq_i/h_i, scaled so that the largest is about 1
  std::vector<double> weight;  ///< g at the nodes 0 ... N (0 and N where not straight); empty: 1/2
  std::vector<double> step;    ///< h_i; empty: 1
  std::vector<double> importance;  ///< of every row in the merit: 1/(size of the targets near it)²
  SplineEnd first = SplineEnd::straight, last = SplineEnd::straight;
  Number before{}, after{};  ///< of fixed ends
  double closure = 1.0;      ///< ±1: z_{-1} = closure z_{N-1}, z_N = closure z_0

  std::size_t size() const { return target.size(); }
  double weight_at(std::size_t node) const { return weight.empty() ? 0.5 : weight[node]; }
  /// Fills `importance` from the targets.
  void weigh_rows();
};

/// The preimage of one span.
struct SpanCoefficients {
  Number a, z, b;
};
SpanCoefficients coefficients(const SplineProblem& problem, const std::vector<Number>& z,
                              std::size_t i);

/// How far a z is from a solution.
struct Misfit {
  double merit = 0.0;  ///< Σ importance |F|²
  double worst = 0.0;  ///< the largest |F|/(|a|² + |b|² + |z|²)
  std::size_t row = 0;
};

/// F, the equations' left sides less their right sides, and its derivatives, for one problem.
/// Memory 32 bytes a span (48 when periodic).
class SplineSystem {
 public:
  explicit SplineSystem(const SplineProblem& problem);

  Misfit measure(const std::vector<Number>& z) const;
  /// Newton's step at z, without pivoting; where it leads; and the misfit of z.
  Misfit newton_step(const std::vector<Number>& z, std::vector<Number>& moved);
  /// The step with row exchanges, for the few places where the other one breaks down.
  void pivoted_step(const std::vector<Number>& z);
  /// The solution x of J x = right instead, J the derivative at z; pivoted.
  void pivoted_solve(const std::vector<Number>& z, const std::vector<Number>& right);
  /// What the last of these found.
  const std::vector<Number>& step() const { return step_; }
  /// F at z, and |F|/(|a|² + |b|² + |z|²).
  std::vector<Number> values(const std::vector<Number>& z) const;
  std::vector<double> misfits(const std::vector<Number>& z) const;

 private:
  template <class Rows>
  Misfit eliminate(const Rows& rows, std::vector<Number>& moved);

  const SplineProblem& problem_;
  std::vector<Number> step_, ratio_, border_;
};

}  // namespace hodograph::planar_spline_detail
