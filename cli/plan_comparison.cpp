// SPDX-License-Identifier: MIT
#include "cli/plan_comparison.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/motions.hpp"
#include "cli/plans.hpp"
#include "hodograph/curve/preimage_jet.hpp"
#include "hodograph/planning/mitred_world.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t points_of_plan = 1500;
constexpr PlotColor colors_of_plans[] = {PlotColor::vermilion, PlotColor::green};

/// "T1" first.
constexpr TangentRule rules[] = {TangentRule::t1, TangentRule::t2};
constexpr const char* rule_names[] = {"T1", "T2"};

Series sampled(const PlanarPath<2>& path) {
  Series series;
  for (std::size_t i = 0; i <= points_of_plan; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(points_of_plan);
    const Vector2<double> p =
        path.position(path.clamped(path.xi_begin() * (1.0 - share) + path.xi_end() * share));
    series.x.push_back(p.x);
    series.y.push_back(p.y);
  }
  return series;
}

/// |κ| by arc length: at both sides of every knot.
Series curvature_series(const PlanarPath<2>& path) {
  Series series;
  const std::size_t each = std::max<std::size_t>(16, points_of_plan / path.segment_count());
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto& curve = path.segment(k);
    for (std::size_t i = 0; i <= each; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(each);
      series.x.push_back(path.knot_arc_lengths()[k] + curve.arc_length(u));
      series.y.push_back(std::abs(curvature(curve.preimage_jet<1>(u))));
    }
  }
  return series;
}

const ObstacleClearance* nearest_of(const PathClearance& clearance) {
  const ObstacleClearance* nearest = nullptr;
  for (const ObstacleClearance& near : clearance.near) {
    if (nearest == nullptr || near.distance.lower() < nearest->distance.lower()) nearest = &near;
  }
  return nearest;
}

std::string clearance_text(const PathClearance& clearance, const World& world) {
  const ObstacleClearance* const nearest = nearest_of(clearance);
  if (nearest == nullptr) return "clearance at least " + to_six_digits(clearance.reach);
  if (nearest->distance.lower() == 0.0) return "meets " + world.name_of(nearest->obstacle);
  return "clearance at least " + to_six_digits(nearest->distance.lower());
}

/// A strip's outer edge, as far as nothing grown covers it: gaps where it is covered.
void append_free_part(Series& series, const MitredWorld& inside, const Vector2<double>& from,
                      const Vector2<double>& to) {
  constexpr int looks = 48, halvings = 20;
  const auto at = [&](double t) { return (1.0 - t) * from + t * to; };
  const auto free = [&](double t) {
    return inside.locate(at(t)).kind == WorldPosition::Kind::free;
  };
  const auto add = [&](double t) {
    series.x.push_back(at(t).x);
    series.y.push_back(at(t).y);
  };
  const auto gap = [&] {
    series.x.push_back(std::numeric_limits<double>::quiet_NaN());
    series.y.push_back(std::numeric_limits<double>::quiet_NaN());
  };
  const auto change = [&](double inside_free, double outside) {
    for (int i = 0; i < halvings; ++i) {
      const double middle = 0.5 * (inside_free + outside);
      (free(middle) ? inside_free : outside) = middle;
    }
    return inside_free;
  };
  bool drawn = free(0.0);
  if (drawn) add(0.0);
  for (int i = 1; i <= looks; ++i) {
    const double before = static_cast<double>(i - 1) / looks, now = static_cast<double>(i) / looks;
    const bool here = free(now);
    if (here && !drawn) add(change(now, before));
    if (!here && drawn) {
      add(change(before, now));
      gap();
    }
    drawn = here;
  }
  if (drawn) add(1.0);
  gap();
}

}  // namespace

std::vector<ComparedPlan> compared_plans(const Plan& plan, const World& world) {
  const ClearanceIndex index(world);
  std::vector<ComparedPlan> compared;
  for (std::size_t i = 0; i < std::size(rules); ++i) {
    auto made = tangent_plan(plan.polyline, rules[i], index, plan.certificate.clearance.reach);
    ComparedPlan one{rule_names[i]};
    if (made) {
      one.plan = *std::move(made);
    } else {
      one.fault = made.fault();
    }
    compared.push_back(std::move(one));
  }
  return compared;
}

MadePath made_comparison(const ComparedPlan& compared, const std::string& world_name) {
  const TangentPlan& plan = *compared.plan;
  MadePath made = made_path(AnyPath(plan.path), world_name.empty() ? "" : "world: " + world_name,
                            "G1 path through the shortest polyline's points",
                            "tangents by rule " + compared.name);
  made.document.name = "rule " + compared.name;
  made.document.promises.largest_curvature = plan.certificate.curvature;
  made.document.promises.clearance = promise_of(plan.certificate.clearance, world_name);
  return made;
}

