// SPDX-License-Identifier: MIT
// The request "frame".
#include "cli/frames.hpp"
#include "cli/requests/handlers.hpp"
#include "cli/sample_plan.hpp"

namespace hodograph::cli {

Answer answer_frame(Members& members) {
  const PathDocument document = members.document();
  FrameRequest request;
  request.kind = members.word("kind", {frame_kinds.begin(), frame_kinds.end()}, request.kind);
  request.gamma = members.maybe_number("gamma");
  if (members.has("choose_gamma")) {
    request.found_gamma = members.word("choose_gamma", {found_gammas.begin(), found_gammas.end()});
    if (request.gamma) {
      members.refuse("choose_gamma", "gamma is given or chosen, one of them");
    }
  }
  request.begin = members.maybe_number("begin");
  request.end = members.maybe_number("end");
  if (members.has("begin_normal")) request.begin_normal = members.point("begin_normal");
  if (members.has("end_normal")) request.end_normal = members.point("end_normal");
  SamplePlan plan;
  if (members.has("xi") && members.has("count")) {
    members.refuse("xi", "give the places as \"xi\" or as \"count\", one of them");
  }
  if (members.has("xi")) plan.xi = members.numbers("xi");
  if (members.has("count")) plan.count = members.count("count");
  members.require_all_known();
  members.require_at_most("count", plan.count.value_or(0), most_places);
  members.require_at_most("xi", plan.xi ? plan.xi->size() : 0, most_places);
  const MadeFrame frame = make_frame(document, request);
  Answer answer;
  answer.result = json_of(frame, request);
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
