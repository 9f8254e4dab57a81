// SPDX-License-Identifier: MIT
// The request "follow".
#include "cli/requests/handlers.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include "cli/follows.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL

Answer answer_follow(Members& request) {
  const PathDocument document = request.document();
  const bool planar = document.path.dimension() == 2;
  FollowRequest wanted;
  FollowLimits& limits = wanted.limits;
  limits.speed = request.number("speed");
  limits.acceleration = request.number("acceleration");
  limits.braking = request.number("braking", 0.0);
  limits.turn_radius = request.number("turn_radius", 0.0);
  limits.offset = request.number("offset");
  if (const auto lateral = request.maybe_number("lateral_acceleration")) {
    limits.lateral_acceleration = *lateral;
  }
  FollowStart& start = wanted.start;
  start.xi = request.number("from_xi", document.path.xi_begin());
  start.speed = request.number("start_speed", 0.0);
  start.heading = request.number("start_heading", 0.0);
  if (request.has("start_offset")) {
    const std::vector<double> offset = request.numbers("start_offset", planar ? 1 : 2);
    std::copy(offset.begin(), offset.end(), start.offset.begin());
  }
  FollowOptions& options = wanted.options;
  options.xi_end = request.maybe_number("to_xi");
  options.end_speed = request.maybe_number("end_speed");
  if (const auto duration = request.maybe_number("duration")) {
    options.aim = FollowAim::most_progress;
    options.duration = *duration;
  }
  if (request.word("independent", {"time", "xi"}, "time") == "xi") {
    options.independent = FollowIndependent::progress;
  }
  options.effort = request.number("effort", options.effort);
  constexpr std::size_t most_intervals = 2000, most_iterations = 3000;
  options.intervals = request.count("intervals", options.intervals);
  constexpr std::size_t usual_iterations = 300;  // some ten times what it usually takes
  options.solver.max_iterations = request.count("most_iterations", usual_iterations);
  const bool nodes = request.truth("nodes", true);
  request.require_all_known();
  request.require_at_most("intervals", options.intervals, most_intervals);
  request.require_at_most("most_iterations", options.solver.max_iterations, most_iterations);
  Answer answer;
  answer.result = json_of(follow(document.path, limits, start, options).value(), wanted,
                          std::nullopt, nodes, document.path.dimension());
  return answer;
}

#else

Answer answer_follow(Members&) {
  throw Error(Fault{FaultCode::unsupported,
                    "this program was built without Ipopt (the component control)", std::nullopt,
                    "request", std::nullopt, std::nullopt});
}

#endif

}  // namespace hodograph::cli
