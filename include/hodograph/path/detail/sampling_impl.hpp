// SPDX-License-Identifier: MIT
// The definitions of path/sampling.hpp.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/arc_length_map.hpp"
#include "hodograph/path/sampling.hpp"

namespace hodograph {

namespace sampling_detail {

inline std::optional<Fault> count_fault(std::size_t count, std::size_t least, const char* what) {
  if (count < least) {
    return Fault{FaultCode::too_few,
                 std::string(what) + " must be at least " + std::to_string(least) + "; got " +
                     std::to_string(count),
                 std::nullopt,
                 "count",
                 static_cast<double>(count),
                 static_cast<double>(least)};
  }
  if (count > maximum_sample_count) {
    return Fault{FaultCode::unsupported,
                 std::string(what) + " is at most " + std::to_string(maximum_sample_count) +
                     "; got " + std::to_string(count),
                 std::nullopt,
                 "count",
                 static_cast<double>(count),
                 static_cast<double>(maximum_sample_count)};
  }
  return std::nullopt;
}

/// j-th of `intervals` equal parts of [a, b].
template <class S>
S between(const S& a, const S& b, std::size_t j, std::size_t intervals) {
  return a + (S(static_cast<double>(j)) / S(static_cast<double>(intervals))) * (b - a);
}

/// Halves the intervals of one curve until its chords are near enough.
template <PreimageAlgebra A, std::size_t n>
class ChordSplitter {
 public:
  using S = typename A::Scalar;
  using Point = point_t<A>;
  using Hodograph = BernsteinPolynomial<Point, 2 * n>;
  using Bend = BernsteinPolynomial<Point, (n > 0 ? 2 * n - 1 : 0)>;

  explicit ChordSplitter(const PhCurve<A, n>& curve) {
    const Hodograph hodograph = curve.parameter_step() * curve.hodograph();  // dr/du
    S largest(0);
    const S coordinate = largest_component(curve.start());
    for (const Point& c : hodograph.coefficients()) {
      if (const S size = norm(c); largest < size) largest = size;
    }
    // Points: the rounding of start + displacement at both ends of the chord and at the point
    // itself, the displacement being at most the largest |dr/du|.
    point_error_ = S(2) * (S(accuracy::evaluation_error<S>(2 * n + 1)) * largest +
                           S(epsilon<S>()) * coordinate);
    // r'' sums differences of 2n of these; every halving adds another 2n roundings.
    bend_error_ =
        S(accuracy::evaluation_error<S>(2 * n)) * S(4.0 * static_cast<double>(n)) * largest;
    hodograph_ = hodograph;
  }

  const S& point_error() const { return point_error_; }

  /// Appends the ends (in u) of the intervals; false when there would be more than `room`.
  bool split(const S& tolerance, std::size_t room, std::vector<S>& ends) const {
    std::vector<Piece> open{{hodograph_, hodograph_.derivative(), S(0), S(1), 1}};
    std::size_t count = 0;
    while (!open.empty()) {
      const Piece piece = open.back();
      open.pop_back();
      if (chord_error(piece) + point_error_ <= tolerance) {
        if (++count > room) return false;
        ends.push_back(piece.begin + piece.width);
        continue;
      }
      const S half(0.5), width = half * piece.width;
      const S middle = piece.begin + width;
      if (count + open.size() > room || !(piece.begin < middle)) return false;
      const std::size_t level = piece.level + 1;
      open.push_back({piece.hodograph.restricted(half, S(1)), piece.bend.restricted(half, S(1)),
                      middle, width, level});
      open.push_back({piece.hodograph.restricted(S(0), half), piece.bend.restricted(S(0), half),
                      piece.begin, width, level});
    }
    return true;
  }

 private:
  struct Piece {
    Hodograph hodograph;  ///< dr/du over the piece
    Bend bend;            ///< d²r/du² over the piece
    S begin, width;
    std::size_t level;
  };

  S chord_error(const Piece& piece) const {
    const Point chord = piece.hodograph.integral();  // over the width
    const S length = norm(chord);
    bool advances = S(0) < length;
    for (const Point& c : piece.hodograph.coefficients()) {
      advances = advances && S(0) < dot(c, chord);
    }
    const Point along = advances ? (S(1) / length) * chord : Point{};
    S largest(0);
    for (const Point& c : piece.bend.coefficients()) {
      if (const S size = norm(c - dot(c, along) * along); largest < size) largest = size;
    }
    const S error = S(static_cast<double>(piece.level)) * bend_error_;
    return piece.width * piece.width / S(8) * (largest + error);
  }

