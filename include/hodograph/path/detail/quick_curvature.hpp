// SPDX-License-Identifier: MIT
// The extremes of the curvature of one planar PH curve in plain double precision, with bounds of
// the rounding known beforehand: rigorous like the general search, for a small part of its time.
// What it cannot settle it leaves to that search.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

#include "hodograph/bernstein/range.hpp"
#include "hodograph/curve/ph_curve.hpp"
#include "hodograph/foundation/answer.hpp"
#include "hodograph/foundation/scalar.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"

namespace hodograph::path_detail {

/// The extremes of two functions together.
inline Extremes joined(const Extremes& a, const Extremes& b) {
  return {{std::min(a.minimum.lower(), b.minimum.lower()),
           std::min(a.minimum.upper(), b.minimum.upper())},
          {std::max(a.maximum.lower(), b.maximum.lower()),
           std::max(a.maximum.upper(), b.maximum.upper())}};
}

/// Bounds of rounding, in units of u = ε/2 and of a bound M of |w_i|². Each is a count of roundings
/// on the way of a term, times a bound of the sum of the terms' sizes (Bernstein products have
/// weights that sum to 1); terms in u² are covered by `whole`.
///   τ: |τ_i| ≤ M; weight 1, its product 1, the form 2, at most n - 1 sums: n + 3.
///   σ: |σ_i| ≤ M; scaled coefficients 2, the form 2, at most n/2 + 1 sums, last factor 2: n + 7.
///   τ' and σ' are at most 4(n - 1) M and 4n M: twice the error of the coefficients times the
///   degree, and 2 roundings.
///   A product of polynomials a b: E_a |b| + |a| E_b + (2 + number of terms) |a||b|.
template <std::size_t n>
struct CurvatureRounding {
  static constexpr double m = static_cast<double>(n);
  static constexpr double turning = m + 3, speed = m + 7;
  static constexpr double turning_rate_size = 4 * (m - 1), speed_rate_size = 4 * m;
  static constexpr double turning_rate = turning_rate_size * (turning + 2);
  static constexpr double speed_rate = speed_rate_size * (speed + 2);
  static constexpr double slope_size = turning_rate_size + 2 * speed_rate_size;
  static constexpr double slope = speed * turning_rate_size + turning_rate +
                                  2 * m * turning_rate_size + 2 * turning * speed_rate_size +
                                  2 * speed_rate + 2 * (2 * m + 1) * speed_rate_size + slope_size;
  /// w and w'/n at a point by de Casteljau's algorithm, in units of u and the square root of M: a
  /// component passes 3 roundings a level, n levels (n - 1, twice, and a difference of at most 2
  /// for the rate); both components together are at most √2 times as far off.
  static constexpr double value = 1.5 * 3 * m, rate = 1.5 * (6 * (m - 1) + 2);
  /// σ², of degree 4n; an elevated τ, whose weights are those of a product with 1.
  static constexpr double squared_speed = 2 * speed + 2 * m + 7;
  static constexpr double elevated_turning = turning + 2 * m + 1;
  /// All counts are below 2^20, so that terms in u² are less than 2^-30 of the bound; M is rounded
  /// three times.
  static constexpr double whole = 1.0 + 0x1.0p-20;
};

/// σ, τ and M of a curve, and what they tell. Sizes far from 1, where products could leave the
/// range of numbers, are not its business: everything it asks is then left open.
template <std::size_t n>
  requires(n > 0)
class QuickCurvature {
 public:
  using Rounding = CurvatureRounding<n>;
  static constexpr std::size_t degree = curvature_slope_degree(n);

  explicit QuickCurvature(const PhCurve<Complex<double>, n>& curve)
      : preimage_(curve.preimage()),
        step_(curve.parameter_step()),
        turning_(turning_polynomial(curve.preimage())),
        speed_(planar_speed(curve.preimage())),
        // The largest re² + im² of the coefficients: speed_bound(), 2 roundings from it.
        size_(curve.speed_bound() * Rounding::whole) {
    // Sixth powers of sizes and a quotient of them stay in range.
    constexpr double small = 0x1.0p-100, large = 0x1.0p+100;
    in_range_ = size_ > small && size_ < large && step_ > small && step_ < large;
    root_size_ = std::sqrt(size_) * Rounding::whole;
  }

