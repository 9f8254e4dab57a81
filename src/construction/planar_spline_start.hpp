// SPDX-License-Identifier: MIT
// Where Newton's iteration for the planar C² spline begins.
#pragma once

#include <vector>

#include "planar_spline_system.hpp"

namespace hodograph::planar_spline_detail {

/// The principal square root, or its negative where that is nearer to `like`.
Number root_near(const Number& square, const Number& like);

/// z from the preimage's values m_i = w(1/2) at the middle of every span:
/// (a + 2z + b)/4 = m, a real tridiagonal system; m_i = z_i on a straight end span.
std::vector<Number> middles_to_unknowns(const SplineProblem& problem,
                                        const std::vector<Number>& middles);
/// The value at the middle of one span, and of every span.
Number middle_value(const SplineProblem& problem, const std::vector<Number>& z, std::size_t i);
std::vector<Number> unknowns_to_middles(const SplineProblem& problem, const std::vector<Number>& z);

/// From the ordinary C² cubic spline with the same knots (parabolic end spans, or periodic): the
/// square root of its derivative at the middle of every span, its sign continued from span to span.
/// Sets problem.closure when periodic. Not for fixed ends.
std::vector<Number> start_from_cubic_spline(SplineProblem& problem);

}  // namespace hodograph::planar_spline_detail
