// SPDX-License-Identifier: MIT
// Six vehicles fly from one circle to another, each leaving and arriving in directions of its own,
// and arrive together: paths of one length, 12.5 % above the distance. How close does each pair
// come, at any time? And if that is too close?
#include <cstdio>
#include <numbers>

#include "hodograph/planning/swarm/deconfliction.hpp"

using namespace hodograph;

namespace {

std::vector<ArrivingVehicle> circle_to_circle() {
  const double leave[] = {0.9, -0.6, 0.5, -0.9, 0.3, -0.4};
  const double arrive[] = {-0.7, 0.8, 0.5, -0.4, -0.9, 0.6};
  std::vector<ArrivingVehicle> vehicles;
  for (std::size_t i = 0; i < 6; ++i) {
    const double angle = std::numbers::pi / 3.0 * static_cast<double>(i);
    const Vector2<double> place = 0.1 * direction_of_angle(angle);
    vehicles.push_back({std::string(1, static_cast<char>('a' + i)),
                        {place, direction_of_angle(leave[i])},
                        {place + Vector2<double>{1.0, 0.0}, direction_of_angle(arrive[i])}});
    vehicles.back().most_curvature = 8.0;
  }
  return vehicles;
}

void print(const SimultaneousArrival& plan, const SwarmGoal& goal) {
  std::printf("arrival at %.6g\n", plan.arrival);
  for (std::size_t i = 0; i < plan.paths.size(); ++i) {
    const ArrivingPath& p = plan.paths[i];
    std::printf("  %s leaves at %.3g: length %.6g, curvature up to %.4g\n",
                plan.vehicles[i].id.c_str(), p.departure, p.path.arc_length(),
                p.largest_curvature.upper());
  }
  const SeparationMatrix matrix = separation_matrix(plan.vehicles, goal).value();
  std::printf("  least separations (certified, to 1e-9):\n");
  for (std::size_t i = 1; i < matrix.size(); ++i) {
    std::printf("    %s", plan.vehicles[i].id.c_str());
    for (std::size_t j = 0; j < i; ++j) std::printf("  %.6f", matrix(i, j)->distance.lower());
    std::printf("\n");
  }
  for (const Conflict& c : conflicts(plan.vehicles, goal).value()) {
    std::printf("  %s and %s come within %.6f at %.4f; %.4f is required\n",
                plan.vehicles[c.pair.first].id.c_str(), plan.vehicles[c.pair.second].id.c_str(),
                c.separation.distance.upper(), c.separation.time, c.pair.required);
  }
}

}  // namespace

int main() {
  const std::vector<ArrivingVehicle> vehicles = circle_to_circle();
  SwarmGoal goal;
  goal.clearance = 0.03;
  const double arrival = 1.125;
  print(arrival_at(vehicles, arrival).value(), goal);

  const ArrivalMoves moves{
      .departure = {.longest_delay = 0.05, .delays = 5}, .latest_excess = 0.1, .later_arrivals = 5};
  const auto apart = deconflict_arrival(vehicles, arrival, goal, moves);
  if (!apart) {
    std::printf("%s\n", apart.fault().sentence.c_str());
    return 3;
  }
  std::printf("\nkept apart after %zu choices and %zu certified pairs:\n", apart->effort.choices,
              apart->effort.pairs_checked);
  print(apart->plan, goal);
  return 0;
}