  /// The extremes of κ: exact up to a few thousand roundings, or nothing.
  std::optional<Extremes> extremes() const {
    if (!in_range_) return std::nullopt;
    const auto& w = preimage_.coefficients();
    if (std::all_of(w.begin(), w.end(), [&](const auto& c) { return c == w[0]; })) {
      return Extremes{Enclosure(0.0), Enclosure(0.0)};  // a straight line at constant speed
    }
    Found found;
    const bool ends = note_end(found, turning_.front(), speed_.front()) &&
                      note_end(found, turning_.back(), speed_.back());
    if (!ends || !search(found)) return std::nullopt;
    return finished(found);
  }

  /// Whether |κ| ≤ limit everywhere: the signs of (limit h/2n) σ² ∓ τ. limit ≥ 0 and finite.
  Answer stays_within(double limit) const {
    const double k = limit * step_ * (0.5 / static_cast<double>(n));
    if (!in_range_ || !(k * size_ < largest_ratio)) return Answer::undecided;
    constexpr std::size_t d = 4 * n;
    const auto square = symmetric_square(speed_, [](double a, double b) { return a * b; });
    const auto turning = elevated_turning(std::make_index_sequence<d + 1>{});
    // k has 3 roundings, the product and the sum one each.
    const double error =
        Rounding::whole * unit * size_ *
        (k * size_ * (Rounding::squared_speed + 5) + Rounding::elevated_turning + 1);
    std::array<double, d + 1> below, above;
    double least = largest_ratio * size_;
    for (std::size_t i = 0; i <= d; ++i) {
      const double bound = k * square[i];
      below[i] = bound - turning[i];
      above[i] = bound + turning[i];
      least = std::min(least, std::min(below[i], above[i]));
    }
    if (least > error) return Answer::yes;
    const double ends = std::min(std::min(below[0], above[0]), std::min(below[d], above[d]));
    if (ends < -error) return Answer::no;
    const Answer first = stays_positive<d>(below, error);
    if (first != Answer::yes) return first;
    return stays_positive<d>(above, error);
  }

 private:
  static constexpr double unit = 0.5 * epsilon<double>();
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// k M above this would mean |κ| beyond 2^100 times what the sizes allow.
  static constexpr double largest_ratio = 0x1.0p+200;
  static constexpr int greatest_depth = 30;
  static constexpr std::size_t greatest_stack = 32;  // depth first: at most one piece a level
  /// The remainder that settles a piece, relative to the largest κ found.
  static constexpr double settled = 0x1.0p-40;

  /// Of τ/σ²: an upper bound of the least value and a lower bound of it, the same of the largest.
  struct Found {
    double least_low = infinity, least_high = infinity;
    double most_low = -infinity, most_high = -infinity;
    double size() const { return std::max(-least_low, most_high); }
  };
  using Coefficients = std::array<double, degree + 1>;
  struct Piece {
    double a, length, error;
    int depth;
    Coefficients c;
  };

  /// Takes notice of τ/σ² where τ and σ are known to within the errors; with remainder ≥ 0 also of
  /// values that far from it, which need not be attained. For q = e_σ/σ ≤ 1/8,
  /// (1 - q)^-2 ≤ 1 + 3q < 2: the quotient is within (2 e_τ + 3 q |τ|)/σ² of the computed one and 4
  /// roundings.
  static bool note(Found& found, double turning, double speed, double turning_error,
                   double speed_error, double remainder = 0.0) {
    if (!(speed_error <= 0.125 * speed)) return false;
    const double r = 1.0 / speed, r2 = r * r, value = turning * r2, size = std::abs(turning);
    const double margin =
        Rounding::whole *
        ((2.0 * turning_error + 3.0 * speed_error * r * size) * r2 + 8.0 * unit * std::abs(value));
    found.least_high = std::min(found.least_high, value + margin);
    found.most_low = std::max(found.most_low, value - margin);
    found.least_low = std::min(found.least_low, value - (margin + remainder));
    found.most_high = std::max(found.most_high, value + (margin + remainder));
    return true;
  }

