// SPDX-License-Identifier: MIT
// The request "operate": a path from one path or two.
#include <functional>
#include <utility>

#include "cli/requests/handlers.hpp"
#include "hodograph/foundation/version.hpp"
#include "hodograph/path/any_operations.hpp"

namespace hodograph::cli {
namespace {

void require_no_roll(Members& request, const PathDocument& document, const char* operation) {
  if (document.roll) {
    request.refuse("operation",
                   std::string("a path with a roll of its frame cannot be ") + operation);
  }
}

PathDocument reverse(PathDocument document, Members&) {
  document.path = reversed(document.path).value();
  if (document.roll) {  // e₃ changes its sign, and ξ
    document.roll = LinearRoll<double>{-document.roll->xi_begin, -document.roll->theta_begin,
                                       document.roll->rate};
  }
  return document;
}

PathDocument cut(PathDocument document, Members& request) {
  const double from = request.number("from"), to = request.number("to");
  document.path = subpath(document.path, from, to).value();
  return document;
}

PathDocument join(PathDocument document, Members& request) {
  const PathDocument other = request.document("other", "other_file");
  require_no_roll(request, document, "joined");
  require_no_roll(request, other, "joined");
  document.path = joined(document.path, other.path).value();
  return document;
}

PathDocument move(PathDocument document, Members& request) {
  if (document.path.dimension() == 2) {
    const double angle = request.number("angle", 0.0);
    const auto shift = request.has("translation") ? request.numbers("translation", 2)
                                                  : std::vector<double>{0.0, 0.0};
    document.path = moved(document.path, angle, {shift[0], shift[1]}).value();
  } else {
    const auto q = request.has("rotation") ? request.numbers("rotation", 4)
                                           : std::vector<double>{1.0, 0.0, 0.0, 0.0};
    const auto shift =
        request.has("translation") ? request.point("translation") : Vector3<double>{};
    document.path = moved(document.path, {q[0], q[1], q[2], q[3]}, shift).value();
  }
  return document;
}

PathDocument scale(PathDocument document, Members& request) {
  const double factor = request.number("factor");
  document.path = scaled(document.path, factor).value();
  return document;
}

PathDocument reflect(PathDocument document, Members& request) {
  const std::size_t dimension = document.path.dimension();
  const auto normal = request.numbers("normal", dimension);
  const auto point = request.has("point") ? request.numbers("point", dimension)
                                          : std::vector<double>(dimension, 0.0);
  document.path = reflected(document.path, normal, point).value();
  if (document.roll) {  // e₃ changes its sign
    document.roll->theta_begin = -document.roll->theta_begin;
    document.roll->rate = -document.roll->rate;
  }
  return document;
}

PathDocument lift(PathDocument document, Members&) {
  document.path = lifted(document.path).value();
  return document;
}

PathDocument reparametrise(PathDocument document, Members& request) {
  const double from = request.number("from"), to = request.number("to");
  const double begin = document.path.xi_begin();
  const double stretch = (to - from) / (document.path.xi_end() - begin);
  document.path = reparametrised(document.path, from, to).value();
  if (document.roll) {
    document.roll->xi_begin = from + (document.roll->xi_begin - begin) * stretch;
    document.roll->rate = document.roll->rate / stretch;
  }
  return document;
}

PathDocument close(PathDocument document, Members& request) {
  const bool closed = request.truth("closed", true);
  document.path = with_closure(document.path, closed).value();
  return document;
}

PathDocument elevate(PathDocument document, Members& request) {
  document.path = with_preimage_degree(document.path, request.count("preimage_degree")).value();
  return document;
}

struct NamedOperation {
  const char* name;
  PathDocument (*apply)(PathDocument, Members&);
};
constexpr std::array operations = {
    NamedOperation{"reverse", reverse}, NamedOperation{"subpath", cut},
    NamedOperation{"join", join},       NamedOperation{"move", move},
    NamedOperation{"scale", scale},     NamedOperation{"reflect", reflect},
    NamedOperation{"lift", lift},       NamedOperation{"reparametrise", reparametrise},
    NamedOperation{"close", close},     NamedOperation{"elevate", elevate},
};

}  // namespace

Answer answer_operate(Members& request) {
  PathDocument document = request.document();
  std::vector<std::string> names;
  for (const NamedOperation& operation : operations) names.emplace_back(operation.name);
  const std::string name = request.word("operation", names);
  for (const NamedOperation& operation : operations) {
    if (name == operation.name) document = operation.apply(std::move(document), request);
  }
  request.require_all_known();
  document.provenance = Provenance{};
  document.provenance.program = std::string("hodograph ") + version;
  document.provenance.method = name;
  const PathFacts facts = facts_of(document.path);
  document.promises = promises_of(facts);
  Answer answer;
  answer.result["segments"] = document.path.segment_count();
  answer.result["arc_length"] = document.path.arc_length();
  answer.result["continuity"] = json_of(facts.continuity);
  answer.document = to_json(document);
  return answer;
}

}  // namespace hodograph::cli
