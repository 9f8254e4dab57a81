// SPDX-License-Identifier: MIT
// Planar C¹ Hermite interpolation: golden solutions, conditions on random and hostile data, ties,
// scale, the batch, and refusals.
#include "hodograph/construction/planar_hermite.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/path/rotation_index.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_judge.hpp"

namespace hodograph::test {
namespace {

/// How far rounding may move an end: the conversion of the data, the solution and the sum of the
/// displacement are each a few roundings of the largest term.
constexpr double end_roundings = 24.0;

/// Checks end point and end derivatives; true if all hold.
void expect_interpolates(const PlanarPhCurve<2>& curve, const PlanarHermitePoint& begin,
                         const PlanarHermitePoint& end) {
  EXPECT_EQ(curve.start(), begin.position);
  const double scale = reach(curve) + largest_component(end.position);
  EXPECT_CLOSE(curve.end(), end.position, end_roundings, scale);
  const auto& w = curve.preimage();
  EXPECT_CLOSE(hodograph_form(w.front(), w.front()), begin.derivative, 8.0,
               largest_component(begin.derivative));
  EXPECT_CLOSE(hodograph_form(w.back(), w.back()), end.derivative, 8.0,
               largest_component(end.derivative));
}

TEST(PlanarHermite, FindsTheGoldenSolutionsInTheirOrder) {
  const Json golden = golden_file("planar_hermite.json");
  for (const Json& item : golden["hermite"].list()) {
    const Json& in = item["input"];
    const auto data =
        hermite_data_of_control_points(golden_plane_point(in["p0"]), golden_plane_point(in["p1"]),
                                       golden_plane_point(in["p4"]), golden_plane_point(in["p5"]));
    const auto found = planar_hermite_solutions(data[0], data[1]);
    ASSERT_TRUE(found) << item["name"].string();
    const auto& expected = item["expected"]["solutions"].list();
    const double tolerance = item["rel_tol"].number();
    const bool tie = item["expected"]["tie"].number() != 0.0;
    for (std::size_t k = 0; k < 4; ++k) {
      const PlanarSolution& solution = (*found)[k];
      const double index = expected[k]["R_abs"].number();
      // Among solutions with cusps rounding decides the index.
      if (index > 0.0 || k == 0) {
        EXPECT_NEAR(solution.rotation_index, index, tolerance * std::max(1.0, index))
            << item["name"].string();
      }
      double least = std::numeric_limits<double>::infinity(), size = 1.0;
      for (const Json& candidate : expected) {
        if (!tie && &candidate != &expected[k]) continue;
        const auto w = golden_preimage(candidate["w"]);
        size = std::max(size, preimage_size(w));
        least = std::min(least, preimage_difference(solution.curve.preimage().coefficients(), w));
      }
      // At a double root of the quadratic half of the digits are the data's rounding.
      const double allowed = tie ? std::sqrt(epsilon<double>()) * size : tolerance * size;
      EXPECT_LE(least, allowed) << item["name"].string() << " " << k;
    }
    const auto best = planar_hermite(data[0], data[1]);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->curve, (*found)[0].curve);
    EXPECT_EQ(best->tie != TieBreak::none, tie);
    EXPECT_NEAR(best->margin, expected[1]["R_abs"].number() - expected[0]["R_abs"].number(),
                tolerance * std::max(1.0, expected[1]["R_abs"].number()));
  }
}

TEST(PlanarHermite, OfAStraightLineIsTheLineWithoutACusp) {
  for (const Vector2<double> d : {Vector2<double>{1, 0}, Vector2<double>{-3, 4},
                                  Vector2<double>{0.3, -0.7}, Vector2<double>{-1, 0}}) {
    const auto found = planar_hermite({{1, 2}, d}, {{1 + d.x, 2 + d.y}, d});
    ASSERT_TRUE(found);
    EXPECT_EQ(found->tie, TieBreak::regularity);
    EXPECT_CLOSE(found->rotation_index, 0.0, 16.0, 1.0);
    for (const double u : {0.0, 0.25, 0.5, 1.0}) {
      EXPECT_CLOSE(found->curve.speed(u), norm(d), 16.0, norm(d));
    }
  }
}

TEST(PlanarHermite, BreaksTiesByTheStatedRule) {
  // A start from rest: the four solutions are two pairs.
  const auto rest = planar_hermite({{0, 0}, {0, 0}}, {{1, 1}, {1, 0}});
  ASSERT_TRUE(rest);
  EXPECT_EQ(rest->margin, 0.0);
  EXPECT_EQ(rest->tie, TieBreak::order);
  // Rest at both ends: a line.
  const auto line = planar_hermite({{0, 0}, {0, 0}}, {{1, 1}, {0, 0}});
  ASSERT_TRUE(line);
  EXPECT_EQ(line->rotation_index, 0.0);
  EXPECT_CLOSE(line->curve.arc_length(), std::sqrt(2.0), 8.0, 2.0);
  // The mirror image at the line of the ends: both turn by the same angle, one to the left.
  const auto back = planar_hermite_solutions({{0, 0}, {1, 0}}, {{-1, 0}, {1, 0}});
  ASSERT_TRUE(back);
  for (std::size_t k = 0; k + 1 < 4; ++k) {
    const PlanarSolution &a = (*back)[k], &b = (*back)[k + 1];
    if (b.rotation_index - a.rotation_index > accuracy_of_rotation_index) continue;
    EXPECT_GE(rotation_index(a.curve), rotation_index(b.curve) - accuracy_of_rotation_index);
  }
}

PlanarHermiteProblem random_problem(Random& random) {
  PlanarHermiteProblem problem;
  const double turn = random_angle(random, 0.0);
  const double start = random.uniform(-3, 3);
  const double size = random.chance(0.2) ? std::ldexp(1.0, int(random.integer(-400, 400))) : 1.0;
  const auto speed = [&] {
    return size * (random.chance(0.7) ? random.uniform(0.1, 3) : std::abs(random.spread(-60, 20)));
  };
  const double s0 = speed(), s1 = random.chance(0.3) ? s0 : speed();
  const double chord = random.chance(0.5) ? 0.0 : random.uniform(-3, 3);
  const double far = size * (random.chance(0.8) ? 1.0 : std::abs(random.spread(-60, 30)));
  problem.step = random.chance(0.5) ? 1.0 : std::abs(random.spread(-20, 20));
  problem.begin.position = random.chance(0.5) ? Vector2<double>{} : size * random.vector2(2.0);
  problem.end.position =
      problem.begin.position +
      (problem.step * far) * Vector2<double>{std::cos(chord + start), std::sin(chord + start)};
  problem.begin.derivative = s0 * Vector2<double>{std::cos(start), std::sin(start)};
  const double last = start + (random.chance(0.3) ? 3.14159265358979 : 0.0) + turn;
  problem.end.derivative = s1 * Vector2<double>{std::cos(last), std::sin(last)};
  return problem;
}

TEST(PlanarHermite, MeetsRandomDataAndTheBatchGivesTheSameBits) {
  Random random("planar hermite data");
  std::vector<PlanarHermiteProblem> problems;
  for (int i = 0; i < cases(100000); ++i) problems.push_back(random_problem(random));
  std::vector<PlanarHermiteAnswer> answers(problems.size());
  const auto fault = planar_hermite(problems, answers);
  ASSERT_FALSE(fault) << fault->sentence;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    const PlanarHermiteProblem& p = problems[i];
    const auto found = planar_hermite(p.begin, p.end, p.step);
    ASSERT_TRUE(found) << found.fault().sentence;
    expect_interpolates(found->curve, p.begin, p.end);
    EXPECT_EQ(found->curve.preimage().coefficients(), answers[i].preimage) << i;
    EXPECT_EQ(found->rotation_index, answers[i].rotation_index) << i;
    EXPECT_EQ(found->margin, answers[i].margin) << i;
    EXPECT_GE(found->margin, 0.0);
    if (i % 20 == 0) {
      const auto all = planar_hermite_solutions(p.begin, p.end, p.step);
      ASSERT_TRUE(all);
      EXPECT_EQ((*all)[0].curve, found->curve);
      for (const PlanarSolution& solution : *all) {
        expect_interpolates(solution.curve, p.begin, p.end);
        EXPECT_GE(solution.rotation_index, found->rotation_index - accuracy_of_rotation_index);
      }
    }
    if (::testing::Test::HasFailure()) {
      ADD_FAILURE() << "problem " << i << ": " << p.begin.position.x << " " << p.begin.position.y
                    << " " << p.begin.derivative.x << " " << p.begin.derivative.y << " "
                    << p.end.position.x << " " << p.end.position.y << " " << p.end.derivative.x
                    << " " << p.end.derivative.y << " " << p.step;
      break;
    }
  }
}

