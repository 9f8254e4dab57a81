// SPDX-License-Identifier: MIT
#include "planar_spline_solver.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "hodograph/foundation/scalar.hpp"
#include "planar_spline_start.hpp"

namespace hodograph::planar_spline_detail {
namespace {

/// F is a sum of 6 products of the node values with weights of total 13, each with a few roundings:
/// what is below this, relative to |a|² + |b|² + |z|², is rounding.
constexpr double settled_misfit = 24.0 * epsilon<double>();
/// Rounding z itself moves F by up to Σ|∂F/∂z| |z| ε, and a step amplifies that: an iteration that
/// no longer descends has settled below this.
constexpr double noise_misfit = 2048.0 * epsilon<double>();
/// Newton's error is squared in every step: from here on, the next is expected to settle.
constexpr double nearly_settled = 1e-7;  // its square is below settled_misfit
/// A step must lower the merit by this share of what the linear model promises.
constexpr double least_descent = 0.1;
constexpr int most_halvings = 14;
constexpr std::size_t most_steps = 30;
/// A span's influence on its neighbours decays at least by 0.2 a span where the data are tame:
/// this many spans around a place, and what is beyond does not matter to 1e-7.
constexpr std::size_t radius = 10;

struct Descent {
  bool converged = false;
  std::size_t steps = 0;
  Misfit misfit;
};

void move(const std::vector<Number>& z, double share, const std::vector<Number>& step,
          std::vector<Number>& moved) {
  const std::size_t size = z.size();
  if (share == 1.0) {
    for (std::size_t i = 0; i < size; ++i) moved[i] = z[i] + step[i];
  } else {
    for (std::size_t i = 0; i < size; ++i) moved[i] = z[i] + share * step[i];
  }
}

/// Newton's iteration from z, in place, at most `most` steps.
Descent descend(SplineSystem& system, std::vector<Number>& z, std::size_t most = most_steps) {
  Descent result;
  std::vector<Number> moved(z.size()), beyond(z.size());
  Misfit here = system.newton_step(z, moved);
  bool has_step = true;
  while (!(here.worst <= settled_misfit) && result.steps < most) {
    if (!has_step) here = system.newton_step(z, moved);
    ++result.steps;
    has_step = !(here.worst <= nearly_settled);
    Misfit next = has_step ? system.newton_step(moved, beyond) : system.measure(moved);
    const bool descends =
        next.merit <= (1.0 - least_descent) * here.merit || next.worst <= settled_misfit;
    if (here.worst <= noise_misfit) {
      // Rounding may hide the descent; a step that does not even halve the worst row is the last.
      if (!descends && !(next.worst <= 0.5 * here.worst)) break;
    } else if (!descends) {
      // The step again, pivoted in case the quick elimination broke down; then shorter ones.
      system.pivoted_step(z);
      double share = 1.0;
      int halvings = 0;
      for (; halvings < most_halvings; ++halvings, share *= 0.5) {
        move(z, share, system.step(), moved);
        next = system.measure(moved);
        if (next.merit <= (1.0 - least_descent * share) * here.merit) break;
      }
      if (halvings == most_halvings) break;
      has_step = false;
    }
    z.swap(moved);
    if (has_step) moved.swap(beyond);
    here = next;
  }
  result.misfit = here;
  // Stopped by the number of steps, it might still come nearer.
  result.converged =
      here.worst <= settled_misfit || (here.worst <= noise_misfit && result.steps < most);
  return result;
}

/// From z to a solution along G(z) = target + (1 - t) F(start): t leads from 0 to 1 through the
/// complex plane, since real data would lead straight through the points where the derivative is
/// singular; a path beside them meets none, except by accident.
bool continue_to_solution(const SplineProblem& problem, std::vector<Number>& z) {
  constexpr double detour = 0.4, first_stride = 0.05, longest_stride = 0.2;
  constexpr double shortest_stride = 1e-7;        // 1e7 of them would be no way to an answer
  constexpr double close = 1e-6, far_off = 0.05;  // Newton's region: step relative to z
  constexpr int most_strides = 2000, most_corrections = 4;
  SplineProblem moving = problem;
  SplineSystem system(moving);
  const std::vector<Number> begin = SplineSystem(problem).values(z);
  std::vector<Number> right(z.size()), trial(z.size());
  const auto place = [&](double tau) { return Number{tau, detour * tau * (1.0 - tau)}; };
  double tau = 0.0, stride = first_stride;
  for (int count = 0; count < most_strides && tau < 1.0; ++count) {
    const double next = std::min(1.0, tau + stride);
    const Number from = place(tau), to = place(next), change = to - from;
    for (std::size_t i = 0; i < z.size(); ++i) {
      moving.target[i] = problem.target[i] + (Number{1.0, 0.0} - from) * begin[i];
      right[i] = -(change * begin[i]);
    }
    system.pivoted_solve(z, right);
    move(z, 1.0, system.step(), trial);
    for (std::size_t i = 0; i < z.size(); ++i) {
      moving.target[i] = problem.target[i] + (Number{1.0, 0.0} - to) * begin[i];
    }
    bool met = false;
    for (int correction = 0; correction < most_corrections && !met; ++correction) {
      system.pivoted_step(trial);
      double largest = 0.0;
      for (std::size_t i = 0; i < z.size(); ++i) {
        double size = squared(trial[i]);
        if (i > 0) size = std::max(size, squared(trial[i - 1]));
        if (i + 1 < z.size()) size = std::max(size, squared(trial[i + 1]));
        const double change_here = squared(system.step()[i]);
        if (!(change_here <= largest * size)) largest = change_here / size;
      }
      if (!(largest <= far_off * far_off)) break;
      move(trial, 1.0, system.step(), trial);
      met = largest <= close * close;
    }
    if (met) {
      z.swap(trial);
      tau = next;
      stride = std::min(longest_stride, 1.6 * stride);
    } else {
      stride *= 0.4;
      if (stride < shortest_stride) return false;
    }
  }
  return tau >= 1.0 && descend(system, z).converged;
}

/// The spans [begin, end) as a problem of their own, everything else held. All spans: the problem
/// itself.
SplineProblem window(const SplineProblem& problem, const std::vector<Number>& z, std::size_t begin,
                     std::size_t end) {
  const std::size_t size = problem.size();
  if (begin == 0 && end == size) return problem;
  const auto slice = [](const auto& all, std::size_t from, std::size_t to) {
    using Vector = std::decay_t<decltype(all)>;
    if (all.empty()) return Vector{};
    return Vector(all.begin() + static_cast<std::ptrdiff_t>(from),
                  all.begin() + static_cast<std::ptrdiff_t>(to));
  };
  SplineProblem part;
  part.target = slice(problem.target, begin, end);
  part.weight = slice(problem.weight, begin, end + 1);
  part.step = slice(problem.step, begin, end);
  part.importance = slice(problem.importance, begin, end);
  part.first = part.last = SplineEnd::fixed;
  const bool periodic = problem.first == SplineEnd::periodic;
  if (begin > 0) {
    part.before = z[begin - 1];
  } else if (periodic) {
    part.before = problem.closure * z[size - 1];
  } else {
    part.first = SplineEnd::straight;
  }
  if (end < size) {
    part.after = z[end];
  } else if (periodic) {
    part.after = problem.closure * z[0];
  } else {
    part.last = SplineEnd::straight;
  }
  return part;
}

/// A row is met, for a repair, at this misfit: far above rounding, far below anything that Newton
/// could not finish.
constexpr double met = 1e-9;

/// Solves the neighbourhoods of the rows that are not met, each on its own, with a continuation
/// where Newton's iteration does not do. Returns whether one was needed.
bool repair(const SplineProblem& problem, const std::vector<double>& misfit,
            std::vector<Number>& z) {
  const std::size_t size = z.size();
  bool continued = false;
  for (std::size_t i = 0; i < size; ++i) {
    if (misfit[i] <= met) continue;
    std::size_t last = i;
    for (std::size_t j = i; j < size && j <= last + 2 * radius; ++j) {
      if (!(misfit[j] <= met)) last = j;
    }
    const std::size_t begin = i > radius ? i - radius : 0;
    const std::size_t end = std::min(size, last + radius + 1);
    const SplineProblem part = window(problem, z, begin, end);
    std::vector<Number> own(z.begin() + static_cast<std::ptrdiff_t>(begin),
                            z.begin() + static_cast<std::ptrdiff_t>(end));
    const std::vector<Number> start = own;
    SplineSystem part_system(part);
    bool solved = descend(part_system, own).converged;
    if (!solved) {
      continued = true;
      own = start;
      solved = continue_to_solution(part, own);
    }
    if (solved) std::copy(own.begin(), own.end(), z.begin() + static_cast<std::ptrdiff_t>(begin));
    i = last;
  }
  return continued;
}

// ---- bending energy
// --------------------------------------------------------------------------------

/// ∫κ²ds = (4/h) ∫ Im(w* w_u)²/|w|⁶ du, and the same with |w|²(|w_u|² + |w|²) in place of the
/// square: rounding moves the first by some ε² of the second, so that no part need be known better.
struct Energy {
  double value = 0.0, possible = 0.0;
};

Energy gauss(const Number& a, const Number& z, const Number& b) {
  // Eight points of Gauss-Legendre on [0, 1]: distances from the middle, and weights.
  constexpr std::array<double, 4> place{0.0917173212478249, 0.2627662049581645, 0.3983332387068134,
                                        0.4801449282487682};
  constexpr std::array<double, 4> weight{0.1813418916891810, 0.1568533229389436, 0.1111905172266872,
                                         0.0506142681451881};
  const Number first = z - a, second = b - z;
  Energy sum;
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (const double u : {0.5 - place[i], 0.5 + place[i]}) {
      const double v = 1.0 - u;
      const Number left = v * a + u * z, right = v * z + u * b;
      const Number w = v * left + u * right, rate = 2.0 * (v * first + u * second);
      const double turn = w.re * rate.im - w.im * rate.re, speed = squared(w);
      const double share = 4.0 * weight[i] / (speed * speed);
      sum.value += share * (turn * turn / speed);
      sum.possible += share * (squared(rate) + speed);
    }
  }
  return sum;
}

double energy_of_part(const Number& a, const Number& z, const Number& b, int depth,
                      const Energy& whole) {
  constexpr double enough = 1e-6;    // the sum is far better than the difference of the two
  constexpr double straight = 1e-9;  // beside what is possible; far above ε²
  const Number left = 0.5 * (a + z), right = 0.5 * (z + b), middle = 0.5 * (left + right);
  // A half has half the step: the local rate is half of that by u, the integrand a quarter.
  const Energy one = gauss(a, left, middle), two = gauss(middle, right, b);
  const double sum = 2.0 * (one.value + two.value);
  const double allowed = enough * (sum + straight * 2.0 * (one.possible + two.possible));
  if (depth == 0 || !(std::abs(sum - whole.value) > allowed)) return sum;
  return 2.0 * (energy_of_part(a, left, middle, depth - 1, one) +
                energy_of_part(middle, right, b, depth - 1, two));
}

double energy_of_span(const SplineProblem& problem, const std::vector<Number>& z, std::size_t i) {
  constexpr int deepest = 24;
  const auto [a, middle, b] = coefficients(problem, z, i);
  const double h = problem.step.empty() ? 1.0 : problem.step[i];
  const double energy = energy_of_part(a, middle, b, deepest, gauss(a, middle, b)) / h;
  return energy == energy ? energy : std::numeric_limits<double>::infinity();
}

// ---- other solutions
// -------------------------------------------------------------------------------

/// A rotated copy: span `shift` becomes the first.
void rotate(SplineProblem& problem, std::vector<Number>& z, std::size_t shift) {
  const auto turn = [&](auto& all, std::size_t size) {
    if (!all.empty()) {
      std::rotate(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(shift),
                  all.begin() + static_cast<std::ptrdiff_t>(size));
    }
  };
  turn(z, z.size());
  for (std::size_t i = z.size() - shift; i < z.size(); ++i) z[i] = problem.closure * z[i];
  turn(problem.target, z.size());
  turn(problem.step, z.size());
  turn(problem.importance, z.size());
  turn(problem.weight, z.size());
  if (!problem.weight.empty()) problem.weight.back() = problem.weight.front();
}

/// The cosine of the turn of the preimage between the middles of the spans that meet at node k.
double turn_cosine(const SplineProblem& problem, const std::vector<Number>& middles,
                   std::size_t k) {
  const Number before = k > 0 ? middles[k - 1] : problem.closure * middles.back();
  const Number after = middles[k];
  const double size = std::sqrt(squared(before) * squared(after));
  return size > 0.0 ? dot(before, after) / size : -1.0;
}

class Alternatives {
 public:
  Alternatives(SplineProblem& problem, SplineSolution& solution)
      : problem_(problem), solution_(solution), energy_(problem.size(), unknown) {}

