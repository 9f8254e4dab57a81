// SPDX-License-Identifier: MIT
// Constant climb: golden solutions climbing, descending and about any axis, conditions on random
// and hostile data, constant inclination, level flight, the batch, plans lifted, and refusals.
#include "hodograph/construction/climb.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "hodograph/construction/lift.hpp"
#include "hodograph/path/helix.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/planar_judge.hpp"

namespace hodograph::test {
namespace {

constexpr double pi = std::numbers::pi;

/// From r' = A k A* to r' = A i A*.
Quaternion<double> converted(const Json& json) {
  const double root = std::sqrt(0.5);
  return json.quaternion() * Quaternion<double>{root, 0.0, -root, 0.0};
}

/// The largest displacement coefficient and |A_i|² h: what rounding is relative to.
double reach(const SpatialPhCurve<2>& curve) {
  double size = 0.0;
  for (const auto& c : curve.integral().coefficients()) {
    size = std::max({size, largest_component(c.displacement), std::abs(c.arc_length)});
  }
  for (const auto& a : curve.preimage().coefficients()) {
    size = std::max(size, curve.parameter_step() * dot(a, a));
  }
  return size;
}

double preimage_difference(const BernsteinPolynomial<Quaternion<double>, 2>& a,
                           const Json& golden) {
  double same = 0.0, opposite = 0.0, size = 0.0;
  for (std::size_t i = 0; i <= 2; ++i) {
    const Quaternion<double> expected = converted(golden[i]);
    same = std::max(same, largest_component(a[i] - expected));
    opposite = std::max(opposite, largest_component(a[i] + expected));
    size = std::max(size, largest_component(expected));
  }
  return std::min(same, opposite) / size;
}

void expect_control_points(const SpatialPhCurve<2>& curve, const Json& golden, double tolerance) {
  const auto displacement = curve.displacement();
  for (std::size_t i = 0; i <= 5; ++i) {
    EXPECT_LE(largest_component(curve.start() + displacement[i] - golden[i].vector()),
              tolerance * std::max(1.0, reach(curve)))
        << i;
  }
}

HeadedPoint golden_end(const Json& point, const Json& heading) {
  return {point.vector(), direction_of_angle(heading.number())};
}

TEST(Climb, FindsTheGoldenSolutions) {
  const Json golden = golden_file("climb.json");
  for (const Json& item : golden["helical"].list()) {
    const Json& in = item["input"];
    const HeadedPoint begin = golden_end(in["r_s"], in["phi_s"]);
    const HeadedPoint end = golden_end(in["r_e"], in["phi_e"]);
    const double theta = in["theta"].number(), tolerance = item["rel_tol"].number();
    const auto found = climb_solutions(begin, end, theta);
    ASSERT_TRUE(found) << item["name"].string() << ": " << found.fault().sentence;
    const auto& expected = item["expected"]["solutions"].list();
    ASSERT_EQ(found->size(), expected.size());
    const bool tie =
        std::abs(expected[0]["R_abs"].number() - expected[1]["R_abs"].number()) <= tolerance;
    for (std::size_t k = 0; k < 2; ++k) {
      const SpatialPhCurve<2>& curve = (*found)[k].curve;
      const Json* match = &expected[k];
      if (tie && preimage_difference(curve.preimage(), (*match)["quaternion"]) > tolerance) {
        match = &expected[1 - k];
      }
      const double size = reach(curve);
      EXPECT_LE(preimage_difference(curve.preimage(), (*match)["quaternion"]), tolerance)
          << item["name"].string() << " " << k;
      EXPECT_NEAR((*found)[k].rotation_index, (*match)["R_abs"].number(), 4 * tolerance);
      EXPECT_NEAR(curve.arc_length(), (*match)["length"].number(), tolerance * size);
      expect_control_points(curve, (*match)["control_points"], tolerance);
      const auto speed = curve.speed_polynomial();
      for (std::size_t i = 0; i <= 4; ++i) {
        EXPECT_NEAR(speed[i], (*match)["sigma"][i].number(), tolerance * size);
      }
      const auto path = SpatialPath<2>::create({0.0, 1.0}, {curve}, false).value();
      for (const Json& sample : (*match)["samples"].list()) {
        const auto r = path.position_derivatives<3>(sample["xi"].number());
        const Vector3<double> binormal = cross(r[1], r[2]);
        const double sigma = norm(r[1]), area = norm(binormal);
        EXPECT_LE(largest_component(r[0] - sample["point"].vector()), tolerance * size);
        // Rounding of r' × r'' is relative to |A|⁴.
        const double noise = tolerance * size * size / (sigma * sigma * sigma);
        EXPECT_NEAR(area / (sigma * sigma * sigma), sample["curvature"].number(), noise);
        const double torsion = sample["torsion"].number();
        constexpr double straight = 0x1.0p-8;  // where the curve hardly bends, torsion is 0/0
        if (std::abs(torsion) > straight) {
          EXPECT_NEAR(dot(binormal, r[3]) / (area * area), torsion,
                      tolerance * std::pow(size / sigma, 3) * (1.0 + std::abs(torsion)));
        }
      }
    }
    const auto best = climb_curve(begin, end, theta);
    ASSERT_TRUE(best);
    EXPECT_EQ(best->curve, (*found)[0].curve);
    EXPECT_NEAR(best->ground_length, item["expected"]["S"].number(),
                tolerance * best->ground_length);
    EXPECT_CLOSE(best->climb_angle, theta, 4.0, 1.0);
  }
}

TEST(Climb, HasTheNumbersThatThePaperPrints) {
  // Figure 1, left, with six printed digits; A = (a + b k)(c + d j).
  constexpr double digits = 0.5e-6;  // not a tolerance: half of the last printed digit
  const auto left = climb_curve({{0.25, 0.25, 0.25}, direction_of_angle(pi / 4)},
                                {{1.25, 0.25, 0.25 + 1.12}, direction_of_angle(pi / 3)}, pi / 4)
                        .value();
  const auto plan = helical_decomposition(left.curve, {0.0, 0.0, 1.0}).value();
  const double sign = plan.plan[0].re < 0.0 ? -1.0 : 1.0;
  const double printed[3][2] = {{1.119619, 0.463761}, {0.918068, -1.084742}, {1.049507, 0.605933}};
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(sign * plan.plan[i].re, printed[i][0], digits);
    EXPECT_NEAR(sign * plan.plan[i].im, printed[i][1], digits);
  }
  EXPECT_NEAR(left.rotation_index, 2.0 * 1.454364, 2.0 * digits);  // the paper prints half of it
  EXPECT_NEAR(left.rotation_index + left.margin, 2.0 * 5.360182, 2.0 * digits);
  // Figure 2: the lengths over ground.
  constexpr double four_digits = 0.5e-4;  // not a tolerance: half of the last printed digit
  const double lengths[4] = {1.8909, 1.6517, 1.4506, 1.2779};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto one = climb_curve({{0.5, 0.5, 0.5}, direction_of_angle(-pi / 2)},
                                 {{1.5, 0.5, 1.7}, direction_of_angle(pi / 3)},
                                 (0.18 + 0.02 * static_cast<double>(i)) * pi)
                         .value();
    EXPECT_NEAR(one.ground_length, lengths[i], four_digits);
  }
}

