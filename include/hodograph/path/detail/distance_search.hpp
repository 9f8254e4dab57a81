// SPDX-License-Identifier: MIT
// How stationary points and the nearest point of a path are found from those of its segments.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/detail/segment_distance.hpp"
#include "hodograph/path/path.hpp"
#include "hodograph/path/stationary_point.hpp"

namespace hodograph::path_detail {

template <class Point>
std::optional<Fault> query_fault(const Point& q) {
  for (std::size_t j = 0; j < Point::dimension; ++j) {
    if (!std::isfinite(q[j])) {
      return Fault{FaultCode::not_finite,
                   "coordinate " + std::to_string(j) +
                       " of the query point is infinite or not a number; it must be finite",
                   j,
                   "query_point",
                   std::nullopt,
                   std::nullopt};
    }
  }
  return std::nullopt;
}

/// ξ of the local parameters u of segment k, kept between its knots.
template <class A, std::size_t n>
Enclosure xi_range(const Path<A, n>& path, std::size_t k, const Enclosure& u) {
  const double low = path.knots()[k], high = path.knots()[k + 1];
  const Enclosure xi = Enclosure(low) + u * Enclosure(path.segment(k).parameter_step());
  return {u.lower() == 0.0 ? low : std::clamp(xi.lower(), low, high),
          u.upper() == 1.0 ? high : std::clamp(xi.upper(), low, high)};
}

/// A zero, a kink, or several of them that rounding cannot tell apart.
struct Stationary {
  std::size_t segment;  ///< of the representative
  double u;
  Enclosure xi;
  int sign_before, sign_after;
  bool reaches_end;  ///< of its segment, within the rounding of the join there
};

inline StationaryKind kind_of(int sign_before, int sign_after) {
  if (sign_before < 0 && sign_after > 0) return StationaryKind::minimum;
  if (sign_before > 0 && sign_after < 0) return StationaryKind::maximum;
  return StationaryKind::undecided;
}

template <class A, std::size_t n>
StationaryPoint<point_t<A>> evaluated(const Path<A, n>& path, const point_t<A>& q,
                                      std::size_t segment, double u, const Enclosure& xi,
                                      StationaryKind kind) {
  StationaryPoint<point_t<A>> result;
  result.xi = std::clamp(path.xi_of({segment, u}), xi.lower(), xi.upper());
  result.xi_range = xi;
  result.point = path.segment(segment).position(u);
  result.distance = safe_norm(result.point - q);
  result.kind = kind;
  return result;
}

/// The walk along a path that collects stationary points and settles what happens at knots.
template <class A, std::size_t n>
class StationaryWalk {
 public:
  StationaryWalk(const Path<A, n>& path, const point_t<A>& q) : path_(path), q_(q) {}

  std::vector<StationaryPoint<point_t<A>>> run() {
    for (std::size_t k = 0; k < path_.segment_count(); ++k) {
      const SegmentDistance<A, n> distance(path_.segment(k), q_);
      if (k == 0) {
        first_sign_ = distance.first_sign();
        first_reach_ = distance.join_reach(false);
      }
      add_segment(k, distance);
      last_sign_ = distance.last_sign();
      last_reach_ = distance.join_reach(true);
    }
    path_.is_closed() ? close() : add_ends();
    std::vector<StationaryPoint<point_t<A>>> result;
    for (const Stationary& s : found_) {
      result.push_back(
          evaluated(path_, q_, s.segment, s.u, s.xi, kind_of(s.sign_before, s.sign_after)));
    }
    return result;
  }

