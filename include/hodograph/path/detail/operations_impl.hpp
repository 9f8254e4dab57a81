// SPDX-License-Identifier: MIT
// The definitions of path/operations.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/path/detail/preimage_turn.hpp"
#include "hodograph/path/operations.hpp"

namespace hodograph {

namespace operation_detail {

/// A path on the same knots whose segments are map(curve).
template <class Result, class P, class Map>
auto mapped(const P& path, const Map& map) {
  std::vector<typename Result::Curve> segments;
  segments.reserve(path.segment_count());
  for (const auto& curve : path.segments()) segments.push_back(map(curve));
  return Result::create(path.knots(), std::move(segments), path.is_closed());
}

/// The same place and shape over another parameter step: h |A|² stays.
template <class Curve>
Curve with_step(const Curve& curve, const typename Curve::Scalar& step) {
  using std::sqrt;
  using S = typename Curve::Scalar;
  if (step == curve.parameter_step()) return curve;
  const S factor = sqrt(S(curve.parameter_step() / step));
  return {curve.start(), factor * curve.preimage(), step};
}

/// a j and i w: what turns the image of the preimage round.
template <class S>
Quaternion<S> turned_round(const Quaternion<S>& a) {
  return {-a.y, -a.z, a.w, a.x};
}
template <class S>
Complex<S> turned_round(const Complex<S>& w) {
  return {-w.im, w.re};
}

/// The preimage b multiplied by the roll (in the plane: the sign) that q = conj(b_0) a_n contains.
template <class S, std::size_t n>
BernsteinPolynomial<Quaternion<S>, n> rolled_by(const BernsteinPolynomial<Quaternion<S>, n>& b,
                                                const Quaternion<S>& q, const S& length) {
  const Roll<S> roll{q.w / length, q.x / length};
  return b.mapped([&](const Quaternion<S>& c) { return c * roll; });
}
template <class S, std::size_t n>
BernsteinPolynomial<Complex<S>, n> rolled_by(const BernsteinPolynomial<Complex<S>, n>& b,
                                             const Complex<S>& q, const S&) {
  return q.re < S(0) ? b.mapped([](const Complex<S>& c) { return -c; }) : b;
}

/// v/|v| without overflow or underflow, for v of positive finite size.
template <class V>
V unit(const V& v) {
  using S = typename V::Scalar;
  const V reduced = (S(1) / largest_component(v)) * v;
  return (S(1) / norm(reduced)) * reduced;
}

/// ν A k and i ν w*.
template <class S>
Quaternion<S> mirrored(const Vector3<S>& normal, const Quaternion<S>& a) {
  return pure(normal) * a * Quaternion<S>{S(0), S(0), S(0), S(1)};
}
template <class S>
Complex<S> mirrored(const Vector2<S>& normal, const Complex<S>& w) {
  return Complex<S>{-normal.y, normal.x} * conjugate(w);
}

inline Fault not_finite(const char* quantity) {
  return {
      FaultCode::not_finite, std::string(quantity) + " has a component that is not a finite number",
      std::nullopt,          quantity,
      std::nullopt,          std::nullopt};
}

template <class S>
Fault outside(const S& xi, const S& low, const S& high) {
  return {FaultCode::outside_domain,
          "path parameter xi " + to_text(to_double(xi)) + " is outside [" +
              to_text(to_double(low)) + ", " + to_text(to_double(high)) + "]",
          std::nullopt,
          "xi",
          to_double(xi),
          to_double(xi < low ? low : high)};
}

}  // namespace operation_detail

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reversed(const Path<A, n>& path) {
  using Curve = typename Path<A, n>::Curve;
  std::vector<typename A::Scalar> knots;
  std::vector<Curve> segments;
  knots.reserve(path.knots().size());
  segments.reserve(path.segment_count());
  for (std::size_t k = path.knots().size(); k-- > 0;) knots.push_back(-path.knots()[k]);
  for (std::size_t k = path.segment_count(); k-- > 0;) {
    const Curve& curve = path.segment(k);
    segments.emplace_back(curve.end(), curve.preimage().reversed().mapped([](const A& a) {
      return operation_detail::turned_round(a);
    }),
                          curve.parameter_step());
  }
  return Path<A, n>::create(std::move(knots), std::move(segments), path.is_closed());
}

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> subpath(const Path<A, n>& path, const typename A::Scalar& xi_a,
                           const typename A::Scalar& xi_b) {
  using S = typename A::Scalar;
  using Curve = typename Path<A, n>::Curve;
  for (const S& xi : {xi_a, xi_b}) {
    if (!(path.xi_begin() <= xi && xi <= path.xi_end())) {
      return operation_detail::outside(xi, path.xi_begin(), path.xi_end());
    }
  }
  if (!(xi_a < xi_b)) {
    return Fault{FaultCode::not_increasing,
                 "a part of a path must begin before it ends; got [" + to_text(to_double(xi_a)) +
                     ", " + to_text(to_double(xi_b)) + "]",
                 std::nullopt,
                 "xi_b",
                 to_double(xi_b),
                 to_double(xi_a)};
  }
  const auto begin = path.locate(xi_a);
  auto end = path.locate(xi_b);
  if (end.segment > 0 && !(path.knots()[end.segment] < xi_b)) end = {end.segment - 1, S(1)};

  std::vector<S> knots{xi_a};
  std::vector<Curve> segments;
  for (std::size_t k = begin.segment; k <= end.segment; ++k) {
    const Curve& curve = path.segment(k);
    const S from = k == begin.segment ? begin.u : S(0);
    const S to = k == end.segment ? end.u : S(1);
    knots.push_back(k == end.segment ? xi_b : path.knots()[k + 1]);
    if (from == S(0) && to == S(1)) {
      segments.push_back(curve);
    } else {
      segments.emplace_back(curve.position(from), curve.preimage().restricted(from, to),
                            knots.back() - knots[knots.size() - 2]);
    }
  }
  return Path<A, n>::create(std::move(knots), std::move(segments), false);
}

template <PreimageAlgebra A, std::size_t m, std::size_t n>
Result<Path<A, std::max(m, n)>> joined(const Path<A, m>& a, const Path<A, n>& b) {
  using S = typename A::Scalar;
  using P = Path<A, std::max(m, n)>;
  const auto& last = a.segments().back().preimage();
  const auto& first = b.segments().front().preimage();
  const std::size_t join = a.segment_count();
  const bool ends_moving = S(0) < largest_component(last.back());
  if (!ends_moving || !(S(0) < largest_component(first.front()))) {
    return Fault{FaultCode::zero_speed,
                 std::string("the ") + (ends_moving ? "second" : "first") +
                     " path stands still at the join: it has no tangent there to continue",
                 join,
                 "speed",
                 0.0,
                 std::nullopt};
  }
  const auto turn = path_detail::preimage_turn(last, first);
  if (turn.is_break()) return path_detail::tangent_fault(turn, join, "the paths meet");

  std::vector<S> knots = a.knots();
  std::vector<typename P::Curve> segments;
  segments.reserve(a.segment_count() + b.segment_count());
  for (const auto& curve : a.segments()) {
    segments.push_back(curve.template elevated<P::preimage_degree>());
  }
  for (std::size_t k = 0; k < b.segment_count(); ++k) {
    const auto& curve = b.segment(k);
    knots.push_back(a.xi_end() == b.xi_begin() ? b.knots()[k + 1]
                                               : S(a.xi_end() + (b.knots()[k + 1] - b.xi_begin())));
    const typename Path<A, n>::Curve rolled{
        curve.start(), operation_detail::rolled_by(curve.preimage(), turn.q, turn.along),
        curve.parameter_step()};
    segments.push_back(
        operation_detail::with_step(rolled, S(knots.back() - knots[knots.size() - 2]))
            .template elevated<P::preimage_degree>());
  }
  return P::create(std::move(knots), std::move(segments), false);
}

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> with_closure(const Path<A, n>& path, bool closed) {
  return Path<A, n>::create(path.knots(), path.segments(), closed);
}

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reparametrised(const Path<A, n>& path, const typename A::Scalar& begin,
                                  const typename A::Scalar& end) {
  using S = typename A::Scalar;
  if (!is_finite(begin) || !is_finite(end) || !is_finite(S(end - begin))) {
    return operation_detail::not_finite("the new parameter interval");
  }
  if (!(begin < end)) {
    return Fault{FaultCode::not_increasing,
                 "a parameter interval must begin before it ends; got [" +
                     to_text(to_double(begin)) + ", " + to_text(to_double(end)) + "]",
                 std::nullopt,
                 "end",
                 to_double(end),
                 to_double(begin)};
  }
  const S length = path.xi_end() - path.xi_begin();
  std::vector<S> knots{begin};
  std::vector<typename Path<A, n>::Curve> segments;
  segments.reserve(path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const S share = (path.knots()[k + 1] - path.xi_begin()) / length;
    knots.push_back(k + 1 == path.segment_count() ? end : S(begin + share * (end - begin)));
    segments.push_back(operation_detail::with_step(path.segment(k), S(knots[k + 1] - knots[k])));
  }
  return Path<A, n>::create(std::move(knots), std::move(segments), path.is_closed());
}

template <std::size_t m, PreimageAlgebra A, std::size_t n>
  requires(m >= n)
Result<Path<A, m>> with_preimage_degree(const Path<A, n>& path) {
  return operation_detail::mapped<Path<A, m>>(
      path, [](const auto& curve) { return curve.template elevated<m>(); });
}

template <class S, std::size_t n>
Result<SpatialPath<n, S>> moved(const SpatialPath<n, S>& path, const Quaternion<S>& rotation,
                                const Vector3<S>& translation) {
  using std::abs;
  if (!is_finite(rotation)) return operation_detail::not_finite("the rotation");
  if (!is_finite(translation)) return operation_detail::not_finite("the translation");
  const S length = norm(rotation);
  if (!(abs(S(length - S(1))) <= S(accuracy::unit_error<S>()))) {
    return Fault{
        FaultCode::outside_domain,
        "a rotation is a unit quaternion; this one has length " + to_text(to_double(length)),
        std::nullopt,
        "rotation",
        to_double(length),
        1.0};
  }
  const Quaternion<S> q = (S(1) / length) * rotation;
  return operation_detail::mapped<SpatialPath<n, S>>(path, [&](const SpatialPhCurve<n, S>& curve) {
    return SpatialPhCurve<n, S>{
        sandwich(q, curve.start()) + translation,
        curve.preimage().mapped([&](const Quaternion<S>& a) { return q * a; }),
        curve.parameter_step()};
  });
}

template <class S, std::size_t n>
Result<PlanarPath<n, S>> moved(const PlanarPath<n, S>& path, const S& angle,
                               const Vector2<S>& translation) {
  using std::cos;
  using std::sin;
  if (!is_finite(angle)) return operation_detail::not_finite("the angle");
  if (!is_finite(translation)) return operation_detail::not_finite("the translation");
  const S half = angle / S(2);
  const Complex<S> q{cos(half), sin(half)};
  const Complex<S> turn = q * q;
  return operation_detail::mapped<PlanarPath<n, S>>(path, [&](const PlanarPhCurve<n, S>& curve) {
    return PlanarPhCurve<n, S>{
        hodograph_form(turn, Complex<S>{curve.start().x, curve.start().y}) + translation,
        curve.preimage().mapped([&](const Complex<S>& w) { return q * w; }),
        curve.parameter_step()};
  });
}

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> scaled(const Path<A, n>& path, const typename A::Scalar& c) {
  using S = typename A::Scalar;
  using std::sqrt;
  if (!is_finite(c) || !(S(0) < c)) {
    return Fault{FaultCode::outside_domain,
                 "a scale is a finite positive number; got " + to_text(to_double(c)),
                 std::nullopt,
                 "scale",
                 to_double(c),
                 0.0};
  }
  const S root = sqrt(c);
  return operation_detail::mapped<Path<A, n>>(path, [&](const PhCurve<A, n>& curve) {
    return PhCurve<A, n>{c * curve.start(), root * curve.preimage(), curve.parameter_step()};
  });
}

template <PreimageAlgebra A, std::size_t n>
Result<Path<A, n>> reflected(const Path<A, n>& path, const point_t<A>& normal,
                             const point_t<A>& point) {
  using S = typename A::Scalar;
  if (!is_finite(normal)) return operation_detail::not_finite("the normal of the mirror");
  if (!is_finite(point)) return operation_detail::not_finite("the point of the mirror");
  if (!(S(0) < largest_component(normal))) {
    return Fault{FaultCode::outside_domain,
                 "the normal of a mirror must not be zero",
                 std::nullopt,
                 "normal",
                 0.0,
                 std::nullopt};
  }
  const point_t<A> direction = operation_detail::unit(normal);
  return operation_detail::mapped<Path<A, n>>(path, [&](const PhCurve<A, n>& curve) {
    const S height = dot(curve.start() - point, direction);
    return PhCurve<A, n>{curve.start() - (S(2) * height) * direction,
                         curve.preimage().mapped(
                             [&](const A& a) { return operation_detail::mirrored(direction, a); }),
                         curve.parameter_step()};
  });
}

template <class S, std::size_t n>
Result<SpatialPath<n, S>> lifted(const PlanarPath<n, S>& path) {
  return operation_detail::mapped<SpatialPath<n, S>>(path, [](const PlanarPhCurve<n, S>& curve) {
    return SpatialPhCurve<n, S>{Vector3<S>{curve.start().x, curve.start().y, S(0)},
                                curve.preimage().mapped([](const Complex<S>& w) {
                                  return Quaternion<S>{w.re, S(0), S(0), w.im};
                                }),
                                curve.parameter_step()};
  });
}

}  // namespace hodograph
