// SPDX-License-Identifier: MIT
#include "cli/planar_facts.hpp"

#include <future>

#include "hodograph/path/any_bounds.hpp"
#include "hodograph/path/any_planar.hpp"
#include "hodograph/surface/offset.hpp"

namespace hodograph::cli {
namespace {

/// Extremes and limits are refined to about this relative width, 2^-40: what people read off.
constexpr double shown_width = 0x1p-40;
/// A path of so many segments is worth threads: its facts take some 20 µs a segment.
constexpr std::size_t many_segments = 2000;

std::string_view name_of(CurvatureExtremeKind kind) {
  switch (kind) {
    case CurvatureExtremeKind::minimum:
      return "minimum";
    case CurvatureExtremeKind::maximum:
      return "maximum";
    case CurvatureExtremeKind::undecided:
      return "undecided";
  }
  return "";
}

Json json_of_place(const CurvaturePlace& place, bool with_curvature) {
  Json json = {{"xi", place.xi}, {"xi_range", cli::json_of(place.xi_range)}};
  if (with_curvature) json["curvature"] = cli::json_of(place.curvature);
  json["kind"] = std::string(place.kind);
  return json;
}

}  // namespace

std::optional<PlanarFacts> planar_facts_of(const AnyPath& path) {
  if (path.dimension() != 2) return std::nullopt;
  PlanarFacts facts;
  // The three that take longest beside the others: what cannot have a thread runs when it is asked.
  const auto way = path.segment_count() < many_segments
                       ? std::launch::deferred
                       : std::launch::async | std::launch::deferred;
  auto energy = std::async(way, [&] { return bending_energy_enclosure(path); });
  auto turns = std::async(way, [&] { return rotation_index_enclosures(path); });
  auto meetings = std::async(way, [&] { return self_intersections(path); });
  facts.signed_area = signed_area_enclosure(path);
  const Extremes curvature = curvature_extremes(path, RangeGoal{shown_width});
  facts.smallest_curvature = curvature.minimum;
  facts.largest_curvature = curvature.maximum;
  const CuspFreeOffsets offsets = cusp_free_offsets(curvature);
  facts.offset_limit_left = offsets.left;
  facts.offset_limit_right = offsets.right;
  for (const Inflection& one : inflections(path)) {
    facts.inflections.push_back({one.xi, one.xi_range, Enclosure(0.0),
                                 one.kind == RootKind::simple ? "simple" : "undecided"});
  }
  for (const auto& one : curvature_stationary_points(path)) {
    facts.curvature_extremes.push_back({one.xi, one.xi_range, one.curvature, name_of(one.kind)});
  }
  facts.self_intersections = meetings.get();
  const RotationIndices indices = turns.get();
  facts.rotation_index = indices.with_sign;
  facts.absolute_rotation_index = indices.absolute;
  if (const auto found = energy.get()) facts.bending_energy = *found;
  return facts;
}

std::string_view keeps_curvature_limit(const AnyPath& path, double limit) {
  if (path.dimension() != 2) return "undecided";
  const hodograph::Answer answer = curvature_stays_within(path, limit);
  switch (answer) {
    case hodograph::Answer::yes:
      return "yes";
    case hodograph::Answer::no:
      return "no";
    case hodograph::Answer::undecided:
      return "undecided";
  }
  return "";
}

Json json_of(const PlanarFacts& facts) {
  Json json = {
      {"rotation_index", json_of(facts.rotation_index)},
      {"absolute_rotation_index", json_of(facts.absolute_rotation_index)},
      {"bending_energy", facts.bending_energy ? json_of(*facts.bending_energy) : Json()},
      {"signed_area", json_of(facts.signed_area)},
      {"smallest_curvature", json_of(facts.smallest_curvature)},
      {"largest_curvature", json_of(facts.largest_curvature)},
      {"cusp_free_offsets",
       {{"left", json_of(facts.offset_limit_left)}, {"right", json_of(facts.offset_limit_right)}}}};
  json["inflections"] = Json::array();
  for (const auto& place : facts.inflections)
    json["inflections"].push_back(json_of_place(place, false));
  json["curvature_extremes"] = Json::array();
  for (const auto& place : facts.curvature_extremes) {
    json["curvature_extremes"].push_back(json_of_place(place, true));
  }
  json["self_intersections"] = Json::array();
  for (const auto& at : facts.self_intersections) {
    json["self_intersections"].push_back(json_of(at));
  }
  return json;
}

Json json_of(const PathIntersection& at) {
  return {{"xi", at.xi_first},          {"xi_range", json_of(at.xi_first_range)},
          {"other_xi", at.xi_second},   {"other_xi_range", json_of(at.xi_second_range)},
          {"point", list_of(at.point)}, {"kind", name_of(at.kind)}};
}

const char* name_of(IntersectionKind kind) {
  return kind == IntersectionKind::crossing ? "crossing" : "undecided";
}

}  // namespace hodograph::cli