  /// The same at an end, where σ = |w_0|² and τ = Im(w_0* w_1): 2 roundings of their terms.
  bool note_end(Found& found, double turning, double speed) const {
    constexpr double error = 3.0 * unit;
    return note(found, turning, speed, error * std::sqrt(speed * size_), error * speed);
  }

  /// The same at u, with τ/σ² within `reach` of u as well: |d(τ/σ²)/du| ≤ rate/σ³ there. Over the
  /// reach |w| changes by at most 2nM^(1/2) reach: no more than 1/64 of it, and neither is its
  /// error, else nothing is said.
  bool note_near(Found& found, double u, double reach, double rate) const {
    std::array<Complex<double>, n + 1> w = preimage_.coefficients();
    const double v = 1.0 - u;
#pragma GCC unroll 64
    for (std::size_t level = n; level > 1; --level) {
#pragma GCC unroll 64
      for (std::size_t i = 0; i < level; ++i) w[i] = v * w[i] + u * w[i + 1];
    }
    const Complex<double> value = v * w[0] + u * w[1], slope = w[1] - w[0];
    const double speed = dot(value, value), size = std::sqrt(speed);
    const double value_error = Rounding::value * unit * root_size_;
    const double slope_error = Rounding::rate * unit * root_size_;
    constexpr double share = 0x1.0p-6;  // of |w|
    const double change = 2.0 * static_cast<double>(n) * root_size_ * reach;
    if (!(change <= share * size && value_error <= share * size)) return false;
    const double slope_size = std::sqrt(dot(slope, slope)) + slope_error;
    const double turning_error = Rounding::whole * ((size + value_error) * slope_error +
                                                    slope_size * (value_error + 3.0 * unit * size));
    const double speed_error = Rounding::whole * (3.0 * value_error + 3.0 * unit * size) * size;
    const double r = 1.0 / speed;
    constexpr double growth = 1.5;  // (1 - 2/64)^-6 < 1.3, and roundings
    return note(found, cross(value, slope), speed, turning_error, speed_error,
                growth * reach * rate * r * r * r);
  }

  /// Finds the zeros of f and takes notice of κ at each; false where it gives up.
  bool search(Found& found) const {
    std::array<Piece, greatest_stack> stack;
    const auto slope = curvature_slope(turning_, speed_);
    stack[0] = {0.0, 1.0, Rounding::whole * Rounding::slope * unit * size_ * size_, 0,
                slope.coefficients()};
    std::size_t count = 1;
    for (int budget = 4 * greatest_depth; count > 0; --budget) {
      if (budget == 0) return false;
      Piece& piece = stack[count - 1];
      bool unknown = false;
      int variations = 0, last = 0;
      double size = 0.0;
      for (const double c : piece.c) {
        size = std::max(size, std::abs(c));
        const int sign = c > piece.error ? 1 : c < -piece.error ? -1 : 0;
        unknown = unknown || sign == 0;
        variations += sign * last < 0 ? 1 : 0;
        last = sign == 0 ? last : sign;
      }
      if (!unknown && variations == 0) {
        --count;
        continue;
      }
      // One change of sign for certain: one zero. A coefficient of unknown sign between two of the
      // same sign could hide two changes.
      if (variations == 1 && (!unknown || one_variation(piece)) && note_zero(found, piece)) {
        --count;
        continue;
      }
      if (piece.depth > 2) {
        // The κ to compare with may be here alone, as in the middle of a corner, straight at its
        // ends.
        const double middle = piece.a + 0.5 * piece.length;
        static_cast<void>(note_near(found, middle, 0.0, 0.0));
        // f is so small that it does not matter: |κ - κ(middle)| ≤ max|f|/σ³ · length/2.
        if (size * piece.length <= settled_slope(found, piece) &&
            note_near(found, middle, 0.5 * piece.length, size + piece.error)) {
          --count;
          continue;
        }
      }
      if (piece.depth == greatest_depth || count == greatest_stack) return false;
      split(piece, stack[count], size);
      ++count;
    }
    return true;
  }

