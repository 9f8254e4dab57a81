// SPDX-License-Identifier: MIT
// hodograph plot: pictures of a path as SVG.
#include <memory>
#include <optional>
#include <vector>

#include "cli/commands.hpp"
#include "cli/drawing.hpp"
#include "cli/fitting.hpp"
#include "cli/options.hpp"
#include "cli/planar_drawing.hpp"
#include "cli/refuse.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/svg.hpp"

namespace hodograph::cli {
namespace {

struct PlotFlags {
  std::string document, output = "-", view = "path";
  std::size_t frames = 24;
  double comb_scale_given = 0.0;
  std::optional<double> comb_scale;
  std::vector<double> offsets;
};

constexpr std::size_t points_of_plot = 2000;

/// The pictures that there are of planar paths alone.
Plot planar_picture(const PlotFlags& flags, const PathDocument& document) {
  if (flags.view == "profile") return curvature_profile(document);
  std::vector<PathOffset> offsets;
  for (const double distance : flags.offsets) {
    offsets.push_back(offset_of(document.path, distance));
  }
  if (flags.view != "comb") return offset_picture(document, offsets);
  Plot plot = curvature_comb(document, flags.comb_scale);
  add_offsets(plot, document.path, offsets);
  return plot;
}

std::string picture(const PlotFlags& flags, const PathDocument& document) {
  if (flags.view == "comb" || flags.view == "profile" || !flags.offsets.empty()) {
    return to_svg(planar_picture(flags, document));
  }
  if (flags.view == "quantities" || flags.view == "all") {
    ReportData data;
    data.title = document.name;
    data.dimension = document.path.dimension();
    data.length_unit = document.length_unit;
    data.parameter_unit = document.parameter_unit;
    data.knots = document.path.knots();
    add_drawing(data, document);
    std::vector<Plot> plots = report_plots(data);
    const std::size_t of_the_path = document.path.dimension() == 2 ? 1 : 3;
    if (flags.view == "quantities") {
      plots.erase(plots.begin(), plots.begin() + static_cast<std::ptrdiff_t>(of_the_path));
    }
    constexpr std::size_t columns = 2;
    return to_svg(plots, columns);
  }
  const FramedPolyline curve = framed_polyline(document, points_of_plot, flags.frames);
  const std::string& unit = document.length_unit;
  if (document.path.dimension() == 2) return to_svg(plane_picture(curve, unit));
  if (flags.view == "xy") return to_svg(projected(curve, Projection::xy, unit));
  if (flags.view == "xz") return to_svg(projected(curve, Projection::xz, unit));
  if (flags.view == "yz") return to_svg(projected(curve, Projection::yz, unit));
  const std::vector<Plot> plots = {projected(curve, Projection::xy, unit),
                                   projected(curve, Projection::xz, unit),
                                   projected(curve, Projection::yz, unit)};
  return to_svg(plots, plots.size());
}

void run(const PlotFlags& flags) {
  if (!flags.offsets.empty() && flags.view != "path" && flags.view != "comb") {
    refuse("offsets are drawn in the views path and comb; the view is " + flags.view, "offset",
           FaultCode::unsupported);
  }
  if (flags.comb_scale && flags.view != "comb") {
    refuse("--comb-scale is for the view comb; the view is " + flags.view, "comb_scale",
           FaultCode::unsupported);
  }
  const PathDocument document = load_document(flags.document).value();
  if (document.path.dimension() == 2 && (flags.view == "xz" || flags.view == "yz")) {
    refuse("the path is in the plane; the view " + flags.view + " is of paths in space", "view",
           FaultCode::unsupported);
  }
  OutputFile file = OutputFile::create(flags.output).value();
  file.write(picture(flags, document));
  if (const auto fault = file.commit()) throw Error(*fault);
}

}  // namespace

std::unique_ptr<Command> plot_command(CLI::App& program) {
  auto flags = std::make_shared<PlotFlags>();
  auto command = std::make_unique<Command>(
      program, "plot",
      "Draw a path with its frames, its quantities along xi, its curvature or offsets, as SVG.");
  add_document_to(*command, flags->document);
  command->group("Picture");
  command
      ->option("--view", flags->view, "VIEW",
               "path (default): all projections; xy, xz or yz: one of them; quantities: speed, "
               "curvature, torsion and angular velocity; all; of paths in the plane also comb: "
               "curvature as teeth on the path, and profile: curvature along the arc length, "
               "extremes and inflections marked")
      .one_of({"path", "xy", "xz", "yz", "quantities", "all", "comb", "profile"});
  constexpr std::size_t most_frames = 1000;
  command->option("--frames", flags->frames, "N", "how many frames are drawn (default 24)")
      .whole_number(0, most_frames);
  const Option comb_scale =
      command->option("--comb-scale", flags->comb_scale_given, "C",
                      "length of the comb's teeth where the curvature is 1 (default: so that the "
                      "longest is a fifth of the picture)");
  constexpr int most_offsets = 1000;
  command
      ->option("--offset", flags->offsets, "D,...",
               "paths in the plane: draw the offsets at these distances, positive to the left")
      .list(1, most_offsets);
  command->group("Files");
  command->option("-o,--out", flags->output, "FILE", "the picture (default: standard output)");
  command->examples({"hodograph plot gateway.json -o gateway.svg",
                     "hodograph plot gateway.json --view quantities -o rates.svg",
                     "hodograph plot path.json --view comb --offset 0.1,-0.1 -o comb.svg"});
  command->run([flags, comb_scale] {
    if (comb_scale.given()) flags->comb_scale = flags->comb_scale_given;
    require_distances(flags->offsets);
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
