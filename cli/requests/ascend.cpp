// SPDX-License-Identifier: MIT
// The request "ascend".
#include "cli/requests/handlers.hpp"

#ifdef HODOGRAPH_HAS_CONTROL
#include "cli/ascents.hpp"
#endif

namespace hodograph::cli {

#ifdef HODOGRAPH_HAS_CONTROL

Answer answer_ascend(Members& request) {
  const std::string problem = request.word("problem", ascent_problems, "energy");
  const std::string start = request.text("start");
  AscentOptions options;
  PoweredOptions& powered = options.powered;
  powered.duration_s = request.number("duration", powered.duration_s);
  powered.thrust_limit_m_s2 = request.number("thrust_limit", powered.thrust_limit_m_s2);
  powered.surface_km = request.number("surface_km", powered.surface_km);
  powered.margin_km = request.number("margin_km", powered.margin_km);
  options.tracking.singular_theta =
      request.number("singular_theta", options.tracking.singular_theta);
  options.along_path = request.word("coordinates", ascent_coordinates, "rectangular") == "path";
  const bool gravity = problem == "energy" || problem == "time";
  if (options.along_path && !gravity) {
    throw Error(
        Fault{FaultCode::unsupported,
              "the coordinates of the path are for the problems with gravity, energy and time",
              std::nullopt, "/coordinates", std::nullopt, std::nullopt});
  }
  constexpr std::size_t most_intervals = 2000, most_guesses = 16, most_iterations = 3000;
  const std::size_t intervals = request.count("intervals", powered.intervals);
  const std::size_t guesses = request.count("guesses", powered.solving.guesses);
  request.require_at_most("intervals", intervals, most_intervals);
  request.require_at_most("guesses", guesses, most_guesses);
  powered.intervals = options.tracking.intervals = intervals;
  for (AscentSolving* solving : {&options.tracking.solving, &powered.solving}) {
    solving->guesses = guesses;
    solving->max_iterations = request.count("most_iterations", solving->max_iterations);
    request.require_at_most("most_iterations", solving->max_iterations, most_iterations);
  }
  const bool nodes = request.truth("nodes", true);
  request.require_all_known();
  static const Result<AscentReference> reference = AscentReference::gateway();
  const AscentSet set = solved_ascents(reference.value(), problem, {start}, options);
  Answer answer;
  answer.result = json_of(set, nodes);
  answer.result = answer.result["ascents"].front();
  return answer;
}

#else

Answer answer_ascend(Members&) {
  throw Error(Fault{FaultCode::unsupported, "this program was built without Ipopt", std::nullopt,
                    "request", std::nullopt, std::nullopt});
}

#endif

}  // namespace hodograph::cli
