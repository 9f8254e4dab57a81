// SPDX-License-Identifier: MIT
// The values, derivatives and patterns of a multiple-shooting program.
#pragma once

#include <algorithm>

#include "hodograph/control/multiple_shooting.hpp"

namespace hodograph {

template <ShootingModel Model>
void MultipleShooting<Model>::make_patterns() {
  const auto put = [](SparsePattern& pattern, std::size_t row, std::size_t column) {
    pattern.rows.push_back(static_cast<int>(row));
    pattern.columns.push_back(static_cast<int>(column));
  };
  const std::size_t p = parameters_at(), last = state_at(intervals_);
  for (std::size_t k = 0; k < intervals_; ++k) {
    for (std::size_t i = 0; i < n + c; ++i) {
      for (std::size_t j = 0; j < width; ++j) put(jacobian_, defect_at(k) + i, state_at(k) + j);
      for (std::size_t j = 0; j < q; ++j) put(jacobian_, defect_at(k) + i, p + j);
      if (i < n) put(jacobian_, defect_at(k) + i, state_at(k + 1) + i);
    }
    for (std::size_t i = 0; i < width; ++i) {
      for (std::size_t j = 0; j <= i; ++j) put(hessian_, state_at(k) + i, state_at(k) + j);
    }
    for (std::size_t i = 0; i < q; ++i) {
      for (std::size_t j = 0; j < width; ++j) put(hessian_, p + i, state_at(k) + j);
    }
  }
  for (std::size_t i = 0; i < e; ++i) {
    for (std::size_t j = 0; j < n + q; ++j) put(jacobian_, end_value_at() + i, last + j);
  }
  for (std::size_t i = 0; i < n + q; ++i) {  // the parameters stand behind the last state
    for (std::size_t j = 0; j <= i; ++j) put(hessian_, last + i, last + j);
  }
}

template <ShootingModel Model>
void MultipleShooting<Model>::find_values() {
  if (values_known_) return;
  const std::array<double, q> p = part<double, q>(parameters_at(), 0);
  cost_ = 0.0;
  for (std::size_t k = 0; k < intervals_; ++k) {
    const std::array<double, n> x = part<double, n>(state_at(k), 0);
    const std::array<double, m> u = part<double, m>(control_at(k), 0);
    const std::array<double, n> next = shoot<double>(k, x, u, p);
    for (std::size_t i = 0; i < n; ++i) {
      values_[defect_at(k) + i] = next[i] - point_[state_at(k + 1) + i];
    }
    const std::array<double, c> path = model_.path_values(k, x, u, p);
    std::copy(path.begin(), path.end(),
              values_.begin() + static_cast<std::ptrdiff_t>(path_value_at(k)));
    cost_ += model_.stage_cost(k, x, u, p);
  }
  const std::array<double, n> x = part<double, n>(state_at(intervals_), 0);
  const std::array<double, e> end = model_.end_values(x, p);
  std::copy(end.begin(), end.end(), values_.begin() + static_cast<std::ptrdiff_t>(end_value_at()));
  cost_ += model_.end_cost(x, p);
  values_known_ = true;
}

template <ShootingModel Model>
void MultipleShooting<Model>::find_derivatives() {
  if (derivatives_known_) return;
  const std::array<Jet, q> p = part<Jet, q>(parameters_at(), width);
  for (std::size_t k = 0; k < intervals_; ++k) {
    const std::array<Jet, n> x = part<Jet, n>(state_at(k), 0);
    const std::array<Jet, m> u = part<Jet, m>(control_at(k), n);
    Stage& stage = stages_[k];
    stage.next = shoot<Jet>(k, x, u, p);
    stage.path = model_.path_values(k, x, u, p);
    stage.cost = model_.stage_cost(k, x, u, p);
  }
  const std::array<EndJet, n> x = part<EndJet, n>(state_at(intervals_), 0);
  const std::array<EndJet, q> end_p = part<EndJet, q>(parameters_at(), n);
  end_.values = model_.end_values(x, end_p);
  end_.cost = model_.end_cost(x, end_p);
  derivatives_known_ = true;
}

template <ShootingModel Model>
void MultipleShooting<Model>::gradient(std::span<double> result) {
  find_derivatives();
  std::fill(result.begin(), result.end(), 0.0);
  for (std::size_t k = 0; k < intervals_; ++k) {
    const Jet& cost = stages_[k].cost;
    for (std::size_t i = 0; i < width; ++i) result[state_at(k) + i] += cost.gradient(i);
    for (std::size_t i = 0; i < q; ++i) result[parameters_at() + i] += cost.gradient(width + i);
  }
  for (std::size_t i = 0; i < n + q; ++i) {
    result[state_at(intervals_) + i] += end_.cost.gradient(i);
  }
}

template <ShootingModel Model>
void MultipleShooting<Model>::jacobian(std::span<double> entries) {
  find_derivatives();
  std::size_t at = 0;
  for (const Stage& stage : stages_) {
    for (std::size_t i = 0; i < n + c; ++i) {
      const Jet& row = i < n ? stage.next[i] : stage.path[i - n];
      for (std::size_t j = 0; j < local; ++j) entries[at++] = row.gradient(j);
      if (i < n) entries[at++] = -1.0;
    }
  }
  for (const EndJet& row : end_.values) {
    for (std::size_t j = 0; j < n + q; ++j) entries[at++] = row.gradient(j);
  }
}

template <ShootingModel Model>
void MultipleShooting<Model>::hessian(double factor, std::span<const double> multipliers,
                                      std::span<double> entries) {
  find_derivatives();
  // Places between two parameters belong to all intervals: they are summed apart.
  std::array<double, q*(q + 1) / 2> shared{};
  std::size_t at = 0;
  for (std::size_t k = 0; k < intervals_; ++k) {
    const Stage& stage = stages_[k];
    std::array<double, Jet::triangle> sum;
    const auto second = [](const auto& jet) {
      return jet.data() + 1 + std::remove_cvref_t<decltype(jet)>::variables;
    };
    for (std::size_t t = 0; t < Jet::triangle; ++t) sum[t] = factor * second(stage.cost)[t];
    for (std::size_t i = 0; i < n + c; ++i) {
      const double* row = second(i < n ? stage.next[i] : stage.path[i - n]);
      const double weight = multipliers[defect_at(k) + i];
      for (std::size_t t = 0; t < Jet::triangle; ++t) sum[t] += weight * row[t];
    }
    // The triangle's first rows are those of x and u; then come those of p.
    const double* from = sum.data();
    constexpr std::size_t own = width * (width + 1) / 2;
    std::copy(from, from + own, entries.begin() + static_cast<std::ptrdiff_t>(at));
    at += own;
    from += own;
    double* to = shared.data();
    for (std::size_t i = 0; i < q; ++i) {
      std::copy(from, from + width, entries.begin() + static_cast<std::ptrdiff_t>(at));
      at += width;
      from += width;
      for (std::size_t j = 0; j <= i; ++j) *to++ += *from++;
    }
  }
  const double* from = shared.data();
  for (std::size_t i = 0; i < n + q; ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      double sum = factor * end_.cost.hessian(i, j);
      for (std::size_t r = 0; r < e; ++r) {
        sum += multipliers[end_value_at() + r] * end_.values[r].hessian(i, j);
      }
      if (j >= n) sum += *from++;
      entries[at++] = sum;
    }
  }
}

}  // namespace hodograph
