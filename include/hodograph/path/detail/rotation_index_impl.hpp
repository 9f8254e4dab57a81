// SPDX-License-Identifier: MIT
// rotation_index.hpp: the closed form for quintics, subdivision for other degrees, and enclosures.
#pragma once

#include <array>
#include <cmath>
#include <vector>

#include "hodograph/bernstein/range.hpp"
#include "hodograph/bernstein/roots.hpp"
#include "hodograph/path/detail/angle.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/quadratic_turn.hpp"
#include "hodograph/path/detail/turning_polynomial.hpp"
#include "hodograph/path/rotation_index.hpp"

namespace hodograph::path_detail {

/// The two halves of a polynomial, on [0, 1/2] and [1/2, 1], each again on [0, 1].
template <class V, std::size_t n>
std::array<BernsteinPolynomial<V, n>, 2> halves(const BernsteinPolynomial<V, n>& f) {
  using S = scalar_of_t<V>;
  BernsteinPolynomial<V, n> left, right = f;
  for (std::size_t r = 0; r <= n; ++r) {
    left[r] = right[0];
    for (std::size_t i = 0; i + r < n; ++i) right[i] = S(0.5) * (right[i] + right[i + 1]);
  }
  return {left, right};
}

/// The direction of the mean of the coefficients, its largest component about 1; zero where they
/// sum to zero.
template <std::size_t n>
Vector2<double> mean_direction(const BernsteinPolynomial<Complex<double>, n>& w) {
  Vector2<double> sum{};
  for (const Complex<double>& c : w.coefficients()) sum += Vector2<double>{c.re, c.im};
  const int exponent = exponent_of(largest_component(sum));
  return {std::ldexp(sum.x, -exponent), std::ldexp(sum.y, -exponent)};
}

/// The turn of w on [0, 1] by subdivision.
template <std::size_t n>
class TurnBySubdivision {
 public:
  explicit TurnBySubdivision(const BernsteinPolynomial<Complex<double>, n>& w) {
    add(w, turning_polynomial(w), 0);
    const double most = static_cast<double>(n) * pi;
    absolute_ = std::min(absolute_, most);
    signed_ = std::max(-most, std::min(signed_, most));
  }
  double absolute() const { return absolute_; }
  double signed_turn() const { return signed_; }

 private:
  using Preimage = BernsteinPolynomial<Complex<double>, n>;
  using Rate = BernsteinPolynomial<double, 2 * n - 2>;
  // On a piece of this length at a double root of the rate, the turn that is counted with the wrong
  // sign is below its cube, 2^-78.
  static constexpr int deepest_sign = 26;
  // A piece of this length that w still turns about by more than a right angle holds a zero of w
  // within rounding.
  static constexpr int deepest = 52;
  // Far more than a few roots need: reached where numbers vanish below the range of double.
  static constexpr int most_parts = 4096;

  void add(const Preimage& w, const Rate& rate, int depth) {
    int changes = 0;
    double sign = 0.0;
    for (const double c : rate.coefficients()) {
      if (c == 0.0) continue;
      if (sign * c < 0.0) ++changes;
      sign = c;
    }
    if (sign == 0.0) return;
    if (within_half_plane(w)) {
      const double turn = between(w.front(), w.back());
      if (changes == 0 || depth >= deepest_sign) {
        absolute_ += std::abs(turn);
        signed_ += turn;
        return;
      }
      if (changes == 1) {  // one inflection: where exactly matters in second order only
        const Complex<double> middle = w.value(root_of(rate));
        absolute_ += std::abs(between(w.front(), middle)) + std::abs(between(middle, w.back()));
        signed_ += turn;
        return;
      }
    } else if (depth >= deepest || ++parts_ > most_parts) {
      return;
    }
    const auto parts = halves(w);
    const auto rates = halves(rate);
    for (std::size_t i = 0; i < 2; ++i) add(parts[i], rates[i], depth + 1);
  }

