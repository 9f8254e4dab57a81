// SPDX-License-Identifier: MIT
// The request "loop".
#include <cmath>

#include "cli/loops.hpp"
#include "cli/requests/handlers.hpp"

namespace hodograph::cli {
namespace {

Json json_of_extremes(const Extremes& extremes) {
  return {{"minimum", json_of(extremes.minimum)}, {"maximum", json_of(extremes.maximum)}};
}

}  // namespace

Answer answer_loop(Members& request) {
  LoopRequest wanted;
  wanted.length = request.number("length", wanted.length);
  if (request.has("start")) wanted.start = request.point("start");
  if (request.has("direction")) wanted.direction = request.point("direction");
  if (request.has("normal")) wanted.normal = request.point("normal");
  wanted.roll = request.number("roll", wanted.roll);
  wanted.xi = request.maybe_number("xi");
  wanted.psi = request.maybe_number("psi");
  if (request.has("limit")) wanted.limit = request.word("limit", {"positive", "negative"});
  if (request.has("for")) {
    wanted.purpose = request.word("for", {loop_purposes.begin(), loop_purposes.end()});
  }
  if (request.has("point")) wanted.point = request.point("point");
  if (request.has("extents")) wanted.extents = request.point("extents");
  if (request.has("within")) {
    const auto box = request.vectors("within", 3);
    if (box.size() != 2) {
      request.refuse("within",
                     "the box is given by two corners; got " + std::to_string(box.size()));
    }
    wanted.within = LoopBox{{box[0][0], box[0][1], box[0][2]}, {box[1][0], box[1][1], box[1][2]}};
  }
  wanted.free_roll = request.truth("free_roll", wanted.free_roll);
  wanted.largest_xi = request.maybe_number("largest_xi");
  request.require_all_known();
  if (wanted.point && wanted.purpose != "near") {
    request.refuse("point", "a point is for a loop whose \"for\" is \"near\"");
  }
  if (wanted.extents && wanted.purpose != "extents") {
    request.refuse("extents", "extents are for a loop whose \"for\" is \"extents\"");
  }
  const MadeLoop loop = make_loop(wanted);
  const LoopFacts& facts = loop.facts;
  Answer answer;
  answer.result = {{"arc_length", loop.path.arc_length()},
                   {"xi", loop.shape.xi},
                   {"psi", loop.shape.psi},
                   {"roll", loop.roll}};
  answer.result["control_points"] = Json::array();
  const auto& curve = loop.path.segment(0);
  for (const auto& c : curve.integral().coefficients()) {
    answer.result["control_points"].push_back(list_of(curve.start() + c.displacement));
  }
  answer.result["juncture"] = {{"curvature", loop.juncture.curvature},
                               {"torsion_begin", loop.juncture.torsion_begin},
                               {"torsion_end", loop.juncture.torsion_end}};
  answer.result["speed"] = json_of_extremes(facts.speed);
  answer.result["curvature"] = json_of_extremes(facts.curvature);
  answer.result["torsion"] = json_of_extremes(facts.torsion);
  answer.result["bending_energy"] = facts.energy ? json_of(*facts.energy) : Json();
  answer.result["tube_radius"] = json_of(facts.tube.radius);
  answer.result["tube_limit"] = name_of(facts.tube.limit);
  if (loop.chosen) {
    Json& chosen = answer.result["chosen"];
    chosen = {{"value", json_of(loop.chosen->value)},
              {"grid_steps", Json::array()},
              {"evaluations", loop.chosen->evaluations}};
    for (const double step : loop.chosen->grid_steps) chosen["grid_steps"].push_back(step);
  }
  answer.document = to_json(made_path(loop, "").document);
  return answer;
}

}  // namespace hodograph::cli
