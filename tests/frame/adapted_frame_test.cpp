// SPDX-License-Identifier: MIT
// Adapted frames and their rates of rotation: all four forms, rolled or not, against
// differentiation of the frame itself.
#include "hodograph/frame/adapted_frame.hpp"

#include <gtest/gtest.h>

#include "hodograph/foundation/taylor.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::converted;
using test::Random;
using test::random_path;

using Series = Taylor<double, 3>;

/// Rates of tame paths: the speed is at least 1/4 and the r-th derivatives of the preimage at most
/// 2^r n!/(n-r)! ≤ 1344 / h^r, h ≥ 1/2, so terms reach 1e6; every one passes a few dozen roundings.
constexpr double rate_tolerance = 64;

/// A roll that has every derivative.
struct WavyRoll {
  template <std::size_t K>
  std::array<Series, K + 1> derivatives(const Series& xi) const {
    return from_all<K, Series>(sin(xi), cos(xi));
  }
  template <std::size_t K>
  std::array<double, K + 1> derivatives(double xi) const {
    return from_all<K, double>(std::sin(xi), std::cos(xi));
  }
  template <std::size_t K, class S>
  static std::array<S, K + 1> from_all(const S& s, const S& c) {
    const std::array<S, 5> all{s, c, -s, -c, s};
    std::array<S, K + 1> result;
    for (std::size_t r = 0; r <= K; ++r) result[r] = all[r];
    return result;
  }
};

/// The r-th derivative of a vector or frame of Taylor series.
Vector3<double> derivative(const Vector3<Series>& v, std::size_t r) {
  return {v.x.derivative(r), v.y.derivative(r), v.z.derivative(r)};
}
Frame3<double> derivative(const Frame3<Series>& f, std::size_t r) {
  return {derivative(f.e1, r), derivative(f.e2, r), derivative(f.e3, r)};
}

template <class V, std::size_t size>
double largest(const std::array<V, size>& values) {
  double result = 1.0;
  for (const auto& v : values) result = std::max(result, largest_component(v));
  return result;
}

/// Every derivative of the frame and of its rates against the Taylor series of the frame alone.
template <class SeriesFrame, class DoubleFrame>
void expect_consistent(const SeriesFrame& series, const DoubleFrame& frame, double xi) {
  const Series variable = Series::variable(xi);
  const auto r = series.at(variable);
  const auto derivatives = frame.template derivatives<3>(xi);
  double scale = 1.0;
  for (std::size_t k = 0; k <= 3; ++k) {
    const auto expected = derivative(r, k);
    for (const auto& e : {expected.e1, expected.e2, expected.e3}) {
      scale = std::max(scale, largest_component(e));
    }
    EXPECT_CLOSE(derivatives[k], expected, rate_tolerance, scale);
  }

  // χ₁ = e₂'·e₃, χ₂ = e₃'·e₁, χ₃ = e₁'·e₂ of the series, one order lower.
  const auto d = [](const Vector3<Series>& v) {
    const auto one = [](const Series& x) {
      Series y;
      for (std::size_t k = 0; k < 3; ++k)
        y[k] = Series::Base(static_cast<double>(k + 1)) * x[k + 1];
      return y;
    };
    return Vector3<Series>{one(v.x), one(v.y), one(v.z)};
  };
  const Vector3<Series> chi{dot(d(r.e2), r.e3), dot(d(r.e3), r.e1), dot(d(r.e1), r.e2)};
  const Vector3<Series> omega = chi.x * r.e1 + chi.y * r.e2 + chi.z * r.e3;
  const auto body = frame.template body_rate_per_xi_derivatives<2>(xi);
  const auto world = frame.template world_rate_per_xi_derivatives<2>(xi);
  for (std::size_t k = 0; k <= 2; ++k) {
    EXPECT_CLOSE(body[k], derivative(chi, k), rate_tolerance, scale);
    EXPECT_CLOSE(world[k], derivative(omega, k), rate_tolerance, scale);
  }
  EXPECT_EQ(frame.body_rate_per_xi(xi), frame.template body_rate_per_xi_derivatives<0>(xi)[0]);
  EXPECT_EQ(frame.world_rate_per_xi(xi), frame.template world_rate_per_xi_derivatives<0>(xi)[0]);
}

