// SPDX-License-Identifier: MIT
// Triangle meshes with normals, and what can be said of one: counts, edges, area, volume.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "hodograph/algebra/vector.hpp"

namespace hodograph {

/// Triangles between numbered vertices. A vertex is a position with a normal: where the surface
/// has an edge, several vertices share a position. Seen from outside the corners of a triangle run
/// counterclockwise.
struct TriangleMesh {
  using Index = std::uint32_t;

  std::vector<Vector3<double>> positions{};
  std::vector<Vector3<double>> normals{};  ///< of the vertices, unit length
  /// The position of each vertex; empty where vertex i has position i.
  std::vector<Index> position_of{};
  std::vector<std::array<Index, 3>> triangles{};  ///< vertices

  std::size_t vertex_count() const { return normals.size(); }
  Index position_index(Index vertex) const {
    return position_of.empty() ? vertex : position_of[vertex];
  }
  const Vector3<double>& corner(std::size_t triangle, std::size_t i) const {
    return positions[position_index(triangles[triangle][i])];
  }
};

struct MeshFacts {
  std::size_t positions = 0, triangles = 0, edges = 0;
  std::size_t boundary_edges = 0;      ///< with one triangle
  std::size_t bad_edges = 0;           ///< with more than two, or passed twice in one direction
  std::size_t bad_positions = 0;       ///< whose triangles are not one fan
  long long euler_characteristic = 0;  ///< positions - edges + triangles, of positions in use
  double area = 0.0;
  /// ∫ x·n dA/3, the volume inside a closed mesh, positive where it is oriented outwards.
  double volume = 0.0;

  bool is_manifold() const { return bad_edges == 0 && bad_positions == 0; }
  bool is_closed() const { return triangles > 0 && boundary_edges == 0; }
};

/// The facts of a mesh; vertices count by position. Exact but for area and volume, sums of rounded
/// terms relative to the middle of the mesh. Domain: indices in range.
MeshFacts facts_of(const TriangleMesh& mesh);

/// Areas and volume alone.
double mesh_area(const TriangleMesh& mesh);
double mesh_volume(const TriangleMesh& mesh);

/// How far positions move, at most, when their coordinates relative to `origin` are written in
/// single precision; infinite where one is too large for it.
double single_precision_error(const TriangleMesh& mesh, const Vector3<double>& origin = {});

/// The middle of the box of all positions; the origin for none.
Vector3<double> middle_of(const TriangleMesh& mesh);

}  // namespace hodograph
