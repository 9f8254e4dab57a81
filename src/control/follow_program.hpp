// SPDX-License-Identifier: MIT
// Private to control/: a vehicle on a stretch of a path as a program, its guess, and its answer.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <type_traits>
#include <utility>

#include "follow_models.hpp"
#include "hodograph/control/path_following.hpp"
#include "speed_profile.hpp"

namespace hodograph::control_detail {

/// What follow() and the receding horizon know of the path before they begin.
struct FollowedStretch {
  double begin = 0.0, end = 0.0, length = 0.0;  ///< progress, and the arc length between
  ProgressBy progress_by = ProgressBy::xi;
  double tube = 0.0, bend = 0.0;  ///< largest |κ|, certified
  std::function<double(double)> arc_length;
};

/// Steps of the integrator between two nodes, to see what happens there: at least.
inline constexpr std::size_t looks_between = 16;

inline Vector3<double> in_space(const Vector2<double>& v) { return {v.x, v.y, 0.0}; }
inline Vector3<double> in_space(const Vector3<double>& v) { return v; }

template <class Vehicle, bool by_progress>
class FollowProgram {
 public:
  using Model = FollowModel<Vehicle, by_progress>;
  using A = typename Vehicle::A;
  using Path = ReferencePath<A>;
  using State = std::array<double, Vehicle::states>;
  using Control = std::array<double, Vehicle::controls>;
  static constexpr bool planar = A::dimension == 2;
  static constexpr bool soft = std::is_same_v<Vehicle, SoftCar>;

  FollowProgram(std::shared_ptr<const Path> path, FollowedStretch stretch,
                const FollowLimits& limits, const FollowStart& start, const FollowOptions& options)
      : path_(std::move(path)),
        stretch_(std::move(stretch)),
        limits_(limits),
        options_(options),
        start_(start),
        program_(model(), options.intervals) {
    set_ranges();
    set_start(start);
  }

  MultipleShooting<Model>& program() { return program_; }

  State state_of(const FollowStart& start) const {
    const double begin = path_->progress_of(start.xi);
    const ReferenceValue<A, double> at = path_->value(begin);
    const double first = by_progress ? 0.0 : begin;
    if constexpr (planar) {
      return {first, start.offset[0], start.heading, start.speed};
    } else {
      const Vector3<double> v = start.velocity.value_or(start.speed * at.frame.e1);
      return {first, start.offset[0], start.offset[1], v.x, v.y, v.z};
    }
  }
  void set_start(const FollowStart& start) {
    start_ = start;
    begin_ = path_->progress_of(start.xi);
    program_.fix_start(state_of(start));
  }

  /// Bounds the speed at the end: at one that the sharpest bend allows, whatever comes next; where
  /// that cannot be reached from the start, at what can.
  void end_slowly() {
    if (!(stretch_.bend > 0.0)) return;
    constexpr double spare = 0.9, half = 0.5;
    const double sideways = planar ? limits_.lateral_acceleration : half * limits_.acceleration;
    double braking = limits_.braking > 0.0 ? limits_.braking : limits_.acceleration;
    if (!planar) braking *= half;
    const double reachable = start_speed() - spare * spare * braking * options_.duration;
    const double most =
        std::min(limits_.speed, std::max(spare * std::sqrt(sideways / stretch_.bend), reachable));
    if constexpr (planar) {
      program_.state_ranges(options_.intervals)[3].upper = most;
    } else {
      program_.end_ranges()[0].upper = most * most;
    }
  }

  /// Bounds the offset at the nodes after the start.
  void bound_offset(double bound) {
    const std::size_t last = options_.intervals;
    for (std::size_t k = 1; k <= last; ++k) {
      for (std::size_t i = 1; i < point_t<A>::dimension; ++i) {
        program_.state_ranges(k)[i] = {-bound, bound};
      }
      if constexpr (!planar) {
        Range& square = k < last ? program_.path_ranges(k)[2] : program_.end_ranges()[1];
        square.upper = bound * bound;
      }
    }
  }

