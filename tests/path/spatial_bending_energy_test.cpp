// SPDX-License-Identifier: MIT
// The bending energy of curves in space: against quadrature in wide arithmetic, against the plane,
// and its scale.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/random.hpp"

namespace hodograph::test {
namespace {

/// ∫ κ² σ by Simpson's rule in long double, its own error far below that of double.
template <std::size_t n>
long double simpson(const SpatialPhCurve<n>& curve) {
  using Wide = Quaternion<long double>;
  BernsteinPolynomial<Wide, n> preimage;
  for (std::size_t i = 0; i <= n; ++i) {
    const auto& a = curve.preimage()[i];
    preimage[i] = {a.w, a.x, a.y, a.z};
  }
  const SpatialPhCurve<n, long double> wide({}, preimage, curve.parameter_step());
  const auto integrand = [&](int i, int count) {
    const auto jet = wide.template preimage_jet<1>(static_cast<long double>(i) / count);
    const long double kappa = curvature(jet);
    return kappa * kappa * speed_form(jet[0], jet[0]);
  };
  constexpr int count = 8192;
  long double sum = integrand(0, count) + integrand(count, count);
  for (int i = 1; i < count; ++i) sum += (i % 2 == 1 ? 4.0L : 2.0L) * integrand(i, count);
  return sum / (3 * count) * curve.parameter_step();
}

TEST(SpatialBendingEnergy, IsTheIntegral) {
  Random random("spatial bending energy");
  for (int i = 0; i < 50; ++i) {
    const LoopShape shape{random.uniform(-2.0, 2.0), random.uniform(-3.0, 3.0)};
    const double length = std::abs(random.spread(-80, 80));
    const auto path = closed_loop(shape, {length, {}, random.rotation()}).value();
    const auto enclosure = bending_energy_enclosure(path);
    const auto energy = bending_energy(path);
    ASSERT_TRUE(enclosure && energy);
    EXPECT_LE(enclosure->width(), 4096 * epsilon<double>() * *energy);
    EXPECT_NEAR(*energy, enclosure->middle(), enclosure->width());
    const double judge = static_cast<double>(simpson(path.segment(0)));
    // Simpson's remainder falls with the fourth power of 1/8192: about 2^-40 for these loops.
    constexpr double remainder = 0x1.0p-36;
    EXPECT_NEAR(enclosure->middle(), judge, remainder * judge);
    const auto twice = bending_energy(scaled(path, 2.0).value());
    EXPECT_NEAR(2.0 * *twice, *energy, 16 * epsilon<double>() * *energy);
  }
}

TEST(SpatialBendingEnergy, AgreesWithThePlane) {
  Random random("planar bending energy in space");
  for (int i = 0; i < 50; ++i) {
    BernsteinPolynomial<Complex<double>, 3> w;
    for (std::size_t k = 0; k <= 3; ++k) w[k] = random.complex(1.0);
    const auto planar =
        PlanarPath<3>::create({0.0, 1.0}, {PlanarPhCurve<3>({}, w, 1.0)}, false).value();
    const auto spatial = lifted(planar).value();
    const auto plane = bending_energy_enclosure(planar), space = bending_energy_enclosure(spatial);
    ASSERT_EQ(plane.has_value(), space.has_value());
    if (!plane) continue;
    EXPECT_LE(std::max(plane->lower(), space->lower()), std::min(plane->upper(), space->upper()));
    const auto turned = bending_energy_enclosure(moved(spatial, random.rotation(), {}).value());
    ASSERT_TRUE(turned);
    EXPECT_NEAR(turned->middle(), plane->middle(),
                1024 * epsilon<double>() * plane->middle() + turned->width());
  }
}

TEST(SpatialBendingEnergy, OfAStraightPathIsZero) {
  BernsteinPolynomial<Quaternion<double>, 2> straight;
  for (std::size_t i = 0; i <= 2; ++i)
    straight[i] = (1.0 + static_cast<double>(i)) * Quaternion<double>{0.5, 0.5, 0.5, 0.5};
  const SpatialPhCurve<2> curve({}, straight, 1.0);
  EXPECT_EQ(bending_energy_enclosure(curve).value().lower(), 0.0);
  constexpr double squared_rounding = 0x1.0p-90;  // of a curvature of 2^-50
  EXPECT_LE(bending_energy_enclosure(curve).value().upper(), squared_rounding);
  EXPECT_EQ(bending_energy(curve).value(), 0.0);
}

TEST(SpatialBendingEnergy, OfAStandstillIsRefused) {
  const auto limit = closed_loop({std::numeric_limits<double>::infinity(), 1.0}).value();
  EXPECT_EQ(bending_energy(limit).fault().code, FaultCode::zero_speed);
  EXPECT_EQ(bending_energy_enclosure(limit).fault().code, FaultCode::zero_speed);
}

}  // namespace
}  // namespace hodograph::test
