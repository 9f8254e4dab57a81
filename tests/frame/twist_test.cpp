// SPDX-License-Identifier: MIT
// Twist and absolute twist: enclosures against quadrature in long double, the closed form,
// symmetries of closed loops, and which frame has the least.
#include "hodograph/frame/twist.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/operations.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/quadrature.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
/// What enclosures of the twist of tame paths are at most wide: some ten thousand roundings, for
/// their pieces are restricted, transformed and multiplied in outward arithmetic.
constexpr double narrow = 0x1.0p-38;
/// Of angles up to some turns: some hundred roundings.
constexpr double roundings = 0x1.0p-44;

/// ∫ of ω₁ ds and of its size between given knots, in long double: `panels` panels of 12 nodes,
/// split where the sense changes.
struct Integrals {
  long double total = 0, absolute = 0;
};
template <std::size_t n, class RollRate>
Integrals integrals(const SpatialPath<n>& path, const std::vector<TwistInflection>& inflections,
                    const RollRate& roll_rate) {
  using Wide = long double;
  static const auto rule = gauss_legendre<Wide, 12>();
  Integrals result;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto preimage = path.segment(k).preimage().mapped(
        [](const Quaternion<double>& a) { return converted<Wide>(a); });
    const Wide h = path.segment(k).parameter_step();
    std::vector<Wide> ends{0};
    for (const auto& inflection : inflections) {
      const Wide u = (Wide(inflection.xi.middle()) - Wide(path.knots()[k])) / h;
      if (0 < u && u < 1) ends.push_back(u);
    }
    ends.push_back(1);
    constexpr int panels = 64;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
      Wide share = 0;
      const Wide width = (ends[i + 1] - ends[i]) / panels;
      for (int j = 0; j < panels; ++j) {
        for (const auto& [node, weight] : rule) {
          const Wide u = ends[i] + width * (static_cast<Wide>(j) + node);
          const auto jet = preimage.template jet<1>(u);
          const Wide erf = 2 * twist_form(jet[0], jet[1]) / dot(jet[0], jet[0]);
          share += weight * width * (erf + roll_rate(Wide(path.knots()[k]) + u * h, h));
        }
      }
      result.total += share;
      result.absolute += std::abs(share);
    }
  }
  return result;
}

/// Within 2^-60: the rounding of long double and what the quadrature leaves of tame rates.
void expect_enclosed(const Enclosure& enclosure, long double expected) {
  constexpr long double rounding = 0x1.0p-56L;  // some hundred of the 2^-64 of long double
  const long double slack = rounding * (1 + std::abs(expected));
  EXPECT_LE(static_cast<long double>(enclosure.lower()), expected + slack);
  EXPECT_GE(static_cast<long double>(enclosure.upper()), expected - slack);
}

template <std::size_t n>
void expect_right(Random& random) {
  const auto path = random_path<SpatialPath<n>>(random, 3);
  const double rate = random.uniform(-3.0, 3.0);
  for (const double linear : {0.0, rate}) {
    const auto twist = frame_twist(path, FrameRoll::linear(path, 0.1, linear)).value();
    const auto expected = integrals(path, twist.inflections, [&](long double, long double h) {
      return static_cast<long double>(linear) * h;
    });
    expect_enclosed(twist.total, expected.total);
    expect_enclosed(twist.absolute, expected.absolute);
    EXPECT_LE(twist.total.width(), narrow);
    EXPECT_LE(twist.absolute.width(), narrow);
    for (const auto& inflection : twist.inflections) {
      EXPECT_EQ(inflection.kind, RootKind::simple);
      const AdaptedFrame frame(path, FrameRoll::linear(path, 0.1, linear));
      const double at = inflection.xi.middle();
      const double h = 0x1.0p-16;  // not a tolerance: how far to either side it is looked
      if (at - h < path.xi_begin() || at + h > path.xi_end()) continue;
      EXPECT_LT(frame.body_rate_per_xi(at - h).x * frame.body_rate_per_xi(at + h).x, 0.0);
    }
  }
  const auto closed = erf_twist_in_closed_form(path);
  ASSERT_TRUE(closed);
  const auto erf = frame_twist(path, FrameRoll::none(path)).value();
  EXPECT_NEAR(closed->value, erf.total.middle(), closed->error + erf.total.width());
  EXPECT_EQ(frame_twist(path, rotation_minimising_roll(path).value())->absolute, Enclosure(0.0));
}

