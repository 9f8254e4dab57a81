// SPDX-License-Identifier: MIT
// The request "separation".
#include "cli/motions.hpp"
#include "cli/requests/handlers.hpp"

namespace hodograph::cli {
namespace {

/// A path with how it is flown.
TimedMotion motion(Members members) {
  const PathDocument document = members.document();
  const Flight flight = flight_of(members);
  members.require_all_known();
  return motion_of(document.path, flight);
}

}  // namespace

Answer answer_separation(Members& request) {
  const TimedMotion first = motion(request.object("first"));
  const TimedMotion second = motion(request.object("second"));
  SeparationGoal goal;
  goal.vertical_scale = vertical_scale_of(request.number("ellipsoid", 1.0));
  const std::optional<double> at_least = request.maybe_number("at_least");
  const std::optional<double> step = request.maybe_number("step");
  request.require_all_known();
  Answer answer;
  answer.result = json_of(separation_facts(first, second, goal, at_least, step));
  return answer;
}

}  // namespace hodograph::cli
