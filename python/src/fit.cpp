// SPDX-License-Identifier: MIT
// fit(): a path within a tolerance of a curve that Python gives: a callable with derivatives, or
// samples. construction/fit.hpp, construction/fit_spline.hpp.
#include "hodograph/construction/fit.hpp"

#include <string>
#include <vector>

#include "hodograph/construction/fit_spline.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

py::dict result_of(const Fit& made) {
  std::vector<double> upper;
  upper.reserve(made.segment_errors.size());
  for (const ErrorBound& error : made.segment_errors) upper.push_back(error.error.upper());
  using namespace py::literals;
  return py::dict(
      "path"_a = AnyPath(made.path), "error"_a = made.error.error,
      "certified"_a = made.error.certified, "at_xi"_a = made.error.at_xi,
      "segment_errors"_a = Doubles(static_cast<py::ssize_t>(upper.size()), upper.data()));
}

FitOptions options_of(double tolerance, HermiteChoice choice, FitKnots knots, std::size_t segments,
                      std::size_t most_segments, bool closed) {
  FitOptions options;
  options.tolerance = tolerance;
  options.choice = choice;
  options.knots = knots;
  options.segments = segments;
  options.most_segments = most_segments;
  options.closed = closed;
  return options;
}

py::dict fit_function(const py::function& gamma, double begin, double end, double tolerance,
                      HermiteChoice choice, FitKnots knots, std::size_t segments,
                      std::size_t most_segments, bool closed) {
  FitOptions options = options_of(tolerance, choice, knots, segments, most_segments, closed);
  options.progress = [](std::size_t, double) {  // Ctrl-C ends the fit
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
    return true;
  };
  const DerivativeCurve curve = [&gamma](double xi) {
    const auto value = gamma(xi).cast<Doubles>();
    if (value.ndim() != 2 || value.shape(0) != 5 || value.shape(1) != 3) {
      refuse_shape("the curve's value: position and four derivatives", "(5, 3)", value);
    }
    HermitePoint<4> point;
    for (std::size_t r = 0; r < 5; ++r) {
      for (std::size_t i = 0; i < 3; ++i) point[r][i] = value.data()[3 * r + i];
    }
    return point;
  };
  return result_of(fit(curve, begin, end, options).value());
}

py::dict fit_samples(const Doubles& parameters, const Doubles& samples, bool periodic,
                     double tolerance, HermiteChoice choice, FitKnots knots, std::size_t segments,
                     std::size_t most_segments) {
  FitOptions options = options_of(tolerance, choice, knots, segments, most_segments, periodic);
  options.progress = [](std::size_t, double) { return !interruption_wanted(); };
  const auto points = points_of<Vector3<double>>(samples, "samples");
  if (parameters.ndim() != 1) refuse_shape("parameters", "(n,)", parameters);
  const auto at = numbers(parameters);
  const Fit made = unlocked([&] {
    const auto spline = InterpolatingSpline<5>::through(
                            at, points, periodic ? SplineEnds::periodic : SplineEnds::not_a_knot)
                            .value();
    return fit(spline, options).value();
  });
  return result_of(made);
}

}  // namespace

void bind_fit(py::module_& m) {
  py::enum_<FitKnots>(m, "FitKnots", "Where a fit puts its knots.")
      .value("adaptive", FitKnots::adaptive, "By halving intervals whose error is too large.")
      .value("uniform", FitKnots::uniform, "Equal intervals, the fewest that do.");
  const std::size_t most = FitOptions{}.most_segments;
  m.def("_fit_function", &fit_function, py::arg("gamma"), py::arg("begin"), py::arg("end"),
        py::arg("tolerance"), py::arg("choice") = HermiteChoice::order_ten,
        py::arg("knots") = FitKnots::adaptive, py::arg("segments") = std::size_t{0},
        py::arg("most_segments") = most, py::arg("closed") = false);
  m.def("_fit_samples", &fit_samples, py::arg("parameters"), py::arg("samples"),
        py::arg("periodic"), py::arg("tolerance"), py::arg("choice") = HermiteChoice::order_ten,
        py::arg("knots") = FitKnots::adaptive, py::arg("segments") = std::size_t{0},
        py::arg("most_segments") = most);
}

}  // namespace hodograph::python
