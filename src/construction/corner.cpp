// SPDX-License-Identifier: MIT
// The G² corner and the rounded polyline.
#include "hodograph/construction/corner.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "hodograph/construction/detail/prescribed_length_kernel.hpp"
#include "hodograph/path/detail/angle.hpp"

namespace hodograph {
namespace {

using C = Complex<double>;

Fault bad(FaultCode code, std::size_t index, const char* quantity, std::optional<double> value,
          std::optional<double> bound, std::string sentence) {
  return {code, std::move(sentence), index, quantity, value, bound};
}

/// The direction of a line and its length; scaled so that no square leaves double's range.
struct Line {
  C direction{1.0, 0.0};
  double length = 0.0;
};

std::optional<Fault> find_line(const Vector2<double>& from, const Vector2<double>& to,
                               std::size_t index, Line& line) {
  for (std::size_t i = 0; i < 2; ++i) {
    if (is_finite(i == 0 ? from : to)) continue;
    return bad(FaultCode::not_finite, index + i, "position", std::nullopt, std::nullopt,
               "point " + std::to_string(index + i) + " is not finite");
  }
  const Vector2<double> v = to - from;
  const double size = largest_component(v);
  if (!(size <= std::numeric_limits<double>::max())) {
    return bad(
        FaultCode::no_interpolant, index, "range", std::nullopt, std::nullopt,
        "point " + std::to_string(index) + " and the next are too far apart to compute with");
  }
  if (size == 0.0) {
    return bad(FaultCode::outside_domain, index, "length", 0.0, std::nullopt,
               "point " + std::to_string(index) +
                   " and the next coincide: the line between them has no direction");
  }
  int exponent = 0;
  std::frexp(size, &exponent);
  const C unit{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent)};
  const double length = std::sqrt(dot(unit, unit));
  line.direction = (1.0 / length) * unit;
  line.length = std::ldexp(length, exponent);
  return std::nullopt;
}

/// A corner in numbers: the square roots of the directions before and after, continued, cos and sin
/// of half the turning angle.
struct Turn {
  Line in, out;
  C root_in{1.0, 0.0}, root_out{1.0, 0.0};
  double cosine = 1.0, sine = 0.0;  // of θ/2, signed sine
  bool straight() const { return std::abs(sine) <= accuracy::join_error<double>(); }
};

std::optional<Fault> find_turn(const Corner& corner, std::size_t index, Turn& turn) {
  if (auto fault = find_line(corner.before, corner.corner, index, turn.in)) return fault;
  if (auto fault = find_line(corner.corner, corner.after, index + 1, turn.out)) return fault;
  const C rotation = turn.out.direction * conjugate(turn.in.direction);
  const C half = planar_detail::root_of_unit(rotation);
  turn.cosine = half.re;
  turn.sine = half.im;
  if (turn.cosine <= 0.5 * accuracy::join_error<double>()) {
    return bad(FaultCode::outside_domain, index + 1, "turning_angle",
               2.0 * std::atan2(turn.sine, turn.cosine), path_detail::pi,
               "the line turns back on itself at point " + std::to_string(index + 1) +
                   ": a turn by π cannot be rounded");
  }
  turn.root_in = planar_detail::root_of_unit(turn.in.direction);
  turn.root_out = turn.root_in * half;
  return std::nullopt;
}

double curvature_for_unit_leg(const Turn& turn) {
  const double c = turn.cosine, s = std::abs(turn.sine);
  return 32.0 * (6.0 * c + 1.0) * s / (15.0 * c * (c + 1.0) * (c + 1.0));
}
double deviation_for_unit_leg(const Turn& turn) {
  const double c = turn.cosine, s = std::abs(turn.sine);
  return (3.0 * c + 8.0) * s / (8.0 * (6.0 * c + 1.0));
}
double length_for_unit_leg(const Turn& turn) {
  if (turn.straight()) return 2.0;
  const double c = turn.cosine;
  return 2.0 * (6.0 + c) * c / (6.0 * c + 1.0);
}

CornerShape shape_of(const Turn& turn, double leg) {
  if (turn.straight()) return {0.0, 0.0, 2.0 * leg, 0.0};
  return {2.0 * std::atan2(turn.sine, turn.cosine), curvature_for_unit_leg(turn) / leg,
          length_for_unit_leg(turn) * leg, deviation_for_unit_leg(turn) * leg};
}

/// The preimage over a step h; w1 = 0 but on a straight line.
BernsteinPolynomial<C, 2> corner_preimage(const Turn& turn, double leg, double h) {
  const double c = turn.cosine;
  if (turn.straight()) {
    const C w = (std::sqrt(2.0) * (std::sqrt(leg) / std::sqrt(h))) * turn.root_in;
    return BernsteinPolynomial<C, 2>({w, w, w});
  }
  const double size = std::sqrt(30.0 * c / (6.0 * c + 1.0)) * (std::sqrt(leg) / std::sqrt(h));
  return BernsteinPolynomial<C, 2>({size * turn.root_in, C{}, size * turn.root_out});
}

std::optional<Fault> positive_fault(double value, const char* quantity) {
  if (std::isfinite(value) && value > 0.0) return std::nullopt;
  return Fault{
      FaultCode::outside_domain,
      std::string("the ") + quantity + " must be positive and finite; got " + to_text(value),
      std::nullopt,
      quantity,
      value,
      0.0};
}

/// The corner from a leg that `leg_of` makes of its turn.
template <class LegOf>
Result<RoundedCorner> make_corner(const Corner& corner, double h, const LegOf& leg_of) {
  if (auto fault = positive_fault(h, "parameter step")) return *std::move(fault);
  Turn turn;
  if (auto fault = find_turn(corner, 0, turn)) return *std::move(fault);
  Result<double> leg = leg_of(turn);
  if (!leg) return leg.fault();
  const Vector2<double> start{corner.corner.x - *leg * turn.in.direction.re,
                              corner.corner.y - *leg * turn.in.direction.im};
  RoundedCorner result{PlanarPhCurve<2>(start, corner_preimage(turn, *leg, h), h), *leg,
                       shape_of(turn, *leg)};
  if (!is_finite(result.curve.end()) || !(result.curve.arc_length() > 0.0)) {
    return bad(FaultCode::no_interpolant, 1, "range", *leg, std::nullopt,
               "a corner with legs of " + to_text(*leg) + " leaves the range of double");
  }
  return result;
}

/// The leg where it fits the lines.
Result<double> fitting(const Turn& turn, double leg) {
  const double room = std::min(turn.in.length, turn.out.length);
  if (leg <= room) return leg;
  return bad(
      FaultCode::no_interpolant, 1, "leg", leg, room,
      "the corner needs " + to_text(leg) + " of each line; the shorter one has " + to_text(room));
}

Fault no_turn(const char* what) {
  return {FaultCode::no_interpolant,
          std::string("the points are on a line: every size of the corner keeps the ") + what +
              "; choose the size itself",
          1,
          "turning_angle",
          0.0,
          std::nullopt};
}

/// The lines and corners of a polyline. Corner k is at the end of line k, between points k and
/// k + 2; the last line of an open polyline ends without one.
struct TurningPolyline {
  std::span<const Vector2<double>> points;
  bool closed = false;
  std::vector<Turn> turns{};