  /// Tries the turns at the nodes, which increase; returns those where the other one was taken.
  std::vector<std::size_t> run(const std::vector<std::size_t>& nodes) {
    const std::size_t size = solution_.z.size();
    std::vector<std::size_t> changed;
    settled_ = 0;
    sign_ = 1.0;
    for (const std::size_t node : nodes) {
      std::size_t begin = node > radius ? node - radius : 0;
      std::size_t end = std::min(size, node + radius);
      if (size <= 2 * radius + 2) {
        begin = 0;
        end = size;
      }
      settle(std::min(size, end + 1));
      if (try_node(begin, end, node)) changed.push_back(node);
    }
    settle(size);
    return changed;
  }

 private:
  static constexpr double unknown = -1.0;

  /// Applies the sign that earlier changes left for the spans below `until`.
  void settle(std::size_t until) {
    for (; settled_ < until; ++settled_) {
      if (sign_ < 0.0) solution_.z[settled_] = -solution_.z[settled_];
    }
  }

  double energy_now(std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t i = begin; i < end; ++i) {
      if (energy_[i] == unknown) energy_[i] = energy_of_span(problem_, solution_.z, i);
      sum += energy_[i];
    }
    return sum;
  }

  bool try_node(std::size_t begin, std::size_t end, std::size_t node) {
    std::vector<Number>& z = solution_.z;
    const bool whole = begin == 0 && end == z.size();
    const double energy = energy_now(begin, end);
    SplineProblem part = window(problem_, z, begin, end);
    const std::vector<Number> own(z.begin() + static_cast<std::ptrdiff_t>(begin),
                                  z.begin() + static_cast<std::ptrdiff_t>(end));
    std::vector<Number> start = unknowns_to_middles(part, own);
    // What lies behind the node changes its sign.
    if (whole) {
      part.closure = -part.closure;
    } else {
      part.after = -part.after;
    }
    for (std::size_t i = node - begin; i < start.size(); ++i) start[i] = -start[i];
    constexpr double distinct = 1e-6;  // 100 times the error of the quadrature
    SplineSystem system(part);
    std::vector<Number> best;
    double least = energy;
    // From the middles of what is there and, where the chords are very uneven, from the chords.
    for (int trial = 0; trial < (uneven(node) ? 2 : 1); ++trial) {
      if (trial == 1) {
        for (std::size_t i = 0; i < start.size(); ++i) {
          start[i] = root_near((1.0 / 15.0) * part.target[i], start[i]);
        }
      }
      std::vector<Number> other = middles_to_unknowns(part, start);
      ++solution_.alternatives;
      if (!descend(system, other).converged) continue;
      const double found = quadrature_energy(part, other);
      if (std::abs(found - energy) > distinct * energy) ++solution_.found;
      if (found < (1.0 - distinct) * least) {
        least = found;
        best = std::move(other);
      }
    }
    if (best.empty()) return false;
    ++solution_.taken;
    std::copy(best.begin(), best.end(), z.begin() + static_cast<std::ptrdiff_t>(begin));
    if (problem_.first == SplineEnd::periodic) problem_.closure = -problem_.closure;
    for (std::size_t i = end; i < settled_; ++i) z[i] = -z[i];
    if (!whole) sign_ = -sign_;
    std::fill(energy_.begin() + static_cast<std::ptrdiff_t>(begin),
              energy_.begin() + static_cast<std::ptrdiff_t>(end), unknown);
    return true;
  }

