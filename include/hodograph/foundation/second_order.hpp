// SPDX-License-Identifier: MIT
// A scalar that carries its first and second derivatives by N variables: exact gradients and
// Hessians of function templates.
//
// SecondOrder<S, N> stands for f(z), ∂f/∂z_i and ∂²f/∂z_i∂z_j at one point z of N variables. A
// function template evaluated at SecondOrder<S, N>::variable(z_i, i) yields all of them, exact up
// to rounding. The size is fixed and nothing is allocated; the numbers lie in one array, so that
// sums and products are loops a compiler turns into vector instructions. For derivatives of
// higher order by one variable see taylor.hpp.
//
// Source: the rules of Leibniz and of the chain, to second order.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <tuple>
#include <type_traits>
#include <utility>

#include "hodograph/foundation/scalar.hpp"

namespace hodograph {

template <class S, std::size_t N>
class SecondOrder {
 public:
  using Base = S;
  static constexpr std::size_t variables = N, order = 2;
  /// Entries of the lower triangle of the Hessian.
  static constexpr std::size_t triangle = N * (N + 1) / 2;
  /// Value, gradient, and the triangle row by row.
  static constexpr std::size_t size = 1 + N + triangle;

  constexpr SecondOrder() = default;
  /// A constant.
  constexpr SecondOrder(const S& constant) { c_[0] = constant; }
  template <class T>
    requires(std::is_arithmetic_v<T> && !std::is_same_v<T, S>)
  constexpr SecondOrder(T constant) {
    c_[0] = S(constant);
  }
  /// The variable z_i at x. Domain: i < N (contract).
  static constexpr SecondOrder variable(const S& x, std::size_t i) {
    SecondOrder result(x);
    result.c_[1 + i] = S(1);
    return result;
  }

  constexpr const S& value() const { return c_[0]; }
  constexpr S& value() { return c_[0]; }
  /// ∂f/∂z_i.
  constexpr const S& gradient(std::size_t i) const { return c_[1 + i]; }
  constexpr S& gradient(std::size_t i) { return c_[1 + i]; }
  /// ∂²f/∂z_i∂z_j, j ≤ i (contract).
  constexpr const S& hessian(std::size_t i, std::size_t j) const { return c_[at(i, j)]; }
  constexpr S& hessian(std::size_t i, std::size_t j) { return c_[at(i, j)]; }
  /// All numbers: value, gradient, the lower triangle row by row.
  constexpr const S* data() const { return c_.data(); }
  constexpr S* data() { return c_.data(); }

  /// φ(f) from φ, φ', φ'' at the value of f: ∂_i = φ' f_i, ∂_ij = φ' f_ij + φ'' f_i f_j.
  constexpr SecondOrder through(const S& value, const S& first, const S& second) const {
    SecondOrder r;
    r.c_[0] = value;
    for (std::size_t k = 1; k < size; ++k) r.c_[k] = first * c_[k];
    for (std::size_t i = 0, k = 1 + N; i < N; ++i) {
      const S scaled = second * c_[1 + i];
      for (std::size_t j = 0; j <= i; ++j, ++k) r.c_[k] = r.c_[k] + scaled * c_[1 + j];
    }
    return r;
  }

