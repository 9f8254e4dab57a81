// SPDX-License-Identifier: MIT
// The cone of tangents: a linear program at nodes, a normal certified by Sturm's sequence.
#include "hodograph/rational/cone_test.hpp"

#include <algorithm>
#include <cassert>
#include <optional>

#include "hodograph/foundation/interruption.hpp"
#include "hodograph/rational/hermite_curves.hpp"
#include "hodograph/rational/real_roots.hpp"
#include "hodograph/rational/text.hpp"
#include "least_value.hpp"
#include "linear_algebra.hpp"
#include "linear_program.hpp"

namespace hodograph {

using rational_detail::LinearProgram;

namespace {

RationalPolynomial along(const RationalVector& n, const VectorPolynomial& f) {
  return RationalPolynomial(n.x) * f.x + RationalPolynomial(n.y) * f.y +
         RationalPolynomial(n.z) * f.z;
}

/// A basis of the span of some vectors, chosen among them: their indices.
std::vector<std::size_t> spanning(const std::vector<RationalVector>& vectors) {
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < vectors.size() && chosen.size() < 3; ++i) {
    std::vector<RationalVector> with;
    for (const std::size_t j : chosen) with.push_back(vectors[j]);
    const RationalVector& v = vectors[i];
    bool adds = v != RationalVector{};
    if (with.size() == 1) adds = cross(with[0], v) != RationalVector{};
    if (with.size() == 2) adds = !dot(cross(with[0], with[1]), v).is_zero();
    if (adds) chosen.push_back(i);
  }
  return chosen;
}

/// The numbers v with Σ v_i vectors[i] = target, the vectors independent; none where it is not in
/// their span.
std::optional<std::vector<Rational>> combination(const std::vector<RationalVector>& vectors,
                                                 const RationalVector& target) {
  std::vector<std::vector<Rational>> system(3);
  for (std::size_t c = 0; c < 3; ++c) {
    for (const RationalVector& v : vectors) system[c].push_back(v[c]);
    system[c].push_back(target[c]);
  }
  auto solution = rational_detail::affine_solution(system, vectors.size());
  if (!solution.contradiction.empty()) return std::nullopt;
  return std::move(solution.particular);
}

/// n with n · v = 0 for every vector of a span of at most two dimensions that does not contain the
/// chord, and n · chord < 0.
RationalVector normal_beside(const std::vector<RationalVector>& span, const RationalVector& chord) {
  if (span.size() == 2) {
    const RationalVector n = cross(span[0], span[1]);
    return dot(n, chord).sign() > 0 ? -n : n;
  }
  // The part of the chord at right angles to the one direction.
  const RationalVector& v = span[0];
  return dot(chord, v) / dot(v, v) * v - chord;
}

/// What the linear program at some nodes says: n with n · F ≥ 0 at the nodes and n · chord ≤ 0; or
/// weights that prove that the chord is inside.
struct NodeAnswer {
  bool inside = false;
  RationalVector normal;
  std::vector<Rational> weights;
};

/// minimise -τ where chord = τ Σ_I F + Σ u_i F_i, u ≥ 0, τ ≤ 1, in coordinates of the span; I is a
/// basis among the nodes, so that Σ_I F is inside the cone, and τ > 0 proves that the chord is.
NodeAnswer at_nodes(const std::vector<RationalVector>& f, const RationalVector& chord,
                    const std::vector<std::size_t>& basis) {
  const std::size_t rank = basis.size(), count = f.size();
  std::vector<RationalVector> axes;
  for (const std::size_t i : basis) axes.push_back(f[i]);
  const std::vector<Rational> v = *combination(axes, chord);
  NodeAnswer answer;
  const std::size_t least =
      static_cast<std::size_t>(std::min_element(v.begin(), v.end()) - v.begin());
  if (v[least].sign() > 0) {
    answer.inside = true;
    answer.weights.resize(count);
    for (std::size_t i = 0; i < rank; ++i) answer.weights[basis[i]] = v[i];
    return answer;
  }
  // Columns: u_i, then τ+, τ-, and what is left of τ below 1.
  LinearProgram program(rank + 1, count + 3);
  program.numeric.assign((rank + 1) * (count + 4), 0.0);
  const auto set = [&](std::size_t i, std::size_t j, const Rational& x) {
    program.set(i, j, x);
    program.numeric[i * (count + 3) + j] = x.to_double();
  };
  for (std::size_t j = 0; j < count; ++j) {
    const std::vector<Rational> coordinates = *combination(axes, f[j]);
    for (std::size_t i = 0; i < rank; ++i) set(i, j, coordinates[i]);
  }
  for (std::size_t i = 0; i < rank; ++i) {
    set(i, count, 1);
    set(i, count + 1, -1);
    program.right[i] = v[i];
  }
  set(rank, count, 1);
  set(rank, count + 1, -1);
  set(rank, count + 2, 1);
  program.right[rank] = 1;
  for (std::size_t i = 0; i <= rank; ++i) {
    program.numeric[(rank + 1) * (count + 3) + i] = program.right[i].to_double();
  }
  program.cost[count] = -1;
  program.cost[count + 1] = 1;
  for (std::size_t i = 0; i < rank; ++i) {
    if (i != least) program.start.push_back(basis[i]);
  }
  program.start.push_back(count + 1);
  program.start.push_back(count + 2);

  const auto optimum = rational_detail::exact_optimum(program);
  const Rational tau = -optimum.value;
  if (tau.sign() > 0) {
    answer.inside = true;
    answer.weights.assign(optimum.weights.begin(),
                          optimum.weights.begin() + static_cast<std::ptrdiff_t>(count));
    for (const std::size_t i : basis) answer.weights[i] += tau;
    return answer;
  }
  // The multipliers y have -y · F ≥ 0 at the nodes and y · chord = -τ - y_cap ≥ 0, in coordinates;
  // n with n · axes[i] = -y_i.
  std::vector<std::vector<Rational>> system;
  for (std::size_t i = 0; i < rank; ++i) {
    system.push_back({axes[i].x, axes[i].y, axes[i].z, -optimum.multipliers[i]});
  }
  const auto n = rational_detail::affine_solution(system, 3).particular;
  answer.normal = {n[0], n[1], n[2]};
  return answer;
}

/// True when n proves that the chord is outside.
bool separates(const RationalVector& n, const VectorPolynomial& f, const RationalVector& chord,
               const Rational& begin, const Rational& end) {
  const int side = dot(n, chord).sign();
  if (side > 0) return false;
  const RationalPolynomial p = along(n, f);
  return (side < 0 || !p.is_zero()) && is_nonnegative(p, begin, end);
}

/// A simple n near the given one that proves it as well, if any is found.
std::optional<RationalVector> simple_separator(const RationalVector& n, const VectorPolynomial& f,
                                               const RationalVector& chord, const Rational& begin,
                                               const Rational& end) {
  Rational largest;
  for (std::size_t c = 0; c < 3; ++c) largest = std::max(largest, n[c].sign() < 0 ? -n[c] : n[c]);
  if (largest.is_zero()) return std::nullopt;
  const RationalVector unit = Rational(1) / largest * n;
  for (const long bits : {2L, 4L, 6L, 8L, 12L, 16L, 24L, 32L}) {
    RationalVector candidate;
    for (std::size_t c = 0; c < 3; ++c) candidate[c] = rational_detail::rounded(unit[c], bits);
    if (separates(candidate, f, chord, begin, end)) return candidate;
    for (std::size_t c = 0; c < 3; ++c) candidate[c] = rational_detail::simplest(unit[c], bits);
    if (separates(candidate, f, chord, begin, end)) return candidate;
  }
  return separates(n, f, chord, begin, end) ? std::optional(n) : std::nullopt;
}

/// A proof for a chord that is itself a direction F(t) of the curve, t rational: the plane that
/// touches the cone there, if it does not enter it.
std::optional<RationalVector> touching_plane(const VectorPolynomial& f, const RationalVector& chord,
                                             const Rational& begin, const Rational& end) {
  const RationalPolynomial parallel =
      content(cross(f, VectorPolynomial{chord.x, chord.y, chord.z}));
  if (parallel.is_constant()) return std::nullopt;
  for (const RealRoot& root : real_roots(parallel)) {
    if (!root.is_rational() || root.lower() < begin || end < root.lower()) continue;
    const RationalVector n = cross(value(f, root.lower()), value(derivative(f), root.lower()));
    for (const RationalVector& candidate : {n, -n}) {
      if (separates(candidate, f, chord, begin, end)) return candidate;
    }
  }
  return std::nullopt;
}

void say_outside(ConeTest& answer, const VectorPolynomial& f, const RationalVector& chord,
                 const Rational& begin, const Rational& end, const RationalVector& n) {
  answer.outcome = ConeTest::Outcome::outside;
  answer.normal = n;
  answer.sentence =
      "the chord " + to_text(chord) + " is outside the cone of the tangents: n = " + to_text(n) +
      (along(n, f).is_zero() ? " has n . F = 0" : " has n . F >= 0") + " on [" + to_text(begin) +
      ", " + to_text(end) + "], and n . chord = " + to_text(dot(n, chord)) +
      (along(n, f).is_zero() ? " is not 0" : " is not positive") +
      "; no curve with these tangents is free of cusps, whatever alpha and the degree";
}

}  // namespace

