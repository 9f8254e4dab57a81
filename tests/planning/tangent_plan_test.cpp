// SPDX-License-Identifier: MIT
// The rules T1 and T2 beside rounded corners: what is certified agrees with samples, and what the
// paper says of them is so.
#include "hodograph/planning/tangent_plan.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/support/random.hpp"
#include "tests/support/star_worlds.hpp"

namespace hodograph {
namespace {

using test::Random;
using P = Vector2<double>;

double distance(const P& p, const P& a, const P& b) {
  const P d = b - a;
  return norm(p - a - std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0) * d);
}

bool inside(const P& p, const Ring& ring) {
  bool odd = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const P &a = ring[i], &b = ring[next_vertex(i, ring.size())];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) odd = !odd;
  }
  return odd;
}

/// The distance of a point from the obstacles of a world; 0 inside.
double distance(const P& p, const World& world) {
  double least = std::numeric_limits<double>::infinity();
  for (const Polygon& polygon : world.obstacles()) {
    if (inside(p, polygon.outer)) return 0.0;
    for (std::size_t i = 0; i < polygon.outer.size(); ++i) {
      least = std::min(least, distance(p, polygon.outer[i],
                                       polygon.outer[next_vertex(i, polygon.outer.size())]));
    }
  }
  return least;
}

TEST(TangentPlan, IsCertifiedAsItsSamplesSay) {
  Random random("tangent plans in random worlds");
  constexpr double rounding = 1024.0 * std::numeric_limits<double>::epsilon();  // of a path's ends
  int compared = 0, meets = 0, too_sharp = 0;
  for (int round = 0; round < 24; ++round) {
    const VehicleLimits limits{.turn_radius = 2.0, .clearance = 0.2};
    const World world = test::star_world(random, 14, 0.6, 2.2);
    const auto planner = Planner::create(world, limits);
    ASSERT_TRUE(planner) << planner.fault().sentence;
    const auto plan = planner->plan(
        {.start = {-14, random.uniform(-12, 12)}, .goal = {14, random.uniform(-12, 12)}});
    if (!plan || plan->polyline.corners.empty()) continue;
    const ClearanceIndex index(world);
    for (const TangentRule rule : {TangentRule::t1, TangentRule::t2}) {
      constexpr double reach = 1.0;
      const auto other = tangent_plan(plan->polyline, rule, index, reach);
      ASSERT_TRUE(other) << other.fault().sentence;
      ++compared;
      const auto& path = other->path;
      const auto& points = plan->polyline.points;
      ASSERT_EQ(path.segment_count() + 1, points.size());
      const PlanCertificate& proof = other->certificate;
      EXPECT_GE(proof.arc_length.upper(), plan->polyline.length);
      for (std::size_t k = 0; k < points.size(); ++k) {
        EXPECT_LE(norm(path.position(path.knots()[k]) - points[k]), rounding * 14.0);
      }
      double least = std::numeric_limits<double>::infinity(), most = 0.0;
      constexpr int samples = 4000;
      for (int i = 0; i <= samples; ++i) {
        const double xi =
            path.clamped(path.xi_begin() + (path.xi_end() - path.xi_begin()) * i / samples);
        most = std::max(most, std::abs(curvature(path.preimage_jet<1>(xi))));
        least = std::min(least, distance(path.position(xi), world));
      }
      const Enclosure clearance = proof.clearance.least();
      EXPECT_LE(clearance.lower(), least);
      EXPECT_LE(most, proof.curvature.upper() * (1.0 + planning_tolerance));
      // Samples so close find nearly as much.
      const double step = proof.arc_length.upper() / samples;
      if (least < reach) {
        EXPECT_LE(least - clearance.upper(), 10.0 * step);
      }
      EXPECT_GT(other->curvature_jump, 0.0);
      EXPECT_LE(other->curvature_jump, 2.0 * proof.curvature.upper());
      if (least == 0.0) {
        ++meets;
        EXPECT_EQ(other->keeps_distance(limits.distance()), Answer::no);
        EXPECT_EQ(clearance.lower(), 0.0);
      }
      if (most > 1.0 / limits.turn_radius) {
        ++too_sharp;
        EXPECT_EQ(other->keeps_radius(limits.turn_radius), Answer::no);
      }
    }
  }
  EXPECT_GT(compared, 20);
  EXPECT_GT(too_sharp, 0);
  EXPECT_GT(meets, 0);
}

TEST(TangentPlan, AnswersExactlyAtItsLimits) {
  TangentPlan plan{TangentRule::t1, waypoint_path(std::vector<P>{{0, 0}, {1, 0}}).value(), {}};
  plan.certificate.curvature = Enclosure(0.25, 0.5);
  EXPECT_EQ(plan.keeps_radius(2.0), Answer::yes);
  EXPECT_EQ(plan.keeps_radius(3.0), Answer::undecided);
  EXPECT_EQ(plan.keeps_radius(5.0), Answer::no);
  plan.certificate.clearance.reach = 4.0;
  EXPECT_EQ(plan.keeps_distance(4.0), Answer::yes);
  plan.certificate.clearance.near = {{0, Enclosure(1.0, 1.5), 0.0, {}}};
  EXPECT_EQ(plan.keeps_distance(1.0), Answer::yes);
  EXPECT_EQ(plan.keeps_distance(1.25), Answer::undecided);
  EXPECT_EQ(plan.keeps_distance(2.0), Answer::no);
}

TEST(TangentPlan, RefusesWhatHasNoTangents) {
  const ClearanceIndex index{World{}};
  Polyline polyline;
  polyline.points = {{0, 0}, {1, 0}, {0, 0}};
  const auto back = tangent_plan(polyline, TangentRule::t1, index, 1.0);
  ASSERT_FALSE(back);
  EXPECT_EQ(back.fault().code, FaultCode::zero_speed);
  polyline.points = {{0, 0}, {1, 0}, {2, 1}};
  EXPECT_EQ(tangent_plan(polyline, TangentRule::t1, index, -1.0).fault().code,
            FaultCode::outside_domain);
  EXPECT_TRUE(tangent_plan(polyline, TangentRule::t1, index, 1.0));
}

}  // namespace
}  // namespace hodograph
