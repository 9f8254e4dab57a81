// SPDX-License-Identifier: MIT
// Planar C¹ Hermite interpolation: checks, scaling, choice and faults around the kernel.
#include "hodograph/construction/planar_hermite.hpp"

#include <algorithm>
#include <cmath>

#include "hodograph/construction/detail/planar_hermite_kernel.hpp"
#include "hodograph/construction/detail/planar_solution.hpp"
#include "hodograph/construction/detail/points_on_knots.hpp"
#include "hodograph/path/rotation_index.hpp"

namespace hodograph {
namespace planar_detail {

double least_speed(const Preimage& w) {
  const auto speed =
      symmetric_square(BernsteinPolynomial<Complex<double>, 2>(w),
                       [](const auto& a, const auto& b) { return speed_form(a, b); });
  const auto slope = speed.derivative();
  double least = std::min(speed.front(), speed.back());
  // A dip lies where the slope, a cubic, turns from negative to positive; dips closer to each other
  // than a step differ by nothing that matters.
  constexpr int steps = 16, halvings = 27;  // 2^-31: the value is flat to rounding there
  double low = 0.0, slope_at_low = slope.front();
  for (int i = 1; i <= steps; ++i) {
    const double high = static_cast<double>(i) / steps, slope_at_high = slope.value(high);
    if (slope_at_low < 0.0 && slope_at_high >= 0.0) {
      double left = low, right = high;
      for (int k = 0; k < halvings; ++k) {
        const double middle = 0.5 * (left + right);
        (slope.value(middle) < 0.0 ? left : right) = middle;
      }
      least = std::min(least, speed.value(right));
    }
    low = high;
    slope_at_low = slope_at_high;
  }
  return std::max(least, 0.0);
}

TieBreak break_tie(const Preimage& one, const Preimage& other, bool& first) {
  double size = 0.0;
  for (const auto* w : {&one, &other}) {
    for (const auto& c : *w) size = std::max(size, dot(c, c));
  }
  // Eight roundings of a value of σ, each of the size of the largest coefficient.
  const double allowed = 8.0 * accuracy::evaluation_error<double>(4) * size;
  const double speed = least_speed(one) - least_speed(other);
  first = speed > 0.0;
  if (std::abs(speed) > allowed) return TieBreak::regularity;
  const auto turn = [](const Preimage& w) {
    return rotation_index(PlanarPhCurve<2>({}, BernsteinPolynomial<Complex<double>, 2>(w), 1.0));
  };
  const double left = turn(one) - turn(other);
  first = left > 0.0;
  if (std::abs(left) > accuracy_of_rotation_index) return TieBreak::left_turn;
  first = true;
  return TieBreak::order;
}

namespace {

std::optional<Fault> data_fault(const PlanarHermitePoint& begin, const PlanarHermitePoint& end,
                                double h, std::size_t index) {
  const PlanarHermitePoint* points[] = {&begin, &end};
  for (std::size_t i = 0; i < 2; ++i) {
    const bool place = is_finite(points[i]->position);
    if (place && is_finite(points[i]->derivative)) continue;
    const char* what = place ? "derivative" : "position";
    return Fault{
        FaultCode::not_finite,
        std::string("the ") + what + " of point " + std::to_string(index + i) + " is not finite",
        index + i,
        what,
        std::nullopt,
        std::nullopt};
  }
  return construction_detail::step_fault(h, index);
}

/// The data of one problem, scaled.
struct Scaled {
  Complex<double> d0, d1, v;
  double scale;
};

double size_of(const Vector2<double>& v) { return largest_component(v); }

/// Fills `data`; the fault if there is one.
std::optional<Fault> prepare(const PlanarHermitePoint& begin, const PlanarHermitePoint& end,
                             double h, std::size_t index, Scaled& data) {
  const Vector2<double> displacement = end.position - begin.position;
  const Vector2<double> v{displacement.x / h, displacement.y / h};
  const double size = std::max({size_of(begin.derivative), size_of(end.derivative), size_of(v)});
  // One comparison for the ordinary case; NaN fails it.
  if (!(size < std::numeric_limits<double>::infinity() && 0.0 < size && 0.0 < h)) {
    if (auto fault = data_fault(begin, end, h, index)) return fault;
    if (size == 0.0) {
      return Fault{FaultCode::zero_speed,
                   "segment " + std::to_string(index) +
                       ": both derivatives are zero and its points coincide; give it a length or "
                       "a speed",
                   index,
                   "derivative",
                   0.0,
                   std::nullopt};
    }
    return planar_range_fault(index);
  }
  if (!is_finite(begin.position) || !is_finite(end.position) || !std::isfinite(h) ||
      !is_finite(begin.derivative) || !is_finite(end.derivative) || !is_finite(v)) {
    if (auto fault = data_fault(begin, end, h, index)) return fault;
    return planar_range_fault(index);
  }
  data.scale = prescale(size);
  const double square = data.scale * data.scale;
  data.d0 = scaled(square, begin.derivative);
  data.d1 = scaled(square, end.derivative);
  data.v = scaled(square, v);
  return std::nullopt;
}

/// The turns by lanes, with the bits of PlainTurns.
struct LaneTurns {
  void operator()(const Complex<double>& w0, const std::array<Complex<double>, 4>& w1,
                  const std::array<Complex<double>, 4>& w2, std::array<double, 4>& turns) const {
    double in[24];
    for (std::size_t k = 0; k < 4; ++k) {
      const double column[] = {w0.re, w0.im, w1[k].re, w1[k].im, w2[k].re, w2[k].im};
      for (std::size_t c = 0; c < 6; ++c) in[4 * c + k] = column[c];
    }
    four_turns(in, turns.data());
  }
};

std::array<Preimage, 4> preimages_of(const HermiteSolutions<double>& found) {
  std::array<Preimage, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] = {found.w0, found.w1[k], k < 2 ? found.w2 : -found.w2};
  }
  return result;
}

bool is_usable(const PlanarPhCurve<2>& curve) {
  return is_finite(curve.end()) && is_finite(curve.arc_length()) && curve.arc_length() > 0.0;
}

/// The chosen preimage in the data's own scale.
struct Choice {
  Preimage w;
  double turn, next;
  TieBreak tie;
};

Choice choose_by_ranking(const HermiteSolutions<double>& found) {
  const auto preimages = preimages_of(found);
  const auto ranking = ranked(preimages, found.turn);
  const std::size_t best = ranking.order[0];
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < 4; ++k) {
    if (k != best) next = std::min(next, found.turn[k]);
  }
  return {preimages[best], found.turn[best], next, ranking.tie};
}

