// SPDX-License-Identifier: MIT
// hodograph frame: an adapted frame along a path.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <numbers>

#include "cli/commands.hpp"
#include "cli/frames.hpp"
#include "cli/options.hpp"
#include "cli/sample_plan.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/report.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

struct FrameFlags {
  FrameRequest request;
  std::string document, gamma, output = "-", format, report;
  std::vector<double> begin_normal, end_normal, xi;
  double begin_degrees = 0.0, end_degrees = 0.0, step = 0.0;
  std::size_t count = 101, count_in_xi = 0, per_segment = 0;
  SamplePlan plan;
};

std::string format_of(const FrameFlags& flags) {
  if (!flags.format.empty()) return flags.format;
  const std::string suffix = std::filesystem::path(flags.output).extension().string();
  return suffix == ".json" || suffix == ".JSON" ? "json" : "csv";
}

std::string csv_text(const std::vector<FramePlace>& places) {
  std::string text;
  append_csv_header(text, frame_columns());
  for (const auto& place : places) append_csv_row(text, row_of(place));
  return text;
}

std::string json_text(const MadeFrame& frame, const FrameRequest& request,
                      const std::vector<FramePlace>& places) {
  Json json = json_of(frame, request);
  Json& list = json["frames"] = Json::array();
  for (const auto& place : places) list.push_back(json_of(place));
  std::string text;
  append_json(text, json);
  return text + "\n";
}

ReportData report_of(const PathDocument& document, const MadeFrame& frame,
                     const FrameRequest& request, const std::string& name) {
  ReportData data;
  data.title = "Frame: " + request.kind;
  data.document_name = name;
  data.segments = document.path.segment_count();
  data.preimage_degree = document.path.preimage_degree();
  data.closed = document.path.is_closed();
  data.length_unit = document.length_unit;
  data.parameter_unit = document.parameter_unit;
  data.more = rows_of(frame, request);
  FramePictures pictures = pictures_of(frame, document);
  data.path = std::move(pictures.path);
  data.further = std::move(pictures.plots);
  if (document.path.segment_count() > 1) data.knots = document.path.knots();
  return data;
}

void run(const FrameFlags& flags) {
  if (flags.output == "-" && flags.report == "-") {
    throw Error(Fault{FaultCode::unsupported,
                      "the frames and the report cannot both go to standard output", std::nullopt,
                      "report", std::nullopt, std::nullopt});
  }
  const PathDocument document = load_document(flags.document).value();
  const MadeFrame frame = make_frame(document, flags.request);
  const auto places =
      places_of(frame, document.path, sampled_parameters(document.path, flags.plan).value());
  const std::string frames =
      format_of(flags) == "json" ? json_text(frame, flags.request, places) : csv_text(places);
  const std::string report =
      flags.report.empty() ? ""
                           : report_html(report_of(document, frame, flags.request,
                                                   flags.document == "-" ? "" : flags.document));
  OutputFile file = OutputFile::create(flags.output).value();
  file.write(frames);
  if (!flags.report.empty()) {
    if (const auto fault = write_file(flags.report, report)) throw Error(*fault);
  }
  if (const auto fault = file.commit()) throw Error(*fault);
  std::size_t width = 0;
  const auto rows = rows_of(frame, flags.request);
  for (const auto& row : rows) width = std::max(width, row.first.size());
  std::string text;
  for (const auto& [name, value] : rows) {
    text += name;
    text.append(width + 2 - name.size(), ' ');
    text += value + "\n";
  }
  if (flags.output != "-") text += "wrote " + flags.output + "\n";
  if (!flags.report.empty() && flags.report != "-") text += "wrote " + flags.report + "\n";
  if (flags.output == "-" || flags.report == "-") {
    std::fputs(text.c_str(), stderr);
  } else {
    print(text);
  }
}

Vector3<double> vector_of(const std::vector<double>& numbers) {
  return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

}  // namespace

