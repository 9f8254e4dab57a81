// SPDX-License-Identifier: MIT
// The request "intersections": a planar path with another one, a line or a segment.
#include "hodograph/path/intersections.hpp"

#include "cli/requests/handlers.hpp"
#include "hodograph/path/operations.hpp"

namespace hodograph::cli {
namespace {

const char* name_of(IntersectionKind kind) {
  return kind == IntersectionKind::crossing ? "crossing" : "undecided";
}

[[noreturn]] void refuse_space(Members& request) {
  request.refuse("document", "this request is about paths in the plane; the path is in space");
}

/// The path written with preimage degree m, at least its own.
template <std::size_t m>
PlanarPath<m> raised(const AnyPath& path) {
  return path.visit([](const auto& p) -> PlanarPath<m> {
    using P = std::remove_cvref_t<decltype(p)>;
    if constexpr (P::Point::dimension == 2 && P::preimage_degree <= m) {
      return with_preimage_degree<m>(p).value();
    } else {
      throw std::logic_error("a path of a degree that does not fit");
    }
  });
}

/// Calls function(std::integral_constant) with the least of a few degrees that hold `degree`: the
/// search is compiled for these alone.
template <class Function>
void with_degree(std::size_t degree, const Function& function) {
  if (degree <= 2) return function(std::integral_constant<std::size_t, 2>{});
  if (degree <= 4) return function(std::integral_constant<std::size_t, 4>{});
  return function(std::integral_constant<std::size_t, maximum_dynamic_degree>{});
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
  const int given = static_cast<int>(with_path) + static_cast<int>(request.has("line")) +
                    static_cast<int>(request.has("segment"));
  if (given != 1) {
    request.refuse("other",
                   "give what the path is to meet: \"other\" (or \"other_file\"), \"line\" or "
                   "\"segment\", one of them");
  }
  Answer answer;
  Json& list = answer.result["intersections"] = Json::array();
  if (with_path) {
    const PathDocument other = request.document("other", "other_file");
    request.require_all_known();
    if (other.path.dimension() != 2) refuse_space(request);
    with_degree(std::max(document.path.preimage_degree(), other.path.preimage_degree()),
                [&](auto degree) {
                  constexpr std::size_t m = degree();
                  for (const PathIntersection& at :
                       intersections(raised<m>(document.path), raised<m>(other.path))) {
                    list.push_back({{"xi", at.xi_first},
                                    {"xi_range", json_of(at.xi_first_range)},
                                    {"other_xi", at.xi_second},
                                    {"other_xi_range", json_of(at.xi_second_range)},
                                    {"point", list_of(at.point)},
                                    {"kind", name_of(at.kind)}});
                  }
                });
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
  with_degree(document.path.preimage_degree(), [&](auto degree) {
    const auto path = raised<degree()>(document.path);
    list = json_of_line_meetings(whole ? line_intersections(path, a, b - a).value()
                                       : segment_intersections(path, a, b).value());
  });
  return answer;
}

}  // namespace hodograph::cli