  /// Along the path itself, as fast as that allows.
  SolverPoint guess() const {
    SolverPoint point;
    point.variables.assign(program_.variable_ranges().size(), 0.0);
    const State from = state_of(start_);
    const SpeedProfile profile = speed_profile();
    const double all = static_cast<double>(options_.intervals);
    for (std::size_t k = 0; k <= options_.intervals; ++k) {
      const double tau = static_cast<double>(k) / all;
      const SpeedProfile::Point at = by_progress
                                         ? profile.at_place(begin_ + tau * (stretch_.end - begin_))
                                         : profile.at_time(tau * profile.duration());
      const double left = std::max(0.0, 1.0 - 4.0 * tau);  // of the start's offset
      double* const x = point.variables.data() + program_.state_at(k);
      x[0] = by_progress ? at.time : at.place;
      for (std::size_t i = 1; i < point_t<A>::dimension; ++i) x[i] = left * from[i];
      const ReferenceValue<A, double> here = path_->value(at.place);
      double* const u = point.variables.data() + program_.control_at(k);  // past the end: unused
      if constexpr (planar) {
        x[2] = left * from[2];
        x[3] = at.speed;
        if (k < options_.intervals) {
          u[0] = at.acceleration;
          u[1] = here.body_rate / here.speed;
        }
      } else {
        for (std::size_t i = 0; i < 3; ++i) {
          x[3 + i] = at.speed * here.frame.e1[i];
          if (k < options_.intervals) u[i] = at.acceleration * here.frame.e1[i];
        }
      }
    }
    std::copy(from.begin(), from.end(), point.variables.begin());
    if constexpr (!by_progress) {
      point.variables[program_.parameters_at()] =
          options_.aim == FollowAim::most_progress ? options_.duration : profile.duration();
    }
    return point;
  }

  /// An answer one interval later: the start of the next of a receding horizon.
  SolverPoint shifted(const SolverPoint& before) const {
    SolverPoint after = before;
    const auto shift = [](std::vector<double>& all, std::size_t width, std::size_t count) {
      for (std::size_t i = 0; i + width < count; ++i) all[i] = all[i + width];
    };
    const std::size_t width = Model::states + Model::controls;
    const std::size_t per_interval = Model::states + Model::path_constraints;
    for (auto* all : {&after.variables, &after.lower_multipliers, &after.upper_multipliers}) {
      // The last interval is repeated; its end is where the vehicle goes on to.
      shift(*all, width, options_.intervals * width);
    }
    shift(after.constraint_multipliers, per_interval, options_.intervals * per_interval);
    return after;
  }

  /// Puts the start into a point that was meant for another.
  void place_start(SolverPoint& point) const {
    const State from = state_of(start_);
    std::copy(from.begin(), from.end(), point.variables.begin());
  }

  /// Where the vehicle is at node k of an answer.
  FollowStart start_after(const Solution& solution, std::size_t k) const {
    const State x = state(solution.point.variables, k);
    FollowStart start;
    start.xi = path_->xi_of(
        progress_at(static_cast<double>(k) / static_cast<double>(options_.intervals), x));
    start.offset[0] = x[1];
    if constexpr (planar) {
      start.heading = x[2];
      start.speed = x[3];
    } else {
      start.offset[1] = x[2];
      start.velocity = Vector3<double>{x[3], x[4], x[5]};
    }
    return start;
  }

  Following following(const Solution& solution) const {
    Following result;
    const std::vector<double>& z = solution.point.variables;
    double duration = 0.0;
    if constexpr (by_progress) {
      duration = z[program_.state_at(options_.intervals)];
    } else {
      duration = z[program_.parameters_at()];
    }
    for (std::size_t k = 0; k <= options_.intervals; ++k) {
      const std::size_t held = std::min(k, options_.intervals - 1);
      result.nodes.push_back(node(k, state(z, k), control(z, held), duration));
    }
    result.duration = duration;
    result.progress = result.nodes.back().xi - result.nodes.front().xi;
    result.tube = stretch_.tube;
    result.objective = solution.objective;
    result.constraint_error = solution.constraint_error;
    result.seconds = solution.seconds;
    result.iterations = solution.iterations;
    look_between(z, result);
    return result;
  }

