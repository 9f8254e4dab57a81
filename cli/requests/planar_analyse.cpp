// SPDX-License-Identifier: MIT
// Requests: analyse a path; offset a planar one.
#include "cli/offsets.hpp"
#include "cli/planar_facts.hpp"
#include "cli/requests/handlers.hpp"
#include "cli/spatial_facts.hpp"

namespace hodograph::cli {

Answer answer_analyse(Members& request) {
  const PathDocument document = request.document();
  const auto limit = request.maybe_number("curvature_limit");
  request.require_all_known();
  if (const auto spatial = spatial_facts_of(document.path)) {
    if (limit) {
      request.refuse("curvature_limit", "it is decided of paths in the plane; this is in space");
    }
    return {json_of(*spatial), ""};
  }
  const auto facts = planar_facts_of(document.path);
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