  friend constexpr SecondOrder operator+(const SecondOrder& a, const SecondOrder& b) {
    SecondOrder r;
    for (std::size_t k = 0; k < size; ++k) r.c_[k] = a.c_[k] + b.c_[k];
    return r;
  }
  friend constexpr SecondOrder operator-(const SecondOrder& a, const SecondOrder& b) {
    SecondOrder r;
    for (std::size_t k = 0; k < size; ++k) r.c_[k] = a.c_[k] - b.c_[k];
    return r;
  }
  friend constexpr SecondOrder operator-(const SecondOrder& a) {
    SecondOrder r;
    for (std::size_t k = 0; k < size; ++k) r.c_[k] = -a.c_[k];
    return r;
  }
  friend constexpr SecondOrder operator*(const SecondOrder& a, const SecondOrder& b) {
    SecondOrder r;
    r.c_[0] = a.c_[0] * b.c_[0];
    for (std::size_t k = 1; k < size; ++k) r.c_[k] = a.c_[0] * b.c_[k] + b.c_[0] * a.c_[k];
    add_symmetric_product(r, a, b);
    return r;
  }
  friend constexpr SecondOrder operator/(const SecondOrder& a, const SecondOrder& b) {
    // From a = r b: r_ij = (a_ij - r b_ij - r_i b_j - r_j b_i) / b.
    SecondOrder r;
    const S reciprocal = S(1) / b.c_[0];
    r.c_[0] = a.c_[0] / b.c_[0];
    for (std::size_t k = 1; k <= N; ++k) {
      r.c_[k] = reciprocal * (a.c_[k] - r.c_[0] * b.c_[k]);
    }
    for (std::size_t i = 0, k = 1 + N; i < N; ++i) {
      for (std::size_t j = 0; j <= i; ++j, ++k) {
        r.c_[k] = reciprocal * (a.c_[k] - r.c_[0] * b.c_[k] - r.c_[1 + i] * b.c_[1 + j] -
                                r.c_[1 + j] * b.c_[1 + i]);
      }
    }
    return r;
  }
  // With a constant, at a fraction of the work.
  friend constexpr SecondOrder operator+(const SecondOrder& a, const S& b) {
    SecondOrder r = a;
    r.c_[0] = r.c_[0] + b;
    return r;
  }
  friend constexpr SecondOrder operator+(const S& a, const SecondOrder& b) { return b + a; }
  friend constexpr SecondOrder operator-(const SecondOrder& a, const S& b) {
    SecondOrder r = a;
    r.c_[0] = r.c_[0] - b;
    return r;
  }
  friend constexpr SecondOrder operator-(const S& a, const SecondOrder& b) { return -b + a; }
  friend constexpr SecondOrder operator*(const SecondOrder& a, const S& b) {
    SecondOrder r;
    for (std::size_t k = 0; k < size; ++k) r.c_[k] = a.c_[k] * b;
    return r;
  }
  friend constexpr SecondOrder operator*(const S& a, const SecondOrder& b) { return b * a; }
  friend constexpr SecondOrder operator/(const SecondOrder& a, const S& b) {
    SecondOrder r;
    for (std::size_t k = 0; k < size; ++k) r.c_[k] = a.c_[k] / b;
    return r;
  }
  friend constexpr SecondOrder operator/(const S& a, const SecondOrder& b) {
    const S quotient = a / b.c_[0], slope = -(quotient / b.c_[0]);
    return b.through(quotient, slope, -((slope + slope) / b.c_[0]));
  }
  constexpr SecondOrder& operator+=(const SecondOrder& b) { return *this = *this + b; }
  constexpr SecondOrder& operator-=(const SecondOrder& b) { return *this = *this - b; }
  constexpr SecondOrder& operator*=(const SecondOrder& b) { return *this = *this * b; }
  constexpr SecondOrder& operator/=(const SecondOrder& b) { return *this = *this / b; }

  /// Comparisons look at the value alone.
  friend constexpr bool operator<(const SecondOrder& a, const SecondOrder& b) {
    return a.c_[0] < b.c_[0];
  }
  friend constexpr bool operator>(const SecondOrder& a, const SecondOrder& b) { return b < a; }
  friend constexpr bool operator<=(const SecondOrder& a, const SecondOrder& b) {
    return a.c_[0] <= b.c_[0];
  }
  friend constexpr bool operator>=(const SecondOrder& a, const SecondOrder& b) { return b <= a; }
  friend constexpr bool operator==(const SecondOrder& a, const SecondOrder& b) {
    return a.c_[0] == b.c_[0];
  }

  /// r_ij += a_i b_j + a_j b_i for j ≤ i.
  friend constexpr void add_symmetric_product(SecondOrder& r, const SecondOrder& a,
                                              const SecondOrder& b) {
    for (std::size_t i = 0, k = 1 + N; i < N; ++i) {
      const S ai = a.c_[1 + i], bi = b.c_[1 + i];
      for (std::size_t j = 0; j <= i; ++j, ++k) {
        r.c_[k] = r.c_[k] + (ai * b.c_[1 + j] + bi * a.c_[1 + j]);
      }
    }
  }

