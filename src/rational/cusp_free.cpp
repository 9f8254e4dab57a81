// SPDX-License-Identifier: MIT
// Linear programs at nodes, certificates on intervals, and the search for the smallest space.
#include "hodograph/rational/cusp_free.hpp"

#include <algorithm>
#include <cassert>

#include "hodograph/foundation/interruption.hpp"
#include "least_value.hpp"
#include "linear_program.hpp"

namespace hodograph {

using rational_detail::LinearProgram;

namespace {

using Outcome = CuspFreeAnswer::Outcome;
using Reason = CuspFreeAnswer::Reason;

/// A number in words: exactly where that is short.
std::string spoken(const Rational& x) {
  constexpr std::size_t short_bits = 40;
  return x.bits() <= short_bits ? to_text(x) : "about " + to_text(x.to_double());
}

std::string interval_text(const RationalHermiteData& data) {
  return "[" + to_text(data.begin) + ", " + to_text(data.end) + "]";
}

/// The largest speed that the data speak of: that of the straight chord, and those at the ends.
Rational speed_of(const RationalHermiteData& data) {
  Rational speed = taxicab_length(data.end_point - data.begin_point) / (data.end - data.begin);
  for (const auto* derivative : {&data.begin_derivative, &data.end_derivative}) {
    if (*derivative) speed = std::max(speed, taxicab_length(**derivative));
  }
  return speed.is_zero() ? Rational(1) : speed;
}

/// The degree that h can have.
std::size_t numerator_degree(const HermiteCurves& curves) {
  std::vector<Rational> x(curves.freedom());
  int degree = curves.lambda_numerator(x).degree();
  for (Rational& parameter : x) {
    parameter = 1;
    degree = std::max(degree, curves.lambda_numerator(x).degree());
    parameter = 0;
  }
  return static_cast<std::size_t>(std::max(degree, 0));
}

/// x with the fewest digits that keeps half of the least speed at the nodes and is certified; none
/// where the optimum, to many digits, is not.
std::optional<std::vector<Rational>> simple_and_certified(const HermiteCurves& curves,
                                                          const NodeOptimum& optimum,
                                                          const std::vector<Rational>& nodes) {
  const auto rounded = [&](long bits) {
    std::vector<Rational> x;
    for (const Rational& exact : optimum.parameters) {
      x.push_back(rational_detail::simplest(exact, bits));
    }
    return x;
  };
  constexpr long many_bits = 192;
  std::vector<Rational> nearest = rounded(many_bits);
  if (!curves.is_cusp_free(nearest)) return std::nullopt;
  const Rational enough = Rational(1, 2) * optimum.least_speed;
  for (const long bits : {2L, 3L, 4L, 6L, 8L, 12L, 16L, 24L, 32L, 48L, 64L, 96L}) {
    std::vector<Rational> x = rounded(bits);
    const RationalFunction speed = curves.speed(x);
    const bool fast = std::all_of(nodes.begin(), nodes.end(),
                                  [&](const Rational& t) { return enough <= speed.value(t); });
    if (fast && curves.is_cusp_free(x)) return x;
  }
  return nearest;
}

void say_found(CuspFreeAnswer& answer, const HermiteCurves& curves, std::vector<Rational> x) {
  answer.outcome = Outcome::found;
  answer.curve = curves.curve(x);
  answer.parameters = std::move(x);
  answer.sentence = "a curve without cusps: lambda > 0 on " + interval_text(curves.data()) +
                    ", and alpha has no root there, both by Sturm's sequence";
}

CuspFreeAnswer only_curve(const HermiteCurves& curves) {
  CuspFreeAnswer answer;
  if (curves.is_cusp_free({})) {
    say_found(answer, curves, {});
    answer.sentence = "the only curve of the space that meets the data; " + answer.sentence;
    return answer;
  }
  answer.outcome = Outcome::none;
  answer.reason = Reason::single_curve;
  const RationalPolynomial h = curves.lambda_numerator({});
  if (h.is_zero()) {
    answer.sentence = "the only curve of the space that meets the data is a point";
    return answer;
  }
  for (const RealRoot& root : real_roots(h)) {
    if (root.compare(curves.data().begin) < 0 || root.compare(curves.data().end) > 0) continue;
    answer.cusp = root;
    answer.sentence =
        "the only curve of the space that meets the data stops at t = " +
        (root.is_rational() ? to_text(root.lower()) : "about " + to_text(root.to_double())) +
        ", where lambda = 0";
    return answer;
  }
  answer.sentence =
      "the only curve of the space that meets the data runs against A i A* on all of " +
      interval_text(curves.data());
  return answer;
}

void say_none(CuspFreeAnswer& answer, const NodeOptimum& optimum,
              const std::vector<Rational>& nodes) {
  answer.outcome = Outcome::none;
  answer.reason = Reason::weights;
  std::string places;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (optimum.weights[i].sign() <= 0) continue;
    answer.nodes.push_back(nodes[i]);
    answer.weights.push_back(optimum.weights[i]);
    places += (places.empty() ? "" : ", ") + spoken(nodes[i]);
  }
  answer.sentence =
      "no curve of the space is free of cusps: with positive weights at t = " + places +
      ", the mean of the speeds there is " + spoken(optimum.least_speed) +
      " for every curve that meets the data, so that none is positive at all of them";
}

}  // namespace

