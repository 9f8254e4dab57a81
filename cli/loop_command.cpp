// SPDX-License-Identifier: MIT
// hodograph loop: a closed loop of given length.
#include <memory>

#include "cli/commands.hpp"
#include "cli/loops.hpp"
#include "cli/options.hpp"

namespace hodograph::cli {
namespace {

struct LoopFlags {
  LoopRequest request;
  std::vector<double> start, direction, normal, near, extents, within;
  double roll_degrees = 0.0, xi = 0.0, psi = 0.0, psi_degrees = 0.0, largest_xi = 0.0;
  std::string limit, purpose;
  OutputFlags output;
};

Vector3<double> vector_of(const std::vector<double>& numbers, std::size_t from = 0) {
  return {numbers.at(from), numbers.at(from + 1), numbers.at(from + 2)};
}

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// The degrees nearest to a half and a quarter turn are these, not nearly so.
double radians_of(double degrees) {
  return degrees == 180.0    ? std::numbers::pi
         : degrees == -180.0 ? -std::numbers::pi
                             : degrees * radians_per_degree;
}

void run(LoopFlags flags) {
  if (flags.output.document.empty()) flags.output.document = "path.json";
  LoopRequest& request = flags.request;
  if (!flags.start.empty()) request.start = vector_of(flags.start);
  if (!flags.direction.empty()) request.direction = vector_of(flags.direction);
  if (!flags.normal.empty()) request.normal = vector_of(flags.normal);
  request.roll = flags.roll_degrees * radians_per_degree;
  if (!flags.limit.empty()) request.limit = flags.limit;
  if (!flags.purpose.empty()) request.purpose = flags.purpose;
  if (!flags.near.empty()) {
    request.point = vector_of(flags.near);
    request.purpose = "near";
  }
  if (!flags.extents.empty()) {
    request.extents = vector_of(flags.extents);
    request.purpose = "extents";
  }
  if (!flags.within.empty())
    request.within = LoopBox{vector_of(flags.within), vector_of(flags.within, 3)};
  const MadeLoop loop = make_loop(request);
  write_made_path(made_path(loop, "a closed loop of length " + to_text(request.length)),
                  flags.output, rows_of(loop));
}

}  // namespace

std::unique_ptr<Command> loop_command(CLI::App& program) {
  auto flags = std::make_shared<LoopFlags>();
  auto command = std::make_unique<Command>(
      program, "loop", "A closed loop of given length: position, frame and curvature return.");
  command->group("Place");
  command->option("--length", flags->request.length, "LENGTH", "the exact arc length (default 1)");
  command->option("--start", flags->start, "X,Y,Z", "where it begins and ends (default 0,0,0)")
      .list(3, 3);
  command->option("--direction", flags->direction, "X,Y,Z", "of its start (default 1,0,0)")
      .list(3, 3);
  command
      ->option("--normal", flags->normal, "X,Y,Z",
               "the side it bends to at the start (default: level, to the left)")
      .list(3, 3);
  command->option("--roll-deg", flags->roll_degrees, "ANGLE",
                  "turn the loop about its direction, from the left upwards");
  command->group("Shape");
  Option xi = command->option("--xi", flags->xi, "XI",
                              "how far it leaves its plane and symmetry; 0 (default): the torsion "
                              "is continuous, too");
  Option psi =
      command->option("--psi", flags->psi, "PSI",
                      "half the roll of the frame round the loop, radians_per_degree in [-pi, pi] "
                      "(default pi: an oval; 0: a figure of eight)");
  Option psi_degrees =
      command->option("--psi-deg", flags->psi_degrees, "PSI", "the same in degrees");
  psi_degrees.excludes(psi);
  Option limit = command->option("--limit", flags->limit, "SIGN",
                                 "the planar limit of xi to positive or negative infinity, which "
                                 "stands still at its start");
  limit.one_of({"positive", "negative"}).excludes(xi);
  command->group("Chosen for a purpose (xi and psi, where given, are held)");
  Option purpose =
      command->option("--for", flags->purpose, "PURPOSE", "least-energy or least-torsion");
  purpose.one_of({"least-energy", "least-torsion"});
  Option near =
      command->option("--near", flags->near, "X,Y,Z", "pass as near to a point as can be");
  near.list(3, 3).excludes(purpose);
  command
      ->option("--extents", flags->extents, "A,B,C", "sides of its box as near to these as can be")
      .list(3, 3)
      .excludes(purpose)
      .excludes(near);
  command
      ->option("--within", flags->within, "X0,Y0,Z0,X1,Y1,Z1",
               "stay in this box; alone: with the least bending energy")
      .list(6, 6);
  command->flag("--free-roll", flags->request.free_roll, "choose the roll, too");
  Option largest = command->option("--largest-xi", flags->largest_xi, "XI",
                                   "search |xi| up to this (default 8)");
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->examples(
      {"hodograph loop --length 12 --start 0,0,30 --direction 0,1,0 -o loop.json",
       "hodograph loop --xi 1 --psi-deg 108 -o loop.json --report loop.html",
       "hodograph loop --length 4 --near 0.3,1.1,0.4 --free-roll -o - | hodograph inspect -"});
  command->note(
      "The purposes are searched over a grid of the whole range and refined: the value told is\n"
      "certain, that no other loop is better is not. See docs/loops.md.");
  command->run([flags, xi, psi, psi_degrees, largest] {
    if (xi.given()) flags->request.xi = flags->xi;
    if (psi.given()) flags->request.psi = flags->psi;
    if (psi_degrees.given()) flags->request.psi = radians_of(flags->psi_degrees);
    if (largest.given()) flags->request.largest_xi = flags->largest_xi;
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
