// SPDX-License-Identifier: MIT
#include "follow_stretch.hpp"

#include <limits>
#include <string>

#include "hodograph/foundation/accuracy.hpp"

namespace hodograph::control_detail {
namespace {

Fault fault_of(FaultCode code, const std::string& sentence, const char* quantity,
               std::optional<double> value = std::nullopt,
               std::optional<double> bound = std::nullopt) {
  return {code, sentence, std::nullopt, quantity, value, bound};
}

/// A number that must be finite and more than (or at least) zero.
std::optional<Fault> check(const char* name, double value, bool may_be_zero) {
  if (std::isfinite(value) && (may_be_zero ? value >= 0.0 : value > 0.0)) return std::nullopt;
  return fault_of(FaultCode::outside_domain,
                  std::string("the ") + name + " is " + to_text(value) + "; it must be " +
                      (may_be_zero ? "zero or positive" : "positive") + " and finite",
                  name, value, 0.0);
}

std::optional<Fault> check_limits(const FollowLimits& limits, bool planar) {
  if (auto fault = check("speed", limits.speed, false)) return fault;
  if (auto fault = check("acceleration", limits.acceleration, false)) return fault;
  if (auto fault = check("braking", limits.braking, true)) return fault;
  if (auto fault = check("turn_radius", limits.turn_radius, true)) return fault;
  if (auto fault = check("offset", limits.offset, false)) return fault;
  if (!(limits.lateral_acceleration > 0.0)) {
    return fault_of(FaultCode::outside_domain,
                    "the lateral acceleration is " + to_text(limits.lateral_acceleration) +
                        "; it must be positive",
                    "lateral_acceleration", limits.lateral_acceleration, 0.0);
  }
  if (!planar && (std::isfinite(limits.lateral_acceleration) || limits.turn_radius > 0.0 ||
                  limits.braking > 0.0)) {
    return fault_of(FaultCode::unsupported,
                    "lateral acceleration, braking and turn radius are a car's, in the plane; in "
                    "space the acceleration is limited in every direction",
                    "lateral_acceleration");
  }
  return std::nullopt;
}

std::optional<Fault> check_options(const FollowOptions& options, bool planar) {
  constexpr std::size_t most_intervals = 100000;
  if (options.intervals < 2 || options.intervals > most_intervals) {
    return fault_of(FaultCode::outside_domain,
                    "there are " + std::to_string(options.intervals) +
                        " intervals; there must be 2 to " + std::to_string(most_intervals),
                    "intervals", static_cast<double>(options.intervals));
  }
  if (auto fault = check("effort", options.effort, true)) return fault;
  const bool by_progress = options.independent == FollowIndependent::progress;
  if (options.aim == FollowAim::most_progress) {
    if (by_progress) {
      return fault_of(FaultCode::unsupported,
                      "with xi independent the progress is given and cannot be sought; take time "
                      "independent, or the least time",
                      "aim");
    }
    if (auto fault = check("duration", options.duration, false)) return fault;
  }
  if (by_progress) {
    if (auto fault = check("least_forward", options.least_forward, false)) return fault;
  }
  if (options.end_speed) {
    if (!planar) {
      return fault_of(FaultCode::unsupported, "an end speed is for a car, in the plane",
                      "end_speed");
    }
    return check("end_speed", *options.end_speed, true);
  }
  return std::nullopt;
}

/// Whether the end speed can be had: over the longest way there is without weaving, that along the
/// tube's outer edge all the way, or within the time given.
std::optional<Fault> check_end_speed(const FollowedStretch& stretch, const FollowLimits& limits,
                                     double speed, const FollowOptions& options) {
  const double way = stretch.length * (1.0 + stretch.bend * limits.offset),
               wanted = *options.end_speed;
  const double braking = limits.braking > 0.0 ? limits.braking : limits.acceleration;
  double fastest = std::sqrt(speed * speed + 2.0 * limits.acceleration * way);
  double slowest = std::sqrt(std::max(0.0, speed * speed - 2.0 * braking * way));
  if (options.aim == FollowAim::most_progress) {
    fastest = speed + limits.acceleration * options.duration;
    slowest = std::max(0.0, speed - braking * options.duration);
  }
  fastest = std::min(fastest, limits.speed);
  constexpr double roundings = 16.0 * std::numeric_limits<double>::epsilon();
  if (wanted >= slowest * (1.0 - roundings) && wanted <= fastest * (1.0 + roundings)) {
    return std::nullopt;
  }
  const bool too_fast = wanted > fastest;
  return fault_of(
      FaultCode::outside_domain,
      "the end speed is " + to_text(wanted) + "; from a speed of " + to_text(speed) +
          (options.aim == FollowAim::most_progress ? " in " + to_text(options.duration) + " s"
                                                   : " over " + to_text(way) + " of way") +
          " it can be at " + (too_fast ? "most " : "least ") +
          to_text(too_fast ? fastest : slowest),
      "end_speed", wanted, too_fast ? fastest : slowest);
}

/// Whether the speed does not jump at any knot: then the derivatives by ξ are those of one
/// function.
bool speed_is_continuous(const AnyPath& path) {
  const PathNumbers numbers = path.numbers();
  const std::size_t width = numbers.components_per_coefficient();
  const std::size_t segment = (numbers.preimage_degree + 1) * width;
  const auto speed = [&](std::size_t first) {
    double sum = 0.0;
    for (std::size_t i = 0; i < width; ++i) {
      sum += numbers.preimages[first + i] * numbers.preimages[first + i];
    }
    return sum;
  };
  for (std::size_t k = 1; k < path.segment_count(); ++k) {
    const double before = speed(k * segment - width), after = speed(k * segment);
    if (!(std::abs(after - before) <= accuracy::join_error<double>() * std::max(before, after))) {
      return false;
    }
  }
  return true;
}

}  // namespace

Result<FollowedStretch> followed_stretch(const AnyPath& path, const FollowLimits& limits,
                                         const FollowStart& start, const FollowOptions& options) {
  const bool planar = path.dimension() == 2;
  if (auto fault = check_limits(limits, planar)) return *fault;
  if (auto fault = check_options(options, planar)) return *fault;

  FollowedStretch stretch;
  const double begin = path.xi_begin(), end = path.xi_end();
  const bool round = path.is_closed() && planar;
  const double xi_end = options.xi_end.value_or(round ? start.xi + (end - begin) : end);
  const auto inside = [&](double xi) { return begin <= xi && xi <= end; };
  if (!inside(start.xi)) {
    return fault_of(FaultCode::outside_domain,
                    "the start xi " + to_text(start.xi) + " is not on the path, from " +
                        to_text(begin) + " to " + to_text(end),
                    "xi", start.xi);
  }
  if (!(xi_end > start.xi) || !(round ? std::isfinite(xi_end) : inside(xi_end))) {
    return fault_of(FaultCode::outside_domain,
                    "the end xi " + to_text(xi_end) + " should be beyond the start " +
                        to_text(start.xi) +
                        (round ? std::string() : " and at most " + to_text(end)),
                    "xi_end", xi_end, start.xi);
  }
  stretch.arc_length = [path, begin, end](double xi) {
    const double period = end - begin, laps = std::floor((xi - begin) / period);
    if (xi >= begin && xi <= end) return path.arc_length(xi);
    if (!path.is_closed()) return path.arc_length(std::clamp(xi, begin, end));
    return laps * path.arc_length() + path.arc_length(std::clamp(xi - laps * period, begin, end));
  };
  const double from = stretch.arc_length(start.xi), to = stretch.arc_length(xi_end);
  stretch.length = to - from;
  const bool by_xi = speed_is_continuous(path);
  stretch.progress_by = by_xi ? ProgressBy::xi : ProgressBy::arc_length;
  stretch.begin = by_xi ? start.xi : from;
  stretch.end = by_xi ? xi_end : to;

  const OffsetLimits tube = offset_limits(path);
  stretch.tube = std::min(tube.left, tube.right);
  stretch.bend =
      std::max(std::abs(tube.curvature_minimum.lower()), std::abs(tube.curvature_maximum.upper()));
  if (!std::isfinite(stretch.bend)) {
    return fault_of(FaultCode::zero_speed,
                    "the path stands still somewhere: it has no frame there, and no tube", "speed",
                    0.0);
  }
  if (!(limits.offset < stretch.tube)) {
    return fault_of(FaultCode::outside_domain,
                    "the offset is " + to_text(limits.offset) +
                        "; beside this path's sharpest bend it must be less than " +
                        to_text(stretch.tube),
                    "offset", limits.offset, stretch.tube);
  }

  const double off =
      planar ? std::abs(start.offset[0]) : std::hypot(start.offset[0], start.offset[1]);
  if (!(off <= limits.offset)) {
    return fault_of(
        FaultCode::outside_domain,
        "the start is " + to_text(off) + " from the path; it may be " + to_text(limits.offset),
        "start", off, limits.offset);
  }
  const Vector3<double> velocity = start.velocity.value_or(Vector3<double>{});
  const double speed = start.velocity ? norm(velocity) : start.speed;
  if (!(speed >= 0.0 && speed <= limits.speed)) {
    return fault_of(FaultCode::outside_domain,
                    "the start's speed is " + to_text(speed) + "; it must be between 0 and " +
                        to_text(limits.speed),
                    "speed", speed, limits.speed);
  }
  if (options.end_speed) {
    if (auto fault = check_end_speed(stretch, limits, speed, options)) return *fault;
  }
  if (!(std::abs(start.heading) < 0.5 * std::numbers::pi)) {
    return fault_of(FaultCode::outside_domain,
                    "the start heads " + to_text(start.heading) +
                        " from the path's direction; a quarter turn is the most",
                    "heading", start.heading, 0.5 * std::numbers::pi);
  }
  if (options.independent == FollowIndependent::progress) {
    double forward = speed * std::cos(start.heading);
    if (start.velocity) {
      std::vector<double> preimage(4);
      path.preimage(start.xi, preimage);
      const Quaternion<double> a{preimage[0], preimage[1], preimage[2], preimage[3]};
      forward = dot(velocity, hodograph_form(a, a)) / speed_form(a, a);
    }
    const double least = options.least_forward * limits.speed;
    if (!(forward >= least)) {
      return fault_of(FaultCode::outside_domain,
                      "with xi independent the start must move along the path at " +
                          to_text(least) + " at least, got " + to_text(forward) +
                          "; take time independent",
                      "speed", forward, least);
    }
  }
  return stretch;
}

}  // namespace hodograph::control_detail
