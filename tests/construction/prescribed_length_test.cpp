// SPDX-License-Identifier: MIT
// Curves of prescribed length: golden solutions of the generic, special and nearly special cases,
// conditions on random and hostile data, loops, the straight line, the batch, and refusals.
#include "hodograph/construction/prescribed_length.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/path/rotation_index.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_judge.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;
/// Roundings of the end and of the length, relative to the size of what is summed.
constexpr double end_roundings = 48.0;

/// The sine of the angle between two vectors, and whether they point the same way.
double sine_between(const Vector2<double>& a, const Vector2<double>& b) {
  const double size = std::sqrt(dot(a, a)) * std::sqrt(dot(b, b));
  return dot(a, b) > 0.0 ? std::abs(cross(a, b)) / size : 2.0;
}

void expect_conditions(const PlanarPhCurve<2>& curve, const DirectedPoint& begin,
                       const DirectedPoint& end, double length, double direction_slack = 0.0) {
  EXPECT_EQ(curve.start(), begin.position);
  const double scale = reach(curve);
  EXPECT_CLOSE(curve.end(), end.position, end_roundings, scale + largest_component(end.position));
  EXPECT_CLOSE(curve.arc_length(), length, end_roundings + 64.0, scale);
  const auto& w = curve.preimage();
  const double allowed = 16 * epsilon<double>() + direction_slack;
  EXPECT_LE(sine_between(hodograph_form(w.front(), w.front()), begin.direction), allowed);
  EXPECT_LE(sine_between(hodograph_form(w.back(), w.back()), end.direction), allowed);
  EXPECT_CLOSE(dot(w.front(), w.front()), dot(w.back(), w.back()), 16.0, dot(w.back(), w.back()));
}

void expect_golden(const Json& item) {
  const Json& in = item["input"];
  const DirectedPoint begin{golden_plane_point(in["q_s"]),
                            direction_of_angle(in["phi_s"].number())};
  const DirectedPoint end{golden_plane_point(in["q_e"]), direction_of_angle(in["phi_e"].number())};
  const double length = in["S"].number();
  const auto found = prescribed_length_solutions(begin, end, length);
  ASSERT_TRUE(found) << item["name"].string() << ": " << found.fault().sentence;
  const auto& expected = item["expected"]["solutions"].list();
  const bool tie = item["expected"]["tie"].number() != 0.0;
  ASSERT_EQ(found->size(), 2U);
  const double tolerance = item["rel_tol"].number();
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& solution = (*found)[k];
    EXPECT_NEAR(solution.rotation_index, expected[k]["R_abs"].number(),
                tolerance * expected[k]["R_abs"].number())
        << item["name"].string();
    const auto w = golden_preimage(expected[k]["w"]);
    double difference = preimage_difference(solution.curve.preimage().coefficients(), w);
    if (tie) {
      difference =
          std::min(difference, preimage_difference(solution.curve.preimage().coefficients(),
                                                   golden_preimage(expected[1 - k]["w"])));
    }
    EXPECT_LE(difference, tolerance * preimage_size(w)) << item["name"].string() << " " << k;
  }
  const auto best = prescribed_length_curve(begin, end, length);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->curve, (*found)[0].curve);
  EXPECT_EQ(best->tie != TieBreak::none, tie) << item["name"].string();
  EXPECT_NEAR(best->margin, expected[1]["R_abs"].number() - expected[0]["R_abs"].number(),
              tolerance * expected[1]["R_abs"].number());
}

TEST(PrescribedLength, FindsTheGoldenSolutions) {
  const Json golden = golden_file("planar_prescribed_length.json");
  for (const char* section : {"g1", "g1_special"}) {
    for (const Json& item : golden[section].list()) expect_golden(item);
  }
}

