// SPDX-License-Identifier: MIT
// How smooth paths and their frames are: frame/any_continuity.hpp. Helices recognised:
// path/helix.hpp.
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/frame/any_continuity.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/path/helix.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/swept.hpp"

namespace hodograph::python {

namespace {

/// ScaledJumps, and WorstJumps where knots are given, of any number of derivatives.
struct Jumps {
  std::vector<double> jump, allowed;
  std::vector<std::size_t> knot;
  int order = -1;
};
template <std::size_t count>
Jumps jumps_of(const ScaledJumps<double, count>& from) {
  return {{from.jump.begin(), from.jump.end()},
          {from.allowed.begin(), from.allowed.end()},
          {},
          from.order()};
}
template <std::size_t count>
Jumps jumps_of(const WorstJumps<double, count>& from) {
  Jumps jumps = jumps_of(static_cast<const ScaledJumps<double, count>&>(from));
  jumps.knot.assign(from.knot.begin(), from.knot.end());
  return jumps;
}

struct Smoothness {
  Jumps position, preimage;
  bool antiperiodic = false;
};
struct FrameSmoothness {
  Jumps frame, angular_velocity;
};
struct HolonomyNumbers {
  double roll = 0.0;
  int sign = 1;
};

void bind_jumps(py::module_& m) {
  Record<Jumps>(
      m, "WorstJumps",
      "The jumps of a quantity and its derivatives, without unit, by order of derivative.")
      .field("jump", &Jumps::jump, "Scaled by the size and the shorter step.")
      .field("allowed", &Jumps::allowed, "What rounding may make of each.")
      .field("knot", &Jumps::knot, "Where; empty for the jumps at one knot. The closing knot is 0.")
      .field("order", &Jumps::order, "How often it is continuously differentiable; -1: it jumps.");
  Record<Smoothness>(m, "PathContinuity", "The jumps of position and preimage.")
      .field("position", &Smoothness::position, "r to r''''.")
      .field("preimage", &Smoothness::preimage, "A to A'''.")
      .field("antiperiodic", &Smoothness::antiperiodic, "Closed, to the preimage's negative.");
  Record<FrameSmoothness>(m, "FrameContinuity", "The jumps of the Euler-Rodrigues frame.")
      .field("frame", &FrameSmoothness::frame, "R to R'''.")
      .field("angular_velocity", &FrameSmoothness::angular_velocity, "omega to omega''.");
  m.def(
      "continuity",
      [](const AnyPath& path) {
        const auto found = unlocked([&] { return continuity(path); });
        return Smoothness{jumps_of(found.position), jumps_of(found.preimage), found.antiperiodic};
      },
      py::arg("path"), "The worst jumps over all knots where segments meet.");
  m.def(
      "frame_continuity",
      [](const AnyPath& path) {
        const auto found = unlocked([&] { return frame_continuity(path); });
        return FrameSmoothness{jumps_of(found.frame), jumps_of(found.angular_velocity)};
      },
      py::arg("path"), "The same of the frame and its angular velocity.");
  m.def(
      "jumps_at_knot",
      [](const AnyPath& path, std::size_t knot) {
        const auto found = jumps_at_knot(path, knot).value();
        return Smoothness{jumps_of(found.position), jumps_of(found.preimage), found.antiperiodic};
      },
      py::arg("path"), py::arg("knot"),
      "The jumps at one knot; 0 is where a closed path closes. Raises HodographError: "
      "outside_domain.");
  m.def(
      "frame_jumps_at_knot",
      [](const AnyPath& path, std::size_t knot) {
        const auto found = frame_jumps_at_knot(path, knot).value();
        return FrameSmoothness{jumps_of(found.frame), jumps_of(found.angular_velocity)};
      },
      py::arg("path"), py::arg("knot"), "The same of the frame and its angular velocity.");
  Record<HolonomyNumbers>(m, "Holonomy", "What is left over when the frame has gone once round.")
      .field("roll", &HolonomyNumbers::roll, "Radians, in (-pi, pi].")
      .field("sign", &HolonomyNumbers::sign, "-1: the preimage returns to its negative.");
  m.def(
      "holonomy",
      [](const AnyPath& path) {
        const auto found = holonomy(path).value();
        return HolonomyNumbers{found.roll, found.sign};
      },
      py::arg("path"),
      "The holonomy of a closed path. Raises HodographError: unsupported, zero_speed, "
      "not_continuous.");
  m.def(
      "closing_roll",
      [](const AnyPath& path) {
        const auto roll = closing_roll(path).value();
        return made(FrameRoll::linear(PreimageTable::of(path).value(), roll.theta_begin, roll.rate),
                    "closing_roll", path);
      },
      py::arg("path"), "The roll that distributes the holonomy evenly over xi.");
}

/// FrenetState at one parameter or many.
struct FrenetStates {
  py::array_t<double> frame;
  FloatOrArray curvature, torsion, roll;
};

FrenetStates frenet_at(const AnyPath& path, const Doubles& xi) {
  const Shape one = shape_of(xi);
  Shape square = one;
  square.insert(square.end(), {3, 3});
  Doubles frames(square), curvatures(one), torsions(one), rolls(one);
  double *f = frames.mutable_data(), *k = curvatures.mutable_data(), *t = torsions.mutable_data(),
         *r = rolls.mutable_data();
  const auto from = numbers(xi);
  unlocked([&] {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto state = frenet(path, from[i]);
      if (!state) {
        throw Error(Fault{FaultCode::outside_domain,
                          "the curvature is zero, within rounding, at xi = " + to_text(from[i]) +
                              " (index " + std::to_string(i) + "): no Frenet frame exists there",
                          i, "curvature", 0.0, std::nullopt});
      }
      for (std::size_t row = 0; row < 3; ++row) {
        for (const auto* axis : {&state->frame.e1, &state->frame.e2, &state->frame.e3}) {
          *f++ = (*axis)[row];
        }
      }
      *k++ = state->curvature;
      *t++ = state->torsion;
      *r++ = state->roll;
    }
  });
  return {frames, FloatOrArray(curvatures), FloatOrArray(torsions), FloatOrArray(rolls)};
}

void bind_frenet(py::module_& m) {
  Record<FrenetStates>(m, "FrenetState", "Tangent, principal normal and binormal.")
      .field("frame", &FrenetStates::frame, "The axes as columns, (..., 3, 3).")
      .field("curvature", &FrenetStates::curvature)
      .field("torsion", &FrenetStates::torsion)
      .field("roll", &FrenetStates::roll, "Against the Euler-Rodrigues frame, in (-pi, pi].");
  m.def("frenet", &frenet_at, py::arg("path"), py::arg("xi"),
        "The Frenet frame of a path in space. Raises HodographError: outside_domain (xi, or the "
        "curvature is\nzero within rounding there), unsupported.");
}

const AnyPath& in_space_only(const AnyPath& path) {
  if (path.dimension() == 3) return path;
  throw Error(Fault{FaultCode::unsupported, "a helix is a path in space; this one is planar",
                    std::nullopt, "dimension", 2.0, 3.0});
}

void bind_helix(py::module_& m) {
  using Point = Vector3<double>;
  Record<HelixStretch>(m, "HelixStretch", "Consecutive segments of one climb angle.")
      .field("first", &HelixStretch::first, "Segment.")
      .field("last", &HelixStretch::last, "Segment.")
      .field("sine", &HelixStretch::sine, "Of the angle between the tangent and the level.")
      .field("sine_range", &HelixStretch::sine_range, "Contains it everywhere on them.");
  Record<HelixFit>(m, "HelixFit", "The axis that fits a path best, and how the path climbs.")
      .field("axis", &HelixFit::axis, "Unit, in the upper half-space, (3,).")
      .field("residual", &HelixFit::residual)
      .field("freedom", &HelixFit::freedom, "0: no axis fits within rounding; 1: this one; 3: any.")
      .field("stretches", &HelixFit::stretches)
      .property("is_helical", &HelixFit::is_helical)
      .property("is_helix", &HelixFit::is_helix, "With one climb angle.");
  m.def(
      "recognised_helix",
      [](const AnyPath& path) {
        in_space_only(path);
        return unlocked([&] { return recognised_helix(path.numbers()); });
      },
      py::arg("path"), "The axis to which the tangent of a path in space is equally inclined.");
  m.def(
      "sine_range",
      [](const AnyPath& path, const Doubles& axis, std::size_t first, std::size_t last) {
        in_space_only(path);
        if (!(first <= last && last < path.segment_count())) {
          throw Error(Fault{FaultCode::outside_domain,
                            "segments run from a first to a last below " +
                                std::to_string(path.segment_count()) + "; got " +
                                std::to_string(first) + " and " + std::to_string(last),
                            std::nullopt, "last", static_cast<double>(last),
                            static_cast<double>(path.segment_count() - 1)});
        }
        return sine_range(path.numbers(), point_of<Point>(axis, "axis"), first, last);
      },
      py::arg("path"), py::arg("axis"), py::arg("first"), py::arg("last"),
      "Contains the component of the unit tangent along an axis (3,) on these segments.");
  const auto checked = [](const Doubles& array) {
    const auto axis = point_of<Point>(array, "axis");
    if (auto fault = path_detail::axis_fault(axis)) throw Error(*fault);
    return axis;
  };
  m.def(
      "unit_axis", [checked](const Doubles& axis) { return array_of(unit_axis(checked(axis))); },
      py::arg("axis"), "The axis (3,) with length 1. Raises HodographError: outside_domain.");
  m.def(
      "turn_upright",
      [checked](const Doubles& axis) { return array_of(turn_upright(checked(axis))); },
      py::arg("axis"), "The unit quaternion (4,) that turns an axis (3,) upright.");
}

}  // namespace

void bind_continuity(py::module_& m) {
  bind_jumps(m);
  bind_frenet(m);
  bind_helix(m);
}

}  // namespace hodograph::python
