// SPDX-License-Identifier: MIT
#include "cli/motions.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string_view>

#include "cli/made_path.hpp"
#include "cli/refuse.hpp"
#include "cli/requests/members.hpp"
#include "hodograph/path/curvature_limited_timing.hpp"

namespace hodograph::cli {
namespace {

/// |(x, y, z · scale)|.
double distance(const Vector3<double>& a, const Vector3<double>& b, double vertical_scale) {
  return std::hypot(a.x - b.x, a.y - b.y, vertical_scale * (a.z - b.z));
}

std::string point_text(const Vector3<double>& p, bool planar) {
  return "(" + to_six_digits(p.x) + ", " + to_six_digits(p.y) +
         (planar ? ")" : ", " + to_six_digits(p.z) + ")");
}

}  // namespace

TimedMotion motion_of(const AnyPath& path, const Flight& flight) {
  if (flight.arrival && (flight.speed || flight.acceleration)) {
    refuse("an arrival time goes with a constant speed that follows from it; leave out the " +
               std::string(flight.speed ? "speed" : "acceleration"),
           "arrival");
  }
  if (!flight.acceleration && (flight.deceleration || flight.lateral_acceleration)) {
    refuse(std::string("a ") + (flight.deceleration ? "deceleration" : "lateral acceleration") +
               " needs an acceleration, too",
           "acceleration");
  }
  const double length = path.arc_length(), speed = flight.speed.value_or(1.0);
  const double altitude = flight.altitude.value_or(0.0);
  if (flight.arrival) {
    return TimedMotion::create(
               path, TimingLaw::between(length, flight.departure, *flight.arrival).value(),
               flight.presence, altitude)
        .value();
  }
  if (!flight.acceleration) {
    return TimedMotion::create(path,
                               TimingLaw::constant_speed(length, speed, flight.departure).value(),
                               flight.presence, altitude)
        .value();
  }
  const TrapezoidalSpeed limits{speed, *flight.acceleration,
                                flight.deceleration.value_or(*flight.acceleration)};
  TimedMotion motion =
      TimedMotion::create(path, TimingLaw::trapezoidal(length, limits, flight.departure).value(),
                          flight.presence, altitude)
          .value();
  if (!flight.lateral_acceleration) return motion;
  LateralLimit limit;
  limit.lateral_acceleration = *flight.lateral_acceleration;
  limit.along = limits;
  return TimedMotion::create(
             path,
             curvature_limited_timing(motion.places().parts(), limit, flight.departure).value(),
             flight.presence, altitude)
      .value();
}

Presence presence_of(const std::string& word) {
  return {word == "always" || word == "before", word == "always" || word == "after"};
}

Flight flight_of(Members& members) {
  Flight flight;
  flight.departure = members.number("departure", 0.0);
  flight.speed = members.maybe_number("speed");
  flight.arrival = members.maybe_number("arrival");
  flight.acceleration = members.maybe_number("acceleration");
  flight.deceleration = members.maybe_number("deceleration");
  flight.lateral_acceleration = members.maybe_number("lateral_acceleration");
  flight.presence = presence_of(members.word(
      "stands", {std::begin(standing_words), std::end(standing_words)}, standing_words[0]));
  flight.altitude = members.maybe_number("altitude");
  return flight;
}

double vertical_scale_of(double factor) {
  if (factor > 0.0 && std::isfinite(factor) && std::isfinite(1.0 / factor)) return 1.0 / factor;
  throw Error(Fault{FaultCode::outside_domain,
                    "the factor of the ellipsoid is " + to_text(factor) +
                        "; it should be positive: 3 where heights count a third",
                    std::nullopt, "ellipsoid", factor, 0.0});
}

const char* word_of(hodograph::Answer answer) {
  return answer == hodograph::Answer::yes  ? "yes"
         : answer == hodograph::Answer::no ? "no"
                                           : "undecided";
}

SeparationFacts separation_facts(const TimedMotion& a, const TimedMotion& b,
                                 const SeparationGoal& goal, const std::optional<double>& at_least,
                                 const std::optional<double>& step) {
  if (at_least && !(*at_least >= 0.0 && std::isfinite(*at_least))) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the distance to keep is " + to_text(*at_least) + "; it should be 0 or more",
                      std::nullopt, "at_least", at_least, 0.0});
  }
  SeparationFacts facts{least_separation(a, b, goal).value()};
  facts.at_least = at_least;
  if (at_least) {
    facts.keeps = separated_by(a, b, *at_least, goal);
    if (facts.keeps != hodograph::Answer::yes) {
      constexpr double parts = 1024.0;  // of the common time: how closely passages are told
      const TimeWindow window = common_window(a, b).value_or(TimeWindow{0.0, 0.0});
      const double resolution = (window.end - window.begin) / parts;
      if (resolution > 0.0) {
        facts.passages = close_passages(a, b, *at_least, resolution, goal).value();
      }
    }
  }
  if (step) facts.stepped = stepped_separation(a, b, *step, goal).value();
  return facts;
}

