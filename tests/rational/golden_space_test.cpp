// SPDX-License-Identifier: MIT
// Every space of tests/golden/rational.json, equal as rationals: the paper's six examples and 14
// further cases. See the member `conventions` of the file.
#include <gtest/gtest.h>

#include <string>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

const Json& golden() {
  static const Json file = golden_file("rational.json");
  return file;
}

std::string golden_name(CurveKind kind) {
  return kind == CurveKind::constant ? "trivial" : std::string(name_of(kind));
}

TEST(GoldenSpaces, Reductions) {
  for (const Json& c : golden()["cases"].list()) {
    SCOPED_TRACE(c["name"].string());
    const auto a = golden_quaternion(c["A"]);
    const Reduction found = reduction(a).value();
    EXPECT_EQ(found.re, golden_polynomial(c["R_right_factor"][0]));
    EXPECT_EQ(found.im, golden_polynomial(c["R_right_factor"][1]));
    EXPECT_EQ(found.reduced, golden_quaternion(c["A_reduced"]));
    EXPECT_EQ(indicatrix(found.reduced), golden_vector(c["F"]));
    EXPECT_EQ(norm_polynomial(found.reduced), golden_polynomial(c["norm"]));
  }
}

TEST(GoldenSpaces, DimensionsOfEveryDegree) {
  for (const Json& c : golden()["cases"].list()) {
    SCOPED_TRACE(c["name"].string());
    const auto a = golden_quaternion(c["A"]);
    const auto alpha = golden_polynomial(c["alpha"]);
    const Json& dimensions = c["dims_by_degB"];
    for (std::size_t d = 0; d < dimensions.size(); ++d) {
      EXPECT_EQ(static_cast<double>(solve(a, alpha, d).value().dimension()), dimensions[d].number())
          << d;
    }
  }
}

TEST(GoldenSpaces, CanonicalBasesAndParts) {
  std::size_t compared = 0;
  for (const Json& c : golden()["cases"].list()) {
    const auto a = golden_quaternion(c["A"]);
    const auto alpha = golden_polynomial(c["alpha"]);
    for (std::size_t d = 0; d < 64; ++d) {
      if (!c["solutions"].has(std::to_string(d))) continue;
      SCOPED_TRACE(c["name"].string() + ", deg B <= " + std::to_string(d));
      const Json& expected = c["solutions"][std::to_string(d)];
      const SolutionSpace space = solve(a, alpha, d).value();
      const auto basis = space.canonical_basis();
      ASSERT_EQ(basis.size(), expected["basis"].size());
      for (std::size_t i = 0; i < basis.size(); ++i) {
        EXPECT_EQ(basis[i], golden_vector(expected["basis"][i]));
        EXPECT_EQ(golden_name(kind_of(basis[i], alpha)), expected["class"][i].string());
        EXPECT_EQ(mu_of(basis[i], alpha, space.indicatrix()), golden_polynomial(expected["mu"][i]));
        ++compared;
      }
      EXPECT_EQ(space.lambda_numerators(), golden_polynomials(expected["lambda_numerators_h"]));
      EXPECT_EQ(space.rational_length_numerators(),
                golden_polynomials(expected["arc_length_rational_h"]));
      EXPECT_EQ(static_cast<double>(space.constant_dimension() + space.polynomial_dimension()),
                expected["dim_polynomial_subspace"].number());
    }
  }
  EXPECT_GT(compared, 200u);
}

}  // namespace
}  // namespace hodograph
