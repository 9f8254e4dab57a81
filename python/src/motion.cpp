// SPDX-License-Identifier: MIT
// Paths flown by a timing law, and how close two of them come: planning/swarm/timed_motion.hpp,
// separation.hpp.
#include "python/src/motion.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hodograph/planning/swarm/separation.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"

namespace hodograph::python {

namespace {

Motion motion_of(const AnyPath& path, const TimingLaw& law, bool before_start, bool after_arrival,
                 double altitude) {
  return unlocked([&] {
    return Motion{
        std::make_shared<const AnyPath>(path), altitude,
        TimedMotion::create(path, law, Presence{before_start, after_arrival}, altitude).value()};
  });
}

Doubles positions_of(const Motion& self, const Doubles& t) {
  require_finite(numbers(t), "t");
  return filled_like(t, {3}, [&](auto from, auto to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const Vector3<double> p = self.motion.position(from[i]);
      for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] = p[j];
    }
  });
}

std::string text_of(const Motion& self) {
  const TimedMotion& m = self.motion;
  return std::string("<hodograph.TimedMotion: ") + (m.is_planar() ? "planar" : "spatial") +
         ", length " + to_text(m.length()) + ", from " + to_text(m.start_time()) + " to " +
         to_text(m.end_time()) + ">";
}

py::tuple state_of(const Motion& self) {
  const Presence& presence = self.motion.presence();
  return py::make_tuple(*self.path, self.motion.law(), presence.before_start,
                        presence.after_arrival, self.altitude);
}

Motion motion_of_state(const py::tuple& t) {
  return motion_of(t[0].cast<AnyPath>(), t[1].cast<TimingLaw>(), t[2].cast<bool>(),
                   t[3].cast<bool>(), t[4].cast<double>());
}

void bind_motions(py::module_& m) {
  py::class_<Motion>(m, "TimedMotion",
                     "A path flown by a timing law: where a vehicle is at every time. A value.")
      .def(py::init(&motion_of), py::arg("path"), py::arg("law"), py::kw_only(),
           py::arg("before_start") = true, py::arg("after_arrival") = true,
           py::arg("altitude") = 0.0,
           "before_start, after_arrival: whether the vehicle stands at its first point before it "
           "starts, at its last\nafter it has arrived, or is absent then. altitude: z of a planar "
           "path.\nRaises HodographError: outside_domain (a law of another length), unsupported.")
      .def_property_readonly(
          "path", [](const Motion& self) { return *self.path; }, "The path that is flown.")
      .def_property_readonly("law", [](const Motion& self) { return self.motion.law(); })
      .def_property_readonly("altitude", [](const Motion& self) { return self.altitude; })
      .def_property_readonly("before_start",
                             [](const Motion& self) { return self.motion.presence().before_start; })
      .def_property_readonly(
          "after_arrival", [](const Motion& self) { return self.motion.presence().after_arrival; })
      .def_property_readonly("is_planar",
                             [](const Motion& self) { return self.motion.is_planar(); })
      .def_property_readonly("start_time",
                             [](const Motion& self) { return self.motion.start_time(); })
      .def_property_readonly("end_time", [](const Motion& self) { return self.motion.end_time(); })
      .def_property_readonly("length", [](const Motion& self) { return self.motion.length(); })
      .def(
          "position", &positions_of, py::arg("t"),
          "The point at times t, (..., 3); before the start the first, after the arrival the last.")
      .def(
          "position_error", [](const Motion& self) { return self.motion.position_error(); },
          "A bound of |position(t) - r(s(t))|.")
      .def(
          "delayed",
          [](const Motion& self, double delay) {
            require_finite({&delay, 1}, "delay");
            return Motion{self.path, self.altitude, self.motion.delayed(delay)};
          },
          py::arg("delay"), "The same motion, later.")
      .def("__repr__", &text_of)
      .def(py::pickle(&state_of, &motion_of_state));
  py::class_<Flyer>(m, "Vehicle",
                    "One of several that move at once: no other comes closer to it than the sum of "
                    "both radii and the\nclearance asked for.")
      .def(py::init([](const std::string& id, const Motion& motion, double radius) {
             return Flyer{id, motion, radius};
           }),
           py::arg("id"), py::arg("motion"), py::arg("radius") = 0.0)
      .def_readonly("id", &Flyer::id)
      .def_readonly("motion", &Flyer::motion)
      .def_readonly("radius", &Flyer::radius)
      .def("__repr__",
           [](const Flyer& self) {
             return "Vehicle(" + std::string(py::repr(py::str(self.id))) + ", " +
                    text_of(self.motion) + ", radius=" + to_text(self.radius) + ")";
           })
      .def(py::pickle(
          [](const Flyer& self) { return py::make_tuple(self.id, self.motion, self.radius); },
          [](const py::tuple& t) {
            return Flyer{t[0].cast<std::string>(), t[1].cast<Motion>(), t[2].cast<double>()};
          }));
}

