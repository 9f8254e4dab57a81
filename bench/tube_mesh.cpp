// SPDX-License-Identifier: MIT
// How long does a mesh of a million triangles round a tube take, certified within its tolerance,
// against the plain way: every vertex evaluated by itself, on a grid of the same size without any
// bound?
#include <cmath>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/frame/path_state.hpp"
#include "hodograph/surface/sweep_mesh.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

/// The tube with its normals, one evaluation of the path a vertex.
TriangleMesh plain_tube(const SpatialPath<3>& path, double radius, std::size_t rings,
                        std::size_t columns) {
  using Index = TriangleMesh::Index;
  TriangleMesh mesh;
  for (std::size_t i = 0; i < rings; ++i) {
    const double xi = static_cast<double>(i) / static_cast<double>(rings - 1);
    for (std::size_t j = 0; j < columns; ++j) {
      const double angle =
          2 * std::numbers::pi * static_cast<double>(j) / static_cast<double>(columns);
      const auto state = evaluate(path, xi);
      const Vector3<double> normal =
          std::cos(angle) * state.frame.e2 + std::sin(angle) * state.frame.e3;
      mesh.positions.push_back(state.position + radius * normal);
      mesh.normals.push_back(normal);
    }
  }
  for (std::size_t i = 0; i + 1 < rings; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const auto at = [&](std::size_t ring, std::size_t column) {
        return static_cast<Index>(ring * columns + column % columns);
      };
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)});
    }
  }
  return mesh;
}

}  // namespace

int main() {
  const auto loop = closed_loop({0.5, 2.0}, {10.0, {}, {1, 0, 0, 0}}).value();
  const auto open = SpatialPath<3>::create({0.0, 1.0}, {loop.segment(0)}, false).value();
  const double radius = 0.2;
  constexpr double first_guess = 1e-3;  // of the tolerance whose mesh has a million triangles
  double tolerance = first_guess;
  const auto tube = [&](const SpatialPath<3>& path) {
    return Sweep{Motion::along(path).value(), Profile::circle(radius).value()};
  };
  for (int i = 0; i < 8; ++i) {
    const auto made = mesh_of(tube(open), {tolerance}).value();
    tolerance *= static_cast<double>(made.mesh.triangles.size()) / 1e6;
  }
  const auto made = mesh_of(tube(open), {tolerance}).value();
  std::printf("%zu triangles, %zu rings of %zu, within %.3g, certified %.3g\n",
              made.mesh.triangles.size(), made.rings, made.columns, tolerance, made.deviation);
  const auto items = static_cast<double>(made.mesh.triangles.size());
  bench::compare("tube of 10^6 triangles, path of degree 7, open with caps",
                 {{"vertex by vertex, no bound",
                   [&] { bench::keep(plain_tube(open, radius, made.rings, made.columns)); }, items},
                  {"mesh_of, certified",
                   [&] { bench::keep(mesh_of(tube(open), {tolerance}).value()); }, items}});
  bench::compare("the same on the closed loop",
                 {{"vertex by vertex, no bound",
                   [&] { bench::keep(plain_tube(loop, radius, made.rings, made.columns)); }, items},
                  {"mesh_of, certified",
                   [&] { bench::keep(mesh_of(tube(loop), {tolerance}).value()); }, items}});
  bench::compare("facts of the mesh: edges, manifold, area, volume",
                 {{"facts_of", [&] { bench::keep(facts_of(made.mesh)); }, items}});
}