TEST(Climb, AboutTheGoldenAxes) {
  const Json golden = golden_file("climb.json");
  for (const Json& item : golden["axis"].list()) {
    const Json& in = item["input"];
    const Vector3<double> axis = in["axis"].vector();
    const DirectedPoint3 begin{in["r_s"].vector(), in["d_s"].vector()};
    const DirectedPoint3 end{in["r_e"].vector(), in["d_e"].vector()};
    const auto found = helical_solutions(axis, begin, end);
    ASSERT_TRUE(found) << item["name"].string() << ": " << found.fault().sentence;
    const auto& expected = item["expected"]["solutions"].list();
    ASSERT_EQ(found->size(), expected.size());
    const double tolerance = item["rel_tol"].number();
    for (std::size_t k = 0; k < 2; ++k) {
      const auto& curve = (*found)[k].curve;
      EXPECT_LE(preimage_difference(curve.preimage(), expected[k]["quaternion"]), tolerance)
          << item["name"].string() << " " << k;
      EXPECT_NEAR((*found)[k].rotation_index, expected[k]["R_abs"].number(), 64 * tolerance);
      expect_control_points(curve, expected[k]["control_points"], tolerance);
    }
    const auto best = helical_curve(axis, begin, end).value();
    EXPECT_NEAR(best.ground_length, item["expected"]["S"].number(), 4 * tolerance);
    EXPECT_NEAR(best.climb_angle, item["expected"]["theta"].number(), tolerance);
  }
}