TEST(AdaptedFrame, DerivativesAgreeWithTheSeriesOfTheFrame) {
  Random random("adapted frame");
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto path = random_path<SpatialPath<4>>(random, 2);
    const auto series = converted<Series>(path);
    const LinearRoll<double> roll{path.xi_begin(), 0.5, -2.0};
    const LinearRoll<Series> series_roll{path.xi_begin(), 0.5, -2.0};
    for (const double u : {0.0, 0.3, 0.55, 0.9}) {
      const double xi = path.xi_begin() + u * (path.xi_end() - path.xi_begin());
      expect_consistent(AdaptedFrame(series), AdaptedFrame(path), xi);
      expect_consistent(AdaptedFrame(series, series_roll), AdaptedFrame(path, roll), xi);
      expect_consistent(AdaptedFrame(series, WavyRoll{}), AdaptedFrame(path, WavyRoll{}), xi);
    }
  }
}

TEST(AdaptedFrame, RatesPerArcLengthAreDerivativesByArcLength) {
  Random random("adapted frame arc length");
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto path = random_path<SpatialPath<4>>(random, 1);
    const auto series = converted<Series>(path);
    const AdaptedFrame frame(path, WavyRoll{});
    const AdaptedFrame in_series(series, WavyRoll{});
    const double xi = path.xi_begin() + random.unit() * (path.xi_end() - path.xi_begin());
    const Series variable = Series::variable(xi);
    const Series sigma = series.speed(variable);
    const auto by_arc_length = [&](Vector3<Series> f, std::size_t order) {
      for (std::size_t r = 0; r < order; ++r) {
        for (std::size_t i = 0; i < 3; ++i) {
          Series d;
          for (std::size_t k = 0; k < 3; ++k) d[k] = static_cast<double>(k + 1) * f[i][k + 1];
          f[i] = d / sigma;
        }
      }
      return derivative(f, 0);
    };
    const auto body = frame.body_rate_per_arc_length_derivatives<2>(xi);
    const auto world = frame.world_rate_per_arc_length_derivatives<2>(xi);
    const double body_scale = largest(body), world_scale = largest(world);
    const Vector3<Series> chi = (Series(1) / sigma) * in_series.body_rate_per_xi(variable);
    const Vector3<Series> omega = (Series(1) / sigma) * in_series.world_rate_per_xi(variable);
    for (std::size_t r = 0; r <= 2; ++r) {
      EXPECT_CLOSE(body[r], by_arc_length(chi, r), rate_tolerance, body_scale);
      EXPECT_CLOSE(world[r], by_arc_length(omega, r), rate_tolerance, world_scale);
    }
    EXPECT_CLOSE(frame.body_rate_per_arc_length(xi), body[0], rate_tolerance, body_scale);
    EXPECT_CLOSE(frame.world_rate_per_arc_length(xi), world[0], rate_tolerance, world_scale);
  }
}

TEST(AdaptedFrame, TheRollIsARightFactorOfThePreimage) {
  Random random("adapted frame roll");
  const auto path = random_path<SpatialPath<3>>(random, 1);
  const double xi = 0.5 * (path.xi_begin() + path.xi_end()), theta = 0.7;
  const auto jet = path.preimage_jet<0>(xi);
  const Roll<double> half{std::cos(theta / 2), std::sin(theta / 2)};
  const std::array<Quaternion<double>, 1> turned{jet[0] * half};
  EXPECT_CLOSE(AdaptedFrame(path, LinearRoll<double>{0, theta, 0}).at(xi),
               euler_rodrigues_frame(turned), 8.0, 1.0);
}

TEST(AdaptedFrame, StandingStillIsAnError) {
  const BernsteinPolynomial<Quaternion<double>, 1> a({Quaternion<double>{}, {1, 0, 0, 0}});
  const auto path =
      SpatialPath<1>::create({0.0, 1.0}, {SpatialPhCurve<1>({}, a, 1.0)}, false).value();
  const AdaptedFrame frame(path);
  try {
    (void)frame.at(0.0);
    FAIL() << "no error";
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().code, FaultCode::zero_speed);
    EXPECT_STREQ(error.what(), "the path stands still at xi = 0: no frame exists there");
  }
  EXPECT_NO_THROW((void)frame.at(0.5));
}

}  // namespace
}  // namespace hodograph
