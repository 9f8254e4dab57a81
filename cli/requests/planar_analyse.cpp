// SPDX-License-Identifier: MIT
// Requests about planar paths: analyse, offset.
#include "cli/offsets.hpp"
#include "cli/planar_facts.hpp"
#include "cli/requests/handlers.hpp"

namespace hodograph::cli {

Answer answer_analyse(Members& request) {
  const PathDocument document = request.document();
  const auto limit = request.maybe_number("curvature_limit");
  request.require_all_known();
  const auto facts = planar_facts_of(document.path);
  if (!facts) {
    request.refuse("document", "this request is about paths in the plane; the path is in space");
  }
  Answer answer{json_of(*facts), ""};
  if (limit) {
    answer.result["curvature_stays_within_limit"] =
        std::string(keeps_curvature_limit(document.path, *limit));
  }
  return answer;
}

Answer answer_offset(Members& request) {
  const PathDocument document = request.document();
  const double distance = request.number("distance");
  request.require_all_known();
  return {json_of(offset_of(document.path, distance)), ""};
}

}  // namespace hodograph::cli
