// SPDX-License-Identifier: MIT
// Random PH curves and paths over any algebra, degree and scalar.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/path/path.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {

/// A preimage coefficient with components in [-scale, scale], exact doubles.
template <class A>
A random_coefficient(Random& random, double scale = 1.0) {
  A a{};
  for (std::size_t i = 0; i < A::dimension; ++i) {
    a[i] = typename A::Scalar(random.uniform(-scale, scale));
  }
  return a;
}

/// A preimage near 1 (0.5 in every component at most away from it, n + 1 coefficients), so that the
/// speed stays away from zero: on [0, 1] the value is 1 plus a convex combination.
template <class A, std::size_t n>
BernsteinPolynomial<A, n> tame_preimage(Random& random) {
  BernsteinPolynomial<A, n> a;
  for (std::size_t i = 0; i <= n; ++i) {
    a[i] = random_coefficient<A>(random, 0.5);
    a[i][0] = a[i][0] + typename A::Scalar(1);
  }
  return a;
}

/// Any preimage: coefficients in [-1, 1].
template <class A, std::size_t n>
BernsteinPolynomial<A, n> wild_preimage(Random& random) {
  BernsteinPolynomial<A, n> a;
  for (std::size_t i = 0; i <= n; ++i) a[i] = random_coefficient<A>(random);
  return a;
}

/// Gives `next` the value and the first `order` derivatives (with respect to ξ) that `before` has
/// at its end; `order` ≤ n.
template <class A, std::size_t n>
void continue_preimage(const PhCurve<A, n>& before, BernsteinPolynomial<A, n>& next,
                       const typename A::Scalar& step, std::size_t order) {
  using S = typename A::Scalar;
  // b_j = Σ_i C(j,i) Δ^i, Δ^i = step^i (n-i)!/n! A^(i); A^(i) = n!/(n-i)! / h^i · backward
  // difference.
  std::array<A, n + 1> difference = before.preimage().coefficients();
  std::array<A, n + 1> forward{};
  const S stretch = step / before.parameter_step();
  S power(1);
  for (std::size_t i = 0; i <= order; ++i) {
    forward[i] = power * difference[n - i];
    power = power * stretch;
    for (std::size_t j = 0; j + i + 1 <= n; ++j) difference[j] = difference[j + 1] - difference[j];
  }
  for (std::size_t j = 0; j <= order; ++j) {
    A sum{};
    for (std::size_t i = 0; i <= j; ++i) {
      sum = sum + S(static_cast<double>(binomial(j, i))) * forward[i];
    }
    next[j] = sum;
  }
}

/// A path of `count` tame segments on non-uniform knots (steps in [0.5, 1.5]), whose preimage has
/// `order` continuous derivatives at the knots (order < 0: only the position continues).
template <class P>
P random_path(Random& random, std::size_t count, int order = 0) {
  using S = typename P::Scalar;
  using A = typename P::Algebra;
  constexpr std::size_t n = P::preimage_degree;
  std::vector<S> knots{S(random.uniform(-1.0, 1.0))};
  std::vector<typename P::Curve> segments;
  typename P::Point start{};
  for (std::size_t i = 0; i < P::Point::dimension; ++i) start[i] = S(random.uniform(-1.0, 1.0));
  for (std::size_t k = 0; k < count; ++k) {
    knots.push_back(knots.back() + S(random.uniform(0.5, 1.5)));
    const S step = knots[k + 1] - knots[k];
    auto preimage = tame_preimage<A, n>(random);
    if (k > 0 && order >= 0) {
      continue_preimage(segments.back(), preimage, step, static_cast<std::size_t>(order));
    }
    segments.emplace_back(start, preimage, step);
    start = segments.back().end();
  }
  return P::create(std::move(knots), std::move(segments), false).value();
}

/// A closed curve of `count` equal arcs that turn left once round: the preimage turns by half that,
/// to its negative. Arc k is w = e^(ikπ/N) ((1 - u) + u e^(iπ/N)), on knots of step 1.
inline PlanarPath<1> ring(std::size_t count) {
  const double half = 3.141592653589793 / static_cast<double>(count);
  const auto turn = [&](std::size_t k) {
    const double angle = half * static_cast<double>(k);
    return Complex<double>{std::cos(angle), std::sin(angle)};
  };
  std::vector<double> knots{0.0};
  std::vector<PlanarPhCurve<1>> segments;
  Vector2<double> start{};
  for (std::size_t k = 0; k < count; ++k) {
    knots.push_back(static_cast<double>(k + 1));
    segments.emplace_back(start, BernsteinPolynomial<Complex<double>, 1>({turn(k), turn(k + 1)}),
                          1.0);
    start = segments.back().end();
  }
  return PlanarPath<1>::create(std::move(knots), std::move(segments), true).value();
}

/// An algebra's value in another scalar.
template <class T, class S>
Complex<T> converted(const Complex<S>& w) {
  return {T(w.re), T(w.im)};
}
template <class T, class S>
Quaternion<T> converted(const Quaternion<S>& a) {
  return {T(a.w), T(a.x), T(a.y), T(a.z)};
}
template <class T, class S>
Vector2<T> converted(const Vector2<S>& v) {
  return {T(v.x), T(v.y)};
}
template <class T, class S>
Vector3<T> converted(const Vector3<S>& v) {
  return {T(v.x), T(v.y), T(v.z)};
}

/// The same path over another scalar T, one that holds S exactly: with a Taylor scalar, evaluating
/// it at Taylor::variable(ξ) differentiates whatever is evaluated.
template <class T, class A, std::size_t n>
auto converted(const Path<A, n>& path) {
  using B = decltype(converted<T>(A{}));
  std::vector<T> knots;
  std::vector<PhCurve<B, n>> segments;
  for (const auto& knot : path.knots()) knots.push_back(T(knot));
  for (const auto& curve : path.segments()) {
    segments.emplace_back(converted<T>(curve.start()),
                          curve.preimage().mapped([](const A& a) { return converted<T>(a); }),
                          T(curve.parameter_step()));
  }
  // A wider scalar sees the rounding of the knots: its steps follow from them.
  for (std::size_t k = 0; k < segments.size(); ++k) {
    segments[k] = {segments[k].start(), segments[k].preimage(), knots[k + 1] - knots[k]};
    if (k > 0) {
      segments[k] = {segments[k - 1].end(), segments[k].preimage(), segments[k].parameter_step()};
    }
  }
  return Path<B, n>::create(std::move(knots), std::move(segments), false).value();
}

}  // namespace hodograph::test
