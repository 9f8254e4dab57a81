// SPDX-License-Identifier: MIT
// The planar C² spline's equations solved: damped Newton, a continuation where that fails, and a
// search among the other solutions where the data are wild.
#pragma once

#include <cstddef>
#include <vector>

#include "planar_spline_system.hpp"

namespace hodograph::planar_spline_detail {

struct SplineSolution {
  std::vector<Number> z;
  bool converged = false;
  bool continued = false;        ///< a continuation was needed somewhere
  std::size_t steps = 0;         ///< Newton steps on the whole system
  std::size_t alternatives = 0;  ///< other starts that were tried
  std::size_t found = 0;         ///< solutions found, the first one included
  std::size_t taken = 0;         ///< how often another one had less bending energy
  Misfit misfit;
};

/// Solves the problem; sets problem.closure when it is periodic.
/// Newton starts from the ordinary cubic spline, every step is checked for descent. Where the
/// preimage turns by more than 75° (the tangent by 150°) from the middle of one span to the middle
/// of the next, the solution in which it turns the other way is tried as well, and taken when it
/// has less bending energy: at most `most_alternatives` places, the sharpest turns first.
SplineSolution solve(SplineProblem& problem, std::size_t most_alternatives);

/// ∫κ²ds over all spans, by adaptive quadrature to about 8 digits.
double quadrature_energy(const SplineProblem& problem, const std::vector<Number>& z);

}  // namespace hodograph::planar_spline_detail
