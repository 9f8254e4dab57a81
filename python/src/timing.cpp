// SPDX-License-Identifier: MIT
// When a vehicle is where on its path: path/timing_law.hpp, path/curvature_limited_timing.hpp.
#include "hodograph/path/timing_law.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hodograph/path/curvature_limited_timing.hpp"
#include "python/src/bindings.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

TrapezoidalSpeed limits_of(double cruise_speed, double acceleration,
                           std::optional<double> deceleration, double start_speed,
                           double end_speed) {
  return {cruise_speed, acceleration, deceleration.value_or(acceleration), start_speed, end_speed};
}

/// The pieces as rows begin, duration, arc length, p, q.
Doubles pieces_of(const TimingLaw& law) {
  constexpr py::ssize_t columns = 5;
  Doubles rows({static_cast<py::ssize_t>(law.pieces().size()), columns});
  double* to = rows.mutable_data();
  for (const TimingLaw::Piece& piece : law.pieces()) {
    for (const double x :
         {piece.begin, piece.duration, piece.arc_length, piece.first, piece.second}) {
      *to++ = x;
    }
  }
  return rows;
}

TimingLaw law_of(const Doubles& pieces, double length, double start_time) {
  constexpr py::ssize_t columns = 5;
  if (pieces.ndim() != 2 || pieces.shape(1) != columns) refuse_shape("pieces", "(n, 5)", pieces);
  std::vector<TimingLaw::Piece> list;
  const double* from = pieces.data();
  for (py::ssize_t i = 0; i < pieces.shape(0); ++i, from += columns) {
    list.push_back({from[0], from[1], from[2], from[3], from[4]});
  }
  return TimingLaw::from_pieces(list, length, start_time).value();
}

std::string text_of(const TimingLaw& law) {
  return "<hodograph.TimingLaw: length " + to_text(law.length()) + ", from " +
         to_text(law.start_time()) + " to " + to_text(law.end_time()) + ", " +
         std::to_string(law.pieces().size()) + (law.pieces().size() == 1 ? " piece>" : " pieces>");
}

template <class Value>
auto at_times(Value value) {
  return [value](const TimingLaw& law, const Doubles& at) {
    return numbers_like(at, [&](auto from, auto to) {
      for (std::size_t i = 0; i < from.size(); ++i) to[i] = (law.*value)(from[i]);
    });
  };
}

}  // namespace

