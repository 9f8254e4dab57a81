// SPDX-License-Identifier: MIT
// hodograph sample: points of a path as a table.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>

#include "cli/commands.hpp"
#include "cli/options.hpp"
#include "cli/point_state.hpp"
#include "cli/sample_plan.hpp"
#include "hodograph/foundation/fault.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

struct SampleFlags {
  std::string document, output = "-", format = "csv";
  std::size_t count = 0, count_in_xi = 0, per_segment = 0;
  double step = 0.0, chord = 0.0;
  std::vector<double> xi, arc_length;
  std::vector<std::string> with;
};

constexpr std::array derivative_names = {"d1", "d2", "d3", "d4"};
constexpr std::array axis_names = {"e1", "e2", "e3"};

/// A group of columns that --with adds.
struct Quantity {
  const char* name;
  std::vector<std::string> (*titles)(std::size_t dimension);
  void (*append)(std::vector<double>& row, const PointState& state, std::size_t dimension);
};

std::vector<std::string> components(const std::string& prefix, std::size_t dimension) {
  std::vector<std::string> titles;
  for (std::size_t i = 0; i < dimension; ++i) titles.push_back(prefix + "xyz"[i]);
  return titles;
}
void append_all(std::vector<double>& row, const std::vector<double>& values) {
  row.insert(row.end(), values.begin(), values.end());
}
void append_none(std::vector<double>& row, std::size_t count) {
  row.insert(row.end(), count, none);
}

std::vector<std::string> derivative_titles(std::size_t dimension) {
  std::vector<std::string> titles;
  for (std::size_t r = 1; r <= 4; ++r) {
    for (const auto& title : components(derivative_names[r - 1], dimension))
      titles.push_back(title);
  }
  return titles;
}

const std::array quantities = {
    Quantity{"derivatives", derivative_titles,
             [](std::vector<double>& row, const PointState& state, std::size_t) {
               for (std::size_t r = 1; r <= 4; ++r) append_all(row, state.position[r]);
             }},
    Quantity{"speed", [](std::size_t) { return std::vector<std::string>{"speed"}; },
             [](std::vector<double>& row, const PointState& state, std::size_t) {
               row.push_back(state.speed[0]);
             }},
    Quantity{"preimage",
             [](std::size_t dimension) {
               return dimension == 2 ? std::vector<std::string>{"re", "im"}
                                     : std::vector<std::string>{"qw", "qx", "qy", "qz"};
             },
             [](std::vector<double>& row, const PointState& state, std::size_t) {
               append_all(row, state.preimage[0]);
             }},
    Quantity{"curvature",
             [](std::size_t dimension) {
               return dimension == 2 ? std::vector<std::string>{"curvature"}
                                     : std::vector<std::string>{"curvature", "torsion"};
             },
             [](std::vector<double>& row, const PointState& state, std::size_t dimension) {
               row.push_back(state.moves ? state.curvature : none);
               if (dimension == 3) row.push_back(state.torsion.value_or(none));
             }},
    Quantity{"frame",
             [](std::size_t dimension) {
               std::vector<std::string> titles;
               for (std::size_t axis = 1; axis <= dimension; ++axis) {
                 for (const auto& title : components(axis_names[axis - 1], dimension)) {
                   titles.push_back(title);
                 }
               }
               return titles;
             },
             [](std::vector<double>& row, const PointState& state, std::size_t dimension) {
               if (!state.moves) return append_none(row, dimension * dimension);
               for (const auto& axis : state.frame[0]) append_all(row, axis);
             }},
    Quantity{"rates",
             [](std::size_t dimension) {
               return dimension == 2 ? std::vector<std::string>{"chi"}
                                     : std::vector<std::string>{"chi1", "chi2", "chi3"};
             },
             [](std::vector<double>& row, const PointState& state, std::size_t dimension) {
               if (!state.moves) return append_none(row, dimension == 2 ? 1 : 3);
               append_all(row, state.rates.body_per_xi[0]);
             }},
};

std::vector<const Quantity*> chosen(const std::vector<std::string>& names) {
  std::vector<const Quantity*> result;
  for (const Quantity& quantity : quantities) {
    for (const std::string& name : names) {
      if (name == quantity.name) {
        result.push_back(&quantity);
        break;
      }
    }
  }
  return result;
}

SamplePlan plan_of(const SampleFlags& flags) {
  constexpr std::size_t default_count = 101;
  SamplePlan plan;
  if (flags.count_in_xi > 0) {
    plan.count_in_xi = flags.count_in_xi;
  } else if (flags.per_segment > 0) {
    plan.count_per_segment = flags.per_segment;
  } else if (flags.step != 0.0) {
    plan.step = flags.step;
  } else if (flags.chord != 0.0) {
    plan.chord_tolerance = flags.chord;
  } else if (!flags.xi.empty()) {
    plan.xi = flags.xi;
  } else if (!flags.arc_length.empty()) {
    plan.arc_length = flags.arc_length;
  } else {
    plan.count = flags.count == 0 ? default_count : flags.count;
  }
  return plan;
}