 private:
  static constexpr std::size_t at(std::size_t i, std::size_t j) {
    return 1 + N + i * (i + 1) / 2 + j;
  }
  std::array<S, size> c_{};
};

template <class S, std::size_t N>
struct RealOf<SecondOrder<S, N>> {
  using type = real_of_t<S>;
};

template <class S, std::size_t N>
constexpr decltype(auto) value_of(const SecondOrder<S, N>& x) {
  return value_of(x.value());
}

template <class S, std::size_t N>
bool is_finite(const SecondOrder<S, N>& x) {
  for (std::size_t k = 0; k < SecondOrder<S, N>::size; ++k) {
    if (!is_finite(x.data()[k])) return false;
  }
  return true;
}

/// f(g_1(z), ..., g_M(z)) from the derivatives of f by its own M arguments, `outer`, taken at the
/// values of the g: ∂_i = Σ f_k g_k,i and ∂_ij = Σ f_k g_k,ij + Σ f_kl g_k,i g_l,j. Differentiating
/// a function of few arguments by them and then joining costs less than carrying all N variables
/// through it. Exact up to rounding.
template <class S, std::size_t N, std::size_t M>
constexpr SecondOrder<S, N> joined(const SecondOrder<S, M>& outer,
                                   const std::array<SecondOrder<S, N>, M>& inner) {
  constexpr std::size_t size = SecondOrder<S, N>::size;
  SecondOrder<S, N> r(outer.value());
  for (std::size_t k = 0; k < M; ++k) {
    const S slope = outer.gradient(k);
    for (std::size_t e = 1; e < size; ++e) r.data()[e] = r.data()[e] + slope * inner[k].data()[e];
  }
  for (std::size_t k = 0; k < M; ++k) {
    std::array<S, N> bent{};  // Σ_l f_kl g_l,j
    for (std::size_t l = 0; l < M; ++l) {
      const S f = l <= k ? outer.hessian(k, l) : outer.hessian(l, k);
      for (std::size_t j = 0; j < N; ++j) bent[j] = bent[j] + f * inner[l].gradient(j);
    }
    for (std::size_t i = 0, e = 1 + N; i < N; ++i) {
      const S g = inner[k].gradient(i);
      for (std::size_t j = 0; j <= i; ++j, ++e) r.data()[e] = r.data()[e] + g * bent[j];
    }
  }
  return r;
}

/// f(arguments) for a function template of a few arguments, std::array<T, M> → std::array<T, K> on
/// any scalar T, inside a computation that carries many variables: f is differentiated by its own M
/// arguments and the result joined. The same numbers, up to rounding, as f(arguments); for a scalar
/// without derivatives, f itself.
template <class F, class S, std::size_t M>
constexpr auto evaluated_apart(const F& f, const std::array<S, M>& arguments) {
  return f(arguments);
}
template <class F, class S, std::size_t N, std::size_t M>
constexpr auto evaluated_apart(const F& f, const std::array<SecondOrder<S, N>, M>& arguments) {
  std::array<SecondOrder<S, M>, M> own;
  for (std::size_t i = 0; i < M; ++i) {
    own[i] = SecondOrder<S, M>::variable(arguments[i].value(), i);
  }
  const auto outer = f(own);
  std::array<SecondOrder<S, N>, std::tuple_size_v<std::remove_cvref_t<decltype(outer)>>> result;
  for (std::size_t k = 0; k < result.size(); ++k) result[k] = joined(outer[k], arguments);
  return result;
}

// ---- elementary functions ----------------------------------------------------------------------

template <class S, std::size_t N>
SecondOrder<S, N> sqrt(const SecondOrder<S, N>& a) {
  using std::sqrt;
  const S root = sqrt(a.value()), slope = S(1) / (root + root);
  return a.through(root, slope, -(slope / (a.value() + a.value())));
}
template <class S, std::size_t N>
SecondOrder<S, N> exp(const SecondOrder<S, N>& a) {
  using std::exp;
  const S e = exp(a.value());
  return a.through(e, e, e);
}
template <class S, std::size_t N>
SecondOrder<S, N> log(const SecondOrder<S, N>& a) {
  using std::log;
  const S reciprocal = S(1) / a.value();
  return a.through(S(log(a.value())), reciprocal, -(reciprocal * reciprocal));
}
/// sin and cos together, as both derivatives need both.
template <class S, std::size_t N>
std::pair<SecondOrder<S, N>, SecondOrder<S, N>> sin_cos(const SecondOrder<S, N>& a) {
  using std::cos;
  using std::sin;
  const S s = sin(a.value()), c = cos(a.value());
  return {a.through(s, c, -s), a.through(c, -s, -c)};
}
template <class S, std::size_t N>
SecondOrder<S, N> sin(const SecondOrder<S, N>& a) {
  return sin_cos(a).first;
}
template <class S, std::size_t N>
SecondOrder<S, N> cos(const SecondOrder<S, N>& a) {
  return sin_cos(a).second;
}
template <class S, std::size_t N>
SecondOrder<S, N> tan(const SecondOrder<S, N>& a) {
  using std::tan;
  const S t = tan(a.value()), slope = S(1) + t * t;
  return a.through(t, slope, (t + t) * slope);
}
template <class S, std::size_t N>
SecondOrder<S, N> atan(const SecondOrder<S, N>& a) {
  using std::atan;
  const S slope = S(1) / (S(1) + a.value() * a.value());
  return a.through(S(atan(a.value())), slope, -((a.value() + a.value()) * slope * slope));
}
/// The angle of (x, y), from -π to π; undefined at the origin.
template <class S, std::size_t N>
SecondOrder<S, N> atan2(const SecondOrder<S, N>& y, const SecondOrder<S, N>& x) {
  using std::atan2;
  const S r = S(1) / (x.value() * x.value() + y.value() * y.value());
  const S p = x.value() * r, q = y.value() * r, mixed = (q - p) * (q + p);
  SecondOrder<S, 2> f(S(atan2(y.value(), x.value())));
  f.gradient(0) = p;
  f.gradient(1) = -q;
  f.hessian(0, 0) = -(S(2) * p * q);
  f.hessian(1, 0) = mixed;
  f.hessian(1, 1) = S(2) * p * q;
  return joined(f, std::array<SecondOrder<S, N>, 2>{y, x});
}
/// |a|; where the value is 0 its derivatives are not defined and those of a are returned.
template <class S, std::size_t N>
SecondOrder<S, N> abs(const SecondOrder<S, N>& a) {
  return a.value() < S(0) ? -a : a;
}
/// a^exponent for a positive base and any exponent.
template <class S, std::size_t N>
SecondOrder<S, N> pow(const SecondOrder<S, N>& a, const S& exponent) {
  using std::pow;
  const S power = pow(a.value(), exponent), slope = exponent * power / a.value();
  return a.through(power, slope, (exponent - S(1)) * slope / a.value());
}

}  // namespace hodograph
