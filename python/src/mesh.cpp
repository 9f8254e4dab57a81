// SPDX-License-Identifier: MIT
// Triangle meshes as arrays: surface/triangle_mesh.hpp, surface/sweep_mesh.hpp.
#include "hodograph/surface/triangle_mesh.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/surface/sweep_mesh.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/swept.hpp"

namespace hodograph::python {

namespace {

using Index = TriangleMesh::Index;
using Indices = py::array_t<Index, py::array::c_style>;
using Integers = py::array_t<long long, py::array::c_style | py::array::forcecast>;

py::ssize_t size(std::size_t n) { return static_cast<py::ssize_t>(n); }

Doubles points_view(const std::vector<Vector3<double>>& points, py::handle owner) {
  static_assert(sizeof(Vector3<double>) == 3 * sizeof(double));
  return view_of(points.empty() ? nullptr : &points.front().x, {size(points.size()), 3}, owner);
}

Indices indices_view(const Index* data, const Shape& shape, py::handle owner) {
  Indices view(shape, data, owner);
  view.attr("flags").attr("writeable") = false;
  return view;
}

void require_finite(const std::vector<Vector3<double>>& points, const char* name) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      if (std::isfinite(points[i][j])) continue;
      throw Error(Fault{FaultCode::not_finite,
                        std::string("row ") + std::to_string(i) + " of the " + name +
                            " is infinite or not a number",
                        i, name, points[i][j], std::nullopt});
    }
  }
}

/// The unit normals of the vertices: area-weighted means of those of their triangles.
std::vector<Vector3<double>> mean_normals(const TriangleMesh& mesh, std::size_t count) {
  std::vector<Vector3<double>> normals(count);
  for (const auto& corners : mesh.triangles) {
    const auto &a = mesh.positions[corners[0]], &b = mesh.positions[corners[1]],
               &c = mesh.positions[corners[2]];
    const Vector3<double> area = cross(b - a, c - a);
    for (const Index vertex : corners) normals[vertex] += area;
  }
  for (auto& normal : normals) {
    const double length = norm(normal);
    normal = length > 0.0 ? (1.0 / length) * normal : Vector3<double>{0.0, 0.0, 1.0};
  }
  return normals;
}

TriangleMesh mesh_from(const Doubles& positions, const Integers& triangles,
                       const std::optional<Doubles>& normals) {
  TriangleMesh mesh;
  mesh.positions = points_of<Vector3<double>>(positions, "positions");
  require_finite(mesh.positions, "positions");
  if (triangles.ndim() != 2 || triangles.shape(1) != 3) {
    refuse_shape("triangles", "(m, 3)", Doubles(triangles));
  }
  const auto count = static_cast<long long>(mesh.positions.size());
  const auto rows = static_cast<std::size_t>(triangles.shape(0));
  mesh.triangles.resize(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const long long at = triangles.data()[3 * i + j];
      if (at < 0 || at >= count) {
        throw Error(Fault{FaultCode::outside_domain,
                          "triangle " + std::to_string(i) + " names vertex " + std::to_string(at) +
                              "; there are " + std::to_string(count) + ", counted from 0",
                          i, "triangles", static_cast<double>(at), static_cast<double>(count - 1)});
      }
      mesh.triangles[i][j] = static_cast<Index>(at);
    }
  }
  if (!normals) {
    mesh.normals = mean_normals(mesh, mesh.positions.size());
    return mesh;
  }
  mesh.normals = points_of<Vector3<double>>(*normals, "normals");
  require_finite(mesh.normals, "normals");
  if (mesh.normals.size() != mesh.positions.size()) {
    refuse_shape("normals", "(" + std::to_string(count) + ", 3), as the positions", *normals);
  }
  return mesh;
}

Doubles vertices_of(const TriangleMesh& mesh) {
  Doubles result(Shape{size(mesh.vertex_count()), 3});
  double* to = result.mutable_data();
  for (Index i = 0; i < mesh.vertex_count(); ++i) {
    for (std::size_t j = 0; j < 3; ++j) *to++ = mesh.positions[mesh.position_index(i)][j];
  }
  return result;
}

py::tuple state_of(const TriangleMesh& mesh) {
  const auto indices = [](const Index* data, const Shape& shape) { return Indices(shape, data); };
  return py::make_tuple(array_of(mesh.positions), array_of(mesh.normals),
                        indices(mesh.position_of.data(), {size(mesh.position_of.size())}),
                        indices(mesh.triangles.empty() ? nullptr : mesh.triangles.front().data(),
                                {size(mesh.triangles.size()), 3}));
}

TriangleMesh mesh_of_state(const py::tuple& state) {
  require_members(state, 4);
  TriangleMesh mesh;
  mesh.positions = points_of<Vector3<double>>(state[0].cast<Doubles>(), "positions");
  mesh.normals = points_of<Vector3<double>>(state[1].cast<Doubles>(), "normals");
  const auto rows = state[2].cast<Indices>(), corners = state[3].cast<Indices>();
  mesh.position_of.assign(rows.data(), rows.data() + rows.size());
  mesh.triangles.resize(static_cast<std::size_t>(corners.size()) / 3);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    std::copy_n(corners.data() + 3 * i, 3, mesh.triangles[i].begin());
  }
  return mesh;
}