TEST(Climb, RefusesTheGoldenImpossibilities) {
  const Json golden = golden_file("climb.json");
  for (const Json& item : golden["reject"].list()) {
    const Json& in = item["input"];
    const auto found = climb_curve(golden_end(in["r_s"], in["phi_s"]),
                                   golden_end(in["r_e"], in["phi_e"]), in["theta"].number());
    EXPECT_FALSE(found) << item["name"].string();
  }
}

ClimbProblem random_problem(Random& random) {
  ClimbProblem problem;
  const double size = random.chance(0.3) ? std::ldexp(1.0, int(random.integer(-400, 400))) : 1.0;
  const double along = random.uniform(-pi, pi);
  const double chord = random.chance(0.05) ? 0.0 : random.uniform(0.1, 3.0);
  const double specials[] = {0.0, pi, -pi, pi / 2, 0.7};
  const double first = random_angle(random, specials[random.index(5)]);
  const double last = random.chance(0.5) ? random_angle(random, random.chance(0.5) ? first : -first)
                                         : random_angle(random, specials[random.index(5)]);
  const double length =
      chord + (random.chance(0.5) ? random.uniform(0.0, 2.0) : std::abs(random.spread(-60, 10)));
  problem.climb_angle = random.sign() * (random.chance(0.8) ? random.uniform(0.01, 1.5)
                                                            : std::abs(random.spread(-60, 0)));
  const Vector2<double> at = random.chance(0.5) ? Vector2<double>{} : random.vector2(1.0);
  const Vector2<double> way = chord * direction_of_angle(along);
  const double z = random.chance(0.5) ? 0.0 : random.uniform(-1.0, 1.0);
  const double top = z + length * std::tan(problem.climb_angle);
  problem.begin = {{size * at.x, size * at.y, size * z}, direction_of_angle(along + first)};
  problem.end = {{size * (at.x + way.x), size * (at.y + way.y), size * top},
                 direction_of_angle(along + last)};
  problem.step = random.chance(0.5) ? 1.0 : std::abs(random.spread(-20, 20));
  return problem;
}

TEST(Climb, MeetsRandomDataAtAConstantAngleAndTheBatchGivesTheSameBits) {
  Random random("climbs");
  std::vector<ClimbProblem> problems;
  std::vector<ClimbCurve> singles;
  int refused = 0;
  while (problems.size() < 4000) {
    const ClimbProblem p = random_problem(random);
    const auto found = climb_curve(p.begin, p.end, p.climb_angle, p.step);
    if (!found) {
      ++refused;  // lost in rounding: a length within rounding of the distance, tiny or huge
      EXPECT_EQ(found.fault().code, FaultCode::no_interpolant) << found.fault().sentence;
      ASSERT_LT(refused, 2000);
      continue;
    }
    problems.push_back(p);
    singles.push_back(*found);
    const auto& curve = found->curve;
    const double size = reach(curve);
    EXPECT_EQ(curve.start(), p.begin.position);
    EXPECT_CLOSE(curve.end(), p.end.position, 192.0,
                 size + largest_component(p.end.position) + largest_component(p.begin.position));
    const double rise = p.end.position.z - p.begin.position.z;
    const double length = rise / std::sin(p.climb_angle);
    EXPECT_CLOSE(curve.arc_length(), length, 192.0, size + std::abs(length));
    // Headings at the ends.
    const auto hodograph = curve.hodograph();
    for (const auto& [way, heading] : {std::pair{hodograph.front(), p.begin.heading},
                                       std::pair{hodograph.back(), p.end.heading}}) {
      const Vector2<double> seen{way.x, way.y};
      EXPECT_GT(dot(seen, heading), 0.0);
      const double sine = std::abs(cross(seen, heading)) / (norm(seen) * norm(heading));
      // A straight line answers for directions that are off it by rounding of the length.
      constexpr double slack = 0x1.0p-20;
      const bool straight = found->rotation_index < slack;
      // The rounding of a steep climb's direction counts more in its small level part.
      const double steep = 1.0 / std::cos(p.climb_angle);
      EXPECT_LE(sine, 32.0 * steep * epsilon<double>() + (straight ? slack : 0.0));
    }
    // a·r' = σ sin θ: every coefficient.
    const auto speed = curve.speed_polynomial();
    double most = 0.0;
    for (const auto& a : curve.preimage().coefficients()) most = std::max(most, dot(a, a));
    const double sine = std::sin(found->climb_angle);
    for (std::size_t i = 0; i <= 4; ++i) {
      EXPECT_CLOSE(hodograph[i].z, sine * speed[i], 16.0, most);
    }
    EXPECT_CLOSE(found->climb_angle, p.climb_angle, 256.0, p.climb_angle);
  }
  std::vector<ClimbAnswer> answers(problems.size());
  ASSERT_FALSE(climb_curves(problems, answers));
  for (std::size_t i = 0; i < problems.size(); ++i) {
    EXPECT_EQ(singles[i].curve.preimage(),
              (BernsteinPolynomial<Quaternion<double>, 2>(answers[i].preimage)))
        << i;
    EXPECT_EQ(singles[i].rotation_index, answers[i].rotation_index);
    EXPECT_EQ(singles[i].ground_length, answers[i].ground_length);
  }
}

