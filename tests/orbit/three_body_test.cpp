// SPDX-License-Identifier: MIT
// The equations of motion, their series, and the frames.
#include "hodograph/orbit/three_body.hpp"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

#include "hodograph/orbit/motion_series.hpp"
#include "hodograph/orbit/reference_frame.hpp"

namespace hodograph {
namespace {

using Real50 = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>,
                                             boost::multiprecision::et_off>;

constexpr double eps = std::numeric_limits<double>::epsilon();

// States near the Moon, near the Earth and far from both.
const std::array<OrbitState<double>, 4> states{{
    {{1.0273, 0.0, -0.1855}, {0.0, -0.1145, 0.0}},
    {{0.98726, -0.00214, 0.01057}, {-0.0127, 1.4617, 0.1522}},
    {{0.05, 0.11, -0.02}, {1.1, -2.3, 0.4}},
    {{-2.5, 3.25, 0.75}, {0.125, 0.5, -0.25}},
}};

template <class T>
OrbitState<T> cast(const OrbitState<double>& s) {
  return {{T(s.position.x), T(s.position.y), T(s.position.z)},
          {T(s.velocity.x), T(s.velocity.y), T(s.velocity.z)}};
}

// Ω and C are sums of fewer than 8 terms, each within 8 roundings.
constexpr double sum_error = 64 * eps;

TEST(ThreeBody, PrimariesRestAtMinusMuAndOneMinusMu) {
  const double mu = earth_moon_system.mass_ratio;
  EXPECT_EQ(offset_from_larger(earth_moon_system, Vector3<double>{-mu, 0.0, 0.0}).x, 0.0);
  EXPECT_LE(std::abs(offset_from_smaller(earth_moon_system, Vector3<double>{1.0 - mu, 0.0, 0.0}).x),
            eps);
}

TEST(ThreeBody, TriangularPointsAreEquilibria) {
  const double mu = earth_moon_system.mass_ratio;
  for (const double side : {1.0, -1.0}) {
    const OrbitState<double> rest{{0.5 - mu, side * std::sqrt(0.75), 0.0}, {0.0, 0.0, 0.0}};
    EXPECT_LE(largest_component(three_body_acceleration(earth_moon_system, rest)), sum_error);
    // Ω = ((1/2 - μ)² + 3/4)/2 + 1 there, both distances being 1.
    EXPECT_NEAR(jacobi_constant(earth_moon_system, rest), 3.0 - mu + mu * mu, sum_error);
  }
}

TEST(ThreeBody, MovingAlongXIsDeflectedTowardsMinusY) {
  const OrbitState<double> rest{{0.3, 0.2, 0.1}, {0.0, 0.0, 0.0}};
  OrbitState<double> moving = rest;
  moving.velocity.x = 1.0;
  const Vector3<double> difference = three_body_acceleration(earth_moon_system, moving) -
                                     three_body_acceleration(earth_moon_system, rest);
  EXPECT_NEAR(difference.y, -2.0, sum_error * 32.0);  // the accelerations themselves are below 32
  EXPECT_EQ(difference.x, 0.0);
  EXPECT_EQ(difference.z, 0.0);
}

TEST(ThreeBody, GradientAndHessianAreThePotentialsDerivatives) {
  using First = Taylor<double, 1>;
  for (const OrbitState<double>& s : states) {
    const Vector3<double> gradient = pseudo_potential_gradient(earth_moon_system, s.position);
    const auto hessian = pseudo_potential_hessian(earth_moon_system, s.position);
    for (std::size_t i = 0; i < 3; ++i) {
      Vector3<First> p{s.position.x, s.position.y, s.position.z};
      p[i] = First::variable(s.position[i]);
      EXPECT_NEAR(pseudo_potential(earth_moon_system, p)[1], gradient[i],
                  sum_error * (1.0 + largest_component(gradient)));
      const Vector3<First> slope = pseudo_potential_gradient(earth_moon_system, p);
      double size = 1.0;
      for (const auto& row : hessian) size = std::max(size, largest_component(row));
      for (std::size_t j = 0; j < 3; ++j) {
        EXPECT_NEAR(slope[j][1], hessian[j][i], sum_error * size) << i << j;
        EXPECT_EQ(hessian[i][j], hessian[j][i]);
      }
    }
  }
}

TEST(ThreeBody, SeriesSatisfiesTheEquationsOfMotion) {
  constexpr std::size_t order = 12;
  for (const OrbitState<double>& start : states) {
    const OrbitState<Real50> s = cast<Real50>(start);
    const auto r = motion_series<order>(earth_moon_system, s);
    OrbitState<Taylor<Real50, order>> motion{r, {}};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < order; ++k) {
        motion.velocity[i][k] = Real50(static_cast<double>(k + 1)) * r[i][k + 1];
      }
    }
    // The field, evaluated on the series, must give the series' own second derivative.
    const auto a = three_body_acceleration(earth_moon_system, motion);
    for (std::size_t k = 0; k + 2 <= order; ++k) {
      Real50 size(0), error(0);
      for (std::size_t i = 0; i < 3; ++i) {
        const Real50 second = Real50(static_cast<double>((k + 1) * (k + 2))) * r[i][k + 2];
        size = std::max(size, Real50(abs(a[i][k])));
        error = std::max(error, Real50(abs(a[i][k] - second)));
      }
      // Each coefficient sums at most k² products of numbers that may cancel by a few digits.
      const Real50 bound = Real50(1000.0 * static_cast<double>((k + 1) * (k + 1))) *
                           std::numeric_limits<Real50>::epsilon() * (Real50(1) + size);
      EXPECT_LE(error, bound) << "coefficient " << k;
    }
  }
}

