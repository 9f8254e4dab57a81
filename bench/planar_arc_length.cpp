// SPDX-License-Identifier: MIT
// How long does the point at a given arc length of a planar spline take, against a table of arc
// lengths with linear interpolation, and against Newton's iteration on adaptive quadrature, as an
// ordinary quintic spline of the same shape needs it?
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>

#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/path/arc_length_map.hpp"
#include "hodograph/path/batch.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

// The accuracy the task asks of the table's points, in about the distance of the nodes; what the
// quadrature needs for a point of its own accuracy; and the step at which Newton's iteration has
// it.
constexpr double wanted = 1e-6, quadrature_tolerance = 1e-9, small_step = 1e-12;

PlanarPath<2> spline(std::size_t count) {
  bench::Numbers numbers;
  std::vector<Vector2<double>> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double t = 0.5 * static_cast<double>(i);
    points.push_back({t + 0.3 * numbers.within(-1, 1), std::sin(t) + 0.3 * numbers.within(-1, 1)});
  }
  return planar_spline(points).value().path;
}

/// (arc length, ξ) so dense that linear interpolation of the point is as accurate as wanted.
struct LengthTable {
  std::vector<double> length, xi;

  LengthTable(const PlanarPath<2>& path, std::size_t entries) {
    const double step = (path.xi_end() - path.xi_begin()) / static_cast<double>(entries);
    for (std::size_t i = 0; i <= entries; ++i) {
      xi.push_back(i == entries ? path.xi_end() : path.xi_begin() + static_cast<double>(i) * step);
      length.push_back(path.arc_length(xi.back()));
    }
  }
  double parameter(double s) const {
    const auto above = std::upper_bound(length.begin() + 1, length.end() - 1, s);
    const auto i = static_cast<std::size_t>(above - length.begin());
    return xi[i - 1] + (xi[i] - xi[i - 1]) * (s - length[i - 1]) / (length[i] - length[i - 1]);
  }
};

double worst_error(const PlanarPath<2>& path, const LengthTable& table,
                   const std::vector<double>& lengths) {
  double worst = 0.0;
  for (const double s : lengths) {
    worst = std::max(worst, norm(path.position(table.parameter(s)) -
                                 path.position(parameter_at_arc_length(path, s))));
  }
  return worst;
}

/// The same shape as an ordinary quintic: control points alone, the speed by a square root.
struct OrdinarySpline {
  std::vector<BernsteinPolynomial<Vector2<double>, 5>> position;
  std::vector<BernsteinPolynomial<Vector2<double>, 4>> derivative;
  std::vector<double> lengths{0.0};

  explicit OrdinarySpline(const PlanarPath<2>& path) {
    for (const auto& curve : path.segments()) {
      position.push_back(
          curve.displacement().mapped([&](const Vector2<double>& d) { return curve.start() + d; }));
      derivative.push_back(position.back().derivative());
      lengths.push_back(lengths.back() + arc_length(position.size() - 1, 1.0));
    }
  }
  double speed(std::size_t k, double u) const { return norm(derivative[k].value(u)); }
  double arc_length(std::size_t k, double u) const {
    using boost::math::quadrature::gauss_kronrod;
    constexpr unsigned deepest = 8;
    return gauss_kronrod<double, 15>::integrate([&](double t) { return speed(k, t); }, 0.0, u,
                                                deepest, quadrature_tolerance);
  }
  Vector2<double> point(double s) const {
    const auto above = std::upper_bound(lengths.begin() + 1, lengths.end() - 1, s);
    const auto k = static_cast<std::size_t>(above - lengths.begin()) - 1;
    const double t = s - lengths[k];
    double u = t / (lengths[k + 1] - lengths[k]);
    constexpr int most_steps = 20;
    for (int step = 0; step < most_steps; ++step) {
      const double change = (t - arc_length(k, u)) / speed(k, u);
      u = std::min(1.0, std::max(0.0, u + change));
      if (std::abs(change) <= small_step) break;
    }
    return position[k].value(u);
  }
};

}  // namespace

int main() {
  constexpr std::size_t nodes = 1000, count = 4096;
  const auto path = spline(nodes);
  const OrdinarySpline ordinary(path);
  bench::Numbers numbers;
  const auto random = numbers.many(count, 0.0, path.arc_length(), false);
  const auto sorted = numbers.many(count, 0.0, path.arc_length(), true);
  std::size_t entries = nodes;
  while (worst_error(path, LengthTable(path, entries), random) > wanted) entries *= 2;
  const LengthTable table(path, entries);
  std::vector<Vector2<double>> points(count);
  const auto items = static_cast<double>(count);
  std::printf("a planar C2 spline through %zu points; the table has %zu entries\n", nodes, entries);
  bench::compare("point at arc length", {{"ordinary quintics, Newton on Gauss-Kronrod",
                                          [&] {
                                            for (const double s : random)
                                              bench::keep(ordinary.point(s));
                                          },
                                          items},
                                         {"table, accurate to 1e-6",
                                          [&] {
                                            for (const double s : random)
                                              bench::keep(path.position(table.parameter(s)));
                                          },
                                          items},
                                         {"point_at_arc_length",
                                          [&] {
                                            for (const double s : random)
                                              bench::keep(point_at_arc_length(path, s));
                                          },
                                          items},
                                         {"points_at_arc_lengths, sorted batch",
                                          [&] {
                                            points_at_arc_lengths(path,
                                                                  std::span<const double>(sorted),
                                                                  std::span(points));
                                            bench::keep(points);
                                          },
                                          items}});
}