  /// Whether a chord near the node is 8 times another.
  bool uneven(std::size_t node) const {
    constexpr double ratio = 64.0;  // of squares
    const std::size_t end = std::min(problem_.size(), node + 2);
    double least = std::numeric_limits<double>::infinity(), largest = 0.0;
    for (std::size_t i = node > 2 ? node - 2 : 0; i < end; ++i) {
      least = std::min(least, squared(problem_.target[i]));
      largest = std::max(largest, squared(problem_.target[i]));
    }
    return largest > ratio * least;
  }

  SplineProblem& problem_;
  SplineSolution& solution_;
  std::vector<double> energy_;  ///< of the spans of the present solution, where known
  std::size_t settled_ = 0;
  double sign_ = 1.0;
};

/// The nodes where the other turn is worth a trial, in increasing order.
std::vector<std::size_t> doubtful_nodes(const SplineProblem& problem, const std::vector<Number>& z,
                                        std::size_t most) {
  constexpr double sharp = 0.25;  // the cosine of 75.5°
  const bool periodic = problem.first == SplineEnd::periodic;
  std::vector<std::pair<double, std::size_t>> nodes;
  Number before = middle_value(problem, z, periodic ? z.size() - 1 : 0);
  if (periodic) before = problem.closure * before;
  for (std::size_t k = periodic ? 0 : 1; k < z.size(); ++k) {
    const Number after = middle_value(problem, z, k);
    const double product = dot(before, after), bound = squared(before) * squared(after);
    if (!(product > 0.0 && product * product >= sharp * sharp * bound)) {
      nodes.emplace_back(product / std::sqrt(bound), k);
    }
    before = after;
  }
  if (nodes.size() > most) {
    std::nth_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(most), nodes.end());
    nodes.resize(most);
  }
  std::vector<std::size_t> result;
  for (const auto& entry : nodes) result.push_back(entry.second);
  std::sort(result.begin(), result.end());
  return result;
}