TEST(ThreeBody, DerivativesBeginWithTheStateAndItsAcceleration) {
  for (const OrbitState<double>& s : states) {
    const auto jet = motion_derivatives(earth_moon_system, s);
    const Vector3<double> a = three_body_acceleration(earth_moon_system, s);
    EXPECT_EQ(jet[0], s.position);
    EXPECT_EQ(jet[1], s.velocity);
    EXPECT_LE(largest_component(jet[2] - a), sum_error * (1.0 + largest_component(a)));
    // And agree with themselves in fifty digits: four recursions of some 30 roundings.
    const auto exact = motion_derivatives(earth_moon_system, cast<Real50>(s));
    for (std::size_t r = 2; r < 5; ++r) {
      double size = 0.0, error = 0.0;
      for (std::size_t i = 0; i < 3; ++i) {
        size = std::max(size, std::abs(to_double(exact[r][i])));
        error = std::max(error, std::abs(to_double(exact[r][i] - Real50(jet[r][i]))));
      }
      EXPECT_LE(error, 128.0 * eps * (1.0 + size)) << "derivative " << r;
    }
  }
}

TEST(ReferenceFrame, InertialDerivativesAreThoseOfTheRotatedSeries) {
  using Series = Taylor<double, 4>;
  for (const OrbitState<double>& s : states) {
    for (const double time : {0.0, 0.7, 3.5, -2.0}) {
      const auto r = motion_series<4>(earth_moon_system, s);
      const auto [sine, cosine] = sin_cos(Series::variable(time));
      const Vector3<Series> offset = offset_from_larger(earth_moon_system, r);
      const Vector3<Series> turned{cosine * offset.x - sine * offset.y,
                                   sine * offset.x + cosine * offset.y, offset.z};
      const auto jet = to_earth_centred_inertial(earth_moon_system,
                                                 motion_derivatives(earth_moon_system, s), time);
      const auto back = from_earth_centred_inertial(earth_moon_system, jet, time);
      double size = 1.0;
      for (std::size_t k = 0; k < 5; ++k) {
        for (std::size_t i = 0; i < 3; ++i) {
          size = std::max(size, std::abs(turned[i].derivative(k)));
          EXPECT_NEAR(jet[k][i], turned[i].derivative(k), sum_error * size);
          EXPECT_NEAR(back[k][i], r[i].derivative(k), sum_error * size);
        }
      }
    }
  }
}

TEST(ReferenceFrame, TheMoonCirclesTheEarthOncePerTwoPi) {
  const double mu = earth_moon_system.mass_ratio;
  const MotionJet<double, 3> moon{{{1.0 - mu, 0.0, 0.0}, {}, {}}};
  const double quarter = std::acos(0.0);
  const auto jet = to_earth_centred_inertial(earth_moon_system, moon, quarter);
  EXPECT_LE(largest_component(jet[0] - Vector3<double>{0.0, 1.0, 0.0}), 2 * eps);
  EXPECT_LE(largest_component(jet[0] - smaller_primary_inertial(quarter)), 2 * eps);
  EXPECT_LE(largest_component(jet[1] - Vector3<double>{-1.0, 0.0, 0.0}), 2 * eps);
  EXPECT_LE(largest_component(jet[2] - Vector3<double>{0.0, -1.0, 0.0}), 2 * eps);
}

TEST(ThreeBody, ImpossibleSystemsAreRefused) {
  const auto sentence = [](const ThreeBodySystem& s) {
    const auto fault = check_system(s);
    return fault ? fault->sentence : std::string("accepted");
  };
  EXPECT_EQ(sentence(earth_moon_system), "accepted");
  EXPECT_EQ(sentence({0.75, 1.0, 1.0}),
            "the mass ratio is 0.75; it is the smaller primary's share of the mass, in (0, 0.5]");
  EXPECT_EQ(sentence({std::nan(""), 1.0, 1.0}),
            "the mass ratio is nan; it is the smaller primary's share of the mass, in (0, 0.5]");
  EXPECT_EQ(sentence({0.25, -1.0, 1.0}),
            "the length unit is -1 km; it must be positive and finite");
  EXPECT_EQ(sentence({0.25, 1.0, HUGE_VAL}),
            "the time unit is inf s; it must be positive and finite");
}

}  // namespace
}  // namespace hodograph