bool is_tie(double turn, double next) { return !(next - turn > 0.5 * accuracy_of_rotation_index); }

Result<PlanarHermite> solve(const PlanarHermitePoint& begin, const PlanarHermitePoint& end,
                            double h, std::size_t index) {
  Scaled data;
  if (auto fault = prepare(begin, end, h, index, data)) return *std::move(fault);
  const auto found = solve_hermite(data.d0, data.d1, data.v, LaneTurns{});
  const LeastTurn<double> best = least_turn(found);
  Choice choice{{found.w0, best.w1, best.w2}, best.turn, best.next, TieBreak::none};
  if (is_tie(choice.turn, choice.next)) choice = choose_by_ranking(found);
  PlanarHermite result{PlanarPhCurve<2>(begin.position, restored(choice.w, data.scale), h),
                       2.0 * choice.turn, std::max(0.0, 2.0 * (choice.next - choice.turn)),
                       choice.tie};
  if (!is_usable(result.curve)) return planar_range_fault(index);
  return result;
}

}  // namespace
}  // namespace planar_detail

Result<PlanarHermite> planar_hermite(const PlanarHermitePoint& begin, const PlanarHermitePoint& end,
                                     double h) {
  return planar_detail::solve(begin, end, h, 0);
}

Result<std::array<PlanarSolution, 4>> planar_hermite_solutions(const PlanarHermitePoint& begin,
                                                               const PlanarHermitePoint& end,
                                                               double h) {
  planar_detail::Scaled data;
  if (auto fault = planar_detail::prepare(begin, end, h, 0, data)) return *std::move(fault);
  const auto found =
      planar_detail::solve_hermite(data.d0, data.d1, data.v, planar_detail::LaneTurns{});
  const auto preimages = planar_detail::preimages_of(found);
  const auto ranking = planar_detail::ranked(preimages, found.turn);
  std::array<PlanarSolution, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = ranking.order[k];
    result[k] = {
        PlanarPhCurve<2>(begin.position, planar_detail::restored(preimages[from], data.scale), h),
        2.0 * found.turn[from]};
    if (!planar_detail::is_usable(result[k].curve)) return planar_detail::planar_range_fault(0);
  }
  return result;
}

