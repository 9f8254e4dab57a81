// SPDX-License-Identifier: MIT
// How long does the bending energy of a planar quintic take, in double precision and enclosed,
// against Gauss-Legendre quadrature with 64 nodes?
#include <cmath>

#include "hodograph/path/bending_energy.hpp"
#include "support/measure.hpp"

namespace {

using namespace hodograph;
using Curve = PlanarPhCurve<2>;

/// 64 evaluations of the integrand, at points that need not be the nodes: the time is the same.
double by_64_nodes(const Curve& curve) {
  const auto& w = curve.preimage();
  double sum = 0.0;
  for (int i = 0; i < 64; ++i) {
    const double u = (i + 0.5) / 64, v = 1.0 - u;
    const auto left = v * w[0] + u * w[1], right = v * w[1] + u * w[2];
    const auto value = v * left + u * right, rate = 2.0 * (right - left);
    const double speed = dot(value, value), h = value.re * rate.im - value.im * rate.re;
    sum += 4.0 * h * h / (speed * speed * speed);
  }
  return sum / 64;
}

void run(double wildness) {
  const auto curves = bench::random_quintics(1000, wildness);
  const auto all = [&](const auto& energy) {
    return [&curves, energy] {
      for (const Curve& curve : curves) bench::keep(energy(curve));
    };
  };
  const auto items = static_cast<double>(curves.size());
  bench::compare("quintics of wildness " + std::to_string(wildness),
                 {{"64 nodes", all([](const Curve& c) { return by_64_nodes(c); }), items},
                  {"bending_energy", all([](const Curve& c) { return bending_energy(c); }), items},
                  {"bending_energy_enclosure",
                   all([](const Curve& c) { return bending_energy_enclosure(c); }), items}});
}

}  // namespace

int main() {
  run(0.3);
  run(0.6);
  run(1.0);
}
