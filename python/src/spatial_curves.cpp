// SPDX-License-Identifier: MIT
// Single Hermite curves in space, splines through samples and their error, many prescribed lengths
// at once: construction/hermite.hpp, interpolating_spline.hpp, fit_spline.hpp,
// prescribed_length.hpp.
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "hodograph/construction/fit_spline.hpp"
#include "hodograph/construction/hermite.hpp"
#include "hodograph/construction/prescribed_length.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/curves.hpp"
#include "python/src/made.hpp"

namespace pybind11::detail {

template <>
struct type_caster<hodograph::InterpolatingSpline<5>>
    : hodograph_made_caster<hodograph::InterpolatingSpline<5>> {};

}  // namespace pybind11::detail

namespace hodograph::python {

namespace {

py::ssize_t size(std::size_t n) { return static_cast<py::ssize_t>(n); }

template <std::size_t m>
HermitePoint<m> hermite_point(const Doubles& data) {
  HermitePoint<m> point;
  for (std::size_t r = 0; r <= m; ++r) {
    for (std::size_t i = 0; i < 3; ++i) point[r][i] = data.data()[3 * r + i];
  }
  return point;
}

/// Up to m - 1 numbers, the others 0.
template <std::size_t m>
void read_tau(const std::optional<Doubles>& from, std::array<double, (m > 1 ? m - 1 : 1)>& to,
              const char* name) {
  if (!from) return;
  const std::size_t count = m - 1;
  if (from->ndim() != 1 || static_cast<std::size_t>(from->size()) != count) {
    refuse_shape(name, "(" + std::to_string(count) + ",)", *from);
  }
  for (std::size_t i = 0; i < count; ++i) to[i] = from->data()[i];
}

struct FreeParameters {
  double theta_begin, theta_middle, theta_end;
  const std::optional<Doubles>& tau_begin;
  const std::optional<Doubles>& tau_end;

  bool are_given() const {
    return theta_begin != 0.0 || theta_middle != 0.0 || theta_end != 0.0 || tau_begin || tau_end;
  }
};

template <std::size_t m>
AnyPath curve_between(const Doubles& begin, const Doubles& end, double h, HermiteChoice choice,
                      const FreeParameters& free) {
  const auto from = hermite_point<m>(begin), to = hermite_point<m>(end);
  if (!free.are_given()) return path_of(hermite_curve<m, double>(from, to, h, choice).value());
  HermiteParameters<m> parameters;
  parameters.theta_begin = free.theta_begin;
  parameters.theta_middle = free.theta_middle;
  parameters.theta_end = free.theta_end;
  read_tau<m>(free.tau_begin, parameters.tau_begin, "tau_begin");
  read_tau<m>(free.tau_end, parameters.tau_end, "tau_end");
  return path_of(hermite_curve<m, double>(from, to, h, parameters).value());
}

AnyPath hermite(const Doubles& begin, const Doubles& end, double h, HermiteChoice choice,
                double theta_begin, double theta_middle, double theta_end,
                const std::optional<Doubles>& tau_begin, const std::optional<Doubles>& tau_end) {
  const FreeParameters free{theta_begin, theta_middle, theta_end, tau_begin, tau_end};
  if (free.are_given() && choice != HermiteChoice::order_six) {
    throw Error(Fault{FaultCode::unsupported,
                      "the free parameters are those of the choice order_six; give it, too",
                      std::nullopt, "choice", std::nullopt, std::nullopt});
  }
  const auto fits = [](const Doubles& data) { return data.ndim() == 2 && data.shape(1) == 3; };
  if (!fits(begin)) refuse_shape("begin", "(2, 3), (3, 3) or (5, 3)", begin);
  if (!fits(end) || end.shape(0) != begin.shape(0)) {
    refuse_shape("end", "(" + std::to_string(begin.shape(0)) + ", 3), as begin", end);
  }
  switch (begin.shape(0)) {
    case 2:
      return curve_between<1>(begin, end, h, choice, free);
    case 3:
      return curve_between<2>(begin, end, h, choice, free);
    case 5:
      return curve_between<4>(begin, end, h, choice, free);
    default:
      refuse_shape("begin", "(2, 3), (3, 3) or (5, 3): a point and 1, 2 or 4 derivatives", begin);
  }
}

using Spline = InterpolatingSpline<5>;

Doubles values_of(const Spline& spline, const Doubles& t) {
  return filled_like(t, {5, 3}, [&](auto from, auto to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      const HermitePoint<4> point = spline(from[i]);
      for (std::size_t r = 0; r < 5; ++r) {
        for (std::size_t j = 0; j < 3; ++j) to[15 * i + 3 * r + j] = point[r][j];
      }
    }
  });
}

ErrorBound error_of(const Spline& spline, const AnyPath& path) {
  const auto* fitted = path.get_if<SpatialPath<8>>();
  if (fitted == nullptr) {
    throw Error(Fault{FaultCode::unsupported,
                      "the error is certified for paths in space of degree 17; this one has " +
                          std::to_string(path.degree()) + " in " +
                          std::to_string(path.dimension()) + " dimensions",
                      std::nullopt, "degree", static_cast<double>(path.degree()), 17.0});
  }
  if (!(spline.begin() <= path.xi_begin() && path.xi_end() <= spline.end())) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the path runs from " + to_text(path.xi_begin()) + " to " +
                          to_text(path.xi_end()) + ", beyond the spline on [" +
                          to_text(spline.begin()) + ", " + to_text(spline.end()) + "]",
                      std::nullopt, "xi", path.xi_begin(), spline.begin()});
  }
  return unlocked([&] {
    const auto& knots = fitted->knots();
    ErrorBound total = spline_error(spline, fitted->segment(0), knots[0], knots[1]);
    for (std::size_t k = 1; k < fitted->segment_count(); ++k) {
      total = larger_error(total, spline_error(spline, fitted->segment(k), knots[k], knots[k + 1]));
    }
    return total;
  });
}