NodeOptimum fastest_at_nodes(const HermiteCurves& curves, std::span<const Rational> nodes,
                             const Rational& cap) {
  assert(curves.solvable() && !nodes.empty());
  // minimise Σ w_i σ_0(t_i) + cap w where Σ w_i σ_k(t_i) = 0 and Σ w_i + w = 1: the dual of the
  // largest s with σ_0(t_i) + Σ x_k σ_k(t_i) ≥ s and s ≤ cap. Its multipliers are -x and s.
  const std::size_t rows = curves.freedom() + 1, count = nodes.size();
  LinearProgram program(rows, count + 1);
  std::vector<std::vector<Rational>> directions(curves.freedom());
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<Rational> speeds = curves.speeds(nodes[i]);
    for (std::size_t k = 0; k + 1 < rows; ++k) {
      program.set(k, i, speeds[k + 1]);
      directions[k].push_back(std::move(speeds[k + 1]));
    }
    program.set(rows - 1, i, 1);
    program.cost[i] = std::move(speeds[0]);
  }
  program.set(rows - 1, count, 1);
  program.cost[count] = cap;
  program.right[rows - 1] = 1;
  for (const auto& row : rational_detail::orthonormal(std::move(directions))) {
    program.numeric.insert(program.numeric.end(), row.begin(), row.end());
    program.numeric.push_back(0.0);
  }
  program.numeric.insert(program.numeric.end(), count + 1, 1.0);
  program.numeric.insert(program.numeric.end(), rows - 1, 0.0);
  program.numeric.push_back(1.0);
  program.start.push_back(count);
  for (std::size_t i = 0; i < count; ++i) program.start.push_back(i);

  auto optimum = rational_detail::exact_optimum(program);
  NodeOptimum result;
  result.least_speed = std::move(optimum.value);
  result.capped = optimum.weights[count].sign() > 0;
  optimum.weights.pop_back();
  result.weights = std::move(optimum.weights);
  for (std::size_t k = 0; k + 1 < rows; ++k) result.parameters.push_back(-optimum.multipliers[k]);
  return result;
}

namespace {

/// The cone test of the data: nothing where it does not prove that there is no curve at all.
std::optional<ConeTest> refusing_cone(const VectorPolynomial& indicatrix,
                                      const RationalHermiteData& data, std::size_t most_rounds) {
  ConeTest cone =
      cone_test(indicatrix, data.end_point - data.begin_point, data.begin, data.end, most_rounds);
  if (cone.outcome != ConeTest::Outcome::outside) return std::nullopt;
  return cone;
}

/// The answer for a chord that is not outside the cone.
Result<CuspFreeAnswer> answer_within_cone(const HermiteCurves& curves,
                                          const CuspFreeLimits& limits) {
  CuspFreeAnswer answer;
  if (!curves.solvable()) {
    answer.outcome = Outcome::none;
    answer.reason = Reason::contradiction;
    answer.sentence = "no curve of the space meets the data: the " +
                      std::to_string(curves.equations()) + " conditions and " +
                      std::to_string(curves.unknowns()) +
                      (curves.unknowns() == 1 ? " unknown" : " unknowns") +
                      " have no solution (a combination of the conditions reads 0 = 1)";
    return answer;
  }
  if (curves.freedom() == 0) return only_curve(curves);
  if (curves.freedom() > largest_freedom) {
    return Fault{FaultCode::unsupported,
                 "the curves that meet the data have " + std::to_string(curves.freedom()) +
                     " free parameters; at most " + std::to_string(largest_freedom) +
                     " are offered, with a smaller degree of B",
                 std::nullopt,
                 "freedom",
                 static_cast<double>(curves.freedom()),
                 static_cast<double>(largest_freedom)};
  }
  const RationalHermiteData& data = curves.data();
  const Rational cap = speed_of(data);
  const std::size_t degree = numerator_degree(curves);
  std::vector<Rational> nodes =
      equidistant(data.begin, data.end, std::max(limits.nodes, 2 * degree + 3));
  std::size_t cells = 8 * (degree + 2);
  long bits = 4;
  while (answer.rounds < limits.most_rounds) {
    check_interruption();
    ++answer.rounds;
    const NodeOptimum optimum = fastest_at_nodes(curves, nodes, cap);
    answer.speed_bound = optimum.least_speed;
    if (optimum.least_speed.sign() <= 0) {
      say_none(answer, optimum, nodes);
      return answer;
    }
    if (auto x = simple_and_certified(curves, optimum, nodes)) {
      say_found(answer, curves, std::move(*x));
      return answer;
    }
    const RationalFunction speed = curves.speed(optimum.parameters);
    const std::size_t before = nodes.size();
    for (Rational& t :
         rational_detail::dips([&](const Rational& at) { return speed.value(at); }, data.begin,
                               data.end, cells, bits, optimum.least_speed)) {
      if (std::find(nodes.begin(), nodes.end(), t) == nodes.end()) nodes.push_back(std::move(t));
    }
    if (nodes.size() == before) cells *= 2;
    bits += 2;
  }
  answer.sentence = "not decided after " + std::to_string(answer.rounds) + " linear programs: ";
  if (answer.speed_bound) {
    answer.sentence += "no curve of the space is faster than " + spoken(*answer.speed_bound) +
                       " everywhere on " + interval_text(data) + ", and ";
  }
  answer.sentence += "none was certified";
  return answer;
}

}  // namespace

