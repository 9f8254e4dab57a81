// SPDX-License-Identifier: MIT
// Private to control/: trying several initial guesses and keeping the best answer.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/control/lunar_ascent.hpp"

namespace hodograph::ascent_detail {

/// Bad numbers in what both ascents share.
std::optional<Fault> check(const AscentSolving& solving, std::size_t intervals);

/// A number that is not in [low, high].
std::optional<Fault> check_number(const char* name, double value, double low, double high);

struct Best {
  Solution solution;
  AscentSolved facts;
};

/// Solves from guess(0), guess(1), ... and keeps the answer of least objective.
Result<Best> best_of(NonlinearProgram& program, const AscentSolving& solving,
                     const std::function<SolverPoint(std::size_t)>& guess);

}  // namespace hodograph::ascent_detail
