// SPDX-License-Identifier: MIT
// Paths from paths: path/any_operations.hpp.
#include "hodograph/path/any_operations.hpp"

#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"

namespace hodograph::python {

namespace {

AnyPath turned(const AnyPath& path, const std::optional<Doubles>& rotation,
               const std::optional<Doubles>& translation) {
  const bool planar = path.dimension() == 2;
  if (planar) {
    if (rotation && rotation->ndim() != 0) refuse_shape("rotation", "()", *rotation);
    const double angle = rotation ? *rotation->data() : 0.0;
    const auto shift =
        translation ? point_of<Vector2<double>>(*translation, "translation") : Vector2<double>{};
    return moved(path, angle, shift).value();
  }
  const auto q = rotation ? point_of<Quaternion<double>>(*rotation, "rotation")
                          : Quaternion<double>{1, 0, 0, 0};
  const auto shift =
      translation ? point_of<Vector3<double>>(*translation, "translation") : Vector3<double>{};
  return moved(path, q, shift).value();
}

}  // namespace

void bind_path_operations(py::module_& m) {
  m.def(
      "reversed", [](const AnyPath& path) { return reversed(path).value(); }, py::arg("path"),
      "The path run backwards, on knots that start where the path's end with their sign changed.");
  m.def(
      "subpath",
      [](const AnyPath& path, double xi_a, double xi_b) {
        return subpath(path, xi_a, xi_b).value();
      },
      py::arg("path"), py::arg("xi_a"), py::arg("xi_b"),
      "The part on [xi_a, xi_b], open, with its xi unchanged.");
  m.def(
      "joined", [](const AnyPath& a, const AnyPath& b) { return joined(a, b).value(); },
      py::arg("a"), py::arg("b"),
      "First a, then b, which starts where a ends, in a's direction; in the larger degree.");
  m.def(
      "with_closure",
      [](const AnyPath& path, bool closed) { return with_closure(path, closed).value(); },
      py::arg("path"), py::arg("closed"), "The same path declared closed, or open.");
  m.def(
      "reparametrised",
      [](const AnyPath& path, double begin, double end) {
        return reparametrised(path, begin, end).value();
      },
      py::arg("path"), py::arg("begin"), py::arg("end"), "The same curve on [begin, end].");
  m.def(
      "with_preimage_degree",
      [](const AnyPath& path, std::size_t degree) {
        return with_preimage_degree(path, degree).value();
      },
      py::arg("path"), py::arg("degree"),
      "The same path with its preimage written in a higher degree.");
  m.def("moved", &turned, py::arg("path"), py::arg("rotation") = py::none(),
        py::arg("translation") = py::none(),
        "Turned about the origin, then shifted: by an angle (radians) in the plane, by a unit "
        "quaternion\n(w, x, y, z) in space.");
  m.def(
      "scaled", [](const AnyPath& path, double factor) { return scaled(path, factor).value(); },
      py::arg("path"), py::arg("factor"), "Scaled about the origin by a positive factor.");
  m.def(
      "reflected",
      [](const AnyPath& path, const Doubles& normal, const std::optional<Doubles>& point) {
        const std::vector<double> origin(path.dimension(), 0.0);
        return reflected(path, numbers(normal),
                         point ? numbers(*point) : std::span<const double>(origin))
            .value();
      },
      py::arg("path"), py::arg("normal"), py::arg("point") = py::none(),
      "Mirrored in the plane (in the plane: the line) through point with the given normal.");
  m.def(
      "lifted", [](const AnyPath& path) { return lifted(path).value(); }, py::arg("path"),
      "A planar path in the plane z = 0 of space.");
}

}  // namespace hodograph::python