  static bool within_half_plane(const Preimage& w) {
    const Vector2<double> d = mean_direction(w);
    for (const Complex<double>& c : w.coefficients()) {
      if (!(0.0 < d.x * c.re + d.y * c.im)) return false;
    }
    return true;
  }
  static double between(const Complex<double>& a, const Complex<double>& b) {
    return angle_of(body_rate_form(a, b), dot(a, b));
  }
  static double root_of(const Rate& rate) {
    double low = 0.0, high = 1.0;
    double sign = 0.0;
    for (std::size_t i = 0; sign == 0.0; ++i) sign = rate[i];
    for (int step = 0; step < deepest_sign + 4; ++step) {
      const double middle = 0.5 * (low + high);
      (rate.value(middle) * sign < 0.0 ? high : low) = middle;
    }
    return 0.5 * (low + high);
  }

  double absolute_ = 0.0, signed_ = 0.0;
  int parts_ = 0;
};

/// The preimage times a power of two, its largest component between 1/2 and 1.
template <std::size_t n>
BernsteinPolynomial<Complex<double>, n> unit_sized(
    const BernsteinPolynomial<Complex<double>, n>& w) {
  double size = 0.0;
  for (const Complex<double>& c : w.coefficients()) size = std::max(size, largest_component(c));
  const int exponent = exponent_of(size);
  return w.mapped([&](const Complex<double>& c) {
    return Complex<double>{std::ldexp(c.re, -exponent), std::ldexp(c.im, -exponent)};
  });
}

/// The turn of w as enclosures.
template <std::size_t n>
class EnclosedTurn {
 public:
  explicit EnclosedTurn(const PlanarPhCurve<n>& curve)
      : w_(EnclosedCurve<Complex<double>, n>(curve).preimage()), rate_(turning_polynomial(w_)) {
    const auto found = isolated_roots(rate_);
    if (!found) return;  // no rate at all: a straight line
    double done = 0.0;
    for (const IsolatedRoot& root : *found) {
      const Enclosure u = narrowed(root);
      add(done, u.lower(), true, 0);
      add(u.lower(), u.upper(), false, 0);
      done = u.upper();
    }
    add(done, 1.0, true, 0);
    const Enclosure most = Enclosure(static_cast<double>(n)) * pi_enclosure();
    absolute_ = {std::max(0.0, absolute_.lower()), std::min(absolute_.upper(), most.upper())};
    signed_ = {std::max(-most.upper(), signed_.lower()), std::min(signed_.upper(), most.upper())};
  }
  const Enclosure& absolute() const { return absolute_; }
  const Enclosure& signed_turn() const { return signed_; }

 private:
  using C = Complex<Enclosure>;
  using Preimage = BernsteinPolynomial<C, n>;
  static constexpr int deepest = 40;
  static constexpr int most_parts = 4096;  // far more than a few roots need

  // A simple root, bisected until where it lies matters at rounding level only (in second order).
  Enclosure narrowed(const IsolatedRoot& root) const {
    constexpr double narrow = 0x1.0p-30;  // its square is 2^-60
    double low = root.u.lower(), high = root.u.upper();
    while (root.kind == RootKind::simple && high - low > narrow) {
      const double middle = 0.5 * (low + high);
      const Enclosure value = rate_.value(Enclosure(middle));
      if (value.contains(0.0)) break;
      ((value.lower() > 0.0 ? 1 : -1) == root.sign_before ? low : high) = middle;
    }
    return {low, high};
  }

  // The part on [a, b], on which the rate keeps its sign or not.
  void add(double a, double b, bool monotone, int depth) {
    if (!(a < b)) return;
    const Preimage w = w_.restricted(Enclosure(a), Enclosure(b));
    const Vector2<double> d = mean_direction(w.mapped([](const C& c) {
      return Complex<double>{c.re.middle(), c.im.middle()};
    }));
    const Enclosure dx(d.x), dy(d.y);
    double nearest = std::numeric_limits<double>::infinity();
    for (const C& c : w.coefficients())
      nearest = std::min(nearest, (dx * c.re + dy * c.im).lower());
    if (nearest > 0.0) {
      const auto angle = [&](const C& c) {
        return arc_tangent((dx * c.im - dy * c.re) / (dx * c.re + dy * c.im));
      };
      const Enclosure turn = angle(w.back()) - angle(w.front());
      signed_ += turn;
      if (monotone) {
        absolute_ += abs(turn);
      } else {
        // |w|² ≥ nearest²/|d|².
        const Enclosure least = square(Enclosure(nearest)) / (square(dx) + square(dy));
        const auto rate = rate_.restricted(Enclosure(a), Enclosure(b));
        const Enclosure length = Enclosure(b) - Enclosure(a), degree(static_cast<double>(n));
        const double most =
            (degree * length * Enclosure(coefficient_hull(rate).magnitude()) / least).upper();
        absolute_ += Enclosure(abs(turn).lower(), std::max(most, abs(turn).lower()));
      }
      return;
    }
    const double middle = 0.5 * (a + b);
    if (depth >= deepest || ++parts_ > most_parts ||
        !(a < middle && middle < b)) {  // a zero of w: any number of its roots
      const double most = (Enclosure(static_cast<double>(n)) * pi_enclosure()).upper();
      signed_ += Enclosure(-most, most);
      absolute_ += Enclosure(0.0, most);
      return;
    }
    add(a, middle, monotone, depth + 1);
    add(middle, b, monotone, depth + 1);
  }