TEST(FrameTwist, EnclosesTheIntegral) {
  Random random("twist");
  for (int repeat = 0; repeat < 10; ++repeat) {
    expect_right<2>(random);
    expect_right<3>(random);
    expect_right<5>(random);
  }
}

TEST(FrameTwist, OfTheFrenetFrameIsTheTotalTorsion) {
  Random random("total torsion");
  for (int repeat = 0; repeat < 5; ++repeat) {
    const auto path = random_path<SpatialPath<3>>(random, 1);
    const auto twist = frame_twist(path, frenet_roll(path).value()).value();
    // ∫ τ σ dξ, by 4096 panels of the midpoint rule in doubles.
    double total = 0.0;
    constexpr int panels = 4096;
    const double h = path.xi_end() - path.xi_begin();
    for (int i = 0; i < panels; ++i) {
      const double xi = path.xi_begin() + h * (i + 0.5) / panels;
      const auto jet = path.preimage_jet<2>(xi);
      total += *torsion(jet) * path.speed(xi) * h / panels;
    }
    constexpr double midpoint =
        1e-4;  // not a tolerance: (h/4096)² times a second derivative of 1e3
    EXPECT_NEAR(twist.total.middle(), total, midpoint * (1.0 + twist.absolute.upper()));
    EXPECT_LE(std::abs(twist.total.middle()), twist.absolute.upper());
  }
}

/// (3) of the paper corrected: with coincident Frenet frames ∫ τ ds = T_ERF - 2ψ + 2πk.
TEST(FrameTwist, TotalTorsionOfLoopsIsNoMultipleOfATurn) {
  constexpr double wide = 0x1.0p-36;  // enclosures of torsion, of degree 18, are this wide
  const double expected[] = {0.0899257, 3.6664482, 0.0640967};
  const LoopShape shapes[] = {{1.0, 0.6 * pi}, {-1.0, 0.1 * pi}, {0.0, 0.6 * pi}};
  for (int i = 0; i < 3; ++i) {
    const auto path = closed_loop(shapes[i]).value();
    const double total = frame_twist(path, frenet_roll(path).value())->total.middle();
    const double erf = frame_twist(path, FrameRoll::none(path))->total.middle();
    EXPECT_NEAR(std::remainder(total - (erf - 2.0 * shapes[i].psi), 2.0 * pi), 0.0, wide);
    constexpr double printed = 0.5e-7;  // not a tolerance: half of the last digit printed
    EXPECT_NEAR(total, expected[i], printed);
  }
}

/// r(ξ,-ψ)(t) = diag(-1,1,1) r(1-t), r(-ξ,-ψ) = diag(1,1,-1) r: a reflection turns angles round.
TEST(FrameTwist, SymmetriesOfClosedLoops) {
  Random random("loop symmetries");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const double xi = random.uniform(-3, 3), psi = random.uniform(0.05, pi - 0.05);
    const auto twist = [](double x, double p) {
      const auto path = closed_loop({x, p}).value();
      return frame_twist(path, FrameRoll::none(path)).value();
    };
    const auto one = twist(xi, psi), mirrored = twist(-xi, -psi), back = twist(xi, -psi);
    const double allowed = 4 * one.total.width() + roundings;
    EXPECT_NEAR(mirrored.total.middle(), -one.total.middle(), allowed);
    EXPECT_NEAR(back.total.middle(), -one.total.middle(), allowed);
    EXPECT_NEAR(mirrored.absolute.middle(), one.absolute.middle(), allowed);
    EXPECT_NEAR(back.absolute.middle(), one.absolute.middle(), allowed);
    // γ of one is γ of the other on the way there, 1/γ on the way back.
    const double gamma = random.uniform(0.1, 3.0) * random.sign();
    const auto periodic = [&](double x, double p, double g) {
      const auto path = closed_loop({x, p}).value();
      return frame_twist(path, periodic_roll(path, g).value())->absolute.middle();
    };
    EXPECT_NEAR(periodic(xi, psi, gamma), periodic(-xi, -psi, gamma), allowed);
    EXPECT_NEAR(periodic(xi, psi, gamma), periodic(xi, -psi, 1.0 / gamma), allowed);
  }
}

