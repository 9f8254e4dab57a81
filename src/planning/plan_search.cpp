// SPDX-License-Identifier: MIT
#include "plan_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <utility>

#include "hodograph/construction/corner.hpp"
#include "hodograph/foundation/interruption.hpp"

namespace hodograph::planning_detail {
namespace {

/// A turn radius is planned for with this much to spare, so that the certified curvature keeps the
/// limit itself: far more than the width of an enclosure, far less than anybody measures.
constexpr double radius_margin = 0x1p-30;
/// Offsets are raised by this much more than needed, so that the rising ends.
constexpr double offset_margin = 0.125;
constexpr int most_rounds = 64;       // of raising offsets for one polyline
constexpr int most_growths = 8;       // doublings of the offsets about a crowded line
constexpr int growth_bisections = 4;  // between one that does not suffice and one that does
constexpr double worthwhile = 1.125;  // a growth that does not give this much more room is none

double largest_coordinate(const World& world, const PlanRequest& request) {
  double largest = std::max(largest_component(request.start), largest_component(request.goal));
  if (world.box()) {
    largest = std::max(
        {largest, largest_component(world.box()->lower), largest_component(world.box()->upper)});
  }
  return largest;
}

/// A polyline that remains to be looked at, or a plan that is done; the shortest comes first.
struct Attempt {
  double length = 0.0;  // of the polyline it came from, or of its own when it is done
  std::vector<ForbiddenLeg> forbidden{};
  std::map<WorldVertex, double> grown{};  // what their offsets are times
  std::shared_ptr<Plan> done{};

  friend bool operator<(const Attempt& a, const Attempt& b) { return a.length > b.length; }
};

/// Why a polyline cannot be rounded.
struct Crowded {
  Polyline polyline;
  std::size_t line = 0;
  CrowdedCorner corner;
  double fit = 0.0;  // the least of what lines have over what their corners need; below 1
};

/// The planning of one request.
class Search {
 public:
  Search(const MitredWorld& mitred, const ClearanceIndex& clearance, const VehicleLimits& limits,
         const PlanRequest& request)
      : mitred_(mitred),
        clearance_(clearance),
        limits_(limits),
        request_(request),
        radius_(limits.turn_radius * (1.0 + radius_margin)),
        largest_(largest_coordinate(clearance.world(), request)) {}

  Result<Plan> run() {
    if (auto fault = choose_common_offset()) return *std::move(fault);
    std::priority_queue<Attempt> queue;
    queue.push({});
    std::vector<CrowdedCorner> given_up;
    std::size_t attempts = 0;
    while (!queue.empty()) {
      check_interruption();
      Attempt attempt = queue.top();
      queue.pop();
      if (attempt.done) {
        attempt.done->attempts = attempts;
        attempt.done->given_up = std::move(given_up);
        return std::move(*attempt.done);
      }
      if (attempts == request_.most_attempts) continue;  // what is done may still be taken
      ++attempts;
      auto outcome = round(attempt);
      if (!outcome) {
        // Of the first attempt it is the answer; later ones may have forbidden too much.
        if (attempts == 1) return outcome.fault();
        continue;
      }
      if (outcome->plan) {
        queue.push({outcome->plan->polyline.length, {}, {}, std::move(outcome->plan)});
        continue;
      }
      const Crowded& crowded = outcome->crowded;
      given_up.push_back(crowded.corner);
      for (Attempt& next : alternatives(attempt, crowded)) queue.push(std::move(next));
    }
    return no_plan(given_up, attempts);
  }

 private:
  /// A plan, or why there is none.
  struct Outcome {
    std::shared_ptr<Plan> plan{};
    Crowded crowded{};
  };

  double factor(const CornerShape& shape) const {
    return corner_clearance_factor(shape.turning_angle) * radius_;
  }

  PolylineQuery query(const Attempt& attempt, const std::map<WorldVertex, double>& offsets) const {
    PolylineQuery result;
    result.start = request_.start;
    result.goal = request_.goal;
    result.forbidden_legs = attempt.forbidden;
    for (const auto& [vertex, offset] : offsets) result.corner_offsets.push_back({vertex, offset});
    return result;
  }

  static std::vector<Result<CornerShape>> shapes_of(const Polyline& polyline) {
    std::vector<Result<CornerShape>> shapes;
    for (std::size_t k = 1; k + 1 < polyline.points.size(); ++k) {
      shapes.push_back(
          corner_shape({polyline.points[k - 1], polyline.points[k], polyline.points[k + 1]}));
    }
    return shapes;
  }