/// Writes rows as CSV, or as a JSON object of "columns" and "rows"; what does not exist is an empty
/// field or null.
class RowWriter {
 public:
  RowWriter(OutputFile& file, const std::vector<std::string>& titles, bool json)
      : file_(file), json_(json) {
    if (json_) {
      text_ = "{\"columns\": [";
      for (std::size_t i = 0; i < titles.size(); ++i) {
        text_ += (i == 0 ? "\"" : ", \"") + titles[i] + "\"";
      }
      text_ += "],\n \"rows\": [";
    } else {
      append_csv_header(text_, titles);
    }
  }
  void row(const std::vector<double>& values) {
    if (json_) text_ += first_ ? "\n  [" : ",\n  [";
    first_ = false;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (i > 0) text_ += json_ ? ", " : ",";
      if (std::isfinite(values[i])) {
        text_ += to_text(values[i]);
      } else if (json_) {
        text_ += "null";
      }
    }
    text_ += json_ ? "]" : "\n";
    constexpr std::size_t enough = std::size_t{1} << 16U;
    if (text_.size() > enough) {
      file_.write(text_);
      text_.clear();
    }
  }
  void finish() {
    if (json_) text_ += "\n]}\n";
    file_.write(text_);
    if (const auto fault = file_.commit()) throw Error(*fault);
  }

 private:
  OutputFile& file_;
  bool json_, first_ = true;
  std::string text_;
};

void run(const SampleFlags& flags) {
  const PathDocument document = load_document(flags.document).value();
  const AnyPath& path = document.path;
  const auto parameters = sampled_parameters(path, plan_of(flags)).value();
  const std::vector<const Quantity*> extra = chosen(flags.with);

  const std::size_t dimension = path.dimension();
  std::vector<std::string> titles = {"xi", "s"};
  for (const auto& title : components("", dimension)) titles.push_back(title);
  for (const Quantity* quantity : extra) {
    for (const auto& title : quantity->titles(dimension)) titles.push_back(title);
  }

  OutputFile file = OutputFile::create(flags.output).value();
  RowWriter writer(file, titles, flags.format == "json");
  std::vector<double> row, point(dimension);
  for (const double xi : parameters) {
    row.assign({xi, path.arc_length(xi)});
    if (extra.empty()) {
      path.position(xi, point);
      append_all(row, point);
    } else {
      const PointState state = state_at(path, xi, document.roll);
      append_all(row, state.position[0]);
      for (const Quantity* quantity : extra) quantity->append(row, state, dimension);
    }
    writer.row(row);
  }
  writer.finish();
}

}  // namespace

std::unique_ptr<Command> sample_command(CLI::App& program) {
  auto flags = std::make_shared<SampleFlags>();
  auto command = std::make_unique<Command>(
      program, "sample", "Write points of a path, with its frame if wanted, as CSV or JSON.");
  add_document_to(*command, flags->document);
  command->group("Where (one of)");
  std::vector<Option> where;
  where.push_back(command->option("-n,--count", flags->count, "N",
                                  "N points, evenly spaced in arc length (default 101)"));
  where.push_back(
      command->option("--count-xi", flags->count_in_xi, "N", "N points, evenly spaced in xi"));
  where.push_back(command->option("--per-segment", flags->per_segment, "N",
                                  "N intervals in every segment, knots included"));
  for (Option& count : where) count.whole_number(1, maximum_count);
  where.push_back(
      command->option("--step", flags->step, "S", "a point every S of arc length, and the end"));
  where.push_back(
      command->option("--chord", flags->chord, "E",
                      "as many points as keep the polyline through them within E of the path"));
  where.push_back(command->option("--xi", flags->xi, "XI,...", "at these parameters"));
  where.push_back(
      command->option("--arc-length", flags->arc_length, "S,...", "at these arc lengths"));
  constexpr int most_items = 1 << 20;
  for (std::size_t i = where.size() - 2; i < where.size(); ++i) where[i].list(1, most_items);
  for (std::size_t i = 0; i < where.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) where[i].excludes(where[j]);
  }
  command->group("What");
  std::vector<std::string> names;
  std::string listed;
  for (const Quantity& quantity : quantities) {
    names.emplace_back(quantity.name);
    listed += std::string(listed.empty() ? "" : ", ") + quantity.name;
  }
  command->option("--with", flags->with, "NAME,...", "more columns: " + listed)
      .list(1, static_cast<int>(names.size()))
      .one_of(names);
  command->option("--format", flags->format, "FORMAT", "csv (default) or json")
      .one_of({"csv", "json"});
  command->group("Files");
  command->option("-o,--out", flags->output, "FILE", "the table (default: standard output)");
  command->examples({"hodograph sample gateway.json --count 1000 -o points.csv",
                     "hodograph sample gateway.json --step 0.01 --with frame,curvature",
                     "hodograph sample gateway.json --xi 0,0.5,1.25 --format json"});
  command->run([flags, where] {
    if (where[3].given() && !(flags->step > 0.0)) {
      throw Error(Fault{FaultCode::outside_domain,
                        "the step is " + to_text(flags->step) + "; it should be positive",
                        std::nullopt, "step", flags->step, 0.0});
    }
    run(*flags);
  });
  return command;
}

}  // namespace hodograph::cli
