// SPDX-License-Identifier: MIT
// Offset curves: golden control points, cusps, and the range of distances without any.
#include "hodograph/surface/offset.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/compare.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/planar_golden.hpp"

namespace hodograph {
namespace {

using test::agrees;
using test::Json;
using test::path_of;
using test::Random;

constexpr RangeGoal goal{std::numeric_limits<float>::epsilon()};
constexpr double infinity = std::numeric_limits<double>::infinity();

TEST(Offset, IsGolden) {
  const Json file = test::golden_file("planar_offset.json");
  for (const Json& entry : file["offset"].list()) {
    SCOPED_TRACE(entry["name"].string());
    const Json &input = entry["input"], &expected = entry["expected"];
    const double rel_tol = entry["rel_tol"].number();
    const auto path = path_of(test::quintic_preimage(input["w"]), test::vector2_of(input["p0"]));
    const double distance = -input["d"].number();  // theirs is positive to the right
    const auto offset = rational_offset(path.segment(0), distance);
    for (std::size_t i = 0; i < 10; ++i) {
      EXPECT_TRUE(agrees(offset.weight[i], expected["W"][i].number(), rel_tol));
      EXPECT_TRUE(agrees(offset.weighted[i].x, expected["X"][i].number(), rel_tol));
      EXPECT_TRUE(agrees(offset.weighted[i].y, expected["Y"][i].number(), rel_tol));
    }
    for (const Json& at : expected["points"].list()) {
      const auto point = test::vector2_of(at["point"]);
      for (const auto& p : {offset_position(path, at["xi"].number(), distance),
                            offset.position(at["xi"].number())}) {
        EXPECT_TRUE(agrees(p.x, point.x, rel_tol));
        EXPECT_TRUE(agrees(p.y, point.y, rel_tol));
      }
    }
  }
}

TEST(Offset, PiecesHavePositiveWeightsAndFollowTheNormal) {
  Random random("offset: pieces");
  for (int i = 0; i < 50; ++i) {
    const auto path = test::random_path<PlanarPath<2>>(random, 6, 0);
    const double distance = random.uniform(-2.0, 2.0);
    const auto pieces = rational_offset(path, distance).value();
    double xi = path.xi_begin();
    Vector2<double> end{};
    for (const auto& piece : pieces) {
      EXPECT_EQ(piece.xi_begin, xi);
      xi = piece.xi_end;
      for (const double w : piece.curve.weight.coefficients()) EXPECT_GT(w, 0.0);
      for (const double u : {0.0, 0.25, 0.5, 1.0}) {
        const double at = piece.xi_begin + u * (piece.xi_end - piece.xi_begin);
        if (u == 1.0) continue;
        // Position and normal carry some ten roundings each; ξ is rounded, too.
        EXPECT_CLOSE(piece.curve.position(u), offset_position(path, at, distance), 512,
                     1.0 + std::abs(distance) + path.arc_length());
      }
      // The preimage is continuous: the pieces meet.
      if (&piece != pieces.data()) {
        EXPECT_CLOSE(piece.curve.control_points().front(), end, 512,
                     1.0 + std::abs(distance) + path.arc_length());
      }
      end = piece.curve.control_points().back();
    }
    EXPECT_EQ(xi, path.xi_end());
  }
}

TEST(Offset, LiesToTheLeft) {
  const auto line = path_of(BernsteinPolynomial<Complex<double>, 0>({Complex<double>{1, 0}}));
  EXPECT_EQ(offset_position(line, 0.5, 2.0), (Vector2<double>{0.5, 2.0}));
  const auto offset = rational_offset(line.segment(0), 2.0);
  EXPECT_EQ(offset.control_points()[1], (Vector2<double>{1.0, 2.0}));
  EXPECT_TRUE(offset_cusps(line, 100.0).empty());
  const auto range = cusp_free_offsets(line, goal);
  EXPECT_EQ(range.left.upper(), infinity);
  EXPECT_EQ(range.right.lower(), std::numeric_limits<double>::max());
}

TEST(Offset, HasCuspsBeyondTheRangeAndNoneWithin) {
  Random random("offset: cusps");
  for (int i = 0; i < 100; ++i) {
    const auto path = test::random_path<PlanarPath<2>>(random, 3, 0);
    const auto range = cusp_free_offsets(path, goal);
    for (const double side : {1.0, -1.0}) {
      const Enclosure& limit = side > 0 ? range.left : range.right;
      if (limit.upper() == infinity) continue;  // it never turns to that side
      EXPECT_TRUE(offset_cusps(path, side * limit.lower() * (1 - goal.relative_width)).empty());
      // So little that on the segment of the largest curvature others are smaller.
      constexpr double little = 0x1.0p-20;  // more than the width of the limit
      const double beyond = side * limit.upper() * (1 + little);
      const auto cusps = offset_cusps(path, beyond);
      EXPECT_FALSE(cusps.empty());
      for (const OffsetCusp& cusp : cusps) {
        // 1 - dκ = 0 at each.
        const auto jet = path.preimage_jet<1>(cusp.xi);
        const double sigma = dot(jet[0], jet[0]);
        const double kappa = 2 * body_rate_form(jet[0], jet[1]) / (sigma * sigma);
        EXPECT_TRUE(cusp.xi_range.contains(cusp.xi));
        EXPECT_NEAR(beyond * kappa, 1.0, std::sqrt(std::numeric_limits<double>::epsilon()));
      }
    }
  }
}

TEST(Offset, OfACircleLikeArcHasItsRadius) {
  // w = 1 + i u: κ = 2/(1 + u²)² falls from 2 to 1/2.
  const auto path =
      path_of(BernsteinPolynomial<Complex<double>, 1>({Complex<double>{1, 0}, {1, 1}}));
  const auto range = cusp_free_offsets(path, goal);
  EXPECT_TRUE(range.left.contains(0.5));
  EXPECT_EQ(range.right.upper(), infinity);
  const auto cusps = offset_cusps(path, 1.0);
  ASSERT_EQ(cusps.size(), 1U);
  EXPECT_TRUE(cusps[0].xi_range.contains(std::sqrt(std::sqrt(2.0) - 1)));
  EXPECT_EQ(cusps[0].kind, RootKind::simple);
}

TEST(Offset, RefusesWhatHasNoNormal) {
  const auto cusp =
      path_of(BernsteinPolynomial<Complex<double>, 1>({Complex<double>{-0.5, -0.25}, {0.5, 0.25}}));
  EXPECT_EQ(rational_offset(cusp, 1.0).fault().code, FaultCode::zero_speed);
  EXPECT_THROW(offset_position(cusp, 0.5, 1.0), Error);
  EXPECT_EQ(rational_offset(cusp, infinity).fault().code, FaultCode::not_finite);
  EXPECT_EQ(rational_offset(cusp, std::nan("")).fault().code, FaultCode::not_finite);
  EXPECT_EQ(cusp_free_offsets(cusp, goal).left.lower(), 0.0);
}

}  // namespace
}  // namespace hodograph
