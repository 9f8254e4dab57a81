// SPDX-License-Identifier: MIT
// The laws of path/arc_length_map.hpp, numbered as there.
#include "hodograph/path/arc_length_map.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "hodograph/curve/preimage_jet.hpp"
#include "hodograph/foundation/second_order.hpp"
#include "hodograph/foundation/taylor.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using Multi = boost::multiprecision::cpp_bin_float_50;
using test::Random;

template <class Wide, class A, std::size_t n>
auto widened(const PhCurve<A, n>& curve) {
  using WideA = std::conditional_t<A::dimension == 2, Complex<Wide>, Quaternion<Wide>>;
  const auto preimage = curve.preimage().mapped([](const A& a) {
    WideA wide;
    for (std::size_t i = 0; i < A::dimension; ++i) wide[i] = Wide(a[i]);
    return wide;
  });
  point_t<WideA> start;
  for (std::size_t i = 0; i < point_t<A>::dimension; ++i) start[i] = Wide(curve.start()[i]);
  return PhCurve<WideA, n>(start, preimage, Wide(curve.parameter_step()));
}

/// A preimage that varies by `wildness`, or one with planted zeros: a double factor (t - root)
/// where root is given.
template <class A, std::size_t n>
BernsteinPolynomial<A, n> random_preimage(Random& random, double wildness) {
  A middle{};
  middle[0] = 1.0;
  BernsteinPolynomial<A, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) {
    preimage[i] = middle + random.components<A>(wildness);
  }
  return preimage;
}

/// A = (u - root) B: the speed has a double zero, the curve a cusp.
template <class A, std::size_t n>
BernsteinPolynomial<A, n> with_cusp(const BernsteinPolynomial<A, n - 1>& rest, double root) {
  const BernsteinPolynomial<double, 1> factor({-root, 1.0 - root});
  return product(rest, factor, [](const A& a, double x) { return x * a; });
}

template <class A, std::size_t n>
Path<A, n> path_of(const std::vector<BernsteinPolynomial<A, n>>& preimages, Random& random) {
  std::vector<double> knots{random.uniform(-1.0, 1.0)};
  std::vector<PhCurve<A, n>> segments;
  point_t<A> start{};
  for (const auto& preimage : preimages) {
    knots.push_back(knots.back() + random.uniform(0.25, 2.0));
    segments.emplace_back(start, preimage, knots.back() - knots[knots.size() - 2]);
    start = segments.back().end();
  }
  return Path<A, n>::create(knots, segments, false).value();
}

template <class A, std::size_t n>
void check_residual(const PhCurve<A, n>& curve, double s, double u) {
  const double scale = curve.parameter_step() * curve.speed_bound();
  const Multi exact = widened<Multi>(curve).arc_length(Multi(u));
  const double slope = curve.speed(u) * curve.parameter_step();
  // u itself is rounded, and so is the sum node + offset: two roundings of size ε/2.
  const double allowed = accuracy::arc_length_error<double>(n) * scale + epsilon<double>() * slope;
  EXPECT_LE(std::abs(static_cast<double>(exact - Multi(s))), allowed) << "s = " << s;
}

template <class A, std::size_t n>
void check_curves(Random& random) {
  for (int round = 0; round < 40; ++round) {
    const double wildness = std::ldexp(1.0, static_cast<int>(random.integer(-12, 3)));
    BernsteinPolynomial<A, n> preimage = random_preimage<A, n>(random, wildness);
    if (round % 3 == 1) {
      const double root = round % 2 == 0 ? random.unit() : random.index(9) / 8.0;
      preimage = with_cusp<A, n>(random_preimage<A, n - 1>(random, 0.3), root);
    }
    const PhCurve<A, n> curve({}, preimage, random.uniform(0.1, 3.0));
    EXPECT_EQ(parameter_at_arc_length(curve, 0.0), 0.0);
    EXPECT_EQ(parameter_at_arc_length(curve, curve.arc_length()), 1.0);
    for (int i = 0; i < 20; ++i) {
      const double s = random.unit() * curve.arc_length();
      check_residual(curve, s, parameter_at_arc_length(curve, s));
    }
  }
}

