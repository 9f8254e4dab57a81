// SPDX-License-Identifier: MIT
// A first guess of the inverse of a curve's arc length: 136 bytes a segment, single precision.
#pragma once

#include <array>
#include <cstddef>

#include "hodograph/curve/ph_curve.hpp"

namespace hodograph {

/// u as a function of x = s/length, a cubic on each of the eight pieces between u = 0, 1/8, ..., 1
/// that has the curve's values and slopes at both ends; where the curve nearly rests the slopes
/// are limited to three times the chord's, which keeps every piece increasing.
/// Only a guess: whoever uses it corrects it with the exact polynomial.
class ArcLengthTable {
 public:
  static constexpr std::size_t pieces = 8;

  ArcLengthTable() = default;
  template <PreimageAlgebra A, std::size_t n>
  explicit ArcLengthTable(const PhCurve<A, n>& curve);

  /// An approximation of u at the arc length s, in [0, 1]. Domain: s and the length positive.
  double guess(double s) const {
    const float x = static_cast<float>(s * inverse_length_);
    int piece = -1;
    for (std::size_t k = 0; k < pieces; ++k) piece += begin_[k] <= x ? 1 : 0;
    if (!(piece > 0)) piece = 0;
    const auto i = static_cast<std::size_t>(piece);
    const float y = x - begin_[i];
    const float u =
        static_cast<float>(piece) * width + y * (slope_[i] + y * (quadratic_[i] + y * cubic_[i]));
    return 0.0F <= u && u <= 1.0F ? static_cast<double>(u) : 0.5;
  }

 private:
  static constexpr float width = 1.0F / static_cast<float>(pieces);
  static constexpr float limited(float slope, float limit) { return slope < limit ? slope : limit; }

  /// B_i^n(k/8), a row for every i and a column for every k = 0..7.
  template <class R, std::size_t n>
  struct NodeValues {
    constexpr std::array<std::array<R, pieces>, n + 1> operator()() const {
      std::array<std::array<R, pieces>, n + 1> rows{};
      for (std::size_t k = 0; k < pieces; ++k) {
        const auto values = bernstein_values<n>(R(static_cast<double>(k) / pieces));
        for (std::size_t i = 0; i <= n; ++i) rows[i][k] = values[i];
      }
      return rows;
    }
  };

  double inverse_length_ = 0.0;
  std::array<float, pieces> begin_{};  // x where each piece begins
  std::array<float, pieces> slope_{}, quadratic_{}, cubic_{};
};

template <PreimageAlgebra A, std::size_t n>
ArcLengthTable::ArcLengthTable(const PhCurve<A, n>& curve) {
  using S = typename A::Scalar;
  constexpr std::size_t degree = 2 * n + 1;
  const double length = to_double(curve.arc_length());
  inverse_length_ = 1.0 / length;
  if (!(inverse_length_ > 0.0) || !is_finite(inverse_length_)) {
    inverse_length_ = 0.0;
    return;
  }
  const double unit = inverse_length_ * to_double(curve.parameter_step());  // dx/du is unit · σ

  // A guess in single precision: double will do for every scalar. The loops run over the nodes, so
  // that the compiler puts them into lanes.
  std::array<double, pieces> x{}, rate{};
  const auto& c = curve.integral().coefficients();
  const auto& a = curve.preimage().coefficients();
  const auto& length_rows = constant_table<double, NodeValues<double, degree>>();
  const auto& preimage_rows = constant_table<double, NodeValues<double, n>>();
  for (std::size_t i = 1; i <= degree; ++i) {
    const double share = to_double(c[i].arc_length) * inverse_length_;
    for (std::size_t k = 0; k < pieces; ++k) x[k] += share * length_rows[i][k];
  }
  for (std::size_t component = 0; component < A::dimension; ++component) {
    std::array<double, pieces> value{};
    for (std::size_t i = 0; i <= n; ++i) {
      const double share = to_double(a[i][component]);
      for (std::size_t k = 0; k < pieces; ++k) value[k] += share * preimage_rows[i][k];
    }
    for (std::size_t k = 0; k < pieces; ++k) rate[k] += (unit * value[k]) * value[k];
  }
  std::array<float, pieces> next_begin, slope_here, slope_next;
  for (std::size_t k = 0; k < pieces; ++k) {
    begin_[k] = static_cast<float>(x[k]);
    slope_here[k] = static_cast<float>(rate[k]);
  }
  for (std::size_t k = 0; k + 1 < pieces; ++k) {
    next_begin[k] = begin_[k + 1];
    slope_next[k] = slope_here[k + 1];
  }
  next_begin.back() = 1.0F;
  slope_next.back() = static_cast<float>(unit * to_double(S(speed_form(a.back(), a.back()))));
  for (std::size_t k = 0; k < pieces; ++k) {
    // With the chord's slope q = width/span: the cubic with end slopes p and r, at most 3q. A piece
    // without a span is never asked: what is divided by zero here is not used.
    const float share = 1.0F / (next_begin[k] - begin_[k]);
    const float chord = width * share, limit = 3.0F * chord;
    const float p = limited(1.0F / slope_here[k], limit);
    const float r = limited(1.0F / slope_next[k], limit);
    slope_[k] = p;
    quadratic_[k] = (3.0F * chord - 2.0F * p - r) * share;
    cubic_[k] = (p + r - 2.0F * chord) * (share * share);
  }
}

}  // namespace hodograph
