// SPDX-License-Identifier: MIT
// hodograph hermite: one planar quintic between two end states, from derivatives or of a given
// length.
#include <memory>

#include "cli/commands.hpp"
#include "cli/made_path.hpp"
#include "cli/options.hpp"
#include "cli/refuse.hpp"
#include "hodograph/construction/prescribed_length.hpp"

namespace hodograph::cli {
namespace {

struct HermiteFlags {
  std::vector<double> begin, end;
  std::vector<double> begin_derivative, end_derivative;
  std::vector<double> begin_direction, end_direction;
  double begin_degrees = 0.0, end_degrees = 0.0, length = 0.0;
  bool begin_by_degrees = false, end_by_degrees = false, by_length = false;
  OutputFlags output;
};

using Rows = std::vector<std::pair<std::string, std::string>>;

Vector2<double> plane_vector(const std::vector<double>& numbers) {
  return {numbers.at(0), numbers.at(1)};
}

Vector2<double> direction_of(const std::vector<double>& vector, bool by_degrees, double degrees,
                             const char* end) {
  if (by_degrees) {
    constexpr double radians = 3.141592653589793 / 180.0;
    return direction_of_angle(degrees * radians);
  }
  if (vector.empty()) {
    refuse(std::string("a path of given length needs a direction at both ends: --") + end +
               "-direction X,Y or --" + end + "-deg ANGLE is missing",
           "direction");
  }
  return plane_vector(vector);
}

const char* sentence_of(TieBreak tie) {
  switch (tie) {
    case TieBreak::none:
      return "";
    case TieBreak::regularity:
      return "; a tie, broken by the larger least speed";
    case TieBreak::left_turn:
      return "; a tie, broken in favour of the left turn";
    case TieBreak::order:
      return "; a tie, broken by order";
  }
  return "";
}

/// The rows that tell how the solution was chosen.
template <class Chosen>
Rows rows_of(const Chosen& chosen) {
  return {{"Rotation index", to_six_digits(chosen.rotation_index) + " rad, the next solution's " +
                                 to_six_digits(chosen.margin) + " more" + sentence_of(chosen.tie)}};
}

void run(HermiteFlags flags) {
  if (flags.output.document.empty()) flags.output.document = "path.json";
  Rows more;
  std::string method;
  const auto curve = [&] {
    const Vector2<double> begin = plane_vector(flags.begin), end = plane_vector(flags.end);
    if (flags.by_length) {
      const auto begin_direction =
          direction_of(flags.begin_direction, flags.begin_by_degrees, flags.begin_degrees, "begin");
      const auto end_direction =
          direction_of(flags.end_direction, flags.end_by_degrees, flags.end_degrees, "end");
      const auto chosen =
          prescribed_length_curve({begin, begin_direction}, {end, end_direction}, flags.length)
              .value();
      method = "G1 Hermite of prescribed length";
      more = rows_of(chosen);
      if (!chosen.loop_free) {
        more.emplace_back("Loops",
                          "no solution of this length is free of loops: it is too long "
                          "for these directions");
      }
      return chosen.curve;
    }
    if (flags.begin_derivative.empty() || flags.end_derivative.empty()) {
      refuse(
          "give the derivatives at both ends (--begin-derivative X,Y --end-derivative X,Y), or "
          "a --length with directions",
          "derivative");
    }
    const auto chosen = planar_hermite({begin, plane_vector(flags.begin_derivative)},
                                       {end, plane_vector(flags.end_derivative)})
                            .value();
    method = "C1 Hermite in the plane";
    more = rows_of(chosen);
    return chosen.curve;
  }();
  write_made_path(
      made_path(PlanarPath<2>::create({0.0, 1.0}, {curve}, false).value(), "end states", method),
      flags.output, more);
}

}  // namespace

std::unique_ptr<Command> hermite_command(CLI::App& program) {
  auto flags = std::make_shared<HermiteFlags>();
  auto command = std::make_unique<Command>(
      program, "hermite",
      "The planar quintic between two points, from derivatives or of a given length.");
  command->group("Points");
  command->option("--begin", flags->begin, "X,Y", "where the path begins").list(2, 2).required();
  command->option("--end", flags->end, "X,Y", "where it ends").list(2, 2).required();
  command->group("By derivatives");
  Option begin_derivative = command->option("--begin-derivative", flags->begin_derivative, "X,Y",
                                            "dr/dxi at the beginning; xi runs from 0 to 1");
  Option end_derivative =
      command->option("--end-derivative", flags->end_derivative, "X,Y", "dr/dxi at the end");
  begin_derivative.list(2, 2);
  end_derivative.list(2, 2);
  command->group("By length");
  Option length = command->option("--length", flags->length, "LENGTH",
                                  "the exact arc length; the speed is equal at both ends");
  length.excludes(begin_derivative).excludes(end_derivative);
  Option begin_direction = command->option("--begin-direction", flags->begin_direction, "X,Y",
                                           "of the path's beginning");
  Option end_direction =
      command->option("--end-direction", flags->end_direction, "X,Y", "of its end");
  Option begin_degrees = command->option("--begin-deg", flags->begin_degrees, "ANGLE",
                                         "the same as an angle from the x axis, in degrees");
  Option end_degrees = command->option("--end-deg", flags->end_degrees, "ANGLE", "likewise");
  begin_direction.list(2, 2).needs(length).excludes(begin_degrees);
  end_direction.list(2, 2).needs(length).excludes(end_degrees);
  begin_degrees.needs(length);
  end_degrees.needs(length);
  flags->output.add_to(*command, "the path document (default path.json; '-': standard output)",
                       "an HTML report with pictures");
  command->examples(
      {"hodograph hermite --begin 0,0 --begin-derivative 2,1 --end 1,0 --end-derivative 2,-1",
       "hodograph hermite --begin 0,0 --begin-deg 45 --end 1,0 --end-deg 60 --length 1.12"});
  command->note(
      "Of several solutions the one with the least absolute rotation index is taken, the integral\n"
      "of |curvature| along the path, which is computed exactly.");
  command->run([flags, length, begin_degrees, end_degrees] {
    flags->by_length = length.given();
    flags->begin_by_degrees = begin_degrees.given();
    flags->end_by_degrees = end_degrees.given();
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