TEST(Climb, AboutRandomAxesIsTheTurnedVerticalOne) {
  Random random("climbs about axes");
  for (int i = 0; i < 500; ++i) {
    ClimbProblem p = random_problem(random);
    if (random.chance(0.2)) p.end.position.x = p.begin.position.x;
    const auto upright = climb_curve(p.begin, p.end, p.climb_angle);
    if (!upright) continue;
    Vector3<double> axis = random.unit_vector3();
    if (i % 4 == 0) axis = {0.0, 0.0, -1.0};
    if (i % 4 == 1) axis = {random.spread(-60, -10), random.spread(-60, -10), -1.0};
    const Quaternion<double> back = conjugate(turn_upright(axis));
    const double c = std::cos(p.climb_angle), s = std::sin(p.climb_angle);
    const auto end_of = [&](const HeadedPoint& e) {
      return DirectedPoint3{sandwich(back, e.position),
                            sandwich(back, Vector3<double>{c * e.heading.x, c * e.heading.y, s})};
    };
    const auto turned = helical_curve(axis, end_of(p.begin), end_of(p.end));
    if (!turned) continue;  // nearly level: rounding decides
    const HelixFit fit =
        recognised_helix(SpatialPath<2>::create({0.0, 1.0}, {turned->curve}, false).value());
    EXPECT_TRUE(fit.is_helix());
    const auto plan = helical_decomposition(turned->curve, axis);
    ASSERT_TRUE(plan) << plan.fault().sentence;
    EXPECT_CLOSE(plan->sine, s, 256.0, 1.0);
    EXPECT_CLOSE(turned->curve.end(), end_of(p.end).position, 512.0,
                 reach(turned->curve) + largest_component(p.begin.position) +
                     largest_component(p.end.position));
  }
}

TEST(Climb, AllFourSolutionsMeetTheData) {
  const HeadedPoint begin{{0.0, 0.0, 0.0}, direction_of_angle(2.0)};
  const HeadedPoint end{{1.0, 0.3, 0.5}, direction_of_angle(-2.5)};
  const auto four = climb_solutions(begin, end, 0.2, 2.0, LengthSolutions::all).value();
  ASSERT_EQ(four.size(), 4U);
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_CLOSE(four[k].curve.end(), end.position, 64.0, reach(four[k].curve));
    EXPECT_LE(four[k == 0 ? 0 : k - 1].rotation_index, four[k].rotation_index);
  }
  const auto best = climb_curve(begin, end, 0.2, 2.0, LengthSolutions::all).value();
  EXPECT_EQ(best.curve, four[0].curve);
}

