// SPDX-License-Identifier: MIT
// Bernstein polynomials in powers of z = u/(1-u), for their complex roots.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

#include "hodograph/bernstein/complex_roots.hpp"
#include "rows.hpp"

namespace hodograph::frame_detail {

/// C(n,k) c_k: a Bernstein polynomial over (1-u)^n as a polynomial in z = u/(1-u).
template <class V>
std::vector<V> power_coefficients(const Row<V>& c) {
  std::vector<V> a(c);
  double binomial = 1.0;
  const std::size_t n = c.size() - 1;
  for (std::size_t k = 1; k < n; ++k) {
    binomial = binomial * static_cast<double>(n - k + 1) / static_cast<double>(k);
    a[k] = binomial * a[k];
  }
  return a;
}

/// The value and two derivatives of Σ a_k z^k, and Σ |a_k z^k|, Σ k |a_k z^(k-1)|.
struct PowerJet {
  std::complex<double> value, first, second;
  double size = 0.0, slope_size = 0.0;
};
template <class V>
PowerJet power_jet(const std::vector<V>& a, const std::complex<double>& z) {
  PowerJet jet;
  const double r = std::abs(z);
  for (std::size_t k = a.size(); k-- > 0;) {
    jet.second = jet.second * z + 2.0 * jet.first;
    jet.first = jet.first * z + jet.value;
    jet.value = jet.value * z + a[k];
    jet.slope_size = jet.slope_size * r + jet.size;
    jet.size = jet.size * r + std::abs(a[k]);
  }
  return jet;
}

}  // namespace hodograph::frame_detail
