// SPDX-License-Identifier: MIT
// Paths of dual numbers with the interface of ceres::Jet. Ceres itself is not needed here (its
// package would put another BLAS in the place of the machine's); what stands for it has the same
// members, the value `a` and the derivatives `v`, and the same functions beside the type.
#include "hodograph/interop/ceres.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "hodograph/foundation/second_order.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/arc_length_map.hpp"

namespace ceres {

template <typename T, int N>
struct Jet {
  using Scalar = T;
  T a{};
  std::array<T, N> v{};
  Jet() = default;
  explicit Jet(const T& value) : a(value) {}
  Jet(const T& value, int k) : a(value) { v[static_cast<std::size_t>(k)] = T(1); }

  /// f(x, y) from its value and slopes.
  static Jet of(const T& value, const T& by_x, const Jet& x, const T& by_y, const Jet& y) {
    Jet result(value);
    for (std::size_t i = 0; i < N; ++i) result.v[i] = by_x * x.v[i] + by_y * y.v[i];
    return result;
  }
  friend Jet operator+(const Jet& x, const Jet& y) { return of(x.a + y.a, 1, x, 1, y); }
  friend Jet operator-(const Jet& x, const Jet& y) { return of(x.a - y.a, 1, x, -1, y); }
  friend Jet operator*(const Jet& x, const Jet& y) { return of(x.a * y.a, y.a, x, x.a, y); }
  friend Jet operator/(const Jet& x, const Jet& y) {
    return of(x.a / y.a, 1 / y.a, x, -x.a / (y.a * y.a), y);
  }
  friend Jet operator-(const Jet& x) { return of(-x.a, -1, x, 0, x); }
  Jet& operator+=(const Jet& y) { return *this = *this + y; }
  friend bool operator<(const Jet& x, const Jet& y) { return x.a < y.a; }
  friend bool operator>(const Jet& x, const Jet& y) { return x.a > y.a; }
  friend bool operator<=(const Jet& x, const Jet& y) { return x.a <= y.a; }
  friend bool operator>=(const Jet& x, const Jet& y) { return x.a >= y.a; }
  friend bool operator==(const Jet& x, const Jet& y) { return x.a == y.a; }
  friend Jet abs(const Jet& x) { return x.a < 0 ? -x : x; }
  friend Jet sqrt(const Jet& x) { return of(std::sqrt(x.a), 0.5 / std::sqrt(x.a), x, 0, x); }
  friend Jet sin(const Jet& x) { return of(std::sin(x.a), std::cos(x.a), x, 0, x); }
  friend Jet cos(const Jet& x) { return of(std::cos(x.a), -std::sin(x.a), x, 0, x); }
  friend Jet atan2(const Jet& y, const Jet& x) {
    const T size = x.a * x.a + y.a * y.a;
    return of(std::atan2(y.a, x.a), x.a / size, y, -y.a / size, x);
  }
};

}  // namespace ceres

namespace hodograph {
namespace {

/// What a cost function may ask of a path whose points are its variables.
template <class S>
std::array<S, 6> answers(const S& x, const S& y, const S& z) {
  const auto vector = [](double a, double b, double c) { return Vector3<S>{S(a), S(b), S(c)}; };
  const HermitePoint<1, S> begin{vector(0, 0, 0), vector(1, 0.2, 0)};
  const HermitePoint<1, S> middle{Vector3<S>{x, y, z}, vector(0.7, 0.1, 0.3)};
  const HermitePoint<1, S> end{Vector3<S>{S(2) * x, y, z - S(1)}, vector(1, 0.2, 0)};
  const auto path =
      hermite_path<1, S>({S(0), S(1), S(2.5)}, std::vector{begin, middle, end}).value();
  return {path.arc_length(),
          path.position(S(0.7)).y,
          AdaptedFrame(path).at(S(1.7)).e2.z,
          path.arc_length(S(0.3)),
          parameter_at_arc_length(path, S(0.8)),
          point_at_arc_length(path, path.arc_length()).z};
}

TEST(Ceres, GradientsOfAPathByItsDataAreThoseOfSecondOrder) {
  using Dual = ceres::Jet<double, 3>;
  using Full = SecondOrder<double, 3>;
  const auto dual = answers(Dual(1.1, 0), Dual(0.4, 1), Dual(-0.2, 2));
  const auto full =
      answers(Full::variable(1.1, 0), Full::variable(0.4, 1), Full::variable(-0.2, 2));
  const auto plain = answers(1.1, 0.4, -0.2);
  // All numbers are of size 1, from some hundreds of operations.
  constexpr double allowed = 64 * epsilon<double>();
  for (std::size_t k = 0; k < plain.size(); ++k) {
    EXPECT_NEAR(dual[k].a, plain[k], allowed) << k;
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(dual[k].v[i], full[k].gradient(i), allowed) << k << ", " << i;
    }
  }
  EXPECT_NEAR(dual[5].v[2], 1.0, allowed);  // the end of the path is the end of the data
}

TEST(Ceres, ADualNumberIsFiniteWithAllItsDerivatives) {
  using Dual = ceres::Jet<double, 2>;
  Dual x(3.0, 1);
  EXPECT_TRUE(is_finite(x));
  EXPECT_EQ(to_double(x), 3.0);
  EXPECT_EQ(epsilon<Dual>(), epsilon<double>());
  x.v[0] = std::numeric_limits<double>::infinity();
  EXPECT_FALSE(is_finite(x));
  EXPECT_FALSE(is_finite(Dual(std::numeric_limits<double>::quiet_NaN())));
}

}  // namespace
}  // namespace hodograph