 private:
  void add_segment(std::size_t k, const SegmentDistance<A, n>& distance) {
    const std::vector<IsolatedRoot> roots = distance.roots();
    const int sign = distance.first_sign();
    const bool has_knot = k > 0;
    // Both sides must be within rounding for a zero to be the same as one on the other side.
    const double right_reach = has_knot ? distance.join_reach(false) : 0.0;
    const bool rounded = has_knot && last_reach_ > 0.0 && right_reach > 0.0;
    const double end_reach = distance.join_reach(true);
    std::size_t next = 0;
    if (has_knot) {
      std::vector<Stationary> same;
      while (!found_.empty() && found_.back().segment + 1 == k && found_.back().reaches_end &&
             (rounded || found_.back().xi.upper() == path_.knots()[k])) {
        same.insert(same.begin(), found_.back());
        found_.pop_back();
      }
      const bool bracketed = last_sign_ * sign < 0;
      const std::size_t left = same.size();
      if (bracketed) same.push_back(at_knot(k, last_sign_, sign));
      while (next < roots.size() &&
             (roots[next].u.lower() == 0.0 || (rounded && roots[next].u.lower() <= right_reach))) {
        same.push_back(made(k, roots[next++], end_reach));
      }
      if (!same.empty()) found_.push_back(merged(k, same, left, bracketed, sign));
    }
    for (; next < roots.size(); ++next) found_.push_back(made(k, roots[next], end_reach));
  }

  Stationary made(std::size_t k, const IsolatedRoot& root, double end_reach) const {
    return {k,
            root.u.middle(),
            xi_range(path_, k, root.u),
            root.sign_before,
            root.sign_after,
            root.u.upper() >= 1.0 - end_reach};
  }
  Stationary at_knot(std::size_t k, int before, int after) const {
    return {k, 0.0, Enclosure(path_.knots()[k]), before, after, false};
  }

  /// What is the same within rounding about knot k, in order, `left` of them before it: one entry.
  Stationary merged(std::size_t k, const std::vector<Stationary>& same, std::size_t left,
                    bool bracketed, int sign) const {
    const std::size_t right = same.size() - left - (bracketed ? 1 : 0);
    Stationary result = same.front();
    result.sign_after = same.back().sign_after;
    result.reaches_end = same.back().reaches_end;
    for (const Stationary& s : same) result.xi = Enclosure::hull(result.xi, s.xi);
    const double knot = path_.knots()[k];
    // On the side where nothing was found the sign is that at the knot.
    if (right == 0 && result.xi.upper() == knot) result.sign_after = sign;
    if (left == 0 && result.xi.lower() == knot) result.sign_before = last_sign_;
    if (same.size() > 1 && result.xi.width() < same_place * path_.segment(k).parameter_step()) {
      result.segment = k;
      result.u = 0.0;
    } else if (right > 0) {
      result.segment = same.back().segment;
      result.u = same.back().u;
    }
    return result;
  }

  /// Both ends of an open path: the sign on the inner side decides.
  void add_ends() {
    if (!found_.empty() && found_.front().xi.lower() == path_.xi_begin()) {
      found_.front().sign_before = -found_.front().sign_after;
    } else {
      found_.insert(found_.begin(), at_knot(0, -first_sign_, first_sign_));
    }
    if (!found_.empty() && found_.back().xi.upper() == path_.xi_end()) {
      found_.back().sign_after = -found_.back().sign_before;
    } else {
      const std::size_t last = path_.segment_count() - 1;
      found_.push_back({last, 1.0, Enclosure(path_.xi_end()), last_sign_, -last_sign_, true});
    }
  }

  /// The knot where a closed path begins and ends.
  void close() {
    const bool rounded = first_reach_ > 0.0 && last_reach_ > 0.0;
    const auto at_begin = [&](const Stationary& s) {
      return s.xi.lower() == path_.xi_begin() ||
             (rounded && s.segment == 0 &&
              s.xi.lower() <= xi_range(path_, 0, first_reach_).upper());
    };
    const auto at_end = [&](const Stationary& s) {
      return s.xi.upper() == path_.xi_end() ||
             (rounded && s.segment + 1 == path_.segment_count() && s.reaches_end);
    };
    const bool begins = !found_.empty() && at_begin(found_.front());
    const bool ends = !found_.empty() && at_end(found_.back());
    if (!begins && !ends) {
      if (first_sign_ * last_sign_ < 0) {
        found_.insert(found_.begin(), at_knot(0, last_sign_, first_sign_));
      }
    } else if (begins && ends && found_.size() > 1) {
      // The same point: it stays at the beginning, unless it is the end of a long stretch.
      found_.front().sign_before = found_.back().sign_before;
      if (found_.back().xi.width() < same_place * path_.segments().back().parameter_step()) {
        found_.pop_back();
      } else {
        found_.back().sign_after = found_.front().sign_after;
      }
    } else if (begins && !ends) {
      if (found_.front().xi.lower() == path_.xi_begin()) found_.front().sign_before = last_sign_;
    } else if (ends && !begins) {
      if (found_.back().xi.upper() == path_.xi_end()) found_.back().sign_after = first_sign_;
    }
  }

