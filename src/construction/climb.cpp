// SPDX-License-Identifier: MIT
// Constant climb: the length over ground from the angle, the plan of that length, and its lifting.
#include "hodograph/construction/climb.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "end_point_faults.hpp"
#include "hodograph/construction/detail/length_choice.hpp"
#include "hodograph/construction/lift.hpp"
#include "hodograph/path/helix.hpp"

namespace hodograph {
namespace {

constexpr double quarter_turn = 0.5 * std::numbers::pi;
constexpr Quaternion<double> no_turn{1.0, 0.0, 0.0, 0.0};

Fault angle_fault(double angle) {
  if (!std::isfinite(angle)) {
    return {FaultCode::not_finite, "the climb angle is not finite",
            std::nullopt,          "climb_angle",
            std::nullopt,          std::nullopt};
  }
  if (angle == 0.0) {
    return {FaultCode::outside_domain,
            "a climb angle of 0 is level flight, which leaves the length open; give the length "
            "over ground instead",
            std::nullopt,
            "climb_angle",
            0.0,
            std::nullopt};
  }
  return {FaultCode::outside_domain,
          "the climb angle must lie between -pi/2 and pi/2, in radians; got " + to_text(angle),
          std::nullopt,
          "climb_angle",
          angle,
          quarter_turn};
}

Fault wrong_way(double angle, double rise) {
  const std::string asked = std::string(angle > 0.0 ? "climb" : "descent") + " angle " +
                            to_text(angle) + " rad needs an end ";
  return {FaultCode::no_interpolant,
          asked + (angle > 0.0 ? "above" : "below") + " the start; its altitude changes by " +
              to_text(rise),
          std::nullopt,
          "climb",
          rise,
          0.0};
}

Fault out_of_range() {
  return {FaultCode::no_interpolant,
          "the climb's numbers are too large, or the parameter step is too small for them, to be "
          "computed with",
          std::nullopt,
          "range",
          std::nullopt,
          std::nullopt};
}

/// What a climb comes down to.
struct Task {
  DirectedPoint begin, end;
  Vector3<double> start;
  Quaternion<double> upright = no_turn;
  double rise = 0.0, ground_length = 0.0;
  double slope = 0.0, angle = 0.0;  ///< tan θ and θ, where they give the ground length; else 0
};

Task task_between(const HeadedPoint& begin, const HeadedPoint& end) {
  return {{{begin.position.x, begin.position.y}, begin.heading},
          {{end.position.x, end.position.y}, end.heading},
          begin.position,
          no_turn,
          end.position.z - begin.position.z,
          0.0,
          0.0};
}

std::optional<Fault> set_angle(Task& task, double angle) {
  if (!(std::abs(angle) < quarter_turn) || angle == 0.0) return angle_fault(angle);
  if (task.rise == 0.0 || (task.rise > 0.0) != (angle > 0.0)) return wrong_way(angle, task.rise);
  task.angle = angle;
  task.slope = std::tan(angle);
  task.ground_length = task.rise / task.slope;
  if (!std::isfinite(task.ground_length)) return out_of_range();
  return std::nullopt;
}

/// Whether a length is that of the straight line between the points, up to rounding.
bool is_straight(const Vector2<double>& chord, double length) {
  constexpr double well_above = 1.0 + 2.0 * accuracy::join_error<double>();
  constexpr double most = 0x1.0p+400;
  if (length < most && length * most > 1.0) {  // squares keep their digits
    return length * length <= well_above * well_above * dot(chord, chord);
  }
  return length <= well_above * std::hypot(chord.x, chord.y);
}
bool is_straight(const Task& task) {
  return is_straight(task.end.position - task.begin.position, task.ground_length);
}

using PlanPreimage = BernsteinPolynomial<Complex<double>, 2>;

/// The slope of a plan that was made: over the length asked for, except that a straight line has
/// its own.
double slope_over(const Task& task, const PlanPreimage& plan, double h) {
  return task.rise /
         (is_straight(task) ? PlanarPhCurve<2>({}, plan, h).arc_length() : task.ground_length);
}

bool is_usable(const SpatialPhCurve<2>& curve) {
  return is_finite(curve.end()) && is_finite(curve.arc_length()) && curve.arc_length() > 0.0;
}

/// The refusal of a plan in terms of the climb. The climb named is tried with these altitudes: the
/// straight line's, or where a heading is off that line a little more.
Fault explained(Fault fault, const Task& task) {
  const bool direction = fault.quantity == "direction";
  if (task.slope == 0.0 || fault.code != FaultCode::no_interpolant || !fault.value ||
      !(direction || (fault.quantity == "length" && fault.bound))) {
    return fault;
  }
  const double climbed = std::abs(task.rise), slope = std::abs(task.slope);
  const double chord = direction ? task.ground_length : *fault.bound, least = chord * slope;
  const bool straight = prescribed_length_curve(task.begin, task.end, chord).has_value();
  const bool level = task.upright == no_turn;  // altitudes round, heights along an axis do not
  constexpr double rounded = 4.0 * epsilon<double>();
  // Off the line the curve turns sharper the less room it has: at these, by some 10³ and 30 a
  // chord.
  constexpr double little = 0x1.0p-20, more_room = 0x1.0p-10;
  double bound = least;
  for (const double excess : {straight ? 0.0 : little, straight ? rounded : little, more_room}) {
    const double more = std::copysign(least * (1.0 + excess), task.rise);
    bound = std::abs(level ? (task.start.z + more) - task.start.z : more);
    if (prescribed_length_curve(task.begin, task.end, bound / slope)) break;
  }
  const std::string what = task.rise > 0.0 ? " of climb" : " of descent";
  const std::string asked = std::string(task.rise > 0.0 ? "climb" : "descent") + " angle " +
                            to_text(std::atan(task.slope)) + " rad ";
  if (direction) {
    fault.sentence = asked + "with " + to_text(climbed) + what +
                     " is a straight line; a heading is off that line by " + to_text(*fault.value) +
                     " rad. It needs more " + (task.rise > 0.0 ? "climb (" : "descent (") +
                     to_text(bound) + " will do)";
  } else {
    fault.sentence =
        asked + "needs " +
        (straight ? "at least " + to_text(bound) + what
                  : "more than " + to_text(least) + what + " (" + to_text(bound) + " will do)") +
        " between points that are " + to_text(chord) + " apart over ground; got " +
        to_text(climbed);
  }
  fault.quantity = "climb";
  fault.value = climbed;
  fault.bound = bound;
  return fault;
}

/// The climb above a plan. It is made where the result is to stand: a copy of its four hundred
/// bytes takes as long as the lifting.
struct Lifting {
  const Task& task;
  const planar_detail::LengthChoice& choice;
  double h;

