// SPDX-License-Identifier: MIT
// The work behind segment_error: one segment against Taylor polynomials of the given curve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/certify/ball.hpp"
#include "hodograph/construction/error_bound.hpp"
#include "hodograph/foundation/taylor.hpp"

namespace hodograph::certify_detail {

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

template <class Curve, PreimageAlgebra A, std::size_t n>
class SegmentCertifier {
 public:
  /// The order of the remainder. Ten coefficients make the remainder on a segment smaller than the
  /// error of any C⁴ interpolant there by the factor |γ^(11)| h / (22 |γ^(10)|).
  static constexpr std::size_t order = 11;
  static constexpr std::size_t dimension = point_t<A>::dimension;
  static constexpr std::size_t degree = std::max(order, PhCurve<A, n>::degree);
  /// Halvings of a segment before it is given up, and intervals looked at altogether.
  static constexpr int depth_limit = 12;
  static constexpr int work_limit = 512;
  /// An interval is halved where its remainder exceeds this part of the difference.
  static constexpr double remainder_part = 1.0 / 32.0;

  SegmentCertifier(const Curve& gamma, const PhCurve<A, n>& segment, double xi_begin, double xi_end)
      : gamma_(gamma),
        segment_(segment),
        xi_begin_(xi_begin),
        xi_end_(xi_end),
        allowance_(position_error(segment)) {}

  ErrorBound run() {
    const double h = segment_.parameter_step();
    // The segment ends at ξ_k + h, which misses ξ_{k+1} by up to half an ulp.
    const Ball gap = Ball(xi_end_) - (Ball(xi_begin_) + Ball(h));
    reaches_past_end_ = !(arb_is_nonnegative(gap.get()));
    Difference displacement;
    const auto raised = segment_.displacement().template elevated<degree>();
    double largest = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      for (std::size_t j = 0; j <= degree; ++j) {
        displacement[i][j] = raised[j][i];
        error_detail::raise_to(largest, std::abs(raised[j][i]));
      }
    }
    // Raising the degree: at most degree + 3 roundings a coefficient; every halving: degree, and as
    // many underflows. A factor 2 > √3 covers the components.
    const Enclosure underflow(static_cast<double>(degree + 3) *
                              std::numeric_limits<double>::denorm_min());
    per_halving_ = (error_detail::roundings(degree + 3) * Enclosure(2.0 * largest) +
                    Enclosure(2.0) * underflow)
                       .upper();
    visit(displacement, 0.0, 1.0, PhCurve<A, n>::degree < degree ? per_halving_ : 0.0, 0);
    if (!arb_is_zero(gap.get()) && !reaches_past_end_) cross_gap(gap);
    ErrorBound result;
    const Enclosure allowance(allowance_);
    const double upper = (Enclosure(upper_) + allowance).upper();
    result.certified = upper < infinity;
    result.error = Enclosure(std::max(0.0, (Enclosure(lower_) - allowance).lower()),
                             result.certified ? upper : infinity);
    result.at_xi = std::min(xi_end_, xi_begin_ + at_ * h);
    return result;
  }

 private:
  using Series = Taylor<Ball, order>;
  using Difference = error_detail::Components<dimension, degree>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  // The segment's displacement on [begin, begin + width] of u, wrong by at most `error`.
  void visit(Difference& displacement, double begin, double width, double error, int depth) {
    ++work_;
    Difference difference;
    double remainder = infinity, radius = infinity;
    const bool known = subtract(displacement, begin, width, difference, remainder, radius);
    const bool may_halve = depth < depth_limit && work_ < work_limit;
    if (!known && !may_halve) {
      upper_ = infinity;
      return;
    }
    if (known) {
      const double total = (Enclosure(radius) + Enclosure(remainder) + Enclosure(error)).upper();
      const NormBound bound = error_detail::largest_norm<dimension, degree>(difference, total);
      const bool sharp = remainder <= remainder_part * bound.norm.upper() ||
                         remainder <= std::max(radius, allowance_) || bound.norm.upper() <= upper_;
      if (sharp || !may_halve) {
        // At the very end the exact segment may reach past ξ_{k+1}; that point is not a witness.
        const bool witness = !(reaches_past_end_ && begin + bound.at * width >= 1.0);
        if (witness && bound.norm.lower() > lower_) {
          lower_ = bound.norm.lower();
          at_ = begin + bound.at * width;
        }
        upper_ = std::max(upper_, bound.norm.upper());
        return;
      }
    }
    Difference right;
    error_detail::halve<dimension, degree>(displacement, right);
    const double next = (Enclosure(error) + Enclosure(per_halving_)).upper();
    visit(displacement, begin, 0.5 * width, next, depth + 1);
    if (upper_ == infinity && lower_ > 0.0) return;
    visit(right, begin + 0.5 * width, 0.5 * width, next, depth + 1);
  }

