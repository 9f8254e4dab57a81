// SPDX-License-Identifier: MIT
#include "cli/planar_facts.hpp"

#include "hodograph/path/bending_energy.hpp"
#include "hodograph/path/planar_curvature.hpp"
#include "hodograph/path/rotation_index.hpp"
#include "hodograph/path/signed_area.hpp"
#include "hodograph/surface/offset.hpp"

namespace hodograph::cli {
namespace {

/// Extremes and limits are refined to about this relative width, 2^-40: what people read off.
constexpr double shown_width = 0x1p-40;

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

template <std::size_t n>
PlanarFacts facts_of_planar(const PlanarPath<n>& path) {
  PlanarFacts facts;
  const RotationIndices turns = rotation_index_enclosures(path);
  facts.rotation_index = turns.with_sign;
  facts.absolute_rotation_index = turns.absolute;
  if (const auto energy = bending_energy_enclosure(path)) facts.bending_energy = *energy;
  facts.signed_area = signed_area_enclosure(path);
  const RangeGoal goal{shown_width};
  const Extremes curvature = curvature_extremes(path, goal);
  facts.smallest_curvature = curvature.minimum;
  facts.largest_curvature = curvature.maximum;
  const CuspFreeOffsets offsets = cusp_free_offsets(curvature);
  facts.offset_limit_left = offsets.left;
  facts.offset_limit_right = offsets.right;
  if constexpr (n > 0) {
    for (const Inflection& one : inflections(path)) {
      facts.inflections.push_back({one.xi, one.xi_range, Enclosure(0.0),
                                   one.kind == RootKind::simple ? "simple" : "undecided"});
    }
    for (const auto& one : curvature_stationary_points(path)) {
      facts.curvature_extremes.push_back({one.xi, one.xi_range, one.curvature, name_of(one.kind)});
    }
  }
  return facts;
}

Json json_of(const CurvaturePlace& place, bool with_curvature) {
  Json json = {{"xi", place.xi}, {"xi_range", cli::json_of(place.xi_range)}};
  if (with_curvature) json["curvature"] = cli::json_of(place.curvature);
  json["kind"] = std::string(place.kind);
  return json;
}

}  // namespace

std::optional<PlanarFacts> planar_facts_of(const AnyPath& path) {
  return path.visit([](const auto& p) -> std::optional<PlanarFacts> {
    using P = std::remove_cvref_t<decltype(p)>;
    if constexpr (P::Point::dimension == 2) {
      return facts_of_planar<P::preimage_degree>(p);
    } else {
      return std::nullopt;
    }
  });
}

std::string_view keeps_curvature_limit(const AnyPath& path, double limit) {
  const hodograph::Answer answer = path.visit([limit](const auto& p) {
    if constexpr (std::remove_cvref_t<decltype(p)>::Point::dimension == 2) {
      return curvature_stays_within(p, limit);
    } else {
      return hodograph::Answer::undecided;
    }
  });
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
  for (const auto& place : facts.inflections) json["inflections"].push_back(json_of(place, false));
  json["curvature_extremes"] = Json::array();
  for (const auto& place : facts.curvature_extremes) {
    json["curvature_extremes"].push_back(json_of(place, true));
  }
  return json;
}

}  // namespace hodograph::cli