void bind_spline(py::module_& m) {
  py::enum_<SplineEnds>(m, "SplineEnds", "How a spline behaves at its ends.")
      .value("not_a_knot", SplineEnds::not_a_knot)
      .value("periodic", SplineEnds::periodic);
  made_class<Spline>(m, "InterpolatingSpline",
                     "The C4 quintic spline through samples in space: what fit() makes of them.")
      .def(py::init([](const Doubles& parameters, const Doubles& points, SplineEnds ends) {
             if (parameters.ndim() != 1) refuse_shape("parameters", "(n,)", parameters);
             const auto samples = points_of<Vector3<double>>(points, "points");
             const auto at = numbers(parameters);
             auto spline = unlocked([&] { return Spline::through(at, samples, ends).value(); });
             return made(std::move(spline), "", parameters, points, ends);
           }),
           py::arg("parameters"), py::arg("points"), py::arg("ends") = SplineEnds::not_a_knot,
           "Through points (n, 3) at parameters (n,). Raises HodographError: mismatched_size, "
           "too_few, not_finite,\nnot_increasing, not_continuous, no_convergence.")
      .def("__call__", &values_of, py::arg("t"),
           "Position and four derivatives, (..., 5, 3). Raises HodographError: outside_domain.")
      .def_property_readonly("begin", &Spline::begin)
      .def_property_readonly("end", &Spline::end)
      .def_property_readonly("is_periodic", &Spline::is_periodic)
      .def_property_readonly("breakpoints",
                             [](const Spline& spline) { return array_of(spline.breakpoints()); })
      .def("__repr__", [](const Spline& spline) {
        return "<hodograph.InterpolatingSpline: " + std::to_string(spline.pieces().size()) +
               " pieces, from " + to_text(spline.begin()) + " to " + to_text(spline.end()) + ">";
      });
  Record<ErrorBound>(m, "ErrorBound", "How far a path is from a curve.")
      .field("error", &ErrorBound::error, "Contains the largest distance, if certified.")
      .field("certified", &ErrorBound::certified)
      .field("at_xi", &ErrorBound::at_xi, "Where the distance is at least error.lower.");
  m.def(
      "spline_error", &error_of, py::arg("spline"), py::arg("path"),
      "The certified distance of a path in space of degree 17 from a spline, over the whole path. "
      "Raises\nHodographError: unsupported, outside_domain.");
}

