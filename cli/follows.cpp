// SPDX-License-Identifier: MIT
#ifdef HODOGRAPH_HAS_CONTROL
#include "cli/follows.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "cli/made_path.hpp"
#include "cli/plans.hpp"
#include "hodograph/io/table.hpp"
#include "hodograph/planning/clearance.hpp"

namespace hodograph::cli {
namespace {

Json json_of(const Vector3<double>& v, std::size_t dimension) {
  Json json = {v.x, v.y};
  if (dimension == 3) json.push_back(v.z);
  return json;
}

Series line(const std::string& label, const std::vector<FollowNode>& nodes, const auto& value) {
  Series series;
  series.label = label;
  for (const FollowNode& node : nodes) {
    series.x.push_back(node.time);
    series.y.push_back(value(node));
  }
  return series;
}

/// Refuses a step so short that no vehicle could get there in so many plans.
void require_few_plans(const AnyPath& path, const FollowRequest& request,
                       const HorizonOptions& options, double to, std::size_t most) {
  const double length = path.arc_length(), from = request.start.xi;
  double way = length;
  if (from >= path.xi_begin() && to <= path.xi_end()) {
    way = std::max(0.0, path.arc_length(to) - path.arc_length(from));
  }
  const double plans = way / (request.limits.speed * options.step);
  if (!(plans > static_cast<double>(most))) return;
  const double least = way / (request.limits.speed * static_cast<double>(most));
  throw Error(Fault{FaultCode::outside_domain,
                    "a step of " + to_text(options.step) + " s makes " + to_six_digits(plans) +
                        " plans or more of this way; at most " + std::to_string(most) +
                        " are made: the step must be at least " + to_six_digits(least) + " s",
                    std::nullopt, "horizon_step", options.step, least});
}

double share_of(const std::vector<double>& ascending, double share) {
  const auto last = static_cast<double>(ascending.size() - 1);
  return ascending[static_cast<std::size_t>(std::ceil(share * last))];
}

}  // namespace

WorldRoom room_in(const PathDocument& document, const World& world, double clearance,
                  double width) {
  WorldRoom room;
  room.needed = clearance + 0.5 * width;
  const double length = document.path.arc_length();
  const PathClearance found =
      clearance_of(document.path, ClearanceIndex(world), room.needed + length);
  room.clearance = found.least().lower();
  if (!(room.offset() > 0.0)) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the path keeps a clearance of " + to_text(room.clearance) +
                          " in this world, of which the vehicle needs " + to_text(room.needed) +
                          ": nothing is left beside the path",
                      std::nullopt, "clearance", room.needed, room.clearance});
  }
  return room;
}

std::vector<std::pair<std::string, std::string>> rows_of(const Following& found,
                                                         const FollowRequest& request,
                                                         const std::optional<WorldRoom>& room) {
  const auto six = [](double x) { return to_six_digits(x); };
  std::vector<std::pair<std::string, std::string>> rows;
  rows.emplace_back("Duration", six(found.duration) + " s");
  const FollowNode& last = found.nodes.back();
  rows.emplace_back("Way along the path", six(last.arc_length - found.nodes.front().arc_length) +
                                              ", to xi " + six(last.xi));
  rows.emplace_back("Offset", "at most " + six(found.largest_offset) + " of " +
                                  six(request.limits.offset) + " allowed");
  rows.emplace_back("Tube", std::isfinite(found.tube)
                                ? "radius " + six(found.tube) + ", certified from the curvature"
                                : std::string("of any radius: the path is straight"));
  if (room) {
    rows.emplace_back("Clearance on the way",
                      "at least " + six(room->clearance - found.largest_offset) + " of " +
                          six(room->needed) + " needed; of the path " + six(room->clearance) +
                          ", certified");
  }
  double speed = 0.0, along = 0.0, lateral = 0.0;
  for (const FollowNode& node : found.nodes) {
    speed = std::max(speed, node.speed);
    along = std::max(along, std::abs(node.along));
    lateral = std::max(lateral, std::abs(node.lateral));
  }
  lateral = std::max(lateral, found.largest_lateral);  // between the nodes, too
  rows.emplace_back("Speed", "at most " + six(speed));
  rows.emplace_back("Acceleration",
                    "at most " + six(along) + " along, " + six(lateral) + " across");
  rows.emplace_back("Solved", std::to_string(found.iterations) + " iterations, " +
                                  six(1000.0 * found.seconds) + " ms, defects " +
                                  six(found.constraint_error));
  return rows;
}

