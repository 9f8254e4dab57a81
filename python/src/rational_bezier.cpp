// SPDX-License-Identifier: MIT
// Rational Bezier curves and patches: bernstein/rational_curve.hpp, surface/rational_bezier.hpp.
#include "hodograph/surface/rational_bezier.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/bernstein/rational_curve.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

py::ssize_t size(std::size_t n) { return static_cast<py::ssize_t>(n); }

void require_unit(double u, std::size_t index, const char* name) {
  if (u >= 0.0 && u <= 1.0) return;
  throw Error(Fault{FaultCode::outside_domain,
                    std::string("the local parameter ") + name + " is " + to_text(u) +
                        "; it should lie between 0 and 1",
                    index, name, u, u < 0.0 ? 0.0 : 1.0});
}

/// Throws Error where control points and weights do not make a curve or patch.
void require_weights(std::span<const double> weights, std::size_t points) {
  if (points == 0 || weights.size() != points) {
    throw Error(Fault{
        points == 0 ? FaultCode::too_few : FaultCode::mismatched_size,
        "there should be a weight for each of at least one control point; got " +
            std::to_string(weights.size()) + " weights for " + std::to_string(points) + " points",
        std::nullopt, "weights", static_cast<double>(weights.size()), static_cast<double>(points)});
  }
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] > 0.0 && std::isfinite(weights[i])) continue;
    throw Error(Fault{FaultCode::outside_domain,
                      "weight " + std::to_string(i) + " is " + to_text(weights[i]) +
                          "; weights are positive, finite numbers",
                      i, "weights", weights[i], 0.0});
  }
}

template <class Point>
void bind_curve(py::module_& m, const char* name, const char* doc) {
  using Curve = RationalBezierCurve<Point>;
  py::class_<Curve>(m, name, doc)
      .def(py::init([](const Doubles& points, const Doubles& weights, double begin, double end) {
             Curve curve;
             curve.control_points = points_of<Point>(points, "control_points");
             require_weights(numbers(weights), curve.control_points.size());
             if (!(begin < end) || !std::isfinite(begin) || !std::isfinite(end)) {
               throw Error(Fault{FaultCode::not_increasing,
                                 "a curve runs from begin to a larger end; got " + to_text(begin) +
                                     " and " + to_text(end),
                                 std::nullopt, "end", end, begin});
             }
             curve.weights.assign(numbers(weights).begin(), numbers(weights).end());
             curve.begin = begin;
             curve.end = end;
             return curve;
           }),
           py::arg("control_points"), py::arg("weights"), py::arg("begin") = 0.0,
           py::arg("end") = 1.0)
      .def_readonly("begin", &Curve::begin)
      .def_readonly("end", &Curve::end)
      .def_property_readonly("degree", &Curve::degree)
      .def_property_readonly(
          "control_points", [](const Curve& curve) { return array_of(curve.control_points); },
          "(degree + 1, d).")
      .def_property_readonly(
          "weights", [](const Curve& curve) { return array_of(curve.weights); },
          "(degree + 1,), positive.")
      .def(
          "position",
          [](const Curve& curve, const Doubles& u) {
            constexpr std::size_t d = Point::dimension;
            return filled_like(u, {size(d)}, [&](auto from, auto to) {
              const auto top = curve.weighted();
              const auto bottom = curve.weight();
              for (std::size_t i = 0; i < from.size(); ++i) {
                require_unit(from[i], i, "u");
                const Point point = (1.0 / bottom.value(from[i])) * top.value(from[i]);
                for (std::size_t j = 0; j < d; ++j) to[i * d + j] = point[j];
              }
            });
          },
          py::arg("u"), "The point at u in [0, 1], where the parameter is begin + u (end - begin).")
      .def(
          "__eq__", [](const Curve& a, const Curve& b) { return a == b; }, py::is_operator())
      .def("__repr__",
           [name](const Curve& curve) {
             return std::string("<hodograph.") + name + ": degree " +
                    std::to_string(curve.degree()) + ", from " + to_text(curve.begin) + " to " +
                    to_text(curve.end) + ">";
           })
      .def(py::pickle(
          [](const Curve& curve) {
            return py::make_tuple(array_of(curve.control_points), array_of(curve.weights),
                                  curve.begin, curve.end);
          },
          [](const py::tuple& t) {
            require_members(t, 4);
            Curve curve;
            curve.control_points = points_of<Point>(t[0].cast<Doubles>(), "control_points");
            curve.weights = t[1].cast<std::vector<double>>();
            curve.begin = t[2].cast<double>();
            curve.end = t[3].cast<double>();
            return curve;
          }))
      .attr("__hash__") = py::none();
}

/// One vector at every pair of parameters.
template <class Value>
Doubles on_patch(const Doubles& v, const Doubles& u, const Value& value) {
  const auto both = py::module_::import("numpy").attr("broadcast_arrays")(v, u);
  const Doubles at_v(both.attr("__getitem__")(0)), at_u(both.attr("__getitem__")(1));
  const auto us = numbers(at_u);
  return filled_like(at_v, {3}, [&](auto vs, auto to) {
    for (std::size_t i = 0; i < vs.size(); ++i) {
      require_unit(vs[i], i, "v");
      require_unit(us[i], i, "u");
      const Vector3<double> result = value(vs[i], us[i]);
      for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] = result[j];
    }
  });
}