/// Many problems: preimages (n, 3, 2), rotation indices and margins (n,).
std::tuple<Doubles, Doubles, Doubles> many_lengths(const Doubles& begins,
                                                   const Doubles& begin_directions,
                                                   const Doubles& ends,
                                                   const Doubles& end_directions,
                                                   const Doubles& lengths, double h) {
  using Point = Vector2<double>;
  const auto from = points_of<Point>(begins, "begins");
  const auto leaving = points_of<Point>(begin_directions, "begin_directions");
  const auto to = points_of<Point>(ends, "ends");
  const auto arriving = points_of<Point>(end_directions, "end_directions");
  const std::size_t count = from.size();
  const std::string wanted = "as many rows as begins: " + std::to_string(count);
  if (leaving.size() != count) refuse_shape("begin_directions", wanted, begin_directions);
  if (to.size() != count) refuse_shape("ends", wanted, ends);
  if (arriving.size() != count) refuse_shape("end_directions", wanted, end_directions);
  if (lengths.ndim() > 1 || (lengths.ndim() == 1 && numbers(lengths).size() != count)) {
    refuse_shape("lengths", "one number, or " + wanted, lengths);
  }
  std::vector<PrescribedLengthProblem> problems(count);
  for (std::size_t i = 0; i < count; ++i) {
    problems[i] = {{from[i], leaving[i]},
                   {to[i], arriving[i]},
                   lengths.data()[lengths.ndim() == 0 ? 0 : i],
                   h};
  }
  std::vector<PlanarHermiteAnswer> answers(count);
  if (const auto fault = unlocked([&] { return prescribed_length_curves(problems, answers); })) {
    throw Error(*fault);
  }
  Doubles preimages(Shape{size(count), 3, 2}), indices(Shape{size(count)}),
      margins(Shape{size(count)});
  double* w = preimages.mutable_data();
  for (std::size_t i = 0; i < count; ++i) {
    for (const auto& c : answers[i].preimage) {
      *w++ = c.re;
      *w++ = c.im;
    }
    indices.mutable_data()[i] = answers[i].rotation_index;
    margins.mutable_data()[i] = answers[i].margin;
  }
  return {preimages, indices, margins};
}

}  // namespace

void bind_spatial_curves(py::module_& m) {
  m.def("hermite_curve", &hermite, py::arg("begin"), py::arg("end"), py::arg("h") = 1.0,
        py::kw_only(), py::arg("choice") = HermiteChoice::order_ten, py::arg("theta_begin") = 0.0,
        py::arg("theta_middle") = 0.0, py::arg("theta_end") = 0.0,
        py::arg("tau_begin") = py::none(), py::arg("tau_end") = py::none(),
        "The curve with a position and m = 1, 2 or 4 derivatives at both ends, (m + 1, 3) each, on "
        "[0, h]. With\nchoice order_six the free parameters of PHODCOS may be given: angles, and "
        "tau (m - 1,). Raises HodographError:\nnot_finite, zero_speed, outside_domain, "
        "no_interpolant.");
  bind_spline(m);
  m.def("prescribed_length_curves", &many_lengths, py::arg("begins"), py::arg("begin_directions"),
        py::arg("ends"), py::arg("end_directions"), py::arg("lengths"), py::arg("h") = 1.0,
        "Many prescribed lengths at once: (n, 2) each, lengths (n,) or one. Preimages (n, 3, 2), "
        "rotation\nindices and margins (n,).");
}

}  // namespace hodograph::python
