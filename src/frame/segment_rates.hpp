// SPDX-License-Identifier: MIT
// The polynomials behind the frames of one segment, over doubles or enclosures.
#pragma once

#include <cstddef>

#include "hodograph/frame/preimage_table.hpp"
#include "rate_series.hpp"
#include "rows.hpp"

namespace hodograph::frame_detail {

/// The coefficients of A on a segment times 2^-exponent, the largest component in [1/2, 1): rates
/// do not depend on the size of the preimage. The exponent is 0 where all are 0.
struct ScaledPreimage {
  Row<Quaternion<double>> a;
  int exponent = 0;
};
ScaledPreimage scaled_preimage(const PreimageTable& path, std::size_t segment);

template <class S>
Row<Quaternion<S>> converted(const Row<Quaternion<double>>& a) {
  Row<Quaternion<S>> result;
  for (const auto& q : a) result.push_back({S(q.w), S(q.x), S(q.y), S(q.z)});
  return result;
}

/// 2N and σ, of degrees 2n - 2 and 2n: the tangential rate of the ERF is 2N/σ per unit u. The
/// weights of the products once for all segments of a path.
template <class S>
class ErfForms {
 public:
  explicit ErfForms(std::size_t degree)
      : degree_(degree),
        turning_(degree > 0 ? degree - 1 : 0, degree > 0 ? degree - 1 : 0),
        square_(degree, degree) {}

  Fraction<S> rate(const Row<Quaternion<S>>& a) const {
    using Span = std::span<const Quaternion<S>>;
    Fraction<S> result;
    if (degree_ == 0) {
      result.numerator = {S(0.0)};
    } else {
      const auto form = [](const auto& p, const auto& q) { return twist_form(p, q); };
      result.numerator = scaled(S(2.0 * static_cast<double>(degree_)),
                                turning_.product(Span(a).first(degree_), Span(a).subspan(1), form));
    }
    result.denominator = square_.product(
        Span(a), Span(a), [](const auto& p, const auto& q) { return speed_form(p, q); });
    return result;
  }

 private:
  std::size_t degree_;
  ProductTable<S> turning_, square_;
};
template <class S>
Fraction<S> erf_rate(const Row<Quaternion<S>>& a) {
  return ErfForms<S>(a.size() - 1).rate(a);
}

/// factor (arg w)' = factor m turning/|w|², m the degree of w.
template <class S>
Fraction<S> argument_rate(const Row<Complex<S>>& w, const S& factor) {
  const auto cross = [](const Complex<S>& p, const Complex<S>& q) { return body_rate_form(p, q); };
  return {scaled(factor * S(static_cast<double>(w.size() - 1)), turning(w, cross)),
          product(w, w, [](const Complex<S>& p, const Complex<S>& q) { return dot(p, q); })};
}

/// The sum of two fractions over the product of their denominators.
template <class S>
Fraction<S> sum(const Fraction<S>& f, const Fraction<S>& g) {
  return {sum(product(f.numerator, g.denominator), product(g.numerator, f.denominator)),
          product(f.denominator, g.denominator)};
}

/// w of a periodic roll at τ: 1 - τ + γ τ e^(-iψ).
struct PeriodicTurn {
  double gamma = 1.0;
  double cosine = 1.0, sine = 0.0;  ///< of ψ
  Complex<double> at(double tau) const {
    return {(1.0 - tau) + gamma * tau * cosine, -(gamma * tau * sine)};
  }
};

/// The complex polynomial c = V₃ - i V₂ of a segment (up to a positive factor) without its zeros on
/// [0, 1], and these: the places where the curvature vanishes.
struct NormalDirection {
  Row<Complex<double>> c;         ///< empty where the segment is straight
  std::vector<double> flips;      ///< u in (0, 1), ascending, where the normal changes sides
  std::vector<double> roundings;  ///< how far each may be off
};
NormalDirection normal_direction(const Row<Quaternion<double>>& a);

/// How the preimage turns from the end of a segment to the start of another.
struct KnotTurn {
  double roll = 0.0;  ///< by which the ERF jumps, radians in (-π, π]; 0 where it is rounding
  double cosine = 1.0, sine = 0.0;  ///< of half the roll with the sign of the preimage
  bool breaks = false;              ///< the tangents differ
  double angle = 0.0, allowed = 0.0;
};
/// Domain: |A| > 0 on both sides.
KnotTurn knot_turn(const Row<Quaternion<double>>& before, const Row<Quaternion<double>>& after);
/// `breaks` of the same alone, which needs no angle.
bool tangent_breaks(const Row<Quaternion<double>>& before, const Row<Quaternion<double>>& after);

}  // namespace hodograph::frame_detail
