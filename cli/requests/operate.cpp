// SPDX-License-Identifier: MIT
// The request "operate": a path from one path or two.
#include <functional>
#include <utility>

#include "cli/requests/handlers.hpp"
#include "hodograph/foundation/version.hpp"
#include "hodograph/path/operations.hpp"

namespace hodograph::cli {
namespace {

/// The path in its static type, as a document's path.
template <class P>
AnyPath any(Result<P> result) {
  return AnyPath(std::move(result).value());
}

/// The same path with its preimage written in a degree that is higher by one.
AnyPath elevated_by_one(const AnyPath& path) {
  return path.visit([](const auto& p) -> AnyPath {
    constexpr std::size_t n = std::remove_cvref_t<decltype(p)>::preimage_degree;
    if constexpr (n < maximum_dynamic_degree) {
      return any(with_preimage_degree<n + 1>(p));
    } else {
      return AnyPath(p);
    }
  });
}

AnyPath elevated_to(AnyPath path, std::size_t degree) {
  while (path.preimage_degree() < degree) path = elevated_by_one(path);
  return path;
}

void require_no_roll(Members& request, const PathDocument& document, const char* operation) {
  if (document.roll) {
    request.refuse("operation",
                   std::string("a path with a roll of its frame cannot be ") + operation);
  }
}

PathDocument reverse(PathDocument document, Members&) {
  document.path = document.path.visit([](const auto& p) { return any(reversed(p)); });
  if (document.roll) {  // e₃ changes its sign, and ξ
    document.roll = LinearRoll<double>{-document.roll->xi_begin, -document.roll->theta_begin,
                                       document.roll->rate};
  }
  return document;
}

PathDocument cut(PathDocument document, Members& request) {
  const double from = request.number("from"), to = request.number("to");
  document.path = document.path.visit([&](const auto& p) { return any(subpath(p, from, to)); });
  return document;
}

PathDocument join(PathDocument document, Members& request) {
  const PathDocument other = request.document("other", "other_file");
  require_no_roll(request, document, "joined");
  require_no_roll(request, other, "joined");
  if (other.path.dimension() != document.path.dimension()) {
    request.refuse("operation",
                   "one path is planar and the other spatial; lift the planar one first");
  }
  const std::size_t degree =
      std::max(document.path.preimage_degree(), other.path.preimage_degree());
  const AnyPath second = elevated_to(other.path, degree);
  document.path =
      elevated_to(std::move(document.path), degree).visit([&](const auto& p) -> AnyPath {
        return any(joined(p, *second.get_if<std::remove_cvref_t<decltype(p)>>()));
      });
  return document;
}

PathDocument move(PathDocument document, Members& request) {
  document.path = document.path.visit([&](const auto& p) -> AnyPath {
    if constexpr (std::remove_cvref_t<decltype(p)>::Point::dimension == 2) {
      const double angle = request.number("angle", 0.0);
      const auto shift = request.has("translation") ? request.numbers("translation", 2)
                                                    : std::vector<double>{0.0, 0.0};
      return any(moved(p, angle, Vector2<double>{shift[0], shift[1]}));
    } else {
      const auto q = request.has("rotation") ? request.numbers("rotation", 4)
                                             : std::vector<double>{1.0, 0.0, 0.0, 0.0};
      const auto shift =
          request.has("translation") ? request.point("translation") : Vector3<double>{};
      return any(moved(p, Quaternion<double>{q[0], q[1], q[2], q[3]}, shift));
    }
  });
  return document;
}

PathDocument scale(PathDocument document, Members& request) {
  const double factor = request.number("factor");
  document.path = document.path.visit([&](const auto& p) { return any(scaled(p, factor)); });
  return document;
}

PathDocument reflect(PathDocument document, Members& request) {
  document.path = document.path.visit([&](const auto& p) -> AnyPath {
    using Point = typename std::remove_cvref_t<decltype(p)>::Point;
    const auto read = [](const std::vector<double>& numbers) {
      Point point{};
      for (std::size_t i = 0; i < Point::dimension; ++i) point[i] = numbers[i];
      return point;
    };
    const Point normal = read(request.numbers("normal", Point::dimension));
    const Point point =
        request.has("point") ? read(request.numbers("point", Point::dimension)) : Point{};
    return any(reflected(p, normal, point));
  });
  if (document.roll) {  // e₃ changes its sign
    document.roll->theta_begin = -document.roll->theta_begin;
    document.roll->rate = -document.roll->rate;
  }
  return document;
}

PathDocument lift(PathDocument document, Members& request) {
  document.path = document.path.visit([&](const auto& p) -> AnyPath {
    if constexpr (std::remove_cvref_t<decltype(p)>::Point::dimension == 2) {
      return any(lifted(p));
    } else {
      request.refuse("operation", "the path is in space already; only a planar one is lifted");
    }
  });
  return document;
}

PathDocument reparametrise(PathDocument document, Members& request) {
  const double from = request.number("from"), to = request.number("to");
  const double begin = document.path.xi_begin();
  const double stretch = (to - from) / (document.path.xi_end() - begin);
  document.path =
      document.path.visit([&](const auto& p) { return any(reparametrised(p, from, to)); });
  if (document.roll) {
    document.roll->xi_begin = from + (document.roll->xi_begin - begin) * stretch;
    document.roll->rate = document.roll->rate / stretch;
  }
  return document;
}

PathDocument close(PathDocument document, Members& request) {
  const bool closed = request.truth("closed", true);
  document.path = document.path.visit([&](const auto& p) { return any(with_closure(p, closed)); });
  return document;
}

PathDocument elevate(PathDocument document, Members& request) {
  const std::size_t degree = request.count("preimage_degree");
  if (degree < document.path.preimage_degree() || degree > maximum_dynamic_degree) {
    request.refuse("preimage_degree", "the degree is " + std::to_string(degree) +
                                          "; it should be " +
                                          std::to_string(document.path.preimage_degree()) + " to " +
                                          std::to_string(maximum_dynamic_degree));
  }
  document.path = elevated_to(std::move(document.path), degree);
  return document;
}

struct Operation {
  const char* name;
  PathDocument (*apply)(PathDocument, Members&);
};
constexpr std::array operations = {
    Operation{"reverse", reverse}, Operation{"subpath", cut},
    Operation{"join", join},       Operation{"move", move},
    Operation{"scale", scale},     Operation{"reflect", reflect},
    Operation{"lift", lift},       Operation{"reparametrise", reparametrise},
    Operation{"close", close},     Operation{"elevate", elevate},
};

}  // namespace

Answer answer_operate(Members& request) {
  PathDocument document = request.document();
  std::vector<std::string> names;
  for (const Operation& operation : operations) names.emplace_back(operation.name);
  const std::string name = request.word("operation", names);
  for (const Operation& operation : operations) {
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
