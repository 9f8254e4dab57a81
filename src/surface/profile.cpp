// SPDX-License-Identifier: MIT
#include "hodograph/surface/profile.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "enclosed_polynomial.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "simple_curve.hpp"
#include "spatial_pieces.hpp"

namespace hodograph {
namespace {

using namespace surface_detail;

Fault size_fault(const std::string& what, double value) {
  return {FaultCode::outside_domain,
          what + " is " + to_text(value) + "; it must be a positive finite number",
          std::nullopt,
          what,
          value,
          0.0};
}

bool is_size(double x) { return std::isfinite(x) && x > 0.0; }

/// The quarters of the ellipse with half axes a, b, counterclockwise from (a, 0); every second one
/// is the mirror image of the one before it, so that end weights agree.
std::vector<RationalBezier> ellipse_quarters(double a, double b) {
  return {{0.0, 0.25, {{a, 0.0}, {a, b}, {0.0, b}}, {1.0, 1.0, 2.0}},
          {0.25, 0.5, {{0.0, b}, {-a, b}, {-a, 0.0}}, {2.0, 1.0, 1.0}},
          {0.5, 0.75, {{-a, 0.0}, {-a, -b}, {0.0, -b}}, {1.0, 1.0, 2.0}},
          {0.75, 1.0, {{0.0, -b}, {a, -b}, {a, 0.0}}, {2.0, 1.0, 1.0}}};
}

template <class Point>
std::optional<Fault> fault_of(const std::vector<RationalBezierCurve<Point>>& pieces, bool closed) {
  if (pieces.empty()) {
    return Fault{FaultCode::too_few,
                 "the profile has no curve; it needs one at least",
                 std::nullopt,
                 "profile",
                 0.0,
                 1.0};
  }
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& piece = pieces[k];
    const std::string name = "piece " + std::to_string(k) + " of the profile";
    if (piece.control_points.size() < 2 || piece.control_points.size() != piece.weights.size()) {
      return Fault{FaultCode::mismatched_size,
                   name + " has " + std::to_string(piece.control_points.size()) +
                       " control points and " + std::to_string(piece.weights.size()) +
                       " weights; there must be as many, two or more",
                   k,
                   "weights",
                   static_cast<double>(piece.weights.size()),
                   std::nullopt};
    }
    for (std::size_t i = 0; i < piece.weights.size(); ++i) {
      if (!is_finite(piece.control_points[i])) {
        return Fault{FaultCode::not_finite,
                     name + " has a coordinate that is not finite",
                     k,
                     "control_points",
                     std::nullopt,
                     std::nullopt};
      }
      if (!is_size(piece.weights[i])) {
        return Fault{FaultCode::outside_domain,
                     name + " has the weight " + to_text(piece.weights[i]) +
                         "; weights must be positive and finite",
                     k,
                     "weights",
                     piece.weights[i],
                     0.0};
      }
    }
  }
  const std::size_t joints = closed ? pieces.size() : pieces.size() - 1;
  for (std::size_t k = 0; k < joints; ++k) {
    const std::size_t next = (k + 1) % pieces.size();
    const Point end = pieces[k].control_points.back(), begin = pieces[next].control_points.front();
    double size = 0.0;
    for (const auto* piece : {&pieces[k], &pieces[next]}) {
      for (const Point& p : piece->control_points) size = std::max(size, largest_component(p));
    }
    const double gap = largest_component(begin - end);
    if (!(gap <= accuracy::join_error<double>() * size)) {
      return Fault{FaultCode::not_continuous,
                   "piece " + std::to_string(next) + " of the profile starts " + to_text(gap) +
                       " away from where piece " + std::to_string(k) + " ends",
                   next,
                   "profile",
                   gap,
                   accuracy::join_error<double>() * size};
    }
  }
  return std::nullopt;
}

/// Areas and cross products of coordinates keep their digits.
std::optional<Fault> range_fault(const std::vector<RationalBezier>& pieces) {
  constexpr double most = 0x1.0p+500, least = 0x1.0p-500;  // their squares are doubles
  double size = 0.0;
  for (const auto& piece : pieces) {
    for (const auto& p : piece.control_points) size = std::max(size, largest_component(p));
  }
  if (size <= most && (size >= least || size == 0.0)) return std::nullopt;
  const double bound = size > most ? most : least;
  return Fault{FaultCode::outside_domain,
               "the profile reaches " + to_text(size) + " from the path; between " +
                   to_text(least) + " and " + to_text(most) + " is what can be computed with",
               std::nullopt,
               "profile",
               size,
               bound};
}

/// Twice the area that closed pieces enclose, ∮ x dy - y dx, positive counterclockwise; by
/// Simpson's rule on `parts` parts a piece: its sign is what is asked for.
double twice_signed_area(const std::vector<RationalBezier>& pieces) {
  constexpr int parts = 8;
  double sum = 0.0;
  for (const auto& piece : pieces) {
    const auto weighted = piece.weighted();
    const auto weight = piece.weight();
    const auto weighted_rate = weighted.derivative();
    const auto weight_rate = weight.derivative();
    const auto integrand = [&](double u) {
      const double w = weight.value(u);
      const Vector2<double> p = (1.0 / w) * weighted.value(u);
      return cross(p, (1.0 / w) * (weighted_rate.value(u) - weight_rate.value(u) * p));
    };
    for (int i = 0; i < parts; ++i) {
      const double a = static_cast<double>(i) / parts, b = static_cast<double>(i + 1) / parts;
      sum += (b - a) / 6.0 * (integrand(a) + 4.0 * integrand(0.5 * (a + b)) + integrand(b));
    }
  }
  return sum;
}

void reverse(std::vector<RationalBezier>& pieces) {
  std::reverse(pieces.begin(), pieces.end());
  const double sum = pieces.front().end + pieces.back().begin;
  for (auto& piece : pieces) {
    std::reverse(piece.control_points.begin(), piece.control_points.end());
    std::reverse(piece.weights.begin(), piece.weights.end());
    const double begin = piece.begin;
    piece.begin = sum - piece.end;
    piece.end = sum - begin;
  }
}

std::vector<RationalBezier> straight_pieces(std::span<const Vector2<double>> points, bool closed) {
  std::vector<RationalBezier> pieces;
  const std::size_t count = closed ? points.size() : points.size() - 1;
  for (std::size_t k = 0; k < count; ++k) {
    const auto at = static_cast<double>(k);
    pieces.push_back({at, at + 1.0, {points[k], points[(k + 1) % points.size()]}, {1.0, 1.0}});
  }
  return pieces;
}

/// The first and second derivative by the local parameter on a part, bounded: with p = X/W,
/// N = X'W - XW':  p' = N/W²,  p'' = (N'W - 2NW')/W³.
ProfileInterval bounded(const SpatialRationalBezier& piece, std::size_t index, double a, double b) {
  ProfileInterval interval{index, a, b, 0.0, 0.0};
  const Enclosure from(a), to(b);
  const Vector3<double> about =
      piece.position(0.5 * (a + b));  // bounds do not depend on the origin
  auto weighted = enclosed(piece.weighted());
  const auto whole_weight = enclosed(piece.weight());
  for (std::size_t i = 0; i < piece.weights.size(); ++i) {
    weighted[i] =
        Enclosure(piece.weights[i]) * (enclosed(piece.control_points[i]) - enclosed(about));
  }
  const auto x = weighted.restricted(from, to);
  const auto w = whole_weight.restricted(from, to);
  const bool polynomial = std::all_of(piece.weights.begin(), piece.weights.end(),
                                      [&](double one) { return one == piece.weights[0]; });
  const Enclosure reciprocal = Enclosure(1.0) / Enclosure(piece.weights[0]);
  if (polynomial) {
    const auto rate = x.derivative();
    interval.first = product_up(largest(rate), reciprocal.upper());
    interval.second = product_up(largest(rate.derivative()), reciprocal.upper());
    return interval;
  }
  const auto n = scaled_product(w, x.derivative()) - scaled_product(w.derivative(), x);
  const double low = least(w);
  const double second = largest(scaled_product(w, n.derivative()) -
                                scaled_product(Enclosure(2.0) * w.derivative(), n));
  interval.first = quotient_up(largest(n), Enclosure::down(low * low));
  interval.second = quotient_up(second, Enclosure::down(Enclosure::down(low * low) * low));
  return interval;
}

/// Halved until halves no longer need clearly fewer chords together.
void add_intervals(std::vector<ProfileInterval>& list, const SpatialRationalBezier& piece,
                   const ProfileInterval& whole, int depth) {
  constexpr int deepest = 8;
  constexpr double worthwhile = 0.9;
  const double middle = 0.5 * (whole.begin + whole.end);
  const auto p = bounded(piece, whole.piece, whole.begin, middle);
  const auto q = bounded(piece, whole.piece, middle, whole.end);
  if (depth == deepest ||
      !(std::sqrt(p.second) + std::sqrt(q.second) < worthwhile * std::sqrt(whole.second))) {
    list.push_back(whole);
    return;
  }
  add_intervals(list, piece, p, depth + 1);
  add_intervals(list, piece, q, depth + 1);
}

}  // namespace

