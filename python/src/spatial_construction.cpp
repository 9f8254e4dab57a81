// SPDX-License-Identifier: MIT
// Paths in space from data: construction/hermite.hpp.
#include <array>
#include <string>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

/// An array of shape (points, m + 1, 3) as Hermite data.
template <std::size_t m>
std::vector<HermitePoint<m>> hermite_points(const Doubles& data) {
  std::vector<HermitePoint<m>> points(static_cast<std::size_t>(data.shape(0)));
  const double* from = data.data();
  for (auto& point : points) {
    for (auto& derivative : point) {
      for (std::size_t i = 0; i < 3; ++i) derivative[i] = *from++;
    }
  }
  return points;
}

template <std::size_t m>
AnyPath path_through(const std::vector<double>& knots, const Doubles& data, HermiteChoice choice,
                     bool closed) {
  const auto points = hermite_points<m>(data);
  return unlocked([&]() -> AnyPath {
    return hermite_path<m, double>(knots, std::span<const HermitePoint<m>>(points), choice, closed)
        .value();
  });
}

AnyPath hermite(const std::vector<double>& knots, const Doubles& points, HermiteChoice choice,
                bool closed) {
  if (points.ndim() == 3 && points.shape(2) == 3) {
    switch (points.shape(1)) {
      case 2:
        return path_through<1>(knots, points, choice, closed);
      case 3:
        return path_through<2>(knots, points, choice, closed);
      case 5:
        return path_through<4>(knots, points, choice, closed);
      default:
        break;
    }
  }
  refuse_shape("points", "(n, 2, 3), (n, 3, 3) or (n, 5, 3): position and 1, 2 or 4 derivatives",
               points);
}

}  // namespace

void bind_spatial_construction(py::module_& m) {
  py::enum_<HermiteChoice>(m, "HermiteChoice", "The free parameters of Hermite interpolation.")
      .value("order_ten", HermiteChoice::order_ten,
             "Rotation-minimising end frames, no mean twist: error of order ten for C4 data.")
      .value("order_six", HermiteChoice::order_six, "The choice of PHODCOS, Algorithm 1.");
  m.def("hermite_path", &hermite, py::arg("knots"), py::arg("points"), py::kw_only(),
        py::arg("choice") = HermiteChoice::order_ten, py::arg("closed") = false,
        "The spatial path that meets position and derivatives with respect to xi at every knot.\n"
        "points: (n, m + 1, 3) with m = 1, 2 or 4 derivatives; the path is C^m, of degree 4m + 1.");
}

}  // namespace hodograph::python
