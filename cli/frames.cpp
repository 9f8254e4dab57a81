// SPDX-License-Identifier: MIT
#include "cli/frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/drawing.hpp"
#include "cli/made_path.hpp"
#include "cli/options.hpp"
#include "cli/sample_plan.hpp"
#include "cli/terminal.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/frame/adapted_frame.hpp"

namespace hodograph::cli {
namespace {

Fault wrong_member(const std::string& sentence, const char* quantity) {
  return {FaultCode::unsupported, sentence, std::nullopt, quantity, std::nullopt, std::nullopt};
}

/// Refuses what a kind of frame does not have.
void check(const FrameRequest& request) {
  const bool periodic = request.kind == "periodic", least = request.kind == "least-twist";
  const bool turns = least || request.kind == "rotation-minimising";
  if (!periodic && (request.gamma || !request.found_gamma.empty())) {
    throw Error(
        wrong_member("gamma is for the kind periodic; this one is " + request.kind, "gamma"));
  }
  if (!turns && (request.begin || request.begin_normal)) {
    throw Error(wrong_member(
        "where the second axis begins can be chosen for the kinds rotation-minimising and "
        "least-twist; this one is " +
            request.kind,
        "begin"));
  }
  if (!least && (request.end || request.end_normal)) {
    throw Error(wrong_member(
        "where the second axis ends can be chosen for the kind least-twist; this one is " +
            request.kind,
        "end"));
  }
  if ((request.begin && request.begin_normal) || (request.end && request.end_normal)) {
    throw Error(wrong_member(
        "give where the second axis points as an angle or as a direction, one of them", "begin"));
  }
}

double found_gamma(const PreimageTable& table, const FrameRequest& request) {
  if (request.gamma) return *request.gamma;
  if (request.found_gamma == "smooth-negative") {
    return smooth_periodic_gammas(table).value().negative;
  }
  if (request.found_gamma == "smooth-positive") {
    return smooth_periodic_gammas(table).value().positive;
  }
  return least_twist_gamma(table).value().gamma;
}

FrameRoll roll_of(const PreimageTable& table, const FrameRequest& request) {
  double begin = request.begin.value_or(0.0);
  std::optional<double> end = request.end;
  if (request.begin_normal) {
    begin = roll_towards(table, table.knots.front(), *request.begin_normal);
  }
  if (request.end_normal) end = roll_towards(table, table.knots.back(), *request.end_normal);
  if (request.kind == "frenet") return frenet_roll(table).value();
  if (request.kind == "rotation-minimising") {
    return rotation_minimising_roll(table, begin, RollIntegration::closed_form).value();
  }
  if (request.kind == "periodic") {
    return periodic_roll(table, found_gamma(table, request)).value();
  }
  if (request.kind == "least-twist") return least_twist_roll(table, begin, end).value();
  return FrameRoll::none(table);
}

const char* word_of(RollMethod method) {
  switch (method) {
    case RollMethod::polynomial:
      return "polynomial";
    case RollMethod::argument:
      return "argument";
    case RollMethod::partial_fractions:
      return "partial_fractions";
    case RollMethod::quadrature:
      return "quadrature";
  }
  return "";
}

constexpr std::array<RollMethod, 4> methods = {RollMethod::polynomial, RollMethod::argument,
                                               RollMethod::partial_fractions,
                                               RollMethod::quadrature};

std::size_t count_of(const FrameRoll& roll, RollMethod method) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < roll.segment_count(); ++k) count += roll.method(k) == method ? 1 : 0;
  return count;
}

/// A knot where the principal normal jumps, and by how much (radians, to π).
struct NormalJump {
  std::size_t knot = 0;
  double angle = 0.0;
};

/// Where two segments meet with different principal normals: the curvature's direction need not go
/// on, and is its opposite where the path bends to the other side.
std::vector<NormalJump> normal_jumps(const MadeFrame& frame) {
  std::vector<NormalJump> jumps;
  const PreimageTable& path = frame.table;
  const std::size_t n = path.degree, count = path.segment_count();
  const auto normal = [&](std::size_t coefficient, double theta) {
    const std::array<Quaternion<double>, 1> jet{path.coefficients[coefficient]};
    return rolled(euler_rodrigues_frame(jet), theta).e2;
  };
  const double rounding = accuracy::join_error<double>() + 4.0 * frame.roll.error_bound();
  for (std::size_t k = path.closed ? 0 : 1; k < count; ++k) {
    const std::size_t before = k == 0 ? count - 1 : k - 1;
    const Vector3<double> end = normal(before * (n + 1) + n, frame.roll.angle_at_end(before));
    const Vector3<double> begin = normal(k * (n + 1), frame.roll.angle_at_begin(k));
    const double angle = 2.0 * std::atan2(norm(end - begin), norm(end + begin));
    if (angle > rounding) jumps.push_back({k, angle});
  }
  return jumps;
}