  Hodograph hodograph_{};
  S point_error_{}, bend_error_{};
};

}  // namespace sampling_detail

template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_even_in_xi(const Path<A, n>& path,
                                                              std::size_t count) {
  using S = typename A::Scalar;
  if (auto fault = sampling_detail::count_fault(count, 2, "the number of points")) return *fault;
  std::vector<S> result(count);
  for (std::size_t j = 0; j + 1 < count; ++j) {
    result[j] =
        path.clamped(sampling_detail::between(path.xi_begin(), path.xi_end(), j, count - 1));
  }
  result.back() = path.xi_end();
  return result;
}

template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_even_in_arc_length(const Path<A, n>& path,
                                                                      std::size_t count) {
  using S = typename A::Scalar;
  if (auto fault = sampling_detail::count_fault(count, 2, "the number of points")) return *fault;
  std::vector<S> result(count);
  const S& length = path.arc_length();
  for (std::size_t j = 0; j + 1 < count; ++j) {
    const S s = sampling_detail::between(S(0), length, j, count - 1);
    result[j] = parameter_at_arc_length(path, length < s ? length : s);
  }
  result.front() = path.xi_begin();
  result.back() = path.xi_end();
  return result;
}

template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_by_arc_length_step(
    const Path<A, n>& path, const typename A::Scalar& step) {
  using S = typename A::Scalar;
  if (!is_finite(step) || !(S(0) < step)) {
    return Fault{FaultCode::outside_domain,
                 "a step is a finite positive number; got " + to_text(to_double(step)),
                 std::nullopt,
                 "step",
                 to_double(step),
                 0.0};
  }
  const S& length = path.arc_length();
  const double steps = to_double(S(length / step));
  if (!(steps < static_cast<double>(maximum_sample_count))) {
    return Fault{FaultCode::unsupported,
                 "steps of " + to_text(to_double(step)) + " along " + to_text(to_double(length)) +
                     " are more than " + std::to_string(maximum_sample_count) + " points",
                 std::nullopt,
                 "step",
                 to_double(step),
                 static_cast<double>(maximum_sample_count)};
  }
  std::vector<S> result{path.xi_begin()};
  // A step that ends within rounding of the path's end is the end.
  const S last = length - S(4) * S(epsilon<S>()) * length;
  for (std::size_t j = 1;; ++j) {
    const S s = S(static_cast<double>(j)) * step;
    if (!(s < last)) break;
    result.push_back(parameter_at_arc_length(path, s));
  }
  result.push_back(path.xi_end());
  return result;
}

template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> parameters_per_segment(const Path<A, n>& path,
                                                               std::size_t count) {
  using S = typename A::Scalar;
  if (auto fault = sampling_detail::count_fault(count, 1, "the number of points in a segment")) {
    return *fault;
  }
  if (count > maximum_sample_count / path.segment_count()) {
    return *sampling_detail::count_fault(maximum_sample_count + 1, 1, "the number of points");
  }
  std::vector<S> result;
  result.reserve(count * path.segment_count() + 1);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const S &a = path.knots()[k], &b = path.knots()[k + 1];
    for (std::size_t j = 0; j < count; ++j) {
      const S xi = sampling_detail::between(a, b, j, count);
      result.push_back(b < xi ? b : xi);
    }
  }
  result.push_back(path.xi_end());
  return result;
}

template <PreimageAlgebra A, std::size_t n>
Result<std::vector<typename A::Scalar>> polyline_parameters(const Path<A, n>& path,
                                                            const typename A::Scalar& tolerance) {
  using S = typename A::Scalar;
  if (!is_finite(tolerance) || !(S(0) < tolerance)) {
    return Fault{FaultCode::outside_domain,
                 "a tolerance is a finite positive number; got " + to_text(to_double(tolerance)),
                 std::nullopt,
                 "tolerance",
                 to_double(tolerance),
                 0.0};
  }
  std::vector<S> result{path.xi_begin()}, ends;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const sampling_detail::ChordSplitter<A, n> splitter(path.segment(k));
    if (!(splitter.point_error() < tolerance)) {
      return Fault{FaultCode::tolerance_not_reached,
                   "a chord tolerance of " + to_text(to_double(tolerance)) +
                       " is below the rounding of the points of segment " + std::to_string(k) +
                       ", " + to_text(to_double(splitter.point_error())),
                   k,
                   "tolerance",
                   to_double(tolerance),
                   to_double(splitter.point_error())};
    }
    ends.clear();
    if (!splitter.split(tolerance, maximum_sample_count - result.size(), ends)) {
      return Fault{FaultCode::tolerance_not_reached,
                   "a chord tolerance of " + to_text(to_double(tolerance)) + " needs more than " +
                       std::to_string(maximum_sample_count) + " points",
                   k,
                   "tolerance",
                   to_double(tolerance),
                   static_cast<double>(maximum_sample_count)};
    }
    for (const S& u : ends) result.push_back(path.xi_of({k, u}));
  }
  return result;
}

template <PreimageAlgebra A, std::size_t n>
std::vector<point_t<A>> points_at(const Path<A, n>& path,
                                  std::span<const typename A::Scalar> parameters) {
  std::vector<point_t<A>> result;
  result.reserve(parameters.size());
  for (const auto& xi : parameters) result.push_back(path.position(xi));
  return result;
}

}  // namespace hodograph
