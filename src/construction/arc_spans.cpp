// SPDX-License-Identifier: MIT
// Arcs as quintics of their own length, very short ones joined with their neighbours.
#include "arc_spans.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace hodograph::turn_detail {
namespace {

/// An arc of a smaller angle α is made one quintic with its neighbour: as one of its own, the
/// rounding of its coefficients would be ε/α of its curvature.
constexpr double least_angle = 0x1.0p-28;
/// Joined arcs end with one of at least this angle: a quintic along less has a length so close to
/// its chord's that rounding decides its shape.
constexpr double least_joined = 0x1.0p-5;
/// The quintic of prescribed length along an arc: chord X = 2 ρ sin(α/2), S = ρ α, directions
/// ∓α/2 to the chord; the symmetric case |w0|² = 3 (S - X)/(2 m²), w1 real, with l + i m =
/// exp(i α/4), where S - X = 2 ρ (α/2 - sin(α/2)) keeps its digits however short the arc.
/// `phase` is exp(i φ/2) for the heading φ, and is turned along.
PlanPreimage arc(Complex<double>& phase, double angle, double radius) {
  const double size = std::abs(angle), l = std::cos(0.25 * size), m = std::sin(0.25 * size);
  const double excess = 2.0 * radius * bow(0.5 * size);
  const double sum = radius * (size + 2.0 * std::sin(0.5 * size));
  const double z = 1.5 * excess / (m * m), w = std::sqrt(z);
  const double middle = 0.25 * (std::sqrt(60.0 * sum - 20.0 * l * l * z) - 6.0 * l * w);
  const auto turned_by = [](double half) {
    return Complex<double>{std::cos(half), std::sin(half)};
  };
  const Complex<double> before = phase;
  phase = phase * turned_by(0.5 * angle);
  phase = (1.0 / std::sqrt(dot(phase, phase))) * phase;
  return PlanPreimage({w * before, middle * (before * turned_by(0.25 * angle)), w * phase});
}

/// The skeleton cut into groups of pieces, each for one quintic: one piece, or a very short arc
/// with what follows it, up to the first longer arc, or line long enough to take its angle up; the
/// last ones with what is before them.
using Group = std::vector<Move>;
std::vector<Group> groups_of(const Skeleton& skeleton, const ArcPieces& pieces) {
  constexpr double long_enough = 16.0;  // times the short arcs: the curvature is half of theirs
  std::vector<Group> groups;
  Group open;
  double short_arcs = 0.0, lines = 0.0;
  const double all = skeleton.length();
  const auto add = [&](const Move& move) {
    open.push_back(move);
    const bool is_arc = move.straight == 0.0;
    if (is_arc && std::abs(move.angle) < least_angle) short_arcs += std::abs(move.angle);
    if (!is_arc) lines += move.straight;
    const double needed = short_arcs > 0.0 ? least_joined : least_angle;
    const bool longer_arc = is_arc && std::abs(move.angle) >= needed;
    if (longer_arc || (lines > 0.0 && lines >= long_enough * short_arcs * skeleton.radius)) {
      groups.push_back(std::move(open));
      open.clear();
      short_arcs = lines = 0.0;
    }
  };
  for (const Move& move : skeleton.moves) {
    if (move.straight > rounding * all) add({0.0, move.straight});
    if (std::abs(move.angle) <= rounding) continue;
    const double count =
        std::max(1.0, std::ceil(std::abs(move.angle) / pieces.longest * (1.0 - rounding)));
    const auto arcs = static_cast<std::size_t>(count);
    for (std::size_t i = 0; i < arcs; ++i) add({move.angle / count, 0.0});
  }
  if (groups.empty() && !open.empty()) groups.emplace_back();
  if (!open.empty()) groups.back().insert(groups.back().end(), open.begin(), open.end());
  return groups;
}

/// The way along moves from the origin, and the direction at its end.
DirectedPoint end_of(const Group& group, const Vector2<double>& along, double radius) {
  DirectedPoint end{{0.0, 0.0}, along};
  for (const Move& move : group) {
    end.position += move.straight * end.direction;
    const double angle = move.angle, side = angle < 0.0 ? -1.0 : 1.0;
    if (angle == 0.0) continue;
    const double c = std::cos(angle), s = std::sin(angle), half = std::sin(0.5 * angle);
    const Vector2<double> left{-end.direction.y, end.direction.x};
    end.position +=
        (radius * side * s) * end.direction + (side * 2.0 * radius * half * half) * left;
    end.direction = c * end.direction + s * left;
  }
  return end;
}

}  // namespace

Result<PlanarPath<2>> spans_along(const Skeleton& skeleton, const ArcPieces& pieces,
                                  const DirectedPoint& begin, double unit) {
  Spans spans(begin.position);
  const double heading = std::atan2(begin.direction.y, begin.direction.x);
  Complex<double> phase{std::cos(0.5 * heading), std::sin(0.5 * heading)};
  for (const Group& group : groups_of(skeleton, pieces)) {
    if (group.size() == 1 && group[0].straight > 0.0) {
      const Complex<double> one = std::sqrt(unit * group[0].straight) * phase;
      spans.add(PlanPreimage({one, one, one}));
      continue;
    }
    if (group.size() == 1) {
      spans.add(arc(phase, group[0].angle, unit * skeleton.radius));
      continue;
    }
    const Vector2<double> along = hodograph_form(phase, phase);
    const DirectedPoint end = end_of(group, along, skeleton.radius);
    double length = 0.0, angle = 0.0;
    for (const Move& move : group) {
      length += move.straight + std::abs(move.angle) * skeleton.radius;
      angle += move.angle;
    }
    const auto made = prescribed_length_curve(
        {{0.0, 0.0}, along}, end, std::max(length, std::hypot(end.position.x, end.position.y)));
    if (!made) return made.fault();
    const double scale = std::sqrt(unit);
    spans.add(made->curve.preimage().mapped([&](const Complex<double>& w) { return scale * w; }));
    phase = phase * Complex<double>{std::cos(0.5 * angle), std::sin(0.5 * angle)};
  }
  return std::move(spans).path();
}

}  // namespace hodograph::turn_detail
