// SPDX-License-Identifier: MIT
// Rational PH curves as values, and in floating point: rational/rational_ph_curve.hpp,
// conversion.hpp, motion_polynomial.hpp.
#include "hodograph/rational/rational_ph_curve.hpp"

#include <string>
#include <vector>

#include "hodograph/rational/conversion.hpp"
#include "python/src/rational/exact.hpp"

namespace hodograph::python {

namespace {

using Curve = RationalPhCurve;

void bind_motions(py::module_& m) {
  using D = DualQuaternionPolynomial;
  Record<D> c(m, "DualQuaternionPolynomial",
              "P + eps D, quaternion polynomials: a rational motion where the Study condition "
              "holds.");
  c.def(py::init([](const QuaternionArgument& primal, const QuaternionArgument& dual) {
          return D{primal.value, dual.value};
        }),
        py::arg("primal"), py::arg("dual"));
  c.field("primal", &D::primal).field("dual", &D::dual);
  c.def(
       "__mul__", [](const D& a, const D& b) { return a * b; }, py::arg("b"))
      .def(
          "__add__", [](const D& a, const D& b) { return a + b; }, py::arg("b"))
      .def(
          "__sub__", [](const D& a, const D& b) { return a - b; }, py::arg("b"))
      .def("conjugate", [](const D& a) { return conjugate(a); })
      .def("content", [](const D& a) { return content(a); })
      .def("satisfies_study_condition", [](const D& a) { return satisfies_study_condition(a); })
      .def("is_motion_polynomial", [](const D& a) { return is_motion_polynomial(a); });
  const auto require_motion = [](const D& motion) {
    if (is_motion_polynomial(motion)) return;
    throw Error(Fault{FaultCode::outside_domain,
                      "this is no motion: P should not be 0, and P D* + D P* should be",
                      std::nullopt, "c", std::nullopt, std::nullopt});
  };
  m.def(
      "trajectory",
      [require_motion](const D& motion, const RationalVector& x) {
        require_motion(motion);
        return trajectory(motion, x);
      },
      py::arg("c"), py::arg("x"), "The trajectory of the point x under a motion polynomial.");
  m.def(
      "framing_motion",
      [](const QuaternionArgument& a, const PolynomialArgument& alpha, const VectorArgument& b) {
        return framing_motion(a.value, alpha.value, b.value);
      },
      py::arg("a"), py::arg("alpha"), py::arg("b"), "The motion (alpha + eps B) A.");
  m.def(
      "is_framing",
      [require_motion](const D& motion) {
        require_motion(motion);
        return is_framing(motion);
      },
      py::arg("c"), "True when P i P* is tangent to the trajectory of the origin everywhere.");
}

void bind_parts(py::module_& m) {
  Record<Curve::Piece>(m, "RationalCurvePiece", "A part of a curve with one pole.")
      .field("pole", &Curve::Piece::pole)
      .field("lambda_", &Curve::Piece::lambda)
      .field("curve", &Curve::Piece::curve);
  Record<Curve::Decomposition>(m, "RationalCurveDecomposition",
                               "r = sum of pieces + integral of polynomial_lambda F + constant.")
      .field("polynomial_lambda", &Curve::Decomposition::polynomial_lambda)
      .field("pieces", &Curve::Decomposition::pieces)
      .field("constant", &Curve::Decomposition::constant);
  Record<Curve::Frame>(m, "RationalFrame", "|A|^2 times the axes of the frame of A.")
      .field("e1", &Curve::Frame::e1)
      .field("e2", &Curve::Frame::e2)
      .field("e3", &Curve::Frame::e3);
}

std::string text_of(const Curve& curve) {
  std::string text = to_text(curve.position());
  constexpr std::size_t most = 80;
  if (text.size() > most) text = text.substr(0, most) + "...";
  return "<hodograph.RationalPhCurve: " + text + ">";
}

Doubles positions_of(const Curve& curve, const Doubles& t) {
  return filled_like(t, {3}, [&](auto from, auto to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const auto point = position(curve, from[i]);
      if (!point) {
        Fault fault = point.fault();
        fault.index = i;
        throw Error(fault);
      }
      for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] = (*point)[j];
    }
  });
}

