// SPDX-License-Identifier: MIT
// hodograph offset: the offset curves of a planar path.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/offsets.hpp"
#include "cli/options.hpp"
#include "cli/planar_drawing.hpp"
#include "cli/sample_plan.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

struct OffsetFlags {
  std::string document, output = "-", format;
  std::vector<double> distances;
  std::size_t count = 101;
  bool count_given = false;
};

const std::vector<std::string> formats = {"svg", "dxf", "csv", "json"};

/// The format that was asked for, or that the suffix of the file names. Throws Error.
std::string format_of(const OffsetFlags& flags) {
  if (!flags.format.empty()) return flags.format;
  std::string suffix = std::filesystem::path(flags.output).extension().string();
  if (!suffix.empty()) suffix.erase(0, 1);
  for (char& c : suffix) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  if (std::find(formats.begin(), formats.end(), suffix) != formats.end()) return suffix;
  throw Error(Fault{FaultCode::unsupported,
                    (flags.output == "-" ? std::string("standard output")
                                         : "the name " + on_one_line(flags.output)) +
                        " does not tell the format; end the name of the file with .svg, .dxf, .csv "
                        "or .json, or use --format",
                    std::nullopt, "format", std::nullopt, std::nullopt});
}

std::string svg_text(const PathDocument& document, const std::vector<PathOffset>& offsets) {
  return to_svg(offset_picture(document, offsets));
}

std::string dxf_text(const PathDocument& document, const std::vector<PathOffset>& offsets) {
  constexpr int red = 1, colors = 6;  // of AutoCAD's index: red, yellow, green, cyan, blue, magenta
  std::vector<DxfCurves> layers;
  int color = red;
  for (const PathOffset& offset : offsets) {
    layers.push_back({"offset " + to_text(offset.distance), color, offset.pieces});
    color = color % colors + 1;
  }
  return to_dxf(layers, dxf_unit(document.length_unit)).value();
}

std::string csv_text(const PathDocument& document, const OffsetFlags& flags) {
  SamplePlan plan;
  plan.count = flags.count;
  const std::vector<double> places = sampled_parameters(document.path, plan).value();
  std::string text;
  append_csv_header(text, std::vector<std::string>{"distance", "xi", "x", "y"});
  for (const double distance : flags.distances) {
    const auto points = offset_points(document.path, distance, places);
    for (std::size_t i = 0; i < points.size(); ++i) {
      append_csv_row(text, std::vector<double>{distance, places[i], points[i].x, points[i].y});
    }
  }
  return text;
}

std::string json_text(const std::vector<PathOffset>& offsets, const CuspFreeOffsets& limits) {
  Json json;
  json["cusp_free_offsets"] = {{"left", json_of(limits.left)}, {"right", json_of(limits.right)}};
  Json& list = json["offsets"] = Json::array();
  for (const PathOffset& offset : offsets) {
    Json one = {{"distance", offset.distance}};
    one.update(json_of(offset));
    list.push_back(std::move(one));
  }
  std::string text;
  append_json(text, json);
  return text + "\n";
}

/// One line an offset: its distance, degree, number of pieces and cusps.
std::string table_of(const std::vector<PathOffset>& offsets, const CuspFreeOffsets& limits) {
  constexpr std::size_t most_listed = 6;
  std::string text = "Distance    Degree  Pieces   Cusps\n";
  for (const PathOffset& offset : offsets) {
    char line[96];
    std::snprintf(line, sizeof line, "%-10.6g  %-6zu  %-7zu  ", offset.distance, offset.degree,
                  offset.pieces.size());
    text += line;
    if (offset.cusps.empty()) {
      text += "none\n";
      continue;
    }
    text += std::to_string(offset.cusps.size()) + ", at xi";
    for (std::size_t i = 0; i < std::min(offset.cusps.size(), most_listed); ++i) {
      std::snprintf(line, sizeof line, "%s %.6g", i == 0 ? "" : ",", offset.cusps[i].xi);
      text += line;
      if (offset.cusps[i].kind != RootKind::simple) text += " (undecided)";
    }
    text += offset.cusps.size() > most_listed ? ", ...\n" : "\n";
  }
  const auto limit = [](const Enclosure& one, const char* side) {
    return (one.lower() == std::numeric_limits<double>::max() ? "at any distance"
                                                              : "below " + to_text(one.lower())) +
           " to the " + side;
  };
  return text + "No cusps, certified, " + limit(limits.left, "left") + " and " +
         limit(limits.right, "right") + "\n";
}

void run(const OffsetFlags& flags) {
  require_distances(flags.distances);
  const std::string format = format_of(flags);
  if (flags.count_given && format != "csv") {
    throw Error(Fault{FaultCode::unsupported,
                      "--count is the number of points in the format csv; the format is " + format,
                      std::nullopt, "count", std::nullopt, std::nullopt});
  }
  const PathDocument document = load_document(flags.document).value();
  const CuspFreeOffsets limits = cusp_free_offsets_of(document.path);
  OutputFile file = OutputFile::create(flags.output).value();
  std::vector<PathOffset> offsets;
  for (const double distance : flags.distances) {
    offsets.push_back(offset_of(document.path, distance));
  }
  file.write(format == "svg"   ? svg_text(document, offsets)
             : format == "dxf" ? dxf_text(document, offsets)
             : format == "csv" ? csv_text(document, flags)
                               : json_text(offsets, limits));
  if (const auto fault = file.commit()) throw Error(*fault);
  const std::string table = table_of(offsets, limits);
  if (flags.output == "-") {
    std::fputs(table.c_str(), stderr);
  } else {
    print(table + "wrote " + flags.output + "\n");
  }
}

}  // namespace

std::unique_ptr<Command> offset_command(CLI::App& program) {
  auto flags = std::make_shared<OffsetFlags>();
  auto command = std::make_unique<Command>(
      program, "offset", "The exact offset curves of a path in the plane, with their cusps.");
  add_document_to(*command, flags->document);
  command->group("Offsets");
  constexpr int most_offsets = 1000;
  command
      ->option("-d,--distance", flags->distances, "D,...",
               "distances, positive to the left of the path, negative to the right")
      .list(1, most_offsets)
      .required();
  Option count = command->option(
      "-n,--count", flags->count, "N",
      "csv: N points on each, evenly spaced in the path's arc length (default 101)");
  count.whole_number(1, maximum_count);
  command->group("Files");
  command
      ->option("--format", flags->format, "FORMAT",
               "svg: a picture; dxf: exact rational splines for CAD; csv: points; json: exact "
               "control points and weights (default: by the suffix of FILE)")
      .one_of(formats);
  command->option("-o,--out", flags->output, "FILE", "where they go (default: standard output)");
  command->examples({"hodograph offset path.json -d 0.05,-0.05 -o offsets.dxf",
                     "hodograph offset path.json -d 0.1 -o offsets.svg",
                     "hodograph offset path.json -d 0.1 --format csv --count 1000"});
  command->note(
      "An offset has a cusp where its distance is the radius of curvature. Offsets are neither\n"
      "trimmed where they cross themselves nor joined at corners. Some programs read splines of\n"
      "limited degree alone; that of a quintic's offset is 9.");
  command->run([flags, count] {
    flags->count_given = count.given();
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
