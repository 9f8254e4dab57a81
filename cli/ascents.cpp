// SPDX-License-Identifier: MIT
#ifdef HODOGRAPH_HAS_CONTROL
#include "cli/ascents.hpp"

#include <array>
#include <cstdio>
#include <numbers>
#include <utility>

#include "cli/made_path.hpp"
#include "hodograph/control/framed_ascent.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

constexpr double degrees = 180.0 / std::numbers::pi;

Json list_of_vectors(const std::vector<Vector3<double>>& vectors) {
  Json list = Json::array();
  for (const auto& v : vectors) list.push_back(list_of(v));
  return list;
}

Json json_of(const AscentSolved& solved) {
  return {{"objective", solved.objective},
          {"status", solved.status},
          {"iterations", solved.iterations},
          {"constraint_error", solved.constraint_error},
          {"guess", solved.guess},
          {"guesses_tried", solved.tried},
          {"guesses_converged", solved.converged}};
}

/// Columns of text, the first one to the left, the others to the right.
std::string aligned(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const auto& row : rows) {
    widths.resize(std::max(widths.size(), row.size()));
    for (std::size_t c = 0; c < row.size(); ++c) widths[c] = std::max(widths[c], row[c].size());
  }
  std::string text;
  for (const auto& row : rows) {
    text += "  ";
    for (std::size_t c = 0; c < row.size(); ++c) {
      const std::string gap(widths[c] - row[c].size(), ' ');
      text += c == 0 ? row[c] + gap : "  " + gap + row[c];
    }
    text += '\n';
  }
  return text;
}