Result<Profile> Profile::circle(double radius) {
  if (!is_size(radius)) return size_fault("radius", radius);
  auto profile = of(ellipse_quarters(radius, radius), true);
  if (profile) {
    Profile& circle = *profile;
    circle.circle_radius_ = radius;
    circle.set_sizes();
  }
  return profile;
}

Result<Profile> Profile::ellipse(double a, double b) {
  if (!is_size(a)) return size_fault("half axis", a);
  if (!is_size(b)) return size_fault("half axis", b);
  if (a == b) return circle(a);
  return of(ellipse_quarters(a, b), true);
}

Result<Profile> Profile::polygon(std::span<const Vector2<double>> corners) {
  if (corners.size() < 3) {
    return Fault{FaultCode::too_few,
                 "a polygon needs at least 3 corners; got " + std::to_string(corners.size()),
                 std::nullopt,
                 "corners",
                 static_cast<double>(corners.size()),
                 3.0};
  }
  return of(straight_pieces(corners, true), true);
}

Result<Profile> Profile::polyline(std::span<const Vector2<double>> points) {
  if (points.size() < 2) {
    return Fault{FaultCode::too_few,
                 "a polyline needs at least 2 points; got " + std::to_string(points.size()),
                 std::nullopt,
                 "points",
                 static_cast<double>(points.size()),
                 2.0};
  }
  return of(straight_pieces(points, false), false);
}

