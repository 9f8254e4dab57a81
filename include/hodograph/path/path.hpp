// SPDX-License-Identifier: MIT
// The path: PH curves in sequence on knots. Every construction returns one; everything downstream
// is written against it.
#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "hodograph/curve/ph_curve.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/path/arc_length_table.hpp"
#include "hodograph/path/detail/compiled_degrees.hpp"
#include "hodograph/path/detail/knots_fault.hpp"
#include "hodograph/path/interval_index.hpp"

namespace hodograph {

namespace path_detail {
/// Throws Error outside_domain: the quantity x lies outside [low, high].
[[noreturn]] void throw_outside(double x, double low, double high, const char* quantity);
}  // namespace path_detail

/// A place on a path: the segment and its local parameter u in [0, 1].
template <class S>
struct PathLocation {
  std::size_t segment;
  S u;
};

/// PH curves of one preimage degree, joined in position, on strictly increasing knots
/// ξ_0 < ... < ξ_N; open or closed. Immutable once made.
///
/// A query outside [ξ_0, ξ_N] (or [0, total arc length]), or with a NaN, throws Error with
/// code outside_domain; `clamped` and `wrapped` bring a parameter inside on purpose.
template <PreimageAlgebra A, std::size_t n>
class Path {
 public:
  using Algebra = A;
  using Scalar = typename A::Scalar;
  using Point = point_t<A>;
  using Curve = PhCurve<A, n>;
  using Location = PathLocation<Scalar>;
  static constexpr std::size_t preimage_degree = n;

  /// A path from its knots and segments.
  /// Faults: too_few (no segment), mismatched_size (knots ≠ segments + 1), not_increasing (knots,
  /// with the index; a segment whose parameter step is not its knot difference), not_finite (with
  /// the index), not_continuous (a segment that does not start where the one before it ends,
  /// within accuracy::join_error of the largest coordinate or displacement there; for a closed path
  /// also the last and the first).
  static Result<Path> create(std::vector<Scalar> knots, std::vector<Curve> segments, bool closed);

  std::size_t segment_count() const { return segments_.size(); }
  const std::vector<Scalar>& knots() const { return knots_; }
  const std::vector<Curve>& segments() const { return segments_; }
  const Curve& segment(std::size_t k) const { return segments_[k]; }
  bool is_closed() const { return closed_; }

  /// The first and the last knot.
  const Scalar& xi_begin() const { return knots_.front(); }
  const Scalar& xi_end() const { return knots_.back(); }
  /// The arc length at each knot, from 0.
  const std::vector<Scalar>& knot_arc_lengths() const { return arc_lengths_; }
  /// The arc length of the whole path: the exact polynomial's value, summed with compensation.
  const Scalar& arc_length() const { return arc_lengths_.back(); }

  /// The segment that holds ξ (the later one at a knot) and the local parameter there.
  Location locate(const Scalar& xi) const {
    require_inside(xi, xi_begin(), xi_end(), "path parameter xi");
    const std::size_t k = xi_index_.find(knots_, xi);
    return {k, local_parameter(k, xi)};
  }
  /// The segment within which the arc length s is reached (the later one at a knot).
  std::size_t segment_at_arc_length(const Scalar& s) const {
    require_inside(s, Scalar(0), arc_length(), "arc length");
    return arc_length_index_.find(arc_lengths_, s);
  }
  /// What arc_length_map.hpp starts from in segment k.
  const ArcLengthTable& arc_length_table(std::size_t k) const { return arc_length_tables_[k]; }
  /// ξ of a location.
  Scalar xi_of(const Location& at) const {
    if (at.u == Scalar(1)) return knots_[at.segment + 1];
    const Scalar xi = knots_[at.segment] + at.u * segments_[at.segment].parameter_step();
    return knots_[at.segment + 1] < xi ? knots_[at.segment + 1] : xi;
  }

  /// ξ brought into [ξ_0, ξ_N] by clamping.
  Scalar clamped(const Scalar& xi) const {
    return xi < xi_begin() ? xi_begin() : xi_end() < xi ? xi_end() : xi;
  }
  /// ξ brought into [ξ_0, ξ_N) by whole periods ξ_N - ξ_0.
  Scalar wrapped(const Scalar& xi) const {
    using std::floor;
    const Scalar period = xi_end() - xi_begin();
    const Scalar inside = xi - floor((xi - xi_begin()) / period) * period;
    return inside < xi_begin() || !(inside < xi_end()) ? xi_begin() : inside;
  }

