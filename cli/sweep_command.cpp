// SPDX-License-Identifier: MIT
// hodograph sweep: a surface swept along a path, as a mesh or as exact surfaces.
#include <algorithm>
#include <cstdio>
#include <filesystem>
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
  std::vector<double> polygon, along, turn, track;
  bool open_ends = false;
  SweepRequest request;
};

/// The numbers of an option as vectors of `size` each.
template <class Vector>
std::vector<Vector> vectors_of(const std::vector<double>& numbers, std::size_t size,
                               const std::string& option) {
  if (numbers.size() % size != 0) {
    throw Error(Fault{FaultCode::mismatched_size,
                      option + " has " + std::to_string(numbers.size()) + " numbers; it takes " +
                          std::to_string(size) + " for each coefficient",
                      std::nullopt, option, static_cast<double>(numbers.size()), std::nullopt});
  }
  std::vector<Vector> vectors(numbers.size() / size);
  for (std::size_t i = 0; i < numbers.size(); ++i) vectors[i / size][i % size] = numbers[i];
  return vectors;
}

void take_profile(SweepFlags& flags) {
  SweepRequest& request = flags.request;
  request.along = vectors_of<Vector3<double>>(flags.along, 3, "--along");
  request.turn = vectors_of<Quaternion<double>>(flags.turn, 4, "--turn");
  const int given = (request.circle ? 1 : 0) + (request.ellipse.empty() ? 0 : 1) +
                    (request.rectangle.empty() ? 0 : 1) + (request.ribbon.empty() ? 0 : 1) +
                    (flags.polygon.empty() ? 0 : 1) + (flags.profile.empty() ? 0 : 1) +
                    (request.is_family() ? 1 : 0) + (flags.track.empty() ? 0 : 1);
  if (given != 1) {
    throw Error(Fault{FaultCode::unsupported,
                      std::string(given == 0 ? "no profile is" : "several profiles are") +
                          " given; give one of --circle, --ellipse, --rectangle, --polygon, "
                          "--ribbon, --profile, --along with --turn, and --track",
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

void write_track(const SweepFlags& flags, const PathDocument& document) {
  const MadeTrack track = made_track(document.path, flags.request, flags.track[0], flags.track[1]);
  std::string text;
  if (std::filesystem::path(flags.output).extension() == ".csv") {
    constexpr std::size_t per_curve = 101;
    text = csv_of(track, per_curve);
  } else {
    append_json(text, json_of(track));
    text += "\n";
  }
  if (const auto fault = write_file(flags.output, text)) throw Error(*fault);
  if (flags.output == "-") return;
  std::size_t degree = 0;
  for (const auto& curve : track.curves) degree = std::max(degree, curve.degree());
  ReportData report;
  report.more = {{"Frame", track.frame},
                 {"Track", std::to_string(track.curves.size()) +
                               " rational Bezier curves, exact, degree " + std::to_string(degree)}};
  print(report_text(report) + "wrote " + flags.output + "\n");
}

void run(SweepFlags flags) {
  if (!flags.track.empty()) {
    if (flags.output.empty()) flags.output = "track.json";
    if (!flags.report.empty()) {
      throw Error(Fault{FaultCode::unsupported, "a track is a curve; --report shows surfaces",
                        std::nullopt, "report", std::nullopt, std::nullopt});
    }
  }
  if (flags.output.empty() && flags.report.empty()) flags.output = "sweep.stl";
  const std::string format =
      flags.output.empty() || !flags.track.empty() ? "" : sweep_format(flags.output, flags.format);
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
  if (!flags.track.empty()) return write_track(flags, document);
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
  command
      ->option("--track", flags->track, "L,U",
               "no surface: the track of the point L to the left, U up (.json: exact rational "
               "curves; .csv: points)")
      .list(2, 2);
  command->group("Tubular family, instead of a profile");
  command
      ->option("--along", flags->along, "X,Y,Z,...",
               "carry the path itself along the polynomial with these Bezier control points")
      .list(3, most_numbers);
  command
      ->option("--turn", flags->turn, "W,X,Y,Z,...",
               "and turn it by the quaternion polynomial with these coefficients")
      .list(4, most_numbers);
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
       "hodograph spline waypoints.csv -o - | hodograph sweep - --circle 0.1 --report tube.html",
       "hodograph sweep loop.json --along 0,0,0,0,0,2 --turn 1,0,0,0,0.7,0,0,0.7 -o vase.stl",
       "hodograph sweep loop.json --track 0.1,0 -o rail.json"});
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