Result<CuspFreeAnswer> cusp_free_curve(const HermiteCurves& curves, const CuspFreeLimits& limits) {
  auto cone = refusing_cone(curves.space().indicatrix(), curves.data(), limits.most_rounds);
  if (!cone) return answer_within_cone(curves, limits);
  CuspFreeAnswer answer;
  answer.outcome = Outcome::none;
  answer.reason = Reason::cone;
  answer.sentence = cone->sentence;
  answer.cone = std::move(cone);
  return answer;
}

bool holds(const CuspFreeAnswer& answer, const HermiteCurves& curves) {
  const RationalHermiteData& data = curves.data();
  switch (answer.outcome) {
    case Outcome::undecided:
      return false;
    case Outcome::found: {
      const RationalPhCurve& curve = *answer.curve;
      const VectorFunction velocity = curve.position().derivative();
      const auto meets = [&](const Rational& t, const RationalVector& point,
                             const std::optional<RationalVector>& derivative) {
        return curve.position().value(t) == point &&
               (!derivative || velocity.value(t) == *derivative);
      };
      const RationalFunction& lambda = curve.lambda();
      const RationalPolynomial& q = lambda.denominator();
      return count_real_roots(curve.position().denominator(), data.begin, data.end) == 0 &&
             meets(data.begin, data.begin_point, data.begin_derivative) &&
             meets(data.end, data.end_point, data.end_derivative) &&
             is_positive(lambda.numerator() * RationalPolynomial(q.value(data.begin)), data.begin,
                         data.end);
    }
    case Outcome::none:
      break;
  }
  switch (answer.reason) {
    case Reason::not_applicable:
      return false;
    case Reason::contradiction: {
      const auto& y = curves.contradiction();
      if (y.size() != curves.equations()) return false;
      for (std::size_t i = 0; i <= curves.unknowns(); ++i) {
        Rational sum;
        for (std::size_t j = 0; j < y.size(); ++j) sum += y[j] * curves.system()[j][i];
        if (sum != Rational(i == curves.unknowns() ? 1 : 0)) return false;
      }
      return true;
    }
    case Reason::cone:
      return answer.cone && holds(*answer.cone, curves.space().indicatrix(),
                                  data.end_point - data.begin_point, data.begin, data.end);
    case Reason::single_curve:
      return curves.freedom() == 0 && !curves.is_cusp_free({});
    case Reason::weights: {
      if (answer.nodes.empty() || answer.nodes.size() != answer.weights.size()) return false;
      std::vector<Rational> sums(curves.freedom() + 1);
      for (std::size_t i = 0; i < answer.nodes.size(); ++i) {
        const Rational& t = answer.nodes[i];
        if (answer.weights[i].sign() <= 0 || t < data.begin || data.end < t) return false;
        const std::vector<Rational> speeds = curves.speeds(t);
        for (std::size_t k = 0; k < sums.size(); ++k) sums[k] += answer.weights[i] * speeds[k];
      }
      return sums[0].sign() <= 0 &&
             std::all_of(sums.begin() + 1, sums.end(), [](const auto& s) { return s.is_zero(); });
    }
  }
  return false;
}

