// SPDX-License-Identifier: MIT
// The work behind segment_error: one segment against Taylor models of the given curve; and a path,
// whose short segments share a model.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "hodograph/certify/detail/taylor_model.hpp"
#include "hodograph/path/path.hpp"

namespace hodograph::certify_detail {

template <class Curve, PreimageAlgebra A, std::size_t n>
class SegmentCertifier {
 public:
  /// The order of the remainder. Ten coefficients make the remainder on a segment smaller than the
  /// error of any C⁴ interpolant there by the factor |γ^(11)| h / (22 |γ^(10)|).
  static constexpr std::size_t order = 11;
  static constexpr std::size_t dimension = point_t<A>::dimension;
  static constexpr std::size_t degree = std::max(order, PhCurve<A, n>::degree);
  using Model = TaylorModel<dimension, order>;

  SegmentCertifier(const Curve& gamma, const PhCurve<A, n>& segment, double xi_begin, double xi_end)
      : gamma_(gamma),
        segment_(segment),
        xi_begin_(xi_begin),
        xi_end_(xi_end),
        allowance_(position_error(segment)),
        gap_(Ball(xi_end) - (Ball(xi_begin) + Ball(segment.parameter_step()))),
        reaches_past_end_(!arb_is_nonnegative(gap_.get())) {
    const auto raised = segment_.displacement().template elevated<degree>();
    double largest = 0.0;
    for (std::size_t i = 0; i < dimension; ++i) {
      for (std::size_t j = 0; j <= degree; ++j) {
        displacement_[i][j] = raised[j][i];
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
    raising_ = PhCurve<A, n>::degree < degree ? per_halving_ : 0.0;
  }

  /// The bound, by models of the segment and, where they are poor, of its halves.
  ErrorBound run() {
    Difference displacement = displacement_;
    visit(displacement, 0.0, 1.0, raising_, 0);
    return result();
  }

  /// The bound by the given model of γ - start on the whole segment, in `bound`; false where
  /// what is unknown of the model would show in it.
  bool run_with(const Model& model, ErrorBound& bound) {
    if (!accept(model, displacement_, 0.0, 1.0, raising_, Demand::high)) return false;
    bound = result();
    return true;
  }

 private:
  using Difference = error_detail::Components<dimension, degree>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// Halvings of a segment before it is given up, and intervals looked at altogether.
  static constexpr int depth_limit = 12;
  static constexpr int work_limit = 512;
  /// A model is good where its remainder is below this part of the difference, or of the allowance
  /// for positions.
  static constexpr double remainder_part = 1.0 / 32.0;

  // What is asked of a model before it is used.
  enum class Demand { none, usual, high };

  // The segment's displacement on [begin, begin + width] of u, wrong by at most `error`.
  void visit(Difference& displacement, double begin, double width, double error, int depth) {
    ++work_;
    const bool may_halve = depth < depth_limit && work_ < work_limit;
    const Ball h(segment_.parameter_step());
    Model model;
    if (model.expand(gamma_, Ball(xi_begin_) + h * Ball(begin + 0.5 * width), h * Ball(0.5 * width),
                     segment_.start())) {
      const Demand demand = may_halve ? Demand::usual : Demand::none;
      if (accept(model, displacement, begin, width, error, demand)) return;
    } else if (!may_halve) {
      upper_ = infinity;
      return;
    }
    Difference right;
    error_detail::halve<dimension, degree>(displacement, right);
    const double next = (Enclosure(error) + Enclosure(per_halving_)).upper();
    visit(displacement, begin, 0.5 * width, next, depth + 1);
    if (upper_ == infinity && lower_ > 0.0) return;
    visit(right, begin + 0.5 * width, 0.5 * width, next, depth + 1);
  }

  // Counts the difference of model and displacement on [begin, begin + width] of u, unless the
  // model falls short of the demand.
  bool accept(const Model& model, const Difference& displacement, double begin, double width,
              double error, Demand demand) {
    double rounding = 0.0;
    const Difference f = difference<dimension, order, degree>(model, displacement, rounding);
    const Enclosure known = Enclosure(model.radius) + Enclosure(rounding) + Enclosure(error);
    const double total = (known + Enclosure(model.remainder)).upper();
    const NormBound bound = error_detail::largest_norm<dimension, degree>(f, total);
    const double upper = bound.norm.upper();
    if (demand == Demand::usual) {
      const bool good = model.remainder <= remainder_part * std::max(upper, allowance_) ||
                        model.remainder <= rounding || upper <= upper_;
      if (!good) return false;
    } else if (demand == Demand::high) {
      if (!(total <= std::max(0.5 * remainder_part * upper, 0.5 * allowance_))) return false;
    }
    // At the very end the exact segment may reach past ξ_{k+1}; that point is not a witness.
    const double at = begin + bound.at * width;
    if (bound.norm.lower() > lower_ && !(reaches_past_end_ && at >= 1.0)) {
      lower_ = bound.norm.lower();
      at_ = at;
    }
    upper_ = std::max(upper_, upper);
    return true;
  }

  ErrorBound result() {
    if (!arb_is_zero(gap_.get()) && !reaches_past_end_) cross_gap();
    const Enclosure allowance(allowance_);
    const double upper = (Enclosure(upper_) + allowance).upper();
    const bool certified = upper < infinity;
    const double lower = std::max(0.0, (Enclosure(lower_) - allowance).lower());
    return {Enclosure(lower, certified ? upper : infinity), certified,
            std::min(xi_end_, xi_begin_ + at_ * segment_.parameter_step())};
  }

  // Between ξ_k + h and ξ_{k+1} the position stays at the segment's end, and γ moves on by at most
  // gap · max|γ'|.
  void cross_gap() {
    const Ball end = Ball(xi_end_) - gap_;
    Taylor<Ball, 1> over_gap(end.widened(gap_));
    over_gap[1] = gap_;
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
  Ball gap_;  // ξ_{k+1} - (ξ_k + h): up to half an ulp
  bool reaches_past_end_;
  Difference displacement_;
  double per_halving_ = 0.0, raising_ = 0.0;
  double lower_ = 0.0, upper_ = 0.0, at_ = 0.0;
  int work_ = 0;
};

/// The segments of a path in order. Where segments are so short that rounding rules their errors,
/// one model serves a block of them.
template <class Curve, PreimageAlgebra A, std::size_t n>
class PathCertifier {
 public:
  PathCertifier(const Curve& gamma, const Path<A, n>& path) : gamma_(gamma), path_(path) {}

  /// The bound of the next segment.
  ErrorBound next() {
    const std::size_t k = next_++;
    if (k >= block_end_) start_block(k);
    const auto& segment = path_.segment(k);
    Certifier certifier(gamma_, segment, path_.knots()[k], path_.knots()[k + 1]);
    if (block_known_) {
      ErrorBound bound;
      if (certifier.run_with(part_of_block(k), bound)) {
        if (next_ == block_end_) block_size_ = std::min(2 * block_size_, largest_block);
        return bound;
      }
      abandon_block();
      return Certifier(gamma_, segment, path_.knots()[k], path_.knots()[k + 1]).run();
    }
    return certifier.run();
  }

 private:
  using Certifier = SegmentCertifier<Curve, A, n>;
  static constexpr std::size_t largest_block = 32;
  /// Segments done one by one after blocks have failed, before another is tried.
  static constexpr std::size_t pause = 64;

  void start_block(std::size_t k) {
    const std::size_t last = std::min(k + block_size_, path_.segment_count()) - 1;
    if (last == k) {
      block_known_ = false;
      block_end_ = k + 1;
      return;
    }
    block_end_ = last + 1;
    block_begin_ = path_.knots()[k];
    block_origin_ = path_.segment(k).start();
    // A little longer than the segments, whose ends are rounded.
    block_length_ = (path_.knots()[last + 1] - block_begin_) * (1.0 + 4.0 * epsilon<double>());
    const Ball half = Ball(block_length_) * Ball(0.5);
    block_known_ = block_.expand(gamma_, Ball(block_begin_) + half, half, block_origin_);
    if (!block_known_) abandon_block();
  }

  void abandon_block() {
    block_known_ = false;
    block_size_ /= 2;
    block_end_ = next_;
    if (block_size_ <= 1) {
      block_size_ = 2;
      block_end_ = std::min(next_ + pause, path_.segment_count());
    }
  }

  // s = alpha + beta s' with the segment's s' in [-1, 1]. The quotients pass three roundings, the
  // sum two: together below 8 ε.
  typename Certifier::Model part_of_block(std::size_t k) const {
    const auto& segment = path_.segment(k);
    const double beta = segment.parameter_step() / block_length_;
    const double left = (path_.knots()[k] - block_begin_) / block_length_;
    const double alpha = (2.0 * left - 1.0) + beta;
    return block_.restricted(alpha, beta, 8.0 * epsilon<double>(), segment.start() - block_origin_);
  }

  const Curve& gamma_;
  const Path<A, n>& path_;
  std::size_t next_ = 0, block_end_ = 0, block_size_ = 8;
  bool block_known_ = false;
  double block_begin_ = 0.0, block_length_ = 0.0;
  point_t<A> block_origin_{};
  typename Certifier::Model block_;
};

}  // namespace hodograph::certify_detail
