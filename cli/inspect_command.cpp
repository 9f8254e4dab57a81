// SPDX-License-Identifier: MIT
// hodograph inspect: what a path is and what its document promises.
#include <algorithm>
#include <array>
#include <cstdio>
#include <limits>
#include <memory>
#include <utility>

#include "cli/commands.hpp"
#include "cli/json.hpp"
#include "cli/options.hpp"
#include "cli/planar_facts.hpp"
#include "cli/point_state.hpp"
#include "cli/spatial_facts.hpp"
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

/// "3, at xi 0.25, 0.5, 0.75": the first few alone where there are many.
template <class Place, class Text>
std::string listed(const std::vector<Place>& places, const Text& text_of_place) {
  constexpr std::size_t most_listed = 6;
  std::string text = std::to_string(places.size());
  for (std::size_t i = 0; i < std::min(places.size(), most_listed); ++i) {
    text += (i == 0 ? ", at xi " : ", ") + text_of_place(places[i]);
  }
  return text + (places.size() > most_listed ? ", ..." : "");
}
std::string shortened(double xi) {
  std::array<char, 32> number{};
  std::snprintf(number.data(), number.size(), "%.6g", xi);
  return number.data();
}
std::string listed(const std::vector<CurvaturePlace>& places) {
  return listed(places, [](const CurvaturePlace& place) { return shortened(place.xi); });
}
std::string listed(const std::vector<PathIntersection>& places) {
  return listed(places, [](const PathIntersection& at) {
    return shortened(at.xi_first) + " and " + shortened(at.xi_second) +
           (at.kind == IntersectionKind::undecided ? " (undecided)" : "");
  });
}

std::string limit(const Enclosure& distance, const char* side) {
  return distance.lower() == std::numeric_limits<double>::max()
             ? std::string("any to the ") + side
             : to_text(distance.lower()) + " to the " + side;
}

/// Where an extreme value of the curvature is reached: ", at xi 0.5"; nothing where that is not
/// found.
std::string place_of(const Enclosure& extreme, const PlanarFacts& facts, const AnyPath& path) {
  const auto at = [](double xi) {
    std::array<char, 32> number{};
    std::snprintf(number.data(), number.size(), "%.6g", xi);
    return std::string(", at xi ") + number.data();
  };
  for (const CurvaturePlace& place : facts.curvature_extremes) {
    if (place.curvature.lower() <= extreme.upper() && extreme.lower() <= place.curvature.upper()) {
      return at(place.xi);
    }
  }
  constexpr std::size_t most_tried = 2000;  // knots; more would cost more than they tell
  if (path.segment_count() > most_tried) return "";
  // Computed curvatures carry some roundings.
  constexpr double roundings = 4096 * std::numeric_limits<double>::epsilon();
  const double allowed = roundings * extreme.magnitude();
  for (const double xi : path.knots()) {
    const double curvature = state_at(path, xi).curvature;
    if (extreme.lower() - allowed <= curvature && curvature <= extreme.upper() + allowed) {
      return at(xi);
    }
  }
  return "";
}

/// What is known of a path in the plane alone.
Rows rows_of(const PlanarFacts& facts, const AnyPath& path, const std::string& unit) {
  const std::string area_unit = unit.empty() ? "" : unit + "^2";
  Rows rows;
  rows.emplace_back("rotation index in", range(facts.rotation_index) + " rad");
  rows.emplace_back("absolute rotation in", range(facts.absolute_rotation_index) + " rad");
  rows.emplace_back("bending energy in", facts.bending_energy
                                             ? range(*facts.bending_energy)
                                             : std::string("no bound: the path may stand still"));
  if (path.is_closed())
    rows.emplace_back("signed area in", with_unit(range(facts.signed_area), area_unit));
  rows.emplace_back("smallest curvature in", range(facts.smallest_curvature) +
                                                 place_of(facts.smallest_curvature, facts, path));
  rows.emplace_back("largest curvature in", range(facts.largest_curvature) +
                                                place_of(facts.largest_curvature, facts, path));
  rows.emplace_back("curvature extremes", listed(facts.curvature_extremes));
  rows.emplace_back("inflections", listed(facts.inflections));
  rows.emplace_back("meets itself", listed(facts.self_intersections));
  rows.emplace_back("offsets without cusp", limit(facts.offset_limit_left, "left") + ", " +
                                                limit(facts.offset_limit_right, "right"));
  return rows;
}

/// What is known of a path in space alone.
Rows rows_of(const SpatialFacts& facts, const std::string& unit) {
  const std::string per_unit = unit.empty() ? "" : "1/" + unit;
  Rows rows;
  if (facts.bending_energy) {
    rows.emplace_back("bending energy in", with_unit(range(*facts.bending_energy), per_unit));
  }
  if (facts.smallest_torsion) {
    rows.emplace_back("smallest torsion in", with_unit(range(*facts.smallest_torsion), per_unit));
    rows.emplace_back("largest torsion in", with_unit(range(*facts.largest_torsion), per_unit));
  }
  return rows;
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
  if (const auto planar = planar_facts_of(path)) {
    for (auto& row : rows_of(*planar, path, unit)) rows.push_back(std::move(row));
  }
  if (const auto spatial = spatial_facts_of(path)) {
    for (auto& row : rows_of(*spatial, unit)) rows.push_back(std::move(row));
  }
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
  Json json = json_of(document, facts);
  if (const auto planar = planar_facts_of(document.path)) json["planar"] = json_of(*planar);
  if (const auto spatial = spatial_facts_of(document.path)) json["spatial"] = json_of(*spatial);
  append_json(out, json);
  print(out + "\n");
}

}  // namespace

std::unique_ptr<Command> inspect_command(CLI::App& program) {
  auto flags = std::make_shared<InspectFlags>();
  auto command = std::make_unique<Command>(
      program, "inspect",
      "Tell what a path is, computed from its numbers, and what its document promises.");
  add_document_to(*command, flags->document);
  command->flag("--json", flags->json, "as one line of JSON");
  command->examples({"hodograph inspect gateway.json", "hodograph inspect gateway.json --json"});
  command->run([flags] { run(*flags); });
  return command;
}

}  // namespace hodograph::cli
