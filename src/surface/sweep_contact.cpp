// SPDX-License-Identifier: MIT
#include "hodograph/surface/sweep_contact.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <utility>
#include <vector>

#include "exact_piece.hpp"
#include "plane_between.hpp"
#include "surface_contact.hpp"

namespace hodograph {
namespace {

using surface_detail::exact_piece;
using surface_detail::ExactPiece;

/// Rounding, of the numbers' size: coefficients carry some hundred ε after the halvings.
constexpr double margin = 0x1.0p-40;
constexpr std::size_t most_pairs = 100'000;
constexpr int deepest = 24;
constexpr std::size_t circle_sides = 32;

/// An axis-parallel box, or an interval of vectors.
struct Box {
  Vector3<double> low{infinity, infinity, infinity}, high{-infinity, -infinity, -infinity};
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  void add(const Vector3<double>& p) {
    for (std::size_t i = 0; i < 3; ++i) {
      low[i] = std::min(low[i], p[i]);
      high[i] = std::max(high[i], p[i]);
    }
  }
  double size() const { return std::max(largest_component(low), largest_component(high)); }
};

struct Range {
  double low = 0.0, high = 0.0;
};
Range times(const Range& a, const Range& b) {
  const auto [low, high] =
      std::minmax({a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high});
  return {low, high};
}
Range component(const Box& b, std::size_t i) { return {b.low[i], b.high[i]}; }
Box cross(const Box& a, const Box& b) {
  Box c;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
    const Range p = times(component(a, j), component(b, k));
    const Range q = times(component(a, k), component(b, j));
    c.low[i] = p.low - q.high;
    c.high[i] = p.high - q.low;
  }
  return c;
}

/// A stretch of a piece: its exact products, and what is derived from them.
struct Stretch {
  ExactPiece exact;
  /// The path is start + displacement. Apart: far from the origin a sum would round its
  /// derivatives.
  Vector3<double> start{};
  DynamicPolynomial<Vector3<double>> displacement;
  /// Per unit of the piece's parameter, and made from the whole piece: differences of the
  /// coefficients of a short stretch would be little but rounding.
  DynamicPolynomial<Vector3<double>> velocity, acceleration;
  double begin = 0.0, end = 1.0;  ///< in ξ
  std::size_t piece = 0;          ///< of the motion
  int depth = 0;
  double largest_weight = 0.0;        ///< of the whole piece
  double spread = 1.0;                ///< that over the least weight here: what rounding grows by
  std::vector<Vector3<double>> hull;  ///< points whose convex hull holds all cross-sections
  Box sections, path;
  /// What a section's plane moves on by, and what carries its points back: no point of a section
  /// near it comes to lie in it again where advance > (x - r)·back.
  double advance = 0.0;
  Box back;
  Vector3<double> middle{}, tangent{};
  std::unique_ptr<Stretch> half[2];
};

/// The angles of a roll on a part of a segment.
Range roll_on(const FrameRoll& roll, std::size_t segment, double from, double to) {
  const double begin = roll.angle_at_begin(segment), end = roll.angle_at_end(segment);
  const auto pieces = roll.pieces(segment);
  Range range{Box::infinity, -Box::infinity};
  const auto add = [&](double low, double high) {
    range.low = std::min(range.low, low);
    range.high = std::max(range.high, high);
  };
  if (pieces.empty()) {
    add(begin + from * (end - begin), begin + from * (end - begin));
    add(begin + to * (end - begin), begin + to * (end - begin));
  }
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const auto& piece = pieces[i];
    const double last = i + 1 < pieces.size() ? pieces[i + 1].begin : 1.0;
    if (last < from || piece.begin > to) continue;
    const double low = (std::max(from, piece.begin) - piece.center) * piece.scale;
    const double high = (std::min(to, last) - piece.center) * piece.scale;
    // The value in the middle, and as far from it as the slope allows.
    const double x = 0.5 * (low + high), reach = 0.5 * (high - low);
    double value = 0.0, slope = 0.0;
    for (std::size_t k = piece.coefficient.size(); k-- > 0;) {
      value = (value + piece.coefficient[k]) * x;
      slope += static_cast<double>(k + 1) * std::abs(piece.coefficient[k]);
    }
    add(piece.middle + value - slope * reach, piece.middle + value + slope * reach);
  }
  const double off = roll.error_bound() + margin * (std::abs(range.low) + std::abs(range.high));
  return {range.low - off, range.high + off};
}

