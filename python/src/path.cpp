// SPDX-License-Identifier: MIT
// The class Path and what is asked of it at many parameters in one call.
#include <string>

#include "hodograph/frame/any_batch.hpp"
#include "hodograph/path/any_path.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

py::ssize_t size(std::size_t n) { return static_cast<py::ssize_t>(n); }

std::vector<double> copied(const Doubles& array) {
  const auto all = numbers(array);
  return {all.begin(), all.end()};
}

AnyPath path_of(const Doubles& knots, const Doubles& starts, const Doubles& preimages,
                bool closed) {
  if (knots.ndim() != 1) refuse_shape("knots", "(segments + 1,)", knots);
  if (starts.ndim() != 2) refuse_shape("starts", "(segments, 2) or (segments, 3)", starts);
  PathNumbers numbers;
  numbers.dimension = static_cast<std::size_t>(starts.shape(1));
  if (preimages.ndim() != 3 || preimages.shape(1) < 1 ||
      preimages.shape(2) != size(numbers.components_per_coefficient())) {
    refuse_shape(
        "preimages",
        "(segments, degree + 1, " + std::to_string(numbers.components_per_coefficient()) + ")",
        preimages);
  }
  numbers.preimage_degree = static_cast<std::size_t>(preimages.shape(1) - 1);
  numbers.closed = closed;
  numbers.knots = copied(knots);
  numbers.starts = copied(starts);
  numbers.preimages = copied(preimages);
  return AnyPath::create(numbers).value();
}

Doubles starts_of(const AnyPath& path) {
  const PathNumbers all = path.numbers();
  Doubles result(Shape{size(path.segment_count()), size(all.dimension)});
  std::copy(all.starts.begin(), all.starts.end(), result.mutable_data());
  return result;
}

Doubles preimages_of(const AnyPath& path) {
  const PathNumbers all = path.numbers();
  Doubles result(Shape{size(path.segment_count()), size(all.preimage_degree + 1),
                       size(all.components_per_coefficient())});
  std::copy(all.preimages.begin(), all.preimages.end(), result.mutable_data());
  return result;
}

std::string text_of(const AnyPath& path) {
  const std::size_t count = path.segment_count();
  return std::string("<hodograph.Path: ") + (path.dimension() == 2 ? "planar" : "spatial") +
         ", degree " + std::to_string(path.degree()) + ", " + std::to_string(count) +
         (count == 1 ? " segment" : " segments") + ", xi from " + to_text(path.xi_begin()) +
         " to " + to_text(path.xi_end()) + ", length " + to_text(path.arc_length()) +
         (path.is_closed() ? ", closed>" : ">");
}

Shape of_dimension(const AnyPath& path) { return {size(path.dimension())}; }

FloatOrArray arc_length(const AnyPath& path, const std::optional<Doubles>& xi) {
  if (!xi) return path.arc_length();
  return numbers_like(*xi, [&](auto from, auto to) { evaluate(path, from, {.arc_lengths = to}); });
}

/// Frames as matrices whose columns are the axes.
Strided matrices(const Doubles& axes) { return axes.attr("swapaxes")(-1, -2); }

py::tuple state(const AnyPath& path, const Doubles& xi) {
  const auto d = size(path.dimension());
  const Shape one = shape_of(xi);
  const auto with = [&](Shape tail) {
    Shape shape = one;
    shape.insert(shape.end(), tail.begin(), tail.end());
    return Doubles(shape);
  };
  Doubles positions = with({d}), frames = with({d, d}), rates = with(d == 3 ? Shape{3} : Shape{}),
          speeds = with({}), lengths = with({});
  const auto all = [](Doubles& array) {
    return std::span<double>(array.mutable_data(), static_cast<std::size_t>(array.size()));
  };
  const AnyPathStateSpans out{all(positions), all(frames), all(rates), all(speeds), all(lengths)};
  const auto from = numbers(xi);
  unlocked([&] { evaluate(path, from, out); });
  const auto plain = [](const Doubles& array) -> py::object {
    if (array.ndim() == 0) return py::float_(*array.data());
    return array;
  };
  return py::make_tuple(positions, matrices(frames), plain(rates), plain(speeds), plain(lengths));
}

}  // namespace

