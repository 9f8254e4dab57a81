// SPDX-License-Identifier: MIT
// The request "intersections": a planar path with another one, itself, a line or a segment.
#include "cli/planar_facts.hpp"
#include "cli/requests/handlers.hpp"
#include "hodograph/path/any_planar.hpp"

namespace hodograph::cli {
namespace {

[[noreturn]] void refuse_space(Members& request) {
  request.refuse("document", "this request is about paths in the plane; the path is in space");
}

Json json_of_line_meetings(const std::vector<LineIntersection>& meetings) {
  Json list = Json::array();
  for (const LineIntersection& at : meetings) {
    list.push_back({{"xi", at.xi},
                    {"xi_range", json_of(at.xi_range)},
                    {"t", json_of(at.t)},
                    {"point", list_of(at.point)},
                    {"kind", name_of(at.kind)}});
  }
  return list;
}

}  // namespace

Answer answer_intersections(Members& request) {
  const PathDocument document = request.document();
  if (document.path.dimension() != 2) refuse_space(request);
  const bool with_path = request.has("other") || request.has("other_file");
  const bool with_itself = request.has("itself") && request.truth("itself", false);
  const int given = static_cast<int>(with_path) + static_cast<int>(with_itself) +
                    static_cast<int>(request.has("line")) +
                    static_cast<int>(request.has("segment"));
  if (given != 1) {
    request.refuse(
        "other",
        "give what the path is to meet: \"other\" (or \"other_file\"), \"itself\": true, "
        "\"line\" or \"segment\", one of them");
  }
  Answer answer;
  Json& list = answer.result["intersections"] = Json::array();
  if (with_itself) {
    request.require_all_known();
    for (const auto& at : self_intersections(document.path)) list.push_back(json_of(at));
    return answer;
  }
  if (with_path) {
    const PathDocument other = request.document("other", "other_file");
    request.require_all_known();
    if (other.path.dimension() != 2) refuse_space(request);
    for (const auto& at : intersections(document.path, other.path)) list.push_back(json_of(at));
    return answer;
  }
  const bool whole = request.has("line");
  const auto numbers = request.vectors(whole ? "line" : "segment", 2);
  if (numbers.size() != 2) {
    request.refuse(whole ? "line" : "segment",
                   "there should be two points on it; got " + std::to_string(numbers.size()));
  }
  request.require_all_known();
  const Vector2<double> a{numbers[0][0], numbers[0][1]}, b{numbers[1][0], numbers[1][1]};
  list = json_of_line_meetings(whole ? line_intersections(document.path, a, b - a).value()
                                     : segment_intersections(document.path, a, b).value());
  return answer;
}

}  // namespace hodograph::cli