  // difference = Taylor polynomial of γ - start on the interval, minus the displacement. remainder
  // bounds what is unknown of the last coefficient, radius everything else. False where γ has no
  // finite enclosure.
  bool subtract(const Difference& displacement, double begin, double width, Difference& difference,
                double& remainder, double& radius) const {
    const Ball half = Ball(segment_.parameter_step()) * Ball(0.5 * width);
    const Ball middle =
        Ball(xi_begin_) + Ball(segment_.parameter_step()) * Ball(begin + 0.5 * width);
    Series at_middle(middle), over_interval(middle.widened(half));
    at_middle[1] = half;
    over_interval[1] = half;
    try {
      const auto bounded = gamma_(over_interval);
      for (std::size_t i = 0; i < dimension; ++i) {
        if (!is_finite(bounded[i])) return false;
      }
      const auto centred = gamma_(at_middle);
      Enclosure unknown_last(0.0), unknown(0.0);
      for (std::size_t i = 0; i < dimension; ++i) {
        Enclosure component(0.0), size(0.0);
        std::array<double, order + 1> coefficient;
        for (std::size_t k = 0; k <= order; ++k) {
          const Ball exact = k == 0       ? centred[i][0] - Ball(segment_.start()[i])
                             : k == order ? bounded[i][order]
                                          : centred[i][k];
          coefficient[k] = exact.midpoint();
          size += Enclosure(std::abs(coefficient[k]));
          (k == order ? unknown_last : component) += Enclosure(exact.radius());
        }
        // Every term passes at most: weight 1, product 1, sum `order`, subtraction 1.
        for (std::size_t j = 0; j <= degree; ++j) difference[i][j] = 0.0;
        add_powers(coefficient, difference[i]);
        double largest = 0.0;
        for (std::size_t j = 0; j <= degree; ++j) {
          largest = std::max(largest, std::abs(displacement[i][j]));
          difference[i][j] -= displacement[i][j];
        }
        component +=
            error_detail::roundings(order + 3) * (size + Enclosure(largest)) +
            Enclosure(static_cast<double>(order + 1) * std::numeric_limits<double>::denorm_min());
        unknown += component;
      }
      remainder = unknown_last.upper();
      radius = unknown.upper();
      return remainder < infinity && radius < infinity;
    } catch (const UndecidedComparison&) {
      return false;
    }
  }

  static void add_powers(const std::array<double, order + 1>& coefficient,
                         std::array<double, degree + 1>& sum) {
    const auto& powers = constant_table<double, CentredPowers<order, degree>>();
    for (std::size_t k = 0; k <= order; ++k) {
      for (std::size_t j = 0; j <= degree; ++j) sum[j] += powers[k][j] * coefficient[k];
    }
  }

  // Between ξ_k + h and ξ_{k+1} the position stays at the segment's end, and γ moves on by at most
  // gap · max|γ'|.
  void cross_gap(const Ball& gap) {
    const Ball end = Ball(xi_end_) - gap;
    Taylor<Ball, 1> over_gap(end.widened(gap));
    over_gap[1] = gap;
    try {
      const auto bounded = gamma_(over_gap);
      Enclosure moved(0.0);
      for (std::size_t i = 0; i < dimension; ++i) {
        moved += Enclosure(bounded[i][1].enclosure().magnitude());
      }
      upper_ = (Enclosure(upper_) + Enclosure(moved.upper())).upper();
      if (!(upper_ < infinity)) upper_ = infinity;
    } catch (const UndecidedComparison&) {
      upper_ = infinity;
    }
  }

  const Curve& gamma_;
  const PhCurve<A, n>& segment_;
  double xi_begin_, xi_end_;
  double allowance_;
  double per_halving_ = 0.0;
  bool reaches_past_end_ = false;
  double lower_ = 0.0, upper_ = 0.0, at_ = 0.0;
  int work_ = 0;
};

}  // namespace hodograph::certify_detail