void search(SplineProblem& problem, SplineSolution& solution, std::size_t most) {
  constexpr int most_passes = 3;
  std::vector<std::size_t> nodes = doubtful_nodes(problem, solution.z, most);
  if (nodes.empty()) return;
  std::size_t shift = 0;
  if (problem.first == SplineEnd::periodic && solution.z.size() > 2 * radius + 2) {
    // The seam goes where the turn is least.
    const std::vector<Number> middles = unknowns_to_middles(problem, solution.z);
    double best = -2.0;
    for (std::size_t k = 0; k < solution.z.size(); ++k) {
      const double cosine = turn_cosine(problem, middles, k);
      if (cosine > best) {
        best = cosine;
        shift = k;
      }
    }
    rotate(problem, solution.z, shift);
    nodes = doubtful_nodes(problem, solution.z, most);
  }
  Alternatives alternatives(problem, solution);
  for (int pass = 0; pass < most_passes && !nodes.empty(); ++pass) {
    const std::vector<std::size_t> changed = alternatives.run(nodes);
    if (changed.empty()) break;
    // Once more, where something changed nearby.
    nodes = doubtful_nodes(problem, solution.z, most);
    std::size_t next = 0;
    std::erase_if(nodes, [&](std::size_t node) {
      while (next < changed.size() && changed[next] + radius < node) ++next;
      return next == changed.size() || changed[next] > node + radius;
    });
  }
  if (shift > 0) rotate(problem, solution.z, solution.z.size() - shift);
}

