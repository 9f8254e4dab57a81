// SPDX-License-Identifier: MIT
// Climbs within a vehicle's limits and helical splines: random requests met or refused for a true
// reason, limits kept, angles found, joints reported, bad input.
#include "hodograph/construction/climb_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/path/bounds.hpp"
#include "hodograph/path/helix.hpp"
#include "tests/support/climb_campaign.hpp"
#include "tests/support/compare.hpp"

namespace hodograph::test {
namespace {

/// The rounding of angles of headings, some ε for each of tens of spans.
constexpr double heading_rounding = 0x1.0p-40;

TEST(ClimbPath, RandomRequestsAreMetOrRefusedForATrueReason) {
  Random random("climb requests");
  const ClimbCampaign campaign = run_climb_campaign(
      random, 600, [](const std::string& complaint) { ADD_FAILURE() << complaint; });
  EXPECT_GT(campaign.met, campaign.refused);
  for (const auto count : campaign.shapes) EXPECT_GT(count, 0U);
}

TEST(ClimbPath, FindsTheAngleWithinTheLimits) {
  const HeadedPoint begin{{0.0, 0.0, 0.0}, {1.0, 0.0}};
  const ClimbLimits limits{0.2, 0.35, 1.0};
  // Far and shallow: as the ground track has it. Steep: the largest angle.
  const auto shallow = climb_path(begin, {{100.0, 0.0, 5.0}, {1.0, 0.0}}, limits).value();
  EXPECT_LT(shallow.climb_angle, 0.051);
  EXPECT_EQ(shallow.shape, TurnLimitedShape::one_span);
  const auto steep = climb_path(begin, {{10.0, 0.0, 8.0}, {1.0, 0.0}}, limits).value();
  EXPECT_CLOSE(steep.climb_angle, 0.2, 32.0, 1.0);
  EXPECT_LE(steep.climb_angle, 0.2);
  EXPECT_EQ(steep.shape, TurnLimitedShape::loiter);
  EXPECT_GT(steep.whole_turns, 1U);
  const auto down = climb_path(begin, {{10.0, 0.0, -8.0}, {1.0, 0.0}}, limits).value();
  EXPECT_CLOSE(down.climb_angle, -0.35, 32.0, 1.0);
  EXPECT_GE(down.climb_angle, -0.35);
  const auto level = climb_path(begin, {{10.0, 3.0, 0.0}, {0.0, 1.0}}, limits).value();
  EXPECT_EQ(level.climb_angle, 0.0);
  const auto up = climb_path(begin, {{0.0, 0.0, 50.0}, {1.0, 0.0}}, limits).value();  // a helix
  EXPECT_EQ(up.shape, TurnLimitedShape::loiter);
  EXPECT_TRUE(recognised_helix(up.path).is_helix());
  const auto free = climb_path(begin, {{10.0, 3.0, 1.0}, {0.0, 1.0}}, {0.2, 0.2, 0.0}).value();
  EXPECT_EQ(free.path.segment_count(), 1U);
}

TEST(ClimbPath, OfAGivenLengthOverGround) {
  const HeadedPoint begin{{0.0, 0.0, 3.0}, {1.0, 0.0}}, end{{4.0, 2.0, 3.0}, {0.0, 1.0}};
  const auto level = climb_path_of_ground_length(begin, end, 20.0, 1.0).value();
  EXPECT_EQ(level.climb_angle, 0.0);
  EXPECT_CLOSE(level.path.arc_length(), 20.0, 256.0, 20.0);
  EXPECT_LE(level.most_ground_curvature, 1.0);
  const std::vector<ClimbWaypoint> two{{begin.position, begin.heading, {}, 6.0},
                                       {{4.0, 2.0, 0.0}, end.heading, {}, {}}};
  const auto down = climb_route(two, {}).value();
  EXPECT_CLOSE(down.spans[0].climb_angle, -std::atan(0.5), 8.0, 1.0);
  EXPECT_FALSE(climb_path_of_ground_length(begin, end, 4.0, 1.0));
}

TEST(ClimbPath, SaysWhichClimbWouldDo) {
  const HeadedPoint begin{{0.0, 0.0, 0.0}, {1.0, 0.0}};
  const HeadedPoint end{{4.0, 0.0, 1.0}, {-1.0, 0.0}};
  const auto found = climb_path(begin, end, 0.2, 2.0);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.fault().quantity, "climb");
  EXPECT_EQ(found.fault().sentence.substr(0, 61),
            "climb angle 0.2 rad with a turn radius of 2 needs at least 2.");
  HeadedPoint higher = end;
  higher.position.z = *found.fault().bound;
  EXPECT_TRUE(climb_path(begin, higher, 0.2, 2.0));

