// SPDX-License-Identifier: MIT
// All pairs of a swarm, arrivals at one time, and keeping vehicles apart: planning/swarm/pairs.hpp,
// simultaneous_arrival.hpp, deconfliction.hpp.
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/planning/swarm/deconfliction.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"
#include "python/src/motion.hpp"

namespace pybind11::detail {

template <>
struct type_caster<hodograph::SeparationMatrix>
    : hodograph_made_caster<hodograph::SeparationMatrix> {};

}  // namespace pybind11::detail

namespace hodograph::python {

namespace {

using Point = Vector2<double>;
using Flyers = std::vector<Flyer>;
using Arriving = std::vector<ArrivingVehicle>;

/// SimultaneousArrival with vehicles as Python holds them.
struct Arrival {
  double arrival = 0.0;
  std::vector<ArrivingPath> paths{};
  Flyers vehicles{};
};

/// SeparatedArrival and DelayedSwarm likewise.
struct ApartArrival {
  Arrival plan{};
  std::vector<double> delays{};
  DeconflictionEffort effort{};
};
struct Delayed {
  Flyers vehicles{};
  std::vector<double> delays{};
  DeconflictionEffort effort{};
};

Arrival arrival_of(SimultaneousArrival made, const Arriving& wanted) {
  Arrival result{made.arrival, std::move(made.paths), {}};
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    result.vehicles.push_back({wanted[i].id,
                               Motion{std::make_shared<const AnyPath>(result.paths[i].path),
                                      wanted[i].altitude, std::move(made.vehicles[i].motion)},
                               wanted[i].radius});
  }
  return result;
}

SwarmGoal goal_of(double clearance, unsigned threads, double relative_width, double vertical_scale,
                  std::size_t most_evaluations) {
  return {{relative_width, vertical_scale, most_evaluations}, clearance, threads};
}

ArrivingVehicle arriving_of(const std::string& id, const Doubles& begin,
                            const Doubles& begin_direction, const Doubles& end,
                            const Doubles& end_direction, double speed, double departure,
                            double radius, std::optional<double> most_curvature, bool before_start,
                            bool after_arrival, double altitude) {
  return {id,
          {point_of<Point>(begin, "begin"), point_of<Point>(begin_direction, "begin_direction")},
          {point_of<Point>(end, "end"), point_of<Point>(end_direction, "end_direction")},
          speed,
          departure,
          radius,
          most_curvature,
          {before_start, after_arrival},
          altitude};
}

py::tuple state_of(const ArrivingVehicle& v) {
  return py::make_tuple(v.id, v.begin.position, v.begin.direction, v.end.position, v.end.direction,
                        v.speed, v.departure, v.radius, v.most_curvature, v.presence.before_start,
                        v.presence.after_arrival, v.altitude);
}

ArrivingVehicle arriving_of_state(const py::tuple& t) {
  return arriving_of(t[0].cast<std::string>(), t[1].cast<Doubles>(), t[2].cast<Doubles>(),
                     t[3].cast<Doubles>(), t[4].cast<Doubles>(), t[5].cast<double>(),
                     t[6].cast<double>(), t[7].cast<double>(), t[8].cast<std::optional<double>>(),
                     t[9].cast<bool>(), t[10].cast<bool>(), t[11].cast<double>());
}

void require_vehicles(const Arriving& vehicles) {
  if (vehicles.empty()) {
    throw Error(Fault{FaultCode::too_few, "there should be at least one vehicle; got none",
                      std::nullopt, "vehicles", 0.0, 1.0});
  }
}

/// The least separations as a matrix: 0 on the diagonal, infinite without a common time.
Doubles matrix_of(const SeparationMatrix& matrix, bool lower) {
  const std::size_t n = matrix.size();
  Doubles result({static_cast<py::ssize_t>(n), static_cast<py::ssize_t>(n)});
  double* to = result.mutable_data();
  for (std::size_t i = 0; i < n; ++i) {
    for (std::size_t j = 0; j < n; ++j) {
      double value = 0.0;
      if (i != j) {
        const auto entry = matrix(i, j);
        value = !entry  ? std::numeric_limits<double>::infinity()
                : lower ? entry->distance.lower()
                        : entry->distance.upper();
      }
      *to++ = value;
    }
  }
  return result;
}

std::optional<SeparationMatrix::Entry> entry_of(const SeparationMatrix& matrix,
                                                std::pair<std::size_t, std::size_t> at) {
  const auto [i, j] = at;
  if (i >= matrix.size() || j >= matrix.size()) {
    throw py::index_error("the matrix has " + std::to_string(matrix.size()) + " vehicles");
  }
  if (i == j) throw py::index_error("a vehicle has no distance from itself");
  return matrix(i, j);
}

void bind_pair_results(py::module_& m) {
  Record<ClosePair>(m, "ClosePair",
                    "Two vehicles, by their numbers, that do not keep the distance required.")
      .field("first", &ClosePair::first)
      .field("second", &ClosePair::second)
      .field("required", &ClosePair::required, "The sum of the radii and the clearance.")
      .field("keeps", &ClosePair::keeps, "Answer.no, or undecided within the goal's width.");
  Record<Conflict> conflict(m, "Conflict", "A close pair with its least distance.");
  conflict.field("pair", &Conflict::pair)
      .field("separation", &Conflict::separation)
      .field("passages", &Conflict::passages, "When they are too close.")
      .def("shortfall", &Conflict::shortfall, "Bounds of required - distance.");
  auto matrix = made_class<SeparationMatrix>(m, "SeparationMatrix",
                                             "The least distances of all pairs, centre to centre.");
  Record<SeparationMatrix::Entry>(matrix, "Entry", "The least distance of one pair.")
      .field("distance", &SeparationMatrix::Entry::distance)
      .field("time", &SeparationMatrix::Entry::time);
  matrix.def_property_readonly("size", &SeparationMatrix::size, "The number of vehicles.")
      .def_property_readonly(
          "lower", [](const SeparationMatrix& self) { return matrix_of(self, true); },
          "Lower bounds, (n, n): 0 on the diagonal, inf where two have no common time.")
      .def_property_readonly(
          "upper", [](const SeparationMatrix& self) { return matrix_of(self, false); },
          "Upper bounds, (n, n), likewise.")
      .def("__getitem__", &entry_of, py::arg("pair"),
           "matrix[i, j]: the entry of two vehicles; None without a common time.")
      .def("__len__", &SeparationMatrix::size)
      .def("__repr__", [](const SeparationMatrix& self) {
        return "<hodograph.SeparationMatrix: " + std::to_string(self.size()) + " vehicles>";
      });
  Record<DeconflictionEffort>(m, "DeconflictionEffort", "What a search did.")
      .field("choices", &DeconflictionEffort::choices)
      .field("pairs_checked", &DeconflictionEffort::pairs_checked);
}

void bind_arriving(py::module_& m) {
  using A = ArrivingVehicle;
  py::class_<A>(m, "ArrivingVehicle",
                "What is given of a vehicle that arrives together with others: places and "
                "directions (2,) at both ends.")
      .def(py::init(&arriving_of), py::arg("id"), py::arg("begin"), py::arg("begin_direction"),
           py::arg("end"), py::arg("end_direction"), py::kw_only(), py::arg("speed") = 1.0,
           py::arg("departure") = 0.0, py::arg("radius") = 0.0,
           py::arg("most_curvature") = py::none(), py::arg("before_start") = true,
           py::arg("after_arrival") = true, py::arg("altitude") = 0.0)
      .def_readonly("id", &A::id)
      .def_property_readonly("begin", [](const A& v) { return v.begin.position; })
      .def_property_readonly("begin_direction", [](const A& v) { return v.begin.direction; })
      .def_property_readonly("end", [](const A& v) { return v.end.position; })
      .def_property_readonly("end_direction", [](const A& v) { return v.end.direction; })
      .def_readonly("speed", &A::speed)
      .def_readonly("departure", &A::departure)
      .def_readonly("radius", &A::radius)
      .def_readonly("most_curvature", &A::most_curvature)
      .def_property_readonly("before_start", [](const A& v) { return v.presence.before_start; })
      .def_property_readonly("after_arrival", [](const A& v) { return v.presence.after_arrival; })
      .def_readonly("altitude", &A::altitude)
      .def("__repr__",
           [](const A& v) {
             return "ArrivingVehicle(" + std::string(py::repr(py::str(v.id))) + ", from (" +
                    to_text(v.begin.position.x) + ", " + to_text(v.begin.position.y) + ") to (" +
                    to_text(v.end.position.x) + ", " + to_text(v.end.position.y) + "), speed " +
                    to_text(v.speed) + ")";
           })
      .def(py::pickle(&state_of, &arriving_of_state));
  const PlanarPath<2> line = *unit_line().get_if<PlanarPath<2>>();
  Record<ArrivingPath>(m, "ArrivingPath", "A vehicle's path.", ArrivingPath{line, 0.0, 0, 0.0, {}})
      .field("path", &ArrivingPath::path, "Over xi in [0, length].")
      .field("departure", &ArrivingPath::departure)
      .field("solution", &ArrivingPath::solution,
             "Of the formal solutions by increasing rotation index.")
      .field("rotation_index", &ArrivingPath::rotation_index)
      .field("largest_curvature", &ArrivingPath::largest_curvature, "Of |kappa|, enclosed.");
  Record<Arrival>(m, "SimultaneousArrival",
                  "Paths of vehicles that arrive together, and the same as a swarm.")
      .field("arrival", &Arrival::arrival)
      .field("paths", &Arrival::paths)
      .field("vehicles", &Arrival::vehicles);
  Record<ApartArrival>(m, "SeparatedArrival", "An arrival whose vehicles are certainly apart.")
      .field("plan", &ApartArrival::plan)
      .field("delays", &ApartArrival::delays, "Of the departures given, (n,).")
      .field("effort", &ApartArrival::effort);
  Record<Delayed>(m, "DelayedSwarm", "Vehicles with delays, all pairs certainly apart.")
      .field("vehicles", &Delayed::vehicles)
      .field("delays", &Delayed::delays, "(n,).")
      .field("effort", &Delayed::effort);
}

const SwarmGoal usual_goal{};

// The members of SwarmGoal as keyword arguments, in the order of goal_of.
#define HODOGRAPH_SWARM_GOAL                                                            \
  py::arg("clearance") = usual_goal.clearance, py::arg("threads") = usual_goal.threads, \
  py::arg("relative_width") = usual_goal.separation.relative_width,                     \
  py::arg("vertical_scale") = usual_goal.separation.vertical_scale,                     \
  py::arg("most_evaluations") = usual_goal.separation.most_evaluations

void bind_pairs(py::module_& m) {
  m.def(
      "close_pairs",
      [](const Flyers& vehicles, double clearance, unsigned threads, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        return unlocked([&] { return close_pairs(vehicles_of(vehicles), goal).value(); });
      },
      py::arg("vehicles"), py::kw_only(), HODOGRAPH_SWARM_GOAL,
      "All pairs that do not certainly keep the sum of their radii and the clearance at every "
      "instant.\nthreads: 0 for as many as the machine runs. Raises HodographError: too_few, "
      "outside_domain.");
  m.def(
      "conflicts",
      [](const Flyers& vehicles, double clearance, unsigned threads, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        return unlocked([&] { return conflicts(vehicles_of(vehicles), goal).value(); });
      },
      py::arg("vehicles"), py::kw_only(), HODOGRAPH_SWARM_GOAL,
      "What close_pairs finds, with every pair's least distance and when it is too small.");
  m.def(
      "separation_matrix",
      [](const Flyers& vehicles, double clearance, unsigned threads, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        auto matrix =
            unlocked([&] { return separation_matrix(vehicles_of(vehicles), goal).value(); });
        py::dict named;
        named["clearance"] = clearance;
        named["threads"] = threads;
        named["relative_width"] = relative_width;
        named["vertical_scale"] = vertical_scale;
        named["most_evaluations"] = most_evaluations;
        return made(std::move(matrix), "separation_matrix", vehicles, named);
      },
      py::arg("vehicles"), py::kw_only(), HODOGRAPH_SWARM_GOAL,
      "Every pair's least distance to the goal's width.");
}

void bind_arrivals(py::module_& m) {
  m.def(
      "arriving_path",
      [](const ArrivingVehicle& vehicle, double arrival, std::size_t solution) {
        return unlocked([&] { return arriving_path(vehicle, arrival, solution).value(); });
      },
      py::arg("vehicle"), py::arg("arrival"), py::arg("solution") = 0,
      "The path of one vehicle that arrives at a given time, the formal solution of that number.\n"
      "Raises HodographError: no_interpolant, outside_domain.");
  m.def(
      "arrival_at",
      [](const Arriving& vehicles, double arrival) {
        require_vehicles(vehicles);
        return unlocked(
            [&] { return arrival_of(arrival_at(vehicles, arrival).value(), vehicles); });
      },
      py::arg("vehicles"), py::arg("arrival"),
      "Arrival at the given time, each vehicle on the first of its solutions that keeps its "
      "curvature limit.");
  const ArrivalSearch usual{};
  m.def(
      "least_arrival",
      [](const Arriving& vehicles, double most_excess, std::size_t steps, double resolution) {
        require_vehicles(vehicles);
        return unlocked([&] {
          return arrival_of(least_arrival(vehicles, {most_excess, steps, resolution}).value(),
                            vehicles);
        });
      },
      py::arg("vehicles"), py::kw_only(), py::arg("most_excess") = usual.most_excess,
      py::arg("steps") = usual.steps, py::arg("resolution") = usual.resolution,
      "The least arrival time at which every vehicle keeps its curvature limit.");
  m.def(
      "least_separated_arrival",
      [](const Arriving& vehicles, const Flyers& others, double most_excess, std::size_t steps,
         double resolution, double clearance, unsigned threads, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        require_vehicles(vehicles);
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        return unlocked([&] {
          return arrival_of(
              least_separated_arrival(vehicles, goal, {most_excess, steps, resolution},
                                      vehicles_of(others))
                  .value(),
              vehicles);
        });
      },
      py::arg("vehicles"), py::kw_only(), py::arg("others") = Flyers{},
      py::arg("most_excess") = usual.most_excess, py::arg("steps") = usual.steps,
      py::arg("resolution") = usual.resolution, HODOGRAPH_SWARM_GOAL,
      "The least at which all pairs keep their distances, too, certified for every instant, also "
      "from `others`,\nwhich stay as they are. Raises HodographError: not_separated and those of "
      "least_arrival.");
  m.def(
      "earliest_arrival",
      [](const Arriving& vehicles) {
        require_vehicles(vehicles);
        const double time = earliest_arrival(vehicles);
        require_finite({&time, 1}, "the earliest arrival");
        return time;
      },
      py::arg("vehicles"), "The largest departure + distance/speed.");
}

void bind_deconfliction(py::module_& m) {
  const DelayMoves usual{};
  m.def(
      "deconflict_by_delays",
      [](const Flyers& vehicles, double longest_delay, std::size_t delays, const Flyers& others,
         std::size_t most_choices, double clearance, unsigned threads, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        return unlocked([&] {
          auto made =
              deconflict_by_delays(vehicles_of(vehicles), goal,
                                   {longest_delay, delays, most_choices}, vehicles_of(others))
                  .value();
          Delayed result{vehicles, std::move(made.delays), made.effort};
          for (std::size_t i = 0; i < vehicles.size(); ++i) {
            result.vehicles[i].motion.motion = std::move(made.vehicles[i].motion);
          }
          return result;
        });
      },
      py::arg("vehicles"), py::arg("longest_delay"), py::arg("delays"), py::kw_only(),
      py::arg("others") = Flyers{}, py::arg("most_choices") = usual.most_choices,
      HODOGRAPH_SWARM_GOAL,
      "Delays some of the vehicles by 0, longest_delay/delays, ..., so that all pairs keep their "
      "distance, also\nfrom `others`. Raises HodographError: not_separated (the sentence says "
      "whether that is proven).");
  const ArrivalMoves moves{};
  m.def(
      "deconflict_arrival",
      [](const Arriving& vehicles, double arrival, double longest_delay, std::size_t delays,
         const Flyers& others, bool other_solution, double latest_excess,
         std::size_t later_arrivals, std::size_t most_choices, double clearance, unsigned threads,
         double relative_width, double vertical_scale, std::size_t most_evaluations) {
        require_vehicles(vehicles);
        const auto goal =
            goal_of(clearance, threads, relative_width, vertical_scale, most_evaluations);
        const ArrivalMoves allowed{
            {longest_delay, delays, most_choices}, other_solution, latest_excess, later_arrivals};
        return unlocked([&] {
          auto made =
              deconflict_arrival(vehicles, arrival, goal, allowed, vehicles_of(others)).value();
          return ApartArrival{arrival_of(std::move(made.plan), vehicles), std::move(made.delays),
                              made.effort};
        });
      },
      py::arg("vehicles"), py::arg("arrival"), py::arg("longest_delay"), py::arg("delays"),
      py::kw_only(), py::arg("others") = Flyers{}, py::arg("other_solution") = moves.other_solution,
      py::arg("latest_excess") = moves.latest_excess,
      py::arg("later_arrivals") = moves.later_arrivals,
      py::arg("most_choices") = usual.most_choices, HODOGRAPH_SWARM_GOAL,
      "Keeps vehicles apart that arrive together: at `arrival` by delays and solutions, else at "
      "the first later\narrival at which that can be done. Raises HodographError: not_separated "
      "and those of arrival_at.");
}

}  // namespace

void bind_swarm(py::module_& m) {
  bind_pair_results(m);
  bind_arriving(m);
  add_equality_of_states(py::type::of<ArrivingVehicle>());
  bind_pairs(m);
  bind_arrivals(m);
  bind_deconfliction(m);
}

}  // namespace hodograph::python
