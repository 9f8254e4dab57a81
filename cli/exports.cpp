// SPDX-License-Identifier: MIT
#include "cli/exports.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "cli/point_state.hpp"
#include "cli/polynomial_flight.hpp"
#include "cli/refuse.hpp"
#include "cli/sample_plan.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {

struct ExportFlags::Given {
  std::vector<Option> options;
  enum class Index : std::size_t { chord, altitude, speed, acceleration, lateral, tolerance };
  bool operator()(Index index) const { return options[static_cast<std::size_t>(index)].given(); }
};

namespace {

/// Rounded up to three digits.
std::string bound_text(double bound) {
  constexpr double three_digits = 1.0 + 1.0 / 128.0;  // rounding takes off at most 1/200
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", bound * three_digits);
  return text;
}

std::string counted(std::size_t count, const char* what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

std::optional<GeodeticPoint> datum_of(const std::vector<double>& numbers) {
  if (numbers.empty()) return std::nullopt;
  GeodeticPoint datum{numbers[0], numbers[1], numbers.size() > 2 ? numbers[2] : 0.0};
  if (const auto fault = fault_of(datum, "the datum")) throw Error(*fault);
  return datum;
}

void add_sample_count(Command& command, std::size_t& count, const std::string& help) {
  command.option("--samples", count, "N", help + " (default " + std::to_string(count) + ")")
      .whole_number(2, 10'000'000);
}

void add_datum(Command& command, std::vector<double>& datum) {
  command
      .option("--datum", datum, "LAT,LON,ALT",
              "where the origin is (degrees, metres): x is east, y north; also for GeoJSON")
      .list(2, 3);
}

void check_places(bool missions, const std::vector<double>& datum, std::optional<double> chord) {
  if (missions && datum.empty()) {
    refuse(
        "waypoints of drones are latitudes and longitudes: say where the origin is by "
        "--datum LAT,LON,ALT",
        "datum");
  }
  if (!datum.empty()) datum_of(datum);
  if (chord && !(*chord > 0.0 && std::isfinite(*chord))) {
    throw Error(
        Fault{FaultCode::outside_domain,
              "the distance of the chords is " + to_text(*chord) + "; it should be positive",
              std::nullopt, "chord", *chord, 0.0});
  }
}

void write_files(const std::vector<std::pair<std::string, std::string>>& texts_of_files) {
  for (const auto& [file, text] : texts_of_files) {
    if (const auto fault = write_file(file, text)) throw Error(*fault);
  }
}

std::vector<LocalWaypoint> waypoints_of(const AnyPath& path, const TimedMotion& motion,
                                        const Flight& flight, double chord) {
  SamplePlan plan;
  plan.chord_tolerance = chord;
  const std::vector<double> parameters = sampled_parameters(path, plan).value();
  const bool constant = !flight.acceleration;
  const TimingLaw& law = motion.law();
  std::vector<LocalWaypoint> waypoints;
  waypoints.reserve(parameters.size());
  std::vector<double> point(path.dimension());
  double before = law.start_time(), covered = 0.0;
  for (const double xi : parameters) {
    path.position(xi, point);
    LocalWaypoint waypoint{
        {point[0], point[1], point.size() > 2 ? point[2] : flight.altitude.value_or(0.0)}, {}};
    if (constant) {
      if (flight.arrival) {
        waypoint.speed = law.most_speed();
      } else {
        waypoint.speed = flight.speed;
      }
    } else {
      const double s = std::min(path.arc_length(xi), law.length()), time = law.time_at(s);
      if (time > before && s > covered) waypoint.speed = (s - covered) / (time - before);
      before = time;
      covered = s;
    }
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

GeoJsonPath line_of(const PathDocument& document, double chord) {
  SamplePlan plan;
  plan.chord_tolerance = chord;
  GeoJsonPath line;
  line.name = document.name;
  line.kind = document.provenance.method;
  line.spatial = document.path.dimension() == 3;
  line.chord_tolerance = chord;
  line.promises = document.promises;
  std::vector<double> point(document.path.dimension());
  for (const double xi : sampled_parameters(document.path, plan).value()) {
    document.path.position(xi, point);
    line.points.push_back({point[0], point[1], line.spatial ? point[2] : 0.0});
  }
  return line;
}

std::string samples_csv(const AnyPath& path, const TimedMotion& motion, std::size_t count) {
  const bool planar = path.dimension() == 2;
  std::vector<std::string> names = {"time", "s", "x", "y", "z", "speed"};
  if (planar) names.insert(names.end(), {"heading", "curvature"});
  std::string text;
  append_csv_header(text, names);
  const TimingLaw& law = motion.law();
  double heading = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = count == 1 ? 0.0 : static_cast<double>(i) / static_cast<double>(count - 1);
    const double time = std::clamp(law.start_time() * (1.0 - share) + law.end_time() * share,
                                   law.start_time(), law.end_time());
    const double s = std::clamp(law.arc_length_at(time), 0.0, path.arc_length());
    const Vector3<double> place = motion.position(time);
    std::vector<double> row = {time, s, place.x, place.y, place.z, law.speed_at(time)};
    if (planar) {
      const PointState state = state_at(path, parameter_at(path, s));
      if (state.moves) {
        const double angle = std::atan2(state.tangent[1], state.tangent[0]);
        heading = i == 0 ? angle : heading + std::remainder(angle - heading, 2.0 * std::acos(-1.0));
      }
      row.insert(row.end(), {heading, state.moves ? state.curvature : 0.0});
    }
    append_csv_row(text, row);
  }
  return text;
}

void ExportFlags::add_to(Command& command, const std::string& chord_default) {
  given_ = std::make_shared<Given>();
  command.group("For other programs");
  command.option("--geojson", geojson, "FILE",
                 "the path in its world, as a line with what it promises");
  command.option("--csv", samples, "FILE",
                 "samples evenly spaced in time: place, speed, heading, curvature");
  add_sample_count(command, sample_count, "how many");
  command.option("--crazyswarm", crazyswarm, "FILE",
                 "a trajectory as CSV: polynomials of degree 7 in time, yaw 0");
  command.option("--qgroundcontrol", qgroundcontrol, "FILE",
                 "waypoints as a plan of QGroundControl (.plan); metres, needs --datum");
  command.option("--wpl", waypoints, "FILE", "waypoints as 'QGC WPL 110'; metres, needs --datum");
  const auto number = [&](const char* name, double& target, const char* shown,
                          const std::string& help) {
    given_->options.push_back(command.option(name, target, shown, help));
  };
  number("--chord", chord, "E",
         "how near the lines between points stay to the path, certified (default: " +
             chord_default + ")");
  add_datum(command, datum);
  number("--altitude", altitude, "Z", "of a path in the plane (default 0)");
  number("--speed", speed, "V", "of the flight (default 1; waypoints: not said)");
  number("--acceleration", acceleration, "A", "from rest to rest, up to the speed");
  number("--lateral-acceleration", lateral, "A", "with it: slower in bends");
  number("--tolerance", polynomial_tolerance, "LENGTH",
         "of the polynomials (default: 1e-6 of the length)");
}

double ExportFlags::near(double default_chord) const {
  return (*given_)(Given::Index::chord) ? chord : default_chord;
}

bool ExportFlags::any() const {
  return !(geojson.empty() && samples.empty() && crazyswarm.empty() && qgroundcontrol.empty() &&
           waypoints.empty());
}

Flight ExportFlags::flight() const {
  const Given& given = *given_;
  Flight flight;
  if (given(Given::Index::speed)) flight.speed = speed;
  if (given(Given::Index::acceleration)) flight.acceleration = acceleration;
  if (given(Given::Index::lateral)) flight.lateral_acceleration = lateral;
  if (given(Given::Index::altitude)) flight.altitude = altitude;
  return flight;
}

void ExportFlags::check() const {
  const Given& given = *given_;
  check_places(!(qgroundcontrol.empty() && waypoints.empty()), datum,
               given(Given::Index::chord) ? std::optional(chord) : std::nullopt);
  if (given(Given::Index::tolerance) && crazyswarm.empty()) {
    refuse("the tolerance is that of --crazyswarm; name its file, too", "tolerance");
  }
}

std::string ExportFlags::write(const PathDocument& document, GeoJsonScene scene,
                               double default_chord) const {
  if (!any()) return "";
  const Given& given = *given_;
  const double within = near(default_chord);
  const Flight flown = flight();
  const TimedMotion motion = motion_of(document.path, flown);
  std::string written;
  // Everything is made before anything is written.
  std::vector<std::pair<std::string, std::string>> files;
  const auto add = [&](const std::string& file, std::string text, const std::string& what) {
    files.emplace_back(file, std::move(text));
    written += "wrote " + file + (what.empty() ? "" : ": " + what) + "\n";
  };
  if (!geojson.empty()) {
    scene.datum = datum_of(datum);
    scene.altitude = flown.altitude.value_or(0.0);
    scene.paths.insert(scene.paths.begin(), line_of(document, within));
    const std::size_t points = scene.paths[0].points.size();
    add(geojson, to_geojson(scene).value(),
        "a line of " + counted(points, "point") + ", within " + to_text(within) +
            " of the path, certified");
  }
  if (!samples.empty()) {
    add(samples, samples_csv(document.path, motion, sample_count), counted(sample_count, "sample"));
  }
  if (!crazyswarm.empty()) {
    constexpr double share = 1e-6;  // not a tolerance: the default, of the length
    const double tolerance =
        given(Given::Index::tolerance) ? polynomial_tolerance : share * motion.length();
    const PolynomialFlight polynomials =
        polynomial_flight(document.path, motion, motion.start_time(), tolerance).value();
    add(crazyswarm, crazyswarm_csv(polynomials),
        counted(polynomials.pieces.size(), "polynomial") + ", within " +
            bound_text(polynomials.error) + " of the path at every instant, certified");
  }
  if (!(qgroundcontrol.empty() && waypoints.empty())) {
    const std::vector<LocalWaypoint> points = waypoints_of(document.path, motion, flown, within);
    const Mission planned = mission(points, *datum_of(datum)).value();
    const std::string what = counted(points.size(), "waypoint") + ", lines between them within " +
                             to_text(within) + " of the path, certified";
    if (!qgroundcontrol.empty()) add(qgroundcontrol, to_qgroundcontrol_plan(planned).value(), what);
    if (!waypoints.empty()) add(waypoints, to_waypoint_file(planned).value(), what);
  }
  write_files(files);
  return written;
}

}  // namespace hodograph::cli
