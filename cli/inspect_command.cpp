// SPDX-License-Identifier: MIT
// hodograph inspect: what a path is and what its document promises.
#include <algorithm>
#include <memory>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/options.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/document.hpp"

namespace hodograph::cli {
namespace {

struct InspectFlags {
  std::string document;
  bool json = false;
};

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string with_unit(const std::string& text, const std::string& unit) {
  return unit.empty() ? text : text + " " + unit;
}
std::string range(const Enclosure& bound) {
  return std::string("[") + to_text(bound.lower()) + ", " + to_text(bound.upper()) + "]";
}
std::string orders(const ContinuityOrders& continuity) {
  const auto order = [](int r) {
    return r < 0 ? std::string("jumps") : std::string("C") + std::to_string(r);
  };
  return "position " + order(continuity.position) + ", preimage " + order(continuity.preimage) +
         ", frame " + order(continuity.frame) + ", angular velocity " +
         order(continuity.angular_velocity);
}

std::string text_of(const Rows& rows) {
  std::size_t width = 0;
  for (const auto& [name, text] : rows) width = std::max(width, name.size());
  std::string out;
  for (const auto& [name, text] : rows) {
    out += name;
    if (!text.empty()) out.append(width - name.size() + 2, ' ').append(text);
    out += '\n';
  }
  return out;
}

Rows rows_of(const PathDocument& document, const PathFacts& facts) {
  const AnyPath& path = document.path;
  const std::string& unit = document.length_unit;
  Rows rows;
  if (!document.name.empty()) rows.emplace_back("name", on_one_line(document.name));
  rows.emplace_back("path", std::string(path.is_closed() ? "closed" : "open") + ", " +
                                (path.dimension() == 2 ? "in the plane" : "in space") +
                                ", degree " + std::to_string(path.degree()) + " (preimage " +
                                std::to_string(path.preimage_degree()) + ")");
  rows.emplace_back("segments", std::to_string(path.segment_count()));
  rows.emplace_back("xi", with_unit(to_text(path.xi_begin()) + " to " + to_text(path.xi_end()),
                                    document.parameter_unit));
  rows.emplace_back("length", with_unit(to_text(path.arc_length()), unit));
  rows.emplace_back("smallest speed in", range(facts.smallest_speed));
  rows.emplace_back("largest speed in", range(facts.largest_speed));
  rows.emplace_back("curvature at most", to_text(facts.curvature_bound));
  rows.emplace_back("continuity", orders(facts.continuity));
  if (facts.holonomy) {
    rows.emplace_back("frame after one round",
                      "rolled by " + to_text(facts.holonomy->roll) + " rad" +
                          (facts.antiperiodic ? ", preimage negated" : ""));
  }
  if (document.roll) {
    rows.emplace_back("roll of the frame", to_text(document.roll->rate) + " rad per unit of xi");
  }
  const Provenance& from = document.provenance;
  if (!from.source.empty()) rows.emplace_back("fitted to", on_one_line(from.source));
  if (!from.method.empty()) {
    rows.emplace_back(
        "method",
        on_one_line(from.choice.empty() ? from.method : from.method + ", " + from.choice));
  }
  if (from.tolerance) rows.emplace_back("tolerance", with_unit(to_text(*from.tolerance), unit));

  const Promises& promises = document.promises;
  if (promises.empty()) {
    rows.emplace_back("promises", "none");
    return rows;
  }
  rows.emplace_back("promises:", "");
  if (promises.error) {
    rows.emplace_back("  error in",
                      range(promises.error->distance) +
                          (promises.error->certified ? ", certified" : ", an estimate") +
                          (promises.error->against.empty()
                               ? std::string()
                               : ", against " + on_one_line(promises.error->against)));
  }
  if (promises.continuity) rows.emplace_back("  continuity", orders(*promises.continuity));
  if (promises.arc_length) rows.emplace_back("  length in", range(*promises.arc_length));
  if (promises.smallest_speed)
    rows.emplace_back("  smallest speed in", range(*promises.smallest_speed));
  if (promises.largest_speed)
    rows.emplace_back("  largest speed in", range(*promises.largest_speed));
  if (promises.curvature_bound) {
    rows.emplace_back("  curvature at most", to_text(*promises.curvature_bound));
  }
  return rows;
}

void run(const InspectFlags& flags) {
  const PathDocument document = load_document(flags.document).value();
  const PathFacts facts = facts_of(document.path);
  if (!flags.json) return print(text_of(rows_of(document, facts)));
  std::string out;
  append_json(out, json_of(document, facts));
  print(out + "\n");
}

}  // namespace

std::unique_ptr<Command> inspect_command(CLI::App& program) {
  auto flags = std::make_shared<InspectFlags>();
  auto command = std::make_unique<Command>(
      program, "inspect",
      "Tell what a path is, computed from its numbers, and what its document promises.");
  command
      ->positional("document", flags->document, "FILE", "the path document ('-': standard input)")
      .required();
  command->flag("--json", flags->json, "as one line of JSON");
  command->examples({"hodograph inspect gateway.json", "hodograph inspect gateway.json --json"});
  command->run([flags] { run(*flags); });
  return command;
}

}  // namespace hodograph::cli