  const Vector2<double>& point(std::size_t k) const { return points[k % points.size()]; }
  bool has_corner(std::size_t k) const { return closed || k + 1 < turns.size(); }
};

Result<TurningPolyline> turning_polyline(std::span<const Vector2<double>> points, bool closed) {
  const std::size_t count = points.size(), least = closed ? 3 : 2;
  if (count < least) {
    return Fault{FaultCode::too_few,
                 "a polyline needs at least " + std::to_string(least) + " points; got " +
                     std::to_string(count),
                 std::nullopt,
                 "points",
                 static_cast<double>(count),
                 static_cast<double>(least)};
  }
  TurningPolyline line{points, closed, std::vector<Turn>(closed ? count : count - 1)};
  for (std::size_t k = 0; k < line.turns.size(); ++k) {
    Turn& turn = line.turns[k];
    if (!line.has_corner(k)) {
      if (auto fault = find_line(line.point(k), line.point(k + 1), k, turn.in)) {
        return *std::move(fault);
      }
      turn.root_in = planar_detail::root_of_unit(turn.in.direction);
    } else if (auto fault =
                   find_turn({line.point(k), line.point(k + 1), line.point(k + 2)}, k, turn)) {
      fault->index = *fault->index % count;
      return *std::move(fault);
    }
  }
  return line;
}

/// Lines and corners in turn; a leg is 0 where the line passes straight (or ends).
Result<PlanarPath<2>> assembled(const TurningPolyline& line, std::span<const double> legs) {
  const auto& turns = line.turns;
  std::vector<double> knots{0.0};
  std::vector<PlanarPhCurve<2>> segments;
  const auto add = [&](const Turn& turn, const Vector2<double>& start, double leg, double length,
                       C root, bool straight) {
    const double knot = knots.back() + length;
    if (!(knots.back() < knot)) return;  // shorter than rounding
    const double step = knot - knots.back();
    knots.push_back(knot);
    if (straight) {
      const C w = std::sqrt(length / step) * root;
      segments.emplace_back(start, BernsteinPolynomial<C, 2>({w, w, w}), step);
    } else {
      segments.emplace_back(start, corner_preimage(turn, leg, step), step);
    }
  };
  for (std::size_t k = 0; k < turns.size(); ++k) {
    const Turn& turn = turns[k];
    const double before = k > 0 ? legs[k - 1] : line.closed ? legs.back() : 0.0;
    const double needed = before + legs[k];
    const double allowed = turn.in.length * (1.0 + accuracy::join_error<double>());
    if (needed > allowed) {
      return bad(FaultCode::no_interpolant, k, "leg", needed, turn.in.length,
                 "between point " + std::to_string(k) +
                     " and the next the corners need a length of " + to_text(needed) +
                     "; there is " + to_text(turn.in.length));
    }
    const C d = turn.in.direction;
    const auto along = [&](const Vector2<double>& from, double distance) {
      return Vector2<double>{from.x + distance * d.re, from.y + distance * d.im};
    };
    const double straight = turn.in.length - needed;
    if (straight > accuracy::join_error<double>() * turn.in.length || needed == 0.0) {
      add(turn, along(line.point(k), before), 0.0, straight, turn.root_in, true);
    }
    if (legs[k] > 0.0) {
      add(turn, along(line.point(k + 1), -legs[k]), legs[k], length_for_unit_leg(turn) * legs[k],
          turn.root_in, false);
    }
  }
  // The preimage continues, sign included.
  for (std::size_t k = 1; k < segments.size(); ++k) {
    if (dot(segments[k - 1].preimage().back(), segments[k].preimage().front()) < 0.0) {
      segments[k] = {segments[k].start(),
                     segments[k].preimage().mapped([](const C& c) { return -c; }),
                     segments[k].parameter_step()};
    }
  }
  return PlanarPath<2>::create(std::move(knots), std::move(segments), line.closed);
}

}  // namespace