void bind_path(py::module_& m) {
  py::class_<AnyPath>(m, "Path",
                      "A planar or spatial Pythagorean-hodograph path: PH curves on increasing "
                      "knots.\n\nA value: it never changes; constructions and operations return "
                      "new paths. Parameters may be\nnumbers or arrays of any shape; results have "
                      "that shape, followed by the shape of one result.")
      .def(py::init(&path_of), py::arg("knots"), py::arg("starts"), py::arg("preimages"),
           py::kw_only(), py::arg("closed") = false,
           "The path that the numbers define: knots (N + 1,), starts (N, d), Bernstein "
           "coefficients of\nthe preimage (N, n + 1, 2) in the plane (re, im) or (N, n + 1, 4) in "
           "space (w, x, y, z).\nRaises HodographError.")
      .def_property_readonly("dimension", &AnyPath::dimension, "2 or 3.")
      .def_property_readonly("preimage_degree", &AnyPath::preimage_degree)
      .def_property_readonly("degree", &AnyPath::degree, "2 preimage_degree + 1.")
      .def_property_readonly("segment_count", &AnyPath::segment_count)
      .def_property_readonly("is_closed", &AnyPath::is_closed)
      .def_property_readonly("xi_begin", &AnyPath::xi_begin)
      .def_property_readonly("xi_end", &AnyPath::xi_end)
      .def_property_readonly(
          "knots",
          [](const py::object& self) {
            const auto& knots = self.cast<const AnyPath&>().knots();
            return view_of(knots.data(), {size(knots.size())}, self);
          },
          "The knots, increasing, (N + 1,). A view.")
      .def_property_readonly(
          "knot_arc_lengths",
          [](const py::object& self) {
            const auto& lengths = self.cast<const AnyPath&>().knot_arc_lengths();
            return view_of(lengths.data(), {size(lengths.size())}, self);
          },
          "The arc length from the start to every knot, (N + 1,). A view.")
      .def_property_readonly("starts", &starts_of, "Where every segment starts, (N, d). A copy.")
      .def_property_readonly("preimages", &preimages_of,
                             "The preimage's coefficients, (N, n + 1, 2 or 4). A copy.")
      .def(
          "position",
          [](const AnyPath& path, const Doubles& xi) {
            return filled_like(xi, of_dimension(path), [&](auto from, auto to) {
              evaluate(path, from, {.positions = to});
            });
          },
          py::arg("xi"), "r(xi), shape (..., d).")
      .def(
          "speed",
          [](const AnyPath& path, const Doubles& xi) {
            return numbers_like(xi,
                                [&](auto from, auto to) { evaluate(path, from, {.speeds = to}); });
          },
          py::arg("xi"), "sigma(xi) = |dr/dxi|.")
      .def("arc_length", &arc_length, py::arg("xi") = py::none(),
           "The arc length from the start to xi; of the whole path without xi. Exact polynomials.")
      .def(
          "parameter_at_arc_length",
          [](const AnyPath& path, const Doubles& s) {
            return numbers_like(
                s, [&](auto from, auto to) { parameters_at_arc_lengths(path, from, to); });
          },
          py::arg("s"), "The xi at which the path has come the arc length s, to rounding.")
      .def(
          "point_at_arc_length",
          [](const AnyPath& path, const Doubles& s) {
            return filled_like(s, of_dimension(path),
                               [&](auto from, auto to) { points_at_arc_lengths(path, from, to); });
          },
          py::arg("s"), "The point at arc length s, shape (..., d).")
      .def("_state", &state, py::arg("xi"))
      .def(
          "__eq__", [](const AnyPath& a, const AnyPath& b) { return a == b; }, py::is_operator())
      .def("__repr__", &text_of)
      .def("__copy__", [](const AnyPath& path) { return path; })
      .def("__deepcopy__", [](const AnyPath& path, const py::dict&) { return path; })
      .def(py::pickle(
          [](const AnyPath& path) {
            return py::make_tuple(Doubles(size(path.knots().size()), path.knots().data()),
                                  starts_of(path), preimages_of(path), path.is_closed());
          },
          [](const py::tuple& t) {
            return path_of(t[0].cast<Doubles>(), t[1].cast<Doubles>(), t[2].cast<Doubles>(),
                           t[3].cast<bool>());
          }))
      .attr("__hash__") = py::none();
}

}  // namespace hodograph::python
