// SPDX-License-Identifier: MIT
// How long does the certified least separation of two planar quintics take, to 1e-9 of their
// length, against stepping at the resolution that proves as much, and against branch and bound with
// the Lipschitz bound alone?
#include "hodograph/planning/swarm/separation.hpp"

#include <queue>

#include "hodograph/construction/prescribed_length.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

constexpr double length = 1.6;  // of every path

PlanarPath<2> random_path(bench::Numbers& numbers) {
  const Vector2<double> begin{numbers.within(-0.2, 0.2), numbers.within(-0.2, 0.2)};
  const Vector2<double> end{1.0 + numbers.within(-0.2, 0.2), numbers.within(-0.2, 0.2)};
  const auto curve =
      prescribed_length_curve({begin, direction_of_angle(numbers.within(-1, 1))},
                              {end, direction_of_angle(numbers.within(-1, 1))}, length)
          .value()
          .curve;
  return PlanarPath<2>::create({0.0, 1.0}, {curve}, false).value();
}

/// The least distance to within `width` by |d(t) - d(t')| ≤ 2 v |t - t'| alone.
double lipschitz(const TimedMotion& a, const TimedMotion& b, double width) {
  struct Interval {
    double lower, begin, end, at_begin, at_end;
    bool operator<(const Interval& other) const { return lower > other.lower; }
  };
  const double speed = a.law().most_speed() + b.law().most_speed();
  const auto distance = [&](double t) { return norm(a.position(t) - b.position(t)); };
  const auto interval = [&](double t, double u, double d, double e) {
    return Interval{0.5 * (d + e - speed * (u - t)), t, u, d, e};
  };
  const double end = std::max(a.end_time(), b.end_time());
  double best = std::min(distance(0.0), distance(end));
  std::priority_queue<Interval> open;
  open.push(interval(0.0, end, distance(0.0), distance(end)));
  while (open.top().lower < best - width) {
    const Interval top = open.top();
    open.pop();
    const double middle = 0.5 * (top.begin + top.end), d = distance(middle);
    best = std::min(best, d);
    open.push(interval(top.begin, middle, top.at_begin, d));
    open.push(interval(middle, top.end, d, top.at_end));
  }
  return best;
}

}  // namespace

int main() {
  bench::Numbers numbers;
  constexpr std::size_t pairs = 500;
  std::vector<TimedMotion> first, second;
  std::vector<PlanarPath<2>> paths;
  for (std::size_t k = 0; k < pairs; ++k) {
    for (auto* list : {&first, &second}) {
      paths.push_back(random_path(numbers));
      list->push_back(
          TimedMotion::create(paths.back(),
                              TimingLaw::constant_speed(paths.back().arc_length(), 1.0).value())
              .value());
    }
  }
  double evaluations = 0.0, widest = 0.0;
  for (std::size_t k = 0; k < pairs; ++k) {
    const Separation found = least_separation(first[k], second[k]).value();
    evaluations += static_cast<double>(found.evaluations);
    widest = std::max(widest, found.distance.width());
  }
  std::printf("%.1f evaluations a pair, widest enclosure %.2e (lengths 1.6)\n",
              evaluations / static_cast<double>(pairs), widest);
  bench::compare(
      "a pair of planar quintics at constant speed",
      {{"least_separation, to 2^-30 of the length",
        [&] {
          for (std::size_t k = 0; k < pairs; ++k)
            bench::keep(least_separation(first[k], second[k]));
        },
        static_cast<double>(pairs)},
       {"separated_by 0.01",
        [&] {
          for (std::size_t k = 0; k < pairs; ++k) {
            bench::keep(separated_by(first[k], second[k], 0.01));
          }
        },
        static_cast<double>(pairs)},
       {"stepped_separation, 1000 steps (proves 1.6e-3)",
        [&] { bench::keep(stepped_separation(first[0], second[0], length / 1000.0)); }, 1.0},
       {"making a motion of a path and a speed",
        [&] {
          for (std::size_t k = 0; k < pairs; ++k) {
            bench::keep(TimedMotion::create(
                paths[k], TimingLaw::constant_speed(paths[k].arc_length(), 1.0).value()));
          }
        },
        static_cast<double>(pairs)}},
      11);
  constexpr double accuracy = 1e-7;  // not a tolerance: what the slower ways are asked for
  bench::compare("the same to 1e-7 of the length",
                 {{"least_separation",
                   [&] {
                     SeparationGoal goal;
                     goal.relative_width = accuracy;
                     for (std::size_t k = 0; k < 20; ++k) {
                       bench::keep(least_separation(first[k], second[k], goal));
                     }
                   },
                   20.0},
                  {"branch and bound with the Lipschitz bound",
                   [&] {
                     for (std::size_t k = 0; k < 20; ++k) {
                       bench::keep(lipschitz(first[k], second[k], length * accuracy));
                     }
                   },
                   20.0},
                  {"stepping, by the cost of a step",
                   [&] { bench::keep(stepped_separation(first[0], second[0], length / 1e5)); },
                   1e5 * accuracy}},
                 3);
  return 0;
}