TEST(PlanarHermite, ReproducesAQuinticWithoutLoops) {
  Random random("quintics from their own data");
  for (int i = 0; i < 2000; ++i) {
    std::array<Complex<double>, 3> w;
    for (auto& c : w) c = Complex<double>{1.0, 0.0} + random.complex(0.4);
    const PlanarPhCurve<2> curve({}, BernsteinPolynomial<Complex<double>, 2>(w), 1.0);
    const auto found = planar_hermite({curve.start(), hodograph_form(w[0], w[0])},
                                      {curve.end(), hodograph_form(w[2], w[2])});
    ASSERT_TRUE(found);
    const auto& v = found->curve.preimage().coefficients();
    EXPECT_LE(preimage_difference(v, w), 256 * epsilon<double>());
  }
}

TEST(PlanarHermite, DoesNotDependOnScale) {
  Random random("scaled planar hermite");
  for (int i = 0; i < 2000; ++i) {
    PlanarHermitePoint begin{random.vector2(1), random.vector2(1)};
    PlanarHermitePoint end{random.vector2(1), random.vector2(1)};
    const auto found = planar_hermite(begin, end);
    ASSERT_TRUE(found);
    for (const int exponent : {-498, 498}) {
      const double c = std::ldexp(1.0, exponent);
      const auto scaled = planar_hermite({c * begin.position, c * begin.derivative},
                                         {c * end.position, c * end.derivative});
      ASSERT_TRUE(scaled) << scaled.fault().sentence;
      EXPECT_EQ(scaled->rotation_index, found->rotation_index);
      const double root = std::ldexp(1.0, exponent / 2);
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(scaled->curve.preimage()[k], root * found->curve.preimage()[k]);
      }
    }
  }
}