TEST(ArcLengthMap, Law1ResidualIsRounding) {
  Random random("arc length residual");
  check_curves<Quaternion<double>, 8>(random);
  check_curves<Quaternion<double>, 2>(random);
  check_curves<Complex<double>, 2>(random);
  check_curves<Complex<double>, 5>(random);
}

/// Runs of adjacent doubles, tiny steps and random places, in increasing order.
std::vector<double> dense_lengths(Random& random, double length, const std::vector<double>& near) {
  std::vector<double> s{0.0, length};
  const auto run = [&](double from) {
    double x = from;
    for (int i = 0; i < 120; ++i) s.push_back(x = std::nextafter(x, length));
    x = from;
    for (int i = 0; i < 120; ++i) s.push_back(x = std::nextafter(x, 0.0));
    for (int i = 0; i < 60; ++i) s.push_back(from * (1.0 + random.spread(-50, -10)));
  };
  for (const double x : near) run(x);
  for (int i = 0; i < 20; ++i) run(random.unit() * length);
  for (int i = 0; i < 40; ++i) s.push_back(length * std::ldexp(random.unit(), -20 * (i % 8)));
  std::erase_if(s, [&](double x) { return !(0.0 <= x && x <= length); });
  std::sort(s.begin(), s.end());
  return s;
}

template <class A, std::size_t n>
void check_monotone(Random& random, int kind) {
  std::vector<BernsteinPolynomial<A, n>> preimages;
  for (int k = 0; k < 4; ++k) {
    if (kind == 0) {
      preimages.push_back(random_preimage<A, n>(random, std::ldexp(1.0, 1 - 3 * k)));
    } else if (kind == 1) {
      preimages.push_back(with_cusp<A, n>(random_preimage<A, n - 1>(random, 0.3), k == 0 ? 0.0
                                                                                  : k == 3
                                                                                      ? 1.0
                                                                                      : 0.25 * k));
    } else {  // at rest over most of the interval, within rounding
      BernsteinPolynomial<A, n> preimage;
      preimage[k % 2 == 0 ? n : 0][0] = 1.0;
      preimages.push_back(preimage);
    }
  }
  const auto path = path_of<A, n>(preimages, random);
  std::vector<double> near = path.knot_arc_lengths();
  for (double x : {0.25, 0.5, 0.75}) {
    for (std::size_t k = 0; k < 4; ++k) {
      near.push_back(path.knot_arc_lengths()[k] + path.segment(k).arc_length(x));
    }
  }
  double before = path.xi_begin();
  for (const double s : dense_lengths(random, path.arc_length(), near)) {
    const double xi = parameter_at_arc_length(path, s);
    ASSERT_LE(before, xi) << "kind " << kind << ", s = " << s;
    ASSERT_LE(xi, path.xi_end());
    before = xi;
  }
  EXPECT_EQ(parameter_at_arc_length(path, 0.0), path.xi_begin());
  EXPECT_EQ(parameter_at_arc_length(path, path.arc_length()), path.xi_end());
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(parameter_at_arc_length(path, path.knot_arc_lengths()[k]), path.knots()[k]);
  }
}

TEST(ArcLengthMap, Laws2And3MonotoneAndExactAtTheEnds) {
  Random random("arc length monotone");
  for (int round = 0; round < 4; ++round) {
    for (int kind = 0; kind < 3; ++kind) {
      check_monotone<Quaternion<double>, 8>(random, kind);
      check_monotone<Quaternion<double>, 2>(random, kind);
      check_monotone<Complex<double>, 3>(random, kind);
    }
  }
}