 private:
  double start_speed() const {
    if constexpr (planar) {
      return start_.speed;
    } else {
      return start_.velocity ? norm(*start_.velocity) : start_.speed;
    }
  }
  /// How fast the path itself can be driven, with something to spare.
  SpeedProfile speed_profile() const {
    constexpr double share = 0.9;  // of the limits
    const double sideways = planar ? limits_.lateral_acceleration : 0.5 * limits_.acceleration;
    const double braking = limits_.braking > 0.0 ? limits_.braking : limits_.acceleration;
    SpeedProfile profile;
    const std::size_t count = 10 * options_.intervals;
    // A horizon over a path that goes round has no end.
    const bool round = path_->is_periodic() && options_.aim == FollowAim::most_progress;
    const double end = round ? begin_ + (stretch_.end - stretch_.begin) : stretch_.end;
    const double step = (end - begin_) / static_cast<double>(count);
    std::vector<double> places;
    for (std::size_t i = 0; i <= count; ++i) {
      places.push_back(begin_ + static_cast<double>(i) * step);
    }
    std::vector<ReferenceJet<A>> jets(places.size());
    path_->at(places, jets);
    for (std::size_t i = 0; i <= count; ++i) {
      const auto& rate = jets[i].body_rate[0];
      const double sigma = jets[i].speed[0];
      double turning = 0.0;
      if constexpr (planar) {
        turning = std::abs(rate);
      } else {
        turning = std::hypot(rate.y, rate.z);
      }
      double speed = share * limits_.speed;
      if (turning > 0.0) {
        speed = std::min(speed, std::sqrt(share * sideways * sigma / turning));
      }
      profile.add(places[i], i == 0 ? 0.0 : step * sigma, speed);
    }
    profile.limit(start_speed(), options_.end_speed, share * limits_.acceleration, share * braking);
    if (options_.aim == FollowAim::most_progress) profile.cut(options_.duration);
    return profile;
  }

  Model model() {
    Model model;
    model.path = path_;
    model.intervals = static_cast<double>(options_.intervals);
    begin_ = stretch_.begin;
    model.begin = stretch_.begin;
    model.end = stretch_.end;
    if constexpr (by_progress) model.find_stages();
    if constexpr (planar) {
      double bend = stretch_.bend;
      if (std::isfinite(limits_.lateral_acceleration)) {
        bend = std::max(bend, limits_.lateral_acceleration / (limits_.speed * limits_.speed));
      }
      model.vehicle.scale[0] = std::max(limits_.acceleration, limits_.braking);
      model.vehicle.scale[1] = bend > 0.0 ? bend : 1.0 / stretch_.length;
      if constexpr (soft) {
        // An offset beyond the limit all the way costs ten times its duration.
        constexpr double weight = 10.0;
        model.vehicle.scale[2] = limits_.offset;
        model.vehicle.excess_weight = weight * options_.duration / limits_.offset;
        if (std::isfinite(limits_.lateral_acceleration)) {
          model.vehicle.lateral_per_offset = limits_.lateral_acceleration / limits_.offset;
        }
      }
    } else {
      model.vehicle.scale.fill(limits_.acceleration);
    }
    // The start and where the guess begins are known by now.
    const double duration = speed_profile().duration();
    model.effort_weight = options_.effort * duration;
    model.time_weight = options_.aim == FollowAim::least_time ? 1.0 : 0.0;
    // Progress counts as the time that it takes at the limit.
    if (options_.aim == FollowAim::most_progress) {
      model.progress_weight = stretch_.length / ((stretch_.end - stretch_.begin) * limits_.speed);
    }
    return model;
  }

