// SPDX-License-Identifier: MIT
// Rolls of adapted frames of every kind, and the frames rolled by them: frame/roll.hpp,
// rolled_frames.hpp, rolled_state.hpp, twist.hpp, frenet.hpp.
#include "hodograph/frame/roll.hpp"

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/frame/minimising_frames.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "hodograph/frame/rolled_state.hpp"
#include "hodograph/frame/twist.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/swept.hpp"

namespace hodograph::python {

namespace {

PreimageTable table_of(const AnyPath& path) { return PreimageTable::of(path).value(); }

/// The roll that make(table) returns, made without the interpreter's lock.
template <class Make>
auto rolled_by(const AnyPath& path, const Make& make) {
  return unlocked([&] { return make(table_of(path)).value(); });
}

/// value(i) for every i; an Error without an index gets i.
template <class Value>
void at_each(std::size_t count, const Value& value) {
  for (std::size_t i = 0; i < count; ++i) {
    try {
      value(i);
    } catch (const Error& error) {
      Fault fault = error.fault();
      if (!fault.index && count > 1) fault.index = i;
      throw Error(fault);
    }
  }
}

/// Frames as matrices whose columns are the axes.
py::array_t<double> matrices(const Doubles& axes) {
  return py::array_t<double>(axes.attr("swapaxes")(-1, -2));
}

Doubles derivatives(const FrameRoll& roll, const Doubles& xi, std::size_t order) {
  if (order > 4) {
    throw Error(Fault{FaultCode::unsupported,
                      "derivatives of order 0 to 4 are offered; got " + std::to_string(order),
                      std::nullopt, "order", static_cast<double>(order), 4.0});
  }
  const std::size_t row = order + 1;
  return filled_like(xi, {static_cast<py::ssize_t>(row)}, [&](auto from, auto to) {
    at_each(from.size(),
            [&](std::size_t i) { roll.derivatives(from[i], to.subspan(i * row, row)); });
  });
}

void require_segment(const FrameRoll& roll, std::size_t segment) {
  if (segment < roll.segment_count()) return;
  throw Error(Fault{FaultCode::outside_domain,
                    "the roll has " + std::to_string(roll.segment_count()) +
                        " segments, counted from 0; got " + std::to_string(segment),
                    std::nullopt, "segment", static_cast<double>(segment),
                    static_cast<double>(roll.segment_count() - 1)});
}

std::string text_of(RollKind kind) { return py::cast(kind).attr("name").cast<std::string>(); }

/// RolledState at many parameters.
struct RolledStates {
  Doubles rotation;
  py::array_t<double> frame;
  Doubles body_rate_per_xi;
  FloatOrArray roll, speed;
};

RolledStates states(const AnyPath& path, const FrameRoll& roll, const Doubles& xi) {
  const Shape one = shape_of(xi);
  const auto with = [&](const Shape& tail) {
    Shape shape = one;
    shape.insert(shape.end(), tail.begin(), tail.end());
    return Doubles(shape);
  };
  Doubles rotations = with({4}), frames = with({3, 3}), rates = with({3}), angles = with({}),
          speeds = with({});
  double *q = rotations.mutable_data(), *f = frames.mutable_data(), *r = rates.mutable_data(),
         *a = angles.mutable_data(), *v = speeds.mutable_data();
  const auto from = numbers(xi);
  unlocked([&] {
    const PreimageTable table = table_of(path);
    at_each(from.size(), [&](std::size_t i) {
      const RolledState state = rolled_state(table, roll, from[i]);
      for (std::size_t j = 0; j < 4; ++j) *q++ = state.rotation[j];
      for (const auto* axis : {&state.frame.e1, &state.frame.e2, &state.frame.e3}) {
        for (std::size_t j = 0; j < 3; ++j) *f++ = (*axis)[j];
      }
      for (std::size_t j = 0; j < 3; ++j) *r++ = state.body_rate_per_xi[j];
      *a++ = state.roll;
      *v++ = state.speed;
    });
  });
  return {rotations, matrices(frames), rates, FloatOrArray(angles), FloatOrArray(speeds)};
}

py::array_t<double> frames_at(const RolledFrames& frames, const Doubles& xi) {
  static_assert(sizeof(Frame3<double>) == 9 * sizeof(double));
  return matrices(filled_like(xi, {3, 3}, [&](auto from, auto to) {
    frames.at(from, {reinterpret_cast<Frame3<double>*>(to.data()), from.size()});
  }));
}

void bind_kinds(py::module_& m) {
  py::enum_<RollKind>(m, "RollKind", "What a roll is for.")
      .value("none", RollKind::none)
      .value("linear", RollKind::linear)
      .value("frenet", RollKind::frenet)
      .value("rotation_minimising", RollKind::rotation_minimising)
      .value("periodic", RollKind::periodic)
      .value("least_twist", RollKind::least_twist);
  py::enum_<RollMethod>(m, "RollMethod", "How the angle over a segment was found.")
      .value("polynomial", RollMethod::polynomial, "None and linear: exact.")
      .value("argument", RollMethod::argument, "The argument of a complex polynomial.")
      .value("partial_fractions", RollMethod::partial_fractions, "Complex logarithms.")
      .value("quadrature", RollMethod::quadrature, "Certified series.");
  py::enum_<RollIntegration>(m, "RollIntegration", "How to integrate where there is a choice.")
      .value("series", RollIntegration::series, "Certified series, with a rigorous bound.")
      .value("closed_form", RollIntegration::closed_form, "Partial fractions over segments.");
  Record<FrenetInflection>(m, "FrenetInflection", "Where the principal normal changes sides.")
      .field("xi", &FrenetInflection::xi)
      .field("rounding", &FrenetInflection::rounding, "How far the true parameter may be.");
}

void bind_class(py::module_& m) {
  made_class<FrameRoll>(m, "FrameRoll",
                        "The roll theta(xi) of an adapted frame against the Euler-Rodrigues frame, "
                        "radians, positive\nfrom e2 to e3. A value; it does not refer to the path.")
      .def_static(
          "none",
          [](const AnyPath& path) { return made(FrameRoll::none(table_of(path)), "none", path); },
          py::arg("path"), "The Euler-Rodrigues frame itself: theta = 0.")
      .def_static(
          "linear",
          [](const AnyPath& path, double begin, double rate) {
            for (const double x : {begin, rate}) {
              if (!std::isfinite(x)) {
                throw Error(Fault{FaultCode::not_finite,
                                  "a linear roll takes finite numbers; got " + to_text(x),
                                  std::nullopt, "rate", x, std::nullopt});
              }
            }
            return made(FrameRoll::linear(table_of(path), begin, rate), "linear", path, begin,
                        rate);
          },
          py::arg("path"), py::arg("begin"), py::arg("rate"),
          "theta = begin + rate (xi - xi_begin), radians.")
      .def_property_readonly("kind", &FrameRoll::kind)
      .def_property_readonly("knots", [](const FrameRoll& roll) { return array_of(roll.knots()); })
      .def_property_readonly("segment_count", &FrameRoll::segment_count)
      .def(
          "angle",
          [](const FrameRoll& roll, const Doubles& xi) {
            return numbers_like(xi, [&](auto from, auto to) {
              at_each(from.size(), [&](std::size_t i) { to[i] = roll.angle(from[i]); });
            });
          },
          py::arg("xi"), "theta(xi). Raises HodographError: outside_domain.")
      .def("derivatives", &derivatives, py::arg("xi"), py::arg("order") = 4,
           "theta and its derivatives with respect to xi up to the order (at most 4), shape (..., "
           "order + 1).")
      .def(
          "method",
          [](const FrameRoll& roll, std::size_t segment) {
            require_segment(roll, segment);
            return roll.method(segment);
          },
          py::arg("segment"), "How the angle over a segment was found.")
      .def(
          "angle_at_begin",
          [](const FrameRoll& roll, std::size_t segment) {
            require_segment(roll, segment);
            return roll.angle_at_begin(segment);
          },
          py::arg("segment"), "theta where a segment begins.")
      .def(
          "angle_at_end",
          [](const FrameRoll& roll, std::size_t segment) {
            require_segment(roll, segment);
            return roll.angle_at_end(segment);
          },
          py::arg("segment"), "theta where a segment ends.")
      .def_property_readonly("error_bound", &FrameRoll::error_bound,
                             "How far any angle may be from the exact integral, radians.")
      .def_property_readonly("inflections", &FrameRoll::inflections,
                             "Where the principal normal changes sides: kind frenet.")
      .def_property_readonly("gamma", &FrameRoll::gamma, "Of a periodic roll, else 0.")
      .def_property_readonly("psi", &FrameRoll::psi, "Of a periodic roll, else 0.")
      .def_property_readonly("twist_rate", &FrameRoll::twist_rate,
                             "Of a least twist: radians an arc length, else 0.")
      .def_property_readonly("linear_rate", &FrameRoll::linear_rate, "Of a linear roll, else 0.")
      .def("__repr__", [](const FrameRoll& roll) {
        return "<hodograph.FrameRoll: " + text_of(roll.kind()) + ", " +
               std::to_string(roll.segment_count()) +
               (roll.segment_count() == 1 ? " segment>" : " segments>");
      });
}

void bind_makers(py::module_& m) {
  m.def(
      "rotation_minimising_roll",
      [](const AnyPath& path, double begin, RollIntegration integration) {
        auto roll = rolled_by(path, [&](const PreimageTable& table) {
          return rotation_minimising_roll(table, begin, integration);
        });
        return made(std::move(roll), "rotation_minimising_roll", path, begin, integration);
      },
      py::arg("path"), py::arg("begin") = 0.0, py::arg("integration") = RollIntegration::series,
      "The roll without rotation about the tangent, theta(xi_begin) = begin. Raises "
      "HodographError:\nzero_speed, not_continuous, not_finite.");
  m.def(
      "rotation_minimising_roll_within",
      [](const AnyPath& path, double accuracy, double begin) {
        auto roll = rolled_by(path, [&](const PreimageTable& table) {
          return rotation_minimising_roll_within(table, accuracy, begin);
        });
        return made(std::move(roll), "rotation_minimising_roll_within", path, accuracy, begin);
      },
      py::arg("path"), py::arg("accuracy"), py::arg("begin") = 0.0,
      "The same, quicker where an accuracy (radians) is enough.");
  m.def(
      "frenet_roll",
      [](const AnyPath& path) {
        auto roll = rolled_by(path, [](const PreimageTable& table) { return frenet_roll(table); });
        return made(std::move(roll), "frenet_roll", path);
      },
      py::arg("path"),
      "The roll whose e2 is the principal normal. Raises HodographError: zero_speed, "
      "outside_domain (a\nstraight segment).");
  m.def(
      "periodic_roll",
      [](const AnyPath& path, double gamma) {
        auto roll = rolled_by(
            path, [&](const PreimageTable& table) { return periodic_roll(table, gamma); });
        return made(std::move(roll), "periodic_roll", path, gamma);
      },
      py::arg("path"), py::arg("gamma"),
      "The periodic rational frame of a closed path, gamma not 0. Raises HodographError: "
      "unsupported,\nnot_continuous, outside_domain, zero_speed.");
  Record<SmoothGammas>(m, "SmoothGammas", "The gammas of periodic frames that are C1 all round.")
      .field("negative", &SmoothGammas::negative)
      .field("positive", &SmoothGammas::positive);
  m.def(
      "smooth_periodic_gammas",
      [](const AnyPath& path) {
        return rolled_by(path,
                         [](const PreimageTable& table) { return smooth_periodic_gammas(table); });
      },
      py::arg("path"), "The two gammas whose periodic frames are C1 at the closing knot as well.");
  Record<LeastTwistGamma>(m, "LeastTwistGamma", "The periodic frame of least absolute twist.")
      .field("gamma", &LeastTwistGamma::gamma)
      .field("absolute_twist", &LeastTwistGamma::absolute_twist, "Radians.")
      .field("plateau", &LeastTwistGamma::plateau, "Whether a whole interval of gammas has it.");
  m.def(
      "least_twist_gamma",
      [](const AnyPath& path) {
        return rolled_by(path, [](const PreimageTable& table) { return least_twist_gamma(table); });
      },
      py::arg("path"), "The gamma of the periodic frame with the least absolute twist.");
  m.def(
      "least_twist_roll",
      [](const AnyPath& path, double begin, std::optional<double> end) {
        auto roll = rolled_by(
            path, [&](const PreimageTable& table) { return least_twist_roll(table, begin, end); });
        return made(std::move(roll), "least_twist_roll", path, begin, end);
      },
      py::arg("path"), py::arg("begin") = 0.0, py::arg("end") = py::none(),
      "Rotation-minimising but for a rotation that is even over the arc length: it returns to "
      "itself on a\nclosed path, and ends with the roll `end` (modulo 2 pi) on an open one.");
}

py::array_t<double> minimising_frames(const AnyPath& path, double accuracy, const Doubles& xi,
                                      double begin) {
  return matrices(filled_like(xi, {3, 3}, [&](auto from, auto to) {
    rotation_minimising_frames(
        table_of(path), accuracy, from,
        std::span<Frame3<double>>(reinterpret_cast<Frame3<double>*>(to.data()), from.size()), begin)
        .value();
  }));
}

void bind_frames(py::module_& m) {
  m.def("rotation_minimising_frames", &minimising_frames, py::arg("path"), py::arg("accuracy"),
        py::arg("xi"), py::arg("begin") = 0.0,
        "The rotation-minimising frames at increasing xi, (..., 3, 3), to an accuracy in radians: "
        "quicker than a\nroll where frames are few. Raises HodographError: outside_domain, "
        "zero_speed, tolerance_not_reached.");
  made_class<RolledFrames>(m, "RolledFrames", "The frames of a path under a roll, in batches.")
      .def(py::init([](const AnyPath& path, const Made<FrameRoll>& roll) {
             auto frames = unlocked([&] { return RolledFrames(table_of(path), roll); });
             return made(std::move(frames), "", path, roll);
           }),
           py::arg("path"), py::arg("roll"))
      .def(
          "at",
          [](const Made<RolledFrames>& self, const Doubles& xi) { return frames_at(self, xi); },
          py::arg("xi"),
          "The frames as matrices with the axes e1 (the tangent), e2, e3 as columns, shape (..., "
          "3, 3).\nRaises HodographError: outside_domain, zero_speed.")
      .def("__repr__", [](const Made<RolledFrames>& self) {
        return "<hodograph.RolledFrames: of " + std::string(py::repr(self.of[1])) + ">";
      });
  Record<RolledStates>(m, "RolledState", "A rolled frame at one parameter or at many.")
      .field("rotation", &RolledStates::rotation, "Unit quaternions (w, x, y, z), (..., 4).")
      .field("frame", &RolledStates::frame, "The axes as columns, (..., 3, 3).")
      .field("body_rate_per_xi", &RolledStates::body_rate_per_xi,
             "Angular velocity of this frame, (..., 3).")
      .field("roll", &RolledStates::roll, "theta, radians.")
      .field("speed", &RolledStates::speed);
  m.def("rolled_state", &states, py::arg("path"), py::arg("roll"), py::arg("xi"),
        "The rolled frame as a rotation and as axes, with its angular velocity, at xi.");
  m.def(
      "roll_towards",
      [](const AnyPath& path, double xi, const Doubles& side) {
        return roll_towards(table_of(path), xi, point_of<Vector3<double>>(side, "side"));
      },
      py::arg("path"), py::arg("xi"), py::arg("side"),
      "The roll at xi whose e2 points towards a vector's part across the tangent, radians.");
}

void bind_twist(py::module_& m) {
  Record<TwistInflection>(m, "TwistInflection", "Where a frame's rotation about the tangent stops.")
      .field("xi", &TwistInflection::xi)
      .field("kind", &TwistInflection::kind, "simple: it certainly changes its sense there.");
  Record<FrameTwist>(m, "FrameTwist", "How much a frame rotates about its tangent, radians.")
      .field("total", &FrameTwist::total)
      .field("absolute", &FrameTwist::absolute)
      .field("inflections", &FrameTwist::inflections);
  m.def(
      "frame_twist",
      [](const AnyPath& path, const FrameRoll& roll) {
        return rolled_by(path,
                         [&](const PreimageTable& table) { return frame_twist(table, roll); });
      },
      py::arg("path"), py::arg("roll"),
      "The twist and the absolute twist of the frame with this roll, enclosed.");
  Record<ClosedFormTwist>(m, "ClosedFormTwist", "A twist in closed form with an estimated error.")
      .field("value", &ClosedFormTwist::value)
      .field("error", &ClosedFormTwist::error);
  m.def(
      "erf_twist_in_closed_form",
      [](const AnyPath& path) { return erf_twist_in_closed_form(table_of(path)); }, py::arg("path"),
      "The twist of the Euler-Rodrigues frame by partial fractions; None where these lose too "
      "much.");
}

}  // namespace

void bind_roll(py::module_& m) {
  bind_kinds(m);
  bind_class(m);
  bind_makers(m);
  bind_frames(m);
  bind_twist(m);
}

}  // namespace hodograph::python
