// SPDX-License-Identifier: MIT
// hodograph orbit: a periodic orbit of the Earth-Moon system as a path.
#include <cstddef>
#include <filesystem>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "hodograph/orbit/three_body.hpp"

namespace hodograph::cli {
namespace {

constexpr double default_tolerance = 1e-9;  // LU: 0.4 m; the length unit is 389703 km

struct OrbitFlags {
  std::string orbit = "gateway", frame = "rotating", units = "lu";
  std::vector<double> initial;
  double mass_ratio = 0.0;
  std::size_t revolutions = 1;
  FitFlags fit;
  OutputFlags output;
};

Source source_of(const OrbitFlags& flags, bool own_ratio) {
  OrbitSource source;
  source.name = flags.orbit;
  source.inertial = flags.frame == "inertial";
  source.kilometres = flags.units == "km";
  source.revolutions = flags.revolutions;
  if (own_ratio) source.mass_ratio = flags.mass_ratio;
  if (!flags.initial.empty()) {
    source.name = "initial";
    source.x = flags.initial[0];
    source.z = flags.initial[1];
    source.vy = flags.initial[2];
    if (flags.initial.size() > 3) source.period = flags.initial[3];
  }
  return source;
}

void run(OrbitFlags flags, bool own_ratio) {
  if (flags.fit.tolerance == 0.0 && flags.fit.segments == 0) {
    flags.fit.tolerance =
        default_tolerance * (flags.units == "km" ? earth_moon_system.length_unit_km : 1.0);
  }
  const std::string name = flags.initial.empty() ? flags.orbit : "orbit";
  if (flags.output.document.empty()) flags.output.document = name + ".json";
  if (flags.output.report.empty() && flags.output.document != "-") {
    flags.output.report =
        std::filesystem::path(flags.output.document).replace_extension(".html").string();
  }
  if (flags.output.report == "none") flags.output.report.clear();
  fit_and_write(source_of(flags, own_ratio), flags.fit, flags.output, "fitting the orbit");
}

}  // namespace

std::unique_ptr<Command> orbit_command(CLI::App& program) {
  auto flags = std::make_shared<OrbitFlags>();
  auto command = std::make_unique<Command>(
      program, "orbit",
      "Fit a periodic orbit of the Earth-Moon system; write the path and a report.");
  command->group("Orbit");
  Option orbit = command->option("--orbit", flags->orbit, "NAME",
                                 "gateway (default), the near-rectilinear halo orbit of the "
                                 "PHODCOS paper, or synodic-9-2, the "
                                 "one in 9:2 resonance with the synodic month");
  orbit.one_of({"gateway", "synodic-9-2"});
  Option initial = command->option(
      "--initial", flags->initial, "X,Z,VY[,T]",
      "the halo orbit nearest to this start on y = 0, perpendicular to it, in LU and TU, with a "
      "guess of its period; z is kept, the others are corrected");
  initial.list(3, 4).excludes(orbit);
  Option ratio = command->option("--mu", flags->mass_ratio, "MU",
                                 "mass ratio of the primaries, with --initial");
  ratio.needs(initial);
  command
      ->option("--frame", flags->frame, "FRAME",
               "rotating (default), or inertial, centred at the Earth")
      .one_of({"rotating", "inertial"});
  constexpr std::size_t most_revolutions = 1000;
  command->option("--revolutions", flags->revolutions, "N", "how often round (default 1)")
      .whole_number(1, most_revolutions);
  command
      ->option("--units", flags->units, "UNIT",
               "of length: lu (default), the distance of the primaries, or km")
      .one_of({"lu", "km"});
  flags->fit.add_to(*command, "largest position error, in the units (default 1e-9 LU)");
  flags->output.add_to(*command, "the path document (default gateway.json; '-': standard output)",
                       "the HTML report (default: named like the document; 'none': no report)");
  command->examples({"hodograph orbit",
                     "hodograph orbit --frame inertial --revolutions 4 -t 1e-6 -o four.json",
                     "hodograph orbit --initial 1.0273,-0.18552,-0.1145 --units km"});
  command->run([flags, ratio] { run(*flags, ratio.given()); });
  return command;
}

}  // namespace hodograph::cli
