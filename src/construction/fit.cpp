// SPDX-License-Identifier: MIT
#include "hodograph/construction/fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/construction/hermite.hpp"

namespace hodograph {
namespace {

/// Bisection near the rounding of positions stops when this many halvings in a row have not halved
/// the error: a fit that converges at all gains a factor 2^6 or more a step.
constexpr int most_stagnant_steps = 3;
/// "Near the rounding": an error below this many ε of the coordinates may be nothing else.
constexpr double rounding_region = 4096.0;

/// γ at one parameter, checked.
struct Knot {
  double xi;
  HermitePoint<4> data;
};

/// An interval of ξ still to be fitted.
struct Interval {
  Knot begin, end;
  double parent_error;
  int stagnant;
};

std::string at_xi(double xi) { return " at xi = " + to_text(xi); }

class Fitter {
 public:
  Fitter(const DerivativeCurve& gamma, const FitOptions& options, const ErrorMeasure& measure)
      : gamma_(gamma), options_(options), measure_(measure) {}

  Result<Knot> knot(double xi) const {
    const Knot knot{xi, gamma_(xi)};
    for (const auto& v : knot.data) {
      if (!is_finite(v)) {
        return Fault{FaultCode::not_finite,
                     "the curve or one of its first four derivatives is not finite" + at_xi(xi),
                     std::nullopt,
                     "xi",
                     xi,
                     std::nullopt};
      }
    }
    if (largest_component(knot.data[1]) == 0.0) {
      return Fault{FaultCode::zero_speed,
                   "the curve stands still" + at_xi(xi) +
                       ": a PH path has no direction there; fit the parts on either side, or "
                       "reparametrise",
                   std::nullopt,
                   "xi",
                   xi,
                   std::nullopt};
    }
    return knot;
  }

  /// Knots by bisection, in order.
  Result<std::vector<Knot>> adaptive(Knot first, Knot last) const {
    std::vector<Knot> knots{first};
    std::vector<Interval> stack{{first, last, std::numeric_limits<double>::infinity(), 0}};
    while (!stack.empty()) {
      const Interval interval = stack.back();
      stack.pop_back();
      const auto bound = bound_of(interval);
      if (bound) {
        if (auto fault = hole_fault(*bound)) return *fault;
      }
      const auto error = bound ? std::optional(bound->error.upper()) : std::nullopt;
      if (error && *error <= options_.tolerance) {
        knots.push_back(interval.end);
        if (options_.progress && !options_.progress(knots.size() - 1, (interval.end.xi - first.xi) /
                                                                          (last.xi - first.xi))) {
          return cancelled();
        }
        continue;
      }
      auto halves = halved(interval, error, knots.size() + stack.size());
      if (!halves) return halves.fault();
      stack.push_back(halves->second);
      stack.push_back(halves->first);
    }
    return knots;
  }

  Result<std::vector<Knot>> uniform(Knot first, Knot last, std::size_t count) const {
    std::vector<Knot> knots{first};
    for (std::size_t k = 1; k < count; ++k) {
      const double share = static_cast<double>(k) / static_cast<double>(count);
      auto next = knot((1.0 - share) * first.xi + share * last.xi);
      if (!next) return next.fault();
      knots.push_back(*next);
    }
    knots.push_back(last);
    return knots;
  }

  /// The path on the knots, and its error.
  Result<Fit> fitted(const std::vector<Knot>& knots) const {
    std::vector<double> xi;
    std::vector<HermitePoint<4>> points;
    for (const Knot& knot : knots) {
      xi.push_back(knot.xi);
      points.push_back(knot.data);
    }
    auto path = hermite_path<4, double>(std::move(xi), points, options_.choice, options_.closed);
    if (!path) return path.fault();
    std::vector<ErrorBound> errors;
    errors.reserve(path->segment_count());
    for (std::size_t k = 0; k < path->segment_count(); ++k) {
      errors.push_back(measure_(path->segment(k), knots[k].xi, knots[k + 1].xi));
      if (auto fault = hole_fault(errors.back())) return *fault;
    }
    ErrorBound total = errors[0];
    for (const ErrorBound& error : errors) total = larger_error(total, error);
    return Fit{std::move(*path), total, std::move(errors)};
  }

