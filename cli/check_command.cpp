// SPDX-License-Identifier: MIT
// hodograph check: computes every promise of a document again, and fails on the first that does not
// hold.
#include <cmath>
#include <memory>

#include "cli/commands.hpp"
#include "cli/fitting.hpp"
#include "cli/options.hpp"
#include "cli/path_facts.hpp"
#include "cli/plans.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/geojson.hpp"
#include "hodograph/path/helix.hpp"

namespace hodograph::cli {
namespace {

struct CheckFlags {
  std::string document, world, samples;
  std::size_t degree = 5;
  bool periodic = false;
};

/// Collects what was checked; a promise that does not hold leaves as Error.
class Checks {
 public:
  void hold(const std::string& what, const std::string& how) {
    text_ += "ok       " + what + ": " + how + "\n";
  }
  void skip(const std::string& what, const std::string& why) {
    text_ += "skipped  " + what + ": " + why + "\n";
  }
  [[noreturn]] static void broken(const std::string& what, const std::string& why, double value,
                                  double bound) {
    throw Error(Fault{FaultCode::broken_promise, "broken promise: " + what + ": " + why,
                      std::nullopt, what, value, bound});
  }
  const std::string& text() const { return text_; }

 private:
  std::string text_;
};

void check_identity(Checks& checks, const PathFacts& facts) {
  if (!(facts.hodograph_identity <= 1.0)) {
    Checks::broken("hodograph",
                   "|r'|^2 and the squared speed differ by " + to_text(facts.hodograph_identity) +
                       " times the rounding",
                   facts.hodograph_identity, 1.0);
  }
  checks.hold("hodograph", "|r'| is the speed polynomial, in every segment");
}

void check_order(const char* name, int promised, int found, const std::vector<JumpFact>& jumps) {
  if (promised <= found) return;
  const auto r = static_cast<std::size_t>(found + 1);
  if (r >= jumps.size()) {
    Checks::broken(std::string("continuity of the ") + name,
                   std::string("C") + std::to_string(promised) + " is promised, orders up to " +
                       std::to_string(found) + " are looked at",
                   promised, found);
  }
  Checks::broken(std::string("continuity of the ") + name,
                 std::string("C") + std::to_string(promised) + " is promised, but derivative " +
                     std::to_string(r) + " jumps at knot " + std::to_string(jumps[r].knot) +
                     " by " + to_text(jumps[r].jump) + " in relative terms, where " +
                     to_text(jumps[r].allowed) + " is rounding",
                 promised, found);
}

void check_continuity(Checks& checks, const ContinuityOrders& promised, const PathFacts& facts) {
  const ContinuityOrders& found = facts.continuity;
  check_order("position", promised.position, found.position, facts.position);
  check_order("preimage", promised.preimage, found.preimage, facts.preimage);
  check_order("frame", promised.frame, found.frame, facts.frame);
  check_order("angular velocity", promised.angular_velocity, found.angular_velocity,
              facts.angular_velocity);
  checks.hold("continuity", "position C" + std::to_string(promised.position) + ", preimage C" +
                                std::to_string(promised.preimage) + ", frame C" +
                                std::to_string(promised.frame) + ", angular velocity C" +
                                std::to_string(promised.angular_velocity) + " at the least");
}

std::string range_text(const Enclosure& bound) {
  return std::string("[") + to_text(bound.lower()) + ", " + to_text(bound.upper()) + "]";
}

/// A promised enclosure holds when it contains the one that is computed again.
void check_bound(Checks& checks, const char* name, const Enclosure& promised,
                 const Enclosure& found) {
  if (!(promised.lower() <= found.lower())) {
    Checks::broken(name,
                   std::string("at least ") + to_text(promised.lower()) + " is promised, " +
                       to_text(found.lower()) + " can be shown",
                   promised.lower(), found.lower());
  }
  if (!(found.upper() <= promised.upper())) {
    Checks::broken(name,
                   std::string("at most ") + to_text(promised.upper()) + " is promised, " +
                       to_text(found.upper()) + " can be shown",
                   promised.upper(), found.upper());
  }
  checks.hold(name, "in " + range_text(promised));
}

std::optional<Source> source_of(const CheckFlags& flags, const PathDocument& document) {
  if (flags.samples.empty()) return named_source(document.provenance.source);
  const Table table = read_table(read_file(flags.samples).value(), flags.samples).value();
  return SampleSource{curve_samples(table, {}, flags.samples).value(), flags.samples, flags.degree,
                      flags.periodic};
}

void check_error(Checks& checks, const CheckFlags& flags, const PathDocument& document) {
  const ErrorPromise& promised = *document.promises.error;
  const auto source = source_of(flags, document);
  if (!source) {
    checks.skip("error", document.provenance.source.empty()
                             ? "the document does not name what the path stands for"
                             : "the samples are not in the document; give them with --samples");
    return;
  }
  const ErrorBound found = error_against(*source, document.path).value();
  if (promised.certified && !found.certified) {
    Checks::broken("error", "a certificate is promised, and none can be given", 1.0, 0.0);
  }
  check_bound(checks, promised.certified ? "error (certified)" : "error (estimate)",
              promised.distance, found.error);
}

/// The clearance from a world, and the largest curvature as plans promise it.
void check_world(Checks& checks, const CheckFlags& flags, const PathDocument& document) {
  const Promises& promises = document.promises;
  if (flags.world.empty()) {
    if (promises.clearance) {
      checks.skip("clearance", "the obstacles are not in the document; give the world" +
                                   (promises.clearance->world.empty()
                                        ? std::string()
                                        : ", " + on_one_line(promises.clearance->world)));
    }
    return;
  }
  if (!promises.clearance) {
    Checks::broken("clearance", "the document promises none", 0.0, 0.0);
  }
  const ClearanceIndex index(load_world(flags.world).value().world);
  const ClearancePromise found =
      promise_of(clearance_of(document.path, index, promises.clearance->reach), flags.world);
  const auto name = [&](std::uint32_t obstacle) {
    return "clearance from " + index.world().name_of(obstacle);
  };
  auto promised = promises.clearance->obstacles.begin();
  const auto end = promises.clearance->obstacles.end();
  for (const ObstacleDistance& near : found.obstacles) {
    const auto obstacle = static_cast<std::uint32_t>(near.obstacle);
    if (promised == end || promised->obstacle > near.obstacle) {
      Checks::broken(name(obstacle),
                     std::string("at least ") + to_text(found.reach) + " is promised, " +
                         to_text(near.distance.lower()) + " can be shown",
                     found.reach, near.distance.lower());
    }
    if (promised->obstacle < near.obstacle) break;
    check_bound(checks, name(obstacle).c_str(), promised->distance, near.distance);
    ++promised;
  }
  if (promised != end) {
    Checks::broken("clearance",
                   "obstacle " + std::to_string(promised->obstacle) +
                       " is listed, but the path does not come within " + to_text(found.reach) +
                       " of it",
                   static_cast<double>(promised->obstacle), found.reach);
  }
  if (found.bounds.has_value() != promises.clearance->bounds.has_value()) {
    Checks::broken("clearance from the bounds",
                   found.bounds ? "none is promised, and the path comes near them"
                                : "one is promised, and the path does not come near any",
                   0.0, found.reach);
  }
  if (found.bounds) {
    check_bound(checks, "clearance from the bounds", *promises.clearance->bounds, *found.bounds);
  }
  checks.hold("clearance", "at least " + to_text(found.reach) + " from everything else");
}

/// The climb angles along an axis.
void check_helix(Checks& checks, const PathDocument& document) {
  const HelixPromise& promised = *document.promises.helix;
  const PathNumbers numbers = document.path.numbers();
  for (std::size_t i = 0; i < promised.sines.size(); ++i) {
    const std::size_t first = promised.sines[i].first_segment;
    const std::size_t last = i + 1 < promised.sines.size() ? promised.sines[i + 1].first_segment - 1
                                                           : document.path.segment_count() - 1;
    const std::string where = promised.sines.size() == 1 ? ""
                                                         : ", segments " + std::to_string(first) +
                                                               " to " + std::to_string(last);
    check_bound(checks, ("sine of the climb angle" + where).c_str(), promised.sines[i].sine,
                sine_range(numbers, promised.axis, first, last));
  }
}

void run(const CheckFlags& flags) {
  const PathDocument document = load_document(flags.document).value();
  const PathFacts facts = facts_of(document.path);
  const Promises& promises = document.promises;
  Checks checks;
  checks.hold("path", std::to_string(document.path.segment_count()) +
                          " segments on increasing knots, joined without a gap");
  check_identity(checks, facts);
  if (promises.continuity) check_continuity(checks, *promises.continuity, facts);
  if (promises.arc_length)
    check_bound(checks, "arc length", *promises.arc_length, facts.arc_length);
  if (promises.smallest_speed) {
    check_bound(checks, "smallest speed", *promises.smallest_speed, facts.smallest_speed);
  }
  if (promises.largest_speed) {
    check_bound(checks, "largest speed", *promises.largest_speed, facts.largest_speed);
  }
  if (promises.end) {
    const Vector3<double> off = facts.end - *promises.end;
    if (!(largest_component(off) <= facts.end_rounding)) {
      Checks::broken("end",
                     "the path ends " + to_text(norm(off)) + " from the point that is promised, " +
                         to_text(facts.end_rounding) + " is rounding",
                     norm(off), facts.end_rounding);
    }
    checks.hold("end", "where it is promised");
  }
  if (promises.curvature_bound) {
    if (!(facts.curvature_bound <= *promises.curvature_bound)) {
      Checks::broken("curvature",
                     std::string("at most ") + to_text(*promises.curvature_bound) +
                         " is promised, " + to_text(facts.curvature_bound) + " can be shown",
                     *promises.curvature_bound, facts.curvature_bound);
    }
    checks.hold("curvature", std::string("at most ") + to_text(*promises.curvature_bound));
  }
  if (promises.largest_curvature) {
    check_bound(checks, "largest curvature", *promises.largest_curvature,
                largest_curvature(document.path));
  }
  if (promises.helix) check_helix(checks, document);
  check_world(checks, flags, document);
  if (promises.error) check_error(checks, flags, document);
  print(checks.text());
}

}  // namespace

std::unique_ptr<Command> check_command(CLI::App& program) {
  auto flags = std::make_shared<CheckFlags>();
  auto command = std::make_unique<Command>(
      program, "check", "Compute every promise of a path document again; exit 2 if one is broken.");
  add_document_to(*command, flags->document);
  command->positional("world", flags->world, "[WORLD]",
                      "the GeoJSON file of the obstacles, for the clearance of a plan");
  command->group("Error against samples");
  const Option samples = command->option("--samples", flags->samples, "FILE",
                                         "the samples that the path was fitted to");
  command->option("--degree", flags->degree, "P", "of the spline through them: 5 (default) or 7")
      .needs(samples);
  command->flag("--periodic", flags->periodic, "the samples are periodic").needs(samples);
  command->examples({"hodograph check gateway.json", "hodograph check plan.json harbour.geojson",
                     "hodograph check track.json --samples track.csv"});
  command->note(
      "The error against a formula or an orbit that the document names is computed again, too;\n"
      "samples are not in the document and have to be given.");
  command->run([flags] { run(*flags); });
  return command;
}

}  // namespace hodograph::cli