  // Found by the campaign: the shortest arcs fall short of the distance by rounding; arcs whose
  // curvature rounding decides, so that a little more descent is named.
  const HeadedPoint ahead{{0.0, 0.0, 0.0}, {1.0, 0.0}};
  HeadedPoint beyond{{0.038155073705738625, 0.0, 0.000019}, {1.0, 0.0}};
  HeadedPoint turned_round{{7.8940779772669103, 1.316765619356957, 8.4049939002685008},
                           {-0.96674830774661025, -0.25572975866931363}};
  HeadedPoint below{{7.8940779772669103, 1.316765619356957, 8.0942167037027932},
                    {-0.96674830528885414, -0.25572976796049485}};
  const struct {
    HeadedPoint first, last;
    double angle, radius;
    const char* what;
  } found_by_campaign[] = {
      {ahead, beyond, 0.00074831783725421287, 3.4558019309093666, "needs at least"},
      {turned_round, below, -1.1726618927807413, 0.19014306789194285, "needs more descent ("}};
  for (const auto& c : found_by_campaign) {
    const auto refused = climb_path(c.first, c.last, c.angle, c.radius);
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.fault().sentence.find(c.what), std::string::npos);
    HeadedPoint named = c.last;
    named.position.z = c.first.position.z + std::copysign(*refused.fault().bound, c.angle);
    EXPECT_TRUE(climb_path(c.first, named, c.angle, c.radius)) << refused.fault().sentence;
  }

  const auto unable = climb_path(begin, end, ClimbLimits{0.0, 0.3, 1.0});
  ASSERT_FALSE(unable);
  EXPECT_EQ(unable.fault().code, FaultCode::no_interpolant);
  EXPECT_EQ(unable.fault().sentence,
            "a climb of 1 needs a climb angle above 0; the vehicle's is 0 (the straight line has "
            "0.24497866312686414 rad)");
  const auto wrong = climb_path(begin, end, ClimbLimits{2.0, 0.3, 1.0});
  ASSERT_FALSE(wrong);
  EXPECT_EQ(wrong.fault().sentence,
            "the largest climb angle must be at least 0 and below pi/2, in radians; got 2");
  const auto down = climb_path(begin, end, -0.3, 1.0);
  ASSERT_FALSE(down);
  EXPECT_EQ(down.fault().sentence,
            "descent angle -0.3 rad needs an end below the start; its altitude changes by 1");
  const auto radius = climb_path(begin, end, ClimbLimits{0.3, 0.3, -1.0});
  ASSERT_FALSE(radius);
  EXPECT_EQ(radius.fault().quantity, "turn_radius");
}

