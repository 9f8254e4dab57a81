// SPDX-License-Identifier: MIT
// Dynamic polynomials over enclosures, and bounds of what they hold.
#pragma once

#include <algorithm>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/dynamic_polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"

namespace hodograph::surface_detail {

inline Enclosure enclosed(double x) { return Enclosure(x); }
inline Vector3<Enclosure> enclosed(const Vector3<double>& v) { return {v.x, v.y, v.z}; }
inline Quaternion<Enclosure> enclosed(const Quaternion<double>& q) { return {q.w, q.x, q.y, q.z}; }

/// The same polynomial with enclosures of the same numbers.
template <class V>
auto enclosed(const DynamicPolynomial<V>& f) {
  return f.mapped([](const V& c) { return enclosed(c); });
}

/// Upper bounds of |f| on [0, 1], and the lower bound of a real f: those of the coefficients.
inline double largest(const DynamicPolynomial<Enclosure>& f) {
  double bound = 0.0;
  for (const Enclosure& c : f.coefficients()) bound = std::max(bound, c.magnitude());
  return bound;
}
inline double least(const DynamicPolynomial<Enclosure>& f) {
  double bound = f[0].lower();
  for (const Enclosure& c : f.coefficients()) bound = std::min(bound, c.lower());
  return bound;
}
inline double size_bound(const Vector3<Enclosure>& v) {
  return sqrt(square(v.x) + square(v.y) + square(v.z)).upper();
}
inline double largest(const DynamicPolynomial<Vector3<Enclosure>>& f) {
  double bound = 0.0;
  for (const auto& c : f.coefficients()) bound = std::max(bound, size_bound(c));
  return bound;
}

/// Upper bounds of a sum and a product of upper bounds that are not negative.
inline double sum_up(double a, double b) { return Enclosure::up(a + b); }
inline double product_up(double a, double b) {
  return a == 0.0 || b == 0.0 ? 0.0 : Enclosure::up(a * b);
}
inline double quotient_up(double a, double b) { return a == 0.0 ? 0.0 : Enclosure::up(a / b); }

}  // namespace hodograph::surface_detail