  /// Entries narrower than this fraction of a segment are points; wider ones are stretches.
  static constexpr double same_place = 0x1.0p-8;

  const Path<A, n>& path_;
  const point_t<A>& q_;
  std::vector<Stationary> found_;
  int first_sign_ = 0, last_sign_ = 0;
  double first_reach_ = 0.0, last_reach_ = 0.0;
};

template <class A, std::size_t n>
std::vector<StationaryPoint<point_t<A>>> all_stationary_points(const Path<A, n>& path,
                                                               const point_t<A>& q) {
  return StationaryWalk<A, n>(path, q).run();
}

/// A place that may be the nearest.
struct NearestCandidate {
  std::size_t segment = 0;
  Enclosure u;
  Enclosure distance{std::numeric_limits<double>::max(), std::numeric_limits<double>::infinity()};
  StationaryKind kind = StationaryKind::minimum;
  bool is_certain = false;  ///< a zero of (r - q)·r' that is a minimum for certain
};

template <class Point>
struct NearestFound {
  StationaryPoint<Point> at;
  Enclosure distance;
};

/// Segments in the order of their quick bounds, until these exceed the best distance found.
template <class A, std::size_t n>
NearestFound<point_t<A>> search_nearest(const Path<A, n>& path, const point_t<A>& q) {
  using Entry = std::pair<double, std::size_t>;
  std::vector<Entry> heap;
  heap.reserve(path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    heap.push_back({quick_distance_bound(path.segment(k), q), k});
  }
  const auto later = [](const Entry& a, const Entry& b) { return b < a; };
  std::make_heap(heap.begin(), heap.end(), later);

  NearestCandidate best;
  double least = std::numeric_limits<double>::infinity();
  const auto consider = [&](const NearestCandidate& c) {
    least = std::min(least, c.distance.lower());
    // A certain minimum is preferred to an end of a segment that is as near within rounding.
    const bool replaces = c.is_certain == best.is_certain
                              ? c.distance.upper() < best.distance.upper()
                          : c.is_certain ? c.distance.lower() <= best.distance.upper()
                                         : c.distance.upper() < best.distance.lower();
    if (replaces) best = c;
  };
  double most = std::numeric_limits<double>::infinity();
  while (!heap.empty() && heap.front().first <= most) {
    std::pop_heap(heap.begin(), heap.end(), later);
    const std::size_t k = heap.back().second;
    heap.pop_back();
    const SegmentDistance<A, n> distance(path.segment(k), q);
    for (const double end : {0.0, 1.0}) {
      consider({k, Enclosure(end), distance.distance(end), StationaryKind::minimum, false});
      most = std::min(most, distance.distance(end).upper());
    }
    for (const IsolatedRoot& root : distance.roots()) {
      const StationaryKind kind = kind_of(root.sign_before, root.sign_after);
      if (kind == StationaryKind::maximum) continue;
      const NearestCandidate c{k, root.u, distance.least_distance(root.u), kind,
                               kind == StationaryKind::minimum};
      consider(c);
      most = std::min(most, c.distance.upper());
    }
  }
  const Enclosure xi = xi_range(path, best.segment, best.u);
  return {evaluated(path, q, best.segment, best.u.middle(), xi, best.kind), {least, most}};
}

}  // namespace hodograph::path_detail