  /// Grows the world by the offset that all corners share, where they do.
  std::optional<Fault> choose_common_offset() {
    double extra = 0.0;
    if (request_.corner_offset) {
      extra = *request_.corner_offset;
      if (!std::isfinite(extra) || extra < 0.0) {
        return limit_fault("corner_offset", extra,
                           "the corner offset must be a number and not negative");
      }
      return grow_by(extra);
    }
    if (request_.aim == CornerAim::smallest) return std::nullopt;
    auto polyline = shortest_polyline(mitred_, query({}, {}));
    if (!polyline) return polyline.fault();
    for (int k = 0; k < most_rounds; ++k) {
      double needed = 0.0;
      for (const auto& shape : shapes_of(*polyline)) {
        if (shape) needed = std::max(needed, factor(*shape));
      }
      if (needed <= extra) break;
      extra = needed * (1.0 + offset_margin);
      // Where that closes the way, or takes in start or goal, corners get their own offsets.
      const MitredWorld before = mitred_;
      if (grow_by(extra)) break;
      auto next = shortest_polyline(mitred_, query({}, {}));
      if (!next) {
        mitred_ = before;
        break;
      }
      polyline = std::move(next);
    }
    common_ = *std::move(polyline);
    return std::nullopt;
  }
  std::optional<Fault> grow_by(double extra) {
    if (extra == 0.0) return std::nullopt;
    auto grown = MitredWorld::create(clearance_.world(), base_offset_ + extra);
    if (!grown) return grown.fault();
    mitred_ = *std::move(grown);
    return std::nullopt;
  }

  /// The shortest polyline of an attempt, rounded and certified; why it cannot be, where there is
  /// no room; a fault where there is no polyline.
  Result<Outcome> round(const Attempt& attempt) {
    std::map<WorldVertex, double> offsets;
    const auto offset_at = [&](const WorldVertex& vertex) {
      const auto found = offsets.find(vertex);
      return found == offsets.end() ? mitred_.offset() : std::max(found->second, mitred_.offset());
    };
    const double beyond = request_.corner_offset ? *request_.corner_offset : 0.0;
    std::optional<Crowded> raised_at;
    for (int k = 0;; ++k) {
      const bool is_common = offsets.empty() && attempt.forbidden.empty();
      auto polyline = is_common && common_ ? Result<Polyline>(*common_)
                                           : shortest_polyline(mitred_, query(attempt, offsets));
      if (is_common && !common_ && polyline) common_ = *polyline;
      if (!polyline) {
        // An offset that was raised takes in the start or the goal, or closes the way.
        if (raised_at) return Outcome{{}, *std::move(raised_at)};
        return polyline.fault();
      }
      const auto shapes = shapes_of(*polyline);
      bool raised = false;
      for (std::size_t i = 0; i < shapes.size() && k < most_rounds; ++i) {
        if (!shapes[i]) continue;
        const WorldVertex& vertex = polyline->corners[i].vertex;
        double needed = base_offset_ + std::max(factor(*shapes[i]), beyond);
        if (const auto grown = attempt.grown.find(vertex); grown != attempt.grown.end()) {
          needed = base_offset_ + (needed - base_offset_) * grown->second;
        }
        if (const auto more = pushed_.find(vertex); more != pushed_.end()) {
          needed = std::max(needed, more->second);
        }
        if (offset_at(vertex) >= needed) continue;
        offsets[vertex] = base_offset_ + (needed - base_offset_) * (1.0 + offset_margin);
        if (!raised) raised_at = Crowded{*polyline, i, crowded_corner(*polyline, shapes, i), 0.0};
        raised = true;
      }
      if (raised) continue;
      auto outcome = size_corners(*polyline, shapes, offset_at);
      if (!outcome || !outcome->plan) return outcome;
      const Plan& plan = *outcome->plan;
      if (plan.certificate.proves(limits_, largest_)) return outcome;
      if (k >= most_rounds || !push(plan)) {
        return Outcome{{}, {*polyline, 0, crowded_corner(*polyline, shapes, 0), 0.0}};
      }
    }
  }

