// SPDX-License-Identifier: MIT
// The request "plan".
#include "cli/plan_comparison.hpp"
#include "cli/plans.hpp"
#include "cli/requests/handlers.hpp"
#include "hodograph/io/geojson.hpp"

namespace hodograph::cli {

Answer answer_plan(Members& request) {
  const bool in_file = request.has("world_file");
  if (in_file == request.has("world")) {
    request.refuse("world",
                   "give the world as \"world\" (GeoJSON) or as \"world_file\", one of them");
  }
  const std::string file = in_file ? request.text("world_file") : "";
  const WorldDocument document =
      (in_file ? load_world(file) : parse_world(request.json_text("world"), "the world")).value();
  PlanRequest plan_request;
  const auto place = [&](const char* name, const std::optional<Vector2<double>>& named) {
    if (!request.has(name) && named) return *named;
    const auto numbers = request.numbers(name, 2);
    return Vector2<double>{numbers[0], numbers[1]};
  };
  plan_request.start = place("start", document.start);
  plan_request.goal = place("goal", document.goal);
  VehicleLimits limits;
  limits.turn_radius = request.number("turn_radius");
  limits.clearance = request.number("clearance", 0.0);
  limits.width = request.number("width", 0.0);
  plan_request.aim = corner_aim(
      request.word("corners", {std::begin(corner_words), std::end(corner_words)}, "smallest"));
  plan_request.corner_offset = request.maybe_number("corner_offset");
  plan_request.most_attempts = request.count("most_attempts", plan_request.most_attempts);
  const bool compare = request.truth("compare", false);
  request.require_all_known();
  const Planner planner = Planner::create(document.world, limits).value();
  const Plan plan = planner.plan(plan_request).value();
  Answer answer;
  answer.result = json_of(plan, planner.world());
  if (compare) {
    answer.result["compared"] = json_of(compared_plans(plan, planner.world()), limits, file, true);
  }
  answer.document = to_json(made_plan(plan, limits, plan_request.aim, file).document);
  return answer;
}

}  // namespace hodograph::cli