Json json_of(const Following& found, const FollowRequest& request,
             const std::optional<WorldRoom>& room, bool nodes, std::size_t dimension) {
  Json json;
  json["duration"] = found.duration;
  json["progress"] = found.progress;
  json["tube"] = found.tube;
  json["offset_limit"] = request.limits.offset;
  json["largest_offset"] = found.largest_offset;
  json["least_stretch"] = found.least_stretch;
  if (dimension == 2) json["largest_lateral"] = found.largest_lateral;
  if (room) {
    json["clearance"] = {{"of_path", room->clearance},
                         {"needed", room->needed},
                         {"on_the_way", room->clearance - found.largest_offset}};
  }
  json["objective"] = found.objective;
  json["constraint_error"] = found.constraint_error;
  json["iterations"] = found.iterations;
  if (!nodes) return json;
  Json& list = json["nodes"] = Json::array();
  for (const FollowNode& node : found.nodes) {
    Json one;
    one["time"] = node.time;
    one["xi"] = node.xi;
    one["arc_length"] = node.arc_length;
    one["offset"] = dimension == 2 ? Json(node.offset[0]) : Json(node.offset);
    one["heading"] = node.heading;
    one["speed"] = node.speed;
    one["position"] = json_of(node.position, dimension);
    one["velocity"] = json_of(node.velocity, dimension);
    one["acceleration"] = json_of(node.acceleration, dimension);
    one["along"] = node.along;
    one["lateral"] = node.lateral;
    list.push_back(std::move(one));
  }
  return json;
}

std::string csv_of(const Following& found, std::size_t dimension) {
  const bool planar = dimension == 2;
  std::vector<std::string> columns = {"time", "xi", "arc_length"};
  const auto add = [&](const std::vector<std::string>& names) {
    columns.insert(columns.end(), names.begin(), names.end());
  };
  add(planar ? std::vector<std::string>{"offset"}
             : std::vector<std::string>{"offset_2", "offset_3"});
  add({"heading", "speed", "x", "y"});
  if (!planar) add({"z"});
  add({"vx", "vy"});
  if (!planar) add({"vz"});
  add({"ax", "ay"});
  if (!planar) add({"az"});
  add({"along", "lateral"});
  std::string text;
  append_csv_header(text, columns);
  for (const FollowNode& node : found.nodes) {
    std::vector<double> row = {node.time, node.xi, node.arc_length, node.offset[0]};
    if (!planar) row.push_back(node.offset[1]);
    row.insert(row.end(), {node.heading, node.speed});
    for (const Vector3<double>& v : {node.position, node.velocity, node.acceleration}) {
      for (std::size_t i = 0; i < dimension; ++i) row.push_back(v[i]);
    }
    row.insert(row.end(), {node.along, node.lateral});
    append_csv_row(text, row);
  }
  return text;
}

ReportData report_of(const PathDocument& document, const Following& found,
                     const FollowRequest& request, const std::optional<WorldRoom>& room,
                     const World* world) {
  const bool planar = document.path.dimension() == 2;
  ReportData data;
  data.title = "Following a path";
  data.segments = document.path.segment_count();
  data.preimage_degree = document.path.preimage_degree();
  data.closed = document.path.is_closed();
  data.dimension = document.path.dimension();
  data.length_unit = document.length_unit;
  data.more = rows_of(found, request, room);
  for (const FollowNode& node : found.nodes) data.path.points.push_back(node.position);
  if (world != nullptr) data.surroundings = outlines(*world);
  if (planar) {
    Series path;
    path.label = "path";
    path.style = SeriesStyle::dashed_line;
    path.color = PlotColor::grey;
    constexpr int places = 1000;
    const double begin = document.path.xi_begin(), end = document.path.xi_end();
    for (int i = 0; i <= places; ++i) {
      std::array<double, 2> p{};
      document.path.position(i == places ? end : begin + (end - begin) * i / places, p);
      path.x.push_back(p[0]);
      path.y.push_back(p[1]);
    }
    data.surroundings.push_back(std::move(path));
  }
  const auto panel = [&](const std::string& title) -> Plot& {
    Plot plot;
    plot.title = title;
    plot.x.label = "time (s)";
    data.further.push_back(std::move(plot));
    return data.further.back();
  };
  Plot& offset = panel("Offset from the path");
  offset.series.push_back(
      line(planar ? "" : "along e2", found.nodes, [](const FollowNode& n) { return n.offset[0]; }));
  if (!planar) {
    offset.series.push_back(
        line("along e3", found.nodes, [](const FollowNode& n) { return n.offset[1]; }));
  }
  offset.levels = {{request.limits.offset, "limit"}, {-request.limits.offset, ""}};
  Plot& speed = panel("Speed");
  speed.series.push_back(line("", found.nodes, [](const FollowNode& n) { return n.speed; }));
  speed.levels = {{request.limits.speed, "limit"}};
  Plot& acceleration = panel("Acceleration");
  acceleration.series.push_back(
      line("along", found.nodes, [](const FollowNode& n) { return n.along; }));
  acceleration.series.push_back(
      line("across", found.nodes, [](const FollowNode& n) { return n.lateral; }));
  Plot& progress = panel("Way along the path");
  progress.series.push_back(
      line("", found.nodes, [](const FollowNode& n) { return n.arc_length; }));
  return data;
}