Result<CornerShape> corner_shape(const Corner& corner) {
  Turn turn;
  if (auto fault = find_turn(corner, 0, turn)) return *std::move(fault);
  return shape_of(turn, 1.0);
}

Result<RoundedCorner> corner_of_leg(const Corner& corner, double leg, double h) {
  if (auto fault = positive_fault(leg, "leg")) return *std::move(fault);
  return make_corner(corner, h, [&](const Turn&) { return Result<double>(leg); });
}

Result<RoundedCorner> corner_of_curvature(const Corner& corner, double most_curvature, double h) {
  if (auto fault = positive_fault(most_curvature, "curvature bound")) return *std::move(fault);
  return make_corner(corner, h, [&](const Turn& turn) -> Result<double> {
    if (turn.straight()) return no_turn("curvature bound");
    return fitting(turn, curvature_for_unit_leg(turn) / most_curvature);
  });
}

Result<RoundedCorner> corner_of_deviation(const Corner& corner, double most_deviation, double h) {
  if (auto fault = positive_fault(most_deviation, "deviation bound")) return *std::move(fault);
  return make_corner(corner, h, [&](const Turn& turn) -> Result<double> {
    if (turn.straight()) return no_turn("deviation bound");
    return fitting(turn, most_deviation / deviation_for_unit_leg(turn));
  });
}

