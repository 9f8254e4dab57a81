// SPDX-License-Identifier: MIT
// Hermite data from golden files, and the comparison of preimages modulo one constant right factor.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "tests/support/json.hpp"

namespace hodograph::test {

/// The members p, v, a, j, s of a golden Hermite point.
inline HermitePoint<4> golden_point(const Json& point) {
  return {point["p"].vector(), point["v"].vector(), point["a"].vector(), point["j"].vector(),
          point["s"].vector()};
}

/// The free parameters of a golden case; in its files tau counts with the index of A_k.
inline HermiteParameters<4> golden_parameters(const Json& phi) {
  const auto of = [&](const char* name) { return phi.has(name) ? phi[name].number() : 0.0; };
  HermiteParameters<4> parameters;
  parameters.theta_begin = of("th0");
  parameters.theta_middle = of("th4");
  parameters.theta_end = of("th8");
  parameters.tau_begin = {of("t1"), of("t2"), of("t3")};
  parameters.tau_end = {of("t7"), of("t6"), of("t5")};
  return parameters;
}

/// Golden quaternions, one list each.
inline std::vector<Quaternion<double>> golden_quaternions(const Json& list) {
  std::vector<Quaternion<double>> result;
  for (const Json& q : list.list()) result.push_back(q.quaternion());
  return result;
}

/// The unit Q = cos a + i sin a for which Σ |A_k Q - B_k|² is least.
template <class S>
Roll<S> matching_roll(const std::vector<Quaternion<S>>& a, const std::vector<Quaternion<S>>& b) {
  using std::sqrt;
  S c(0), s(0);
  for (std::size_t k = 0; k < a.size(); ++k) {
    c += dot(a[k], b[k]);
    s += dot(times_i(a[k]), b[k]);
  }
  const S size = sqrt(c * c + s * s);
  return {c / size, s / size};
}

/// The coefficients of all segments in local scaling, √h A.
template <class S, std::size_t n>
std::vector<Quaternion<S>> local_coefficients(const SpatialPath<n, S>& path) {
  using std::sqrt;
  std::vector<Quaternion<S>> result;
  for (const auto& segment : path.segments()) {
    const S root = sqrt(segment.parameter_step());
    for (const auto& a : segment.preimage().coefficients()) result.push_back(root * a);
  }
  return result;
}

/// The same curves with their preimages multiplied on the right by a constant.
template <class S, std::size_t n>
SpatialPath<n, S> rolled_path(const SpatialPath<n, S>& path, const Roll<S>& roll) {
  std::vector<SpatialPhCurve<n, S>> segments;
  for (const auto& segment : path.segments()) {
    segments.emplace_back(segment.start(), segment.preimage().mapped([&](const Quaternion<S>& a) {
      return a * roll;
    }),
                          segment.parameter_step());
  }
  return SpatialPath<n, S>::create(path.knots(), std::move(segments), path.is_closed()).value();
}

/// A curve as a path of one segment.
template <class S, std::size_t n>
SpatialPath<n, S> single(const SpatialPhCurve<n, S>& curve) {
  return SpatialPath<n, S>::create({S(0), curve.parameter_step()}, {curve}, false).value();
}

/// The largest component of any of the given vectors (quaternions, points).
template <class V>
typename V::Scalar largest_of(const std::vector<V>& list) {
  typename V::Scalar largest(0);
  for (const V& v : list) {
    if (largest < largest_component(v)) largest = largest_component(v);
  }
  return largest;
}

}  // namespace hodograph::test