/// Newton on the whole, with repairs where it fails; and, where the points are many and only a few
/// places are not met after some steps, with repairs instead of steps for all of them.
void settle(const SplineProblem& problem, SplineSystem& system, SplineSolution& solution) {
  constexpr int most_rounds = 5;
  constexpr std::size_t few = 400;     // spans that a continuation as a whole takes on
  constexpr std::size_t patience = 5;  // steps before the first look at single places
  const std::size_t size = problem.size();
  std::vector<Number> start;
  if (size <= few) start = solution.z;
  for (int round = 0; round < most_rounds; ++round) {
    const bool early = round == 0 && size > few;
    const Descent descent = descend(system, solution.z, early ? patience : most_steps);
    solution.steps += descent.steps;
    solution.misfit = descent.misfit;
    solution.converged = descent.converged;
    if (descent.converged || round + 1 == most_rounds) break;
    const std::vector<double> misfit = system.misfits(solution.z);
    const auto open = static_cast<std::size_t>(
        std::count_if(misfit.begin(), misfit.end(), [](double x) { return !(x <= met); }));
    if (early && 4 * radius * open > size) continue;  // more than a few places: all of them
    if (repair(problem, misfit, solution.z)) solution.continued = true;
  }
  if (solution.converged || size > few) return;
  std::vector<Number> z = start;
  solution.continued = true;
  if (continue_to_solution(problem, z)) {
    solution.z = std::move(z);
    solution.misfit = system.measure(solution.z);
    solution.converged = true;
  }
}

}  // namespace

double quadrature_energy(const SplineProblem& problem, const std::vector<Number>& z) {
  double sum = 0.0;
  for (std::size_t i = 0; i < z.size(); ++i) sum += energy_of_span(problem, z, i);
  return sum;
}

SplineSolution solve(SplineProblem& problem, std::size_t most_alternatives) {
  problem.weigh_rows();
  SplineSolution solution;
  solution.z = start_from_cubic_spline(problem);
  SplineSystem system(problem);
  settle(problem, system, solution);
  solution.found = solution.converged ? 1 : 0;
  if (!solution.converged || most_alternatives == 0) return solution;
  const std::size_t taken = solution.taken;
  search(problem, solution, most_alternatives);
  if (solution.taken > taken) settle(problem, system, solution);
  return solution;
}

}  // namespace hodograph::planar_spline_detail
