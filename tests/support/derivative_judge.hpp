// SPDX-License-Identifier: MIT
// Judges derivatives by differences in 40 digits, and by the solver's own checker.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstddef>
#include <vector>

#include "hodograph/control/solver.hpp"
#include "hodograph/foundation/second_order.hpp"
#include "tests/support/compare.hpp"

namespace hodograph::test {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<40>,
                                           boost::multiprecision::et_off>;

/// The gradients and Hessians of some functions, f(std::array<S, count>) → std::vector<S> on any
/// scalar S, against central differences in 40 digits, to `operations` roundings of the largest
/// number of the function's value and derivatives.
template <std::size_t count, class F>
void expect_right_derivatives(const F& f, const std::array<double, count>& at, double operations) {
  using Jet = SecondOrder<double, count>;
  const Wide h("1e-10");  // not a tolerance: leaves errors of 1e-20
  std::array<Jet, count> jets;
  std::array<Wide, count> wide;
  for (std::size_t i = 0; i < count; ++i) {
    jets[i] = Jet::variable(at[i], i);
    wide[i] = at[i];
  }
  const std::vector<Jet> exact = f(jets);
  const auto moved = [&](std::size_t i, int di, std::size_t j, int dj) {
    std::array<Wide, count> z = wide;
    z[i] += di * h;
    z[j] += dj * h;
    return f(z);
  };
  const auto size_of = [](const Jet& jet) {
    double size = 0.0;
    for (std::size_t c = 0; c < Jet::size; ++c) size = std::max(size, std::abs(jet.data()[c]));
    return size;
  };
  for (std::size_t i = 0; i < count; ++i) {
    const auto after = moved(i, 1, i, 0), before = moved(i, -1, i, 0);
    for (std::size_t k = 0; k < exact.size(); ++k) {
      const Wide slope = (after[k] - before[k]) / (2 * h);
      EXPECT_CLOSE(exact[k].gradient(i), static_cast<double>(slope), operations, size_of(exact[k]))
          << "function " << k << ", variable " << i;
    }
    for (std::size_t j = 0; j <= i; ++j) {
      const auto pp = moved(i, 1, j, 1), pm = moved(i, 1, j, -1);
      const auto mp = moved(i, -1, j, 1), mm = moved(i, -1, j, -1);
      for (std::size_t k = 0; k < exact.size(); ++k) {
        const Wide bend = (pp[k] - pm[k] - mp[k] + mm[k]) / (4 * h * h);
        EXPECT_CLOSE(exact[k].hessian(i, j), static_cast<double>(bend), operations,
                     size_of(exact[k]))
            << "function " << k << ", variables " << i << " and " << j;
      }
    }
  }
}

/// The same of everything that a program computes on interval 1: the next state, path values and
/// stage cost, of (x, u, p).
template <class Program>
void expect_right_stage_derivatives(const Program& program,
                                    const std::array<double, Program::local>& at,
                                    double operations) {
  expect_right_derivatives(
      [&program]<class S>(const std::array<S, Program::local>& point) {
        std::array<S, Program::n> x;
        std::array<S, Program::m> u;
        std::array<S, Program::q> p;
        for (std::size_t i = 0; i < Program::local; ++i) {
          (i < Program::n                ? x[i]
           : i < Program::n + Program::m ? u[i - Program::n]
                                         : p[i - Program::n - Program::m]) = point[i];
        }
        const auto next = program.template shoot<S>(1, x, u, p);
        const auto path = program.model().path_values(1, x, u, p);
        std::vector<S> all(next.begin(), next.end());
        all.insert(all.end(), path.begin(), path.end());
        all.push_back(program.model().stage_cost(1, x, u, p));
        return all;
      },
      at, operations);
}

/// And of what it computes at the end, of (x, p).
template <class Program>
void expect_right_end_derivatives(const Program& program,
                                  const std::array<double, Program::n + Program::q>& at,
                                  double operations) {
  expect_right_derivatives(
      [&program]<class S>(const std::array<S, Program::n + Program::q>& point) {
        std::array<S, Program::n> x;
        std::array<S, Program::q> p;
        std::copy_n(point.begin(), Program::n, x.begin());
        std::copy_n(point.begin() + Program::n, Program::q, p.begin());
        const auto values = program.model().end_values(x, p);
        std::vector<S> all(values.begin(), values.end());
        all.push_back(program.model().end_cost(x, p));
        return all;
      },
      at, operations);
}

/// How many derivatives the solver's own checker finds wrong, at a point.
inline std::size_t wrong_derivatives(NonlinearProgram& program, const SolverPoint& at) {
  SolverOptions options;
  options.check_derivatives = true;
  options.max_iterations = 0;
  options.keep_unfinished = true;
  return solve(program, at, options).value().wrong_derivatives;
}

}  // namespace hodograph::test
