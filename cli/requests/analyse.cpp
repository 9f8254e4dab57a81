// SPDX-License-Identifier: MIT
// Requests about a path that is there: evaluate, sample, inspect.
#include <algorithm>

#include "cli/requests/handlers.hpp"
#include "cli/sample_plan.hpp"

namespace hodograph::cli {

Answer answer_evaluate(Members& request) {
  const PathDocument document = request.document();
  if (request.has("xi") == request.has("arc_length")) {
    request.refuse("xi", "give the places as \"xi\" or as \"arc_length\", one of them");
  }
  SamplePlan plan;
  if (request.has("xi")) {
    plan.xi = request.numbers("xi");
  } else {
    plan.arc_length = request.numbers("arc_length");
  }
  request.require_all_known();
  request.require_at_most("xi", (plan.xi ? *plan.xi : *plan.arc_length).size(), most_places);
  Answer answer;
  Json& points = answer.result["points"] = Json::array();
  for (const double xi : sampled_parameters(document.path, plan).value()) {
    points.push_back(json_of(state_at(document.path, xi, document.roll)));
  }
  return answer;
}

Answer answer_sample(Members& request) {
  const PathDocument document = request.document();
  SamplePlan plan;
  int given = 0;
  if (request.has("count")) plan.count = request.count("count"), ++given;
  if (request.has("count_in_xi")) plan.count_in_xi = request.count("count_in_xi"), ++given;
  if (request.has("per_segment")) plan.count_per_segment = request.count("per_segment"), ++given;
  if (request.has("step")) plan.step = request.number("step"), ++given;
  if (request.has("chord")) plan.chord_tolerance = request.number("chord"), ++given;
  if (given != 1) {
    request.refuse(
        "request",
        "a sample needs one of \"count\", \"count_in_xi\", \"per_segment\", \"step\" and "
        "\"chord\"");
  }
  request.require_all_known();
  request.require_at_most("count", plan.count.value_or(0), most_points);
  request.require_at_most("count_in_xi", plan.count_in_xi.value_or(0), most_points);
  const std::vector<double> parameters = sampled_parameters(document.path, plan).value();
  request.require_at_most("request", parameters.size(), most_points);
  std::vector<double> lengths;
  Json positions = Json::array();
  std::vector<double> point(document.path.dimension());
  for (const double xi : parameters) {
    document.path.position(xi, point);
    positions.push_back(point);
    lengths.push_back(document.path.arc_length(xi));
  }
  Answer answer;
  answer.result["xi"] = parameters;
  answer.result["arc_length"] = lengths;
  answer.result["position"] = std::move(positions);
  return answer;
}

Answer answer_inspect(Members& request) {
  const PathDocument document = request.document();
  request.require_all_known();
  return {json_of(document, facts_of(document.path)), ""};
}

}  // namespace hodograph::cli
