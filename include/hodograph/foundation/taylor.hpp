// SPDX-License-Identifier: MIT
// Truncated Taylor series as a scalar: forward differentiation to any fixed order.
//
// Taylor<S, K> stands for f(t) = Σ_{k=0..K} c_k t^k + O(t^{K+1}), c_k = f^(k)(0)/k!. Evaluating a
// function template at Taylor<S, K>::variable(x) yields its derivatives at x up to order K, exact
// up to rounding: K = 1 differentiates a construction with respect to its data, K = 4 turns a
// callable into C⁴ Hermite data, and S may be an interval, which gives rigorous derivatives.
//
// Source of the recurrences: each elementary function satisfies a linear first-order differential
// equation; comparing coefficients gives them (Moore 1966; Griewank and Walther 2008, ch. 13).
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

/// Σ_{j=first..last} a_j b_{k-j}, 0 where first > last: the sum that arithmetic on series consists
/// of. Called unqualified, so that a scalar may bring a faster or sharper one.
template <class S>
constexpr S convolution(const S* a, const S* b, std::size_t k, std::size_t first,
                        std::size_t last) {
  if (first > last) return S(0);
  S sum = a[first] * b[k - first];
  for (std::size_t j = first + 1; j <= last; ++j) sum = sum + a[j] * b[k - j];
  return sum;
}

/// a / count for a whole number; another hook of the same kind.
template <class S>
constexpr S divided_by_count(const S& a, std::size_t count) {
  return a / S(static_cast<double>(count));
}

template <class S, std::size_t K>
class Taylor {
 public:
  using Base = S;
  static constexpr std::size_t order = K;

  constexpr Taylor() = default;
  /// A constant.
  constexpr Taylor(const S& constant) { c_[0] = constant; }
  template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, S>)
  constexpr Taylor(T constant) {
    c_[0] = S(constant);
  }
  /// The independent variable at x: x + t.
  static constexpr Taylor variable(const S& x) {
    Taylor result(x);
    if constexpr (K > 0) result.c_[1] = S(1);
    return result;
  }

  /// The coefficient c_k = f^(k)/k!.
  constexpr const S& operator[](std::size_t k) const { return c_[k]; }
  constexpr S& operator[](std::size_t k) { return c_[k]; }
  /// The first of the K + 1 coefficients, which are contiguous.
  constexpr const S* data() const { return c_.data(); }
  /// The k-th derivative k! c_k.
  constexpr S derivative(std::size_t k) const {
    S factor(1);
    for (std::size_t j = 2; j <= k; ++j) factor = factor * S(static_cast<double>(j));
    return factor * c_[k];
  }

  friend constexpr Taylor operator+(const Taylor& a, const Taylor& b) {
    Taylor r;
    for (std::size_t k = 0; k <= K; ++k) r.c_[k] = a.c_[k] + b.c_[k];
    return r;
  }
  friend constexpr Taylor operator-(const Taylor& a, const Taylor& b) {
    Taylor r;
    for (std::size_t k = 0; k <= K; ++k) r.c_[k] = a.c_[k] - b.c_[k];
    return r;
  }
  friend constexpr Taylor operator-(const Taylor& a) {
    Taylor r;
    for (std::size_t k = 0; k <= K; ++k) r.c_[k] = -a.c_[k];
    return r;
  }
  friend constexpr Taylor operator*(const Taylor& a, const Taylor& b) {
    Taylor r;
    for (std::size_t k = 0; k <= K; ++k) r.c_[k] = convolution(a.data(), b.data(), k, 0, k);
    return r;
  }
  friend constexpr Taylor operator/(const Taylor& a, const Taylor& b) {
    Taylor r;
    for (std::size_t k = 0; k <= K; ++k) {
      r.c_[k] = (a.c_[k] - convolution(b.data(), r.data(), k, 1, k)) / b.c_[0];
    }
    return r;
  }
  constexpr Taylor& operator+=(const Taylor& b) { return *this = *this + b; }
  constexpr Taylor& operator-=(const Taylor& b) { return *this = *this - b; }
  constexpr Taylor& operator*=(const Taylor& b) { return *this = *this * b; }
  constexpr Taylor& operator/=(const Taylor& b) { return *this = *this / b; }

  /// Comparisons look at the value alone.
  friend constexpr bool operator<(const Taylor& a, const Taylor& b) { return a.c_[0] < b.c_[0]; }
  friend constexpr bool operator>(const Taylor& a, const Taylor& b) { return b < a; }
  friend constexpr bool operator<=(const Taylor& a, const Taylor& b) { return a.c_[0] <= b.c_[0]; }
  friend constexpr bool operator>=(const Taylor& a, const Taylor& b) { return b <= a; }
  friend constexpr bool operator==(const Taylor& a, const Taylor& b) { return a.c_[0] == b.c_[0]; }

 private:
  std::array<S, K + 1> c_{};
};