TEST(ClimbRoute, JoinsSpansAndReportsWhatIsContinuous) {
  const std::vector<ClimbWaypoint> waypoints{
      {{0.0, 0.0, 0.0}, {}, {}, {}},
      {{40.0, 10.0, 6.0}, {}, 0.2, {}},
      {{60.0, 40.0, 12.0}, {}, 0.2, {}},
      {{20.0, 60.0, 20.0}, {}, {}, {}},
      {{-20.0, 30.0, 5.0}, Vector2<double>{0.0, -1.0}, {}, {}}};
  ClimbRouteOptions options;
  options.limits = {0.25, 0.3, 5.0};
  const auto route = climb_route(waypoints, options);
  ASSERT_FALSE(route);  // 20 of length over ground is too little for the altitude at 0.2 rad
  EXPECT_EQ(route.fault().index, 1U);
  EXPECT_EQ(route.fault().sentence.substr(0, 31), "span 1: climb angle 0.2 rad wit");

  std::vector<ClimbWaypoint> better = waypoints;
  better[2].position.z = 6.0 + *route.fault().bound + 0.5;
  better[3].position.z = better[2].position.z + 12.0;
  const auto made = climb_route(better, options);
  ASSERT_TRUE(made) << made.fault().sentence;
  ASSERT_EQ(made->spans.size(), 4U);
  ASSERT_EQ(made->joints.size(), 3U);
  EXPECT_CLOSE(made->spans[1].climb_angle, 0.2, 8.0, 1.0);
  EXPECT_CLOSE(made->spans[2].climb_angle, 0.2, 8.0, 1.0);
  EXPECT_LT(made->spans[3].climb_angle, 0.0);
  for (std::size_t i = 0; i < better.size(); ++i) {
    const double xi =
        i + 1 < better.size() ? made->path.knots()[made->spans[i].first] : made->path.xi_end();
    EXPECT_CLOSE(made->path.position(xi), better[i].position, 256.0, 100.0) << i;
    const auto way = made->path.position_derivatives<1>(xi)[1];
    const Vector2<double> seen{way.x, way.y};
    EXPECT_LE(std::abs(cross(seen, made->headings[i])) / norm(made->headings[i]), heading_rounding);
    EXPECT_CLOSE(norm(seen), 1.0, 64.0, 1.0);  // unit speed over ground
  }
  // Equal angles meet at waypoint 2: C1 there; elsewhere a corner in pitch.
  EXPECT_EQ(made->joints[0].position, 0);
  EXPECT_EQ(made->joints[0].frame, -1);
  EXPECT_GE(made->joints[1].position, 1);
  EXPECT_GE(made->joints[1].preimage, 0);
  EXPECT_GE(made->joints[1].frame, 0);
  EXPECT_CLOSE(made->joints[1].pitch_change, 0.0, 8.0, 1.0);
  EXPECT_EQ(made->joints[2].position, 0);
  EXPECT_TRUE(recognised_helix(made->path).is_helical());
  for (const ClimbSpan& span : made->spans) EXPECT_LE(span.most_ground_curvature * 5.0, 1.0);
}

TEST(ClimbRoute, RefusesBadWaypoints) {
  ClimbRouteOptions options;
  options.limits = {0.25, 0.3, 5.0};
  const std::vector<ClimbWaypoint> one{{{0.0, 0.0, 0.0}, {}, {}, {}}};
  EXPECT_EQ(climb_route(one, options).fault().sentence,
            "a route needs at least two waypoints; got 1");
  std::vector<ClimbWaypoint> two{{{0.0, 0.0, 0.0}, {}, {}, {}}, {{0.0, 0.0, 10.0}, {}, {}, {}}};
  EXPECT_FALSE(climb_route(two, options));  // one above the other: the headings have to be given
  two[0].heading = two[1].heading = Vector2<double>{1.0, 0.0};
  const auto up = climb_route(two, options);
  ASSERT_TRUE(up) << up.fault().sentence;
  EXPECT_GT(up->spans[0].whole_turns, 0U);
  two[1].position.z = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(climb_route(two, options).fault().code, FaultCode::not_finite);
  two[1].position.z = 10.0;
  two[0].climb_angle = 0.0;
  EXPECT_EQ(climb_route(two, options).fault().code, FaultCode::outside_domain);
}

TEST(ClimbPath, HostileNumbersGiveNoNan) {
  Random random("hostile climb paths");
  for (int i = 0; i < 1500; ++i) {
    double x[14];
    for (double& number : x) number = random.chance(0.7) ? random.uniform(-2, 2) : random.hostile();
    const HeadedPoint begin{{x[0], x[1], x[2]}, {x[3], x[4]}},
        end{{x[5], x[6], x[7]}, {x[8], x[9]}};
    for (const auto& made : {climb_path(begin, end, x[10], x[11]),
                             climb_path(begin, end, ClimbLimits{x[12], x[13], x[11]})}) {
      if (made) {
        EXPECT_TRUE(is_finite(made->path.segments().back().end()));
        EXPECT_TRUE(is_finite(made->path.position(made->path.xi_begin())));
        EXPECT_TRUE(std::isfinite(made->climb_angle));
      } else {
        EXPECT_FALSE(made.fault().sentence.empty());
      }
    }
  }
}

}  // namespace
}  // namespace hodograph::test