std::string digits(double value, const char* format) {
  char text[48];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::vector<std::vector<std::string>> table_of(const AscentSet& set) {
  std::vector<std::vector<std::string>> rows;
  if (!set.tracking.empty()) {
    rows.push_back({"start", "objective", "iterations", "ms", "defects", "end error km",
                    "lowest km", "thrust m/s2"});
    for (const TrackingAscent& a : set.tracking) {
      rows.push_back({a.start.name, digits(a.solved.objective, "%.7f"),
                      std::to_string(a.solved.iterations),
                      digits(1000.0 * a.solved.seconds, "%.0f"),
                      digits(a.solved.constraint_error, "%.0e"), digits(a.end_error_km, "%.2f"),
                      digits(a.lowest_height_km, "%.1f"), digits(a.largest_thrust_m_s2, "%.3f")});
    }
  } else {
    rows.push_back({"start", "objective", "minutes", "m/s", "iterations", "ms", "defects",
                    "again km", "again m/s", "lowest km"});
    for (const PoweredAscent& a : set.powered) {
      rows.push_back(
          {a.start.name, digits(a.solved.objective, "%.5f"), digits(a.duration_s / 60.0, "%.2f"),
           digits(a.velocity_change_m_s, "%.0f"), std::to_string(a.solved.iterations),
           digits(1000.0 * a.solved.seconds, "%.0f"), digits(a.solved.constraint_error, "%.0e"),
           digits(a.again.orbit_error_km, "%.5f"), digits(a.again.orbit_velocity_error_m_s, "%.5f"),
           digits(a.again.lowest_later_height_km, "%.3f")});
    }
  }
  return rows;
}

std::string title_of(const std::string& problem) {
  if (problem == "tracking") return "Optimal control problem (25), as published";
  if (problem == "figure") return "Optimal control problem (25), in the setting of its figure";
  if (problem == "energy") return "Ascent with gravity, least energy";
  return "Ascent with gravity, least time";
}

std::string remark_on(const std::string& problem) {
  if (problem == "tracking") {
    return "Tracking of the orbit as the publication has it: no gravity, and nothing keeps the "
           "lander out of the Moon. Time is mapped to the path parameter, one revolution to [0, "
           "1].";
  }
  if (problem == "figure") {
    return "The setting of the publication's figure, four revolutions on [0, 1]: it does not "
           "arrive. "
           "No gravity, and nothing keeps the lander out of the Moon.";
  }
  return "Three-body dynamics and a thrust vector, from rest on the surface (in the rotating "
         "frame) "
         "to a free point of the orbit with its velocity. 'again': the thrust followed once more "
         "by "
         "a Runge-Kutta pair of orders 7 and 8, against the orbit; 'lowest': height above the "
         "surface from the end of the first interval on, between the nodes too.";
}

Plot figure(const std::string& title, const std::string& x, const std::string& y) {
  Plot plot;
  plot.title = title;
  plot.x.label = x;
  plot.y.label = y;
  return plot;
}

Series line(const std::string& label, std::vector<double> x, std::vector<double> y) {
  Series series;
  series.label = label;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

/// Two coordinates, in km from the Moon's centre, of points.
Series seen(const std::string& label, const std::vector<Vector3<double>>& points, std::size_t right,
            std::size_t up) {
  Series series;
  series.label = label;
  for (const auto& p : points) {
    series.x.push_back(p[right]);
    series.y.push_back(p[up]);
  }
  return series;
}

/// Everything drawn, in km from the Moon's centre and minutes, whichever the problem.
struct Drawn {
  std::string name;
  std::vector<Vector3<double>> position;
  std::vector<double> time, position_error, orientation_error, speed;
};

std::vector<Drawn> drawn_of(const AscentReference& reference, const AscentSet& set) {
  std::vector<Drawn> all;
  const double length = reference.orbit().system.length_unit_km;
  for (const TrackingAscent& a : set.tracking) {
    Drawn d{a.start.name, {}, a.xi, a.position_error_km, {}, {}};
    for (const auto& p : a.position) d.position.push_back(length * (p - reference.moon()));
    for (const double angle : a.orientation_error) d.orientation_error.push_back(degrees * angle);
    for (const double v : a.speed) d.speed.push_back(v * a.speed_unit_m_s / 1000.0);
    all.push_back(std::move(d));
  }
  for (const PoweredAscent& a : set.powered) {
    Drawn d{a.start.name, a.position, {}, a.position_error_km, {}, {}};
    for (const double t : a.time_s) d.time.push_back(t / 60.0);
    for (const double angle : a.orientation_error) d.orientation_error.push_back(degrees * angle);
    for (const auto& v : a.velocity) d.speed.push_back(norm(v));
    all.push_back(std::move(d));
  }
  return all;
}

/// The stretch of the orbit that is flown beside, and some more of it.
std::vector<Vector3<double>> orbit_points(const AscentReference& reference, const AscentSet& set) {
  double begin = 0.5, end = 0.5;
  for (const TrackingAscent& a : set.tracking) {
    const double scale = a.time_unit_s / reference.period_s();
    begin = std::min(begin, scale * a.xi.front());
    end = std::max(end, scale * a.xi.back());
  }
  constexpr double margin = 0.006;  // revolutions: an hour
  for (const PoweredAscent& a : set.powered) {
    begin = std::min(begin, a.phase - margin);
    end = std::max(end, a.phase + margin);
  }
  constexpr int count = 200;
  std::vector<Vector3<double>> points;
  for (int i = 0; i <= count; ++i) {
    const double xi = begin + (end - begin) * i / count;
    points.push_back(reference.orbit().system.length_unit_km *
                     (reference.derivatives(xi)[0] - reference.moon()));
  }
  return points;
}

}  // namespace

AscentSet solved_ascents(const AscentReference& reference, const std::string& problem,
                         const std::vector<std::string>& starts, const AscentOptions& options,
                         const AscentWatch& watch) {
  AscentSet set{problem, {}, {}, options.along_path};
  const bool tracks = problem == "tracking" || problem == "figure";
  for (const std::string& name : starts) {
    const AscentStart start = ascent_start(name).value();
    std::string from = problem;
    from.append(" from ").append(name);
    AscentOptions wanted = options;
    AscentSolving& solving = tracks ? wanted.tracking.solving : wanted.powered.solving;
    if (watch) {
      solving.progress = [&](std::size_t guess, const SolverIteration& at) {
        std::string shown = from;
        shown.append(", guess ").append(std::to_string(guess + 1)).append(" of ");
        shown.append(std::to_string(solving.guesses)).append(", iteration ");
        return watch(shown.append(std::to_string(at.iteration)));
      };
    }
    const auto named = [&](auto result) {
      if (!result) {
        Fault fault = result.fault();
        fault.sentence.insert(0, ": ").insert(0, from);
        throw Error(fault);
      }
      return *std::move(result);
    };
    if (tracks) {
      wanted.tracking.setting = problem == "tracking" ? TrackingSetting::one_revolution
                                                      : TrackingSetting::four_revolutions;
      set.tracking.push_back(named(tracking_ascent(reference, start, wanted.tracking)));
    } else {
      wanted.powered.objective =
          problem == "energy" ? PoweredObjective::least_energy : PoweredObjective::least_time;
      set.powered.push_back(named(options.along_path
                                      ? powered_ascent_along_path(reference, start, wanted.powered)
                                      : powered_ascent(reference, start, wanted.powered)));
    }
  }
  return set;
}

Json json_of(const TrackingAscent& a, bool nodes) {
  Json json = {{"start", a.start.name}};
  json.update(json_of(a.solved));
  json["end_error_km"] = a.end_error_km;
  json["arrives"] = a.arrives;
  json["lowest_height_km"] = a.lowest_height_km;
  json["largest_thrust_m_s2"] = a.largest_thrust_m_s2;
  json["speed_unit_m_s"] = a.speed_unit_m_s;
  json["time_unit_s"] = a.time_unit_s;
  if (!nodes) return json;
  json["nodes"] = {{"xi", a.xi},
                   {"position", list_of_vectors(a.position)},
                   {"reference", list_of_vectors(a.reference)},
                   {"speed", a.speed},
                   {"theta", a.theta},
                   {"phi", a.phi},
                   {"acceleration", a.acceleration},
                   {"theta_rate", a.theta_rate},
                   {"phi_rate", a.phi_rate},
                   {"position_error_km", a.position_error_km},
                   {"orientation_error", a.orientation_error}};
  return json;
}

Json json_of(const PoweredAscent& a, bool nodes) {
  Json json = {{"start", a.start.name}};
  json.update(json_of(a.solved));
  json["duration_s"] = a.duration_s;
  json["phase"] = a.phase;
  json["velocity_change_m_s"] = a.velocity_change_m_s;
  json["again"] = {{"position_error_km", a.again.position_error_km},
                   {"velocity_error_m_s", a.again.velocity_error_m_s},
                   {"orbit_error_km", a.again.orbit_error_km},
                   {"orbit_velocity_error_m_s", a.again.orbit_velocity_error_m_s},
                   {"lowest_height_km", a.again.lowest_height_km},
                   {"lowest_later_height_km", a.again.lowest_later_height_km}};
  if (!nodes) return json;
  json["nodes"] = {{"time_s", a.time_s},
                   {"position_km", list_of_vectors(a.position)},
                   {"velocity_km_s", list_of_vectors(a.velocity)},
                   {"thrust_m_s2", list_of_vectors(a.thrust)},
                   {"position_error_km", a.position_error_km},
                   {"orientation_error", a.orientation_error}};
  return json;
}

Json json_of(const AscentSet& set, bool nodes) {
  Json json = {{"problem", set.problem}, {"ascents", Json::array()}};
  for (const auto& a : set.tracking) json["ascents"].push_back(json_of(a, nodes));
  for (const auto& a : set.powered) {
    Json one = json_of(a, nodes);
    one["coordinates"] = set.along_path ? "path" : "rectangular";
    json["ascents"].push_back(std::move(one));
  }
  return json;
}

std::string text_of(const AscentSet& set) {
  std::string text = title_of(set.problem) + "\n" + aligned(table_of(set));
  if (set.problem == "figure") text += "  This setting does not reach the orbit.\n";
  return text;
}

std::string csv_of(const AscentSet& set) {
  std::string text;
  const auto rows = [&](const std::vector<std::string>& names, const auto& ascents,
                        const auto& row_of) {
    std::vector<std::string> all = {"start_x", "start_y", "start_z"};
    all.insert(all.end(), names.begin(), names.end());
    append_csv_header(text, all);
    for (const auto& a : ascents) {
      for (std::size_t k = 0; k < a.position.size(); ++k) {
        std::vector<double> row = {a.start.direction.x, a.start.direction.y, a.start.direction.z};
        row_of(a, k, row);
        append_csv_row(text, row);
      }
    }
  };
  // The last node has no control of its own: it repeats the one before.
  if (!set.tracking.empty()) {
    rows({"xi", "x (LU)", "y (LU)", "z (LU)", "v", "theta", "phi", "a", "theta_rate", "phi_rate",
          "position_error (km)", "orientation_error (rad)"},
         set.tracking, [](const TrackingAscent& a, std::size_t k, std::vector<double>& row) {
           const std::size_t c = std::min(k, a.acceleration.size() - 1);
           const auto& p = a.position[k];
           row.insert(row.end(), {a.xi[k], p.x, p.y, p.z, a.speed[k], a.theta[k], a.phi[k],
                                  a.acceleration[c], a.theta_rate[c], a.phi_rate[c],
                                  a.position_error_km[k], a.orientation_error[k]});
         });
  } else {
    rows({"time (s)", "x (km)", "y (km)", "z (km)", "vx (km/s)", "vy (km/s)", "vz (km/s)",
          "ux (m/s2)", "uy (m/s2)", "uz (m/s2)", "position_error (km)", "orientation_error (rad)"},
         set.powered, [](const PoweredAscent& a, std::size_t k, std::vector<double>& row) {
           const auto& p = a.position[k];
           const auto& v = a.velocity[k];
           const auto& u = a.thrust[std::min(k, a.thrust.size() - 1)];
           row.insert(row.end(), {a.time_s[k], p.x, p.y, p.z, v.x, v.y, v.z, u.x, u.y, u.z,
                                  a.position_error_km[k], a.orientation_error[k]});
         });
  }
  return text;
}

ReportData report_of(const AscentReference& reference, const AscentSet& set) {
  ReportData data;
  data.title = title_of(set.problem);
  data.summary = remark_on(set.problem);
  const auto table = table_of(set);
  for (std::size_t r = 1; r < table.size(); ++r) {
    std::string text;
    for (std::size_t c = 1; c < table[r].size(); ++c) {
      text += (c == 1 ? "" : ", ") + table[0][c] + " " + table[r][c];
    }
    data.more.emplace_back(table[r][0], text);
  }

  const std::vector<Drawn> drawn = drawn_of(reference, set);
  const std::vector<Vector3<double>> orbit = orbit_points(reference, set);
  std::vector<Vector2<double>> circle;
  constexpr int corners = 120;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / corners;
    circle.push_back({moon_radius_km * std::cos(angle), moon_radius_km * std::sin(angle)});
  }
  constexpr std::array<const char*, 3> axes = {"x (km)", "y (km)", "z (km)"};
  data.first_heading = "The Moon, the orbit and the ascents, from the Moon's centre";
  for (const auto& [right, up] : {std::pair{0UL, 1UL}, {0UL, 2UL}, {1UL, 2UL}}) {
    Plot plot = figure("", axes[right], axes[up]);
    plot.equal_aspect = true;
    plot.height = plot.width;
    Series moon;
    moon.label = "Moon";
    moon.color = PlotColor::grey;
    moon.style = SeriesStyle::thin_line;
    for (const auto& p : circle) {
      moon.x.push_back(p.x);
      moon.y.push_back(p.y);
    }
    plot.series.push_back(std::move(moon));
    plot.series.push_back(seen("orbit", orbit, right, up));
    plot.series.back().style = SeriesStyle::dashed_line;
    plot.series.back().color = PlotColor::grey;
    for (const Drawn& d : drawn) plot.series.push_back(seen(d.name, d.position, right, up));
    data.first.push_back(std::move(plot));
  }

  const std::string time = set.tracking.empty() ? "time (minutes)" : "\xce\xbe";
  const auto panel = [&](const std::string& title, const std::string& unit, const auto& values) {
    Plot plot = figure(title, time, unit);
    for (const Drawn& d : drawn) plot.series.push_back(line(d.name, d.time, values(d)));
    data.further.push_back(std::move(plot));
  };
  panel("Distance from the orbit's moving point", "km", [](const Drawn& d) {
    std::vector<double> shown;
    constexpr double least_shown = 0.001;  // km: the meeting itself would fill the picture
    for (const double error : d.position_error) shown.push_back(std::max(error, least_shown));
    return shown;
  });
  data.further.back().y.logarithmic = true;
  panel("Angle to the orbit's tangent", "degrees",
        [](const Drawn& d) { return d.orientation_error; });
  panel("Speed", "km/s", [](const Drawn& d) { return d.speed; });
  if (!set.tracking.empty()) {
    for (const bool is_phi : {false, true}) {
      Plot plot = figure(is_phi ? "Gimbal angle \xcf\x86" : "Gimbal angle \xce\xb8", time, "rad");
      for (const TrackingAscent& a : set.tracking) {
        plot.series.push_back(line(a.start.name, a.xi, is_phi ? a.phi : a.theta));
      }
      data.further.push_back(std::move(plot));
    }
  } else {
    Plot thrust = figure("Thrust", time, "m/s\xc2\xb2");
    Plot height = figure("Height above the surface", time, "km");
    height.y.logarithmic = true;
    for (std::size_t i = 0; i < set.powered.size(); ++i) {
      const PoweredAscent& a = set.powered[i];
      Series steps, heights;
      steps.label = heights.label = a.start.name;
      for (std::size_t k = 0; k < a.thrust.size(); ++k) {
        const double size = norm(a.thrust[k]);
        steps.x.insert(steps.x.end(), {drawn[i].time[k], drawn[i].time[k + 1]});
        steps.y.insert(steps.y.end(), {size, size});
      }
      heights.x = drawn[i].time;
      for (const auto& p : a.position) heights.y.push_back(norm(p) - a.options.surface_km);
      thrust.series.push_back(std::move(steps));
      height.series.push_back(std::move(heights));
    }
    data.further.push_back(std::move(thrust));
    data.further.push_back(std::move(height));
  }
  return data;
}

}  // namespace hodograph::cli

#endif