  /// Where the certificate does not hold, the corner that comes too near gets more offset.
  bool push(const Plan& plan) {
    bool any = false;
    for (const ObstacleClearance& near : plan.certificate.clearance.near) {
      if (near.distance.lower() >= limits_.distance() - planning_tolerance * largest_) continue;
      const Vector2<double> at = plan.path.position(plan.path.clamped(near.xi));
      std::optional<std::size_t> nearest;
      double least = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < plan.polyline.corners.size(); ++i) {
        const Vector2<double> d = plan.polyline.corners[i].point - at;
        if (const double distance = std::hypot(d.x, d.y); distance < least) {
          least = distance;
          nearest = i;
        }
      }
      if (!nearest) continue;
      const double missing = limits_.distance() - near.distance.lower();
      pushed_[plan.polyline.corners[*nearest].vertex] =
          plan.offsets[*nearest] + 2.0 * missing + 2.0 * planning_tolerance * largest_;
      any = true;
    }
    return any;
  }

  template <class OffsetAt>
  Result<Outcome> size_corners(const Polyline& polyline,
                               const std::vector<Result<CornerShape>>& shapes,
                               const OffsetAt& offset_at) {
    std::vector<double> lines, offsets;
    for (std::size_t k = 0; k + 1 < polyline.points.size(); ++k) {
      const Vector2<double> d = polyline.points[k + 1] - polyline.points[k];
      lines.push_back(std::hypot(d.x, d.y));
    }
    std::vector<CornerRoom> rooms;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (!shapes[i]) {
        return Outcome{{}, {polyline, i, crowded_corner(polyline, shapes, i), 0.0}};
      }
      const CornerShape& shape = *shapes[i];
      const double offset = offset_at(polyline.corners[i].vertex);
      offsets.push_back(offset);
      CornerRoom room;
      room.least = shape.peak_curvature * radius_;
      // How far a corner of leg 1 comes off its lines, by which the offset shrinks (21).
      const double depth = shape.deviation * std::cos(0.5 * shape.turning_angle);
      const double room_of_lines = std::min(lines[i], lines[i + 1]);
      room.most =
          depth > 0.0 ? std::min(room_of_lines, (offset - base_offset_) / depth) : room_of_lines;
      room.most = std::max(room.most, room.least);
      room.saving = std::max(0.0, 2.0 - shape.arc_length);
      room.peak_curvature = shape.peak_curvature;
      rooms.push_back(room);
    }
    auto legs = corner_sizes(lines, rooms, request_.aim);
    if (!legs) {  // where the room is least
      Crowded crowded{polyline, 0, {}, std::numeric_limits<double>::infinity()};
      for (std::size_t k = 0; k < lines.size(); ++k) {
        const double needed =
            (k > 0 ? rooms[k - 1].least : 0.0) + (k < rooms.size() ? rooms[k].least : 0.0);
        if (!(lines[k] < crowded.fit * needed)) continue;
        crowded.fit = lines[k] / needed;
        crowded.line = k;
      }
      crowded.corner = crowded_corner(polyline, shapes, crowded.line);
      return Outcome{{}, std::move(crowded)};
    }
    auto path = rounded_polyline_of_legs(polyline.points, *legs);
    if (!path) return path.fault();
    const double reach = 2.0 * limits_.distance() + limits_.turn_radius;
    auto certificate = certify_plan(*path, clearance_, reach);
    if (!certificate) return certificate.fault();
    return Outcome{std::make_shared<Plan>(Plan{*std::move(path),
                                               polyline,
                                               *std::move(legs),
                                               std::move(offsets),
                                               *std::move(certificate),
                                               0,
                                               {}}),
                   {}};
  }

  /// The corner of a line that asks for more of it, and about which radius there is room for.
  CrowdedCorner crowded_corner(const Polyline& polyline,
                               const std::vector<Result<CornerShape>>& shapes,
                               std::size_t line) const {
    CrowdedCorner result;
    double asked = 0.0, most = -1.0;
    for (const std::size_t i : {line - 1, line}) {  // line 0 has no corner before it
      if (i >= shapes.size()) continue;
      const double share =
          shapes[i] ? shapes[i]->peak_curvature : std::numeric_limits<double>::infinity();
      asked += share;
      if (!(share > most)) continue;
      most = share;
      result.point = polyline.corners[i].point;
      result.vertex = polyline.corners[i].vertex;
      result.turning_angle = shapes[i] ? shapes[i]->turning_angle : 0.0;
    }
    const Vector2<double> d = polyline.points[line + 1] - polyline.points[line];
    result.turn_radius = asked > 0.0 ? std::hypot(d.x, d.y) / asked : 0.0;
    return result;
  }