  /// r(ξ), the derivatives of the preimage, speed and arc length; see PhCurve for the formulas.
  Point position(const Scalar& xi) const {
    const Location at = locate(xi);
    return segments_[at.segment].position(at.u);
  }
  A preimage(const Scalar& xi) const {
    const Location at = locate(xi);
    return segments_[at.segment].preimage().value(at.u);
  }
  template <std::size_t K>
  PreimageJet<A, K> preimage_jet(const Scalar& xi) const {
    const Location at = locate(xi);
    return segments_[at.segment].template preimage_jet<K>(at.u);
  }
  Scalar speed(const Scalar& xi) const {
    const Location at = locate(xi);
    return segments_[at.segment].speed(at.u);
  }
  Scalar arc_length(const Scalar& xi) const { return arc_length(locate(xi)); }
  Scalar arc_length(const Location& at) const {
    if (at.u == Scalar(1)) return arc_lengths_[at.segment + 1];
    return arc_lengths_[at.segment] + segments_[at.segment].arc_length(at.u);
  }
  Point position(const Location& at) const { return segments_[at.segment].position(at.u); }
  /// r and its derivatives r', ..., r^(K) with respect to ξ.
  template <std::size_t K>
  std::array<Point, K + 1> position_derivatives(const Scalar& xi) const {
    const Location at = locate(xi);
    std::array<Point, K + 1> result;
    result[0] = segments_[at.segment].position(at.u);
    if constexpr (K > 0) {
      const auto jet = segments_[at.segment].template preimage_jet<K - 1>(at.u);
      const auto derivatives = hodograph_derivatives(jet);
      for (std::size_t r = 0; r < K; ++r) result[r + 1] = derivatives[r];
    }
    return result;
  }

  /// Bytes held, and the part of them that are the coefficients of the preimage, displacement and
  /// arc-length polynomials.
  std::size_t memory() const {
    return segments_.capacity() * sizeof(Curve) +
           arc_length_tables_.capacity() * sizeof(ArcLengthTable) +
           (knots_.capacity() + arc_lengths_.capacity()) * sizeof(Scalar) + xi_index_.memory() +
           arc_length_index_.memory();
  }
  std::size_t coefficient_memory() const {
    return segments_.size() * (sizeof(typename Curve::Preimage) +
                               (Curve::degree + 1) * (sizeof(Point) + sizeof(Scalar)));
  }

  friend bool operator==(const Path& a, const Path& b) {
    return a.closed_ == b.closed_ && a.knots_ == b.knots_ && a.segments_ == b.segments_;
  }

 private:
  Path() = default;

  static void require_inside(const Scalar& x, const Scalar& low, const Scalar& high,
                             const char* quantity) {
    if (!(low <= x && x <= high))
      path_detail::throw_outside(to_double(x), to_double(low), to_double(high), quantity);
  }
  // The parameter step is the difference of the knots (create checks it), and rounding is monotone:
  // the quotient is at most 1.
  Scalar local_parameter(std::size_t k, const Scalar& xi) const {
    return (xi - knots_[k]) / (knots_[k + 1] - knots_[k]);
  }