std::string text_of(const Enclosure& bound) {
  return bound.width() <= std::numeric_limits<float>::epsilon() * (1.0 + bound.magnitude())
             ? to_six_digits(bound.middle())
             : "between " + to_six_digits(bound.lower()) + " and " + to_six_digits(bound.upper());
}

}  // namespace

MadeFrame make_frame(const PathDocument& document, const FrameRequest& request) {
  check(request);
  PreimageTable table = PreimageTable::of(document.path).value();
  FrameRoll roll = roll_of(table, request);
  FrameTwist twist = frame_twist(table, roll).value();
  FrameTwist erf = frame_twist(table, FrameRoll::none(table)).value();
  return {std::move(table), std::move(roll), std::move(twist), std::move(erf)};
}

void set_gamma(FrameRequest& request, const std::string& text) {
  if (std::find(found_gammas.begin(), found_gammas.end(), text) != found_gammas.end()) {
    request.found_gamma = text;
    return;
  }
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != '\0') {
    throw Error(Fault{FaultCode::malformed_document,
                      "gamma is a number, least, smooth-negative or smooth-positive; got '" +
                          on_one_line(text) + "'",
                      std::nullopt, "gamma", std::nullopt, std::nullopt});
  }
  request.gamma = value;
}

Json json_of(const MadeFrame& frame, const FrameRequest& request) {
  Json json = {{"kind", request.kind}, {"angle_error", frame.roll.error_bound()}};
  if (frame.roll.kind() == RollKind::periodic) {
    json["gamma"] = frame.roll.gamma();
    json["psi"] = frame.roll.psi();
  }
  if (frame.roll.kind() == RollKind::least_twist) json["twist_rate"] = frame.roll.twist_rate();
  json["twist"] = json_of(frame.twist.total);
  json["absolute_twist"] = json_of(frame.twist.absolute);
  json["erf_twist"] = json_of(frame.erf_twist.total);
  Json& inflections = json["inflections"] = Json::array();
  for (const auto& inflection : frame.twist.inflections) {
    inflections.push_back(
        {{"xi", json_of(inflection.xi)}, {"certain", inflection.kind == RootKind::simple}});
  }
  if (frame.roll.kind() == RollKind::frenet) {
    Json& flips = json["normal_flips"] = Json::array();
    for (const auto& flip : frame.roll.inflections()) flips.push_back(flip.xi);
    Json& jumps = json["normal_jumps"] = Json::array();
    for (const NormalJump& jump : normal_jumps(frame)) {
      jumps.push_back({{"knot", jump.knot}, {"angle", jump.angle}});
    }
  }
  Json& found = json["segments_by"] = Json::object();
  for (const RollMethod method : methods) {
    if (const auto count = count_of(frame.roll, method)) found[word_of(method)] = count;
  }
  return json;
}

std::vector<std::pair<std::string, std::string>> rows_of(const MadeFrame& frame,
                                                         const FrameRequest& request) {
  std::vector<std::pair<std::string, std::string>> rows{{"Frame", request.kind}};
  if (frame.roll.kind() == RollKind::periodic) {
    rows.push_back({"Gamma", to_text(frame.roll.gamma())});
  }
  rows.push_back({"Twist", text_of(frame.twist.total) + " rad"});
  rows.push_back({"Absolute twist", text_of(frame.twist.absolute) + " rad"});
  rows.push_back({"Twist of the Euler-Rodrigues frame", text_of(frame.erf_twist.total) + " rad"});
  constexpr std::size_t most_listed = 6;
  const auto& inflections = frame.twist.inflections;
  std::string places =
      inflections.empty() ? "none" : std::to_string(inflections.size()) + ", at xi";
  for (std::size_t i = 0; i < std::min(inflections.size(), most_listed); ++i) {
    places += (i == 0 ? " " : ", ") + to_six_digits(inflections[i].xi.middle());
    if (inflections[i].kind != RootKind::simple) places += " (undecided)";
  }
  rows.push_back(
      {"Inflections of the frame", places + (inflections.size() > most_listed ? ", ..." : "")});
  if (frame.roll.kind() == RollKind::frenet && !frame.roll.inflections().empty()) {
    std::string flips = std::to_string(frame.roll.inflections().size()) + ", at xi";
    for (std::size_t i = 0; i < std::min(frame.roll.inflections().size(), most_listed); ++i) {
      flips += (i == 0 ? " " : ", ") + to_six_digits(frame.roll.inflections()[i].xi);
    }
    rows.push_back({"The normal changes sides", flips});
  }
  if (frame.roll.kind() == RollKind::frenet) {
    const auto jumps = normal_jumps(frame);
    std::string knots = std::to_string(jumps.size()) + ", at knot";
    for (std::size_t i = 0; i < std::min(jumps.size(), most_listed); ++i) {
      knots += (i == 0 ? " " : ", ") + std::to_string(jumps[i].knot) + " by " +
               to_six_digits(jumps[i].angle) + " rad";
    }
    if (jumps.size() > most_listed) knots += ", ...";
    if (!jumps.empty()) rows.push_back({"The normal jumps", knots});
  }
  rows.push_back(
      {"Error of the angle", "below " + to_six_digits(frame.roll.error_bound()) + " rad"});
  return rows;
}