Result<DegreeSearch> smallest_cusp_free(const QuaternionPolynomial& a,
                                        const RationalHermiteData& data,
                                        const SpaceSearch& search) {
  if (search.least_power > search.most_power) {
    return Fault{FaultCode::outside_domain,
                 "the powers " + std::to_string(search.least_power) + " to " +
                     std::to_string(search.most_power) +
                     " of alpha are none; right would be the smaller one first",
                 std::nullopt,
                 "power",
                 static_cast<double>(search.least_power),
                 static_cast<double>(search.most_power)};
  }
  DegreeSearch result;
  const auto base_degree = static_cast<std::size_t>(std::max(search.base.degree(), 0));
  // What is wrong with the input shows in the smallest space, and the cone is the same for all.
  const auto first = solve(a, search.base.power(search.least_power), 0);
  if (!first) return first.fault();
  const auto points = HermiteCurves::create(*first, data);
  if (!points) return points.fault();
  if (auto cone = refusing_cone(first->indicatrix(), data, search.limits.most_rounds)) {
    result.sentence = cone->sentence;
    result.cone = std::move(cone);
    result.proved_smallest = false;
    return result;
  }
  // One answer for one space; none where it holds points alone.
  const auto look = [&](std::size_t power,
                        std::size_t degree) -> Result<std::optional<SearchedSpace>> {
    const auto space = solve(a, search.base.power(power), degree);
    if (!space) return space.fault();
    const auto curves = HermiteCurves::create(*space, data);
    if (!curves) return curves.fault();
    if (curves->unknowns() == 0) return std::optional<SearchedSpace>();
    auto answer = answer_within_cone(*curves, search.limits);
    if (!answer) return answer.fault();
    return std::optional(SearchedSpace{power, degree, std::move(*answer)});
  };
  const std::size_t most_power = base_degree == 0 ? search.least_power : search.most_power;
  const std::size_t largest = std::max(search.largest_degree, most_power * base_degree);
  for (std::size_t size = 0; size <= largest; ++size) {
    for (std::size_t power = search.least_power; power <= most_power; ++power) {
      check_interruption();
      const std::size_t m = power * base_degree;
      if (m > size) break;
      const std::size_t degree = std::min(size, search.largest_degree);
      if (m < size && degree < size) continue;  // looked at already
      auto space = look(power, degree);
      if (!space) return space.fault();
      if (!*space) continue;
      if ((*space)->answer.outcome == Outcome::found) {
        // Smaller degrees of B give no smaller curve where α has the larger degree, but simpler
        // ones.
        for (std::size_t d = 0; m == size && d < degree; ++d) {
          auto smaller = look(power, d);
          if (!smaller) return smaller.fault();
          if (!*smaller) continue;
          if ((*smaller)->answer.outcome == Outcome::found) {
            *space = std::move(*smaller);
            break;
          }
          result.before.push_back(std::move(**smaller));
        }
        result.found = std::move(**space);
        break;
      }
      result.before.push_back(std::move(**space));
    }
    if (result.found) break;
  }
  for (const SearchedSpace& space : result.before) {
    if (space.answer.outcome != Outcome::none) result.proved_smallest = false;
  }
  const auto alpha_text = [&](std::size_t power) {
    return base_degree == 0 || power == 0
               ? std::string("1")
               : "(" + to_text(search.base) + ")^" + std::to_string(power);
  };
  if (result.found) {
    result.sentence = "deg B <= " + std::to_string(result.found->degree) +
                      " with alpha = " + alpha_text(result.found->power) + ": " +
                      result.found->answer.sentence +
                      (result.proved_smallest ? "; every smaller space of the search holds none"
                                              : "; smaller spaces were not all decided");
  } else {
    result.proved_smallest = false;
    if (result.before.empty()) {
      result.sentence = "every curve with deg B <= " + std::to_string(search.largest_degree) +
                        " and these denominators is a point: a larger degree is needed";
      return result;
    }
    result.sentence =
        "no curve without cusps was found for deg B <= " + std::to_string(search.largest_degree) +
        " and alpha = " + alpha_text(search.least_power) +
        (most_power > search.least_power ? " to " + alpha_text(most_power) : "") + ": of " +
        std::to_string(result.before.size()) + " spaces " +
        std::to_string(
            std::count_if(result.before.begin(), result.before.end(),
                          [](const auto& s) { return s.answer.outcome == Outcome::none; })) +
        " were proved to hold none";
  }
  return result;
}

}  // namespace hodograph