TEST(Climb, LevelFlightAndAnyLengthOverGround) {
  const HeadedPoint begin{{0.0, 0.0, 2.0}, {1.0, 1.0}};
  HeadedPoint end{{3.0, 0.0, 2.0}, {1.0, -1.0}};
  const auto level = climb_curve_of_ground_length(begin, end, 3.5).value();
  EXPECT_EQ(level.climb_angle, 0.0);
  for (const auto& c : level.curve.displacement().coefficients()) EXPECT_EQ(c.z, 0.0);
  EXPECT_CLOSE(level.curve.arc_length(), 3.5, 16.0, 3.5);
  end.position.z = -1.5;
  const auto down = climb_curve_of_ground_length(begin, end, 3.5).value();
  EXPECT_CLOSE(down.climb_angle, -pi / 4, 2.0, 1.0);
  EXPECT_CLOSE(down.curve.end(), end.position, 32.0, reach(down.curve));
}

TEST(Climb, LiftsWholePlans) {
  const auto first =
      prescribed_length_curve({{0.0, 0.0}, {1.0, 0.0}}, {{2.0, 1.0}, {0.0, 1.0}}, 2.5)
          .value()
          .curve;
  const auto second =
      prescribed_length_curve({first.end(), {0.0, 1.0}}, {{1.0, 4.0}, {-1.0, 0.0}}, 3.5)
          .value()
          .curve;
  const auto plan = PlanarPath<2>::create({0.0, 1.0, 2.0}, {first, second}, false).value();
  const auto path = lifted(plan, 10.0, 0.5).value();
  EXPECT_CLOSE(path.position(2.0).z, 10.0 + 0.5 * plan.arc_length(), 16.0, 13.0);
  EXPECT_CLOSE(path.arc_length(), std::hypot(1.0, 0.5) * plan.arc_length(), 16.0, 6.0);
  EXPECT_TRUE(recognised_helix(path).is_helix());
  const double slopes[] = {0.5, -0.25};
  const HelixFit fit = recognised_helix(lifted(plan, 10.0, slopes).value());
  ASSERT_EQ(fit.stretches.size(), 2U);
  EXPECT_CLOSE(fit.stretches[1].sine, -0.25 / std::hypot(1.0, 0.25), 8.0, 1.0);
  const auto wrong = lifted(plan, 0.0, std::span(slopes).first(1));
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.fault().sentence, "2 segments need as many slopes; got 1");
}