void bind_curve(py::module_& m) {
  py::class_<Curve>(m, "RationalPhCurve",
                    "A rational PH curve r with r' = lambda F, F = A i A*, exactly. A value.")
      .def(py::init([](const QuaternionArgument& a, const VectorFunctionArgument& r) {
             return unlocked([&] { return Curve::create(a.value, r.value).value(); });
           }),
           py::arg("a"), py::arg("r"),
           "The curve r, which A frames. Raises HodographError: outside_domain.")
      .def_static(
          "of_solution",
          [](const QuaternionArgument& a, const PolynomialArgument& alpha,
             const VectorArgument& b) {
            return unlocked([&] { return Curve::create(a.value, alpha.value, b.value).value(); });
          },
          py::arg("a"), py::arg("alpha"), py::arg("b"), "r = -2 B / alpha.")
      .def_static(
          "from_osculating_planes",
          [](const QuaternionArgument& a, const FunctionArgument& f) {
            return unlocked(
                [&] { return Curve::from_osculating_planes(a.value, f.value).value(); });
          },
          py::arg("a"), py::arg("f"), "The curve whose osculating planes are (F x F') . x = f.")
      .def_property_readonly("preimage", &Curve::preimage)
      .def_property_readonly("indicatrix", &Curve::indicatrix)
      .def_property_readonly("position", &Curve::position, "r, exactly.")
      .def_property_readonly("lambda_", &Curve::lambda, "lambda.")
      .def_property_readonly("speed", &Curve::speed, "sigma, with the sign of lambda.")
      .def_property_readonly("kind", &Curve::kind)
      .def("__call__", &positions_of, py::arg("t"),
           "The points r(t) at numbers or arrays, (..., 3): exact values, rounded once.\nRaises "
           "HodographError: not_finite, outside_domain (a pole).")
      .def("arc_length", &Curve::arc_length, "The integral of the speed.")
      .def("arc_length_is_rational", &Curve::arc_length_is_rational)
      .def("motion", &Curve::motion, "The framing motion.")
      .def("osculating_planes", &Curve::osculating_planes, "f of the planes (F x F') . x = f.")
      .def("poles", &Curve::poles, "The real poles.")
      .def("stationary_points", &Curve::stationary_points, "The real zeros of lambda.")
      .def("inflections", &Curve::inflections, "The real zeros of F x F'.")
      .def("torsion_zeros", &Curve::torsion_zeros, "The real zeros of det(F, F', F'').")
      .def("is_planar", &Curve::is_planar)
      .def("frame", &Curve::frame, "|A|^2 times the axes.")
      .def("angular_velocity", &Curve::angular_velocity,
           "|A|^2 times the angular velocity with respect to t, in the frame.")
      .def("frame_is_rotation_minimising", &Curve::frame_is_rotation_minimising)
      .def("decomposition", &Curve::decomposition, "By poles.")
      .def(
          "rational_bezier",
          [](const Curve& curve, double begin, double end) {
            return unlocked([&] { return rational_bezier(curve, begin, end).value(); });
          },
          py::arg("begin"), py::arg("end"),
          "The curve over [begin, end] as rational Bezier curves with positive weights.\nRaises "
          "HodographError: not_finite, not_increasing, outside_domain (a pole), unsupported.")
      .def(
          "path",
          [](const Curve& curve, double begin, double end) {
            return unlocked(
                [&] { return AnyPath::create(path_numbers(curve, begin, end).value()).value(); });
          },
          py::arg("begin"), py::arg("end"),
          "A polynomial curve over [begin, end] as a Path of one segment with xi = t.\nRaises "
          "HodographError: outside_domain (poles; a cusp), unsupported, no_convergence.")
      .def(
          "__eq__",
          [](const Curve& a, const Curve& b) {
            return a.position() == b.position() && a.preimage() == b.preimage();
          },
          py::is_operator())
      .def("__repr__", &text_of)
      .def(py::pickle(
          [](const Curve& curve) { return py::make_tuple(curve.preimage(), curve.position()); },
          [](const py::tuple& t) {
            return Curve::create(t[0].cast<QuaternionPolynomial>(), t[1].cast<VectorFunction>())
                .value();
          }))
      .attr("__hash__") = py::none();
}

}  // namespace

void bind_curves(py::module_& m) {
  bind_motions(m);
  bind_parts(m);
  bind_curve(m);
}

}  // namespace hodograph::python