void bind_timing(py::module_& m) {
  py::class_<TimingLaw> law(m, "TimingLaw",
                            "The arc length as a monotone function of time, with speed continuous "
                            "in between; made by its\nstatic functions. A value; times may be "
                            "numbers or arrays of any shape.");
  law.def_static(
         "constant_speed",
         [](double length, double speed, double start_time) {
           return TimingLaw::constant_speed(length, speed, start_time).value();
         },
         py::arg("length"), py::arg("speed"), py::arg("start_time") = 0.0,
         "s = speed (t - start_time). Raises HodographError: not_finite, outside_domain.")
      .def_static(
          "between",
          [](double length, double start_time, double arrival_time) {
            return TimingLaw::between(length, start_time, arrival_time).value();
          },
          py::arg("length"), py::arg("start_time"), py::arg("arrival_time"),
          "The constant speed that covers the length between two times.")
      .def_static(
          "trapezoidal",
          [](double length, double cruise_speed, double acceleration,
             std::optional<double> deceleration, double start_speed, double end_speed,
             double start_time) {
            return TimingLaw::trapezoidal(
                       length,
                       limits_of(cruise_speed, acceleration, deceleration, start_speed, end_speed),
                       start_time)
                .value();
          },
          py::arg("length"), py::kw_only(), py::arg("cruise_speed") = 1.0,
          py::arg("acceleration") = 1.0, py::arg("deceleration") = py::none(),
          py::arg("start_speed") = 0.0, py::arg("end_speed") = 0.0, py::arg("start_time") = 0.0,
          "The fastest law: accelerate, cruise, decelerate (as fast as accelerate unless given).\n"
          "Raises HodographError: outside_domain, no_interpolant (too short).")
      .def_static(
          "under_limits",
          [](const Doubles& arc_lengths, const Doubles& most_speeds, double cruise_speed,
             double acceleration, std::optional<double> deceleration, double start_speed,
             double end_speed, double start_time) {
            const auto at = numbers_of(arc_lengths, "arc_lengths");
            const auto most = numbers_of(most_speeds, "most_speeds");
            const auto limits =
                limits_of(cruise_speed, acceleration, deceleration, start_speed, end_speed);
            return unlocked(
                [&] { return TimingLaw::under_limits(at, most, limits, start_time).value(); });
          },
          py::arg("arc_lengths"), py::arg("most_speeds"), py::kw_only(),
          py::arg("cruise_speed") = 1.0, py::arg("acceleration") = 1.0,
          py::arg("deceleration") = py::none(), py::arg("start_speed") = 0.0,
          py::arg("end_speed") = 0.0, py::arg("start_time") = 0.0,
          "The fastest law below most_speeds[i] between arc_lengths[i] and arc_lengths[i + 1], "
          "which begin at 0.")
      .def_static(
          "from_speeds",
          [](const Doubles& durations, const Doubles& speeds, double length, double start_time) {
            return TimingLaw::from_speeds(numbers_of(durations, "durations"),
                                          numbers_of(speeds, "speeds"), length, start_time)
                .value();
          },
          py::arg("durations"), py::arg("speeds"), py::arg("length"), py::arg("start_time") = 0.0,
          "From speeds (n + 1,) between pieces of given durations (n,), linear in between.")
      .def_static("from_pieces", &law_of, py::arg("pieces"), py::arg("length"),
                  py::arg("start_time") = 0.0, "The law that has these pieces, (n, 5).")
      .def_property_readonly("length", &TimingLaw::length)
      .def_property_readonly("start_time", &TimingLaw::start_time)
      .def_property_readonly("end_time", &TimingLaw::end_time)
      .def_property_readonly("duration", &TimingLaw::duration)
      .def_property_readonly("most_speed", &TimingLaw::most_speed, "Rounded up.")
      .def_property_readonly("most_acceleration", &TimingLaw::most_acceleration,
                             "The largest |acceleration|, rounded up.")
      .def_property_readonly("pieces", &pieces_of,
                             "(n, 5): time and duration, counted from the start, arc length, and p "
                             "and q of\ns = s_i + 2u(1 - u) p + u^2 (p + q).")
      .def("arc_length_at", at_times(&TimingLaw::arc_length_at), py::arg("t"),
           "The arc length at times from start_time to end_time.")
      .def("speed_at", at_times(&TimingLaw::speed_at), py::arg("t"), "The speed at such times.")
      .def("time_at", at_times(&TimingLaw::time_at), py::arg("s"),
           "The first time at which the arc length s has been covered, 0 <= s <= length.")
      .def("arc_length_error", &TimingLaw::arc_length_error,
           "A bound of the rounding of arc_length_at.")
      .def(
          "delayed",
          [](const TimingLaw& self, double delay) {
            require_finite({&delay, 1}, "delay");
            return self.delayed(delay);
          },
          py::arg("delay"), "The same law, later.")
      .def(
          "__eq__", [](const TimingLaw& a, const TimingLaw& b) { return a == b; },
          py::is_operator())
      .def("__repr__", &text_of)
      .def("__copy__", [](const TimingLaw& self) { return self; })
      .def(
          "__deepcopy__", [](const TimingLaw& self, const py::dict&) { return self; },
          py::arg("memo"))
      .def(py::pickle(
          [](const TimingLaw& self) {
            return py::make_tuple(pieces_of(self), self.length(), self.start_time());
          },
          [](const py::tuple& t) {
            return law_of(t[0].cast<Doubles>(), t[1].cast<double>(), t[2].cast<double>());
          }))
      .attr("__hash__") = py::none();

  const LateralLimit usual{};
  m.def(
      "curvature_limited_timing",
      [](const AnyPath& path, double lateral_acceleration, double cruise_speed, double acceleration,
         std::optional<double> deceleration, double start_speed, double end_speed,
         std::size_t parts_per_segment, double start_time) {
        const LateralLimit limit{
            lateral_acceleration,
            limits_of(cruise_speed, acceleration, deceleration, start_speed, end_speed),
            parts_per_segment};
        return unlocked([&] {
          return path.visit([&](const auto& typed) {
            const auto parts =
                curvature_parts(typed, std::max<std::size_t>(1, limit.parts_per_segment));
            return curvature_limited_timing(parts, limit, start_time).value();
          });
        });
      },
      py::arg("path"), py::kw_only(), py::arg("lateral_acceleration") = usual.lateral_acceleration,
      py::arg("cruise_speed") = usual.along.cruise_speed,
      py::arg("acceleration") = usual.along.acceleration, py::arg("deceleration") = py::none(),
      py::arg("start_speed") = 0.0, py::arg("end_speed") = 0.0,
      py::arg("parts_per_segment") = usual.parts_per_segment, py::arg("start_time") = 0.0,
      "The fastest timing of a path whose lateral acceleration v^2 |kappa| keeps a bound at every "
      "point.\nRaises HodographError: outside_domain, no_interpolant (a point of zero speed; "
      "speeds "
      "at the ends).");
}

}  // namespace hodograph::python
