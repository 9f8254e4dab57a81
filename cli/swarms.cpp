// SPDX-License-Identifier: MIT
#include "cli/swarms.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <set>

#include "cli/made_path.hpp"
#include "cli/plans.hpp"
#include "cli/refuse.hpp"
#include "cli/requests/members.hpp"
#include "hodograph/io/table.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t most_vehicles = 10'000;  // whose pairs are answered in minutes

DirectedPoint directed_point(Members end) {
  if (end.has("direction") == end.has("angle")) {
    end.refuse("direction", "give the direction as \"direction\" or as \"angle\", one of them");
  }
  const auto position = end.numbers("position", 2);
  DirectedPoint point{{position[0], position[1]}, {}};
  if (end.has("angle")) {
    point.direction = direction_of_angle(end.number("angle"));
  } else {
    const auto direction = end.numbers("direction", 2);
    point.direction = {direction[0], direction[1]};
  }
  end.require_all_known();
  return point;
}

/// What serves as the name of a file everywhere.
bool is_plain(const std::string& id) {
  constexpr std::size_t longest = 64;
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-';
  };
  return !id.empty() && id.size() <= longest && std::all_of(id.begin(), id.end(), plain);
}

std::string id_of(Members& vehicle, std::size_t number, std::set<std::string>& taken) {
  std::string id = vehicle.text("id", std::to_string(number + 1));
  if (!is_plain(id)) {
    vehicle.refuse(
        "id", in_quotes(id) + " does not serve as a name: up to 64 letters, digits, - and _ do");
  }
  if (!taken.insert(id).second) vehicle.refuse("id", in_quotes(id) + " is another vehicle's, too");
  return id;
}

ArrivingVehicle arriving_vehicle(Members& vehicle, std::string id) {
  ArrivingVehicle result{std::move(id), directed_point(vehicle.object("start")),
                         directed_point(vehicle.object("end"))};
  result.speed = vehicle.number("speed", 1.0);
  if (!(result.speed > 0.0)) {
    vehicle.refuse("speed", "a speed is positive; here is " + to_text(result.speed));
  }
  result.departure = vehicle.number("departure", 0.0);
  result.radius = vehicle.number("radius", 0.0);
  result.most_curvature = vehicle.maybe_number("most_curvature");
  result.presence = presence_of(
      vehicle.word("stands", {std::begin(standing_words), std::end(standing_words)}, "always"));
  result.altitude = vehicle.number("altitude", 0.0);
  vehicle.require_all_known();
  return result;
}

FlyingVehicle flying_vehicle(Members& vehicle, std::string id) {
  FlyingVehicle result{std::move(id), vehicle.document()};
  result.flight = flight_of(vehicle);
  result.radius = vehicle.number("radius", 0.0);
  result.fixed = vehicle.truth("fixed", false);
  vehicle.require_all_known();
  return result;
}

ArrivalChoice arrival_choice(Members& members) {
  const char* const ways[] = {"arrival", "length", "excess", "least"};
  if (std::count_if(std::begin(ways), std::end(ways),
                    [&](const char* way) { return members.has(way); }) != 1) {
    members.refuse("arrival",
                   "say when the vehicles arrive by one of \"arrival\", \"length\", \"excess\" and "
                   "\"least\"");
  }
  ArrivalChoice choice;
  choice.arrival = members.maybe_number("arrival");
  choice.length = members.maybe_number("length");
  choice.excess = members.maybe_number("excess");
  if (members.has("least")) {
    choice.separated = members.word("least", {"feasible", "separated"}) == "separated";
  }
  return choice;
}

ArrivalMoves arrival_moves(Members moves, bool& longest_delay_given) {
  ArrivalMoves result;
  constexpr std::size_t delays = 4, later_arrivals = 4;
  constexpr double latest_excess = 0.25;
  longest_delay_given = moves.has("longest_delay");
  result.departure.longest_delay = moves.number("longest_delay", 0.0);
  result.departure.delays = moves.count("delays", delays);
  result.departure.most_choices = moves.count("most_choices", result.departure.most_choices);
  result.other_solution = moves.truth("other_solution", true);
  result.latest_excess = moves.number("latest_excess", latest_excess);
  result.later_arrivals = moves.count("later_arrivals", later_arrivals);
  moves.require_at_most("delays", result.departure.delays, most_places);
  moves.require_at_most("later_arrivals", result.later_arrivals, most_places);
  moves.require_all_known();
  return result;
}