std::unique_ptr<Command> frame_command(CLI::App& program) {
  auto flags = std::make_shared<FrameFlags>();
  auto command = std::make_unique<Command>(
      program, "frame", "An adapted frame along a path in space: rotations, rates and twist.");
  add_document_to(*command, flags->document);
  command->group("Frame");
  command
      ->option("--kind", flags->request.kind, "KIND",
               "erf, frenet, rotation-minimising (default), periodic, or least-twist")
      .one_of({frame_kinds.begin(), frame_kinds.end()});
  Option gamma = command->option(
      "--gamma", flags->gamma, "GAMMA",
      "periodic: a number other than 0, least (default: the least absolute twist), or "
      "smooth-negative or smooth-positive (rates that close, too)");
  Option begin_normal = command->option("--begin-normal", flags->begin_normal, "X,Y,Z",
                                        "rotation-minimising, least-twist: the second axis begins "
                                        "as near to this direction as can be");
  begin_normal.list(3, 3);
  Option begin = command->option("--begin-deg", flags->begin_degrees, "ANGLE",
                                 "the same as an angle from the Euler-Rodrigues frame");
  begin.excludes(begin_normal);
  Option end_normal = command->option("--end-normal", flags->end_normal, "X,Y,Z",
                                      "least-twist on an open path: where the second axis ends");
  end_normal.list(3, 3);
  Option end = command->option("--end-deg", flags->end_degrees, "ANGLE", "the same as an angle");
  end.excludes(end_normal);
  command->group("Where");
  Option count = command->option("-n,--count", flags->count, "N",
                                 "N frames evenly spaced in arc length (default 101)");
  count.whole_number(1, maximum_count);
  Option in_xi = command->option("--count-in-xi", flags->count_in_xi, "N", "evenly spaced in xi");
  in_xi.whole_number(1, maximum_count).excludes(count);
  Option per_segment = command->option("--per-segment", flags->per_segment, "N",
                                       "N on every segment, the knots included");
  per_segment.whole_number(1, maximum_count).excludes(count).excludes(in_xi);
  Option step = command->option("--step", flags->step, "S", "every S of arc length");
  step.excludes(count).excludes(in_xi).excludes(per_segment);
  constexpr int most_given = 100000;
  Option xi = command->option("--xi", flags->xi, "XI,...", "at these parameters");
  xi.list(1, most_given).excludes(count).excludes(in_xi).excludes(per_segment).excludes(step);
  command->group("Files");
  command
      ->option("--format", flags->format, "FORMAT",
               "csv or json (default: by the suffix of FILE, else csv)")
      .one_of({"csv", "json"});
  command->option("-o,--out", flags->output, "FILE", "the frames (default: standard output)");
  command->option("--report", flags->report, "FILE", "an HTML report with pictures");
  command->examples(
      {"hodograph frame loop.json -o frames.csv",
       "hodograph frame loop.json --kind periodic --gamma least --report frame.html -o "
       "frames.csv",
       "hodograph frame track.json --kind least-twist --begin-normal 0,0,1 --end-normal 0,0,1"});
  command->note(
      "A row holds xi, arc length, position, roll against the Euler-Rodrigues frame, rotation as "
      "a\n"
      "quaternion (w, x, y, z), the three axes, and the rates about them per unit arc length.\n"
      "The twist is enclosed: rounding included. See docs/frames.md.");
  command->run([flags, gamma, begin_normal, begin, end_normal, end, in_xi, per_segment, step, xi] {
    constexpr double radians = std::numbers::pi / 180.0;
    FrameRequest& request = flags->request;
    if (gamma.given()) set_gamma(request, flags->gamma);
    if (begin_normal.given()) request.begin_normal = vector_of(flags->begin_normal);
    if (begin.given()) request.begin = flags->begin_degrees * radians;
    if (end_normal.given()) request.end_normal = vector_of(flags->end_normal);
    if (end.given()) request.end = flags->end_degrees * radians;
    SamplePlan& plan = flags->plan;
    if (in_xi.given()) {
      plan.count_in_xi = flags->count_in_xi;
    } else if (per_segment.given()) {
      plan.count_per_segment = flags->per_segment;
    } else if (step.given()) {
      plan.step = flags->step;
    } else if (xi.given()) {
      plan.xi = flags->xi;
    } else {
      plan.count = flags->count;
    }
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