ConeTest cone_test(const VectorPolynomial& indicatrix, const RationalVector& chord,
                   const Rational& begin, const Rational& end, std::size_t most_rounds) {
  ConeTest answer;
  const VectorPolynomial& f = indicatrix;
  // More nodes than the degree of n · F, so that they span what F spans.
  const auto count = static_cast<std::size_t>(std::max(degree(f), 0)) + 9;
  std::vector<Rational> nodes = equidistant(begin, end, count);
  std::vector<RationalVector> values;
  for (const Rational& t : nodes) values.push_back(value(f, t));
  std::vector<std::size_t> basis = spanning(values);
  std::vector<RationalVector> axes;
  for (const std::size_t i : basis) axes.push_back(values[i]);
  if (!combination(axes, chord)) {
    say_outside(answer, f, chord, begin, end, normal_beside(axes, chord));
    return answer;
  }
  if (most_rounds > 0) {
    if (const auto n = touching_plane(f, chord, begin, end)) {
      say_outside(answer, f, chord, begin, end, *n);
      return answer;
    }
  }
  long bits = 8;
  while (answer.rounds < most_rounds) {
    check_interruption();
    ++answer.rounds;
    const NodeAnswer found = at_nodes(values, chord, basis);
    if (found.inside) {
      answer.outcome = ConeTest::Outcome::inside;
      for (std::size_t i = 0; i < nodes.size(); ++i) {
        if (found.weights[i].sign() <= 0) continue;
        answer.nodes.push_back(nodes[i]);
        answer.weights.push_back(found.weights[i]);
      }
      answer.sentence = "the chord " + to_text(chord) +
                        " is inside the cone of the tangents: a sum of F at " +
                        std::to_string(answer.nodes.size()) + " parameters with positive weights";
      return answer;
    }
    if (const auto n = simple_separator(found.normal, f, chord, begin, end)) {
      say_outside(answer, f, chord, begin, end, *n);
      return answer;
    }
    // Where n · F dips below 0 between the nodes, there are nodes of the next round.
    const RationalPolynomial p = along(found.normal, f);
    for (Rational& t : rational_detail::dips([&](const Rational& at) { return p.value(at); }, begin,
                                             end, 4 * count, bits, Rational())) {
      if (std::find(nodes.begin(), nodes.end(), t) != nodes.end()) continue;
      values.push_back(value(f, t));
      nodes.push_back(std::move(t));
    }
    bits += 4;
  }
  answer.sentence = "the chord " + to_text(chord) +
                    " is too near to the boundary of the cone of the tangents: not decided after " +
                    std::to_string(answer.rounds) + " linear programs";
  return answer;
}

bool holds(const ConeTest& answer, const VectorPolynomial& indicatrix, const RationalVector& chord,
           const Rational& begin, const Rational& end) {
  if (answer.outcome == ConeTest::Outcome::outside) {
    return separates(answer.normal, indicatrix, chord, begin, end);
  }
  if (answer.outcome == ConeTest::Outcome::undecided) return false;
  if (answer.weights.size() != answer.nodes.size()) return false;
  RationalVector sum;
  std::vector<RationalVector> values;
  for (std::size_t i = 0; i < answer.nodes.size(); ++i) {
    const Rational& t = answer.nodes[i];
    if (answer.weights[i].sign() <= 0 || t < begin || end < t) return false;
    values.push_back(value(indicatrix, t));
    sum += answer.weights[i] * values.back();
  }
  std::vector<RationalVector> all;
  for (int k = 0; k <= degree(indicatrix); ++k) {
    const auto i = static_cast<std::size_t>(k);
    all.push_back(
        {indicatrix.x.coefficient(i), indicatrix.y.coefficient(i), indicatrix.z.coefficient(i)});
  }
  return sum == chord && spanning(values).size() == spanning(all).size();
}

}  // namespace hodograph
