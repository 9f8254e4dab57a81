// SPDX-License-Identifier: MIT
// How long do the planar constructions take, one by one and in batches: C¹ Hermite with the best of
// four solutions, and prescribed length with the best of two, by exact rotation index, against the
// published formulas with std::complex and a rotation index by sampling?
#include <complex>
#include <numbers>

#include "hodograph/construction/planar_hermite.hpp"
#include "hodograph/construction/prescribed_length.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Number = std::complex<double>;

/// Twice the sum of |Δ arg w| over 64 steps.
double sampled_index(const Number& w0, const Number& w1, const Number& w2) {
  constexpr int steps = 64;
  double sum = 0.0;
  Number before = w0;
  for (int i = 1; i <= steps; ++i) {
    const double u = static_cast<double>(i) / steps, v = 1.0 - u;
    const Number w = v * v * w0 + 2.0 * u * v * w1 + u * u * w2;
    sum += std::abs(std::arg(w * std::conj(before)));
    before = w;
  }
  return 2.0 * sum;
}

std::array<Number, 3> plain_hermite(const PlanarHermiteProblem& p) {
  const auto number = [](const Vector2<double>& v) { return Number(v.x, v.y); };
  const Number d0 = number(p.begin.derivative), d1 = number(p.end.derivative);
  const Number v = number(p.end.position - p.begin.position) / p.step;
  const Number w0 = std::sqrt(d0);
  std::array<Number, 3> best{};
  double least = 1e300;
  for (const double sign : {1.0, -1.0}) {
    const Number w2 = sign * std::sqrt(d1);
    const Number root = std::sqrt(120.0 * v - 15.0 * (d0 + d1) + 10.0 * w0 * w2);
    for (const double side : {1.0, -1.0}) {
      const Number w1 = 0.25 * (-3.0 * (w0 + w2) + side * root);
      const double index = sampled_index(w0, w1, w2);
      if (index < least) {
        least = index;
        best = {w0, w1, w2};
      }
    }
  }
  return best;
}

}  // namespace

int main() {
  constexpr std::size_t count = 4096;
  bench::Numbers numbers;
  const auto vector = [&] { return Vector2<double>{numbers.within(-1, 1), numbers.within(-1, 1)}; };
  std::vector<PlanarHermiteProblem> hermite(count);
  std::vector<PrescribedLengthProblem> lengths(count);
  for (std::size_t i = 0; i < count; ++i) {
    hermite[i] = {{vector(), vector()}, {vector(), vector()}, 1.0};
    lengths[i].begin = {vector(), direction_of_angle(numbers.within(-3, 3))};
    lengths[i].end = {vector(), direction_of_angle(numbers.within(-3, 3))};
    lengths[i].length =
        numbers.within(1.05, 2.0) * norm(lengths[i].end.position - lengths[i].begin.position);
  }
  std::vector<PlanarHermiteAnswer> answers(count);
  const std::string kernels = std::string(", kernels ") + batch_detail::kernel_instruction_set();
  bench::compare("C1 Hermite, best of four" + kernels,
                 {{"std::complex, index by 64 samples",
                   [&] {
                     for (const auto& p : hermite) bench::keep(plain_hermite(p));
                   },
                   count},
                  {"one by one, with the curve",
                   [&] {
                     for (const auto& p : hermite) bench::keep(planar_hermite(p.begin, p.end));
                   },
                   count},
                  {"batch, preimages",
                   [&] {
                     bench::keep(planar_hermite(hermite, answers));
                     bench::keep(answers);
                   },
                   count}},
                 51);
  bench::compare("prescribed length, best of two" + kernels,
                 {{"one by one, with the curve",
                   [&] {
                     for (const auto& p : lengths) {
                       bench::keep(prescribed_length_curve(p.begin, p.end, p.length));
                     }
                   },
                   count},
                  {"batch, preimages",
                   [&] {
                     bench::keep(prescribed_length_curves(lengths, answers));
                     bench::keep(answers);
                   },
                   count}},
                 51);
}