/// The arrival time of a choice that names one.
double arrival_time(const std::vector<ArrivingVehicle>& vehicles, const ArrivalChoice& choice) {
  if (choice.arrival) return *choice.arrival;
  if (choice.length) {
    for (const ArrivingVehicle& v : vehicles) {
      if (v.speed != vehicles[0].speed || v.departure != vehicles[0].departure) {
        refuse("paths of one length bring vehicles together that leave together at one speed; '" +
                   v.id + "' leaves at " + to_text(v.departure) + " with speed " +
                   to_text(v.speed) + ", '" + vehicles[0].id + "' at " +
                   to_text(vehicles[0].departure) + " with " + to_text(vehicles[0].speed) +
                   "; give the arrival instead",
               "length");
      }
    }
    return vehicles[0].departure + *choice.length / vehicles[0].speed;
  }
  double longest = 0.0;
  for (const ArrivingVehicle& v : vehicles) {
    const Vector2<double> chord = v.end.position - v.begin.position;
    longest = std::max(longest, std::hypot(chord.x, chord.y) / v.speed);
  }
  const double time = earliest_arrival(vehicles) + *choice.excess * longest;
  if (!std::isfinite(time)) {
    throw Error(Fault{FaultCode::outside_domain,
                      "with an excess of " + to_text(*choice.excess) +
                          " the vehicles would arrive beyond all numbers; the longest straight "
                          "flight takes " +
                          to_text(longest),
                      std::nullopt, "excess", *choice.excess, std::nullopt});
  }
  return time;
}

SimultaneousArrival arrival_of(const SwarmRequest& request, std::span<const Vehicle> others) {
  const ArrivalChoice& choice = request.arrival;
  if (choice.arrival || choice.length || choice.excess) {
    return arrival_at(request.arriving, arrival_time(request.arriving, choice)).value();
  }
  if (choice.separated) {
    return least_separated_arrival(request.arriving, request.goal, {}, others).value();
  }
  return least_arrival(request.arriving).value();
}

PathDocument document_of(const ArrivingPath& path, const ArrivingVehicle& vehicle, double arrival) {
  const std::string choice = "solution " + std::to_string(path.solution + 1) + ", leaves at " +
                             to_text(path.departure) + ", arrives at " + to_text(arrival) +
                             ", speed " + to_text(vehicle.speed);
  PathDocument document = made_path(AnyPath(path.path), "swarm: vehicle " + vehicle.id,
                                    "G1 Hermite of prescribed length", choice)
                              .document;
  document.name = vehicle.id;
  document.promises.largest_curvature = largest_curvature(document.path);
  return document;
}

/// The longest delay that is tried where none is given.
double delay_limit(const SwarmRequest& request, double longest_flight) {
  constexpr double share = 0.125;
  return request.longest_delay_given ? request.deconflict->departure.longest_delay
                                     : share * longest_flight;
}

/// Makes the paths of the arriving vehicles, beside others that stay as they are.
SimultaneousArrival fly_arriving(const SwarmRequest& request, std::span<const Vehicle> others,
                                 SwarmFacts& facts) {
  SimultaneousArrival plan = arrival_of(request, others);
  if (request.deconflict) {
    ArrivalMoves moves = *request.deconflict;
    double longest = 0.0;
    for (const ArrivingVehicle& v : request.arriving) {
      longest = std::max(longest, plan.arrival - v.departure);
    }
    moves.departure.longest_delay = delay_limit(request, longest);
    SeparatedArrival apart =
        deconflict_arrival(request.arriving, plan.arrival, request.goal, moves, others).value();
    facts.effort = apart.effort;
    plan = std::move(apart.plan);
  }
  facts.arrival = plan.arrival;
  return plan;
}

/// The given vehicles, delayed where that is asked for and none is to be made around them.
std::vector<Vehicle> fly_given(const SwarmRequest& request, SwarmFacts& facts) {
  double longest = 0.0;
  std::vector<Vehicle> vehicles, moving, fixed;
  for (const FlyingVehicle& v : request.flying) {
    vehicles.push_back({v.id, motion_of(v.document.path, v.flight), v.radius});
    longest = std::max(longest, vehicles.back().motion.law().duration());
    (v.fixed ? fixed : moving).push_back(vehicles.back());
  }
  if (!request.deconflict || !request.arriving.empty() || moving.empty()) return vehicles;
  DelayMoves moves = request.deconflict->departure;
  moves.longest_delay = delay_limit(request, longest);
  DelayedSwarm apart = deconflict_by_delays(moving, request.goal, moves, fixed).value();
  facts.effort = apart.effort;
  std::size_t next = 0;
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    if (!request.flying[i].fixed) vehicles[i] = std::move(apart.vehicles[next++]);
  }
  return vehicles;
}

