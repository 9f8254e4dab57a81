// SPDX-License-Identifier: MIT
// hodograph sweep: a surface swept along a path, as a mesh or as exact surfaces.
#include <cstdio>
#include <memory>

#include "cli/commands.hpp"
#include "cli/frames.hpp"
#include "cli/options.hpp"
#include "cli/sweeps.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/report.hpp"

namespace hodograph::cli {
namespace {

struct SweepFlags {
  std::string document, profile, output, format, report, gamma;
  double circle = 0.0, tolerance = 0.0;
  std::vector<double> polygon;
  bool open_ends = false;
  SweepRequest request;
};

void take_profile(SweepFlags& flags) {
  SweepRequest& request = flags.request;
  const int given = (request.circle ? 1 : 0) + (request.ellipse.empty() ? 0 : 1) +
                    (request.rectangle.empty() ? 0 : 1) + (request.ribbon.empty() ? 0 : 1) +
                    (flags.polygon.empty() ? 0 : 1) + (flags.profile.empty() ? 0 : 1);
  if (given != 1) {
    throw Error(Fault{FaultCode::unsupported,
                      std::string(given == 0 ? "no profile is" : "several profiles are") +
                          " given; give one of --circle, --ellipse, --rectangle, --polygon, "
                          "--ribbon and --profile",
                      std::nullopt, "profile", std::nullopt, std::nullopt});
  }
  if (flags.polygon.size() % 2 != 0) {
    throw Error(Fault{
        FaultCode::mismatched_size,
        "--polygon has " + std::to_string(flags.polygon.size()) + " numbers; it takes pairs x,y",
        std::nullopt, "polygon", static_cast<double>(flags.polygon.size()), std::nullopt});
  }
  for (std::size_t i = 0; i < flags.polygon.size(); i += 2) {
    request.polygon.push_back({flags.polygon[i], flags.polygon[i + 1]});
  }
  if (!flags.profile.empty()) request.curve = load_document(flags.profile).value().path;
}

void run(SweepFlags flags) {
  if (flags.output.empty() && flags.report.empty()) flags.output = "sweep.stl";
  const std::string format = flags.output.empty() ? "" : sweep_format(flags.output, flags.format);
  take_profile(flags);
  SweepRequest& request = flags.request;
  request.caps = !flags.open_ends;
  if (!flags.gamma.empty()) {
    FrameRequest frame;
    set_gamma(frame, flags.gamma);
    request.gamma = frame.gamma;
    request.found_gamma = frame.found_gamma;
  }
  const PathDocument document = load_document(flags.document).value();
  const MadeSweep made = made_sweep(document.path, request);
  std::optional<MeasuredMesh> mesh;
  if (format != "step") mesh = measured_mesh(made, request, format);
  auto rows = rows_of(made, mesh ? &*mesh : nullptr, document.length_unit);
  if (!flags.output.empty()) {
    const auto step =
        write_sweep(made, request, mesh ? &*mesh : nullptr, document, flags.output, format);
    if (step) {
      rows.emplace_back("Surfaces", std::to_string(step->faces) + " faces, exact, degree " +
                                        std::to_string(step->degree_along) + " along and " +
                                        std::to_string(step->degree_round) + " round");
      rows.emplace_back("Body", step->solid ? "closed solid" : "shell with boundary");
    }
  }
  ReportData report = report_of(made, request, document, std::move(rows), !flags.report.empty());
  report.document_name = flags.document == "-" ? "" : flags.document;
  std::string table = report_text(report);
  if (!flags.output.empty() && flags.output != "-") table += "wrote " + flags.output + "\n";
  if (!flags.report.empty()) {
    if (const auto fault = write_file(flags.report, report_html(report))) throw Error(*fault);
    if (flags.report != "-") table += "wrote " + flags.report + "\n";
  }
  if (flags.output == "-" || flags.report == "-") {
    std::fputs(table.c_str(), stderr);
  } else {
    print(table);
  }
}

}  // namespace

std::unique_ptr<Command> sweep_command(CLI::App& program) {
  auto flags = std::make_shared<SweepFlags>();
  auto command = std::make_unique<Command>(
      program, "sweep", "Tubes, ribbons and swept surfaces along a path, as mesh or for CAD.");
  add_document_to(*command, flags->document);
  command->group("Profile (one of them)");
  Option circle = command->option("--circle", flags->circle, "R", "a tube of radius R");
  constexpr int most_numbers = 200'000;
  command->option("--ellipse", flags->request.ellipse, "A,B", "half axes along e2 and e3")
      .list(2, 2);
  command
      ->option("--rectangle", flags->request.rectangle, "W,H",
               "width along e2 and height along e3, about the path")
      .list(2, 2);
  command
      ->option("--polygon", flags->polygon, "X,Y,...",
               "corners in the plane of e2 and e3, convex or not")
      .list(6, most_numbers);
  command
      ->option("--ribbon", flags->request.ribbon, "L,R",
               "a ribbon from L to the left of the path to R to its right")
      .list(2, 2);
  command->option("--profile", flags->profile, "FILE", "a path in the plane, as document");
  command->group("Sweep");
  command
      ->option("--frame", flags->request.frame, "FRAME",
               "automatic (default: closing on a closed path, else erf), erf, "
               "closing, frenet, rotation-minimising, periodic, least-twist")
      .one_of({std::begin(sweep_frames), std::end(sweep_frames)});
  command->option("--gamma", flags->gamma, "G",
                  "parameter of the frame periodic: a number, least (default: that of the least "
                  "twist), smooth-negative or smooth-positive (C1 where the path closes)");
  command
      ->option("--scale", flags->request.scale, "S,...",
               "Bernstein coefficients of the scale along the path: 1,0.5 tapers to half")
      .list(1, 26);
  command->flag("--open-ends", flags->open_ends, "no flat faces at the ends of an open sweep");
  command->flag("--allow-contact", flags->request.allow_contact,
                "make a surface that meets itself all the same");
  command->group("Mesh");
  Option tolerance =
      command->option("-t,--tolerance", flags->tolerance, "E",
                      "largest distance of mesh and surface, a bound (default: a hundredth of "
                      "the profile's extent)");
  command
      ->option("--most-triangles", flags->request.most_triangles, "N",
               "refuse a mesh of more (default 20000000)")
      .whole_number(4, std::size_t{1} << 30U);
  command->group("Files");
  command->option("-o,--out", flags->output, "FILE",
                  "model.stl, .obj, .glb or .step (default sweep.stl; '-': standard output)");
  command
      ->option("--format", flags->format, "FORMAT",
               "stl, obj, glb: meshes; step: exact rational surfaces (default: by the suffix)")
      .one_of({"stl", "obj", "glb", "step"});
  command->option("--report", flags->report, "FILE", "an HTML page with the facts and pictures");
  command->examples(
      {"hodograph sweep loop.json --circle 0.05 -t 0.001 -o ring.stl",
       "hodograph loop --xi 1 --psi 2 -o - | hodograph sweep - --rectangle 0.02,0.1 -o belt.glb",
       "hodograph spline waypoints.csv -o - | hodograph sweep - --ribbon 0.1,0.1 -o road.obj",
       "hodograph spline waypoints.csv -o - | hodograph sweep - --circle 0.1 --report tube.html"});
  command->note(
      "A tube that meets itself is refused with the largest radius that does not. STEP needs a\n"
      "rational frame (erf, closing, periodic) and takes surfaces up to degree 25:\n"
      "4n+1 for a path of degree 2n+1, 4 more where the frame of a closed path is turned.");
  command->run([flags, circle, tolerance] {
    if (circle.given()) flags->request.circle = flags->circle;
    if (tolerance.given()) flags->request.tolerance = flags->tolerance;
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
