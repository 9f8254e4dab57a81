// SPDX-License-Identifier: MIT
// What is known of curves between end points, for people and for programs.
#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cli/rational_hermites.hpp"

namespace hodograph::cli {
namespace {

using Outcome = CuspFreeAnswer::Outcome;
using Reason = CuspFreeAnswer::Reason;

constexpr std::size_t longest_line = 300;  // characters; longer values are for programs

std::string row(const std::string& label, const std::string& value) {
  constexpr std::size_t width = 18;
  std::string line = "  " + label;
  line.resize(std::max(line.size() + 1, width + 2), ' ');
  const bool whole = value.size() <= longest_line;
  return line +
         (whole ? value
                : value.substr(0, longest_line) + "... (" + std::to_string(value.size()) +
                      " characters; --json has them)") +
         "\n";
}

std::string direction_row(const char* label, const RationalDirection& direction) {
  if (direction.exact) return row(label, to_text(direction.unit));
  return row(label, to_text(direction.unit) + ", the nearest rational direction that is simple: " +
                        to_six_digits(direction.deviation) + " rad from the one given, whose " +
                        "length is irrational");
}

const char* word_of(Outcome outcome) {
  return outcome == Outcome::found ? "found" : outcome == Outcome::none ? "none" : "undecided";
}
const char* word_of(Reason reason) {
  switch (reason) {
    case Reason::contradiction:
      return "contradiction";
    case Reason::cone:
      return "cone";
    case Reason::single_curve:
      return "single_curve";
    case Reason::weights:
      return "weights";
    case Reason::not_applicable:
      break;
  }
  return "";
}
const char* word_of(ConeTest::Outcome outcome) {
  return outcome == ConeTest::Outcome::inside    ? "inside"
         : outcome == ConeTest::Outcome::outside ? "outside"
                                                 : "undecided";
}

/// Of the whole answer: that of the space, or of the search.
Outcome outcome_of(const RationalHermiteAnswer& answer) {
  if (answer.answer) return answer.answer->outcome;
  if (answer.search->cone) return Outcome::none;
  const auto& before = answer.search->before;
  return std::all_of(before.begin(), before.end(),
                     [](const auto& s) { return s.answer.outcome == Outcome::none; })
             ? Outcome::none
             : Outcome::undecided;
}

Json list_of(const std::vector<Rational>& numbers) {
  Json list = Json::array();
  for (const Rational& x : numbers) list.push_back(to_text(x));
  return list;
}
Json json_of(const ConeTest& cone) {
  return {
      {"outcome", word_of(cone.outcome)},
      {"sentence", cone.sentence},
      {"normal", cone.outcome == ConeTest::Outcome::outside ? cli::json_of(cone.normal) : Json()},
      {"nodes", list_of(cone.nodes)},
      {"weights", list_of(cone.weights)}};
}
Json json_of(const std::optional<RationalDirection>& direction) {
  if (!direction) return {};
  return {{"unit", cli::json_of(direction->unit)},
          {"length", to_text(direction->length)},
          {"exact", direction->exact},
          {"deviation", direction->deviation}};
}
Json reason_json(const CuspFreeAnswer& answer) {
  const std::string word = word_of(answer.reason);
  return word.empty() ? Json() : Json(word);
}

}  // namespace

std::string text_of(const RationalHermiteAnswer& answer) {
  const RationalHermiteData& data = answer.data;
  std::string text = row("from", to_text(data.begin_point) + " at t = " + to_text(data.begin)) +
                     row("to", to_text(data.end_point) + " at t = " + to_text(data.end));
  if (answer.begin_direction) text += direction_row("tangent there", *answer.begin_direction);
  if (answer.end_direction) text += direction_row("and there", *answer.end_direction);
  if (data.begin_derivative) text += row("r' at the begin", to_text(*data.begin_derivative));
  if (data.end_derivative) text += row("r' at the end", to_text(*data.end_derivative));
  text += row(answer.a_chosen ? "A, chosen" : "A", to_text(answer.a));
  text += row("cone test", std::string(word_of(answer.cone.outcome)) + ": " + answer.cone.sentence);
  if (answer.search) {
    std::size_t contradictions = 0;
    for (const SearchedSpace& space : answer.search->before) {
      if (space.answer.reason == Reason::contradiction) {
        ++contradictions;
        continue;
      }
      const std::string power =
          answer.problem.base ? "base^" + std::to_string(space.power) + ": " : "";
      text += row("deg B <= " + std::to_string(space.degree), power + space.answer.sentence);
    }
    if (contradictions > 0) {
      text += row("left out",
                  std::to_string(contradictions) +
                      " smaller spaces, in which the conditions at the ends have no solution");
    }
  }
  if (answer.curves) {
    text += row("space", "deg B <= " + std::to_string(*answer.degree) +
                             ", alpha = " + to_text(answer.alpha));
    text += row("conditions",
                std::to_string(answer.curves->equations()) + " for " +
                    std::to_string(answer.curves->unknowns()) + " unknowns; " +
                    (answer.curves->solvable()
                         ? std::to_string(answer.curves->freedom()) + " free parameters remain"
                         : "they contradict each other"));
  }
  text += "\n" + answer.sentence + "\n";
  if (answer.curve) text += text_of(*answer.curve);
  return text;
}

Json json_of(const RationalHermiteAnswer& answer) {
  const RationalHermiteData& data = answer.data;
  Json json = {
      {"outcome", word_of(outcome_of(answer))},
      {"reason", Json()},
      {"sentence", answer.sentence},
      {"P0", json_of(data.begin_point)},
      {"P1", json_of(data.end_point)},
      {"begin", to_text(data.begin)},
      {"end", to_text(data.end)},
      {"v0", data.begin_derivative ? json_of(*data.begin_derivative) : Json()},
      {"v1", data.end_derivative ? json_of(*data.end_derivative) : Json()},
      {"begin_direction", json_of(answer.begin_direction)},
      {"end_direction", json_of(answer.end_direction)},
      {"A", json_of(answer.a)},
      {"A_chosen", answer.a_chosen},
      {"cone", json_of(answer.cone)},
      {"alpha", answer.curves ? json_of(answer.alpha) : Json()},
      {"degree", answer.degree ? Json(*answer.degree) : Json()},
      {"unknowns", answer.curves ? Json(answer.curves->unknowns()) : Json()},
      {"equations", answer.curves ? Json(answer.curves->equations()) : Json()},
      {"freedom",
       answer.curves && answer.curves->solvable() ? Json(answer.curves->freedom()) : Json()}};
  json["contradiction"] = answer.curves && !answer.curves->solvable()
                              ? list_of(answer.curves->contradiction())
                              : Json();
  Json nodes, weights, cusp, bound;
  if (answer.answer) {
    json["reason"] = reason_json(*answer.answer);
    if (!answer.answer->nodes.empty()) {
      nodes = list_of(answer.answer->nodes);
      weights = list_of(answer.answer->weights);
    }
    if (answer.answer->cusp) cusp = json_of(*answer.answer->cusp);
    if (answer.answer->speed_bound) bound = to_text(*answer.answer->speed_bound);
  } else if (answer.search->cone) {
    json["reason"] = word_of(Reason::cone);
  }
  json["nodes"] = std::move(nodes);
  json["weights"] = std::move(weights);
  json["cusp"] = std::move(cusp);
  json["speed_bound"] = std::move(bound);
  json["proved_smallest"] =
      answer.search && answer.search->found ? Json(answer.search->proved_smallest) : Json();
  Json& before = json["before"] = Json::array();
  if (answer.search) {
    for (const SearchedSpace& space : answer.search->before) {
      before.push_back({{"power", answer.problem.base ? Json(space.power) : Json()},
                        {"degree", space.degree},
                        {"outcome", word_of(space.answer.outcome)},
                        {"reason", reason_json(space.answer)},
                        {"sentence", space.answer.sentence}});
    }
  }
  json["curve"] = answer.curve ? json_of(*answer.curve) : Json();
  return json;
}

}  // namespace hodograph::cli
