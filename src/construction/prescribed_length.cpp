// SPDX-License-Identifier: MIT
// Planar G¹ Hermite interpolation with a prescribed length: checks, canonical position, choice and
// faults around the kernel.
#include "hodograph/construction/prescribed_length.hpp"

#include <algorithm>
#include <cmath>

#include "end_point_faults.hpp"
#include "hodograph/construction/detail/length_choice.hpp"
#include "hodograph/construction/detail/planar_solution.hpp"
#include "hodograph/construction/detail/prescribed_length_kernel.hpp"

namespace hodograph {
namespace planar_detail {
namespace {

/// A problem in canonical position: exp(i φ/2) at the ends, S + X and S - X, and what turns and
/// scales its preimage back.
struct Canonical {
  Complex<double> s, e;
  double sum, excess, scale;
  Complex<double> turn;
  bool straight;
};

/// The vector times a power of two, its largest component in [1/2, 1).
Vector2<double> unit_sized(const Vector2<double>& v) {
  const double size = largest_component(v);
  constexpr double ordinary = 0x1.0p+160;
  if (size < ordinary && 1.0 < size * ordinary) return v;
  int exponent = 0;
  std::frexp(size, &exponent);
  return {std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
}

std::optional<Fault> input_fault(const DirectedPoint& begin, const DirectedPoint& end,
                                 double length, double h) {
  if (auto fault = directed_points_fault(begin, end)) return fault;
  const bool bad_length = !(std::isfinite(length) && length > 0.0);
  if (bad_length || !(std::isfinite(h) && h > 0.0)) {
    const double value = bad_length ? length : h;
    return Fault{std::isfinite(value) ? FaultCode::outside_domain : FaultCode::not_finite,
                 std::string("the ") + (bad_length ? "arc length" : "parameter step") +
                     " must be positive and finite; got " + to_text(value),
                 std::nullopt,
                 bad_length ? "length" : "parameter_step",
                 value,
                 0.0};
  }
  return std::nullopt;
}

Fault too_short(double length, double chord) {
  return {FaultCode::no_interpolant,
          "no path of length " + to_text(length) + " joins points that are " + to_text(chord) +
              " apart; it needs at least that length",
          std::nullopt,
          "length",
          length,
          chord};
}

Fault off_the_chord(double length, double angle, double most) {
  return {FaultCode::no_interpolant,
          "a path of length " + to_text(length) +
              ", the distance of its points, is a straight line; a direction is off that line by " +
              to_text(angle) + " rad. Give it more length",
          std::nullopt,
          "direction",
          angle,
          most};
}

/// Whether a problem needs none of the care that `prepare` takes: numbers of ordinary size and a
/// length above the chord's by more than rounding. NaN and infinity do.
bool is_ordinary(const DirectedPoint& begin, const DirectedPoint& end, double length, double h) {
  constexpr double most = 0x1.0p+160, least = 1.0 / most;
  const Vector2<double> chord = end.position - begin.position;
  const double first = largest_component(begin.direction);
  const double last = largest_component(end.direction);
  const double reach = largest_component(chord);
  const double sum = first + last + reach + length + std::abs(chord.x) + std::abs(chord.y) +
                     std::abs(begin.direction.y) + std::abs(end.direction.y);
  if (!(sum < most && least < first && least < last && least < length && 0.0 < h &&
        h <= std::numeric_limits<double>::max())) {
    return false;
  }
  const double well_above = 1.0 + 2.0 * accuracy::join_error<double>();
  return reach > least ? well_above * well_above * dot(chord, chord) < length * length
                       : reach == 0.0;
}

/// The row of the kernels.
std::array<double, length_numbers_in> row_of(const DirectedPoint& begin, const DirectedPoint& end,
                                             double length) {
  return {begin.direction.x,
          begin.direction.y,
          end.direction.x,
          end.direction.y,
          end.position.x - begin.position.x,
          end.position.y - begin.position.y,
          length};
}

/// Fills `data`; the fault if there is one.
std::optional<Fault> prepare(const DirectedPoint& begin, const DirectedPoint& end, double length,
                             double h, Canonical& data) {
  const Vector2<double> displacement = end.position - begin.position;
  const double first = largest_component(begin.direction);
  const double last = largest_component(end.direction);
  const double reach = largest_component(displacement), size = std::max(reach, length);
  // One test for the ordinary case; NaN fails it. (∞ - ∞ among components gives NaN in the sum.)
  const double all = (begin.direction.x * 0.0 + begin.direction.y * 0.0) +
                     (end.direction.x * 0.0 + end.direction.y * 0.0) +
                     (displacement.x * 0.0 + displacement.y * 0.0) + length * 0.0 + h * 0.0;
  if (!(all == 0.0 && 0.0 < first && 0.0 < last && 0.0 < length && 0.0 < h)) {
    if (auto fault = input_fault(begin, end, length, h)) return fault;
    return planar_range_fault(0);
  }
  data.scale = prescale(size);
  const double square = data.scale * data.scale;
  const Vector2<double> chord{square * displacement.x, square * displacement.y};
  const double scaled_length = square * length;
  const auto number = [](const Vector2<double>& v) { return Complex<double>{v.x, v.y}; };
  const auto ends = canonical_ends(number(unit_sized(begin.direction)),
                                   number(unit_sized(end.direction)), number(chord));
  const double x = ends.chord;
  data.s = ends.s;
  data.e = ends.e;
  data.turn = ends.turn;
  data.excess = excess_of(scaled_length, number(chord), x);
  data.sum = scaled_length + x;
  data.straight = false;
  const double rounding = accuracy::join_error<double>() * x;
  if (data.excess <= rounding) {
    if (data.excess < -rounding) return too_short(length, x / square);
    // A curve with small angles φ and no loop is longer than its chord by about q/10, q as in the
    // header: (φs² ... )/10 for cubics; from q/2 on it has a loop (B < 0).
    const double q =
        3.0 * (data.s.im * data.s.im + data.e.im * data.e.im) - 2.0 * (data.s.im * data.e.im);
    const bool ahead = data.s.re > 0.5 && data.e.re > 0.5;
    const double natural = 0.1 * q * x;
    if (data.excess <= 0.0 || (data.excess <= rounding && data.excess > 0.5 * q * x)) {
      if (!ahead || natural > rounding) {
        const auto angle = [](const Complex<double>& half) {
          return 2.0 * std::abs(std::atan2(half.im, half.re));
        };
        return off_the_chord(length, std::max(angle(data.s), angle(data.e)),
                             std::sqrt(10.0 * accuracy::join_error<double>()));
      }
      data.excess = natural;
      data.straight = natural < std::numeric_limits<double>::min();
    }
  }
  return std::nullopt;
}

/// The roots with their w2; those of a straight line are one and the same.
struct Roots {
  std::array<Preimage, 4> preimages;
  std::array<double, 4> turns;
  double unavoidable;
};

/// The turns by lanes, with the bits of PlainPairTurns; two lanes left over take the turn from
/// -|φs|/2 over 0 to |φe|/2, half of the unavoidable rotation.
struct LanePairTurns {
  const Canonical& data;
  double& unavoidable;

  void operator()(LengthRoots<double>& found) const {
    const Complex<double> one{1.0, 0.0}, down{data.s.re, -std::abs(data.s.im)},
        up{data.e.re, std::abs(data.e.im)};
    const Complex<double>* preimages[4][3] = {{&found.w0, &found.w1[0], &found.w2},
                                              {&found.w0, &found.w1[1], &found.w2},
                                              {&down, &one, &up},
                                              {&down, &one, &up}};
    double in[24], turns[4];
    for (std::size_t k = 0; k < 4; ++k) {
      for (std::size_t c = 0; c < 3; ++c) {
        in[8 * c + k] = preimages[k][c]->re;
        in[8 * c + 4 + k] = preimages[k][c]->im;
      }
    }
    four_turns(in, turns);
    found.turn = {turns[0], turns[1]};
    unavoidable = turns[2];
  }
};

void solve_pair(const Canonical& data, const Complex<double>& e, std::size_t at, Roots& roots) {
  const LengthRoots<double> found =
      solve_length(data.s, e, data.sum, data.excess, LanePairTurns{data, roots.unavoidable});
  for (std::size_t k = 0; k < 2; ++k) {
    roots.preimages[at + k] = {found.w0, found.w1[k], found.w2};
    roots.turns[at + k] = found.turn[k];
  }
}

/// The two of an ordinary problem, and the turn of `data` (its scale is 1).
void solve_ordinary(const DirectedPoint& begin, const DirectedPoint& end, double length,
                    Canonical& data, Roots& roots) {
  const auto in = row_of(begin, end, length);
  double out[one_length_numbers_out];
  solve_prescribed_length(in.data(), out);
  const auto number = [&](std::size_t i) { return Complex<double>{out[2 * i], out[2 * i + 1]}; };
  roots.preimages[0] = {number(0), number(1), number(3)};
  roots.preimages[1] = {number(0), number(2), number(3)};
  data.scale = 1.0;
  data.turn = number(4);
  roots.turns[0] = out[10];
  roots.turns[1] = out[11];
  roots.unavoidable = out[12];
}

template <std::size_t count>
Ranking<count> rank(const Roots& roots) {
  std::array<Preimage, count> preimages;
  std::array<double, count> turns;
  for (std::size_t k = 0; k < count; ++k) {
    preimages[k] = roots.preimages[k];
    turns[k] = roots.turns[k];
  }
  return ranked(preimages, turns);
}

/// The preimage over the step h in the data's own position and scale.
Preimage placed(const Canonical& data, const Preimage& w, double root_of_step) {
  const double factor = 1.0 / (data.scale * root_of_step);
  const Complex<double> turn = data.turn;
  return {factor * (turn * w[0]), factor * (turn * w[1]), factor * (turn * w[2])};
}

Preimage straight_line(const Canonical& data) {
  const double w = std::sqrt(0.5 * data.sum);
  return {Complex<double>{w, 0.0}, Complex<double>{w, 0.0}, Complex<double>{w, 0.0}};
}

PlanarPhCurve<2> curve_of(const DirectedPoint& begin, const Preimage& w, double h) {
  return {begin.position, BernsteinPolynomial<Complex<double>, 2>(w), h};
}

bool is_usable(const PlanarPhCurve<2>& curve) {
  return is_finite(curve.end()) && is_finite(curve.arc_length()) && curve.arc_length() > 0.0;
}

}  // namespace
}  // namespace planar_detail

namespace planar_detail {

std::optional<Fault> choose_length(const DirectedPoint& begin, const DirectedPoint& end,
                                   double length, double h, LengthSolutions among,
                                   LengthChoice& choice) {
  Canonical data;
  Roots roots;
  const double root = std::sqrt(h);
  std::size_t count = 2;
  if (among == LengthSolutions::published && is_ordinary(begin, end, length, h)) {
    solve_ordinary(begin, end, length, data, roots);
  } else {
    if (auto fault = prepare(begin, end, length, h, data)) return fault;
    if (data.straight) {
      choice.preimage = placed(data, straight_line(data), root);
      choice.margin = std::numeric_limits<double>::infinity();
      return std::nullopt;
    }
    solve_pair(data, data.e, 0, roots);
    if (among == LengthSolutions::all) {
      solve_pair(data, -data.e, 2, roots);
      count = 4;
    }
  }
  std::size_t best = 0;
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t k = 1; k < count; ++k) {
    const bool better = roots.turns[k] < roots.turns[best];
    next = std::min(next, better ? roots.turns[best] : roots.turns[k]);
    if (better) best = k;
  }
  if (!(next - roots.turns[best] > 0.5 * accuracy_of_rotation_index)) {
    const std::size_t least = best;
    if (count == 2) {
      const auto ranking = rank<2>(roots);
      best = ranking.order[0];
      choice.tie = ranking.tie;
    } else {
      const auto ranking = rank<4>(roots);
      best = ranking.order[0];
      choice.tie = ranking.tie;
    }
    if (best != least) next = roots.turns[least];
  }
  choice.preimage = placed(data, roots.preimages[best], root);
  const double turn = roots.turns[best];
  choice.rotation_index = 2.0 * turn;
  choice.margin = std::max(0.0, 2.0 * (next - turn));
  choice.unavoidable_rotation = 2.0 * roots.unavoidable;
  constexpr double half_turn = path_detail::pi;
  choice.loop_free = 2.0 * (turn - roots.unavoidable) < half_turn;
  return std::nullopt;
}

}  // namespace planar_detail

Vector2<double> direction_of_angle(double theta) { return {std::cos(theta), std::sin(theta)}; }

Result<PrescribedLength> prescribed_length_curve(const DirectedPoint& begin,
                                                 const DirectedPoint& end, double length, double h,
                                                 LengthSolutions among) {
  using namespace planar_detail;
  LengthChoice choice;
  if (auto fault = choose_length(begin, end, length, h, among, choice)) return *std::move(fault);
  PrescribedLength result;
  result.curve = curve_of(begin, choice.preimage, h);
  if (!is_usable(result.curve)) return planar_range_fault(0);
  result.rotation_index = choice.rotation_index;
  result.margin = choice.margin;
  result.tie = choice.tie;
  result.unavoidable_rotation = choice.unavoidable_rotation;
  result.loop_free = choice.loop_free;
  return result;
}

Result<std::vector<PlanarSolution>> prescribed_length_solutions(const DirectedPoint& begin,
                                                                const DirectedPoint& end,
                                                                double length, double h,
                                                                LengthSolutions among) {
  using namespace planar_detail;
  Canonical data;
  if (auto fault = prepare(begin, end, length, h, data)) return *std::move(fault);
  const double root = std::sqrt(h);
  std::vector<PlanarSolution> result;
  const auto add = [&](const Preimage& w, double turn) {
    result.push_back({curve_of(begin, placed(data, w, root), h), 2.0 * turn});
    return is_usable(result.back().curve);
  };
  if (data.straight) {
    if (!add(straight_line(data), 0.0)) return planar_range_fault(0);
    return result;
  }
  Roots roots;
  solve_pair(data, data.e, 0, roots);
  std::array<std::size_t, 4> order{};
  std::size_t count = 2;
  if (among == LengthSolutions::all) {
    solve_pair(data, -data.e, 2, roots);
    count = 4;
    order = rank<4>(roots).order;
  } else {
    const auto ranking = rank<2>(roots);
    order[0] = ranking.order[0];
    order[1] = ranking.order[1];
  }
  for (std::size_t k = 0; k < count; ++k) {
    if (!add(roots.preimages[order[k]], roots.turns[order[k]])) return planar_range_fault(0);
  }
  return result;
}

std::optional<Fault> prescribed_length_curves(std::span<const PrescribedLengthProblem> problems,
                                              std::span<PlanarHermiteAnswer> answers) {
  using namespace planar_detail;
  constexpr std::size_t longest = 64;
  double in[longest * length_numbers_in], out[longest * length_numbers_out];
  std::size_t waiting[longest], count = 0;
  const auto answer_alone = [&](std::size_t i) -> std::optional<Fault> {
    const PrescribedLengthProblem& p = problems[i];
    auto found = prescribed_length_curve(p.begin, p.end, p.length, p.step);
    if (!found) {
      Fault fault = found.fault();
      fault.index = i;
      fault.sentence = "problem " + std::to_string(i) + ": " + fault.sentence;
      return fault;
    }
    answers[i] = {found->curve.preimage().coefficients(), found->rotation_index, found->margin};
    return std::nullopt;
  };
  const auto answer_waiting = [&] {
    solve_prescribed_lengths(in, count, out);
    for (std::size_t k = 0; k < count; ++k) {
      const double* row = out + k * length_numbers_out;
      if (!(row[7] - row[6] > 0.5 * accuracy_of_rotation_index)) {
        answer_alone(waiting[k]);  // a tie; ordinary numbers have no fault
        continue;
      }
      const double factor = 1.0 / std::sqrt(problems[waiting[k]].step);
      answers[waiting[k]] = {{Complex<double>{factor * row[0], factor * row[1]},
                              Complex<double>{factor * row[2], factor * row[3]},
                              Complex<double>{factor * row[4], factor * row[5]}},
                             2.0 * row[6],
                             2.0 * (row[7] - row[6])};
    }
    count = 0;
  };
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const PrescribedLengthProblem& p = problems[i];
    if (!is_ordinary(p.begin, p.end, p.length, p.step)) {
      if (auto fault = answer_alone(i)) return fault;
      continue;
    }
    const auto numbers = row_of(p.begin, p.end, p.length);
    std::copy(numbers.begin(), numbers.end(), in + count * length_numbers_in);
    waiting[count] = i;
    if (++count == longest) answer_waiting();
  }
  answer_waiting();
  return std::nullopt;
}

}  // namespace hodograph
