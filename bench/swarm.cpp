// SPDX-License-Identifier: MIT
// 1000 vehicles, 499,500 pairs: how long does it take to say which pairs come within 1 % of the
// path length, and how close every pair comes to 1e-9, against stepping and against one pair at a
// time?
#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/planning/swarm/pairs.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

constexpr double proven = 1e-9;  // not a tolerance: what stepping is asked for, of length 1

/// Vehicles that start and arrive all over a square of the side of their path length.
std::vector<Vehicle> random_swarm(std::size_t count, double staggered) {
  bench::Numbers numbers;
  std::vector<Vehicle> swarm;
  while (swarm.size() < count) {
    const Vector2<double> begin{numbers.within(0, 1), numbers.within(0, 1)};
    const Vector2<double> way = direction_of_angle(numbers.within(-3.14, 3.14));
    const Vector2<double> end = begin + numbers.within(0.6, 0.85) * way;
    const double angle = std::atan2(way.y, way.x);
    const auto curve =
        prescribed_length_curve({begin, direction_of_angle(angle + numbers.within(-0.8, 0.8))},
                                {end, direction_of_angle(angle + numbers.within(-0.8, 0.8))}, 1.0);
    if (!curve || !curve->loop_free) continue;
    const auto path = PlanarPath<2>::create({0.0, 1.0}, {curve->curve}, false).value();
    const TimingLaw law =
        TimingLaw::constant_speed(path.arc_length(), 1.0, staggered * numbers.next()).value();
    swarm.push_back({std::to_string(swarm.size()), TimedMotion::create(path, law).value(), 0.0});
  }
  return swarm;
}

}  // namespace

int main() {
  const std::vector<Vehicle> swarm = random_swarm(1000, 0.0), staggered = random_swarm(1000, 0.5);
  SwarmGoal near;
  near.clearance = 0.01;
  std::printf("%zu pairs closer than 0.01\n", close_pairs(swarm, near).value().size());
  double widest = 0.0;
  const SeparationMatrix matrix = separation_matrix(swarm, {}).value();
  for (std::size_t i = 0; i < swarm.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) widest = std::max(widest, matrix(i, j)->distance.width());
  }
  std::printf("widest enclosure %.2e\n", widest);
  const double pairs = 0.5 * 1000.0 * 999.0;
  SwarmGoal alone = near;
  alone.threads = 1;
  bench::compare(
      "which of 499,500 pairs come within 0.01 (the whole swarm)",
      {{"close_pairs", [&] { bench::keep(close_pairs(swarm, near)); }, 1.0},
       {"close_pairs, one thread", [&] { bench::keep(close_pairs(swarm, alone)); }, 1.0},
       {"close_pairs, staggered starts", [&] { bench::keep(close_pairs(staggered, near)); }, 1.0},
       {"conflicts", [&] { bench::keep(conflicts(swarm, near)); }, 1.0}},
      7);
  bench::compare(
      "every pair's least distance (a pair)",
      {{"separation_matrix", [&] { bench::keep(separation_matrix(swarm, {})); }, pairs},
       {"separation_matrix, one thread", [&] { bench::keep(separation_matrix(swarm, alone)); },
        pairs},
       {"separation_matrix, staggered starts",
        [&] { bench::keep(separation_matrix(staggered, {})); }, pairs},
       {"least_separation of one pair after the other (1 %)",
        [&] {
          for (std::size_t i = 0; i < 100; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
              bench::keep(least_separation(swarm[i].motion, swarm[j].motion));
            }
          }
        },
        4950.0},
       {"stepping at 1e-9, by the cost of a step",
        [&] { bench::keep(stepped_separation(swarm[0].motion, swarm[1].motion, 1.0 / 1e5)); },
        1e5 * proven}},
      1);
  return 0;
}