  Preimage w_;
  BernsteinPolynomial<Enclosure, 2 * n - 2> rate_;
  Enclosure absolute_{0.0}, signed_{0.0};
  int parts_ = 0;
};

/// The sum of f over the segments of a path.
template <std::size_t n, class F>
auto sum_over(const PlanarPath<n>& path, const F& f) {
  auto sum = f(path.segment(0));
  for (std::size_t k = 1; k < path.segment_count(); ++k) sum += f(path.segment(k));
  return sum;
}

}  // namespace hodograph::path_detail

namespace hodograph {

template <std::size_t n>
double absolute_rotation_index(const PlanarPhCurve<n>& curve) {
  if constexpr (n == 0) {
    return 0.0;
  } else {
    const auto w = path_detail::unit_sized(curve.preimage());
    if constexpr (n == 2) {
      return 2.0 * path_detail::absolute_turn(w[0], w[1], w[2]);
    } else {
      return 2.0 * path_detail::TurnBySubdivision<n>(w).absolute();
    }
  }
}

template <std::size_t n>
double rotation_index(const PlanarPhCurve<n>& curve) {
  if constexpr (n == 0) {
    return 0.0;
  } else {
    return 2.0 * path_detail::TurnBySubdivision<n>(path_detail::unit_sized(curve.preimage()))
                     .signed_turn();
  }
}

template <std::size_t n>
double absolute_rotation_index(const PlanarPath<n>& path) {
  return path_detail::sum_over(
      path, [](const PlanarPhCurve<n>& curve) { return absolute_rotation_index(curve); });
}
template <std::size_t n>
double rotation_index(const PlanarPath<n>& path) {
  return path_detail::sum_over(path,
                               [](const PlanarPhCurve<n>& curve) { return rotation_index(curve); });
}

template <std::size_t n>
Enclosure absolute_rotation_index_enclosure(const PlanarPhCurve<n>& curve) {
  if constexpr (n == 0) {
    return 0.0;
  } else {
    return Enclosure(2.0) * path_detail::EnclosedTurn<n>(curve).absolute();
  }
}
template <std::size_t n>
Enclosure rotation_index_enclosure(const PlanarPhCurve<n>& curve) {
  if constexpr (n == 0) {
    return 0.0;
  } else {
    return Enclosure(2.0) * path_detail::EnclosedTurn<n>(curve).signed_turn();
  }
}
template <std::size_t n>
RotationIndices rotation_index_enclosures(const PlanarPath<n>& path) {
  RotationIndices sum{0.0, 0.0};
  if constexpr (n > 0) {
    for (const PlanarPhCurve<n>& curve : path.segments()) {
      const path_detail::EnclosedTurn<n> turn(curve);
      sum.absolute += Enclosure(2.0) * turn.absolute();
      sum.with_sign += Enclosure(2.0) * turn.signed_turn();
    }
  }
  return sum;
}
template <std::size_t n>
Enclosure absolute_rotation_index_enclosure(const PlanarPath<n>& path) {
  return rotation_index_enclosures(path).absolute;
}
template <std::size_t n>
Enclosure rotation_index_enclosure(const PlanarPath<n>& path) {
  return rotation_index_enclosures(path).with_sign;
}

}  // namespace hodograph
