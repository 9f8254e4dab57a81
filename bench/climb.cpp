// SPDX-License-Identifier: MIT
// How long does a climb take, one by one and in batches: the plan of exact length with the best of
// two by exact rotation index, lifted to the spatial curve with its quaternion preimage, against
// the printed formulas (10)-(14), (20), (24) with std::complex and a rotation index by sampling?
#include <complex>

#include "hodograph/construction/climb.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Number = std::complex<double>;

double sampled_index(const std::array<Number, 3>& w) {
  constexpr int steps = 64;
  double sum = 0.0;
  Number before = w[0];
  for (int i = 1; i <= steps; ++i) {
    const double u = static_cast<double>(i) / steps, v = 1.0 - u;
    const Number now = v * v * w[0] + 2.0 * u * v * w[1] + u * u * w[2];
    sum += std::abs(std::arg(now * std::conj(before)));
    before = now;
  }
  return 2.0 * sum;
}

struct PlainClimb {
  std::array<Vector3<double>, 6> control_points;
  std::array<Quaternion<double>, 3> preimage;  // of r' = A k A*
};

/// As the paper prints it, for data in general position.
PlainClimb plain_climb(const ClimbProblem& p) {
  const Number from(p.begin.position.x, p.begin.position.y);
  const Number chord = Number(p.end.position.x, p.end.position.y) - from;
  const double distance = std::abs(chord), gamma = std::arg(chord);
  const auto wrapped = [&](const Vector2<double>& d) {
    return std::arg(Number(d.x, d.y) * std::polar(1.0, -gamma));
  };
  const double first = wrapped(p.begin.heading), last = wrapped(p.end.heading);
  const double slope = std::tan(p.climb_angle);
  const double s = (p.end.position.z - p.begin.position.z) / slope / distance;
  const double ls = std::cos(first / 2), ms = std::sin(first / 2);
  const double le = std::cos(last / 2), me = std::sin(last / 2);
  const double a2 = 2 * (ls * me - le * ms) * (ls * me - le * ms);
  const double a1 = 3 * (2 * (ls * le + ms * me - 3) * s +
                         3 * (ls * ls - ms * ms + le * le - me * me) - 2 * (ls * le - ms * me));
  const double a0 = 36 * (s * s - 1);
  const double z = (-a1 - std::sqrt(a1 * a1 - 4 * a2 * a0)) / (2 * a2), w = std::sqrt(z);
  const double big_p = 60 * (s + 1) - (15 * ls * ls + 15 * le * le - 10 * ls * le) * z;
  const double big_q = 60 * (s - 1) - (15 * ms * ms + 15 * me * me - 10 * ms * me) * z;
  const double sign = (ls * me + le * ms - 3 * ls * ms - 3 * le * me) < 0 ? -1.0 : 1.0;
  std::array<Number, 3> best{};
  double least = 1e300;
  for (const double alpha : {1.0, -1.0}) {
    const double u = (-3 * (ls + le) * w + alpha * std::sqrt(std::max(0.0, big_p))) / 4;
    const double v = (-3 * (ms + me) * w + alpha * sign * std::sqrt(std::max(0.0, big_q))) / 4;
    const std::array<Number, 3> one{w * Number(ls, ms), Number(u, v), w * Number(le, me)};
    const double index = sampled_index(one);
    if (index < least) {
      least = index;
      best = one;
    }
  }
  for (Number& x : best) x *= std::polar(std::sqrt(distance), gamma / 2);
  const auto& [w0, w1, w2] = best;
  const Number steps[5] = {w0 * w0, w0 * w1, (2.0 * w1 * w1 + w0 * w2) / 3.0, w1 * w2, w2 * w2};
  const double speeds[5] = {std::norm(w0), (std::conj(w0) * w1).real(),
                            (2 * std::norm(w1) + (std::conj(w0) * w2).real()) / 3,
                            (std::conj(w1) * w2).real(), std::norm(w2)};
  PlainClimb result;
  result.control_points[0] = p.begin.position;
  for (std::size_t k = 0; k < 5; ++k) {
    result.control_points[k + 1] =
        result.control_points[k] +
        Vector3<double>{steps[k].real() / 5, steps[k].imag() / 5, speeds[k] / 5 * slope};
  }
  const double f = std::sqrt((slope + 1 / std::cos(p.climb_angle)) / 2);
  for (std::size_t k = 0; k < 3; ++k) {
    const double a = best[k].real(), b = best[k].imag();
    result.preimage[k] = {f * a, -b / (2 * f), a / (2 * f), f * b};
  }
  return result;
}

}  // namespace

int main() {
  constexpr std::size_t count = 4096;
  bench::Numbers numbers;
  const auto point = [&] {
    return Vector3<double>{numbers.within(-1, 1), numbers.within(-1, 1), numbers.within(-1, 1)};
  };
  std::vector<ClimbProblem> problems(count);
  for (ClimbProblem& p : problems) {
    p.begin = {point(), direction_of_angle(numbers.within(-3, 3))};
    p.end = {point(), direction_of_angle(numbers.within(-3, 3))};
    const Vector3<double> way = p.end.position - p.begin.position;
    p.climb_angle =
        std::atan(way.z / (numbers.within(1.05, 2.0) * std::sqrt(way.x * way.x + way.y * way.y)));
  }
  std::vector<ClimbAnswer> answers(count);
  bench::compare(
      "climb, best of two, kernels " + std::string(batch_detail::kernel_instruction_set()),
      {{"std::complex as printed, index by 64 samples",
        [&] {
          for (const auto& p : problems) bench::keep(plain_climb(p));
        },
        count},
       {"one by one, with the curve",
        [&] {
          for (const auto& p : problems) {
            bench::keep(climb_curve(p.begin, p.end, p.climb_angle));
          }
        },
        count},
       {"batch, preimages",
        [&] {
          bench::keep(climb_curves(problems, answers));
          bench::keep(answers);
        },
        count}},
      51);
}
