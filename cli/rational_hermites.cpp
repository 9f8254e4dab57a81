// SPDX-License-Identifier: MIT
#include "cli/rational_hermites.hpp"
#include "cli/rational_input.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <tuple>
#include <utility>

#include "cli/refuse.hpp"
#include "cli/requests/members.hpp"
#include "hodograph/rational/motion_polynomial.hpp"

namespace hodograph::cli {
namespace {

/// What a text may define: the name and where it goes.
struct Slot {
  const char* name;
  std::optional<RationalVector> RationalHermiteProblem::*vector;
};
constexpr std::array<Slot, 6> vector_slots = {{
    {"P0", &RationalHermiteProblem::begin_point},
    {"P1", &RationalHermiteProblem::end_point},
    {"T0", &RationalHermiteProblem::begin_direction},
    {"T1", &RationalHermiteProblem::end_direction},
    {"v0", &RationalHermiteProblem::begin_derivative},
    {"v1", &RationalHermiteProblem::end_derivative},
}};

/// The point (x, y, z) that a value is.
Result<RationalVector> point_of(const QuaternionFunction& value, const std::string& name) {
  const auto function = vector_function(value, name);
  if (!function) return function.fault();
  if (!function->is_constant()) {
    return Fault{FaultCode::malformed_document,
                 name + " depends on t; right would be numbers, such as (1, 2/3, 0)"};
  }
  const VectorPolynomial& p = function->numerator();
  return RationalVector{p.x.coefficient(0), p.y.coefficient(0), p.z.coefficient(0)};
}
Result<Rational> number_of(const QuaternionFunction& value, const std::string& name) {
  const auto p = real_polynomial(value, name);
  if (!p) return p.fault();
  if (!p->is_constant()) {
    return Fault{FaultCode::malformed_document,
                 name + " depends on t; right would be a number, such as 3/2"};
  }
  return p->coefficient(0);
}

/// A number of a request: any JSON number, which is taken for exactly the double or the whole
/// number it is, or text.
Rational exact_number(const Json& value, Members& members, std::string_view name) {
  if (value.is_number_integer()) return Rational::parse(value.dump()).value();
  if (value.is_number_float()) return Rational::exactly(value.get<double>()).value();
  if (value.is_string()) {
    const auto& text = value.get_ref<const std::string&>();
    if (text.size() <= most_text_digits) {
      if (auto number = Rational::parse(text)) return *number;
    }
  }
  members.refuse(name, "should be a number, or a string such as \"-3/4\"");
}
Rational number_member(Members& members, std::string_view name) {
  return exact_number(Json::parse(members.json_text(name)), members, name);
}
RationalVector point_member(Members& members, std::string_view name) {
  const Json value = Json::parse(members.json_text(name));
  if (!value.is_array() || value.size() != 3) {
    members.refuse(name, "should be a list of three numbers");
  }
  return {exact_number(value[0], members, name), exact_number(value[1], members, name),
          exact_number(value[2], members, name)};
}

bool same_direction(const RationalVector& a, const RationalVector& b) {
  return cross(a, b) == RationalVector{} && dot(a, b).sign() > 0;
}

/// Refuses numbers for which an answer would take hours.
void require_small_input(const RationalHermiteProblem& problem) {
  constexpr std::size_t most_bits = 4096;  // 1200 digits
  RationalVector interval{problem.begin, problem.end, {}};
  const auto require = [&](const std::optional<RationalVector>& v, const char* name) {
    if (!v) return;
    for (std::size_t c = 0; c < 3; ++c) {
      if ((*v)[c].bits() <= most_bits) continue;
      refuse(std::string(name) + " has a number of " + std::to_string((*v)[c].bits()) +
                 " bits; at most " + std::to_string(most_bits) + " are offered",
             name, FaultCode::unsupported);
    }
  };
  for (const Slot& slot : vector_slots) require(problem.*slot.vector, slot.name);
  require(interval, "begin or end");
  RationalProblem spaces;
  spaces.a = problem.a.value_or(QuaternionPolynomial{1, {}, {}, {}});
  spaces.alpha = problem.alpha;
  if (problem.base) {
    const auto most = static_cast<int>(largest_input_degree);
    if (problem.base->degree() * static_cast<int>(problem.most_power) > most) {
      refuse("alpha = base^" + std::to_string(problem.most_power) + " has degree " +
                 std::to_string(problem.base->degree() * static_cast<int>(problem.most_power)) +
                 "; at most " + std::to_string(most) + " is offered",
             "most_power", FaultCode::unsupported);
    }
    spaces.alpha = problem.base->power(problem.most_power);
  }
  spaces.degree = problem.degree ? problem.degree : problem.largest_degree;
  require_small(spaces);
}

/// A, given or chosen, and the directions and derivatives that are met.
void take_preimage(RationalHermiteAnswer& answer) {
  const RationalHermiteProblem& problem = answer.problem;
  const bool c1 = problem.begin_derivative || problem.end_derivative;
  if (c1 && (problem.begin_direction || problem.end_direction)) {
    refuse("T0, T1 (directions) and v0, v1 (derivatives) exclude each other", "T0");
  }
  const auto& first = c1 ? problem.begin_derivative : problem.begin_direction;
  const auto& last = c1 ? problem.end_derivative : problem.end_direction;
  if (problem.a) {
    if (auto reduced = reduction(*problem.a); !reduced) throw Error(reduced.fault());
    answer.a = *problem.a;
    answer.data.begin_derivative = problem.begin_derivative;
    answer.data.end_derivative = problem.end_derivative;
    if (c1) return;  // derivatives are compared with A in any case
    const VectorPolynomial f = indicatrix(reduction(answer.a)->reduced);
    for (const auto& [t, given, name] :
         {std::tuple(answer.data.begin, first, "T0"), std::tuple(answer.data.end, last, "T1")}) {
      if (!given || same_direction(*given, value(f, t))) continue;
      refuse(std::string(name) + " = " + to_text(*given) + " is not the direction " +
                 to_text(value(f, t)) + " that A has there",
             name, FaultCode::outside_domain);
    }
    return;
  }
  if (!first || !last) {
    refuse("without A both tangents are needed: T0 and T1, or v0 and v1", c1 ? "v0" : "T0");
  }
  answer.begin_direction = rational_direction(*first, problem.direction_bits).value();
  answer.end_direction = rational_direction(*last, problem.direction_bits).value();
  HermiteEnds ends{answer.data.end_point - answer.data.begin_point,
                   answer.begin_direction->unit,
                   answer.end_direction->unit,
                   std::nullopt,
                   std::nullopt,
                   answer.data.begin,
                   answer.data.end};
  if (c1) {
    ends.begin_speed = answer.begin_direction->length;
    ends.end_speed = answer.end_direction->length;
    answer.data.begin_derivative = *ends.begin_speed * ends.begin_direction;
    answer.data.end_derivative = *ends.end_speed * ends.end_direction;
  }
  answer.a = chosen_preimage(ends).value().preimage;
  answer.a_chosen = true;
}

/// The curves of one space.
HermiteCurves curves_of(const RationalHermiteAnswer& answer, const RationalPolynomial& alpha,
                        std::size_t degree) {
  return HermiteCurves::create(solve(answer.a, alpha, degree).value(), answer.data).value();
}

}  // namespace

void define(RationalHermiteProblem& problem, std::string_view text) {
  auto definitions = parse_definitions(text);
  if (!definitions) throw Error(definitions.fault());
  for (const TextDefinition& d : *definitions) {
    for (const Slot& slot : vector_slots) {
      if (d.name == slot.name)
        problem.*slot.vector = taken(point_of(d.value, d.name), text, d.index);
    }
    if (d.name == "begin") problem.begin = taken(number_of(d.value, d.name), text, d.index);
    if (d.name == "end") problem.end = taken(number_of(d.value, d.name), text, d.index);
    if (d.name == "A") problem.a = taken(quaternion_polynomial(d.value, d.name), text, d.index);
    if (d.name == "alpha") problem.alpha = taken(real_polynomial(d.value, d.name), text, d.index);
    if (d.name == "base") problem.base = taken(real_polynomial(d.value, d.name), text, d.index);
    if (d.name == "degree") {
      problem.degree =
          taken(whole_number(d.value, "the degree of B", largest_solution_degree), text, d.index);
    }
  }
}

void define(RationalHermiteProblem& problem, Members& members) {
  for (const Slot& slot : vector_slots) {
    if (members.has(slot.name)) problem.*slot.vector = point_member(members, slot.name);
  }
  if (members.has("begin")) problem.begin = number_member(members, "begin");
  if (members.has("end")) problem.end = number_member(members, "end");
  if (members.has("A")) problem.a = quaternion_member(members, "A");
  if (members.has("alpha")) problem.alpha = polynomial_member(members, "alpha");
  if (members.has("base")) problem.base = polynomial_member(members, "base");
  if (members.has("degree")) problem.degree = members.count("degree");
  if (members.has("largest_degree")) problem.largest_degree = members.count("largest_degree");
  problem.least_power = members.count("least_power", problem.least_power);
  problem.most_power =
      members.count("most_power", std::max(problem.least_power, problem.most_power));
  const auto bits = static_cast<std::size_t>(problem.direction_bits);
  problem.direction_bits = static_cast<long>(members.count("direction_bits", bits));
  problem.limits.most_rounds = members.count("rounds", problem.limits.most_rounds);
}

RationalHermiteAnswer answer_of(const RationalHermiteProblem& problem) {
  if (!problem.end_point) refuse("P1 is missing; right would be such as P1 = (2, 9/4, 2)", "P1");
  if (problem.alpha && problem.base) refuse("alpha and base exclude each other", "alpha");
  if (problem.degree && problem.base) {
    refuse("degree names one space and base many; largest_degree bounds the search", "degree");
  }
  if (problem.base && problem.base->is_zero()) refuse("the base of the denominator is 0", "base");
  if (problem.least_power > problem.most_power) {
    refuse("least_power is " + std::to_string(problem.least_power) + ", more than most_power, " +
               std::to_string(problem.most_power),
           "least_power");
  }
  constexpr std::size_t most_powers = 64;
  if (problem.most_power > most_powers || problem.least_power > most_powers) {
    refuse("alpha = base^k is offered for k up to " + std::to_string(most_powers), "most_power",
           FaultCode::unsupported);
  }
  require_small_input(problem);
  RationalHermiteAnswer answer{problem, {}, {}};
  answer.data = {problem.begin_point.value_or(RationalVector{}),
                 *problem.end_point,
                 {},
                 {},
                 problem.begin,
                 problem.end};
  take_preimage(answer);
  // Bad input shows here, whatever follows.
  const RationalPolynomial alpha = problem.alpha.value_or(RationalPolynomial(1));
  const HermiteCurves points = curves_of(answer, alpha, 0);
  answer.cone =
      cone_test(points.space().indicatrix(), answer.data.end_point - answer.data.begin_point,
                answer.data.begin, answer.data.end, problem.limits.most_rounds);
  if (problem.degree && !problem.base) {
    answer.alpha = alpha;
    answer.degree = problem.degree;
    answer.curves = curves_of(answer, alpha, *problem.degree);
    answer.answer = cusp_free_curve(*answer.curves, problem.limits).value();
    answer.sentence = answer.answer->sentence;
  } else {
    SpaceSearch search{problem.base.value_or(alpha), problem.least_power, problem.most_power, 0,
                       problem.limits};
    if (!problem.base) search.least_power = search.most_power = 1;
    const auto poles = static_cast<std::size_t>(std::max(0, search.base.degree()));
    search.largest_degree =
        problem.largest_degree.value_or(usual_largest_degree + poles * search.most_power);
    answer.search = smallest_cusp_free(answer.a, answer.data, search).value();
    answer.sentence = answer.search->sentence;
    if (answer.search->found) {
      answer.alpha = search.base.power(answer.search->found->power);
      answer.degree = answer.search->found->degree;
      answer.curves = curves_of(answer, answer.alpha, *answer.degree);
      answer.answer = answer.search->found->answer;
    }
  }
  if (answer.answer && answer.answer->curve) {
    answer.curve = described_curve(*answer.answer->curve, "the curve");
  }
  return answer;
}

}  // namespace hodograph::cli
