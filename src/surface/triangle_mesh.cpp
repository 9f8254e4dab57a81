// SPDX-License-Identifier: MIT
#include "hodograph/surface/triangle_mesh.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace hodograph {
namespace {

using Index = TriangleMesh::Index;

/// An edge of a triangle, by the positions of its ends, smaller first.
struct Side {
  std::uint64_t ends;
  std::uint32_t triangle;
  std::uint8_t corner;  // where it starts
  bool forward;         // from the smaller to the larger position
};

/// Sets of corners that belong together.
class Classes {
 public:
  explicit Classes(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), std::uint32_t{0});
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) {
      parent_[i] = parent_[parent_[i]];
      i = parent_[i];
    }
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[find(i)] = find(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// All sides, equal ends together: counted into runs of one smaller end, which are short.
std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
  std::vector<std::uint32_t> begin(mesh.positions.size() + 1, 0);
  const auto for_each_side = [&mesh](const auto& visit) {
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const auto& triangle = mesh.triangles[t];
      const Index p[3] = {mesh.position_index(triangle[0]), mesh.position_index(triangle[1]),
                          mesh.position_index(triangle[2])};
      for (std::size_t i = 0; i < 3; ++i) visit(t, i, p[i], p[(i + 1) % 3]);
    }
  };
  for_each_side([&](std::size_t, std::size_t, Index a, Index b) { ++begin[std::min(a, b) + 1]; });
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * mesh.triangles.size());
  std::vector<std::uint32_t> next(begin.begin(), begin.end() - 1);
  for_each_side([&](std::size_t t, std::size_t i, Index a, Index b) {
    const std::uint64_t low = std::min(a, b), high = std::max(a, b);
    sides[next[low]++] = {low << 32 | high, static_cast<std::uint32_t>(t),
                          static_cast<std::uint8_t>(i), a < b};
  });
  for (std::size_t p = 0; p + 1 < begin.size(); ++p) {
    std::sort(sides.begin() + begin[p], sides.begin() + begin[p + 1],
              [](const Side& a, const Side& b) { return a.ends < b.ends; });
  }
  return sides;
}

}  // namespace

MeshFacts facts_of(const TriangleMesh& mesh) {
  MeshFacts facts;
  facts.positions = mesh.positions.size();
  facts.triangles = mesh.triangles.size();
  facts.area = mesh_area(mesh);
  facts.volume = mesh_volume(mesh);
  const std::vector<Side> sides = sorted_sides(mesh);
  Classes fans(3 * mesh.triangles.size());
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t j = i;
    while (j < sides.size() && sides[j].ends == sides[i].ends) ++j;
    ++facts.edges;
    if (j - i == 1) ++facts.boundary_edges;
    const bool degenerate = sides[i].ends >> 32 == (sides[i].ends & 0xffffffffu);
    if (j - i > 2 || degenerate || (j - i == 2 && sides[i].forward == sides[i + 1].forward)) {
      ++facts.bad_edges;
    } else if (j - i == 2) {
      const Side &p = sides[i], &q = sides[i + 1];
      const auto corner = [](const Side& s, unsigned step) {
        return 3 * s.triangle + (s.corner + step) % 3;
      };
      fans.join(corner(p, 0), corner(q, 1));
      fans.join(corner(p, 1), corner(q, 0));
    }
    i = j;
  }
  // A position in use has one fan: one class of its corners.
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> fan_of(mesh.positions.size(), none);
  std::vector<bool> bad(mesh.positions.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Index p = mesh.position_index(mesh.triangles[t][i]);
      const std::uint32_t fan = fans.find(static_cast<std::uint32_t>(3 * t + i));
      if (fan_of[p] == none) fan_of[p] = fan;
      if (fan_of[p] != fan) bad[p] = true;
    }
  }
  facts.bad_positions = static_cast<std::size_t>(std::count(bad.begin(), bad.end(), true));
  const auto used = static_cast<long long>(fan_of.size()) -
                    static_cast<long long>(std::count(fan_of.begin(), fan_of.end(), none));
  facts.euler_characteristic =
      used - static_cast<long long>(facts.edges) + static_cast<long long>(facts.triangles);
  return facts;
}

Vector3<double> middle_of(const TriangleMesh& mesh) {
  if (mesh.positions.empty()) return {};
  Vector3<double> low = mesh.positions[0], high = low;
  for (const auto& p : mesh.positions) {
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = std::min(low[j], p[j]);
      high[j] = std::max(high[j], p[j]);
    }
  }
  return 0.5 * low + 0.5 * high;
}

double mesh_area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& a = mesh.corner(t, 0);
    sum += 0.5 * norm(cross(mesh.corner(t, 1) - a, mesh.corner(t, 2) - a));
  }
  return sum;
}

double mesh_volume(const TriangleMesh& mesh) {
  const Vector3<double> middle = middle_of(mesh);
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    sum += dot(mesh.corner(t, 0) - middle,
               cross(mesh.corner(t, 1) - middle, mesh.corner(t, 2) - middle));
  }
  return sum / 6.0;
}

double single_precision_error(const TriangleMesh& mesh, const Vector3<double>& origin) {
  // Each coordinate is rounded to within half an ulp, 2^-24 of itself, or half of the smallest
  // number; three of them.
  constexpr double half_ulp = 0x1.0p-24, half_smallest = 0x1.0p-150;
  constexpr double root_three_up = 1.7320508075688774;
  double far = 0.0;
  for (const auto& p : mesh.positions) far = std::max(far, largest_component(p - origin));
  if (far > static_cast<double>(std::numeric_limits<float>::max())) {
    return std::numeric_limits<double>::infinity();
  }
  return root_three_up * std::max(half_ulp * far, half_smallest);
}

}  // namespace hodograph