void bind_triangle_mesh(py::module_& m) {
  py::class_<TriangleMesh>(m, "TriangleMesh",
                           "Triangles between numbered vertices, each a position with a normal. "
                           "Seen from outside the corners\nof a triangle run counterclockwise.")
      .def(py::init(&mesh_from), py::arg("positions"), py::arg("triangles"),
           py::arg("normals") = py::none(),
           "From positions (n, 3) and triangles (m, 3) of whole numbers; without normals (n, 3) "
           "the means of the\ntriangles'. Raises HodographError: mismatched_size, not_finite, "
           "outside_domain.")
      .def_property_readonly(
          "vertices", &vertices_of,
          "The position of every vertex, (n, 3): what `triangles` counts. A copy.")
      .def_property_readonly(
          "normals",
          [](const py::object& self) {
            return points_view(self.cast<const TriangleMesh&>().normals, self);
          },
          "The unit normal of every vertex, (n, 3). A view.")
      .def_property_readonly(
          "triangles",
          [](const py::object& self) {
            const auto& triangles = self.cast<const TriangleMesh&>().triangles;
            return indices_view(triangles.empty() ? nullptr : triangles.front().data(),
                                {size(triangles.size()), 3}, self);
          },
          "Three vertices each, (m, 3). A view.")
      .def_property_readonly(
          "positions",
          [](const py::object& self) {
            return points_view(self.cast<const TriangleMesh&>().positions, self);
          },
          "Distinct positions, (k, 3), k <= n: vertices on an edge share one. A view.")
      .def_property_readonly(
          "position_of",
          [](const TriangleMesh& mesh) {
            Indices result(size(mesh.vertex_count()));
            for (Index i = 0; i < mesh.vertex_count(); ++i) {
              result.mutable_data()[i] = mesh.position_index(i);
            }
            return result;
          },
          "Which row of `positions` every vertex has, (n,). A copy.")
      .def("__repr__",
           [](const TriangleMesh& mesh) {
             return "<hodograph.TriangleMesh: " + std::to_string(mesh.vertex_count()) +
                    " vertices, " + std::to_string(mesh.triangles.size()) + " triangles>";
           })
      .def(
          "__eq__",
          [](const TriangleMesh& a, const TriangleMesh& b) {
            return a.positions == b.positions && a.normals == b.normals &&
                   a.position_of == b.position_of && a.triangles == b.triangles;
          },
          py::is_operator())
      .def(py::pickle(&state_of, &mesh_of_state));
  Record<MeshFacts>(m, "MeshFacts", "Counts, edges, area and volume of a mesh.")
      .field("positions", &MeshFacts::positions)
      .field("triangles", &MeshFacts::triangles)
      .field("edges", &MeshFacts::edges)
      .field("boundary_edges", &MeshFacts::boundary_edges, "With one triangle.")
      .field("bad_edges", &MeshFacts::bad_edges, "With more than two, or passed twice one way.")
      .field("bad_positions", &MeshFacts::bad_positions, "Whose triangles are not one fan.")
      .field("euler_characteristic", &MeshFacts::euler_characteristic)
      .field("area", &MeshFacts::area)
      .field("volume", &MeshFacts::volume, "Inside a closed mesh; positive if oriented outwards.")
      .property("is_manifold", &MeshFacts::is_manifold)
      .property("is_closed", &MeshFacts::is_closed);
  m.def(
      "facts_of", [](const TriangleMesh& mesh) { return unlocked([&] { return facts_of(mesh); }); },
      py::arg("mesh"), "What can be said of a mesh; vertices count by position.");
  m.def("mesh_area", &mesh_area, py::arg("mesh"), "The sum of the triangles' areas.");
  m.def("mesh_volume", &mesh_volume, py::arg("mesh"), "The volume inside a closed mesh.");
  m.def(
      "middle_of", [](const TriangleMesh& mesh) { return array_of(middle_of(mesh)); },
      py::arg("mesh"), "The middle of the box of all positions, (3,).");
  m.def(
      "single_precision_error",
      [](const TriangleMesh& mesh, const std::optional<Doubles>& origin) {
        return single_precision_error(
            mesh, origin ? point_of<Vector3<double>>(*origin, "origin") : Vector3<double>{});
      },
      py::arg("mesh"), py::arg("origin") = py::none(),
      "How far positions move, at most, when written in single precision relative to an origin.");
}

}  // namespace

void bind_mesh(py::module_& m) {
  bind_triangle_mesh(m);
  Record<SweepMesh>(m, "SweepMesh", "The mesh of a sweep and how far it is from the surface.")
      .field("mesh", &SweepMesh::mesh)
      .field("deviation", &SweepMesh::deviation,
             "No point of the mesh is further from the surface: at most the tolerance.")
      .field("rings", &SweepMesh::rings, "Vertices along the motion.")
      .field("columns", &SweepMesh::columns, "Vertices round the profile.")
      .field("cap_triangles", &SweepMesh::cap_triangles, "The last ones of the mesh.");
  m.def(
      "mesh_of",
      [](const Sweep& sweep, double tolerance, std::size_t most_triangles, bool caps) {
        return unlocked([&] { return mesh_of(sweep, {tolerance, most_triangles, caps}).value(); });
      },
      py::arg("sweep"), py::kw_only(), py::arg("tolerance"),
      py::arg("most_triangles") = SweepMeshOptions{}.most_triangles, py::arg("caps") = true,
      "The watertight, oriented mesh of a sweep within a tolerance: a bound of the distance. Raises"
      "\nHodographError: outside_domain, tolerance_not_reached, zero_speed, unsupported.");
  m.attr("crease_angle") = crease_angle;
}

}  // namespace hodograph::python