  /// An attempt with larger offsets at some vertices, and how well its lines fit.
  struct Growth {
    Attempt attempt;
    double fit = 0.0;  // at least 1 where it is a plan
  };
  std::optional<Growth> grown(const Attempt& attempt, const std::vector<WorldVertex>& vertices,
                              double factor_of_offset) {
    Growth result{attempt, 0.0};
    for (const WorldVertex& vertex : vertices) {
      result.attempt.grown.try_emplace(vertex, 1.0).first->second *= factor_of_offset;
    }
    const auto outcome = round(result.attempt);
    if (!outcome) return std::nullopt;
    result.fit = outcome->plan ? 1.0 : outcome->crowded.fit;
    result.attempt.length =
        outcome->plan ? outcome->plan->polyline.length : outcome->crowded.polyline.length;
    return result;
  }

  /// The least growth of these vertices' offsets that suffices; where none does, the one that gives
  /// most room, if that is worthwhile.
  std::optional<Attempt> least_growth(const Attempt& attempt,
                                      const std::vector<WorldVertex>& vertices, double fit) {
    std::optional<Growth> best;
    double low = 1.0, high = 1.0;
    for (int k = 0; k < most_growths; ++k) {
      low = high;
      high *= 2.0;
      auto next = grown(attempt, vertices, high);
      if (!next) break;
      if (next->fit > (best ? best->fit : worthwhile * fit)) best = std::move(next);
      if (best && best->fit >= 1.0) break;
    }
    if (!best) return std::nullopt;
    for (int k = 0; best->fit >= 1.0 && k < growth_bisections; ++k) {
      const double middle = 0.5 * (low + high);
      auto next = grown(attempt, vertices, middle);
      if (next && next->fit >= 1.0) {
        best = std::move(next);
        high = middle;
      } else {
        low = middle;
      }
    }
    return std::move(best->attempt);
  }

  /// What else is tried: larger offsets at either corner of the crowded line, or both, and to go
  /// without the line.
  std::vector<Attempt> alternatives(const Attempt& attempt, const Crowded& crowded) {
    std::vector<Attempt> result;
    const auto& corners = crowded.polyline.corners;
    const std::size_t line = crowded.line;
    std::vector<WorldVertex> ends;
    ForbiddenLeg leg;
    if (line > 0) ends.push_back(*(leg.from = corners[line - 1].vertex));
    if (line < corners.size()) ends.push_back(*(leg.to = corners[line].vertex));
    std::vector<std::vector<WorldVertex>> choices;
    for (const WorldVertex& end : ends) choices.push_back({end});
    if (ends.size() == 2) choices.push_back(ends);
    for (const auto& choice : choices) {
      if (auto next = least_growth(attempt, choice, crowded.fit)) {
        result.push_back(*std::move(next));
      }
    }
    Attempt without{crowded.polyline.length, attempt.forbidden, attempt.grown, {}};
    without.forbidden.push_back(leg);
    result.push_back(std::move(without));
    return result;
  }

  Fault no_plan(const std::vector<CrowdedCorner>& given_up, std::size_t attempts) const {
    if (given_up.empty()) {
      return {FaultCode::no_route,
              "no polyline was tried: allow at least one attempt",
              std::nullopt,
              "most_attempts",
              0.0,
              1.0};
    }
    const CrowdedCorner& first = given_up.front();
    return {FaultCode::no_route,
            "no path of turn radius " + to_text(limits_.turn_radius) + " was found in " +
                std::to_string(attempts) + " attempts: on the shortest way the corner at (" +
                to_text(first.point.x) + ", " + to_text(first.point.y) + "), about vertex " +
                std::to_string(first.vertex.vertex) + " of " +
                clearance_.world().name_of(first.vertex.obstacle) +
                ", has no room; there a turn radius of about " + to_text(first.turn_radius) +
                " would have",
            std::nullopt,
            "turn_radius",
            limits_.turn_radius,
            first.turn_radius};
  }

  MitredWorld mitred_;
  std::optional<Polyline> common_{};  // the shortest one in that world, nothing forbidden or raised
  const ClearanceIndex& clearance_;
  const VehicleLimits& limits_;
  const PlanRequest& request_;
  double radius_;   // a little more than the vehicle's
  double largest_;  // coordinate
  double base_offset_ = mitred_.offset();
  std::map<WorldVertex, double> pushed_{};
};

}  // namespace

Fault limit_fault(const char* quantity, double value, const std::string& sentence) {
  return {FaultCode::outside_domain,
          sentence + "; got " + to_text(value),
          std::nullopt,
          quantity,
          value,
          0.0};
}

Result<Plan> search_plan(const MitredWorld& mitred, const ClearanceIndex& clearance,
                         const VehicleLimits& limits, const PlanRequest& request) {
  return Search(mitred, clearance, limits, request).run();
}

}  // namespace hodograph::planning_detail