void bind_separation_results(py::module_& m) {
  Record<Separation>(m, "Separation", "The least distance of two motions.")
      .field("distance", &Separation::distance, "Contains the minimum over all common times.")
      .field("time", &Separation::time, "At which at most distance.upper occurs.")
      .field("time_range", &Separation::time_range,
             "Contains every time at which the minimum is attained.")
      .field("first", &Separation::first, "Where the first is then, (3,).")
      .field("second", &Separation::second, "Where the second is then, (3,).")
      .field("evaluations", &Separation::evaluations);
  Record<TimeWindow>(m, "TimeWindow", "The times at which two motions are both there.",
                     TimeWindow{0.0, 0.0})
      .field("begin", &TimeWindow::begin)
      .field("end", &TimeWindow::end);
  Record<SteppedSeparation>(m, "SteppedSeparation",
                            "What the distances at times a step apart prove.")
      .field("sampled", &SteppedSeparation::sampled, "The least of the samples.")
      .field("time", &SteppedSeparation::time)
      .field("index", &SteppedSeparation::index, "Of the sample.")
      .field("distance", &SteppedSeparation::distance, "The minimum's enclosure they prove.")
      .field("evaluations", &SteppedSeparation::evaluations);
  Record<ClosePassage>(m, "ClosePassage",
                       "A stretch of time at which two motions are, or may be, too close.",
                       ClosePassage{0.0, 0.0, false})
      .field("begin", &ClosePassage::begin)
      .field("end", &ClosePassage::end)
      .field("certain", &ClosePassage::certain, "At some time within certainly too close.");
}

/// Throws Error (outside_domain) where heights count by what is no positive, moderate number.
void require_scale(double vertical_scale) {
  if (vertical_scale > 0.0 && vertical_scale <= largest_vertical_scale) return;
  throw Error(Fault{FaultCode::outside_domain,
                    "the vertical_scale must be positive and at most " +
                        to_text(largest_vertical_scale) + "; got " + to_text(vertical_scale),
                    std::nullopt, "vertical_scale", vertical_scale, largest_vertical_scale});
}

void bind_separations(py::module_& m) {
  const SeparationGoal usual{};
  const auto width = py::arg("relative_width") = usual.relative_width;
  const auto scale = py::arg("vertical_scale") = usual.vertical_scale;
  const auto most = py::arg("most_evaluations") = usual.most_evaluations;
  m.def(
      "common_window",
      [](const Motion& a, const Motion& b) { return common_window(a.motion, b.motion); },
      py::arg("a"), py::arg("b"), "The times at which both are there; None if there are none.");
  m.def(
      "least_separation",
      [](const Motion& a, const Motion& b, double relative_width, double vertical_scale,
         std::size_t most_evaluations) {
        return unlocked([&] {
          return least_separation(a.motion, b.motion,
                                  {relative_width, vertical_scale, most_evaluations})
              .value();
        });
      },
      py::arg("a"), py::arg("b"), py::kw_only(), width, scale, most,
      "The least distance over all common times, enclosed to relative_width of the shorter path's "
      "length;\nheights count times vertical_scale. Raises HodographError: outside_domain (no "
      "common time).");
  m.def(
      "separated_by",
      [](const Motion& a, const Motion& b, double distance, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        require_finite({&distance, 1}, "distance");
        require_scale(vertical_scale);
        return unlocked([&] {
          return separated_by(a.motion, b.motion, distance,
                              {relative_width, vertical_scale, most_evaluations});
        });
      },
      py::arg("a"), py::arg("b"), py::arg("distance"), py::kw_only(), width, scale, most,
      "Whether the motions keep at least a distance; yes and no are certain.");
  m.def(
      "stepped_separation",
      [](const Motion& a, const Motion& b, double step, double relative_width,
         double vertical_scale, std::size_t most_evaluations) {
        return unlocked([&] {
          return stepped_separation(a.motion, b.motion, step,
                                    {relative_width, vertical_scale, most_evaluations})
              .value();
        });
      },
      py::arg("a"), py::arg("b"), py::arg("step"), py::kw_only(), width, scale, most,
      "The distance at times a step apart, and what that proves of the minimum.");
  m.def(
      "close_passages",
      [](const Motion& a, const Motion& b, double distance, double resolution,
         double relative_width, double vertical_scale, std::size_t most_evaluations) {
        return unlocked([&] {
          return close_passages(a.motion, b.motion, distance, resolution,
                                {relative_width, vertical_scale, most_evaluations})
              .value();
        });
      },
      py::arg("a"), py::arg("b"), py::arg("distance"), py::arg("resolution"), py::kw_only(), width,
      scale, most,
      "All times at which the motions come closer than a distance, to within `resolution` of "
      "time.");
}

}  // namespace

void bind_timed_motion(py::module_& m) {
  bind_motions(m);
  add_equality_of_states(py::type::of<Motion>());
  add_equality_of_states(py::type::of<Flyer>());
  bind_separation_results(m);
  bind_separations(m);
}

}  // namespace hodograph::python
