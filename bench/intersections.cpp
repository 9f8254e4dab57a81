// SPDX-License-Identifier: MIT
// How long do the certain intersections of two planar quintics take, of two paths of many, and of a
// path with a line, against polylines of 100 samples without any certainty?
#include "hodograph/path/intersections.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Curve = PlanarPhCurve<2>;

/// Paths of quintics whose preimages vary by `wildness` about `turn`.
PlanarPath<2> random_path(bench::Numbers& numbers, std::size_t segments, double wildness,
                          const Complex<double>& turn) {
  std::vector<double> knots{0.0};
  std::vector<Curve> curves;
  Vector2<double> start{numbers.within(-0.5, 0.5), numbers.within(-0.5, 0.5)};
  for (std::size_t k = 0; k < segments; ++k) {
    Curve::Preimage w;
    for (std::size_t i = 0; i <= 2; ++i) {
      w[i] = turn * Complex<double>{1.0 + wildness * numbers.within(-1, 1),
                                    wildness * numbers.within(-1, 1)};
    }
    knots.push_back(static_cast<double>(k + 1));
    curves.emplace_back(start, w, 1.0);
    start = curves.back().end();
  }
  return PlanarPath<2>::create(std::move(knots), std::move(curves), false).value();
}

std::vector<Vector2<double>> samples(const PlanarPath<2>& path) {
  constexpr int count = 100;
  std::vector<Vector2<double>> points;
  for (int i = 0; i <= count; ++i) {
    points.push_back(path.segment(0).position(static_cast<double>(i) / count));
  }
  return points;
}

/// How often two polylines cross, all sides against all.
std::size_t crossings(const std::vector<Vector2<double>>& a,
                      const std::vector<Vector2<double>>& b) {
  std::size_t count = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i) {
    const auto d = a[i + 1] - a[i];
    for (std::size_t k = 0; k + 1 < b.size(); ++k) {
      const auto e = b[k + 1] - b[k];
      const bool across = cross(d, b[k] - a[i]) * cross(d, b[k + 1] - a[i]) <= 0.0 &&
                          cross(e, a[i] - b[k]) * cross(e, a[i + 1] - b[k]) <= 0.0;
      count += across ? 1U : 0U;
    }
  }
  return count;
}

}  // namespace

int main() {
  bench::Numbers numbers;
  std::vector<PlanarPath<2>> first, second;
  constexpr std::size_t pairs = 200;
  for (std::size_t k = 0; k < pairs; ++k) {
    first.push_back(random_path(numbers, 1, 1.0, {1.0, 0.0}));
    second.push_back(random_path(numbers, 1, 1.0, {0.6, 0.8}));
  }
  std::size_t certain = 0, undecided = 0;
  for (std::size_t k = 0; k < pairs; ++k) {
    for (const auto& at : intersections(first[k], second[k])) {
      ++(at.kind == IntersectionKind::crossing ? certain : undecided);
    }
  }
  std::printf("%zu crossings, %zu undecided\n", certain, undecided);
  bench::compare("a pair of quintics",
                 {{"polylines of 100 sides",
                   [&] {
                     for (std::size_t k = 0; k < pairs; ++k) {
                       bench::keep(crossings(samples(first[k]), samples(second[k])));
                     }
                   },
                   static_cast<double>(pairs)},
                  {"intersections",
                   [&] {
                     for (std::size_t k = 0; k < pairs; ++k) {
                       bench::keep(intersections(first[k], second[k]));
                     }
                   },
                   static_cast<double>(pairs)},
                  {"line_intersections",
                   [&] {
                     for (std::size_t k = 0; k < pairs; ++k) {
                       bench::keep(line_intersections(first[k], {0.5, 0.0}, {0.2, 1.0}));
                     }
                   },
                   static_cast<double>(pairs)}},
                 11);
  const auto long_first = random_path(numbers, 1000, 0.6, {1.0, 0.0});
  const auto long_second = random_path(numbers, 1000, 0.6, {1.0, 0.05});
  bench::compare("two paths of 1000 quintics, " +
                     std::to_string(intersections(long_first, long_second).size()) +
                     " intersections",
                 {{"intersections, the whole",
                   [&] { bench::keep(intersections(long_first, long_second)); }, 1.0}},
                 5);
  return 0;
}