void require_part(double a, double b) {
  if (a >= 0.0 && a < b && b <= 1.0) return;
  throw Error(Fault{FaultCode::outside_domain,
                    "a part of a patch runs from a to a larger b within [0, 1]; got " + to_text(a) +
                        " and " + to_text(b),
                    std::nullopt, "a", a, b});
}

Doubles grid_of(const RationalPatch& patch, const std::vector<Vector3<double>>& points) {
  Doubles result(Shape{size(patch.degree_v + 1), size(patch.degree_u + 1), 3});
  double* to = result.mutable_data();
  for (const auto& point : points) {
    for (std::size_t i = 0; i < 3; ++i) *to++ = point[i];
  }
  return result;
}

void bind_patch(py::module_& m) {
  using Patch = RationalPatch;
  py::class_<Patch>(m, "RationalPatch",
                    "A rational tensor-product Bezier patch: v along the motion, u along the "
                    "profile, both local\nparameters in [0, 1].")
      .def_readonly("degree_v", &Patch::degree_v)
      .def_readonly("degree_u", &Patch::degree_u)
      .def_readonly("begin_v", &Patch::begin_v)
      .def_readonly("end_v", &Patch::end_v)
      .def_readonly("begin_u", &Patch::begin_u)
      .def_readonly("end_u", &Patch::end_u)
      .def_property_readonly(
          "control_points",
          [](const Patch& patch) { return grid_of(patch, patch.control_points()); },
          "(degree_v + 1, degree_u + 1, 3).")
      .def_property_readonly(
          "weighted", [](const Patch& patch) { return grid_of(patch, patch.weighted); },
          "Control points times weights, (degree_v + 1, degree_u + 1, 3).")
      .def_property_readonly(
          "weights",
          [](const Patch& patch) {
            return Doubles(Shape{size(patch.degree_v + 1), size(patch.degree_u + 1)},
                           patch.weights.data());
          },
          "(degree_v + 1, degree_u + 1), positive on sweeps.")
      .def(
          "position",
          [](const Patch& patch, const Doubles& v, const Doubles& u) {
            return on_patch(v, u, [&](double a, double b) { return patch.position(a, b); });
          },
          py::arg("v"), py::arg("u"), "The points at v and u, which are broadcast, (..., 3).")
      .def(
          "normal",
          [](const Patch& patch, const Doubles& v, const Doubles& u) {
            return on_patch(v, u, [&](double a, double b) { return patch.normal(a, b); });
          },
          py::arg("v"), py::arg("u"),
          "The unit normals, outwards on a sweep of a closed profile; zero where there is none.")
      .def(
          "derivatives",
          [](const Patch& patch, const Doubles& v, const Doubles& u) {
            return std::pair(
                on_patch(v, u, [&](double a, double b) { return patch.derivatives(a, b).along_v; }),
                on_patch(v, u,
                         [&](double a, double b) { return patch.derivatives(a, b).along_u; }));
          },
          py::arg("v"), py::arg("u"), "The first derivatives along v and along u, (..., 3) each.")
      .def(
          "restricted_v",
          [](const Patch& patch, double a, double b) {
            require_part(a, b);
            return patch.restricted_v(a, b);
          },
          py::arg("a"), py::arg("b"), "The part on [a, b] of v, all of u.")
      .def(
          "restricted_u",
          [](const Patch& patch, double a, double b) {
            require_part(a, b);
            return patch.restricted_u(a, b);
          },
          py::arg("a"), py::arg("b"), "The part on [a, b] of u, all of v.")
      .def(
          "__eq__", [](const Patch& a, const Patch& b) { return a == b; }, py::is_operator())
      .def(py::pickle(
          [](const Patch& p) {
            return py::make_tuple(p.degree_v, p.degree_u, p.begin_v, p.end_v, p.begin_u, p.end_u,
                                  array_of(p.weighted), array_of(p.weights));
          },
          [](const py::tuple& t) {
            require_members(t, 8);
            return Patch{t[0].cast<std::size_t>(),
                         t[1].cast<std::size_t>(),
                         t[2].cast<double>(),
                         t[3].cast<double>(),
                         t[4].cast<double>(),
                         t[5].cast<double>(),
                         points_of<Vector3<double>>(t[6].cast<Doubles>(), "weighted"),
                         numbers_of(t[7].cast<Doubles>(), "weights")};
          }))
      .def("__repr__",
           [](const Patch& patch) {
             return "<hodograph.RationalPatch: degrees " + std::to_string(patch.degree_v) +
                    " and " + std::to_string(patch.degree_u) + ">";
           })
      .attr("__hash__") = py::none();
}

}  // namespace

void bind_rational_bezier(py::module_& m) {
  bind_curve<Vector2<double>>(m, "RationalBezier", "A rational Bezier curve in the plane.");
  bind_curve<Vector3<double>>(m, "SpatialRationalBezier", "A rational Bezier curve in space.");
  bind_patch(m);
}

}  // namespace hodograph::python
