// SPDX-License-Identifier: MIT
// Rational PH curves as values: every curve of the golden file, equal as rationals, and identities
// on random solutions.
#include "hodograph/rational/rational_ph_curve.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

std::string golden_name(CurveKind kind) {
  return kind == CurveKind::constant ? "trivial" : std::string(name_of(kind));
}

void expect_equal(const RationalPhCurve& curve, const Json& expected, const QuaternionPolynomial& a,
                  const RationalPolynomial& alpha) {
  const VectorFunction& r = curve.position();
  EXPECT_EQ(r.numerator(), golden_vector(expected["r_num"]));
  EXPECT_EQ(r.denominator(), golden_polynomial(expected["r_den"]));
  EXPECT_EQ(golden_name(curve.kind()), expected["class"].string());
  EXPECT_EQ(curve.lambda(), golden_function(expected["lambda"]));
  EXPECT_EQ(curve.speed(), golden_function(expected["signed_speed"]));
  const VectorFunction velocity = r.derivative();
  EXPECT_EQ(dot(velocity, velocity), curve.speed() * curve.speed());
  const VectorPolynomial b =
      RationalPolynomial(Rational(-1, 2)) * divided(alpha * r.numerator(), r.denominator());
  EXPECT_EQ(mu_of(b, alpha, curve.indicatrix()), golden_polynomial(expected["mu"]));
  const auto motion = framing_motion(a, alpha, b);
  EXPECT_TRUE(satisfies_study_condition(motion));
  EXPECT_TRUE(is_framing(motion));
  EXPECT_TRUE(is_framing(curve.motion()));
  EXPECT_EQ(trajectory(curve.motion(), {}), r);
  EXPECT_EQ(content(motion), golden_polynomial(expected["motion_content"]));
  const RationalIntegral length = curve.arc_length();
  EXPECT_EQ(curve.arc_length_is_rational(), expected["arc_length_rational"].number() == 1.0);
  if (expected.has("arc_length")) {
    EXPECT_EQ(length.rational, golden_function(expected["arc_length"]));
  }
  if (expected.has("arc_length_log_obstruction")) {
    EXPECT_EQ(length.obstruction, golden_function(expected["arc_length_log_obstruction"]));
  }
  EXPECT_EQ(static_cast<double>(curve.poles().size()), expected["real_poles"].number());
  EXPECT_EQ(static_cast<double>(curve.stationary_points().size()),
            expected["real_zeros_of_lambda"].number());
}

void expect_equal_parts(const RationalPhCurve& curve, const Json& expected) {
  const auto parts = curve.decomposition();
  EXPECT_EQ(parts.polynomial_lambda, golden_polynomial(expected["polynomial_lambda"]));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(parts.constant[c], golden_rational(expected["constant"][c]));
  }
  // The file lists the factors of alpha, those without a principal part among them.
  std::size_t nonzero = 0;
  for (const Json& piece : expected["pieces"].list()) {
    const RationalFunction lambda = golden_function(piece["lambda"]);
    if (lambda.is_zero()) continue;
    ++nonzero;
    bool found = false;
    for (const auto& part : parts.pieces) {
      if (part.pole != golden_polynomial(piece["q"])) continue;
      found = true;
      EXPECT_EQ(part.lambda, lambda);
      EXPECT_EQ(part.curve,
                VectorFunction(golden_vector(piece["r_num"]), golden_polynomial(piece["r_den"])));
    }
    EXPECT_TRUE(found);
  }
  EXPECT_EQ(parts.pieces.size(), nonzero);
}

TEST(RationalPhCurve, EveryGoldenCurve) {
  const Json file = golden_file("rational.json");
  std::size_t compared = 0;
  for (const Json& c : file["cases"].list()) {
    const auto a = golden_quaternion(c["A_reduced"]);
    const auto alpha = golden_polynomial(c["alpha"]);
    for (std::size_t d = 0; d < 64; ++d) {
      if (!c["solutions"].has(std::to_string(d))) continue;
      SCOPED_TRACE(c["name"].string() + ", deg B <= " + std::to_string(d));
      const auto basis = solve(a, alpha, d).value().canonical_basis();
      const Json& curves = c["solutions"][std::to_string(d)]["curves"];
      std::size_t next = 0;
      for (const auto& b : basis) {
        const auto curve = RationalPhCurve::create(a, alpha, b).value();
        if (curve.kind() == CurveKind::constant) continue;
        ASSERT_LT(next, curves.size());
        expect_equal(curve, curves[next++], a, alpha);
        ++compared;
      }
      EXPECT_EQ(next, curves.size());
    }
    if (!c.has("given_curves")) continue;
    for (const Json& given : c["given_curves"].list()) {
      SCOPED_TRACE(given["label"].string());
      const auto curve =
          RationalPhCurve::create(
              a, VectorFunction(golden_vector(given["r_num"]), golden_polynomial(given["r_den"])))
              .value();
      expect_equal(curve, given, a, alpha);
      ++compared;
      if (given.has("decomposition")) expect_equal_parts(curve, given["decomposition"]);
      if (given.has("dual_f") && !curve.is_planar()) {
        const RationalFunction f = golden_function(given["dual_f"]);
        EXPECT_EQ(curve.osculating_planes(), f);
        EXPECT_EQ(RationalPhCurve::from_osculating_planes(a, f).value().position(),
                  curve.position());
      }
    }
  }
  EXPECT_EQ(compared, 102u);
}