TEST(FrameTwist, TheLeastIsTheLeast) {
  Random random("least");
  for (int repeat = 0; repeat < 20; ++repeat) {
    const auto path = closed_loop({random.uniform(-3, 3), random.uniform(-pi, pi)}).value();
    const auto least = frame_twist(path, least_twist_roll(path).value()).value();
    EXPECT_LE(least.absolute.upper(), pi + roundings);
    const auto best = least_twist_gamma(path).value();
    EXPECT_LE(least.absolute.lower(), best.absolute_twist + roundings);
    for (int i = 0; i < 10; ++i) {
      const double gamma = std::exp(random.uniform(-4.0, 4.0)) * random.sign();
      const auto twist = frame_twist(path, periodic_roll(path, gamma).value()).value();
      EXPECT_LE(best.absolute_twist, twist.absolute.upper() + narrow);
      EXPECT_LE(std::abs(twist.total.middle()), twist.absolute.upper());
    }
    const auto at = frame_twist(path, periodic_roll(path, best.gamma).value()).value();
    EXPECT_NEAR(at.absolute.middle(), best.absolute_twist, narrow);
  }
}

TEST(FrameTwist, NearlySingularRatesStayEnclosed) {
  // A zero of the preimage at a distance d from the segment: rates like 1/d.
  for (const int exponent : {-4, -10, -20, -30}) {
    const double d = std::ldexp(1.0, exponent);
    BernsteinPolynomial<Quaternion<double>, 2> a;
    a[0] = {-0.5, d, 0.0, 0.3 * d};
    a[1] = {0.0, d, 0.5 * d, 0.0};
    a[2] = {0.5, d, -0.2 * d, d};
    const auto path = SpatialPath<2>::create({0.0, 1.0}, {{{}, a, 1.0}}, false).value();
    const auto twist = frame_twist(path, FrameRoll::none(path));
    if (exponent == -30) {  // σ is 2^-60 of its largest coefficient: lost in its rounding
      ASSERT_FALSE(twist);
      EXPECT_EQ(twist.fault().code, FaultCode::zero_speed);
      EXPECT_EQ(rotation_minimising_roll(path).fault().code, FaultCode::zero_speed);
      continue;
    }
    ASSERT_TRUE(twist);
    // θ jumps by about 2 · (-π): the angle of (u - 1/2) + i d, twice.
    EXPECT_NEAR(twist->total.middle(), -2.0 * pi, 16.0 * d + 0.5);
    const auto roll = rotation_minimising_roll(path);
    ASSERT_TRUE(roll);
    EXPECT_LE(std::abs(roll->angle(1.0) + twist->total.middle()),
              roll->error_bound() + twist->total.width());
  }
}

TEST(FrameTwist, Refusals) {
  Random random("twist faults");
  const auto path = random_path<SpatialPath<2>>(random, 2);
  const auto other = random_path<SpatialPath<2>>(random, 2);
  EXPECT_EQ(frame_twist(path, FrameRoll::none(other)).fault().code, FaultCode::mismatched_size);
  const auto b = tame_preimage<Quaternion<double>, 1>(random);
  const auto zero = product(BernsteinPolynomial<double, 1>({-1.0, 1.0}), b,
                            [](double x, const Quaternion<double>& q) { return x * q; });
  const auto still = SpatialPath<2>::create({0.0, 1.0}, {{{}, zero, 1.0}}, false).value();
  EXPECT_EQ(frame_twist(still, FrameRoll::none(still)).fault().code, FaultCode::zero_speed);
}

}  // namespace
}  // namespace hodograph::test