template <class A, std::size_t n>
void check_points(Random& random, double wildness) {
  std::vector<BernsteinPolynomial<A, n>> preimages(12);
  for (auto& preimage : preimages) preimage = random_preimage<A, n>(random, wildness);
  const auto path = path_of<A, n>(preimages, random);
  for (int i = 0; i < 500; ++i) {
    const double s = random.unit() * path.arc_length();
    const auto at = location_at_arc_length(path, s);
    const auto& curve = path.segment(at.segment);
    // Both carry the rounding of the inverse and of one evaluation of the position.
    const double allowed = 2.0 *
                               (accuracy::arc_length_error<double>(n) +
                                accuracy::evaluation_error<double>(2 * n + 1)) *
                               curve.parameter_step() * curve.speed_bound() +
                           4.0 * epsilon<double>() * largest_component(curve.start());
    EXPECT_LE(norm(point_at_arc_length(path, s) - path.position(at)), allowed);
  }
  EXPECT_EQ(point_at_arc_length(path, 0.0), path.segment(0).start());
  EXPECT_EQ(point_at_arc_length(path, path.arc_length()), path.segments().back().end());
}

TEST(ArcLengthMap, PointsAgreeWithTheParameter) {
  Random random("points at arc length");
  for (const double wildness : {0.01, 0.3, 3.0}) {
    check_points<Quaternion<double>, 8>(random, wildness);
    check_points<Quaternion<double>, 2>(random, wildness);
    check_points<Complex<double>, 4>(random, wildness);
  }
}

TEST(ArcLengthMap, StretchesAtRest) {
  // A constant preimage, then one that is zero throughout, then a constant one again.
  Random random("stretch at rest");
  BernsteinPolynomial<Quaternion<double>, 2> moving, resting;
  for (std::size_t i = 0; i <= 2; ++i) moving[i].w = 1.0;
  const auto path = path_of<Quaternion<double>, 2>({moving, resting, moving}, random);
  double before = path.xi_begin();
  for (int i = 0; i <= 1000; ++i) {
    const double s = path.arc_length() * i / 1000.0;
    const double xi = parameter_at_arc_length(path, s);
    ASSERT_LE(before, xi);
    before = xi;
  }
  EXPECT_EQ(before, path.xi_end());
}

TEST(ArcLengthMap, RefusesLengthsOutside) {
  Random random("arc length outside");
  const auto path =
      path_of<Complex<double>, 2>({random_preimage<Complex<double>, 2>(random, 0.3)}, random);
  for (const double s : {-1.0, 2.0 * path.arc_length(), std::numeric_limits<double>::quiet_NaN(),
                         std::numeric_limits<double>::infinity()}) {
    try {
      parameter_at_arc_length(path, s);
      FAIL() << s;
    } catch (const Error& error) {
      EXPECT_EQ(error.fault().code, FaultCode::outside_domain);
    }
    EXPECT_THROW(point_at_arc_length(path, s), Error);
  }
}

template <class S>
void check_scalar() {
  BernsteinPolynomial<Quaternion<S>, 4> preimage;
  for (std::size_t i = 0; i <= 4; ++i) {
    preimage[i] = {S(1), S(static_cast<double>(i)) / S(5), S(0.25),
                   S(static_cast<double>(i * i)) / S(16)};
  }
  const PhCurve<Quaternion<S>, 4> curve({}, preimage, S(2));
  for (int i = 1; i < 40; ++i) {
    const S s = curve.arc_length() * S(i) / S(40);
    const S residual = curve.arc_length(parameter_at_arc_length(curve, s)) - s;
    const S allowed = S(2) * accuracy::arc_length_error<S>(4) * S(2) * curve.speed_bound();
    EXPECT_LE(residual, allowed);
    EXPECT_GE(residual, -allowed);
  }
}

TEST(ArcLengthMap, OtherScalars) {
  check_scalar<long double>();
  check_scalar<Multi>();
}