std::vector<FramePlace> places_of(const MadeFrame& frame, const AnyPath& path,
                                  const std::vector<double>& xi) {
  std::vector<FramePlace> places;
  places.reserve(xi.size());
  std::array<double, 3> point{};
  for (const double at : xi) {
    path.position(at, point);
    places.push_back({at,
                      path.arc_length(at),
                      {point[0], point[1], point[2]},
                      rolled_state(frame.table, frame.roll, at)});
  }
  return places;
}

std::vector<std::string> frame_columns() {
  return {"xi",  "s",   "x",   "y",   "z",   "roll", "qw",  "qx",  "qy",     "qz",     "e1x",
          "e1y", "e1z", "e2x", "e2y", "e2z", "e3x",  "e3y", "e3z", "omega1", "omega2", "omega3"};
}

std::vector<double> row_of(const FramePlace& place) {
  const RolledState& s = place.state;
  std::vector<double> row{place.xi,         place.arc_length, place.position.x, place.position.y,
                          place.position.z, s.roll,           s.rotation.w,     s.rotation.x,
                          s.rotation.y,     s.rotation.z};
  for (const auto& axis : {s.frame.e1, s.frame.e2, s.frame.e3}) {
    for (std::size_t i = 0; i < 3; ++i) row.push_back(axis[i]);
  }
  for (std::size_t i = 0; i < 3; ++i) row.push_back(s.body_rate_per_xi[i] / s.speed);
  return row;
}

Json json_of(const FramePlace& place) {
  const RolledState& s = place.state;
  return {{"xi", place.xi},
          {"arc_length", place.arc_length},
          {"position", list_of(place.position)},
          {"roll", s.roll},
          {"rotation", list_of(s.rotation)},
          {"axes", {list_of(s.frame.e1), list_of(s.frame.e2), list_of(s.frame.e3)}},
          {"body_rate_per_arc_length", list_of((1.0 / s.speed) * s.body_rate_per_xi)}};
}

FramePictures pictures_of(const MadeFrame& frame, const PathDocument& document) {
  constexpr std::size_t drawn = 600, shown_frames = 48;
  const AnyPath& path = document.path;
  FramePictures pictures;
  pictures.path = framed_polyline(document, drawn, 0);
  SamplePlan plan;
  plan.count = shown_frames;
  for (const auto& place : places_of(frame, path, sampled_parameters(path, plan).value())) {
    pictures.path.frame_origins.push_back(place.position);
    pictures.path.frames.push_back(place.state.frame);
  }
  const std::string unit =
      document.length_unit.empty() ? "rad per unit length" : "rad/" + document.length_unit;
  const FrameRoll none = FrameRoll::none(frame.table);
  Series roll, own{"this frame"}, erf{"Euler-Rodrigues frame"}, second{"ω2"}, third{"ω3"};
  erf.style = SeriesStyle::dashed_line;
  SamplePlan along;
  along.count_per_segment = std::max<std::size_t>(2, drawn / path.segment_count());
  for (const double xi : sampled_parameters(path, along).value()) {
    const RolledState state = rolled_state(frame.table, frame.roll, xi);
    const RolledState plain = rolled_state(frame.table, none, xi);
    for (Series* series : {&roll, &own, &erf, &second, &third}) series->x.push_back(xi);
    roll.y.push_back(state.roll);
    own.y.push_back(state.body_rate_per_xi.x / state.speed);
    erf.y.push_back(plain.body_rate_per_xi.x / plain.speed);
    second.y.push_back(state.body_rate_per_xi.y / state.speed);
    third.y.push_back(state.body_rate_per_xi.z / state.speed);
  }
  const auto plot = [&](const std::string& title, const std::string& axis,
                        std::vector<Series> series) {
    Plot result;
    result.title = title;
    result.x.label = "ξ";
    result.y.label = axis;
    result.series = std::move(series);
    result.clip_outliers = true;
    pictures.plots.push_back(std::move(result));
  };
  plot("Rotation about the tangent ω1", unit, {own, erf});
  for (const auto& inflection : frame.twist.inflections) {
    pictures.plots.back().x_marks.push_back(inflection.xi.middle());
  }
  plot("Rotation across the tangent", unit, {second, third});
  plot("Roll against the Euler-Rodrigues frame", "rad", {roll});
  return pictures;
}

}  // namespace hodograph::cli
