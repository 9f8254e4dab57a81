// SPDX-License-Identifier: MIT
// The search behind arc_length_map.hpp, where its laws and the reasons for them stand.
#pragma once

#include <type_traits>

#include "hodograph/path/arc_length_map.hpp"

namespace hodograph {

namespace arc_length_detail {

/// D: cells of width 2^-D. The tangent misses the curve by at most 2^-2D |s''|/2 within a cell,
/// and |s''| ≤ 4n h max|A_i|².
template <class S>
constexpr int cell_bits() {
  return std::numeric_limits<real_of_t<S>>::digits / 2 + 4;
}

/// 2^bits, exactly.
template <class S>
constexpr S power_of_two(int bits) {
  S result(1);
  for (; bits >= 30; bits -= 30) result = result * S(1073741824.0);
  return result * S(static_cast<double>(std::int64_t{1} << bits));
}

/// The largest whole number that is at most x, 0 ≤ x < 2^(cell bits).
inline double whole_part(double x) { return static_cast<double>(static_cast<std::int64_t>(x)); }
template <class S>
S whole_part(const S& x) {
  using std::floor;
  return S(floor(value_of(x)));
}

/// The descent of the search tree: the last whole j with ŝ(j 2^-D) ≤ t along it.
template <class Curve, class S = typename Curve::Scalar>
S descend(const Curve& curve, const S& t, const S& cells) {
  S low(0), high = cells;
  for (int level = 0; level < cell_bits<S>(); ++level) {
    const S middle = (low + high) * S(0.5);
    if (curve.evaluate_speed(middle / cells).integral.arc_length <= t) {
      low = middle;
    } else {
      high = middle;
    }
  }
  return low;
}

/// A bracket of nodes and the next trial within it.
template <class S>
struct Bracket {
  S low{0}, high;
  /// Notes that the root lies above (below) u; the trial itself where it is inside, else the
  /// middle.
  S next(bool above, const S& u, const S& trial) {
    (above ? low : high) = u;
    return low <= trial && trial <= high ? trial : S((low + high) * S(0.5));
  }
};

constexpr int most_steps = 8;  // Halley's iteration settles in 1 to 4; then the descent decides

/// The length still to go from a point of a curve, and Newton's and Halley's steps to there.
template <class S>
struct Steps {
  S rest, slope, newton, bend;  // bend: newton s''/(2 s')
  template <class Curve, class A>
  [[gnu::always_inline]] Steps(const Curve& curve, const CurvePoint<A>& at, const S& t)
      : rest(t - at.integral.arc_length),
        slope(curve.parameter_step() * speed_form(at.preimage, at.preimage)) {
    const S reciprocal = S(1) / slope;
    const S turn = curve.parameter_step() * speed_form(at.preimage, at.preimage_rate);  // s''/2
    newton = rest * reciprocal;
    bend = newton * (turn * reciprocal);
  }
  S halley() const { return newton / (S(1) + bend); }
  /// The same up to terms of third order, without a division: for small steps.
  S small_step() const { return newton - newton * bend; }
};

/// u of the arc length t from the first guess u. Domain: 0 < t < curve.arc_length().
template <PreimageAlgebra A, std::size_t n>
typename A::Scalar search(const PhCurve<A, n>& curve, const typename A::Scalar& t,
                          typename A::Scalar u) {
  using S = typename A::Scalar;
  const S cells = power_of_two<S>(cell_bits<S>()), width = S(1) / cells;
  const S margin = S(real_of_t<S>(2) * accuracy::arc_length_error<S>(n)) *
                   (curve.parameter_step() * curve.speed_bound());
  Bracket<S> bracket{S(0), S(1)};
  for (int step = 0; step < most_steps; ++step) {
    S node = whole_part(S(u * cells)) * width;
    if (!(node < S(1))) node = S(1) - width;
    const Steps<S> to(curve, curve.evaluate_speed(node), t);
    const S beyond = to.slope * width - to.rest;
    // The proof of the cell: margins on both sides; none is needed at the ends of the curve.
    if ((margin < to.rest || (node == S(0) && !(to.rest < S(0)))) &&
        (margin < beyond || (node + width == S(1) && !(beyond < S(0))))) {
      return node + (to.newton < width ? to.newton : width);
    }
    if (-margin < to.rest && -margin < beyond) break;  // too close to a node to tell
    u = bracket.next(S(0) < to.rest, node, node + to.halley());
  }
  const S node = descend(curve, t, cells) * width;
  const Steps<S> to(curve, curve.evaluate_speed(node), t);
  return node + (to.newton < width ? to.newton : width);
}

/// How many derivatives a scalar carries: S::order, or one, as dual numbers do.
template <class S>
constexpr std::size_t derivatives_of = 1;
template <class S>
  requires requires { S::order; }
constexpr std::size_t derivatives_of<S> = S::order;

/// u, whose value is that of the arc length t, with the derivatives that t and the curve carry:
/// every Newton step in the scalar's own arithmetic doubles the number of those that are right.
/// Where the curve stands still they do not exist, and u stays as it is.
template <PreimageAlgebra A, std::size_t n>
typename A::Scalar with_derivatives(const PhCurve<A, n>& curve, typename A::Scalar u,
                                    const typename A::Scalar& t) {
  using S = typename A::Scalar;
  if constexpr (!std::is_same_v<S, real_of_t<S>>) {
    for (std::size_t right = 1; right <= derivatives_of<S>; right *= 2) {
      const S step = Steps<S>(curve, curve.evaluate_speed(u), t).newton;
      if (!is_finite(step)) break;
      u = u + (step - S(value_of(step)));
    }
  }
  return u;
}

/// The same from t = s less the length of the segments before; the ends of a curve need no search.
template <PreimageAlgebra A, std::size_t n>
typename A::Scalar parameter_at(const PhCurve<A, n>& curve, const ArcLengthTable& table,
                                const typename A::Scalar& t) {
  using S = typename A::Scalar;
  if (!(S(0) < t)) return with_derivatives(curve, S(0), t);
  if (!(t < curve.arc_length())) return with_derivatives(curve, S(1), t);
  return with_derivatives(curve, search(curve, t, S(table.guess(to_double(t)))), t);
}

/// The point at the arc length t from the start of the curve. From a point within 2^-18 of it,
/// steps and the Taylor polynomial of degree two leave out terms of size 2^-54.
template <PreimageAlgebra A, std::size_t n>
point_t<A> point_at(const PhCurve<A, n>& curve, const ArcLengthTable& table,
                    const typename A::Scalar& t) {
  using S = typename A::Scalar;
  using std::abs;
  if constexpr (!std::is_same_v<S, real_of_t<S>>) {  // as many derivatives as the scalar carries
    return curve.position(parameter_at(curve, table, t));
  }
  if (!(S(0) < t)) return curve.start();
  if (!(t < curve.arc_length())) return curve.end();
  const S reach = S(1) / power_of_two<S>(std::numeric_limits<real_of_t<S>>::digits / 3 + 1);
  const S& h = curve.parameter_step();
  S u(table.guess(to_double(t)));
  Bracket<S> bracket{S(0), S(1)};
  for (int step = 0; step < most_steps; ++step) {
    const CurvePoint<A> at = curve.evaluate(u);
    const Steps<S> to(curve, at, t);
    if (abs(to.newton) <= reach) {
      const S du = to.small_step();
      const auto first = hodograph_form(at.preimage, at.preimage);
      const auto second = hodograph_form(at.preimage, at.preimage_rate);
      return curve.start() + (at.integral.displacement + (h * du) * (first + du * second));
    }
    u = bracket.next(S(0) < to.rest, u, u + to.halley());
  }
  return curve.position(search(curve, t, u));
}

}  // namespace arc_length_detail

template <PreimageAlgebra A, std::size_t n>
typename A::Scalar parameter_at_arc_length(const PhCurve<A, n>& curve,
                                           const typename A::Scalar& s) {
  return arc_length_detail::parameter_at(curve, ArcLengthTable(curve), s);
}

template <PreimageAlgebra A, std::size_t n>
PathLocation<typename A::Scalar> location_at_arc_length(const Path<A, n>& path,
                                                        const typename A::Scalar& s) {
  using S = typename A::Scalar;
  const std::size_t k = path.segment_at_arc_length(s);
  const auto& curve = path.segment(k);
  const S t = s - path.knot_arc_lengths()[k];
  if (s == path.arc_length()) return {k, arc_length_detail::with_derivatives(curve, S(1), t)};
  return {k, arc_length_detail::parameter_at(curve, path.arc_length_table(k), t)};
}

template <PreimageAlgebra A, std::size_t n>
typename A::Scalar parameter_at_arc_length(const Path<A, n>& path, const typename A::Scalar& s) {
  using S = typename A::Scalar;
  const auto at = location_at_arc_length(path, s);
  if constexpr (!std::is_same_v<S, real_of_t<S>>) {
    if (at.u == S(1)) {  // the knot, and the derivatives of what is behind it
      return path.knots()[at.segment + 1] +
             (at.u - S(1)) * path.segment(at.segment).parameter_step();
    }
  }
  return path.xi_of(at);
}

template <PreimageAlgebra A, std::size_t n>
point_t<A> point_at_arc_length(const Path<A, n>& path, const typename A::Scalar& s) {
  using S = typename A::Scalar;
  if constexpr (!std::is_same_v<S, real_of_t<S>>) {
    return path.position(location_at_arc_length(path, s));
  }
  const std::size_t k = path.segment_at_arc_length(s);
  if (s == path.arc_length()) return path.segments().back().end();
  return arc_length_detail::point_at(path.segment(k), path.arc_length_table(k),
                                     S(s - path.knot_arc_lengths()[k]));
}

}  // namespace hodograph