  void set_ranges() {
    constexpr double inside = 0.95;  // of the tube, for what is soft
    const std::size_t last = options_.intervals;
    const double braking = limits_.braking > 0.0 ? limits_.braking : limits_.acceleration;
    for (std::size_t k = 0; k <= last; ++k) {
      auto state = program_.state_ranges(k);
      if (by_progress) {
        state[0].lower = 0.0;
      } else if (!path_->is_periodic()) {
        state[0] = {path_->begin(), path_->end()};
      }
      if constexpr (planar) {
        const double widest = soft ? inside * stretch_.tube : limits_.offset;
        state[1] = {-widest, widest};
        state[2] = {-0.5 * std::numbers::pi, 0.5 * std::numbers::pi};
        state[3] = {0.0, limits_.speed};
      } else {
        for (std::size_t i = 1; i < 3; ++i) state[i] = {-limits_.offset, limits_.offset};
        for (std::size_t i = 3; i < 6; ++i) state[i] = {-limits_.speed, limits_.speed};
      }
      if (k == last) break;
      auto control = program_.control_ranges(k);
      auto limited = program_.path_ranges(k);
      if constexpr (planar) {
        control[0] = {-braking, limits_.acceleration};
        if (limits_.turn_radius > 0.0) {
          control[1] = {-1.0 / limits_.turn_radius, 1.0 / limits_.turn_radius};
        }
        if constexpr (soft) {
          control[2] = {0.0, inside * stretch_.tube};
          limited[0].upper = limited[1].upper = limits_.lateral_acceleration;
          limited[2].upper = limited[3].upper = limits_.offset;
        } else {
          limited[0] = {-limits_.lateral_acceleration, limits_.lateral_acceleration};
        }
      } else {
        for (Range& range : control) range = {-limits_.acceleration, limits_.acceleration};
        limited[0].upper = limits_.acceleration * limits_.acceleration;
        limited[1].upper = limits_.speed * limits_.speed;
        limited[2].upper = limits_.offset * limits_.offset;
      }
      if constexpr (by_progress) {
        limited[Vehicle::limited].lower = options_.least_forward * limits_.speed;
      }
    }
    if (!by_progress && options_.aim == FollowAim::least_time) {
      program_.state_ranges(last)[0] = Range::only(stretch_.end);
    }
    if constexpr (planar) {
      if (options_.end_speed) program_.state_ranges(last)[3] = Range::only(*options_.end_speed);
    } else {
      program_.end_ranges()[0].upper = limits_.speed * limits_.speed;
      program_.end_ranges()[1].upper = limits_.offset * limits_.offset;
    }
    if constexpr (!by_progress) {
      program_.parameter_ranges()[0] = {0.0, std::numeric_limits<double>::infinity()};
      if (options_.aim == FollowAim::most_progress) {
        program_.parameter_ranges()[0] = Range::only(options_.duration);
      }
    }
  }

  State state(const std::vector<double>& z, std::size_t k) const {
    State x;
    std::copy_n(z.begin() + static_cast<std::ptrdiff_t>(program_.state_at(k)), x.size(), x.begin());
    return x;
  }
  Control control(const std::vector<double>& z, std::size_t k) const {
    Control u;
    std::copy_n(z.begin() + static_cast<std::ptrdiff_t>(program_.control_at(k)), u.size(),
                u.begin());
    return u;
  }
  double progress_at(double tau, const State& x) const {
    return by_progress ? stretch_.begin + tau * (stretch_.end - stretch_.begin) : x[0];
  }
  static auto offset_of(const State& x) {
    std::array<double, point_t<A>::dimension - 1> eta;
    for (std::size_t i = 0; i < eta.size(); ++i) eta[i] = x[1 + i];
    return eta;
  }

  FollowNode node(std::size_t k, const State& x, const Control& u, double duration) const {
    const double tau = static_cast<double>(k) / static_cast<double>(options_.intervals);
    FollowNode result;
    const double place = progress_at(tau, x);
    result.xi = path_->xi_of(place);
    result.time = by_progress ? x[0] : tau * duration;
    result.arc_length = stretch_.arc_length(result.xi);
    const ReferenceValue<A, double> at = path_->value(place);
    const auto eta = offset_of(x);
    std::copy(eta.begin(), eta.end(), result.offset.begin());
    result.stretch = progress_stretch(at, eta);
    result.position = in_space(place_of(at, eta));
    if constexpr (planar) {
      result.heading = x[2];
      result.speed = x[3];
      const Vector2<double> way = std::cos(x[2]) * at.frame.e1 + std::sin(x[2]) * at.frame.e2;
      const Vector2<double> left{-way.y, way.x};
      result.along = u[0];
      result.lateral = x[3] * x[3] * u[1];
      result.velocity = in_space(x[3] * way);
      result.acceleration = in_space(result.along * way + result.lateral * left);
    } else {
      result.velocity = {x[3], x[4], x[5]};
      result.acceleration = {u[0], u[1], u[2]};
      result.speed = norm(result.velocity);
      const double forward = dot(result.velocity, at.frame.e1);
      result.heading = std::atan2(norm(result.velocity - forward * at.frame.e1), forward);
      if (result.speed > 0.0) {
        result.along = dot(result.acceleration, result.velocity) / result.speed;
        result.lateral = norm(cross(result.velocity, result.acceleration)) / result.speed;
      }
    }
    return result;
  }