std::array<PlanarHermitePoint, 2> hermite_data_of_control_points(const Vector2<double>& p0,
                                                                 const Vector2<double>& p1,
                                                                 const Vector2<double>& p4,
                                                                 const Vector2<double>& p5,
                                                                 double h) {
  const auto derivative = [h](const Vector2<double>& a, const Vector2<double>& b) {
    return Vector2<double>{5.0 * (b.x - a.x) / h, 5.0 * (b.y - a.y) / h};
  };
  return {PlanarHermitePoint{p0, derivative(p0, p1)}, PlanarHermitePoint{p5, derivative(p4, p5)}};
}

Result<PlanarPath<2>> planar_hermite_path(std::vector<double> knots,
                                          std::span<const PlanarHermitePoint> points, bool closed) {
  if (auto fault = construction_detail::points_on_knots_fault<double>(points.size(), knots)) {
    return *std::move(fault);
  }
  std::vector<PlanarPhCurve<2>> segments;
  segments.reserve(points.size() - 1);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    auto found = planar_detail::solve(points[k], points[k + 1], knots[k + 1] - knots[k], k);
    if (!found) return found.fault();
    const PlanarPhCurve<2>& curve = found->curve;
    const bool turned =
        !segments.empty() && dot(segments.back().preimage().back(), curve.preimage().front()) < 0.0;
    if (turned) {
      segments.emplace_back(curve.start(),
                            curve.preimage().mapped([](const Complex<double>& c) { return -c; }),
                            curve.parameter_step());
    } else {
      segments.push_back(curve);
    }
  }
  return PlanarPath<2>::create(std::move(knots), std::move(segments), closed);
}

std::optional<Fault> planar_hermite(std::span<const PlanarHermiteProblem> problems,
                                    std::span<PlanarHermiteAnswer> answers) {
  using namespace planar_detail;
  constexpr std::size_t longest = 64;
  double in[longest * hermite_numbers_in], out[longest * hermite_numbers_out], scales[longest];
  for (std::size_t first = 0; first < problems.size(); first += longest) {
    const std::size_t count = std::min(longest, problems.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const PlanarHermiteProblem& problem = problems[first + i];
      Scaled data;
      if (auto fault = prepare(problem.begin, problem.end, problem.step, 0, data)) {
        fault->index = first + i;
        fault->sentence = "problem " + std::to_string(first + i) + ": " + fault->sentence;
        return fault;
      }
      const double numbers[] = {data.d0.re, data.d0.im, data.d1.re,
                                data.d1.im, data.v.re,  data.v.im};
      std::copy(std::begin(numbers), std::end(numbers), in + i * hermite_numbers_in);
      scales[i] = data.scale;
    }
    solve_hermites(in, count, out);
    for (std::size_t i = 0; i < count; ++i) {
      const double* row = out + i * hermite_numbers_out;
      Choice choice{
          {{{row[0], row[1]}, {row[2], row[3]}, {row[4], row[5]}}}, row[6], row[7], TieBreak::none};
      if (is_tie(choice.turn, choice.next)) {
        const double* data = in + i * hermite_numbers_in;
        choice = choose_by_ranking(
            solve_hermite<double>({data[0], data[1]}, {data[2], data[3]}, {data[4], data[5]}));
      }
      const double factor = 1.0 / scales[i];
      PlanarHermiteAnswer& answer = answers[first + i];
      answer.preimage = {factor * choice.w[0], factor * choice.w[1], factor * choice.w[2]};
      answer.rotation_index = 2.0 * choice.turn;
      answer.margin = std::max(0.0, 2.0 * (choice.next - choice.turn));
    }
  }
  return std::nullopt;
}

}  // namespace hodograph