void add_made(const ArrivingVehicle& wanted, ArrivingPath path, Vehicle vehicle, double arrival,
              SwarmFacts& facts) {
  facts.documents.push_back(document_of(path, wanted, arrival));
  Flight flight;
  flight.departure = path.departure;
  flight.arrival = arrival;
  flight.presence = wanted.presence;
  if (wanted.altitude != 0.0) flight.altitude = wanted.altitude;
  facts.flights.push_back(flight);
  facts.vehicles.push_back(std::move(vehicle));
  facts.made.emplace_back(std::move(path));
}

void add_given(const FlyingVehicle& wanted, Vehicle vehicle, SwarmFacts& facts) {
  Flight flight = wanted.flight;
  flight.departure = vehicle.motion.start_time();
  if (flight.arrival) flight.arrival = vehicle.motion.end_time();
  facts.flights.push_back(flight);
  facts.documents.push_back(wanted.document);
  facts.vehicles.push_back(std::move(vehicle));
  facts.made.emplace_back();
}

std::string seven(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%-13.7g", value);
  return text;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size() + 2), ' ');
  return text;
}

}  // namespace

SwarmRequest swarm_request(Members& members) {
  SwarmRequest request;
  std::set<std::string> taken;
  std::vector<Members> vehicles = members.objects("vehicles");
  members.require_at_most("vehicles", vehicles.size(), most_vehicles);
  if (vehicles.empty()) members.refuse("vehicles", "there should be at least one vehicle");
  for (std::size_t i = 0; i < vehicles.size(); ++i) {
    Members& vehicle = vehicles[i];
    std::string id = id_of(vehicle, i, taken);
    const bool flies = vehicle.has("document") || vehicle.has("file");
    request.order.push_back({flies, flies ? request.flying.size() : request.arriving.size()});
    if (flies) {
      request.flying.push_back(flying_vehicle(vehicle, std::move(id)));
    } else {
      request.arriving.push_back(arriving_vehicle(vehicle, std::move(id)));
    }
  }
  if (!request.arriving.empty()) request.arrival = arrival_choice(members);
  request.goal.clearance = members.number("clearance", 0.0);
  request.goal.separation.vertical_scale = vertical_scale_of(members.number("ellipsoid", 1.0));
  if (members.has("deconflict")) {
    request.deconflict = arrival_moves(members.object("deconflict"), request.longest_delay_given);
    if (request.arrival.separated) {
      members.refuse("deconflict",
                     "the least arrival at which all keep their distance leaves nothing to change; "
                     "leave this out or seek the least that is \"feasible\"");
    }
  }
  return request;
}

SwarmFacts swarm_facts(const SwarmRequest& request) {
  SwarmFacts facts;
  facts.goal = request.goal;
  std::vector<Vehicle> given = fly_given(request, facts);
  SimultaneousArrival plan;
  if (!request.arriving.empty()) plan = fly_arriving(request, given, facts);
  for (const SwarmRequest::Place& place : request.order) {
    if (place.flies) {
      add_given(request.flying[place.number], std::move(given[place.number]), facts);
    } else {
      add_made(request.arriving[place.number], std::move(plan.paths[place.number]),
               std::move(plan.vehicles[place.number]), plan.arrival, facts);
    }
  }
  facts.matrix = separation_matrix(facts.vehicles, request.goal).value();
  facts.conflicts = conflicts(facts.vehicles, request.goal).value();
  return facts;
}

