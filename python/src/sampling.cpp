// SPDX-License-Identifier: MIT
// Where to take points, derivatives of the curvature, lifts: path/any_sampling.hpp,
// curve/curvature_derivatives.hpp, construction/any_lift.hpp.
#include "hodograph/path/any_sampling.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "hodograph/construction/any_lift.hpp"
#include "hodograph/curve/curvature_derivatives.hpp"
#include "hodograph/frame/any_batch.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

template <class Parameters>
Doubles made_by(const Parameters& parameters) {
  return array_of(unlocked([&] { return parameters().value(); }));
}

void bind_parameters(py::module_& m) {
  m.attr("maximum_sample_count") = maximum_sample_count;
  m.def(
      "parameters_even_in_xi",
      [](const AnyPath& path, std::size_t count) {
        return made_by([&] { return parameters_even_in_xi(path, count); });
      },
      py::arg("path"), py::arg("count"),
      "count parameters, evenly spaced in xi. Raises HodographError: too_few (fewer than 2), "
      "unsupported.");
  m.def(
      "parameters_even_in_arc_length",
      [](const AnyPath& path, std::size_t count) {
        return made_by([&] { return parameters_even_in_arc_length(path, count); });
      },
      py::arg("path"), py::arg("count"), "count parameters, evenly spaced in arc length.");
  m.def(
      "parameters_by_arc_length_step",
      [](const AnyPath& path, double step) {
        return made_by([&] { return parameters_by_arc_length_step(path, step); });
      },
      py::arg("path"), py::arg("step"),
      "The parameters at arc lengths 0, step, 2 step, ... and at the end.");
  m.def(
      "parameters_per_segment",
      [](const AnyPath& path, std::size_t count) {
        return made_by([&] { return parameters_per_segment(path, count); });
      },
      py::arg("path"), py::arg("count"),
      "count parameters in each segment and the last knot, every knot among them.");
  m.def(
      "polyline_parameters",
      [](const AnyPath& path, double tolerance) {
        return made_by([&] { return polyline_parameters(path, tolerance); });
      },
      py::arg("path"), py::arg("tolerance"),
      "Parameters whose polyline is within the tolerance of the path: a bound. Raises "
      "HodographError:\noutside_domain, tolerance_not_reached.");
  m.def(
      "points_at",
      [](const AnyPath& path, const Doubles& parameters) {
        return filled_like(parameters, {static_cast<py::ssize_t>(path.dimension())},
                           [&](auto from, auto to) { evaluate(path, from, {.positions = to}); });
      },
      py::arg("path"), py::arg("parameters"), "r at every parameter, (..., d), as path.position.");
}

[[noreturn]] void no_derivatives(const char* why, double xi, std::size_t index) {
  throw Error(Fault{FaultCode::zero_speed,
                    std::string(why) + " at xi = " + to_text(xi) + " (index " +
                        std::to_string(index) + "): the curvature has no derivatives there",
                    index, "speed", 0.0, std::nullopt});
}

template <class A>
void write_derivatives(const AnyPath& path, std::span<const double> xi, std::span<double> to) {
  std::vector<PreimageJet<A, 4>> jets(xi.size());
  preimage_jets(path, xi, jets);
  for (std::size_t i = 0; i < xi.size(); ++i) {
    const std::array jet{jets[i][0], jets[i][1], jets[i][2], jets[i][3]};
    if (!(0.0 < speed_form(jet[0], jet[0]))) no_derivatives("the path stands still", xi[i], i);
    std::array<double, 3> kappa{};
    if constexpr (A::dimension == 2) {
      kappa = curvature_derivatives(jet);
    } else {
      const auto found = curvature_derivatives(jet);
      if (!found) no_derivatives("the curvature is zero", xi[i], i);
      kappa = *found;
    }
    for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] = kappa[j];
  }
}

void bind_lift(py::module_& m) {
  m.def(
      "lifted",
      [](const AnyPath& path, double altitude, const std::variant<double, Doubles>& slope) {
        std::vector<double> slopes(path.segment_count());
        if (const double* one = std::get_if<double>(&slope)) {
          slopes.assign(slopes.size(), *one);
        } else {
          const Doubles& all = std::get<Doubles>(slope);
          if (all.ndim() != 1) refuse_shape("slope", "one number, or one a segment", all);
          slopes.assign(numbers(all).begin(), numbers(all).end());
        }
        return lifted(path, altitude, slopes).value();
      },
      py::arg("path"), py::arg("altitude"), py::arg("slope"),
      "The path above a planar one that climbs from an altitude with a slope, the tangent of the "
      "climb angle:\none number, or one a segment. Raises HodographError: mismatched_size, "
      "not_finite, unsupported.");
  Record<HelicalPlan>(m, "HelicalDecomposition", "A helical curve as the lifting of a planar one.")
      .field("axis", &HelicalPlan::axis)
      .field("sine", &HelicalPlan::sine, "Of the climb angle.")
      .field("cosine", &HelicalPlan::cosine)
      .field("upright", &HelicalPlan::upright, "The unit quaternion that turns the axis upright.")
      .field("plan", &HelicalPlan::plan, "Bernstein coefficients of the plan's preimage, (n, 2).")
      .field("roll", &HelicalPlan::roll, "Against the level frame, radians.")
      .field("residual", &HelicalPlan::residual);
  m.def(
      "helical_decomposition",
      [](const AnyPath& path, std::size_t segment, const Doubles& axis) {
        return helical_decomposition(path, segment, point_of<Vector3<double>>(axis, "axis"))
            .value();
      },
      py::arg("path"), py::arg("segment"), py::arg("axis"),
      "The plan below a segment that is helical about an axis (3,). Raises HodographError: "
      "unsupported (it is\nnot), outside_domain.");
}

}  // namespace

void bind_sampling(py::module_& m) {
  bind_parameters(m);
  m.def(
      "curvature_derivatives",
      [](const AnyPath& path, const Doubles& xi) {
        return filled_like(xi, {3}, [&](auto from, auto to) {
          if (path.dimension() == 2) return write_derivatives<Complex<double>>(path, from, to);
          write_derivatives<Quaternion<double>>(path, from, to);
        });
      },
      py::arg("path"), py::arg("xi"),
      "kappa, kappa', kappa'' with respect to xi, (..., 3): signed in the plane. Raises "
      "HodographError:\noutside_domain, zero_speed.");
  bind_lift(m);
}

}  // namespace hodograph::python