TEST(Climb, SaysWhatWouldBeFeasible) {
  const HeadedPoint begin{{0.0, 0.0, 0.0}, {1.0, 0.2}}, end{{3.0, 4.0, 1.0}, {1.0, 0.0}};
  const auto steep = climb_curve(begin, end, 0.9);
  ASSERT_FALSE(steep);
  EXPECT_EQ(steep.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(steep.fault().quantity, "climb");
  // The headings are off the straight line: the climb named is a little more than that line's.
  EXPECT_GT(*steep.fault().bound, 5.0 * std::tan(0.9));
  constexpr double little_more = 1.0 + 0x1.0p-19;  // twice what is tried first
  EXPECT_LE(*steep.fault().bound, 5.0 * std::tan(0.9) * little_more);
  EXPECT_EQ(steep.fault().sentence.substr(0, 42), "climb angle 0.9 rad needs more than 6.3007");
  EXPECT_NE(steep.fault().sentence.find("got 1"), std::string::npos);
  HeadedPoint higher = end;
  higher.position.z = *steep.fault().bound;
  EXPECT_TRUE(climb_curve(begin, higher, 0.9));
  // Headings along the line: the line itself, from an altitude that rounds the climb, too.
  for (const double altitude : {0.0, 1000.0 / 3.0, -0x1.0p+30 / 3.0}) {
    const HeadedPoint low{{0.0, 0.0, altitude}, {3.0, 4.0}};
    const auto along = climb_curve(low, HeadedPoint{{3.0, 4.0, altitude + 1.0}, {3.0, 4.0}}, 0.9);
    ASSERT_FALSE(along);
    EXPECT_NE(along.fault().sentence.find(altitude == 0.0 ? "needs at least 6.3007" : "needs"),
              std::string::npos);
    EXPECT_TRUE(climb_curve(
        low, HeadedPoint{{3.0, 4.0, altitude + *along.fault().bound}, {3.0, 4.0}}, 0.9));
  }

  const struct {
    double angle, altitude;
    FaultCode code;
    const char* sentence;
  } cases[] = {
      {-0.3, 1.0, FaultCode::no_interpolant,
       "descent angle -0.3 rad needs an end below the start; its altitude changes by 1"},
      {0.3, -1.0, FaultCode::no_interpolant,
       "climb angle 0.3 rad needs an end above the start; its altitude changes by -1"},
      {0.3, 0.0, FaultCode::no_interpolant,
       "climb angle 0.3 rad needs an end above the start; its altitude changes by 0"},
      {0.0, 1.0, FaultCode::outside_domain,
       "a climb angle of 0 is level flight, which leaves the length open; give the length over "
       "ground instead"},
      {2.0, 1.0, FaultCode::outside_domain,
       "the climb angle must lie between -pi/2 and pi/2, in radians; got 2"},
      {std::nan(""), 1.0, FaultCode::not_finite, "the climb angle is not finite"},
      {0.3, std::numeric_limits<double>::infinity(), FaultCode::not_finite,
       "the altitude of point 1 is not finite"},
  };
  for (const auto& c : cases) {
    const HeadedPoint last{{3.0, 4.0, c.altitude}, {1.0, 0.0}};
    const auto found = climb_curve(begin, last, c.angle);
    ASSERT_FALSE(found);
    EXPECT_EQ(found.fault().code, c.code);
    EXPECT_EQ(found.fault().sentence, c.sentence);
  }
  // S = |Δq| = 5, to rounding.
  const HeadedPoint far{{3.0, 4.0, 2.5}, {3.0, 4.0}};
  const double chord_angle = std::atan(0.5) * (1.0 + 4.0 * epsilon<double>());
  const auto straight = climb_curve({{0.0, 0.0, 0.0}, {1.0, 0.1}}, far, chord_angle);
  ASSERT_FALSE(straight);
  EXPECT_EQ(straight.fault().quantity, "climb");
  EXPECT_NE(straight.fault().sentence.find("It needs more climb (2.50000"), std::string::npos);
  EXPECT_TRUE(climb_curve({{0.0, 0.0, 0.0}, {1.0, 0.1}},
                          {{3.0, 4.0, *straight.fault().bound}, far.heading}, chord_angle));
  EXPECT_TRUE(climb_curve({{0.0, 0.0, 0.0}, {3.0, 4.0}}, far, chord_angle));
  const auto unequal = helical_curve({0.0, 0.0, 1.0}, {{0.0, 0.0, 0.0}, {1.0, 0.0, 0.5}},
                                     {{1.0, 1.0, 1.0}, {1.0, 0.0, 0.6}});
  ASSERT_FALSE(unequal);
  EXPECT_EQ(unequal.fault().sentence.substr(0, 40), "the directions climb along the axis at 0");
  const auto along = helical_curve({0.0, 0.0, 1.0}, {{0.0, 0.0, 0.0}, {0.0, 0.0, 0.5}},
                                   {{1.0, 1.0, 1.0}, {0.0, 0.0, 0.6}});
  ASSERT_FALSE(along);
  EXPECT_EQ(along.fault().index, 0U);

  std::vector<ClimbProblem> problems(100, {begin, {{3.0, 4.0, 2.0}, {1.0, 0.0}}, 0.3, 1.0});
  std::vector<ClimbAnswer> answers(problems.size());
  EXPECT_FALSE(climb_curves(problems, answers));
  problems[70].climb_angle = 0.9;
  const auto fault = climb_curves(problems, answers);
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->index, 70U);
  EXPECT_EQ(fault->sentence.substr(0, 42), "problem 70: climb angle 0.9 rad needs more");
}

TEST(Climb, HostileNumbersGiveNoNan) {
  Random random("hostile climbs");
  for (int i = 0; i < 20000; ++i) {
    double numbers[11];
    for (double& x : numbers) x = random.chance(0.5) ? random.uniform(-2.0, 2.0) : random.hostile();
    const auto found =
        climb_curve({{numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4]}},
                    {{numbers[5], numbers[6], numbers[7]}, {numbers[8], numbers[9]}}, numbers[10]);
    if (!found) {
      EXPECT_FALSE(found.fault().sentence.empty());
      continue;
    }
    EXPECT_TRUE(is_finite(found->curve.end()));
    EXPECT_TRUE(is_finite(found->curve.position(0.5)));
    EXPECT_GT(found->curve.arc_length(), 0.0);
  }
}

}  // namespace
}  // namespace hodograph::test
