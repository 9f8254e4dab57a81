// SPDX-License-Identifier: MIT
// A curve on an interval as a polynomial with double coefficients and a radius: what the rest of a
// certificate is computed from.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/certify/ball.hpp"
#include "hodograph/construction/error_bound.hpp"
#include "hodograph/foundation/taylor.hpp"

namespace hodograph::certify_detail {

/// |γ(m + w s) - origin - Σ_k coefficient[.][k] s^k| ≤ radius + remainder for -1 ≤ s ≤ 1.
template <std::size_t dimension, std::size_t order>
struct TaylorModel {
  std::array<std::array<double, order + 1>, dimension> coefficient{};
  /// What is unknown of the coefficient of the highest order, taken over the interval as a ball,
  /// and everything else: it is the former that shrinks on shorter intervals.
  double remainder = 0.0, radius = 0.0;

  /// Makes the model of γ on middle ± half, relative to origin. False where γ has no finite
  /// enclosure there, or branches on a comparison that the interval does not decide.
  template <class Curve, class Point>
  bool expand(const Curve& gamma, const Ball& middle, const Ball& half, const Point& origin) {
    Taylor<Ball, order> at_middle(middle), over_interval(middle.widened(half));
    at_middle[1] = half;
    over_interval[1] = half;
    try {
      const auto bounded = gamma(over_interval);
      for (std::size_t i = 0; i < dimension; ++i) {
        if (!is_finite(bounded[i])) return false;
      }
      const auto centred = gamma(at_middle);
      Enclosure last(0.0), others(0.0);
      for (std::size_t i = 0; i < dimension; ++i) {
        const Ball first = centred[i][0] - Ball(origin[i]);
        for (std::size_t k = 0; k <= order; ++k) {
          const Ball& exact = k == 0 ? first : k == order ? bounded[i][k] : centred[i][k];
          coefficient[i][k] = exact.midpoint();
          (k == order ? last : others) += Enclosure(exact.radius());
        }
      }
      remainder = last.upper();
      radius = others.upper();
      return remainder < infinity && radius < infinity;
    } catch (const UndecidedComparison&) {
      return false;
    }
  }

  /// The same curve relative to origin + shift and on s = alpha + beta s', |alpha| + |beta| ≤ 1 but
  /// for rounding, where alpha and beta may be wrong by up to `uncertainty` together.
  ///
  /// Derivation: a wrong parameter moves the value by that times Σ k |c_k|. The new coefficients
  /// are sums of terms C(k,j) c_k alpha^{k-j} beta^j, whose sizes sum to at most Σ |c_k| on all of
  /// [-1, 1]; each passes at most 2 order roundings in the repeated division and order + 2 in the
  /// scaling.
  template <class Point>
  TaylorModel restricted(double alpha, double beta, double uncertainty, const Point& shift) const {
    TaylorModel part = *this;
    Enclosure added(0.0);
    for (std::size_t i = 0; i < dimension; ++i) {
      auto& c = part.coefficient[i];
      double size = 0.0, slope = 0.0;
      for (std::size_t k = 0; k <= order; ++k) {
        size += std::abs(c[k]);
        slope += static_cast<double>(k) * std::abs(c[k]);
      }
      for (std::size_t j = 0; j < order; ++j) {
        for (std::size_t k = order; k-- > j;) c[k] += alpha * c[k + 1];
      }
      double power = 1.0;
      for (std::size_t k = 1; k <= order; ++k) {
        power *= beta;
        c[k] *= power;
      }
      c[0] -= shift[i];
      // The factors 2 cover the roundings of the bound itself and of |alpha| + |beta|.
      const Enclosure underflow(static_cast<double>(4 * order * order) *
                                std::numeric_limits<double>::denorm_min());
      added += Enclosure(2.0 * uncertainty) * Enclosure(slope) + underflow +
               error_detail::roundings(3 * order + 4) *
                   (Enclosure(2.0 * size) + Enclosure(std::abs(shift[i])));
    }
    part.radius = (Enclosure(radius) + added).upper();
    return part;
  }

 private:
  static constexpr double infinity = std::numeric_limits<double>::infinity();
};

/// The Bernstein coefficients, in degree d, of the powers s^0 ... s^K of s = 2u - 1: in degree k
/// they are (-1)^{k-j}, and raising the degree averages, so that none exceeds 1. Correctly rounded.
template <std::size_t K, std::size_t d>
struct CentredPowers {
  constexpr std::array<std::array<double, d + 1>, K + 1> operator()() const {
    std::array<std::array<double, d + 1>, K + 1> table{};
    for (std::size_t k = 0; k <= K; ++k) {
      for (std::size_t i = 0; i <= d; ++i) {
        std::int64_t sum = 0;
        for (std::size_t j = 0; j <= k && j <= i; ++j) {
          const std::int64_t term = binomial(k, j) * binomial(d - k, i - j);
          sum += (k - j) % 2 == 0 ? term : -term;
        }
        table[k][i] = ratio<double>(sum, binomial(d, i));
      }
    }
    return table;
  }
};

/// The polynomial of a model minus a displacement, and in `rounding` a bound of what computing it
/// in double precision adds. Every term passes at most: weight 1, product 1, sum K, subtraction 1.
template <std::size_t dimension, std::size_t K, std::size_t d>
error_detail::Components<dimension, d> difference(
    const TaylorModel<dimension, K>& model,
    const error_detail::Components<dimension, d>& displacement, double& rounding) {
  const auto& powers = constant_table<double, CentredPowers<K, d>>();
  error_detail::Components<dimension, d> result{};
  double size = 0.0;  // few additions: the factor 2 below covers their roundings
  for (std::size_t i = 0; i < dimension; ++i) {
    for (std::size_t k = 0; k <= K; ++k) {
      const double c = model.coefficient[i][k];
      size += std::abs(c);
      for (std::size_t j = 0; j <= d; ++j) result[i][j] += powers[k][j] * c;
    }
    double largest = 0.0;
    for (std::size_t j = 0; j <= d; ++j) {
      error_detail::raise_to(largest, std::abs(displacement[i][j]));
      result[i][j] -= displacement[i][j];
    }
    size += largest;
  }
  rounding =
      (error_detail::roundings(K + 3) * Enclosure(2.0 * size) +
       Enclosure(static_cast<double>(4 * (K + 1)) * std::numeric_limits<double>::denorm_min()))
          .upper();
  return result;
}

}  // namespace hodograph::certify_detail