template <class S, std::size_t K>
struct RealOf<Taylor<S, K>> {
  using type = real_of_t<S>;
};

template <class S, std::size_t K>
constexpr decltype(auto) value_of(const Taylor<S, K>& x) {
  return value_of(x[0]);
}

template <class S, std::size_t K>
bool is_finite(const Taylor<S, K>& x) {
  for (std::size_t k = 0; k <= K; ++k) {
    if (!is_finite(x[k])) return false;
  }
  return true;
}

// ---- elementary functions ----------------------------------------------------------------------

namespace taylor_detail {

/// j as a scalar.
template <class S>
constexpr S count(std::size_t j) {
  return S(static_cast<double>(j));
}

/// t a', with coefficients j a_j.
template <class S, std::size_t K>
constexpr Taylor<S, K> times_index(const Taylor<S, K>& a) {
  Taylor<S, K> result;
  for (std::size_t j = 1; j <= K; ++j) result[j] = count<S>(j) * a[j];
  return result;
}

/// The k-th coefficient of the y with y' = q a', k ≥ 1, from those of q below k (so q may depend on
/// y): y_k = (1/k) Σ_{j=1..k} j a_j q_{k-j}. `slope` is times_index(a).
template <class S, std::size_t K>
constexpr S integral_step(const Taylor<S, K>& slope, const Taylor<S, K>& q, std::size_t k) {
  return divided_by_count(convolution(slope.data(), q.data(), k, 1, k), k);
}

/// y with y' = a'/q and value y0.
template <class S, std::size_t K>
Taylor<S, K> integral_of_quotient(const S& y0, const Taylor<S, K>& a, const Taylor<S, K>& q) {
  const Taylor<S, K> reciprocal = Taylor<S, K>(S(1)) / q, slope = times_index(a);
  Taylor<S, K> y(y0);
  for (std::size_t k = 1; k <= K; ++k) y[k] = integral_step(slope, reciprocal, k);
  return y;
}

}  // namespace taylor_detail

template <class S, std::size_t K>
Taylor<S, K> sqrt(const Taylor<S, K>& a) {
  using std::sqrt;
  Taylor<S, K> y(S(sqrt(a[0])));
  const S twice = y[0] + y[0];
  for (std::size_t k = 1; k <= K; ++k) {
    y[k] = (a[k] - convolution(y.data(), y.data(), k, 1, k - 1)) / twice;
  }
  return y;
}

template <class S, std::size_t K>
Taylor<S, K> exp(const Taylor<S, K>& a) {
  using std::exp;
  const Taylor<S, K> slope = taylor_detail::times_index(a);
  Taylor<S, K> y(S(exp(a[0])));
  for (std::size_t k = 1; k <= K; ++k) y[k] = taylor_detail::integral_step(slope, y, k);
  return y;
}

template <class S, std::size_t K>
Taylor<S, K> log(const Taylor<S, K>& a) {
  using std::log;
  return taylor_detail::integral_of_quotient(S(log(a[0])), a, a);
}

/// sin and cos together, as both recurrences need both.
template <class S, std::size_t K>
std::pair<Taylor<S, K>, Taylor<S, K>> sin_cos(const Taylor<S, K>& a) {
  using std::cos;
  using std::sin;
  const Taylor<S, K> slope = taylor_detail::times_index(a);
  Taylor<S, K> s(S(sin(a[0]))), c(S(cos(a[0])));
  for (std::size_t k = 1; k <= K; ++k) {
    s[k] = taylor_detail::integral_step(slope, c, k);
    c[k] = -taylor_detail::integral_step(slope, s, k);
  }
  return {s, c};
}
template <class S, std::size_t K>
Taylor<S, K> sin(const Taylor<S, K>& a) {
  return sin_cos(a).first;
}
template <class S, std::size_t K>
Taylor<S, K> cos(const Taylor<S, K>& a) {
  return sin_cos(a).second;
}
template <class S, std::size_t K>
Taylor<S, K> tan(const Taylor<S, K>& a) {
  const auto [s, c] = sin_cos(a);
  return s / c;
}

