// SPDX-License-Identifier: MIT
#include "cli/loops.hpp"
#include "cli/refuse.hpp"

#include <cmath>
#include <limits>

namespace hodograph::cli {
namespace {

/// An enclosure as people read it: its middle, or "unbounded".
std::string text_of(const Enclosure& e) {
  return e.is_bounded() ? to_six_digits(e.middle()) : "unbounded";
}
std::string range_of(const Extremes& e) {
  if (!e.range().is_bounded()) return "unbounded";
  return to_six_digits(e.minimum.middle()) + " to " + to_six_digits(e.maximum.middle());
}

LoopPlacement placement_of(const LoopRequest& request) {
  LoopPlacement placement{request.length, request.start, {}};
  if (!request.normal) {
    placement.frame = level_frame(request.direction, request.roll).value();
    return placement;
  }
  const auto frame = frame_towards(request.direction, *request.normal).value();
  placement.frame =
      frame * Roll<double>{std::cos(0.5 * request.roll), std::sin(0.5 * request.roll)};
  return placement;
}

/// The wish, where there is one: a purpose, or a box alone, in which energy is least.
std::optional<LoopWish> wish_of(const LoopRequest& request) {
  const bool wished = request.purpose || request.within || request.free_roll || request.largest_xi;
  if (!wished) return std::nullopt;
  LoopWish wish;
  const std::string purpose = request.purpose.value_or("least-energy");
  if (purpose == "near") {
    wish.purpose = LoopPurpose::near_point;
    if (!request.point) refuse("a loop near a point needs the point", "point");
    wish.point = *request.point;
  } else if (purpose == "extents") {
    wish.purpose = LoopPurpose::extents;
    if (!request.extents) refuse("a loop of given extents needs the three sides", "extents");
    wish.extents = *request.extents;
  } else if (purpose == "least-torsion") {
    wish.purpose = LoopPurpose::least_torsion_range;
  } else if (purpose != "least-energy") {
    refuse("\"" + purpose +
               "\" is no purpose of a loop; there are least-energy, least-torsion, "
               "near and extents",
           "for");
  }
  if (request.limit) {
    refuse("limit members stand still at their start: there is nothing to choose among them",
           "limit");
  }
  wish.within = request.within;
  wish.xi = request.xi;
  wish.psi = request.psi;
  wish.free_roll = request.free_roll;
  wish.largest_xi = request.largest_xi.value_or(wish.largest_xi);
  return wish;
}

const char* told(TubeLimit limit) {
  switch (limit) {
    case TubeLimit::curvature:
      return "where it is most curved";
    case TubeLimit::distance:
      return "where it comes close to itself";
    case TubeLimit::corner:
      return "at a corner";
    case TubeLimit::standstill:
      return "where it stands still";
  }
  return "";
}

const char* value_name(LoopPurpose purpose) {
  switch (purpose) {
    case LoopPurpose::least_energy:
      return "bending energy";
    case LoopPurpose::least_torsion_range:
      return "range of torsion";
    case LoopPurpose::near_point:
      return "distance";
    case LoopPurpose::extents:
      return "largest difference of the sides";
  }
  return "";
}

}  // namespace

MadeLoop make_loop(const LoopRequest& request) {
  const LoopPlacement placement = placement_of(request);
  if (const auto wish = wish_of(request)) {
    ChosenLoop chosen = choose_loop(placement, *wish).value();
    const SpatialPath<3> path = chosen.path;
    LoopJuncture juncture = closed_loop_juncture(chosen.shape).value();
    const LoopFacts facts = loop_facts(path);
    std::string name = value_name(wish->purpose);
    MadeLoop loop{chosen.shape, chosen.roll, std::move(name), std::move(chosen),
                  path,         facts,       juncture};
    for (double* x :
         {&loop.juncture.curvature, &loop.juncture.torsion_begin, &loop.juncture.torsion_end}) {
      *x /= request.length;
    }
    return loop;
  }
  LoopShape shape;
  if (request.limit) {
    if (request.xi) refuse("give xi or a limit, not both", "limit");
    if (*request.limit != "positive" && *request.limit != "negative") {
      refuse("a limit is positive or negative; got \"" + *request.limit + "\"", "limit");
    }
    shape.xi =
        (*request.limit == "positive" ? 1.0 : -1.0) * std::numeric_limits<double>::infinity();
  } else if (request.xi) {
    if (!std::isfinite(*request.xi)) {
      refuse("xi must be a finite number; for the limit members there is the limit", "xi");
    }
    shape.xi = *request.xi;
  }
  if (request.psi) shape.psi = *request.psi;
  const SpatialPath<3> path = closed_loop(shape, placement).value();
  const LoopJuncture one = closed_loop_juncture(shape).value();
  return MadeLoop{shape,
                  0.0,
                  "",
                  std::nullopt,
                  path,
                  loop_facts(path),
                  {one.curvature / request.length, one.torsion_begin / request.length,
                   one.torsion_end / request.length}};
}

MadePath made_path(const MadeLoop& loop, const std::string& source) {
  return made_path(AnyPath(loop.path), source, "C2 closed loop of prescribed length",
                   "xi " + to_text(loop.shape.xi) + ", psi " + to_text(loop.shape.psi));
}

std::vector<std::pair<std::string, std::string>> rows_of(const MadeLoop& loop) {
  std::vector<std::pair<std::string, std::string>> rows;
  std::string shape =
      "xi " + to_six_digits(loop.shape.xi) + ", psi " + to_six_digits(loop.shape.psi) + " rad";
  if (loop.roll != 0.0) shape += ", rolled by " + to_six_digits(loop.roll) + " rad";
  rows.emplace_back("Loop", shape);
  if (loop.chosen) {
    const Enclosure& value = loop.chosen->value;
    const std::string size = value.lower() > 0.0 ? to_six_digits(value.middle())
                                                 : "at most " + to_six_digits(value.upper());
    rows.emplace_back("Chosen", "least " + loop.purpose + ", " + size + ", of " +
                                    std::to_string(loop.chosen->evaluations) + " loops looked at");
  }
  const LoopFacts& facts = loop.facts;
  std::string curvature = range_of(facts.curvature);
  if (std::isfinite(loop.juncture.curvature)) {
    curvature += ", where it closes " + to_six_digits(loop.juncture.curvature);
  }
  rows.emplace_back("Curvature", curvature);
  const double before = loop.juncture.torsion_end, after = loop.juncture.torsion_begin;
  std::string torsion = range_of(facts.torsion);
  if (std::isfinite(before)) {
    torsion += before == after ? ", continuous where it closes"
                               : ", where it closes " + to_six_digits(before) + " before and " +
                                     to_six_digits(after) + " after";
  }
  rows.emplace_back("Torsion", torsion);
  if (facts.energy) rows.emplace_back("Bending energy", text_of(*facts.energy));
  rows.emplace_back("Speed", range_of(facts.speed) + " per unit of xi");
  rows.emplace_back(
      "Tube", facts.tube.radius.upper() > 0.0 && facts.tube.radius.lower() > 0.0
                  ? "radius up to " + to_six_digits(facts.tube.radius.lower()) + ", limited " +
                        told(facts.tube.limit)
                  : std::string("none: the loop ") + (facts.tube.limit == TubeLimit::distance
                                                          ? "meets itself within rounding"
                                                          : "stands still where it closes"));
  return rows;
}

}  // namespace hodograph::cli
