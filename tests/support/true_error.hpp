// SPDX-License-Identifier: MIT
// The true distance of a stored path from a curve, in 60-digit arithmetic: the judge of error
// bounds.
#pragma once

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "hodograph/foundation/taylor.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph::test {

using Wide = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<60>,
                                           boost::multiprecision::et_off>;

template <class V>
auto widened(const V& v) {
  if constexpr (requires { v.w; }) {
    return Quaternion<Wide>{Wide(v.w), Wide(v.x), Wide(v.y), Wide(v.z)};
  } else if constexpr (requires { v.z; }) {
    return Vector3<Wide>{Wide(v.x), Wide(v.y), Wide(v.z)};
  } else if constexpr (requires { v.re; }) {
    return Complex<Wide>{Wide(v.re), Wide(v.im)};
  } else {
    return Vector2<Wide>{Wide(v.x), Wide(v.y)};
  }
}

/// The exact curve (to 60 digits) of the stored start, preimage and parameter step.
template <class A, std::size_t n>
auto widened_curve(const PhCurve<A, n>& curve) {
  using WideAlgebra = decltype(widened(A{}));
  return PhCurve<WideAlgebra, n>(widened(curve.start()),
                                 curve.preimage().mapped([](const A& a) { return widened(a); }),
                                 Wide(curve.parameter_step()));
}

/// The distance at one ξ of [xi_begin, xi_end], u clamped to the segment.
template <class Gamma, class WideCurve>
Wide true_distance(const Gamma& gamma, const WideCurve& curve, const Wide& xi_begin,
                   const Wide& xi) {
  Wide u = (xi - xi_begin) / curve.parameter_step();
  if (Wide(1) < u) u = Wide(1);
  return norm(gamma(xi) - curve.position(u));
}

/// The largest distance over a segment: `samples` points, then golden sections about the best three
/// neighbours. A lower bound of the truth by construction, and close to it.
template <class Gamma, class A, std::size_t n>
Wide true_segment_error(const Gamma& gamma, const PhCurve<A, n>& segment, double xi_begin,
                        double xi_end, int samples) {
  const auto curve = widened_curve(segment);
  const Wide begin(xi_begin), width = Wide(xi_end) - begin;
  const auto distance = [&](const Wide& t) {
    return true_distance(gamma, curve, begin, Wide(begin + t * width));
  };
  Wide best(-1);
  int at = 0;
  for (int i = 0; i <= samples; ++i) {
    const Wide d = distance(Wide(i) / Wide(samples));
    if (best < d) {
      best = d;
      at = i;
    }
  }
  Wide low = Wide(at > 0 ? at - 1 : 0) / Wide(samples);
  Wide high = Wide(at < samples ? at + 1 : samples) / Wide(samples);
  const Wide golden = (sqrt(Wide(5)) - Wide(1)) / Wide(2);
  Wide a = high - golden * (high - low), b = low + golden * (high - low);
  Wide da = distance(a), db = distance(b);
  for (int step = 0; step < 24; ++step) {
    if (da < db) {
      low = a;
      a = b;
      da = db;
      b = low + golden * (high - low);
      db = distance(b);
    } else {
      high = b;
      b = a;
      db = da;
      a = high - golden * (high - low);
      da = distance(a);
    }
    if (best < da) best = da;
    if (best < db) best = db;
  }
  return best;
}

/// The C^m data of a curve that is a template on its scalar, at the given knots, in double.
template <std::size_t m, class Gamma>
std::vector<HermitePoint<m, double>> hermite_data_of(const Gamma& gamma,
                                                     const std::vector<double>& knots) {
  std::vector<HermitePoint<m, double>> points;
  for (const double xi : knots) {
    const auto series = gamma(Taylor<double, m>::variable(xi));
    HermitePoint<m, double> point;
    for (std::size_t r = 0; r <= m; ++r) {
      point[r] = {series.x.derivative(r), series.y.derivative(r), series.z.derivative(r)};
    }
    points.push_back(point);
  }
  return points;
}

/// The C^m path through a curve at the given knots; throws where there is none.
template <std::size_t m, class Gamma>
SpatialPath<2 * m> fitted_path(const Gamma& gamma, const std::vector<double>& knots,
                               HermiteChoice choice = HermiteChoice::order_ten) {
  const auto points = hermite_data_of<m>(gamma, knots);
  return hermite_path<m, double>(knots, std::span<const HermitePoint<m, double>>(points), choice)
      .value();
}

/// N + 1 evenly spaced knots on [a, b].
inline std::vector<double> even_knots(double a, double b, int segments) {
  std::vector<double> knots;
  for (int k = 0; k <= segments; ++k) {
    const double t = static_cast<double>(k) / segments;
    knots.push_back(k == segments ? b : a + t * (b - a));
  }
  return knots;
}

}  // namespace hodograph::test
