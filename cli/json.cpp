// SPDX-License-Identifier: MIT
#include "cli/json.hpp"

#include <cmath>
#include <utility>

namespace hodograph::cli {
namespace {

Json optional_json(const std::optional<double>& value) { return value ? Json(*value) : Json(); }

Json jumps(const std::vector<JumpFact>& facts) {
  Json list = Json::array();
  for (const JumpFact& fact : facts) {
    list.push_back({{"jump", fact.jump}, {"allowed", fact.allowed}, {"knot", fact.knot}});
  }
  return list;
}

void set_text(Json& object, const char* name, const std::string& text) {
  if (!text.empty()) object[name] = text;
}

}  // namespace

void append_json(std::string& out, const Json& value) {
  switch (value.type()) {
    case Json::value_t::object: {
      out += '{';
      bool first = true;
      for (const auto& [key, member] : value.items()) {
        if (!std::exchange(first, false)) out += ", ";
        out += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
        out += ": ";
        append_json(out, member);
      }
      out += '}';
      break;
    }
    case Json::value_t::array: {
      out += '[';
      bool first = true;
      for (const auto& item : value) {
        if (!std::exchange(first, false)) out += ", ";
        append_json(out, item);
      }
      out += ']';
      break;
    }
    case Json::value_t::number_float: {
      const auto number = value.get<double>();
      if (!std::isfinite(number)) {
        out += "null";
      } else if (number == 0.0 && std::signbit(number)) {
        out += "-0.0";
      } else {
        out += to_text(number);
      }
      break;
    }
    default:
      out += value.dump(-1, ' ', false, Json::error_handler_t::replace);
  }
}

Json json_of(const Enclosure& bound) {
  return {{"lower", bound.lower()}, {"upper", bound.upper()}};
}

Json json_of(const ErrorPromise& error) {
  Json json = json_of(error.distance);
  json["certified"] = error.certified;
  set_text(json, "against", error.against);
  return json;
}

Json json_of(const ContinuityOrders& orders) {
  return {{"position", orders.position},
          {"preimage", orders.preimage},
          {"frame", orders.frame},
          {"angular_velocity", orders.angular_velocity}};
}

Json json_of(const Fault& fault) {
  return {{"code", std::string(name_of(fault.code))},
          {"sentence", fault.sentence},
          {"index", fault.index ? Json(*fault.index) : Json()},
          {"quantity", fault.quantity.empty() ? Json() : Json(fault.quantity)},
          {"value", optional_json(fault.value)},
          {"bound", optional_json(fault.bound)}};
}

Json json_of(const PathFacts& facts) {
  Json json = {{"arc_length", json_of(facts.arc_length)},
               {"smallest_speed", json_of(facts.smallest_speed)},
               {"largest_speed", json_of(facts.largest_speed)},
               {"curvature_bound", facts.curvature_bound},
               {"continuity", json_of(facts.continuity)},
               {"jumps",
                {{"position", jumps(facts.position)},
                 {"preimage", jumps(facts.preimage)},
                 {"frame", jumps(facts.frame)},
                 {"angular_velocity", jumps(facts.angular_velocity)}}}};
  if (facts.holonomy) {
    json["holonomy"] = {{"roll", facts.holonomy->roll}, {"preimage_sign", facts.holonomy->sign}};
  }
  return json;
}

Json json_of(const PointState& state) {
  Json json = {{"xi", state.xi},
               {"arc_length", state.arc_length},
               {"position", state.position},
               {"preimage", state.preimage},
               {"speed", state.speed}};
  json["tangent"] = state.moves ? Json(state.tangent) : Json();
  json["curvature"] = state.moves ? Json(state.curvature) : Json();
  json["torsion"] = optional_json(state.torsion);
  json["frame"] = state.moves ? Json(state.frame) : Json();
  if (state.moves) {
    json["angular_velocity"] = {{"body_per_xi", state.rates.body_per_xi},
                                {"world_per_xi", state.rates.world_per_xi},
                                {"body_per_arc_length", state.rates.body_per_arc_length},
                                {"world_per_arc_length", state.rates.world_per_arc_length}};
  } else {
    json["angular_velocity"] = Json();
  }
  if (state.frenet) {
    json["frenet"] = {{"tangent", state.frenet->tangent},   {"normal", state.frenet->normal},
                      {"binormal", state.frenet->binormal}, {"curvature", state.frenet->curvature},
                      {"torsion", state.frenet->torsion},   {"roll", state.frenet->roll}};
  } else {
    json["frenet"] = Json();
  }
  return json;
}

Json json_of(const PathDocument& document, const PathFacts& facts) {
  const AnyPath& path = document.path;
  Json json;
  set_text(json, "name", document.name);
  json["algebra"] = path.dimension() == 2 ? "complex" : "quaternion";
  json["dimension"] = path.dimension();
  json["preimage_degree"] = path.preimage_degree();
  json["degree"] = path.degree();
  json["segments"] = path.segment_count();
  json["closed"] = path.is_closed();
  json["xi"] = {path.xi_begin(), path.xi_end()};
  json["length"] = path.arc_length();
  if (!document.length_unit.empty() || !document.parameter_unit.empty()) {
    json["units"] = Json::object();
    set_text(json["units"], "length", document.length_unit);
    set_text(json["units"], "parameter", document.parameter_unit);
  }
  json.update(json_of(facts));
  if (const Provenance& from = document.provenance; !from.empty()) {
    Json& provenance = json["provenance"] = Json::object();
    set_text(provenance, "program", from.program);
    set_text(provenance, "source", from.source);
    set_text(provenance, "method", from.method);
    set_text(provenance, "choice", from.choice);
    if (from.tolerance) provenance["tolerance"] = *from.tolerance;
  }
  if (const Promises& promises = document.promises; !promises.empty()) {
    Json& list = json["promises"] = Json::object();
    if (promises.continuity) list["continuity"] = json_of(*promises.continuity);
    if (promises.error) list["error"] = json_of(*promises.error);
    if (promises.arc_length) list["arc_length"] = json_of(*promises.arc_length);
    if (promises.smallest_speed) list["smallest_speed"] = json_of(*promises.smallest_speed);
    if (promises.largest_speed) list["largest_speed"] = json_of(*promises.largest_speed);
    if (const auto& end = promises.end) {
      list["end"] =
          document.path.dimension() == 2 ? list_of(Vector2<double>{end->x, end->y}) : list_of(*end);
    }
    if (promises.largest_curvature) {
      list["largest_curvature"] = json_of(*promises.largest_curvature);
    }
    if (promises.curvature_bound) list["curvature_bound"] = *promises.curvature_bound;
  }
  return json;
}

}  // namespace hodograph::cli