  /// The fewest uniform segments within the tolerance: doubling, then bisection on the number.
  Result<Fit> fewest_uniform(const Knot& first, const Knot& last) const {
    std::optional<Fit> best;
    Fault reason;
    double reached = std::numeric_limits<double>::infinity();
    bool near_rounding = false;
    const auto attempt = [&](std::size_t count) -> bool {
      reached = std::numeric_limits<double>::infinity();
      near_rounding = false;
      auto knots = uniform(first, last, count);
      if (!knots) {
        reason = knots.fault();
        return false;
      }
      double size = options_.tolerance;
      for (const Knot& k : *knots) size = std::max(size, largest_component(k.data[0]));
      auto result = fitted(*knots);
      if (!result) {
        reason = result.fault();
        return false;
      }
      reached = result->error.error.upper();
      near_rounding = reached <= rounding_region * epsilon<double>() * size;
      reason = not_reached(reached, count, result->error.at_xi);
      if (!(reached <= options_.tolerance)) return false;
      best = std::move(*result);
      if (options_.progress && !options_.progress(count, 1.0)) {
        reason = cancelled();
        return false;
      }
      return true;
    };
    std::size_t enough = 1, too_few = 0;
    int stagnant = 0;
    double before = std::numeric_limits<double>::infinity();
    while (!attempt(enough)) {
      // What the curve lacks at one knot, more knots will not bring; the rest they may.
      if (reason.code == FaultCode::not_finite || reason.code == FaultCode::zero_speed ||
          reason.code == FaultCode::cancelled || enough >= options_.most_segments) {
        return reason;
      }
      stagnant = near_rounding && !(reached < 0.5 * before) ? stagnant + 1 : 0;
      if (stagnant > most_stagnant_steps) {
        reason.sentence += rounding_hint();
        return reason;
      }
      before = reached;
      too_few = enough;
      enough = std::min(2 * enough, options_.most_segments);
    }
    while (enough - too_few > 1) {
      const std::size_t middle = too_few + (enough - too_few) / 2;
      (attempt(middle) ? enough : too_few) = middle;
      if (reason.code == FaultCode::cancelled) return reason;
    }
    return std::move(*best);
  }

  static Fault cancelled() {
    return {FaultCode::cancelled, "the fit was stopped on request", std::nullopt, "", std::nullopt,
            std::nullopt};
  }
  static std::string rounding_hint() {
    return "; that is the rounding of double precision at these coordinates, ask for more than "
           "that";
  }

  Fault not_reached(double error, std::size_t segments, double xi) const {
    return {FaultCode::tolerance_not_reached,
            "the tolerance " + to_text(options_.tolerance) + " was not reached with " +
                std::to_string(segments) + " segments: the error is " + to_text(error) + at_xi(xi),
            std::nullopt,
            "error",
            error,
            options_.tolerance};
  }

 private:
  /// The error of one segment over the interval; nothing where no segment exists.
  std::optional<ErrorBound> bound_of(const Interval& interval) const {
    const auto curve =
        hermite_curve<4, double>(interval.begin.data, interval.end.data,
                                 interval.end.xi - interval.begin.xi, options_.choice);
    if (!curve) return std::nullopt;
    return measure_(*curve, interval.begin.xi, interval.end.xi);
  }

  /// Where the error is unbounded, the curve itself may be missing: the fault that says so.
  std::optional<Fault> hole_fault(const ErrorBound& bound) const {
    if (std::isfinite(bound.error.upper()) || is_finite(gamma_(bound.at_xi)[0])) {
      return std::nullopt;
    }
    return knot(bound.at_xi).fault();
  }

  Result<std::pair<Interval, Interval>> halved(const Interval& interval,
                                               const std::optional<double>& error,
                                               std::size_t segments) const {
    const double middle = 0.5 * interval.begin.xi + 0.5 * interval.end.xi;
    const double reached = error.value_or(std::numeric_limits<double>::infinity());
    if (segments >= options_.most_segments) return not_reached(reached, segments, middle);
    const double size = std::max({largest_component(interval.begin.data[0]),
                                  largest_component(interval.end.data[0]), options_.tolerance});
    const bool stagnant = reached <= rounding_region * epsilon<double>() * size &&
                          !(reached < 0.5 * interval.parent_error);
    const int steps = stagnant ? interval.stagnant + 1 : 0;
    if (steps > most_stagnant_steps || !(interval.begin.xi < middle && middle < interval.end.xi)) {
      Fault fault = not_reached(reached, segments, middle);
      fault.sentence += steps > most_stagnant_steps
                            ? "; that is the rounding of double precision at coordinates of " +
                                  to_text(size) + ", ask for more than that"
                            : "; the interval cannot be halved any further: the curve or its "
                              "derivatives jump there";
      return fault;
    }
    auto knot_between = knot(middle);
    if (!knot_between) return knot_between.fault();
    return std::pair{Interval{interval.begin, *knot_between, reached, steps},
                     Interval{*knot_between, interval.end, reached, steps}};
  }