TEST(PrescribedLength, HasNoSpecialCaseWhereTheSignRuleIsVoid) {
  // |φs - φe| = 2 arccos(1/3): g vanishes, and with it the rule for the sign of αβ.
  const double gap = 2.0 * std::acos(1.0 / 3.0);
  Random random("directions 2 arccos(1/3) apart");
  for (int i = 0; i < 400; ++i) {
    const double off = i % 2 == 0 ? 0.0 : random.spread(-52, -8);
    const double phi = random.uniform(-0.6, 3.1), side = random.sign();
    const DirectedPoint begin{{0.0, 0.0}, direction_of_angle(side * phi)};
    const DirectedPoint end{{1.0, 0.0}, direction_of_angle(side * (phi - gap + off))};
    const double length = random.uniform(1.05, 4.0);
    const auto solutions = prescribed_length_solutions(begin, end, length);
    ASSERT_TRUE(solutions) << solutions.fault().sentence;
    ASSERT_EQ(solutions->size(), 2U);
    for (const auto& solution : *solutions) expect_conditions(solution.curve, begin, end, length);
    const auto& first = (*solutions)[0].curve.preimage().coefficients();
    const auto& second = (*solutions)[1].curve.preimage().coefficients();
    constexpr double far_above_rounding = 0x1.0p-20;  // two solutions, not one twice
    EXPECT_GT(preimage_difference(first, second), far_above_rounding);
  }
}

TEST(PrescribedLength, OfVehiclesThatArriveTogether) {
  const Json golden = golden_file("planar_prescribed_length.json");
  for (const Json& item : golden["arrival"].list()) {
    const Json& in = item["input"];
    const auto& vehicles = item["expected"]["vehicles"].list();
    for (std::size_t k = 0; k < vehicles.size(); ++k) {
      const DirectedPoint begin{golden_plane_point(in["start"][k]),
                                direction_of_angle(in["directions"][k][0].number())};
      const DirectedPoint end{golden_plane_point(in["end"][k]),
                              direction_of_angle(in["directions"][k][1].number())};
      const auto found = prescribed_length_curve(begin, end, in["S"].number());
      ASSERT_TRUE(found) << item["name"].string() << ": " << found.fault().sentence;
      const auto w = golden_preimage(vehicles[k]["w"]);
      const double tolerance = item["rel_tol"].number() * preimage_size(w);
      double difference = preimage_difference(found->curve.preimage().coefficients(), w);
      if (found->tie != TieBreak::none) {  // the reference took the mirror image
        const auto both = prescribed_length_solutions(begin, end, in["S"].number());
        ASSERT_TRUE(both);
        difference = std::min(difference,
                              preimage_difference((*both)[1].curve.preimage().coefficients(), w));
      }
      EXPECT_LE(difference, tolerance) << k;
      EXPECT_NEAR(found->rotation_index, vehicles[k]["R_abs"].number(), 4 * tolerance);
    }
  }
}

TEST(PrescribedLength, RefusesTheGoldenPlanarImpossibilities) {
  const Json golden = golden_file("planar_prescribed_length.json");
  for (const Json& item : golden["reject"].list()) {
    const Json& in = item["input"];
    const double climb = in["r_e"][2].number() - in["r_s"][2].number();
    const double length = climb / std::tan(in["theta"].number());
    if (!(length > 0.0) || !std::isfinite(length)) continue;  // a refusal of the climb
    if (in["theta"].number() >= pi / 2) continue;
    const auto found = prescribed_length_curve(
        {golden_plane_point(in["r_s"]), direction_of_angle(in["phi_s"].number())},
        {golden_plane_point(in["r_e"]), direction_of_angle(in["phi_e"].number())}, length);
    ASSERT_FALSE(found) << item["name"].string();
    EXPECT_EQ(found.fault().code, FaultCode::no_interpolant);
  }
}