Json json_of(const std::vector<ClosePassage>& passages) {
  Json list = Json::array();
  for (const ClosePassage& passage : passages) {
    list.push_back({{"begin", passage.begin}, {"end", passage.end}, {"certain", passage.certain}});
  }
  return list;
}

Json json_of(const SeparationFacts& facts) {
  const Separation& least = facts.least;
  Json json = {{"distance", json_of(least.distance)},
               {"time", least.time},
               {"time_range", json_of(least.time_range)},
               {"first", list_of(least.first)},
               {"second", list_of(least.second)}};
  if (facts.at_least) {
    json["at_least"] = *facts.at_least;
    json["keeps"] = word_of(facts.keeps);
    json["passages"] = json_of(facts.passages);
  }
  if (facts.stepped) {
    json["stepped"] = {{"sampled", facts.stepped->sampled},
                       {"time", facts.stepped->time},
                       {"distance", json_of(facts.stepped->distance)},
                       {"evaluations", facts.stepped->evaluations}};
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const SeparationFacts& facts) {
  const Separation& least = facts.least;
  const bool planar = least.first.z == 0.0 && least.second.z == 0.0;
  std::vector<std::pair<std::string, std::string>> rows = {
      {"Least distance", "at least " + to_text(least.distance.lower()) + ", at most " +
                             to_text(least.distance.upper()) + ", at any time; certified"},
      {"When", "at " + to_six_digits(least.time)},
      {"The first is at", point_text(least.first, planar)},
      {"The second is at", point_text(least.second, planar)}};
  if (facts.at_least) {
    rows.emplace_back("Keeps " + to_six_digits(*facts.at_least),
                      facts.keeps == hodograph::Answer::undecided ? "undecided within rounding"
                                                                  : word_of(facts.keeps));
    for (const ClosePassage& passage : facts.passages) {
      rows.emplace_back(
          passage.certain ? "Closer" : "Perhaps closer",
          "from " + to_six_digits(passage.begin) + " to " + to_six_digits(passage.end));
    }
  }
  if (facts.stepped) {
    rows.emplace_back("By stepping", "samples at least " + to_six_digits(facts.stepped->sampled) +
                                         " apart, hence at least " +
                                         to_six_digits(facts.stepped->distance.lower()));
  }
  return rows;
}

std::string table_of(const std::vector<std::pair<std::string, std::string>>& rows) {
  constexpr std::size_t column = 20;
  std::string text;
  for (const auto& [name, value] : rows) {
    std::string left = "  " + name;
    left.resize(std::max(column, left.size() + 2), ' ');
    text += left + value + "\n";
  }
  return text;
}

Series distances_in_time(const TimedMotion& a, const TimedMotion& b, double vertical_scale,
                         std::size_t points) {
  Series series;
  const auto window = common_window(a, b);
  if (!window) return series;
  for (std::size_t i = 0; i <= points; ++i) {
    const double x = static_cast<double>(i) / static_cast<double>(points);
    const double t = window->begin * (1.0 - x) + window->end * x;
    series.x.push_back(t);
    series.y.push_back(distance(a.position(t), b.position(t), vertical_scale));
  }
  return series;
}

Series at_zero(const Series& series) {
  Series point{"", {}, {}, SeriesStyle::thin_line, PlotColor::grey};
  if (!series.x.empty()) {
    point.x = {series.x.front()};
    point.y = {0.0};
  }
  return point;
}

Plot separation_picture(const TimedMotion& a, const TimedMotion& b, const SeparationGoal& goal,
                        const SeparationFacts& facts) {
  constexpr std::size_t points = 1000;
  Plot plot;
  plot.title = "Separation";
  plot.x.label = "time";
  plot.y.label = "distance";
  plot.series.push_back(distances_in_time(a, b, goal.vertical_scale, points));
  plot.series.back().color = PlotColor::blue;
  plot.series.push_back(at_zero(plot.series.back()));
  if (facts.at_least) plot.levels.push_back({*facts.at_least, to_six_digits(*facts.at_least)});
  plot.marks.push_back({{facts.least.time, facts.least.distance.upper()},
                        "least " + to_six_digits(facts.least.distance.lower()),
                        PlotColor::vermilion});
  return plot;
}

}  // namespace hodograph::cli
