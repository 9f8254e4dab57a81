// SPDX-License-Identifier: MIT
#include "hodograph/control/path_following.hpp"

#include <string>

#include "follow_program.hpp"
#include "follow_stretch.hpp"

namespace hodograph {
namespace {

using namespace control_detail;

template <class Vehicle, bool by_progress>
Result<Following> followed(const AnyPath& path, const FollowedStretch& stretch,
                           const FollowLimits& limits, const FollowStart& start,
                           const FollowOptions& options) {
  auto reference = ReferencePath<typename Vehicle::A>::of(path, stretch.progress_by);
  if (!reference) return reference.fault();
  FollowProgram<Vehicle, by_progress> program(
      std::make_shared<const ReferencePath<typename Vehicle::A>>(*std::move(reference)), stretch,
      limits, start, options);
  auto solver = Solver::make(program.program(), options.solver);
  if (!solver) return solver.fault();
  auto solution = solver->solve(program.guess());
  if (!solution) return solution.fault();
  Following result = program.following(*solution);
  // Where the way bulges out between two nodes, the nodes are kept as much further in.
  constexpr int most_rounds = 6;
  constexpr double enough = 1.25;
  double bound = limits.offset, seconds = result.seconds;
  std::size_t iterations = result.iterations;
  for (int round = 0; round < most_rounds && result.largest_offset > limits.offset; ++round) {
    const double nearer = bound - enough * (result.largest_offset - limits.offset);
    bound = nearer > 0.0 ? nearer : bound * (limits.offset / result.largest_offset);
    program.bound_offset(bound);
    const auto next = solver->solve({solution->point.variables, {}, {}, {}});
    if (!next) return next.fault();
    *solution = *next;
    result = program.following(*next);
    iterations += result.iterations;
    seconds += result.seconds;
  }
  if (result.largest_offset > limits.offset) {
    return Fault{FaultCode::tolerance_not_reached,
                 "between the nodes the way leaves the path by " + to_text(result.largest_offset) +
                     ", where " + to_text(limits.offset) + " is allowed; more than " +
                     std::to_string(options.intervals) + " intervals would follow it closer",
                 std::nullopt,
                 "offset",
                 result.largest_offset,
                 limits.offset};
  }
  result.iterations = iterations;
  result.seconds = seconds;
  return result;
}

}  // namespace

Result<Following> follow(const AnyPath& path, const FollowLimits& limits, const FollowStart& start,
                         const FollowOptions& options) {
  const auto stretch = followed_stretch(path, limits, start, options);
  if (!stretch) return stretch.fault();
  const bool planar = path.dimension() == 2;
  if (options.independent == FollowIndependent::progress) {
    return planar ? followed<Car, true>(path, *stretch, limits, start, options)
                  : followed<Glider, true>(path, *stretch, limits, start, options);
  }
  return planar ? followed<Car, false>(path, *stretch, limits, start, options)
                : followed<Glider, false>(path, *stretch, limits, start, options);
}

}  // namespace hodograph
