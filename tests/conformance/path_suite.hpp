// SPDX-License-Identifier: MIT
// What every PH curve and every path must satisfy, whatever the algebra, the degree and the scalar.
// Each file path_<scalar>_test.cpp instantiates this suite for one scalar.
//
// Three regimes: generic preimages, preimages that almost vanish at an end, and ones that do
// vanish.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

#include "hodograph/foundation/taylor.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/continuity.hpp"
#include "hodograph/path/continuity.hpp"
#include "hodograph/path/operations.hpp"
#include "hodograph/path/path.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/quadrature.hpp"

namespace hodograph::test {

enum class Regime { generic, almost_degenerate, degenerate };

template <class S>
inline constexpr bool carries_derivatives = false;
template <class S, std::size_t K>
inline constexpr bool carries_derivatives<Taylor<S, K>> = true;

/// A path of the regime (of degree 0: always generic) on three segments with two continuous
/// derivatives of the preimage (as far as its degree goes). A scalar that carries derivatives
/// follows a common change of the first components.
template <class P>
P conformance_path(Random& random, Regime regime) {
  using S = typename P::Scalar;
  using A = typename P::Algebra;
  constexpr std::size_t n = P::preimage_degree;
  constexpr std::size_t order = n < 3 ? (n == 0 ? 0 : n - 1) : 2;
  std::vector<S> knots{S(random.uniform(-1.0, 1.0))};
  std::vector<typename P::Curve> segments;
  typename P::Point start{};
  for (std::size_t k = 0; k < 3; ++k) {
    knots.push_back(knots[k] + S(random.uniform(0.5, 1.5)));
    auto preimage = tame_preimage<A, n>(random);
    if constexpr (carries_derivatives<S>) {
      for (std::size_t i = 0; i <= n; ++i) preimage[i][0][1] = typename S::Base(1);
    }
    if (k > 0) {
      if constexpr (n == 0) preimage = segments[k - 1].preimage();
      if constexpr (n > 0) {
        continue_preimage(segments[k - 1], preimage, S(knots[k + 1] - knots[k]), order);
      }
    } else if (n > 0 && regime != Regime::generic) {
      // Almost zero: 2^-30 of the rest.
      const S size(regime == Regime::degenerate ? 0.0 : std::ldexp(1.0, -30));
      preimage[0] = size * preimage[0];
    }
    segments.emplace_back(start, preimage, knots[k + 1] - knots[k]);
    start = segments[k].end();
  }
  return P::create(std::move(knots), std::move(segments), false).value();
}

template <class P>
class PathConformance : public testing::Test {
 protected:
  using S = typename P::Scalar;
  using A = typename P::Algebra;
  static constexpr std::size_t n = P::preimage_degree;

  /// Sums of n + 1 products of d terms, evaluated at two places: (9n + 16) ε, and 3 times that
  /// where the scalar carries a value and two derivatives, whose products have up to three terms.
  static constexpr double tolerance = (carries_derivatives<S> ? 3.0 : 1.0) * (9.0 * n + 16.0);

  /// The largest |A_i|² h over the path and its sum: the scale of what is integrated from them.
  static double scale(const P& path) {
    double sum = 1.0;
    for (const auto& curve : path.segments()) {
      double largest = 1.0;
      for (const auto& a : curve.preimage().coefficients()) {
        largest = std::max(largest, to_double(S(dot(a, a))));
        if constexpr (carries_derivatives<S>) {
          for (std::size_t i = 0; i < A::dimension; ++i) {
            for (std::size_t k = 0; k <= S::order; ++k) {
              largest = std::max(largest, a[i][k] * a[i][k] * 4.0);
            }
          }
        }
      }
      sum += largest * to_double(curve.parameter_step());
    }
    return sum;
  }