  /// What max|f| times the length may be so that the remainder is settled.
  double settled_slope(const Found& found, const Piece& piece) const {
    const double speed = speed_.value(piece.a + 0.5 * piece.length);
    return settled * found.size() * (speed * speed) * speed;
  }

  /// Whether the signs change exactly once whatever those of the unknown coefficients: the unknown
  /// ones lie between the last of one sign and the first of the other.
  static bool one_variation(const Piece& piece) {
    const auto sign = [&](std::size_t i) {
      return piece.c[i] > piece.error ? 1 : piece.c[i] < -piece.error ? -1 : 0;
    };
    if (sign(0) == 0 || sign(degree) == 0) return false;
    std::size_t i = 0, j = degree;
    while (sign(i + 1) == sign(0)) ++i;
    while (sign(j - 1) == sign(degree)) --j;
    for (std::size_t k = i + 1; k < j; ++k) {
      if (sign(k) != 0) return false;
    }
    return true;
  }

  /// f and df/dt at t of a piece's own parameter. Weights 2 degree roundings, their products and
  /// sums degree + 1, the last step 3.
  static std::array<double, 2> value_and_rate(const Coefficients& c, double t) {
    const auto weights = bernstein_values<degree - 1>(t);
    double left = 0.0, right = 0.0;
#pragma GCC unroll 64
    for (std::size_t i = 0; i < degree; ++i) {
      left += weights[i] * c[i];
      right += weights[i] * c[i + 1];
    }
    return {(1.0 - t) * left + t * right, static_cast<double>(degree) * (right - left)};
  }

  /// The one zero of f on a piece whose coefficients change sign once: bracketed by certain signs,
  /// and κ noted there. Newton's steps, kept inside the bracket. Within δ of the zero |f| ≤ δ
  /// max|f'|, and within δ of t |f'| ≤ |f'(t)| + δ max|f''|.
  bool note_zero(Found& found, const Piece& piece) const {
    const Coefficients& c = piece.c;
    const double direction = c[degree] > 0.0 ? 1.0 : -1.0;
    double size = 0.0, bend = 0.0;
    std::size_t change = 0;
    for (std::size_t i = 0; i < degree; ++i) {
      size = std::max(size, std::abs(c[i]));
      if (direction * c[i] <= 0.0 && direction * c[i + 1] > 0.0) change = i;
    }
    size = std::max(size, std::abs(c[degree]));
    for (std::size_t i = 0; i + 2 <= degree; ++i) {
      bend = std::max(bend, std::abs((c[i + 2] - c[i + 1]) - (c[i + 1] - c[i])));
    }
    constexpr double d = static_cast<double>(degree);
    const double bend_bound = d * (d - 1.0) * (bend + 4.0 * piece.error);
    const double error = piece.error + (3.0 * d + 4.0) * unit * size;
    double t = (static_cast<double>(change) + c[change] / (c[change] - c[change + 1])) / d;
    double low = 0.0, high = 1.0;
    constexpr double close = 0x1.0p-21;  // the remainder is about the square of it
    constexpr int most_steps = 16;
    for (int step = 0; step < most_steps; ++step) {
      const auto [value, rate] = value_and_rate(c, t);
      if (direction * value > error) high = t;
      if (direction * value < -error) low = t;
      const double slope = std::abs(rate), next = t - value / rate;
      if (!(next > low && next < high)) {
        t = 0.5 * (low + high);
        continue;
      }
      // At next ± reach, at most 2m from t, f has the signs of its tangent at t if that exceeds
      // 2 max|f''| m², the error of the value and the error of the slope over 2m.
      const double m = std::abs(next - t) + 4.0 * error / slope;
      const double doubt = 2.0 * bend_bound * m * m + error * (1.0 + 4.0 * d * m);
      const double reach = Rounding::whole * doubt / slope;
      t = next;
      if (!(reach <= m && reach <= close)) continue;
      // u = a + length t is rounded twice; the zero is within reach of t, and so is u.
      const double within = reach * piece.length + 2.0 * epsilon<double>();
      const double most_slope = slope + 2.0 * d * error + (m + 2.0 * reach) * bend_bound;
      return note_near(found, std::min(1.0, piece.a + piece.length * t), within,
                       most_slope * (within / piece.length));
    }
    return false;
  }

