// SPDX-License-Identifier: MIT
// The request "nearest".
#include "hodograph/path/nearest_point.hpp"

#include "cli/requests/handlers.hpp"

namespace hodograph::cli {
namespace {

const char* name_of(StationaryKind kind) {
  switch (kind) {
    case StationaryKind::minimum:
      return "minimum";
    case StationaryKind::maximum:
      return "maximum";
    case StationaryKind::undecided:
      return "undecided";
  }
  return "";
}

template <class Point>
Json json_of_stationary(const StationaryPoint<Point>& stationary) {
  return {{"xi", stationary.xi},
          {"xi_range", cli::json_of(stationary.xi_range)},
          {"point", list_of(stationary.point)},
          {"distance", stationary.distance},
          {"kind", name_of(stationary.kind)}};
}

}  // namespace

Answer answer_nearest(Members& request) {
  const PathDocument document = request.document();
  const auto numbers = request.numbers("point", document.path.dimension());
  const bool all = request.truth("stationary", false);
  request.require_all_known();
  Answer answer;
  document.path.visit([&](const auto& path) {
    typename std::remove_cvref_t<decltype(path)>::Point point{};
    for (std::size_t i = 0; i < numbers.size(); ++i) point[i] = numbers[i];
    const auto nearest = nearest_point(path, point).value();
    answer.result["nearest"] = json_of_stationary(nearest.at);
    answer.result["distance"] = cli::json_of(nearest.distance);
    if (!all) return;
    Json& list = answer.result["stationary"] = Json::array();
    for (const auto& one : stationary_points(path, point).value())
      list.push_back(json_of_stationary(one));
  });
  return answer;
}

}  // namespace hodograph::cli
