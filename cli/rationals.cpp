// SPDX-License-Identifier: MIT
#include "cli/rationals.hpp"
#include "cli/rational_input.hpp"

#include <algorithm>
#include <utility>

#include "cli/refuse.hpp"
#include "cli/requests/members.hpp"
#include "hodograph/rational/work_limits.hpp"

namespace hodograph::cli {
namespace {

/// A list of coefficients, "p/q", "0.5" or whole numbers, the constant one first.
RationalPolynomial polynomial_of(const Json& list, Members& members, std::string_view name) {
  std::vector<Rational> coefficients;
  for (const Json& item : list) {
    if (item.is_number_integer()) {
      coefficients.push_back(Rational::parse(item.dump()).value());
    } else if (item.is_number_float() && item.get<double>() == 0.0) {
      coefficients.emplace_back(0);  // "-0"
    } else if (item.is_string()) {
      const auto& text = item.get_ref<const std::string&>();
      if (text.size() > most_text_digits) {
        members.refuse(name, "a coefficient has " + std::to_string(text.size()) +
                                 " characters; at most " + std::to_string(most_text_digits) +
                                 " are offered");
      }
      const auto value = Rational::parse(text);
      if (!value) members.refuse(name, value.fault().sentence);
      coefficients.push_back(*value);
    } else {
      members.refuse(name, "a coefficient should be a whole number, or a string such as \"-3/4\"");
    }
  }
  if (coefficients.size() > largest_text_degree + 1) {
    members.refuse(name, "there are " + std::to_string(coefficients.size()) +
                             " coefficients; at most " + std::to_string(largest_text_degree + 1) +
                             " are offered");
  }
  return RationalPolynomial(coefficients);
}

std::vector<RationalPolynomial> polynomials_of(const Json& list, std::size_t count,
                                               Members& members, std::string_view name) {
  const bool fits =
      list.is_array() && list.size() == count &&
      std::all_of(list.begin(), list.end(), [](const Json& p) { return p.is_array(); });
  if (!fits) {
    members.refuse(name, "should be text, or " + std::to_string(count) + " lists of coefficients");
  }
  std::vector<RationalPolynomial> result;
  for (const Json& p : list) result.push_back(polynomial_of(p, members, name));
  return result;
}

Json json_in(Members& members, std::string_view name) {
  return Json::parse(members.json_text(name));
}

/// The polynomial that is a list of coefficients.
RationalPolynomial scalar_of(const Json& list, Members& members, std::string_view name) {
  if (!list.is_array()) members.refuse(name, "should be text, or a list of coefficients");
  return polynomial_of(list, members, name);
}

/// Numerator and denominator of a JSON object.
template <class Numerator>
auto fraction_of(const Json& value, Members& members, std::string_view name,
                 const Numerator& numerator) {
  const bool fits = value.is_object() && value.size() == 2 && value.contains("numerator") &&
                    value.contains("denominator");
  if (!fits) {
    members.refuse(name, "should be text, or an object with \"numerator\" and \"denominator\"");
  }
  RationalPolynomial denominator = scalar_of(value["denominator"], members, name);
  if (denominator.is_zero()) members.refuse(name, "the denominator is 0");
  return std::pair(numerator(value["numerator"]), std::move(denominator));
}

/// The text of a member, as an expression. Throws Error that names the member.
QuaternionFunction expression_of(const Json& value, Members& members, std::string_view name) {
  auto result = parse_expression(value.get_ref<const std::string&>());
  if (!result) members.refuse(name, result.fault().sentence);
  return *std::move(result);
}
template <class T>
T taken(Result<T> value, Members& members, std::string_view name) {
  if (!value) members.refuse(name, value.fault().sentence);
  return *std::move(value);
}

/// The least degree whose space holds a truly rational curve; of a polynomial one if there is none.
std::size_t least_degree(const QuaternionPolynomial& a, const RationalPolynomial& alpha,
                         const Existence& existence) {
  const std::size_t most = existence.alpha_degree + existence.indicatrix_degree;
  if (!existence.exists) return most + 1;
  std::size_t below = 0, enough = most;  // spaces are nested
  while (below < enough) {
    const std::size_t middle = (below + enough) / 2;
    if (solve(a, alpha, middle).value().rational_dimension() > 0) {
      enough = middle;
    } else {
      below = middle + 1;
    }
  }
  return enough;
}

DescribedCurve described(RationalPhCurve curve, const std::string& name,
                         std::optional<std::size_t> index, double& root_work) {
  std::optional<std::vector<RealRoot>> stationary;
  const RationalPolynomial& zeros = curve.lambda().numerator();
  const double work = hodograph::root_work(zeros);  // root_work is left for all curves together
  if (work <= root_work) {
    root_work -= work;
    stationary = curve.stationary_points();
  }
  std::optional<RationalFunction> planes;
  if (!curve.is_planar()) planes = curve.osculating_planes();
  RationalIntegral length = curve.arc_length();
  std::vector<RealRoot> poles = curve.poles();
  DualQuaternionPolynomial motion = curve.motion();
  RationalPhCurve::Decomposition decomposition = curve.decomposition();
  return {name,
          index,
          std::move(curve),
          std::move(length),
          std::move(poles),
          std::move(stationary),
          std::move(planes),
          std::move(motion),
          std::move(decomposition),
          {}};
}

/// The canonical basis, or the compact one where that is not known.
const std::vector<VectorPolynomial>& elements_of(const RationalAnswer& answer) {
  return answer.basis ? *answer.basis : answer.space.basis();
}
DescribedCurve element_described(const RationalAnswer& answer, std::size_t index,
                                 double& root_work) {
  const SolutionSpace& space = answer.space;
  return described(
      RationalPhCurve::create(space.preimage(), space.alpha(), elements_of(answer)[index]).value(),
      "curve " + std::to_string(index + 1) + " of the " + (answer.basis ? "canonical" : "compact") +
          " basis",
      index, root_work);
}

/// The place of the first coefficient that is not 0, by falling degree, then x, y, z.
std::pair<int, std::size_t> pivot_of(const VectorPolynomial& b) {
  const int d = degree(b);
  for (std::size_t c = 0; c < 3; ++c) {
    if (b[c].degree() == d) return {d, c};
  }
  return {d, 0};
}

/// What multiples of the basis sum up to B = -α r / 2: its coefficients at the pivots.
std::vector<Rational> coordinates_of(const RationalPhCurve& curve, const RationalPolynomial& alpha,
                                     const std::vector<VectorPolynomial>& basis) {
  const RationalPolynomial& q = curve.position().denominator();
  if (!divides(q, alpha)) return {};
  const VectorPolynomial b =
      (RationalPolynomial(Rational(-1, 2)) * (alpha / q)) * curve.position().numerator();
  std::vector<Rational> coordinates;
  VectorPolynomial rest = b;
  for (const VectorPolynomial& element : basis) {
    const auto [d, c] = pivot_of(element);
    coordinates.push_back(b[c].coefficient(static_cast<std::size_t>(d)));
    if (!coordinates.back().is_zero()) {
      rest = rest - RationalPolynomial(coordinates.back()) * element;
    }
  }
  if (degree(rest) >= 0) return {};
  return coordinates;
}

std::vector<TaylorRow> taylor_of(const SolutionSpace& space) {
  std::vector<TaylorRow> rows;
  for (const PolynomialFactor& q : irreducible_factors(space.alpha())) {
    TaylorRow row{q.factor, q.multiplicity, {}};
    for (std::size_t k = 0; k <= q.multiplicity; ++k) {
      const VectorPolynomial f = taylor_coefficient(space.indicatrix(), k);
      row.coefficients.push_back({f.x % q.factor, f.y % q.factor, f.z % q.factor});
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<DegreeRow> rows_of(const SolutionSpace& space, const Existence& existence,
                               const std::optional<std::vector<VectorPolynomial>>& basis) {
  const std::size_t m = existence.alpha_degree, e = existence.indicatrix_degree;
  std::vector<DegreeRow> rows;
  for (std::size_t d = basis ? 0 : space.degree(); d <= space.degree(); ++d) {
    DegreeRow row{d, space.dimension()};
    if (basis) {  // the elements of degree d and less are the canonical basis of V_d
      row.dimension = static_cast<std::size_t>(std::count_if(
          basis->begin(), basis->end(),
          [d](const VectorPolynomial& b) { return degree(b) <= static_cast<int>(d); }));
    }
    row.points = d >= m ? 3 : 0;
    row.polynomials = d > m + e ? d - m - e : 0;
    row.predicted = existence.dimension(d);
    rows.push_back(row);
  }
  return rows;
}

/// Σ c_i r_i over the canonical basis.
RationalPhCurve combination(const RationalAnswer& answer) {
  const auto& c = answer.problem.coefficients;
  if (!answer.basis)
    refuse("coefficients need the canonical basis: " + answer.basis_refused, "coefficients",
           FaultCode::unsupported);
  if (c.size() != answer.basis->size()) {
    refuse("the basis has " + std::to_string(answer.basis->size()) + " elements and there are " +
               std::to_string(c.size()) + " coefficients; give one each",
           "coefficients", FaultCode::mismatched_size);
  }
  VectorPolynomial sum;
  for (std::size_t i = 0; i < c.size(); ++i) {
    sum = sum + RationalPolynomial(c[i]) * (*answer.basis)[i];
  }
  return RationalPhCurve::create(answer.space.preimage(), answer.space.alpha(), sum).value();
}

void require_degree(const std::string& what, int degree, std::size_t most) {
  if (degree <= static_cast<int>(most)) return;
  refuse(what + " has degree " + std::to_string(degree) + "; at most " + std::to_string(most) +
             " is offered",
         "degree", FaultCode::unsupported);
}

}  // namespace

void require_small(const RationalProblem& problem) {
  if (problem.degree) {
    require_degree("B", static_cast<int>(std::min<std::size_t>(*problem.degree, 1'000'000'000)),
                   largest_solution_degree);
  }
  require_degree("A", degree(*problem.a), largest_input_degree);
  if (problem.alpha) require_degree("alpha", problem.alpha->degree(), largest_input_degree);
  const auto fault = input_size_fault(*problem.a, problem.alpha.value_or(RationalPolynomial()));
  if (fault) throw Error(*fault);
}

void define(RationalProblem& problem, std::string_view text) {
  auto definitions = parse_definitions(text);
  if (!definitions) throw Error(definitions.fault());
  const auto twice = [&](bool known, const TextDefinition& d) {
    if (known) {
      const TextPlace place = place_in(text, d.index);
      throw Error(Fault{FaultCode::malformed_document,
                        "line " + std::to_string(place.line) + ": '" + d.name + "' is given twice",
                        d.index, "text", std::nullopt, std::nullopt});
    }
  };
  for (const TextDefinition& d : *definitions) {
    if (d.name == "A") {
      twice(problem.a.has_value(), d);
      problem.a = taken(quaternion_polynomial(d.value, "A"), text, d.index);
    } else if (d.name == "alpha") {
      twice(problem.alpha.has_value(), d);
      problem.alpha = taken(real_polynomial(d.value, "alpha"), text, d.index);
    } else if (d.name == "degree") {
      twice(problem.degree.has_value(), d);
      problem.degree =
          taken(whole_number(d.value, "the degree of B", largest_solution_degree), text, d.index);
    } else if (d.name == "r") {
      twice(problem.curve.has_value(), d);
      problem.curve = taken(vector_function(d.value, "r"), text, d.index);
    } else if (d.name == "f") {
      twice(problem.planes.has_value(), d);
      problem.planes = taken(real_function(d.value, "f"), text, d.index);
    }
  }
}

RationalPolynomial polynomial_member(Members& members, std::string_view name) {
  const Json value = json_in(members, name);
  if (!value.is_string()) return scalar_of(value, members, name);
  return taken(real_polynomial(expression_of(value, members, name), std::string(name)), members,
               name);
}

QuaternionPolynomial quaternion_member(Members& members, std::string_view name) {
  const Json value = json_in(members, name);
  if (value.is_string()) {
    return taken(quaternion_polynomial(expression_of(value, members, name), std::string(name)),
                 members, name);
  }
  auto p = polynomials_of(value, 4, members, name);
  return {p[0], p[1], p[2], p[3]};
}

void define(RationalProblem& problem, Members& members) {
  if (members.has("A")) problem.a = quaternion_member(members, "A");
  if (members.has("alpha")) problem.alpha = polynomial_member(members, "alpha");
  if (members.has("degree")) {
    problem.degree = members.count("degree");
  }
  if (members.has("r")) {
    const Json value = json_in(members, "r");
    if (value.is_string()) {
      problem.curve = taken(vector_function(expression_of(value, members, "r"), "r"), members, "r");
    } else {
      const auto [p, q] = fraction_of(value, members, "r", [&](const Json& list) {
        auto c = polynomials_of(list, 3, members, "r");
        return VectorPolynomial{c[0], c[1], c[2]};
      });
      problem.curve = VectorFunction(p, q);
    }
  }
  if (members.has("f")) {
    const Json value = json_in(members, "f");
    if (value.is_string()) {
      problem.planes = taken(real_function(expression_of(value, members, "f"), "f"), members, "f");
    } else {
      const auto [p, q] = fraction_of(
          value, members, "f", [&](const Json& list) { return scalar_of(list, members, "f"); });
      problem.planes = RationalFunction(p, q);
    }
  }
  if (members.has("coefficients")) {
    const Json value = json_in(members, "coefficients");
    const RationalPolynomial list = scalar_of(value, members, "coefficients");
    for (std::size_t i = 0; i < value.size(); ++i) {
      problem.coefficients.push_back(list.coefficient(i));
    }
  }
  problem.described = members.count("curves", problem.described);
}

DescribedCurve described_curve(RationalPhCurve curve, const std::string& name) {
  double root_work = largest_root_work;
  return described(std::move(curve), name, std::nullopt, root_work);
}

RationalAnswer answer_of(const RationalProblem& problem) {
  if (!problem.a) refuse("A is missing; right would be such as A = t^2 - (i+j)*t + k", "A");
  std::optional<RationalPhCurve> chosen;
  std::string chosen_name = "the curve r";
  if (problem.curve.has_value() + problem.planes.has_value() + !problem.coefficients.empty() > 1) {
    refuse("r, f and coefficients exclude each other; give one of them", "r");
  }
  require_small(problem);
  if (problem.curve) chosen = RationalPhCurve::create(*problem.a, *problem.curve).value();
  if (problem.planes) {
    chosen = RationalPhCurve::from_osculating_planes(*problem.a, *problem.planes).value();
    chosen_name = "the curve of the planes f";
  }
  if (!problem.alpha && !chosen) {
    refuse("alpha is missing; right would be such as alpha = t^3, or a curve r, or planes f",
           "alpha");
  }
  if (chosen) {
    require_degree("the denominator of " + chosen_name, chosen->position().denominator().degree(),
                   largest_input_degree);
  }
  const RationalPolynomial alpha =
      problem.alpha ? *problem.alpha : chosen->position().denominator();
  Existence found = existence(*problem.a, alpha).value();
  std::size_t wanted = problem.degree ? *problem.degree : least_degree(*problem.a, alpha, found);
  if (chosen && !problem.degree && !alpha.is_zero()) {  // far enough for the curve
    const VectorFunction& r = chosen->position();
    const int above = alpha.degree() - r.denominator().degree() + degree(r.numerator());
    if (divides(r.denominator(), alpha) && above <= static_cast<int>(largest_solution_degree)) {
      wanted = std::max(wanted, static_cast<std::size_t>(std::max(0, above)));
    }
  }
  RationalAnswer answer{problem, solve(*problem.a, alpha, wanted).value(), std::move(found)};
  const SolutionSpace& space = answer.space;
  if (space.canonical_basis_work() <= largest_canonical_basis_work) {
    answer.basis = space.canonical_basis();
  } else {
    answer.basis_refused = "the canonical basis has " + std::to_string(space.dimension()) +
                           " elements of degree " + std::to_string(wanted) +
                           " whose numbers become too large; right would be a smaller degree";
  }
  answer.rows = rows_of(space, answer.existence, answer.basis);
  answer.taylor = taylor_of(space);

  double root_work = largest_root_work;
  const std::vector<VectorPolynomial>& elements = elements_of(answer);
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (kind_of(elements[i], alpha) == CurveKind::constant) continue;
    if (answer.curves.size() < problem.described) {
      answer.curves.push_back(element_described(answer, i, root_work));
    } else {
      ++answer.curves_left_out;
    }
  }
  if (!problem.coefficients.empty()) {
    chosen = combination(answer);
    chosen_name = "the combination";
  }
  if (chosen) {
    answer.chosen = described_curve(*std::move(chosen), chosen_name);
    if (answer.basis) {
      answer.chosen->coordinates = coordinates_of(answer.chosen->curve, alpha, *answer.basis);
    }
  }
  const auto any = RationalPhCurve::create(space.preimage(), VectorFunction()).value();
  answer.inflections = any.inflections();
  answer.torsion_zeros = any.torsion_zeros();
  return answer;
}

DescribedCurve shown_curve(const RationalAnswer& answer) {
  if (answer.chosen) return *answer.chosen;
  const std::vector<VectorPolynomial>& elements = elements_of(answer);
  std::optional<std::size_t> shown;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    const CurveKind kind = kind_of(elements[i], answer.space.alpha());
    if (kind == CurveKind::constant || (shown && kind != CurveKind::rational)) continue;
    shown = i;
    if (kind == CurveKind::rational) break;
  }
  if (!shown) {
    refuse(
        "the space holds no curve but points, and nothing can be shown of it; right would be a "
        "larger degree",
        "degree", FaultCode::outside_domain);
  }
  for (const DescribedCurve& c : answer.curves) {
    if (c.index == shown) return c;
  }
  double root_work = largest_root_work;
  return element_described(answer, *shown, root_work);
}

}  // namespace hodograph::cli