  /// The speed at a state, and the largest acceleration with these controls up to a speed.
  static double speed_of(const State& x) {
    if constexpr (planar) {
      return x[3];
    } else {
      return norm(Vector3<double>{x[3], x[4], x[5]});
    }
  }
  static double acceleration_of(const Control& u, double speed) {
    if constexpr (planar) {
      return std::hypot(u[0], speed * speed * u[1]);
    } else {
      return norm(Vector3<double>{u[0], u[1], u[2]});
    }
  }
  static double size_of_offset(const State& x) {
    double square = 0.0;
    for (const double e : offset_of(x)) square += e * e;
    return std::sqrt(square);
  }
  /// How fast the offset's rate may fall where the offset is at most d: its second derivative by
  /// time is the acceleration across, and the way's bending against the path's: at least
  /// -(|p''| + v² κ/(1 - κ d)), κ being the path's largest curvature. Infinite outside the tube.
  double bending(const Control& u, double speed, double d) const {
    const double left = 1.0 - stretch_.bend * d;
    if (!(left > 0.0)) return std::numeric_limits<double>::infinity();
    return acceleration_of(u, speed) + speed * speed * stretch_.bend / left;
  }

  /// Bounds the offset between the nodes: over a step of the time t it is at most the larger one of
  /// the step's ends and t²/8 times `bending`; and at most v t/2 more than there. The speed is
  /// largest at an end: its square (in the plane: it itself) is convex in time. Steps are so short
  /// that this adds little.
  void look_between(const std::vector<double>& z, Following& result) const {
    std::array<double, Model::parameters> p{};
    if constexpr (!by_progress) p[0] = z[program_.parameters_at()];
    const double intervals = static_cast<double>(options_.intervals);
    constexpr double little = 0.005;  // of the offset allowed
    constexpr std::size_t most_looks = 1024;
    result.least_stretch = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < options_.intervals; ++k) {
      State x = state(z, k);
      const State after = state(z, k + 1);
      const Control u = control(z, k);
      double lasts = 0.0;
      if constexpr (by_progress) {
        lasts = std::max(0.0, after[0] - x[0]);
      } else {
        lasts = p[0] / intervals;
      }
      const double fastest = std::max(speed_of(x), speed_of(after));
      const double most = bending(u, fastest, limits_.offset);
      const double enough = lasts * std::sqrt(most / (8.0 * little * limits_.offset));
      const std::size_t looks = static_cast<std::size_t>(std::clamp(
          std::ceil(enough), static_cast<double>(looks_between), static_cast<double>(most_looks)));
      const double step = 1.0 / (intervals * static_cast<double>(looks));
      if constexpr (planar) {
        result.largest_lateral =
            std::max(result.largest_lateral, fastest * fastest * std::abs(u[1]));
      }
      for (std::size_t i = 0; i <= looks; ++i) {
        const double tau = static_cast<double>(k * looks + i) * step;
        const ReferenceValue<A, double> at = path_->value(progress_at(tau, x));
        result.least_stretch =
            std::min(result.least_stretch, progress_stretch(at, offset_of(x)) / at.speed);
        if (i == looks) break;
        const State before = x;
        x = runge_kutta_step<double, Vehicle::states>(
            [&](double t, const State& y) { return program_.model().derivative(t, y, u, p); }, tau,
            step, x);
        double time = lasts / static_cast<double>(looks);
        if constexpr (by_progress) time = std::abs(x[0] - before[0]);
        const double ends = std::max(size_of_offset(before), size_of_offset(x));
        const double speed = std::max(speed_of(before), speed_of(x));
        const double reach = ends + 0.5 * speed * time;
        const double bound = ends + time * time / 8.0 * bending(u, speed, reach);
        result.largest_offset = std::max(result.largest_offset, std::min(reach, bound));
      }
    }
  }

  std::shared_ptr<const Path> path_;
  FollowedStretch stretch_;
  FollowLimits limits_;
  FollowOptions options_;
  FollowStart start_;
  double begin_ = 0.0;
  MultipleShooting<Model> program_;
};

}  // namespace hodograph::control_detail