TEST(ArcLengthMap, DifferentiatesWithRespectToData) {
  // s(u) = a² u for the constant preimage a: u = s/a², with a = 2 + t, s = 1: derivatives of (2 +
  // t)^-2.
  using T = Taylor<double, 3>;
  BernsteinPolynomial<Complex<T>, 1> preimage;
  preimage[0].re = preimage[1].re = T::variable(2.0);
  const PhCurve<Complex<T>, 1> curve({}, preimage, T(1.0));
  const T u = parameter_at_arc_length(curve, T(1.0));
  const T expected = T(1.0) / (T::variable(2.0) * T::variable(2.0));
  for (std::size_t k = 0; k <= 3; ++k) {
    EXPECT_NEAR(u[k], expected[k], 8 * epsilon<double>());
  }
}

TEST(ArcLengthMap, DifferentiatesAtTheEndsAndTheKnotsToo) {
  // d/ds of what is reached at s: dξ/ds = 1/σ, d²ξ/ds² = -σ'/σ³, dr/ds the tangent.
  using T = Taylor<double, 3>;
  using J = SecondOrder<double, 1>;
  Random random("arc length derivatives at the ends");
  std::vector<double> knots{-1.0, 0.5, 2.5};
  std::vector<PlanarPhCurve<2>> segments;
  segments.emplace_back(Vector2<double>{1.0, 2.0}, test::tame_preimage<Complex<double>, 2>(random),
                        1.5);
  segments.emplace_back(segments[0].end(), test::tame_preimage<Complex<double>, 2>(random), 2.0);
  const auto path = PlanarPath<2>::create(knots, segments, false).value();
  const auto series = test::converted<T>(path);
  const auto second = test::converted<J>(path);
  for (const double s :
       {0.0, 0.3 * path.arc_length(), path.knot_arc_lengths()[1], path.arc_length()}) {
    const T xi = parameter_at_arc_length(series, T::variable(s));
    const J same = parameter_at_arc_length(second, J::variable(s, 0));
    EXPECT_EQ(xi[0], parameter_at_arc_length(path, s));
    EXPECT_EQ(same.value(), xi[0]);
    const auto sigma = speed_derivatives(path.preimage_jet<2>(xi[0]));
    // A preimage within a factor of some tens of its least size; sums of three terms.
    constexpr double allowed = 1024 * epsilon<double>();
    EXPECT_NEAR(xi[1] * sigma[0], 1.0, allowed);
    EXPECT_NEAR(2.0 * xi[2] * sigma[0] * sigma[0] * sigma[0], -sigma[1],
                allowed * (1.0 + std::abs(sigma[1])));
    EXPECT_NEAR(same.gradient(0) * sigma[0], 1.0, allowed);
    EXPECT_NEAR(same.hessian(0, 0) * sigma[0] * sigma[0] * sigma[0], -sigma[1],
                allowed * (1.0 + std::abs(sigma[1])));
    const auto point = point_at_arc_length(series, T::variable(s));
    const auto at = point_at_arc_length(path, s);
    const auto plain = series.position(xi);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(point[i][0], at[i], allowed);
      for (std::size_t k = 1; k <= 3; ++k) {
        EXPECT_NEAR(point[i][k], plain[i][k], allowed * (1.0 + std::abs(plain[i][k])));
      }
    }
    EXPECT_NEAR(point[0][1] * point[0][1] + point[1][1] * point[1][1], 1.0, allowed);
  }
}

TEST(ArcLengthMap, ScalesFromTinyToHuge) {
  Random random("arc length scales");
  for (const int exponent : {-500, -250, 0, 250, 498}) {
    const double root = std::ldexp(1.0, exponent / 2);
    const auto preimage = root * random_preimage<Quaternion<double>, 4>(random, 0.4);
    const PhCurve<Quaternion<double>, 4> curve({}, preimage, 1.0);
    for (int i = 1; i < 20; ++i) {
      const double s = curve.arc_length() * i / 20.0;
      const double residual = curve.arc_length(parameter_at_arc_length(curve, s)) - s;
      EXPECT_LE(std::abs(residual),
                2.0 * accuracy::arc_length_error<double>(4) * curve.speed_bound());
    }
  }
}

}  // namespace
}  // namespace hodograph