  /// The left half goes to `left`, the right one stays. An average is one rounding, and each
  /// coefficient is the last of at most `degree` of them.
  static void split(Piece& piece, Piece& left, double size) {
    left.a = piece.a;
    left.length = piece.length = 0.5 * piece.length;
    piece.a += left.length;
    left.depth = ++piece.depth;
    left.error = piece.error =
        piece.error + static_cast<double>(degree) * unit * Rounding::whole * size;
    halve(piece.c, left.c);
  }
  template <std::size_t size>
  static void halve(std::array<double, size>& c, std::array<double, size>& left) {
#pragma GCC unroll 64
    for (std::size_t r = 0; r < size; ++r) {
      left[r] = c[0];
#pragma GCC unroll 64
      for (std::size_t i = 0; i + 1 + r < size; ++i) c[i] = 0.5 * (c[i] + c[i + 1]);
    }
  }

  Extremes finished(const Found& found) const {
    // 2n/h: one rounding, and one of the product.
    const double factor = 2.0 * static_cast<double>(n) / step_;
    const auto down = [&](double x) {
      return factor * x - 2.0 * epsilon<double>() * std::abs(factor * x);
    };
    const auto up = [&](double x) {
      return factor * x + 2.0 * epsilon<double>() * std::abs(factor * x);
    };
    return {{down(found.least_low), up(found.least_high)},
            {down(found.most_low), up(found.most_high)}};
  }

  template <std::size_t... i>
  std::array<double, sizeof...(i)> elevated_turning(std::index_sequence<i...>) const {
    BernsteinPolynomial<double, 2 * n + 2> one;
    return product(turning_, one, [](double a, double) { return a; }).coefficients();
  }

  /// Whether the polynomial with these coefficients, each known to within the error, is positive.
  template <std::size_t d>
  static Answer stays_positive(const std::array<double, d + 1>& coefficients, double error) {
    struct Part {
      std::array<double, d + 1> c;
      int depth;
    };
    constexpr int deepest = 10;
    std::array<Part, deepest + 1> stack;
    stack[0] = {coefficients, 0};
    double size = 0.0;
    for (const double c : coefficients) size = std::max(size, std::abs(c));
    // The deepest part has passed `deepest` times d averages.
    error += static_cast<double>(deepest * d) * unit * Rounding::whole * size;
    std::size_t count = 1;
    while (count > 0) {
      Part& part = stack[count - 1];
      const double least = *std::min_element(part.c.begin(), part.c.end());
      if (least > error) {
        --count;
        continue;
      }
      if (std::min(part.c[0], part.c[d]) < -error) return Answer::no;
      if (part.depth == deepest) return Answer::undecided;
      stack[count].depth = ++part.depth;
      halve(part.c, stack[count].c);
      ++count;
    }
    return Answer::yes;
  }

  BernsteinPolynomial<Complex<double>, n> preimage_;
  double step_;
  BernsteinPolynomial<double, turning_degree(n)> turning_;
  BernsteinPolynomial<double, 2 * n> speed_;
  double size_, root_size_ = 0.0;  ///< M and its square root
  bool in_range_ = false;
};

}  // namespace hodograph::path_detail