template <class S, std::size_t K>
std::pair<Taylor<S, K>, Taylor<S, K>> sinh_cosh(const Taylor<S, K>& a) {
  using std::cosh;
  using std::sinh;
  const Taylor<S, K> slope = taylor_detail::times_index(a);
  Taylor<S, K> s(S(sinh(a[0]))), c(S(cosh(a[0])));
  for (std::size_t k = 1; k <= K; ++k) {
    s[k] = taylor_detail::integral_step(slope, c, k);
    c[k] = taylor_detail::integral_step(slope, s, k);
  }
  return {s, c};
}
template <class S, std::size_t K>
Taylor<S, K> sinh(const Taylor<S, K>& a) {
  return sinh_cosh(a).first;
}
template <class S, std::size_t K>
Taylor<S, K> cosh(const Taylor<S, K>& a) {
  return sinh_cosh(a).second;
}
template <class S, std::size_t K>
Taylor<S, K> tanh(const Taylor<S, K>& a) {
  const auto [s, c] = sinh_cosh(a);
  return s / c;
}

template <class S, std::size_t K>
Taylor<S, K> atan(const Taylor<S, K>& a) {
  using std::atan;
  return taylor_detail::integral_of_quotient(S(atan(a[0])), a, Taylor<S, K>(S(1)) + a * a);
}
template <class S, std::size_t K>
Taylor<S, K> asin(const Taylor<S, K>& a) {
  using std::asin;
  return taylor_detail::integral_of_quotient(S(asin(a[0])), a, sqrt(Taylor<S, K>(S(1)) - a * a));
}
template <class S, std::size_t K>
Taylor<S, K> acos(const Taylor<S, K>& a) {
  using std::acos;
  Taylor<S, K> y = -asin(a);
  y[0] = S(acos(a[0]));
  return y;
}
template <class S, std::size_t K>
Taylor<S, K> atan2(const Taylor<S, K>& y, const Taylor<S, K>& x) {
  using std::atan2;
  // θ' = (x y' - y x')/(x² + y²), integrated term by term.
  const Taylor<S, K> reciprocal = Taylor<S, K>(S(1)) / (x * x + y * y);
  const Taylor<S, K> p = x * reciprocal, q = y * reciprocal;
  const Taylor<S, K> x_slope = taylor_detail::times_index(x),
                     y_slope = taylor_detail::times_index(y);
  Taylor<S, K> angle(S(atan2(y[0], x[0])));
  for (std::size_t k = 1; k <= K; ++k) {
    angle[k] =
        taylor_detail::integral_step(y_slope, p, k) - taylor_detail::integral_step(x_slope, q, k);
  }
  return angle;
}

/// a^exponent for a whole exponent, by repeated squaring.
template <class S, std::size_t K>
Taylor<S, K> pow(const Taylor<S, K>& a, int exponent) {
  Taylor<S, K> result(S(1)), power = a;
  for (int e = exponent < 0 ? -exponent : exponent; e > 0; e /= 2) {
    if (e % 2 == 1) result = result * power;
    if (e > 1) power = power * power;
  }
  return exponent < 0 ? Taylor<S, K>(S(1)) / result : result;
}
/// a^exponent for a positive base and any exponent.
template <class S, std::size_t K>
Taylor<S, K> pow(const Taylor<S, K>& a, const S& exponent) {
  return exp(Taylor<S, K>(exponent) * log(a));
}

/// |a|. Where the sign of the value is not known (zero, or an interval that contains it) the
/// derivatives are not numbers: the function has none there.
template <class S, std::size_t K>
Taylor<S, K> abs(const Taylor<S, K>& a) {
  if (S(0) < a[0]) return a;
  if (a[0] < S(0)) return -a;
  return sqrt(a * a);
}

}  // namespace hodograph