Result<RoundedCorner> corner_of_room(const Corner& corner, double h) {
  return make_corner(corner, h, [&](const Turn& turn) {
    return Result<double>(std::min(turn.in.length, turn.out.length));
  });
}

double corner_clearance_factor(double turning_angle) {
  const double c = std::cos(0.5 * turning_angle), s = std::sin(0.25 * turning_angle);
  // 1 - c = 2 sin²(θ/4).
  return 8.0 * (3.0 * c + 8.0) * (s * s) / (15.0 * (1.0 + c));
}

Result<PlanarPath<2>> rounded_polyline(std::span<const Vector2<double>> points,
                                       const CornerRule& rule) {
  for (const auto& [bound, name] : {std::pair(rule.most_curvature, "curvature bound"),
                                    std::pair(rule.most_deviation, "deviation bound")}) {
    if (!bound) continue;
    if (auto fault = positive_fault(*bound, name)) return *std::move(fault);
  }
  const auto line = turning_polyline(points, rule.closed);
  if (!line) return line.fault();
  std::vector<double> legs(line->turns.size(), 0.0);
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const Turn& turn = line->turns[k];
    if (!line->has_corner(k) || turn.straight()) continue;
    const double most = rule.most_deviation ? *rule.most_deviation / deviation_for_unit_leg(turn)
                                            : std::numeric_limits<double>::infinity();
    if (rule.most_curvature) {
      legs[k] = curvature_for_unit_leg(turn) / *rule.most_curvature;
      if (legs[k] > most) {
        const std::size_t at = (k + 1) % points.size();
        return bad(FaultCode::no_interpolant, at, "deviation",
                   legs[k] * deviation_for_unit_leg(turn), rule.most_deviation,
                   "at point " + std::to_string(at) + " a curvature of " +
                       to_text(*rule.most_curvature) + " takes a deviation of " +
                       to_text(legs[k] * deviation_for_unit_leg(turn)) + "; only " +
                       to_text(*rule.most_deviation) + " is allowed");
      }
    } else {
      legs[k] = std::min(0.5 * std::min(turn.in.length, turn.out.length), most);
    }
  }
  return assembled(*line, legs);
}

Result<PlanarPath<2>> rounded_polyline_of_legs(std::span<const Vector2<double>> points,
                                               std::span<const double> legs, bool closed) {
  const auto line = turning_polyline(points, closed);
  if (!line) return line.fault();
  const std::size_t corners = closed ? points.size() : points.size() - 2;
  if (legs.size() != corners) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(points.size()) + " points have " + std::to_string(corners) +
                     " corners; got " + std::to_string(legs.size()) + " legs",
                 std::nullopt,
                 "legs",
                 static_cast<double>(legs.size()),
                 static_cast<double>(corners)};
  }
  std::vector<double> used(line->turns.size(), 0.0);
  for (std::size_t k = 0; k < corners; ++k) {
    if (line->turns[k].straight()) continue;
    if (auto fault = positive_fault(legs[k], "leg of a corner")) {
      fault->index = (k + 1) % points.size();
      return *std::move(fault);
    }
    used[k] = legs[k];
  }
  return assembled(*line, used);
}

}  // namespace hodograph