Result<Profile> Profile::of(std::vector<RationalBezier> pieces, bool closed, SelfContact contact) {
  if (auto fault = fault_of(pieces, closed)) return *fault;
  if (auto fault = range_fault(pieces)) return *fault;
  if (contact == SelfContact::refuse) {
    if (const auto at = surface_detail::self_contact(pieces, closed)) {
      return Fault{FaultCode::unsupported,
                   "the profile touches or crosses itself near (" + to_text(at->x) + ", " +
                       to_text(at->y) + "); it must not",
                   std::nullopt,
                   "profile",
                   std::nullopt,
                   std::nullopt};
    }
  }
  if (closed) {
    const double area = twice_signed_area(pieces);
    if (area == 0.0) {
      return Fault{FaultCode::outside_domain,
                   "the closed profile encloses no area",
                   std::nullopt,
                   "profile",
                   0.0,
                   std::nullopt};
    }
    if (area < 0.0) reverse(pieces);
  }
  Profile profile;
  profile.closed_ = closed;
  for (auto& piece : pieces) {
    SpatialRationalBezier spatial{piece.begin, piece.end, {}, std::move(piece.weights)};
    for (const auto& p : piece.control_points) spatial.control_points.push_back({0.0, p.x, p.y});
    profile.pieces_.push_back(std::move(spatial));
  }
  profile.set_sizes();
  return profile;
}