/// Points whose convex hull holds those of all corners when these are rolled by angles of a range.
std::vector<Vector3<double>> rolled_corners(const std::vector<Vector3<double>>& corners,
                                            const Range& roll) {
  const double middle = 0.5 * (roll.low + roll.high), most = 0.5 * (roll.high - roll.low);
  std::vector<Vector3<double>> result;
  constexpr double widest = 0.25 * std::numbers::pi;
  if (!(most <= widest)) {
    // Anything: the square round the circle.
    double radius = 0.0;
    for (const auto& p : corners) radius = std::max(radius, std::hypot(p.y, p.z));
    for (const double y : {-radius, radius}) {
      for (const double z : {-radius, radius}) result.push_back({0.0, y, z});
    }
    return result;
  }
  // An arc lies in the triangle of its ends and of where the tangents there meet.
  for (const auto& p : corners) {
    for (const double by : {-most, 0.0, most}) {
      const double stretch = by == 0.0 ? 1.0 / std::cos(most) : 1.0;
      const double c = stretch * std::cos(middle + by), s = stretch * std::sin(middle + by);
      result.push_back({p.x, c * p.y - s * p.z, s * p.y + c * p.z});
    }
  }
  return result;
}

/// The convex hull of the profile's control points in (e₂, e₃), counterclockwise.
std::vector<Vector2<double>> corners_of(const Profile& profile) {
  std::vector<Vector2<double>> points;
  if (profile.circle_radius()) {
    const double turn = 2.0 * std::numbers::pi / static_cast<double>(circle_sides);
    const double radius = *profile.circle_radius() / std::cos(0.5 * turn);
    for (std::size_t i = 0; i < circle_sides; ++i) {
      const double angle = turn * static_cast<double>(i);
      points.push_back({radius * std::cos(angle), radius * std::sin(angle)});
    }
    return points;
  }
  for (const auto& piece : profile.pieces()) {
    for (const auto& p : piece.control_points) points.push_back({p.y, p.z});
  }
  std::sort(points.begin(), points.end(),
            [](const auto& a, const auto& b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  std::vector<Vector2<double>> hull;
  for (int side = 0; side < 2; ++side) {  // Andrew's chains
    const std::size_t first = hull.size();
    for (const auto& p : points) {
      while (hull.size() >= first + 2 &&
             cross(hull.back() - hull[hull.size() - 2], p - hull.back()) <= 0.0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.empty() ? std::vector<Vector2<double>>{points.front()} : hull;
}

class Search {
 public:
  Search(const Sweep& sweep, double factor)
      : closed_(sweep.motion.is_closed()),
        roll_(sweep.profile.circle_radius() ? nullptr : sweep.motion.roll()) {
    for (const auto& p : corners_of(sweep.profile)) {
      corners_.push_back({0.0, factor * p.x, factor * p.y});
    }
    for (const MotionPiece& piece : sweep.motion.pieces()) {
      auto whole = std::make_unique<Stretch>();
      whole->exact = exact_piece(piece);
      whole->start = piece.start;
      whole->displacement = piece.displacement;
      whole->velocity = piece.displacement.derivative();
      whole->acceleration = whole->velocity.derivative();
      for (const double w : whole->exact.weight.coefficients()) {
        whole->largest_weight = std::max(whole->largest_weight, w);
      }
      whole->begin = piece.begin;
      whole->end = piece.end;
      whole->piece = roots_.size();
      first_.push_back(piece.begin);
      length_.push_back(piece.end - piece.begin);
      roots_.push_back(std::move(whole));
    }
    // At least four stretches, so that neighbours on a closed path are on one side only.
    constexpr std::size_t least = 4;
    for (bool more = true; more;) {
      more = roots_.size() < least;
      std::vector<std::unique_ptr<Stretch>> next;
      for (auto& root : roots_) {
        const auto& w = root->exact.weight.coefficients();
        const bool positive = std::all_of(w.begin(), w.end(), [](double c) { return c > 0.0; });
        if ((positive && roots_.size() >= least) || root->depth >= deepest) {
          next.push_back(std::move(root));
          continue;
        }
        split(*root);
        next.push_back(std::move(root->half[0]));
        next.push_back(std::move(root->half[1]));
        more = true;
      }
      roots_ = std::move(next);
    }
    for (auto& root : roots_) {
      if (!finish(*root)) bounded_ = false;
    }
  }

  SweepContact run() {
    SweepContact answer;
    if (!bounded_) return answer;
    struct Pair {
      Stretch *first, *second;
      bool adjacent;  // `second` begins where `first` ends
    };
    std::vector<Pair> open;
    const std::size_t n = roots_.size();
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) {
        const bool round = closed_ && i == 0 && j + 1 == n;
        Stretch* a = roots_[round ? j : i].get();
        Stretch* b = roots_[round ? i : j].get();
        open.push_back({a, b, round || j == i + 1});
      }
    }
    for (const auto& root : roots_) open.push_back({root.get(), root.get(), false});
    while (!open.empty()) {
      const Pair pair = open.back();
      open.pop_back();
      Stretch &a = *pair.first, &b = *pair.second;
      if (++answer.pairs > most_pairs || a.depth > deepest || b.depth > deepest) {
        answer.xi[0] = std::min(a.begin, b.begin);
        answer.xi[1] = std::max(a.begin, b.begin);
        return answer;
      }
      if (&a == &b) {
        if (advances(a, a)) continue;
        if (!halves(a)) return answer;
        // Folds first: they are found soonest.
        open.push_back({a.half[0].get(), a.half[1].get(), true});
        open.push_back({a.half[0].get(), a.half[0].get(), false});
        open.push_back({a.half[1].get(), a.half[1].get(), false});
        continue;
      }
      if (pair.adjacent ? advances(a, a) && advances(a, b) : separated(a, b)) {
        continue;
      }
      if (!halves(a) || !halves(b)) return answer;
      for (int i = 0; i < 2; ++i) {
        for (int j = 0; j < 2; ++j) {
          open.push_back({a.half[i].get(), b.half[j].get(), pair.adjacent && i == 1 && j == 0});
        }
      }
    }
    answer.free = true;
    return answer;
  }

 private:
  static void split(Stretch& s) {
    for (int i = 0; i < 2; ++i) {
      const double from = i == 0 ? 0.0 : 0.5, to = i == 0 ? 0.5 : 1.0;
      auto part = std::make_unique<Stretch>();
      const auto cut = [&](const auto& f) { return f.restricted(from, to); };
      part->exact = {cut(s.exact.weight), cut(s.exact.center), cut(s.exact.e1), cut(s.exact.e2),
                     cut(s.exact.e3)};
      part->start = s.start;
      part->displacement = cut(s.displacement);
      part->velocity = cut(s.velocity);
      part->acceleration = cut(s.acceleration);
      part->largest_weight = s.largest_weight;
      const double half = 0.5 * (s.begin + s.end);
      part->begin = i == 0 ? s.begin : half;
      part->end = i == 0 ? half : s.end;
      part->piece = s.piece;
      part->depth = s.depth + 1;
      s.half[i] = std::move(part);
    }
  }

  /// Makes the halves where there are none yet; false where their numbers are no good.
  bool halves(Stretch& s) const {
    if (s.half[0]) return true;
    split(s);
    return finish(*s.half[0]) && finish(*s.half[1]);
  }

  /// Hulls and boxes. False where a weight is not positive.
  bool finish(Stretch& s) const {
    const std::size_t degree =
        std::max({s.exact.center.degree(), s.exact.e2.degree(), s.exact.weight.degree()});
    const auto weight = s.exact.weight.elevated(degree);
    const auto center = s.exact.center.elevated(degree);
    const auto e1 = s.exact.e1.elevated(degree);
    const auto e2 = s.exact.e2.elevated(degree), e3 = s.exact.e3.elevated(degree);
    std::vector<Vector3<double>> rolled;
    if (roll_ != nullptr) {
      const double first = first_[s.piece], length = length_[s.piece];
      rolled = rolled_corners(
          corners_, roll_on(*roll_, s.piece, std::max(0.0, (s.begin - first) / length - margin),
                            std::min(1.0, (s.end - first) / length + margin)));
    }
    for (std::size_t i = 0; i <= degree; ++i) {
      if (!(weight[i] > 0.0)) return false;
      s.spread = std::max(s.spread, s.largest_weight / weight[i]);
      for (const auto& p : roll_ != nullptr ? rolled : corners_) {
        const Vector3<double> at =
            (1.0 / weight[i]) * (center[i] + (p.x * e1[i] + p.y * e2[i] + p.z * e3[i]));
        if (!is_finite(at)) return false;
        s.hull.push_back(at);
        s.sections.add(at);
      }
    }
    for (const auto& c : s.displacement.coefficients()) s.path.add(s.start + c);
    set_advance(s);
    constexpr double half = 0.5;
    s.middle = s.start + s.displacement.value(half);
    s.tangent = s.velocity.value(half);
    return true;
  }

  /// N = r'/|r'|, times |r'|⁴: only the part of r'' across r' carries back.
  static void set_advance(Stretch& s) {
    Box velocity, acceleration;
    for (const auto& c : s.velocity.coefficients()) velocity.add(c);
    for (const auto& c : s.acceleration.coefficients()) acceleration.add(c);
    s.back = cross(velocity, cross(acceleration, velocity));
    double square = 0.0;  // ≤ |r'|²
    for (std::size_t i = 0; i < 3; ++i) {
      const Range v = component(velocity, i);
      if (v.low > 0.0) square += v.low * v.low;
      if (v.high < 0.0) square += v.high * v.high;
    }
    s.advance = square * square;
  }

  /// Whether no section of `a` meets one of a or of its neighbour `b` on account of what is
  /// between, for η in b.
  static bool advances(const Stretch& a, const Stretch& b) {
    double terms = 0.0, most = 0.0;
    for (std::size_t i = 0; i < 3; ++i) {
      const Range t = component(b.back, i);
      terms += (a.sections.size() + b.path.size()) * std::max(std::abs(t.low), std::abs(t.high));
      const Range x{a.sections.low[i] - b.path.high[i], a.sections.high[i] - b.path.low[i]};
      most += times(x, t).high;
    }
    const double spread = std::max(a.spread, b.spread);
    const double least = b.advance - margin * spread * (b.advance + terms);
    if (least > most) return true;
    // Point by point: the box of the sections holds points further out than they.
    for (const auto& p : a.hull) {
      double sum = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        sum += times({p[i] - b.path.high[i], p[i] - b.path.low[i]}, component(b.back, i)).high;
      }
      if (!(least > sum)) return false;
    }
    return true;
  }

  /// Whether a plane lies between the hulls: across one of some directions.
  static bool separated(const Stretch& a, const Stretch& b) {
    const double off =
        margin * std::max(a.spread, b.spread) * std::max(a.sections.size(), b.sections.size());
    for (std::size_t i = 0; i < 3; ++i) {
      if (a.sections.high[i] + off < b.sections.low[i] ||
          b.sections.high[i] + off < a.sections.low[i]) {
        return true;
      }
    }
    const auto unit = [](const Vector3<double>& v) { return (1.0 / norm(v)) * v; };
    const Vector3<double> s = unit(a.tangent), t = unit(b.tangent);
    for (const Vector3<double>& d : {s + t, s, t, b.middle - a.middle}) {
      if (surface_detail::plane_between(a.hull, b.hull, d, off)) return true;
    }
    return false;
  }

  bool closed_, bounded_ = true;
  const FrameRoll* roll_;
  std::vector<Vector3<double>> corners_;
  std::vector<double> first_, length_;  ///< ξ where pieces of the motion begin, and how much there
  std::vector<std::unique_ptr<Stretch>> roots_;
};

}  // namespace

SweepContact contact_of(const Sweep& sweep, double factor) {
  if (sweep.motion.is_adapted() && sweep.profile.is_planar()) {
    return Search(sweep, factor).run();
  }
  return surface_detail::surface_contact(sweep, factor);
}

double largest_free_factor(const Sweep& sweep, const TubeRadius& tube, double most) {
  if (tube.limit == TubeLimit::corner || tube.limit == TubeLimit::standstill) return 0.0;
  constexpr int halvings = 10;
  double low = std::min(most, tube.radius.lower() / outer_radius(sweep)), high = most;
  if (low == most || contact_of(sweep, most).free) return most;
  // Doubled until it is not certified, then bisected.
  for (;;) {
    high = std::min(most, 2.0 * low);
    if (high == most || !contact_of(sweep, high).free) break;
    low = high;
  }
  for (int i = 0; i < halvings; ++i) {
    const double middle = 0.5 * (low + high);
    (contact_of(sweep, middle).free ? low : high) = middle;
  }
  return low;
}

}  // namespace hodograph
