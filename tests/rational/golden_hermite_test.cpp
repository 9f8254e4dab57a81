// SPDX-License-Identifier: MIT
// Every Hermite problem of tests/golden/rational.json, equal as rationals.
#include <gtest/gtest.h>

#include <string>

#include "hodograph/rational/cusp_free.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

RationalVector golden_point(const Json& list) {
  return {golden_rational(list[0]), golden_rational(list[1]), golden_rational(list[2])};
}

RationalHermiteData golden_data(const Json& problem) {
  RationalHermiteData data{golden_point(problem["P0"]),
                           golden_point(problem["P1"]),
                           {},
                           {},
                           golden_rational(problem["interval"][0]),
                           golden_rational(problem["interval"][1])};
  if (problem["v0"].size() == 3) {
    data.begin_derivative = golden_point(problem["v0"]);
    data.end_derivative = golden_point(problem["v1"]);
  }
  return data;
}

std::size_t golden_count(const Json& number) { return static_cast<std::size_t>(number.number()); }

/// A curve as the golden file states it, and what it says of its cusps.
void expect_curve(const RationalPhCurve& curve, const Json& expected) {
  EXPECT_EQ(curve.position(),
            VectorFunction(golden_vector(expected["r_num"]), golden_polynomial(expected["r_den"])));
  EXPECT_EQ(curve.lambda(), golden_function(expected["lambda"]));
  std::size_t cusps = 0, changes = 0;
  for (const RealRoot& root : curve.stationary_points()) {
    if (root.compare(0) < 0 || root.compare(1) > 0) continue;
    ++cusps;
    changes += root.multiplicity() % 2;
  }
  EXPECT_EQ(cusps, golden_count(expected["cusps_on_interval"]));
  EXPECT_EQ(changes, golden_count(expected["sign_changes"]));
  EXPECT_EQ(count_real_roots(curve.position().denominator(), 0, 1),
            golden_count(expected["poles_on_interval"]));
  EXPECT_EQ(curve.lambda().value(0).sign() > 0, golden_count(expected["forward"]) != 0);
}

TEST(GoldenHermite, EveryProblem) {
  const Json file = golden_file("rational.json");
  std::size_t compared = 0;
  for (const Json& problem : file["hermite"].list()) {
    SCOPED_TRACE(problem["name"].string());
    ++compared;
    const RationalHermiteData data = golden_data(problem);
    const SolutionSpace space =
        solve(golden_quaternion(problem["A"]), golden_polynomial(problem["alpha"]),
              golden_count(problem["degB"]))
            .value();
    const HermiteCurves curves = HermiteCurves::create(space, data).value();
    EXPECT_EQ(curves.unknowns(), golden_count(problem["unknowns"]));
    EXPECT_EQ(curves.equations(), golden_count(problem["equations"]));
    EXPECT_EQ(curves.solvable(), golden_count(problem["solvable"]) != 0);

    const RationalVector chord = data.end_point - data.begin_point;
    const ConeTest cone = cone_test(space.indicatrix(), chord, 0, 1);
    EXPECT_EQ(cone.outcome == ConeTest::Outcome::inside, problem["cone_test"].string() == "inside");
    EXPECT_EQ(cone.outcome == ConeTest::Outcome::outside,
              problem["cone_test"].string() == "outside");
    EXPECT_TRUE(holds(cone, space.indicatrix(), chord, 0, 1)) << cone.sentence;

    const CuspFreeAnswer answer = cusp_free_curve(curves).value();
    EXPECT_TRUE(holds(answer, curves)) << answer.sentence;
    if (!curves.solvable()) {
      EXPECT_EQ(answer.reason, CuspFreeAnswer::Reason::contradiction);
      continue;
    }
    EXPECT_EQ(curves.freedom(), golden_count(problem["free"]));
    if (problem.has("unique")) {
      expect_curve(curves.curve({}), problem["unique"]);
      EXPECT_EQ(answer.outcome == CuspFreeAnswer::Outcome::found,
                golden_count(problem["unique"]["cusps_on_interval"]) == 0);
      continue;
    }
    const auto nodes = equidistant(0, 1, golden_count(problem["nodes"]));
    const Rational target = golden_rational(problem["lsq_target"]);
    EXPECT_EQ(target, taxicab_length(chord));
    expect_curve(curves.curve(curves.nearest_to_speed(target, nodes)), problem["lsq"]);

    const Rational least = golden_rational(problem["maximin_node_speed"]);
    const NodeOptimum optimum = fastest_at_nodes(curves, nodes, target);
    EXPECT_EQ(optimum.least_speed, least);
    EXPECT_FALSE(optimum.capped);
    EXPECT_EQ(answer.outcome == CuspFreeAnswer::Outcome::found, least.sign() > 0);
    EXPECT_EQ(curves.is_cusp_free(optimum.parameters) || least.sign() > 0, least.sign() > 0);

    // The rounded curve of the golden file meets the data, and its certificate is confirmed.
    const Json& sample = problem["sample_after_rounding"];
    const auto curve = RationalPhCurve::create(golden_quaternion(problem["A"]),
                                               VectorFunction(golden_vector(sample["r_num"]),
                                                              golden_polynomial(sample["r_den"])))
                           .value();
    expect_curve(curve, sample);
    EXPECT_EQ(curve.position().value(1), data.end_point);
  }
  EXPECT_EQ(compared, 14u);
}

}  // namespace
}  // namespace hodograph
