// SPDX-License-Identifier: MIT
// Requests that make paths from data: hermite, hermite_path, fit, orbit.
#include <algorithm>
#include <utility>

#include "cli/fitting.hpp"
#include "cli/made_path.hpp"
#include "cli/requests/handlers.hpp"
#include "hodograph/construction/hermite.hpp"
#ifdef HODOGRAPH_HAS_ORBIT
#include "hodograph/orbit/periodic_orbit.hpp"
#endif

namespace hodograph::cli {
namespace {

template <std::size_t m>
HermitePoint<m> hermite_point(const std::vector<Vector3<double>>& jet) {
  HermitePoint<m> point;
  std::copy(jet.begin(), jet.end(), point.begin());
  return point;
}

HermiteChoice choice_of(Members& request) {
  return request.word("choice", {"order_ten", "order_six"}, "order_ten") == "order_ten"
             ? HermiteChoice::order_ten
             : HermiteChoice::order_six;
}

template <std::size_t m>
HermiteParameters<m> parameters_of(Members request) {
  HermiteParameters<m> parameters{};
  parameters.theta_begin = request.number("theta_begin", 0.0);
  parameters.theta_middle = request.number("theta_middle", 0.0);
  parameters.theta_end = request.number("theta_end", 0.0);
  if constexpr (m > 1) {
    for (auto& [name, tau] : {std::pair{"tau_begin", &parameters.tau_begin},
                              std::pair{"tau_end", &parameters.tau_end}}) {
      if (!request.has(name)) continue;
      const auto numbers = request.numbers(name, m - 1);
      std::copy(numbers.begin(), numbers.end(), tau->begin());
    }
  }
  request.require_all_known();
  return parameters;
}

template <std::size_t m>
Answer hermite(Members& request) {
  const auto begin = hermite_point<m>(request.jet("begin", m + 1));
  const auto end = hermite_point<m>(request.jet("end", m + 1));
  const double step = request.number("step", 1.0);
  if (request.has("choice") && request.has("parameters")) {
    request.refuse("choice", "a choice and free parameters exclude each other; give one of them");
  }
  const auto curve = [&] {
    if (!request.has("parameters")) {
      return hermite_curve<m>(begin, end, step, choice_of(request)).value();
    }
    return hermite_curve<m>(begin, end, step, parameters_of<m>(request.object("parameters")))
        .value();
  }();
  std::vector<double> u;
  if (request.has("evaluate")) u = request.numbers("evaluate");
  request.require_all_known();

  Answer answer;
  Json& result = answer.result;
  result["arc_length"] = curve.arc_length();
  result["preimage"] = Json::array();
  for (const auto& a : curve.preimage().coefficients()) result["preimage"].push_back(list_of(a));
  result["control_points"] = Json::array();
  const auto displacement = curve.displacement();
  for (const auto& c : displacement.coefficients()) {
    result["control_points"].push_back(list_of(curve.start() + c));
  }
  const AnyPath path(SpatialPath<2 * m>::create({0.0, step}, {curve}, false).value());
  if (!u.empty()) {
    request.require_at_most("evaluate", u.size(), most_places);
    result["samples"] = Json::array();
    for (std::size_t i = 0; i < u.size(); ++i) {
      if (!(u[i] >= 0.0 && u[i] <= 1.0)) {
        request.refuse("evaluate/" + std::to_string(i),
                       "u is " + to_text(u[i]) + "; it should be in [0, 1]");
      }
      Json sample = json_of(state_at(path, u[i] * step));
      sample["u"] = u[i];
      result["samples"].push_back(std::move(sample));
    }
  }
  answer.document = to_json(made_path(path, "", "C" + std::to_string(m) + " Hermite").document);
  return answer;
}

template <std::size_t m>
Answer hermite_through(Members& request) {
  auto knots = request.numbers("knots");
  std::vector<HermitePoint<m>> points;
  for (const auto& jet : request.jets("points", m + 1)) points.push_back(hermite_point<m>(jet));
  const HermiteChoice choice = choice_of(request);
  const bool closed = request.truth("closed", false);
  request.require_all_known();
  AnyPath path(
      hermite_path<m>(std::move(knots), std::span<const HermitePoint<m>>(points), choice, closed)
          .value());
  Answer answer;
  const MadePath made = made_path(path, "", "C" + std::to_string(m) + " Hermite",
                                  choice == HermiteChoice::order_ten ? "order ten" : "order six");
  answer.document = to_json(made.document);
  answer.result["segments"] = path.segment_count();
  answer.result["arc_length"] = path.arc_length();
  answer.result["continuity"] = json_of(made.facts.continuity);
  return answer;
}

template <class Function>
Answer by_order(Members& request, const Function& function) {
  const std::size_t order = request.count("order", 4);
  switch (order) {
    case 1:
      return function(std::integral_constant<std::size_t, 1>{});
    case 2:
      return function(std::integral_constant<std::size_t, 2>{});
    case 4:
      return function(std::integral_constant<std::size_t, 4>{});
    default:
      request.refuse("order", "Hermite data of order " + std::to_string(order) +
                                  " are not offered; the order is 1, 2 or 4");
  }
}

OrbitSource orbit_source(Members& request) {
  OrbitSource source;
  if (request.has("initial")) {
    Members initial = request.object("initial");
    source.name = "initial";
    source.x = initial.number("x");
    source.z = initial.number("z");
    source.vy = initial.number("vy");
    source.period = initial.maybe_number("period");
    initial.require_all_known();
    source.mass_ratio = request.maybe_number("mu");
  } else {
    source.name = request.word("name", {"gateway", "synodic-9-2"}, "gateway");
  }
  return source;
}

Source fit_source(Members& request) {
  const int given = static_cast<int>(request.has("formula")) +
                    static_cast<int>(request.has("samples")) +
                    static_cast<int>(request.has("orbit"));
  if (given != 1) {
    request.refuse("request", "a fit needs one of \"formula\", \"samples\" and \"orbit\"");
  }
  if (request.has("formula")) {
    FormulaSource source;
    source.formula = request.text("formula");
    source.begin = request.number("from", 0.0);
    source.end = request.number("to", 1.0);
    return source;
  }
  if (request.has("orbit")) {
    Members orbit = request.object("orbit");
    OrbitSource source = orbit_source(orbit);
    source.inertial = orbit.word("frame", {"rotating", "inertial"}, "rotating") == "inertial";
    source.kilometres = orbit.word("units", {"lu", "km"}, "lu") == "km";
    source.revolutions = orbit.count("revolutions", 1);
    constexpr std::size_t most_revolutions = 1000;
    orbit.require_at_most("revolutions", source.revolutions, most_revolutions);
    orbit.require_all_known();
    return source;
  }
  Members samples = request.object("samples");
  SampleSource source;
  source.name = "samples";
  source.samples.parameters = samples.numbers("parameters");
  for (const auto& p : samples.vectors("points", 3)) {
    source.samples.points.push_back({p[0], p[1], p[2]});
  }
  source.degree = samples.count("degree", source.degree);
  source.periodic = samples.truth("periodic", false);
  samples.require_all_known();
  return source;
}

}  // namespace

Answer answer_hermite(Members& request) {
  return by_order(request, [&](auto m) { return hermite<m()>(request); });
}

Answer answer_hermite_path(Members& request) {
  return by_order(request, [&](auto m) { return hermite_through<m()>(request); });
}

Answer answer_fit(Members& request) {
  const Source source = fit_source(request);
  FitOptions options;
  options.tolerance = request.number("tolerance", 0.0);
  options.segments = request.count("segments", 0);
  options.most_segments = request.count("most_segments", options.most_segments);
  request.require_at_most("segments", options.segments, most_fit_segments);
  request.require_at_most("most_segments", options.most_segments, most_fit_segments);
  options.choice = choice_of(request);
  options.knots = request.word("knots", {"adaptive", "uniform"}, "adaptive") == "adaptive"
                      ? FitKnots::adaptive
                      : FitKnots::uniform;
  options.closed = request.truth("closed", false);
  request.require_all_known();

  const FittedPath fit = fitted(source, options).value();
  Answer answer;
  Json& result = answer.result;
  result["segments"] = fit.document.path.segment_count();
  result["error"] = json_of(*fit.document.promises.error);
  result["error"]["at_xi"] = fit.error.at_xi;
  result["arc_length"] = fit.document.path.arc_length();
  result["continuity"] = json_of(fit.facts.continuity);
  if (fit.facts.holonomy) {
    result["holonomy"] = {{"roll", fit.facts.holonomy->roll},
                          {"preimage_sign", fit.facts.holonomy->sign}};
  }
  answer.document = to_json(fit.document);
  return answer;
}

#ifdef HODOGRAPH_HAS_ORBIT
Answer answer_orbit(Members& request) {
  const OrbitSource source = orbit_source(request);
  request.require_all_known();
  const PeriodicOrbit orbit = periodic_orbit(source).value();
  const auto number = [](long double x) { return static_cast<double>(x); };
  const auto& [position, velocity] = orbit.initial;
  constexpr double seconds_a_day = 86400.0;
  Answer answer;
  answer.result = {{"mu", orbit.system.mass_ratio},
                   {"length_unit_km", orbit.system.length_unit_km},
                   {"time_unit_s", orbit.system.time_unit_s},
                   {"position", {number(position.x), number(position.y), number(position.z)}},
                   {"velocity", {number(velocity.x), number(velocity.y), number(velocity.z)}},
                   {"period", number(orbit.period)},
                   {"period_days", number(orbit.period) * orbit.system.time_unit_s / seconds_a_day},
                   {"jacobi", number(orbit.jacobi)},
                   {"crossing_residual", number(orbit.crossing_residual)},
                   {"closure", number(orbit.closure)},
                   {"closest_approach_larger", number(orbit.closest_approach_larger)},
                   {"closest_approach_smaller", number(orbit.closest_approach_smaller)},
                   {"iterations", orbit.iterations},
                   {"stability_indices",
                    {{orbit.stability_indices[0].real(), orbit.stability_indices[0].imag()},
                     {orbit.stability_indices[1].real(), orbit.stability_indices[1].imag()}}}};
  return answer;
}
#else
Answer answer_orbit(Members& request) {
  request.refuse("request", "this program was built without orbits (Boost was missing)");
}
#endif

}  // namespace hodograph::cli