std::vector<PairFact> closest_pairs(const SwarmFacts& facts) {
  std::vector<PairFact> pairs;
  for (std::size_t j = 1; j < facts.matrix.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) {
      if (const auto entry = facts.matrix(i, j)) pairs.push_back({i, j, *entry});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const PairFact& a, const PairFact& b) {
    const double x = a.entry.distance.lower(), y = b.entry.distance.lower();
    return x != y ? x < y : std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return pairs;
}

Json json_of(const SwarmFacts& facts, std::size_t closest, bool with_documents, bool with_matrix) {
  Json json = Json::object();
  if (facts.arrival) json["arrival"] = *facts.arrival;
  Json& vehicles = json["vehicles"] = Json::array();
  for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
    const Vehicle& vehicle = facts.vehicles[i];
    Json one = {{"id", vehicle.id},
                {"departure", vehicle.motion.start_time()},
                {"arrival", vehicle.motion.end_time()},
                {"length", vehicle.motion.length()}};
    if (const double altitude = facts.flights[i].altitude.value_or(0.0); altitude != 0.0) {
      one["altitude"] = altitude;
    }
    if (const auto& made = facts.made[i]) {
      one["solution"] = made->solution;
      one["rotation_index"] = made->rotation_index;
      one["largest_curvature"] = json_of(made->largest_curvature);
      if (with_documents) one["document"] = Json::parse(to_json(facts.documents[i]));
    }
    vehicles.push_back(std::move(one));
  }
  const auto named = [&](std::size_t first, std::size_t second) {
    return Json{{"first", facts.vehicles[first].id}, {"second", facts.vehicles[second].id}};
  };
  Json& pairs = json["closest"] = Json::array();
  const std::vector<PairFact> all = closest_pairs(facts);
  for (std::size_t k = 0; k < std::min(closest, all.size()); ++k) {
    Json one = named(all[k].first, all[k].second);
    one["distance"] = json_of(all[k].entry.distance);
    one["time"] = all[k].entry.time;
    pairs.push_back(std::move(one));
  }
  Json& list = json["conflicts"] = Json::array();
  for (const Conflict& conflict : facts.conflicts) {
    Json one = named(conflict.pair.first, conflict.pair.second);
    one["required"] = conflict.pair.required;
    one["keeps"] = word_of(conflict.pair.keeps);
    one["distance"] = json_of(conflict.separation.distance);
    one["time"] = conflict.separation.time;
    one["shortfall"] = json_of(conflict.shortfall());
    one["passages"] = json_of(conflict.passages);
    list.push_back(std::move(one));
  }
  if (with_matrix) {
    Json& rows = json["matrix"] = Json::array();
    for (std::size_t i = 0; i < facts.matrix.size(); ++i) {
      Json row = Json::array();
      for (std::size_t j = 0; j < facts.matrix.size(); ++j) {
        const auto entry = i == j ? std::nullopt : facts.matrix(i, j);
        row.push_back(i == j ? Json(0) : entry ? Json(entry->distance.lower()) : Json());
      }
      rows.push_back(std::move(row));
    }
  }
  if (facts.effort) {
    json["effort"] = {{"choices", facts.effort->choices},
                      {"pairs_checked", facts.effort->pairs_checked}};
  }
  return json;
}

