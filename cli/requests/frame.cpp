// SPDX-License-Identifier: MIT
// The request "frame".
#include "cli/frames.hpp"
#include "cli/requests/handlers.hpp"
#include "cli/sample_plan.hpp"

namespace hodograph::cli {

Answer answer_frame(Members& request) {
  const PathDocument document = request.document();
  FrameRequest wanted;
  wanted.kind = request.word("kind", {frame_kinds.begin(), frame_kinds.end()}, wanted.kind);
  wanted.gamma = request.maybe_number("gamma");
  if (request.has("choose_gamma")) {
    wanted.found_gamma = request.word("choose_gamma", {found_gammas.begin(), found_gammas.end()});
    if (wanted.gamma) {
      request.refuse("choose_gamma", "gamma is given or chosen, one of them");
    }
  }
  wanted.begin = request.maybe_number("begin");
  wanted.end = request.maybe_number("end");
  if (request.has("begin_normal")) wanted.begin_normal = request.point("begin_normal");
  if (request.has("end_normal")) wanted.end_normal = request.point("end_normal");
  SamplePlan plan;
  if (request.has("xi") && request.has("count")) {
    request.refuse("xi", "give the places as \"xi\" or as \"count\", one of them");
  }
  if (request.has("xi")) plan.xi = request.numbers("xi");
  if (request.has("count")) plan.count = request.count("count");
  request.require_all_known();
  request.require_at_most("count", plan.count.value_or(0), most_places);
  request.require_at_most("xi", plan.xi ? plan.xi->size() : 0, most_places);
  const MadeFrame frame = make_frame(document, wanted);
  Answer answer;
  answer.result = json_of(frame, wanted);
  if (plan.xi || plan.count) {
    Json& list = answer.result["frames"] = Json::array();
    const auto places = sampled_parameters(document.path, plan).value();
    for (const auto& place : places_of(frame, document.path, places)) {
      list.push_back(json_of(place));
    }
  }
  return answer;
}

}  // namespace hodograph::cli