PrescribedLengthProblem random_problem(Random& random) {
  PrescribedLengthProblem problem;
  const double size = random.chance(0.3) ? std::ldexp(1.0, int(random.integer(-400, 400))) : 1.0;
  const double along = random.chance(0.3) ? 0.0 : random.uniform(-pi, pi);
  const double chord = random.chance(0.05) ? 0.0 : random.uniform(0.1, 3.0);
  const double specials[] = {0.0, pi, -pi, pi / 2, 0.7};
  const double start = random_angle(random, specials[random.index(5)]);
  const double last = random.chance(0.5) ? random_angle(random, random.chance(0.5) ? start : -start)
                                         : random_angle(random, specials[random.index(5)]);
  const double excess =
      random.chance(0.5) ? random.uniform(0.0, 2.0) : std::abs(random.spread(-60, 30));
  problem.length = size * (chord + excess);
  problem.begin = {random.chance(0.5) ? Vector2<double>{} : size * random.vector2(1.0),
                   direction_of_angle(along + start)};
  problem.end = {problem.begin.position + (size * chord) * direction_of_angle(along),
                 direction_of_angle(along + last)};
  problem.step = random.chance(0.5) ? 1.0 : std::abs(random.spread(-20, 20));
  return problem;
}

TEST(PrescribedLength, MeetsRandomDataAndTheBatchGivesTheSameBits) {
  Random random("prescribed lengths");
  std::vector<PrescribedLengthProblem> problems;
  std::vector<PrescribedLength> singles;
  int refused = 0;
  for (int i = 0; i < cases(100000); ++i) {
    const PrescribedLengthProblem p = random_problem(random);
    const auto found = prescribed_length_curve(p.begin, p.end, p.length, p.step);
    const double chord = norm((1 / p.length) * (p.end.position - p.begin.position));
    if (!found) {
      ++refused;
      EXPECT_EQ(found.fault().code, FaultCode::no_interpolant);
      // Only where the length is the chord's, or below it.
      EXPECT_GE(chord, 1.0 - 4 * accuracy::join_error<double>()) << found.fault().sentence;
      continue;
    }
    EXPECT_LE(chord, 1.0 + 4 * accuracy::join_error<double>());
    // A straight line may miss the directions by as much as its length misses the chord.
    const bool straight = 1.0 - chord <= 4 * accuracy::join_error<double>();
    expect_conditions(found->curve, p.begin, p.end, p.length,
                      straight ? 4 * std::sqrt(accuracy::join_error<double>()) : 0.0);
    EXPECT_GE(found->margin, 0.0);
    EXPECT_TRUE(std::isfinite(found->rotation_index));
    problems.push_back(p);
    singles.push_back(*found);
    if (i % 20 == 0) {
      const auto all =
          prescribed_length_solutions(p.begin, p.end, p.length, p.step, LengthSolutions::all);
      ASSERT_TRUE(all);
      for (const PlanarSolution& solution : *all) {
        expect_conditions(solution.curve, p.begin, p.end, p.length,
                          straight ? 4 * std::sqrt(accuracy::join_error<double>()) : 0.0);
      }
      EXPECT_LE((*all)[0].rotation_index, found->rotation_index + accuracy_of_rotation_index);
      // One problem in lanes has the bits of plain numbers, which list the solutions.
      const auto listed = prescribed_length_solutions(p.begin, p.end, p.length, p.step);
      ASSERT_TRUE(listed);
      EXPECT_EQ((*listed)[0].curve, found->curve);
      EXPECT_EQ((*listed)[0].rotation_index, found->rotation_index);
    }
    if (::testing::Test::HasFailure()) {
      FAIL() << i << ": length " << p.length << " directions " << p.begin.direction.x << " "
             << p.begin.direction.y << " " << p.end.direction.x << " " << p.end.direction.y
             << " ends " << p.begin.position.x << " " << p.begin.position.y << " "
             << p.end.position.x << " " << p.end.position.y << " step " << p.step;
    }
  }
  EXPECT_LE(refused, 20000);
  std::vector<PlanarHermiteAnswer> answers(problems.size());
  const auto fault = prescribed_length_curves(problems, answers);
  ASSERT_FALSE(fault) << fault->sentence;
  for (std::size_t i = 0; i < problems.size(); ++i) {
    ASSERT_EQ(answers[i].preimage, singles[i].curve.preimage().coefficients()) << i;
    ASSERT_EQ(answers[i].rotation_index, singles[i].rotation_index) << i;
    ASSERT_EQ(answers[i].margin, singles[i].margin) << i;
  }
}