std::string text_of(const SwarmFacts& facts, std::size_t closest) {
  constexpr std::size_t most_listed = 24, narrow = 10;
  std::string text = "  " + padded("Vehicle", narrow) + "Leaves       Arrives      Length";
  text += facts.arrival ? "       Curvature\n" : "\n";
  for (std::size_t i = 0; i < std::min(most_listed, facts.vehicles.size()); ++i) {
    const Vehicle& vehicle = facts.vehicles[i];
    std::string line = "  " + padded(vehicle.id, narrow) + seven(vehicle.motion.start_time()) +
                       seven(vehicle.motion.end_time()) + seven(vehicle.motion.length());
    if (const auto& made = facts.made[i]) {
      line += "at most " + to_six_digits(made->largest_curvature.upper());
    } else if (facts.arrival) {
      line += "path given";
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  if (facts.vehicles.size() > most_listed) {
    text += "  and " + std::to_string(facts.vehicles.size() - most_listed) + " more\n";
  }
  const std::vector<PairFact> pairs = closest_pairs(facts);
  if (!pairs.empty()) {
    text += "\n  " + padded("Pair", 2 * narrow) + "Least distance, certified at every instant\n";
    for (std::size_t k = 0; k < std::min(closest, pairs.size()); ++k) {
      const PairFact& pair = pairs[k];
      text += "  " +
              padded(facts.vehicles[pair.first].id + " and " + facts.vehicles[pair.second].id,
                     2 * narrow) +
              "at least " + seven(pair.entry.distance.lower()) + "at time " +
              to_six_digits(pair.entry.time) + "\n";
    }
    if (pairs.size() > closest) {
      text += "  and " + std::to_string(pairs.size() - closest) + " more pairs\n";
    }
  }
  text += "\n";
  for (std::size_t k = 0; k < std::min(most_listed, facts.conflicts.size()); ++k) {
    const Conflict& c = facts.conflicts[k];
    text += "  " + facts.vehicles[c.pair.first].id + " and " + facts.vehicles[c.pair.second].id +
            (c.pair.keeps == hodograph::Answer::no ? " are too close" : " may be too close") +
            ", by " + to_six_digits(std::max(0.0, c.shortfall().upper())) + ":";
    for (std::size_t i = 0; i < c.passages.size(); ++i) {
      text += (i == 0 ? " from " : ", from ") + to_six_digits(c.passages[i].begin) + " to " +
              to_six_digits(c.passages[i].end);
    }
    text += "\n";
  }
  const bool with_radii = std::any_of(facts.vehicles.begin(), facts.vehicles.end(),
                                      [](const Vehicle& v) { return v.radius > 0.0; });
  if (!facts.conflicts.empty()) {
    text += "  " + std::to_string(facts.conflicts.size()) + " of " + std::to_string(pairs.size()) +
            " pairs do not keep their distance\n";
  } else if (facts.goal.clearance > 0.0 || with_radii) {
    text += "  All " + std::to_string(pairs.size()) + " pairs keep " +
            (facts.goal.clearance > 0.0 ? to_six_digits(facts.goal.clearance) : "") +
            (facts.goal.clearance > 0.0 && with_radii ? " and " : "") +
            (with_radii ? "their radii" : "") + ", certified\n";
  } else {
    text += "  No distance is required: there is neither a clearance nor a radius\n";
  }
  if (facts.effort) {
    text += "  Kept apart after " + std::to_string(facts.effort->choices) + " choices, " +
            std::to_string(facts.effort->pairs_checked) + " pairs checked\n";
  }
  return text;
}

std::string matrix_csv(const SwarmFacts& facts) {
  std::vector<std::string> names = {"vehicle"};
  for (const Vehicle& vehicle : facts.vehicles) names.push_back(vehicle.id);
  std::string text;
  append_csv_header(text, names);
  for (std::size_t i = 0; i < facts.matrix.size(); ++i) {
    text += facts.vehicles[i].id;
    for (std::size_t j = 0; j < facts.matrix.size(); ++j) {
      text += ',';
      if (i == j) {
        text += '0';
      } else if (const auto entry = facts.matrix(i, j)) {
        text += to_text(entry->distance.lower());
      }
    }
    text += '\n';
  }
  return text;
}

std::string swarm_json(const SwarmFacts& facts) {
  std::string text = "{\n  \"clearance\": " + to_text(facts.goal.clearance) + ",\n";
  if (facts.goal.separation.vertical_scale != 1.0) {
    text += "  \"ellipsoid\": " + to_text(1.0 / facts.goal.separation.vertical_scale) + ",\n";
  }
  text += "  \"vehicles\": [\n";
  for (std::size_t i = 0; i < facts.vehicles.size(); ++i) {
    const Vehicle& vehicle = facts.vehicles[i];
    const Flight& flight = facts.flights[i];
    Json one = {
        {"id", vehicle.id}, {"file", vehicle.id + ".json"}, {"departure", flight.departure}};
    const auto set = [&](const char* name, const std::optional<double>& value) {
      if (value) one[name] = *value;
    };
    set("speed", flight.speed);
    set("arrival", flight.arrival);
    set("acceleration", flight.acceleration);
    set("deceleration", flight.deceleration);
    set("lateral_acceleration", flight.lateral_acceleration);
    set("altitude", flight.altitude);
    if (vehicle.radius > 0.0) one["radius"] = vehicle.radius;
    const Presence& presence = flight.presence;
    if (!(presence.before_start && presence.after_arrival)) {
      one["stands"] = presence.before_start ? "before" : presence.after_arrival ? "after" : "never";
    }
    text += "    ";
    append_json(text, one);
    text += i + 1 < facts.vehicles.size() ? ",\n" : "\n";
  }
  return text + "  ]\n}\n";
}

std::optional<Fault> conflict_fault(const SwarmFacts& facts) {
  if (facts.conflicts.empty()) return std::nullopt;
  const Conflict* worst = &facts.conflicts[0];
  for (const Conflict& c : facts.conflicts) {
    if (c.shortfall().upper() > worst->shortfall().upper()) worst = &c;
  }
  const double distance = worst->separation.distance.upper();
  return Fault{FaultCode::not_separated,
               std::to_string(facts.conflicts.size()) +
                   (facts.conflicts.size() == 1 ? " pair does" : " pairs do") +
                   " not keep the distance required; '" + facts.vehicles[worst->pair.first].id +
                   "' and '" + facts.vehicles[worst->pair.second].id + "' come as close as " +
                   to_text(distance) + " at time " + to_six_digits(worst->separation.time) + "; " +
                   to_text(worst->pair.required) + " is required",
               worst->pair.first,
               "distance",
               distance,
               worst->pair.required};
}

}  // namespace hodograph::cli
