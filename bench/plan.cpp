// SPDX-License-Identifier: MIT
// How long does a plan take once the world is indexed: the polyline, its corners rounded, and the
// proof of curvature and clearance; against the shortest polyline alone?
#include <cstdio>
#include <string>

#include "hodograph/planning/plan.hpp"
#include "support/measure.hpp"
#include "support/worlds.hpp"

namespace {

using namespace hodograph;

void run(std::size_t size, int repetitions) {
  const World world = bench::uniform_world(size);
  const PlanarBox& box = *world.box();
  const std::string name = std::to_string(world.vertex_count()) + " vertices";
  constexpr VehicleLimits limits{0.01, 0.02, 0.0};
  bench::compare("index of a world of " + name,
                 {{"Planner::create", [&] { bench::keep(Planner::create(world, limits)); }, 1.0}},
                 repetitions);

  const Planner planner = Planner::create(world, limits).value();
  const MitredWorld grown = MitredWorld::create(world, limits.distance()).value();
  // From the left to the right third of the world, where there is a plan.
  bench::Numbers numbers;
  std::vector<PlanRequest> requests;
  std::size_t corners = 0, attempts = 0, refused = 0;
  while (requests.size() < 20) {
    PlanRequest request;
    request.start = {numbers.within(0.0, 0.3) * box.upper.x, numbers.next() * box.upper.y};
    request.goal = {numbers.within(0.7, 1.0) * box.upper.x, numbers.next() * box.upper.y};
    const auto plan = planner.plan(request);
    if (!plan) {
      ++refused;
      continue;
    }
    corners += plan->legs.size();
    attempts += plan->attempts;
    requests.push_back(request);
  }
  const auto items = static_cast<double>(requests.size());
  bench::compare("a plan among " + name,
                 {{"shortest_polyline alone",
                   [&] {
                     for (const PlanRequest& request : requests) {
                       PolylineQuery query;
                       query.start = request.start;
                       query.goal = request.goal;
                       bench::keep(shortest_polyline(grown, query));
                     }
                   },
                   items},
                  {"Planner::plan",
                   [&] {
                     for (const PlanRequest& request : requests) bench::keep(planner.plan(request));
                   },
                   items}},
                 repetitions);
  std::printf("  %.1f corners and %.1f attempts a plan; %zu requests have none\n",
              static_cast<double>(corners) / items, static_cast<double>(attempts) / items, refused);
}

}  // namespace

int main() {
  run(1000, 9);
  run(10000, 5);
  run(100000, 3);
}