Result<Profile> Profile::of(const AnyPath& path, SelfContact contact) {
  if (path.dimension() != 2) {
    return Fault{FaultCode::unsupported,
                 "the profile is a path in space; a sweep needs one in the plane",
                 std::nullopt,
                 "dimension",
                 3.0,
                 2.0};
  }
  std::vector<RationalBezier> pieces;
  for (const auto& piece : surface_detail::spatial_pieces(path.numbers())) {
    RationalBezier plane{
        piece.begin, piece.end, {}, std::vector<double>(piece.displacement.degree() + 1, 1.0)};
    for (const auto& d : piece.displacement.coefficients()) {
      plane.control_points.push_back({piece.start.x + d.x, piece.start.y + d.y});
    }
    pieces.push_back(std::move(plane));
  }
  return of(std::move(pieces), path.is_closed(), contact);
}

Result<Profile> Profile::in_space(std::vector<SpatialRationalBezier> pieces, bool closed) {
  if (auto fault = fault_of(pieces, closed)) return *fault;
  Profile profile;
  profile.closed_ = closed;
  profile.planar_ = false;
  profile.pieces_ = std::move(pieces);
  profile.set_sizes();
  return profile;
}

Result<Profile> Profile::in_space(const AnyPath& path) {
  std::vector<SpatialRationalBezier> pieces;
  for (const auto& piece : surface_detail::spatial_pieces(path.numbers())) {
    SpatialRationalBezier curve{
        piece.begin, piece.end, {}, std::vector<double>(piece.displacement.degree() + 1, 1.0)};
    for (const auto& d : piece.displacement.coefficients()) {
      curve.control_points.push_back(piece.start + d);
    }
    pieces.push_back(std::move(curve));
  }
  return in_space(std::move(pieces), path.is_closed());
}

Profile::Jet Profile::at(std::size_t smooth_piece, double w) const {
  if (circle_radius_) {
    const double full = 2.0 * std::numbers::pi, r = *circle_radius_;
    const double c = std::cos(full * w), s = std::sin(full * w);
    return {{0.0, r * c, r * s}, {0.0, -(full * r) * s, (full * r) * c}};
  }
  const auto& piece = pieces_[smooth_piece];
  const auto weighted = piece.weighted();
  const auto weight = piece.weight();
  const double reciprocal = 1.0 / weight.value(w);
  const Vector3<double> p = reciprocal * weighted.value(w);
  return {p, reciprocal * (weighted.derivative().value(w) - weight.derivative().value(w) * p)};
}

void Profile::set_sizes() {
  reach_ = 0.0;
  Vector3<double> low = pieces_[0].control_points[0], high = low;
  for (const auto& piece : pieces_) {
    for (const auto& p : piece.control_points) {
      reach_ = std::max(reach_, surface_detail::size_bound(enclosed(p)));
      for (std::size_t j = 0; j < 3; ++j) {
        low[j] = std::min(low[j], p[j]);
        high[j] = std::max(high[j], p[j]);
      }
    }
  }
  extent_ = surface_detail::size_bound(enclosed(high) - enclosed(low));
  intervals_.clear();
  if (circle_radius_) {
    reach_ = *circle_radius_;
    const double speed = product_up(Enclosure::up(2.0 * std::numbers::pi), reach_);
    intervals_.push_back(
        {0, 0.0, 1.0, speed, product_up(Enclosure::up(2.0 * std::numbers::pi), speed)});
    return;
  }
  for (std::size_t k = 0; k < pieces_.size(); ++k) {
    add_intervals(intervals_, pieces_[k], bounded(pieces_[k], k, 0.0, 1.0), 0);
  }
}

}  // namespace hodograph