TEST(PrescribedLength, OfTheChordIsTheStraightLine) {
  Random random("straight lines");
  for (int i = 0; i < 5000; ++i) {
    const Vector2<double> begin = random.vector2(3), end = random.vector2(3);
    const Vector2<double> along = end - begin;
    const double chord = std::hypot(along.x, along.y);
    const double length = random.near(chord, 8);
    const auto found = prescribed_length_curve({begin, along}, {end, 2.0 * along}, length);
    ASSERT_TRUE(found) << found.fault().sentence;
    EXPECT_TRUE(found->loop_free);
    // Directions off by rounding keep their small turn.
    EXPECT_LE(found->rotation_index, 64 * std::sqrt(accuracy::join_error<double>()));
    EXPECT_CLOSE(found->curve.arc_length(), length, 96.0, length);
    EXPECT_CLOSE(found->curve.speed(0.3), chord, 1e4, chord);  // nearly uniform
    const auto longer = prescribed_length_curve({begin, along}, {end, along}, 1.25 * chord);
    ASSERT_TRUE(longer);
    EXPECT_FALSE(longer->loop_free);
  }
}

TEST(PrescribedLength, SaysWhereThereIsNoLoopFreeSolution) {
  // The published examples have no loops; the rejected solutions do.
  const DirectedPoint begin{{0, 0}, direction_of_angle(pi / 4)};
  const DirectedPoint end{{1, 0}, direction_of_angle(pi / 3)};
  const auto good = prescribed_length_curve(begin, end, 1.12);
  ASSERT_TRUE(good);
  EXPECT_TRUE(good->loop_free);
  EXPECT_FALSE(crosses_itself(good->curve));
  EXPECT_CLOSE(good->unavoidable_rotation, pi / 4 + pi / 3, 4.0, 2.0);
  const auto both = prescribed_length_solutions(begin, end, 1.12);
  ASSERT_TRUE(both);
  // Small angles and a long path: mirror images with a loop each.
  const auto bad = prescribed_length_curve({{0, 0}, direction_of_angle(0.3)},
                                           {{1, 0}, direction_of_angle(-0.3)}, 1.8);
  ASSERT_TRUE(bad);
  EXPECT_FALSE(bad->loop_free);
  EXPECT_NE(bad->tie, TieBreak::none);
  EXPECT_CLOSE(bad->margin, 0.0, 64.0, 1.0);
}

/// Whether a polygon of the curve meets itself.
bool polygon_crosses(const PlanarPhCurve<2>& curve) {
  constexpr int count = 300;
  std::vector<Vector2<double>> points;
  for (int i = 0; i <= count; ++i) points.push_back(curve.position(double(i) / count));
  const auto side = [](const auto& a, const auto& b, const auto& c) { return cross(b - a, c - a); };
  for (int i = 0; i < count; ++i) {
    for (int j = i + 2; j < count; ++j) {
      const auto &a = points[i], &b = points[i + 1], &c = points[j], &d = points[j + 1];
      if (side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0) return true;
    }
  }
  return false;
}

TEST(PrescribedLength, FindsCrossingsLikeAPolygonDoes) {
  Random random("self crossings");
  int crossing = 0, different = 0;
  for (int i = 0; i < 1500; ++i) {
    const double start = random.uniform(-pi, pi);
    const double last = random.chance(0.4) ? -start : random.uniform(-pi, pi);
    const auto both =
        prescribed_length_solutions({{0, 0}, direction_of_angle(start)},
                                    {{1, 0}, direction_of_angle(last)}, random.uniform(1.05, 3.0));
    ASSERT_TRUE(both);
    for (const PlanarSolution& solution : *both) {
      const bool found = crosses_itself(solution.curve);
      const bool expected = polygon_crosses(solution.curve);
      crossing += found;
      different += found != expected;
    }
  }
  EXPECT_GE(crossing, 300);
  EXPECT_LE(different, 15);  // loops smaller than the polygon's sides
}