HorizonDrive driven(const AnyPath& path, const FollowRequest& request,
                    const HorizonOptions& options, double disturbance, std::size_t most_plans,
                    const std::function<bool(double fraction)>& watch) {
  RecedingHorizon horizon = RecedingHorizon::make(path, request.limits, options).value();
  const double period = path.xi_end() - path.xi_begin();
  const bool round = path.is_closed() && path.dimension() == 2;
  const double from = request.start.xi;
  const double to = request.options.xi_end.value_or(round ? from + period : path.xi_end());
  require_few_plans(path, request, options, to, most_plans);
  constexpr std::uint64_t seed = 7;
  std::mt19937_64 engine(seed);
  const auto error = [&engine](double size) {  // uniform in [-size, size]
    constexpr int bits = 53;
    const double unit = std::ldexp(static_cast<double>(engine() >> (64 - bits)), -bits);
    return size * (2.0 * unit - 1.0);
  };
  HorizonDrive drive;
  FollowStart state = request.start;
  const double begin = from, end = to;
  constexpr double arrived = 0.98;  // of the way: a horizon has no end to stop at
  while (drive.plans < most_plans && state.xi < begin + arrived * (end - begin)) {
    if (!watch((state.xi - begin) / (end - begin))) {
      throw Error(Fault{FaultCode::cancelled,
                        "stopped on request after " + std::to_string(drive.plans) + " plans",
                        std::nullopt, "plans", std::nullopt, std::nullopt});
    }
    const HorizonPlan plan = horizon.plan(state).value();
    if (drive.plans++ == 0) {
      drive.cold_s = plan.latency_s;
    } else {
      drive.latencies_s.push_back(plan.latency_s);
    }
    drive.warm += plan.warm ? 1 : 0;
    drive.recovered += plan.recovered ? 1 : 0;
    drive.unfinished += plan.finished ? 0 : 1;
    drive.iterations += plan.iterations;
    drive.duration += options.step;
    state = horizon.predicted();
    if (!round && state.xi > path.xi_end()) break;
    drive.largest_offset =
        std::max(drive.largest_offset, std::hypot(state.offset[0], state.offset[1]));
    for (double& offset : state.offset) {
      if (path.dimension() == 3 || &offset == state.offset.data()) {
        offset += error(disturbance * request.limits.offset);
      }
    }
    if (state.velocity) {
      for (std::size_t i = 0; i < 3; ++i) {
        (*state.velocity)[i] += error(disturbance * request.limits.speed);
      }
    } else {
      state.heading += error(disturbance);
      state.speed += error(disturbance * request.limits.speed);
    }
  }
  drive.xi = state.xi;
  std::sort(drive.latencies_s.begin(), drive.latencies_s.end());
  return drive;
}

std::vector<std::pair<std::string, std::string>> rows_of(const HorizonDrive& drive) {
  const auto ms = [](double s) { return to_six_digits(1000.0 * s) + " ms"; };
  std::vector<std::pair<std::string, std::string>> rows;
  rows.emplace_back("Driven",
                    to_six_digits(drive.duration) + " s, to xi " + to_six_digits(drive.xi));
  rows.emplace_back("Plans", std::to_string(drive.plans) + ", " + std::to_string(drive.warm) +
                                 " warm, " + std::to_string(drive.recovered) +
                                 " from a state out of bounds");
  rows.emplace_back("Offset", "at most " + to_six_digits(drive.largest_offset));
  rows.emplace_back("First plan", ms(drive.cold_s));
  if (!drive.latencies_s.empty()) {
    const auto& all = drive.latencies_s;
    constexpr double median = 0.5, most = 0.95, nearly_all = 0.99;
    rows.emplace_back("Latency", "median " + ms(share_of(all, median)) + ", 95 % " +
                                     ms(share_of(all, most)) + ", 99 % " +
                                     ms(share_of(all, nearly_all)) + ", largest " + ms(all.back()));
  }
  return rows;
}

Json json_of(const HorizonDrive& drive) {
  Json json;
  json["duration"] = drive.duration;
  json["xi"] = drive.xi;
  json["largest_offset"] = drive.largest_offset;
  json["plans"] = drive.plans;
  json["warm"] = drive.warm;
  json["recovered"] = drive.recovered;
  json["unfinished"] = drive.unfinished;
  json["iterations"] = drive.iterations;
  json["first_latency_s"] = drive.cold_s;
  json["latencies_s"] = drive.latencies_s;
  return json;
}

}  // namespace hodograph::cli
#endif
