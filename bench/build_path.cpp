// SPDX-License-Identifier: MIT
// How long does it take to build a curve from its preimage and a path from its curves, and how many
// bytes does a segment need?
#include "support/measure.hpp"

namespace {

using namespace hodograph;

/// The plain way: the two full products, each with its own antiderivative.
template <std::size_t n>
auto by_two_products(const BernsteinPolynomial<Quaternion<double>, n>& a, double h) {
  using A = Quaternion<double>;
  return std::pair{
      h * product(a, a, [](const A& x, const A& y) { return hodograph_form(x, y); })
              .antiderivative(),
      h * product(a, a, [](const A& x, const A& y) { return speed_form(x, y); }).antiderivative()};
}

template <std::size_t n>
void run() {
  constexpr std::size_t count = 10000;
  const auto path = bench::random_path<n>(count, 0.3);
  std::vector<BernsteinPolynomial<Quaternion<double>, n>> preimages;
  for (const auto& curve : path.segments()) preimages.push_back(curve.preimage());
  const auto items = static_cast<double>(count);
  bench::compare(
      "degree " + std::to_string(2 * n + 1) + ", a segment",
      {{"two full products",
        [&] {
          for (const auto& a : preimages) bench::keep(by_two_products(a, 1.25));
        },
        items},
       {"PhCurve",
        [&] {
          for (const auto& a : preimages) bench::keep(SpatialPhCurve<n>({}, a, 1.25));
        },
        items},
       {"Path::create from curves",
        [&] { bench::keep(SpatialPath<n>::create(path.knots(), path.segments(), false)); }, items}},
      21);
  const auto total = static_cast<double>(path.memory()) / items;
  const auto coefficients = static_cast<double>(path.coefficient_memory()) / items;
  std::printf("  %.0f bytes a segment, %.0f of them coefficients, %.0f beyond\n\n", total,
              coefficients, total - coefficients);
}

}  // namespace

int main() {
  run<8>();
  run<4>();
  run<2>();
}