  const DerivativeCurve& gamma_;
  const FitOptions& options_;
  const ErrorMeasure& measure_;
};

std::optional<Fault> options_fault(double xi_begin, double xi_end, const FitOptions& options) {
  if (!std::isfinite(xi_begin) || !std::isfinite(xi_end) || !(xi_begin < xi_end)) {
    return Fault{FaultCode::outside_domain,
                 "the parameter interval must have a positive length; got [" + to_text(xi_begin) +
                     ", " + to_text(xi_end) + "]",
                 std::nullopt,
                 "xi_end",
                 xi_end,
                 xi_begin};
  }
  if (options.segments == 0 && !(options.tolerance > 0 && std::isfinite(options.tolerance))) {
    return Fault{FaultCode::outside_domain,
                 "the tolerance must be positive; got " + to_text(options.tolerance),
                 std::nullopt,
                 "tolerance",
                 options.tolerance,
                 0.0};
  }
  if (options.segments > options.most_segments || options.most_segments == 0) {
    return Fault{FaultCode::outside_domain,
                 "at most " + std::to_string(options.most_segments) +
                     " segments are allowed; got " + std::to_string(options.segments),
                 std::nullopt,
                 "segments",
                 static_cast<double>(options.segments),
                 static_cast<double>(options.most_segments)};
  }
  return std::nullopt;
}

/// Closes the data of a closed curve: the last knot takes the values of the first, when they agree.
std::optional<Fault> close(const Knot& first, Knot& last, const FitOptions& options) {
  const double gap = norm(last.data[0] - first.data[0]);
  double size = largest_component(first.data[0]);
  size = std::max(size, largest_component(first.data[1]) * (last.xi - first.xi));
  const double allowed = std::max(options.tolerance, std::sqrt(epsilon<double>()) * size);
  double worst = gap, weight = 1.0;
  std::size_t order = 0;
  for (std::size_t r = 1; r <= 4; ++r) {
    weight *= (last.xi - first.xi) / static_cast<double>(r);
    const double scale =
        std::max(largest_component(first.data[r]), largest_component(last.data[r]));
    const double jump = largest_component(last.data[r] - first.data[r]);
    if (jump > std::sqrt(epsilon<double>()) * std::max(scale, size / weight) && gap <= allowed) {
      worst = jump;
      order = r;
      break;
    }
  }
  if (gap > allowed || order > 0) {
    return Fault{FaultCode::not_continuous,
                 "the curve is not closed: derivative " + std::to_string(order) + " differs by " +
                     to_text(worst) + " between xi = " + to_text(first.xi) +
                     " and xi = " + to_text(last.xi),
                 std::nullopt,
                 "gap",
                 worst,
                 allowed};
  }
  last.data = first.data;
  return std::nullopt;
}

}  // namespace

Result<Fit> fit(const DerivativeCurve& gamma, double xi_begin, double xi_end,
                const FitOptions& options, const ErrorMeasure& measure) {
  if (auto fault = options_fault(xi_begin, xi_end, options)) return *fault;
  const Fitter fitter(gamma, options, measure);
  auto first = fitter.knot(xi_begin);
  if (!first) return first.fault();
  auto last = fitter.knot(xi_end);
  if (!last) return last.fault();
  if (options.closed) {
    if (auto fault = close(*first, *last, options)) return *fault;
  }
  if (options.segments > 0) {
    auto knots = fitter.uniform(*first, *last, options.segments);
    if (!knots) return knots.fault();
    return fitter.fitted(*knots);
  }
  if (options.knots == FitKnots::uniform) return fitter.fewest_uniform(*first, *last);
  auto knots = fitter.adaptive(*first, *last);
  if (!knots) return knots.fault();
  return fitter.fitted(*knots);
}

Result<Fit> fit(const DerivativeCurve& gamma, double xi_begin, double xi_end,
                const FitOptions& options) {
  return fit(gamma, xi_begin, xi_end, options,
             [&gamma](const SpatialPhCurve<8>& segment, double from, double to) {
               return estimated_error(gamma, segment, from, to);
             });
}

ErrorBound estimated_error(const DerivativeCurve& gamma, const SpatialPhCurve<8>& segment,
                           double xi_begin, double xi_end) {
  constexpr int samples = 32;
  const auto distance = [&](double u) {
    const double xi = (1.0 - u) * xi_begin + u * xi_end;
    return norm(gamma(xi)[0] - segment.position(u));
  };
  std::array<double, samples + 2> seen{};
  int largest = 0;
  for (int i = 0; i <= samples + 1; ++i) {
    seen[static_cast<std::size_t>(i)] = distance(static_cast<double>(i) / (samples + 1));
    if (!std::isfinite(seen[static_cast<std::size_t>(i)])) {
      const double at = static_cast<double>(i) / (samples + 1);
      return {Enclosure(0.0, std::numeric_limits<double>::infinity()), false,
              (1.0 - at) * xi_begin + at * xi_end};
    }
    if (seen[static_cast<std::size_t>(i)] > seen[static_cast<std::size_t>(largest)]) largest = i;
  }
  double u = static_cast<double>(largest) / (samples + 1);
  double error = seen[static_cast<std::size_t>(largest)];
  if (largest > 0 && largest < samples + 1) {
    const double left = seen[static_cast<std::size_t>(largest - 1)];
    const double right = seen[static_cast<std::size_t>(largest + 1)];
    const double bend = left - 2.0 * error + right;
    if (bend < 0.0) {
      const double vertex = u + 0.5 * (left - right) / bend / (samples + 1);
      if (const double there = distance(vertex); there > error) {
        error = there;
        u = vertex;
      }
    }
  }
  return {Enclosure(error), false, (1.0 - u) * xi_begin + u * xi_end};
}

}  // namespace hodograph
