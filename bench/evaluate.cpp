// SPDX-License-Identifier: MIT
// How long does position + frame + body rate + speed + arc length at a point take, one by one and
// in batches, against de Casteljau's algorithm?
#include "hodograph/frame/batch.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;

/// The value of a polynomial by de Casteljau's algorithm, and with it the derivative by u.
template <class V, std::size_t n>
std::array<V, 2> de_casteljau(const BernsteinPolynomial<V, n>& f, double u) {
  std::array<V, n + 1> point = f.coefficients();
  for (std::size_t r = n; r > 1; --r) {
    for (std::size_t i = 0; i < r; ++i) point[i] = (1 - u) * point[i] + u * point[i + 1];
  }
  return {(1 - u) * point[0] + u * point[1], static_cast<double>(n) * (point[1] - point[0])};
}

template <std::size_t n>
PathState<Quaternion<double>> by_de_casteljau(const SpatialPath<n>& path, double xi) {
  const auto at = path.locate(xi);
  const auto& curve = path.segment(at.segment);
  const auto a = de_casteljau(curve.preimage(), at.u);
  const auto integral = de_casteljau(curve.integral(), at.u)[0];
  const double sigma = speed_form(a[0], a[0]), reciprocal = 1 / sigma;
  return {curve.start() + integral.displacement, reciprocal * scaled_frame(a[0]),
          (2 * reciprocal / curve.parameter_step()) * body_rate_form(a[0], a[1]), sigma,
          path.knot_arc_lengths()[at.segment] + integral.arc_length};
}

template <std::size_t n>
void run(std::size_t segments, std::size_t count, bool sorted) {
  using A = Quaternion<double>;
  const auto path = bench::random_path<n>(segments, 0.3);
  bench::Numbers numbers;
  const auto xi = numbers.many(count, path.xi_begin(), path.xi_end(), sorted);
  std::vector<Vector3<double>> positions(count), rates(count);
  std::vector<Frame3<double>> frames(count);
  std::vector<double> speeds(count), lengths(count);
  const auto items = static_cast<double>(count);
  bench::compare("degree " + std::to_string(2 * n + 1) + ", " + std::to_string(segments) +
                     " segments, " + std::to_string(count) + (sorted ? " sorted" : " random") +
                     " points, kernels " + batch_detail::kernel_instruction_set(),
                 {{"de Casteljau",
                   [&] {
                     for (const double x : xi) bench::keep(by_de_casteljau(path, x));
                   },
                   items},
                  {"evaluate, one by one",
                   [&] {
                     for (const double x : xi) bench::keep(evaluate(path, x));
                   },
                   items},
                  {"evaluate, batch",
                   [&] {
                     evaluate(path, std::span<const double>(xi),
                              PathStateSpans<A>{positions, frames, rates, speeds, lengths});
                     bench::keep(positions);
                   },
                   items}},
                 count > 100000 ? 7 : 101);
}

}  // namespace

int main() {
  run<8>(1000, 4096, false);
  run<8>(1000, 4096, true);
  run<8>(1000, 1000000, true);
  run<2>(1000, 4096, false);
  run<2>(1000, 1000000, true);
}