  template <class Check>
  static void for_each_path(const std::string& name, const Check& check) {
    Random random(name);
    for (const Regime regime : {Regime::generic, Regime::almost_degenerate, Regime::degenerate}) {
      SCOPED_TRACE("regime " + std::to_string(static_cast<int>(regime)));
      for (int repeat = 0; repeat < 3; ++repeat) {
        check(random, conformance_path<P>(random, regime), regime);
        if (testing::Test::HasFailure()) return;
      }
    }
  }

  static std::vector<S> places() {
    std::vector<S> result;
    for (int j = 0; j <= 8; ++j) result.push_back(S(0.125 * j));
    return result;
  }
};

TYPED_TEST_SUITE_P(PathConformance);

// |r'| = σ: as polynomials, |r'|² = σ².
TYPED_TEST_P(PathConformance, ThePythagoreanIdentityHolds) {
  this->for_each_path("pythagorean identity", [&](Random&, const TypeParam& path, Regime) {
    using Point = typename TypeParam::Point;
    using S = typename TypeParam::Scalar;
    for (const auto& curve : path.segments()) {
      const auto hodograph = curve.hodograph();
      const auto speed = curve.speed_polynomial();
      const auto square =
          symmetric_square(hodograph, [](const Point& a, const Point& b) { return dot(a, b); });
      const auto speed_square =
          symmetric_square(speed, [](const S& a, const S& b) { return S(a * b); });
      const double scale = this->scale(path);
      EXPECT_CLOSE(square.coefficients(), speed_square.coefficients(), 2 * this->tolerance,
                   scale * scale * 16);
      for (const S& u : this->places()) {
        EXPECT_CLOSE(curve.speed(u), speed.value(u), this->tolerance, 4 * scale);
      }
    }
  });
}

// The exact arc length is what quadrature of |r'| gives; it starts at 0, ends at the total, grows.
TYPED_TEST_P(PathConformance, ArcLengthIsTheIntegralOfTheSpeed) {
  using S = typename TypeParam::Scalar;
  const auto rule = gauss_legendre<real_of_t<S>, 9>();
  this->for_each_path("arc length", [&](Random&, const TypeParam& path, Regime) {
    S total(0);
    for (const auto& curve : path.segments()) {
      const auto hodograph = curve.hodograph();
      for (const S& end : {S(0.375), S(1)}) {
        S sum(0);
        for (const auto& [node, weight] : rule) {
          const auto r = hodograph.value(S(end * S(node)));
          using std::sqrt;
          sum = sum + S(weight) * S(sqrt(S(dot(r, r))));
        }
        sum = sum * end * curve.parameter_step();
        EXPECT_CLOSE(curve.arc_length(end), sum, 2 * this->tolerance, 4 * this->scale(path));
        if (end == S(1)) total = total + sum;
      }
      EXPECT_TRUE(curve.arc_length(S(0)) == S(0));
      EXPECT_TRUE(curve.arc_length(S(1)) == curve.arc_length());
    }
    EXPECT_CLOSE(path.arc_length(), total, 2 * this->tolerance, 4 * this->scale(path));
    EXPECT_TRUE(path.arc_length(path.xi_begin()) == S(0));
    EXPECT_TRUE(path.arc_length(path.xi_end()) == path.arc_length());
    S before(0);
    for (int j = 0; j <= 64; ++j) {
      const S xi = path.clamped(path.xi_begin() + S(j / 64.0) * S(path.xi_end() - path.xi_begin()));
      const S s = path.arc_length(xi);
      EXPECT_FALSE(s < before);
      before = s;
    }
  });
}

// r' = A i A* and its derivatives, σ and its derivatives, from the Taylor series of r and s in ξ.
TYPED_TEST_P(PathConformance, DerivativesAreThoseOfTheSeries) {
  using S = typename TypeParam::Scalar;
  // Not for a scalar that is a series itself: what it carries is checked by the other laws.
  if constexpr (!carries_derivatives<S>) {
    using Series = Taylor<S, 4>;
    this->for_each_path("derivatives", [&](Random&, const TypeParam& path, Regime) {
      const auto series = converted<Series>(path);
      for (const double share : {0.0, 0.21, 0.5, 0.86}) {
        const S xi = path.xi_begin() + S(share) * S(path.xi_end() - path.xi_begin());
        const auto position = series.position(Series::variable(xi));
        const auto length = series.arc_length(Series::variable(xi));
        const auto r = path.template position_derivatives<4>(xi);
        const auto sigma = speed_derivatives(path.template preimage_jet<3>(xi));
        double scale = 4 * this->scale(path);
        for (std::size_t order = 0; order <= 4; ++order) {
          for (std::size_t i = 0; i < TypeParam::Point::dimension; ++i) {
            EXPECT_CLOSE(r[order][i], position[i].derivative(order), this->tolerance, scale);
          }
          if (order > 0) {
            EXPECT_CLOSE(sigma[order - 1], length.derivative(order), this->tolerance, scale);
          }
          // The next derivative sums with weights 2d/h, h ≥ 1/2.
          scale *=
              4.0 * static_cast<double>(TypeParam::Curve::degree -
                                        std::min<std::size_t>(order, TypeParam::Curve::degree - 1));
        }
      }
    });
  }
}

// Turned, scaled, mirrored, reversed: the arc length knows nothing of it but the scale, and the
// points and speeds follow.
TYPED_TEST_P(PathConformance, InvariantUnderMotionScaleAndReversal) {
  using S = typename TypeParam::Scalar;
  using Point = typename TypeParam::Point;
  this->for_each_path("invariance", [&](Random& random, const TypeParam& path, Regime) {
    const double scale = 8 * this->scale(path);
    const auto image = [&] {
      if constexpr (Point::dimension == 2) {
        return moved(path, S(random.uniform(-3.0, 3.0)), Point{S(1), S(2)}).value();
      } else {
        // (1, 2, 4, 10)/11 has length 1 in any scalar, to rounding.
        const Quaternion<S> q{ratio<S>(1, 11), ratio<S>(2, 11), ratio<S>(4, 11), ratio<S>(10, 11)};
        return moved(path, q, Point{S(1), S(2), S(3)}).value();
      }
    }();
    const auto larger = scaled(path, S(2.5)).value();
    const auto back = reversed(path).value();
    Point normal{};
    for (std::size_t i = 0; i < Point::dimension; ++i) normal[i] = S(random.uniform(0.5, 1.0));
    const auto mirror = reflected(path, normal, Point{}).value();
    EXPECT_CLOSE(image.arc_length(), path.arc_length(), 2 * this->tolerance, scale);
    EXPECT_CLOSE(larger.arc_length(), S(S(2.5) * path.arc_length()), 2 * this->tolerance,
                 2.5 * scale);
    EXPECT_CLOSE(back.arc_length(), path.arc_length(), 2 * this->tolerance, scale);
    EXPECT_CLOSE(mirror.arc_length(), path.arc_length(), 2 * this->tolerance, scale);
    const S xi = path.xi_begin() + S(0.3) * S(path.xi_end() - path.xi_begin());
    for (const auto& other : {image, mirror}) {
      EXPECT_CLOSE(other.speed(xi), path.speed(xi), this->tolerance, scale);
      const auto chord = path.position(xi) - path.position(path.xi_end());
      const auto other_chord = other.position(xi) - other.position(path.xi_end());
      EXPECT_CLOSE(S(dot(other_chord, other_chord)), S(dot(chord, chord)), 2 * this->tolerance,
                   scale * scale);
    }
    EXPECT_CLOSE(back.position(S(-xi)), path.position(xi), this->tolerance, scale);
    EXPECT_CLOSE(larger.position(xi), S(2.5) * path.position(xi), this->tolerance, 2.5 * scale);
  });
}

// Cutting, elevating and joining change nothing but the description.
TYPED_TEST_P(PathConformance, PartsAndOtherDegreesAreTheSameCurve) {
  using S = typename TypeParam::Scalar;
  this->for_each_path("parts", [&](Random& random, const TypeParam& path, Regime) {
    const double scale = 8 * this->scale(path);
    const S length = path.xi_end() - path.xi_begin();
    const S a = path.xi_begin() + S(random.uniform(0.05, 0.4)) * length;
    const S b = path.xi_begin() + S(random.uniform(0.5, 0.9)) * length;
    const auto part = subpath(path, a, b).value();
    const auto higher = with_preimage_degree<TypeParam::preimage_degree + 2>(path).value();
    const auto whole =
        joined(subpath(path, path.xi_begin(), a).value(), subpath(path, a, path.xi_end()).value())
            .value();
    for (const S& u : this->places()) {
      const S xi = part.clamped(a + u * S(b - a));
      EXPECT_CLOSE(part.position(xi), path.position(xi), 2 * this->tolerance, scale);
      EXPECT_CLOSE(whole.position(xi), path.position(xi), 2 * this->tolerance, scale);
      EXPECT_CLOSE(higher.position(xi), path.position(xi), 2 * this->tolerance, scale);
    }
    EXPECT_CLOSE(part.arc_length(), S(path.arc_length(b) - path.arc_length(a)), 2 * this->tolerance,
                 scale);
  });
}

// The orders of continuity that the preimage was built with are found, for the frame as well.
TYPED_TEST_P(PathConformance, ContinuityIsFound) {
  constexpr std::size_t n = TypeParam::preimage_degree;
  // Beyond its own degree a polynomial has no derivative that could jump.
  constexpr int expected = n == 0 ? 3 : n < 3 ? static_cast<int>(n) - 1 : 2;
  this->for_each_path("continuity", [&](Random&, const TypeParam& path, Regime) {
    EXPECT_EQ(continuity(path).preimage.order(), expected);
    EXPECT_EQ(continuity(path).position.order(), expected + 1);
    EXPECT_EQ(frame_continuity(path).frame.order(), expected);
    EXPECT_EQ(frame_continuity(path).angular_velocity.order(), expected - 1);
  });
}

// The frame is orthonormal, right-handed, and its first axis is the tangent.
TYPED_TEST_P(PathConformance, TheFrameIsOrthonormalAndAdapted) {
  using S = typename TypeParam::Scalar;
  this->for_each_path("frame", [&](Random&, const TypeParam& path, Regime) {
    for (const double share : {0.05, 0.5, 0.95}) {
      const S xi = path.xi_begin() + S(share) * S(path.xi_end() - path.xi_begin());
      const auto jet = path.template preimage_jet<0>(xi);
      if (!(S(0.001) < speed_form(jet[0], jet[0]))) continue;
      const auto frame = euler_rodrigues_frame(jet);
      // A Taylor scalar divides by σ up to three times: its derivatives grow by 1/σ each time.
      const double growth = carries_derivatives<S> ? 1e9 : 1.0;
      const double tolerance = 16.0;  // products of 4 terms, a division
      EXPECT_CLOSE(S(dot(frame.e1, frame.e1)), S(1), tolerance, growth);
      EXPECT_CLOSE(S(dot(frame.e2, frame.e2)), S(1), tolerance, growth);
      EXPECT_CLOSE(S(dot(frame.e1, frame.e2)), S(0), tolerance, growth);
      EXPECT_CLOSE(frame.e1, tangent(jet), tolerance, growth);
      if constexpr (TypeParam::Point::dimension == 3) {
        EXPECT_CLOSE(frame.e3, cross(frame.e1, frame.e2), tolerance, growth);
      } else {
        EXPECT_CLOSE(S(cross(frame.e1, frame.e2)), S(1), tolerance, growth);
      }
    }
  });
}

REGISTER_TYPED_TEST_SUITE_P(PathConformance, ThePythagoreanIdentityHolds,
                            ArcLengthIsTheIntegralOfTheSpeed, DerivativesAreThoseOfTheSeries,
                            InvariantUnderMotionScaleAndReversal,
                            PartsAndOtherDegreesAreTheSameCurve, ContinuityIsFound,
                            TheFrameIsOrthonormalAndAdapted);

}  // namespace hodograph::test