TEST(PlanarHermite, AnswersHostileNumbersWithACurveOrAFault) {
  Random random("hostile planar hermite");
  for (int i = 0; i < 20000; ++i) {
    PlanarHermitePoint begin{random.vector2(1), random.vector2(1)};
    PlanarHermitePoint end{random.vector2(1), random.vector2(1)};
    double h = 1.0;
    for (std::int64_t k = random.integer(1, 4); k > 0; --k) {
      double* number[] = {&begin.position.x,   &begin.position.y, &begin.derivative.x,
                          &begin.derivative.y, &end.position.x,   &end.position.y,
                          &end.derivative.x,   &end.derivative.y, &h};
      *number[random.index(9)] = random.hostile();
    }
    const auto found = planar_hermite(begin, end, h);
    if (!found) continue;
    EXPECT_TRUE(is_finite(found->curve.end()));
    EXPECT_TRUE(std::isfinite(found->rotation_index));
    const double largest = std::max({largest_component(begin.derivative),
                                     largest_component(end.derivative), reach(found->curve)});
    // Where squares of the smaller numbers leave double's range, only the larger ones are met.
    if (std::abs(std::log2(largest)) < 300) {
      EXPECT_CLOSE(found->curve.end(), end.position, end_roundings,
                   reach(found->curve) + largest_component(end.position) +
                       largest_component(begin.position));
    }
  }
}