TEST(PrescribedLength, DoesNotDependOnScale) {
  Random random("scaled prescribed lengths");
  for (int i = 0; i < 2000; ++i) {
    const DirectedPoint begin{random.vector2(1), random.unit_vector2()};
    const DirectedPoint end{random.vector2(1), random.unit_vector2()};
    const double length = norm(end.position - begin.position) * random.uniform(1.0001, 3.0);
    const auto found = prescribed_length_curve(begin, end, length);
    ASSERT_TRUE(found);
    for (const int exponent : {-498, 498}) {
      const double c = std::ldexp(1.0, exponent);
      const auto scaled = prescribed_length_curve({c * begin.position, begin.direction},
                                                  {c * end.position, end.direction}, c * length);
      ASSERT_TRUE(scaled) << scaled.fault().sentence;
      EXPECT_EQ(scaled->rotation_index, found->rotation_index);
      EXPECT_EQ(scaled->curve.arc_length(), c * found->curve.arc_length());
    }
  }
}

TEST(PrescribedLength, AnswersHostileNumbersWithACurveOrAFault) {
  Random random("hostile prescribed lengths");
  int found_count = 0;
  for (int i = 0; i < 30000; ++i) {
    DirectedPoint begin{random.vector2(1), random.vector2(1)};
    DirectedPoint end{random.vector2(1), random.vector2(1)};
    double length = 4.0, h = 1.0;
    for (std::int64_t k = random.integer(1, 4); k > 0; --k) {
      double* number[] = {&begin.position.x,
                          &begin.position.y,
                          &begin.direction.x,
                          &begin.direction.y,
                          &end.position.x,
                          &end.position.y,
                          &end.direction.x,
                          &end.direction.y,
                          &length,
                          &h};
      *number[random.index(10)] = random.hostile();
    }
    const auto found = prescribed_length_curve(begin, end, length, h);
    if (!found) continue;
    ++found_count;
    EXPECT_TRUE(is_finite(found->curve.end()));
    EXPECT_TRUE(std::isfinite(found->rotation_index));
    if (std::abs(std::log2(length)) < 300) {
      EXPECT_CLOSE(found->curve.arc_length(), length, end_roundings + 64.0, reach(found->curve));
      EXPECT_CLOSE(found->curve.end(), end.position, end_roundings,
                   reach(found->curve) + largest_component(end.position) +
                       largest_component(begin.position));
    }
  }
  EXPECT_GE(found_count, 8000);
}

TEST(PrescribedLength, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const DirectedPoint a{{0, 0}, {1, 1}}, b{{3, 4}, {1, 0}};
  const auto shorter = prescribed_length_curve(a, b, 4.5);
  ASSERT_FALSE(shorter);
  EXPECT_EQ(shorter.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(shorter.fault().value, 4.5);
  EXPECT_EQ(shorter.fault().bound, 5.0);
  EXPECT_EQ(prescribed_length_curve(a, b, 5.0).fault().quantity, "direction");
  EXPECT_EQ(prescribed_length_curve({{nan, 0}, {1, 0}}, b, 9).fault().code, FaultCode::not_finite);
  EXPECT_EQ(prescribed_length_curve(a, {{3, 4}, {nan, 0}}, 9).fault().index, 1U);
  EXPECT_EQ(prescribed_length_curve(a, {{3, 4}, {0, 0}}, 9).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(prescribed_length_curve(a, b, nan).fault().code, FaultCode::not_finite);
  EXPECT_EQ(prescribed_length_curve(a, b, -1.0).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(prescribed_length_curve(a, b, 9.0, 0.0).fault().quantity, "parameter_step");
  std::vector<PrescribedLengthProblem> problems{{a, b, 9.0, 1.0}, {a, b, 1.0, 1.0}};
  std::vector<PlanarHermiteAnswer> answers(2);
  const auto fault = prescribed_length_curves(problems, answers);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->index, 1U);
}

}  // namespace
}  // namespace hodograph::test