Json json_of(const std::vector<ComparedPlan>& compared, const VehicleLimits& limits,
             const std::string& world_name, bool with_documents) {
  Json list = Json::array();
  for (const ComparedPlan& one : compared) {
    Json json = {{"rule", one.name}};
    if (!one.plan) {
      json["fault"] = json_of(*one.fault);
      list.push_back(std::move(json));
      continue;
    }
    const TangentPlan& plan = *one.plan;
    const MadePath made = made_comparison(one, world_name);
    json["arc_length"] = json_of(plan.certificate.arc_length);
    json["largest_curvature"] = json_of(plan.certificate.curvature);
    json["curvature_jump"] = plan.curvature_jump;
    json["continuity"] = json_of(made.facts.continuity);
    const ObstacleClearance* const nearest = nearest_of(plan.certificate.clearance);
    json["clearance"] = nearest == nullptr
                            ? json_of(Enclosure(plan.certificate.clearance.reach,
                                                std::numeric_limits<double>::infinity()))
                            : json_of(plan.certificate.clearance.least());
    Json& meets = json["meets"] = Json::array();
    for (const ObstacleClearance& near : plan.certificate.clearance.near) {
      if (near.distance.lower() > 0.0) continue;
      meets.push_back(near.obstacle == WorldVertex::bounds ? Json("bounds") : Json(near.obstacle));
    }
    json["keeps_turn_radius"] = word_of(plan.keeps_radius(limits.turn_radius));
    json["keeps_clearance"] = word_of(plan.keeps_distance(limits.distance()));
    if (with_documents) json["document"] = Json::parse(to_json(made.document));
    list.push_back(std::move(json));
  }
  return list;
}

std::vector<std::pair<std::string, std::string>> rows_of(const std::vector<ComparedPlan>& compared,
                                                         const Plan& plan, const World& world,
                                                         const VehicleLimits& limits) {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto text = [&](const PlanCertificate& proof) {
    return to_six_digits(proof.arc_length.upper()) + " long, curvature at most " +
           to_six_digits(proof.curvature.upper());
  };
  rows.emplace_back("G2 corners", text(plan.certificate) + ", continuous; " +
                                      clearance_text(plan.certificate.clearance, world));
  for (const ComparedPlan& one : compared) {
    if (!one.plan) {
      rows.emplace_back("Rule " + one.name, one.fault->sentence);
      continue;
    }
    std::string row = text(one.plan->certificate);
    row += one.plan->curvature_jump > 0.0
               ? ", jumps by up to " + to_six_digits(one.plan->curvature_jump)
               : std::string(", continuous");
    row += "; " + clearance_text(one.plan->certificate.clearance, world);
    std::string broken;
    if (one.plan->keeps_radius(limits.turn_radius) == hodograph::Answer::no) broken = "turn radius";
    if (one.plan->keeps_distance(limits.distance()) == hodograph::Answer::no) {
      broken += (broken.empty() ? "" : " and ") + std::string("clearance");
    }
    if (!broken.empty()) row += "; breaks the " + broken;
    rows.emplace_back("Rule " + one.name, row);
  }
  return rows;
}

void draw(ReportData& report, const std::vector<ComparedPlan>& compared, const Plan& plan,
          const VehicleLimits& limits) {
  Plot curvatures;
  curvatures.title = "Curvature |\xce\xba| of the three paths";
  curvatures.x.label = "arc length";
  curvatures.levels.push_back({1.0 / limits.turn_radius, "limit"});
  Series corners = curvature_series(plan.path);
  corners.label = "G2 corners";
  corners.color = PlotColor::blue;
  curvatures.series.push_back(std::move(corners));
  for (std::size_t i = 0; i < compared.size(); ++i) {
    if (!compared[i].plan) continue;
    const PlanarPath<2>& path = compared[i].plan->path;
    Series line = sampled(path);
    line.label = "rule " + compared[i].name;
    line.style = SeriesStyle::dashed_line;
    line.color = colors_of_plans[i];
    report.surroundings.push_back(std::move(line));
    Series curve = curvature_series(path);
    curve.label = "rule " + compared[i].name;
    curve.color = colors_of_plans[i];
    curvatures.series.push_back(std::move(curve));
  }
  report.further.push_back(std::move(curvatures));
}

Series polyline_series(const Polyline& polyline) {
  Series series;
  series.label = "shortest polyline";
  series.style = SeriesStyle::thin_line;
  series.color = PlotColor::purple;
  for (const auto& point : polyline.points) {
    series.x.push_back(point.x);
    series.y.push_back(point.y);
  }
  return series;
}

std::vector<Series> grown_outlines(const World& world, double distance) {
  if (!(distance > 0.0) || world.vertex_count() > most_grown_vertices) return {};
  // What is drawn is at the distance, just outside of this.
  constexpr double just_inside = 1.0 - 0x1.0p-16;  // not a tolerance: a picture's line
  const auto grown = MitredWorld::create(world, distance);
  const auto inside = MitredWorld::create(world, distance * just_inside);
  if (!grown || !inside) return {};
  Series series;
  series.label = "grown by " + to_six_digits(distance);
  series.style = SeriesStyle::thin_line;
  series.color = PlotColor::gold;
  const auto add = [&](const Ring& ring, std::uint32_t obstacle, std::uint32_t number,
                       double side) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const std::size_t j = next_vertex(i, ring.size());
      const Vector2<double> edge = ring[j] - ring[i];
      const double length = norm(edge);
      const Vector2<double> out{side * distance * edge.y / length,
                                -side * distance * edge.x / length};
      const auto end = [&](std::size_t v) {
        return grown->mitre_tip({obstacle, number, static_cast<std::uint32_t>(v)})
            .value_or(ring[v] + out);
      };
      append_free_part(series, *inside, end(i), end(j));
    }
  };
  for (std::size_t k = 0; k < world.obstacles().size(); ++k) {
    const Polygon& polygon = world.obstacles()[k];
    const auto obstacle = static_cast<std::uint32_t>(k);
    add(polygon.outer, obstacle, 0, 1.0);
    for (std::size_t h = 0; h < polygon.holes.size(); ++h) {
      add(polygon.holes[h], obstacle, static_cast<std::uint32_t>(h + 1), 1.0);
    }
  }
  if (world.bounds()) add(*world.bounds(), WorldVertex::bounds, 0, -1.0);  // inwards
  return {std::move(series)};
}

}  // namespace hodograph::cli