TEST(PlanarHermite, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  const PlanarHermitePoint a{{0, 0}, {1, 0}}, b{{1, 0}, {1, 1}};
  EXPECT_EQ(planar_hermite({{nan, 0}, {1, 0}}, b).fault().code, FaultCode::not_finite);
  EXPECT_EQ(planar_hermite({{nan, 0}, {1, 0}}, b).fault().index, 0U);
  EXPECT_EQ(planar_hermite(a, {{0, 0}, {1, infinity}}).fault().code, FaultCode::not_finite);
  EXPECT_EQ(planar_hermite(a, {{0, 0}, {1, infinity}}).fault().index, 1U);
  for (const double h : {0.0, -1.0, nan, infinity}) {
    EXPECT_EQ(planar_hermite(a, b, h).fault().code, FaultCode::outside_domain);
  }
  EXPECT_EQ(planar_hermite({{1, 2}, {0, 0}}, {{1, 2}, {0, 0}}).fault().code, FaultCode::zero_speed);
  EXPECT_EQ(planar_hermite({{-1e308, 0}, {0, 1}}, {{1e308, 0}, {0, 1}}).fault().code,
            FaultCode::no_interpolant);
  const double tiny = std::numeric_limits<double>::denorm_min();  // the mean velocity overflows
  EXPECT_EQ(planar_hermite(a, b, tiny).fault().code, FaultCode::no_interpolant);
  std::vector<PlanarHermiteProblem> problems{{a, b, 1.0}, {a, {{nan, 0}, {1, 0}}, 1.0}};
  std::vector<PlanarHermiteAnswer> answers(2);
  const auto fault = planar_hermite(problems, answers);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->index, 1U);
}

TEST(PlanarHermitePath, IsContinuousWithItsPreimage) {
  Random random("planar hermite path");
  std::vector<double> knots{0.0};
  std::vector<PlanarHermitePoint> points;
  for (int k = 0; k <= 40; ++k) {
    const double t = 0.3 * k;
    points.push_back({{std::cos(t), std::sin(2 * t)}, {-std::sin(t), 2 * std::cos(2 * t)}});
    if (k > 0) knots.push_back(knots.back() + 0.3);
  }
  const auto path = planar_hermite_path(knots, points);
  ASSERT_TRUE(path) << path.fault().sentence;
  for (std::size_t k = 0; k + 1 < path->segment_count(); ++k) {
    EXPECT_CLOSE(path->segment(k).preimage().back(), path->segment(k + 1).preimage().front(), 16.0,
                 2.0);
    EXPECT_CLOSE(path->segment(k).end(), points[k + 1].position, 32.0, 1.0);
  }
  EXPECT_EQ(planar_hermite_path({0.0}, std::span(points).first(1)).fault().code,
            FaultCode::too_few);
  EXPECT_EQ(planar_hermite_path({0.0, 1.0}, points).fault().code, FaultCode::mismatched_size);
  EXPECT_EQ(planar_hermite_path({0.0, 0.0}, std::span(points).first(2)).fault().code,
            FaultCode::not_increasing);
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(planar_hermite_path({0.0, infinity}, std::span(points).first(2)).fault().code,
            FaultCode::not_finite);
  const double most = std::numeric_limits<double>::max();
  EXPECT_EQ(planar_hermite_path({-most, most}, std::span(points).first(2)).fault().code,
            FaultCode::not_finite);
  points[1].position.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(planar_hermite_path(knots, points).fault().index, 1U);
}

}  // namespace
}  // namespace hodograph::test
