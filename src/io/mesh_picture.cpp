// SPDX-License-Identifier: MIT
#include "hodograph/io/mesh_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <numeric>

#include "hodograph/io/svg.hpp"

namespace hodograph {

std::string mesh_svg(const TriangleMesh& mesh, const MeshView& view) {
  const double ca = std::cos(view.azimuth), sa = std::sin(view.azimuth);
  const double ce = std::cos(view.elevation), se = std::sin(view.elevation);
  const Vector3<double> eye{ce * ca, ce * sa, se}, right{-sa, ca, 0.0},
      up{-(se * ca), -(se * sa), ce};
  const Vector3<double> light =
      (1.0 / norm(eye + 0.5 * up - 0.4 * right)) * (eye + 0.5 * up - 0.4 * right);

  double left = 0.0, low = 0.0, wide = 0.0, high = 0.0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double x = dot(mesh.positions[i], right), y = dot(mesh.positions[i], up);
    left = i == 0 ? x : std::min(left, x);
    wide = i == 0 ? x : std::max(wide, x);
    low = i == 0 ? y : std::min(low, y);
    high = i == 0 ? y : std::max(high, y);
  }
  const double spread_x = wide - left, spread_y = high - low;
  const double scale =
      std::min(spread_x > 0.0 ? (view.width - 2 * view.margin) / spread_x : 1e300,
               spread_y > 0.0 ? (view.height - 2 * view.margin) / spread_y : 1e300);
  const double zoom = spread_x > 0.0 || spread_y > 0.0 ? scale : 1.0;

  std::vector<double> depth(mesh.triangles.size());
  for (std::size_t t = 0; t < depth.size(); ++t) {
    depth[t] = dot(mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2), eye);
  }
  std::vector<std::size_t> order(depth.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return depth[a] < depth[b] || (depth[a] == depth[b] && a < b);
  });

  const double width = zoom * spread_x + 2 * view.margin;
  const double height = zoom * spread_y + 2 * view.margin;
  std::array<char, 200> line{};
  std::snprintf(line.data(), line.size(),
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.1f %.1f\" "
                "width=\"%.0f\" height=\"%.0f\" role=\"img\" stroke-width=\"0.4\" "
                "stroke-linejoin=\"round\">\n",
                width, height, width, height);
  std::string text = line.data();
  for (const std::size_t t : order) {
    const Vector3<double> across =
        cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    const double size = norm(across);
    const double facing = dot(across, eye);
    if (!(size > 0.0) || (view.closed && facing <= 0.0)) continue;
    const double lit = (facing < 0.0 ? -1.0 : 1.0) * dot(across, light) / size;
    const double shade = 0.35 + 0.65 * std::max(0.0, lit);
    // The blue of the pictures of paths, darker away from the light.
    const auto part = [shade](double full) { return static_cast<unsigned>(full * shade); };
    std::array<char, 8> color{};
    std::snprintf(color.data(), color.size(), "#%02x%02x%02x", part(96.0), part(165.0),
                  part(225.0));
    std::array<double, 6> at;
    for (std::size_t i = 0; i < 3; ++i) {
      at[2 * i] = view.margin + zoom * (dot(mesh.corner(t, i), right) - left);
      at[2 * i + 1] = view.margin + zoom * (high - dot(mesh.corner(t, i), up));
    }
    std::snprintf(line.data(), line.size(),
                  "<path d=\"M%.1f %.1fL%.1f %.1fL%.1f %.1fZ\" fill=\"%s\" stroke=\"%s\"/>\n",
                  at[0], at[1], at[2], at[3], at[4], at[5], color.data(), color.data());
    text += line.data();
  }
  return text + "</svg>\n";
}

}  // namespace hodograph