  operator ClimbCurve() const {
    const PlanPreimage plan(choice.preimage);
    const double slope = slope_over(task, plan, h);
    const bool by_angle = task.slope != 0.0 && !is_straight(task);
    return {{task.start, lifted(plan, slope, task.upright), h},
            by_angle ? task.angle : std::atan(slope),
            task.ground_length,
            choice.rotation_index,
            choice.margin,
            choice.tie,
            choice.loop_free};
  }
};

Result<ClimbCurve> answer(const Lifting& lifting) {
  Result<ClimbCurve> result(std::in_place, lifting);
  if (!is_usable(result->curve)) result = out_of_range();
  return result;
}

Result<ClimbCurve> solve(const Task& task, double h, LengthSolutions among) {
  planar_detail::LengthChoice choice;
  if (auto fault = planar_detail::choose_length(task.begin, task.end, task.ground_length, h, among,
                                                choice)) {
    return explained(*std::move(fault), task);
  }
  return answer({task, choice, h});
}

Result<std::vector<ClimbSolution>> solve_all(const Task& task, double h, LengthSolutions among) {
  const auto plans =
      prescribed_length_solutions(task.begin, task.end, task.ground_length, h, among);
  if (!plans) return explained(plans.fault(), task);
  std::vector<ClimbSolution> solutions;
  for (const PlanarSolution& plan : *plans) {
    solutions.push_back(
        {lifted(plan.curve, task.start, slope_over(task, plan.curve.preimage(), h), task.upright),
         plan.rotation_index});
    if (!is_usable(solutions.back().curve)) return out_of_range();
  }
  return solutions;
}

Result<Task> task_about(const Vector3<double>& axis, const DirectedPoint3& begin,
                        const DirectedPoint3& end) {
  if (auto fault = path_detail::axis_fault(axis)) return *std::move(fault);
  if (auto fault = planar_detail::directed_points_fault(begin, end)) return *std::move(fault);
  Task task;
  task.upright = turn_upright(axis);
  const DirectedPoint3* points[] = {&begin, &end};
  Vector3<double> directions[2];
  for (std::size_t i = 0; i < 2; ++i) {
    directions[i] = sandwich(task.upright, unit_axis(points[i]->direction));
    if (std::hypot(directions[i].x, directions[i].y) <= accuracy::join_error<double>()) {
      return Fault{FaultCode::outside_domain,
                   "the direction of point " + std::to_string(i) +
                       " is along the helix axis; a helix has an angle with its axis",
                   i,
                   "direction",
                   std::nullopt,
                   std::nullopt};
    }
  }
  if (std::abs(directions[0].z - directions[1].z) > accuracy::join_error<double>()) {
    return Fault{FaultCode::no_interpolant,
                 "the directions climb along the axis at " +
                     to_text(std::asin(std::clamp(directions[0].z, -1.0, 1.0))) + " and " +
                     to_text(std::asin(std::clamp(directions[1].z, -1.0, 1.0))) +
                     " rad; on a helix both angles are equal",
                 std::nullopt,
                 "direction",
                 std::abs(directions[0].z - directions[1].z),
                 accuracy::join_error<double>()};
  }
  const double level =
      std::hypot(directions[0].x, directions[0].y) + std::hypot(directions[1].x, directions[1].y);
  const double up = directions[0].z + directions[1].z;
  const Vector3<double> way = sandwich(task.upright, end.position - begin.position);
  task.begin = {{0.0, 0.0}, {directions[0].x, directions[0].y}};
  task.end = {{way.x, way.y}, {directions[1].x, directions[1].y}};
  task.start = begin.position;
  task.rise = way.z;
  const double angle = std::atan2(up, level);
  if (std::abs(up) <= accuracy::join_error<double>()) return angle_fault(0.0);
  if (!(way.z * up > 0.0)) return wrong_way(angle, way.z);
  task.angle = angle;
  task.slope = up / level;
  task.ground_length = way.z / task.slope;
  return task;
}

}  // namespace

Result<ClimbCurve> climb_curve(const HeadedPoint& begin, const HeadedPoint& end, double climb_angle,
                               double h, LengthSolutions among) {
  if (auto fault = planar_detail::altitude_fault(begin, end)) return *std::move(fault);
  Task task = task_between(begin, end);
  if (auto fault = set_angle(task, climb_angle)) return *std::move(fault);
  return solve(task, h, among);
}

Result<ClimbCurve> climb_curve_of_ground_length(const HeadedPoint& begin, const HeadedPoint& end,
                                                double ground_length, double h,
                                                LengthSolutions among) {
  if (auto fault = planar_detail::altitude_fault(begin, end)) return *std::move(fault);
  Task task = task_between(begin, end);
  task.ground_length = ground_length;
  return solve(task, h, among);
}

Result<std::vector<ClimbSolution>> climb_solutions(const HeadedPoint& begin, const HeadedPoint& end,
                                                   double climb_angle, double h,
                                                   LengthSolutions among) {
  if (auto fault = planar_detail::altitude_fault(begin, end)) return *std::move(fault);
  Task task = task_between(begin, end);
  if (auto fault = set_angle(task, climb_angle)) return *std::move(fault);
  return solve_all(task, h, among);
}

Result<ClimbCurve> helical_curve(const Vector3<double>& axis, const DirectedPoint3& begin,
                                 const DirectedPoint3& end, double h, LengthSolutions among) {
  const auto task = task_about(axis, begin, end);
  if (!task) return task.fault();
  return solve(*task, h, among);
}

Result<std::vector<ClimbSolution>> helical_solutions(const Vector3<double>& axis,
                                                     const DirectedPoint3& begin,
                                                     const DirectedPoint3& end, double h,
                                                     LengthSolutions among) {
  const auto task = task_about(axis, begin, end);
  if (!task) return task.fault();
  return solve_all(*task, h, among);
}

std::optional<Fault> climb_curves(std::span<const ClimbProblem> problems,
                                  std::span<ClimbAnswer> answers) {
  constexpr std::size_t longest = 64;
  std::array<PrescribedLengthProblem, longest> plans;
  std::array<PlanarHermiteAnswer, longest> found;
  const auto fault_of = [&](std::size_t first, std::size_t last) {
    for (std::size_t i = first; i < last; ++i) {  // the first that has a fault of its own
      const ClimbProblem& p = problems[i];
      const auto alone = climb_curve(p.begin, p.end, p.climb_angle, p.step);
      if (alone) continue;
      Fault fault = alone.fault();
      fault.index = i;
      fault.sentence = "problem " + std::to_string(i) + ": " + fault.sentence;
      return std::optional(std::move(fault));
    }
    return std::optional<Fault>();
  };
  for (std::size_t first = 0; first < problems.size(); first += longest) {
    const std::size_t count = std::min(longest, problems.size() - first);
    bool ordinary = true;
    for (std::size_t i = 0; i < count; ++i) {
      const ClimbProblem& p = problems[first + i];
      const double rise = p.end.position.z - p.begin.position.z;
      const double length = rise / std::tan(p.climb_angle);
      ordinary = ordinary && std::abs(p.climb_angle) < quarter_turn && std::isfinite(rise) &&
                 length > 0.0 && std::isfinite(length);
      plans[i] = {{{p.begin.position.x, p.begin.position.y}, p.begin.heading},
                  {{p.end.position.x, p.end.position.y}, p.end.heading},
                  length,
                  p.step};
    }
    const std::span<const PrescribedLengthProblem> some(plans.data(), count);
    if (!ordinary || prescribed_length_curves(some, std::span(found).first(count))) {
      if (auto fault = fault_of(first, first + count)) return fault;
      return out_of_range();
    }
    for (std::size_t i = 0; i < count; ++i) {
      const ClimbProblem& p = problems[first + i];
      const Vector2<double> chord = plans[i].end.position - plans[i].begin.position;
      const double rise = p.end.position.z - p.begin.position.z;
      double slope = rise / plans[i].length;
      if (is_straight(chord, plans[i].length)) {
        slope = rise / PlanarPhCurve<2>({}, PlanPreimage(found[i].preimage), p.step).arc_length();
      }
      const Pitch pitch = Pitch::of_slope(slope);
      ClimbAnswer& answer = answers[first + i];
      for (std::size_t j = 0; j < 3; ++j) answer.preimage[j] = lifted(found[i].preimage[j], pitch);
      answer.ground_length = plans[i].length;
      answer.rotation_index = found[i].rotation_index;
      answer.margin = found[i].margin;
    }
  }
  return std::nullopt;
}

}  // namespace hodograph