  bool closed_ = false;
  std::vector<Scalar> knots_, arc_lengths_;
  std::vector<Curve> segments_;
  std::vector<ArcLengthTable> arc_length_tables_;
  IntervalIndex<Scalar> xi_index_, arc_length_index_;
};

template <std::size_t n, class S = double>
using PlanarPath = Path<Complex<S>, n>;
template <std::size_t n, class S = double>
using SpatialPath = Path<Quaternion<S>, n>;

// ------------------------------------------------------------------------------------------------

namespace path_detail {

/// The fault of a join that does not meet, if there is one.
template <class Curve>
std::optional<Fault> join_fault(const Curve& before, const Curve& after, std::size_t knot) {
  using S = typename Curve::Scalar;
  const auto gap = largest_component(after.start() - before.end());
  S scale = largest_component(before.end());
  if (gap <= S(accuracy::join_error<S>()) * scale) return std::nullopt;
  for (const Curve* curve : {&before, &after}) {
    for (const auto& c : curve->integral().coefficients()) {
      if (const S size = largest_component(c.displacement); scale < size) scale = size;
    }
  }
  const S allowed = S(accuracy::join_error<S>()) * scale;
  if (!(allowed < gap)) return std::nullopt;
  return Fault{FaultCode::not_continuous,
               "the path is torn at knot " + std::to_string(knot) + ": the segments are " +
                   to_text(to_double(gap)) + " apart, at most " + to_text(to_double(allowed)) +
                   " is rounding",
               knot,
               "gap",
               to_double(gap),
               to_double(allowed)};
}

}  // namespace path_detail

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> Path<A, n>::create(std::vector<Scalar> knots, std::vector<Curve> segments,
                                      bool closed) {
  if (segments.empty()) {
    return Fault{FaultCode::too_few,
                 "a path needs at least one segment; got none",
                 std::nullopt,
                 "segments",
                 0.0,
                 1.0};
  }
  if (knots.size() != segments.size() + 1) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(segments.size()) + " segments need " +
                     std::to_string(segments.size() + 1) + " knots; got " +
                     std::to_string(knots.size()),
                 std::nullopt,
                 "knots",
                 static_cast<double>(knots.size()),
                 static_cast<double>(segments.size() + 1)};
  }
  if (auto fault = path_detail::knots_fault<Scalar>(knots)) return *std::move(fault);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (!(segments[k - 1].parameter_step() == knots[k] - knots[k - 1])) {
      return path_detail::fault_at(
          FaultCode::not_increasing, k - 1, "parameter_step",
          to_double(segments[k - 1].parameter_step()),
          "segment " + std::to_string(k - 1) + " covers a parameter step of " +
              to_text(to_double(segments[k - 1].parameter_step())) + " between knots " +
              to_text(to_double(knots[k] - knots[k - 1])) + " apart");
    }
  }

  Path path;
  path.arc_lengths_.resize(knots.size());
  Scalar sum(0), compensation(0);  // Neumaier's summation: one rounding in all
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const Curve& curve = segments[k];
    if (!is_finite(curve.start()) || !is_finite(curve.end()) || !is_finite(curve.arc_length())) {
      return path_detail::fault_at(
          FaultCode::not_finite, k, "segment", to_double(curve.arc_length()),
          "segment " + std::to_string(k) + " has a coefficient that is infinite or not a number");
    }
    if (k > 0) {
      if (auto fault = path_detail::join_fault(segments[k - 1], curve, k)) return *fault;
    }
    const Scalar length = curve.arc_length();
    const Scalar next = sum + length;
    compensation = compensation + (sum < length ? (length - next) + sum : (sum - next) + length);
    sum = next;
    const Scalar total = sum + compensation;
    path.arc_lengths_[k + 1] = total < path.arc_lengths_[k] ? path.arc_lengths_[k] : total;
    if (!is_finite(total)) {
      return path_detail::fault_at(FaultCode::not_finite, k, "arc_length", to_double(length),
                                   "the arc length up to the end of segment " + std::to_string(k) +
                                       " exceeds the range of numbers");
    }
  }
  if (closed) {
    if (auto fault = path_detail::join_fault(segments.back(), segments.front(), 0)) return *fault;
  }
  path.arc_length_tables_.reserve(segments.size());
  for (const Curve& curve : segments) path.arc_length_tables_.emplace_back(curve);
  path.closed_ = closed;
  path.xi_index_ = IntervalIndex<Scalar>(knots);
  path.arc_length_index_ = IntervalIndex<Scalar>(path.arc_lengths_);
  path.knots_ = std::move(knots);
  path.segments_ = std::move(segments);
  return path;
}

#define HODOGRAPH_COMPILED_PATH(prefix, n)                       \
  prefix template Result<PlanarPath<n>> PlanarPath<n>::create(   \
      std::vector<double>, std::vector<PlanarPhCurve<n>>, bool); \
  prefix template Result<SpatialPath<n>> SpatialPath<n>::create( \
      std::vector<double>, std::vector<SpatialPhCurve<n>>, bool);
HODOGRAPH_FOR_COMPILED_DEGREES(HODOGRAPH_COMPILED_PATH, extern)

}  // namespace hodograph