TEST(RationalPhCurve, GoldenFramesAndSingularPoints) {
  const Json file = golden_file("rational.json");
  for (const Json& c : file["cases"].list()) {
    SCOPED_TRACE(c["name"].string());
    const auto a = golden_quaternion(c["A_reduced"]);
    const auto curve = RationalPhCurve::create(a, VectorFunction()).value();
    const Json& expected = c["erf"];
    EXPECT_EQ(curve.frame().e1, golden_vector(expected["e1"]));
    EXPECT_EQ(curve.frame().e2, golden_vector(expected["e2"]));
    EXPECT_EQ(curve.frame().e3, golden_vector(expected["e3"]));
    EXPECT_EQ(curve.angular_velocity(), golden_vector(expected["angular"]));
    EXPECT_EQ(curve.frame_is_rotation_minimising(),
              expected["rotation_minimising"].number() == 1.0);
    const auto cusps = golden_polynomial(c["cusp_gcd_F_x_Fprime"]);
    if (!cusps.is_zero()) {
      EXPECT_EQ(curve.inflections().size(), real_roots(cusps).size());
    }
    const auto torsion = golden_polynomial(c["det_F_F1_F2"]);
    EXPECT_EQ(curve.is_planar(), torsion.is_zero());
    if (!torsion.is_zero()) {
      EXPECT_EQ(curve.torsion_zeros().size(), real_roots(torsion).size());
    }
  }
}

TEST(RationalPhCurve, RandomSolutionsAreWhatTheyClaim) {
  Random random("random rational PH curves");
  for (int i = 0; i < 25; ++i) {
    const auto a = random_quaternion_polynomial(random, 1 + random.index(2), 3);
    const auto alpha =
        random_polynomial(random, 1, 3).power(3) * random_polynomial(random, 2, 3).power(3);
    const auto space = solve(a, alpha, 12).value();
    VectorPolynomial b;
    for (const auto& element : space.basis()) {
      b += RationalPolynomial(random.integer(-3, 3)) * element;
    }
    const auto curve = RationalPhCurve::create(space.preimage(), alpha, b).value();
    const VectorFunction velocity = curve.position().derivative();
    EXPECT_EQ(dot(velocity, velocity), curve.speed() * curve.speed());
    EXPECT_EQ(velocity, curve.lambda() * VectorFunction(curve.indicatrix(), 1));
    const auto parts = curve.decomposition();
    VectorFunction sum({parts.constant.x, parts.constant.y, parts.constant.z}, 1);
    RationalFunction lambda(parts.polynomial_lambda);
    for (const auto& piece : parts.pieces) {
      sum = sum + piece.curve;
      lambda = lambda + piece.lambda;
      EXPECT_TRUE(RationalPhCurve::create(a, piece.curve));
    }
    EXPECT_EQ(lambda, curve.lambda());
    EXPECT_TRUE((curve.position() - sum).is_polynomial());
    if (!curve.is_planar()) {
      const auto back = RationalPhCurve::from_osculating_planes(a, curve.osculating_planes());
      EXPECT_EQ(back.value().position(), curve.position());
    }
  }
}

TEST(RationalPhCurve, RefusesWhatIsNone) {
  const auto t = RationalPolynomial::monomial(1, 1);
  const QuaternionPolynomial a{t * t, -t, -t, 1};
  const auto other = RationalPhCurve::create(a, VectorFunction({t, t * t, {}}, 1));
  ASSERT_FALSE(other);
  EXPECT_EQ(other.fault().code, FaultCode::outside_domain);
  EXPECT_NE(other.fault().sentence.find("t^4 - 1"), std::string::npos) << other.fault().sentence;
  EXPECT_FALSE(RationalPhCurve::create(a, {}, {t, t, t}));
  EXPECT_FALSE(RationalPhCurve::create({}, VectorFunction()));
  const QuaternionPolynomial planar{1, {}, {}, t};
  const auto refused = RationalPhCurve::from_osculating_planes(planar, RationalFunction(t));
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.fault().sentence.find("planar"), std::string::npos);
}

TEST(RealRoots, AreIsolatedExactly) {
  const auto t = RationalPolynomial::monomial(1, 1);
  // Neighbours: the square root of 2, a fraction close to it, a pair of close roots, a double root.
  const auto p = (t * t - 2).power(3) * (t - Rational(1414213562373, 1000000000000)) *
                 (t * t * 1000000 - t * 2000000 + 999999) * (t + 5) * (t * t + 1);
  const auto roots = real_roots(p);
  ASSERT_EQ(roots.size(), 6u);
  for (std::size_t i = 0; i + 1 < roots.size(); ++i) {
    EXPECT_LT(roots[i].upper(), roots[i + 1].lower());
  }
  EXPECT_TRUE(roots[0].is_rational());
  EXPECT_EQ(roots[1].multiplicity(), 3u);
  EXPECT_EQ(roots[1].to_double(), -std::sqrt(2.0));
  EXPECT_EQ(roots[5].to_double(), std::sqrt(2.0));
  EXPECT_EQ(roots[4].lower(), Rational(1414213562373, 1000000000000));
  EXPECT_EQ(count_real_roots(p, 0, 1), 1u);
  EXPECT_EQ(count_real_roots(p, -5, 2), 6u);
  EXPECT_EQ(count_real_roots(p, 2, 100), 0u);
}

}  // namespace
}  // namespace hodograph
