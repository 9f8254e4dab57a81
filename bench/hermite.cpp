// SPDX-License-Identifier: MIT
// How long does a C⁴ Hermite segment take, one by one and in a batch, and a path of 10⁵ of them?
#include "hodograph/construction/hermite.hpp"

#include <cmath>
#include <span>
#include <vector>

#include "../tests/support/curves.hpp"
#include "hodograph/construction/derivative_curve.hpp"
#include "hodograph/construction/detail/hermite_batch.hpp"
#include "support/measure.hpp"
#if defined(HODOGRAPH_HAS_CERTIFY)
#include "hodograph/certify/certified_error.hpp"
#endif

namespace {

using namespace hodograph;
using test::Curve23;  // run through faster for every turn

struct Data {
  std::vector<double> knots, steps;
  std::vector<HermitePoint<4>> points;
};

Data data(std::size_t segments, double end) {
  Data result;
  for (std::size_t k = 0; k <= segments; ++k) {
    result.knots.push_back(end * static_cast<double>(k) / static_cast<double>(segments));
    result.points.push_back(derivatives_of<4, double>(Curve23{}, result.knots.back()));
    if (k > 0) result.steps.push_back(result.knots[k] - result.knots[k - 1]);
  }
  return result;
}

void single_segments() {
  constexpr std::size_t count = 1024;
  const Data d = data(count, 10.0);
  const auto items = static_cast<double>(count);
  const auto one_by_one = [&](HermiteChoice choice) {
    for (std::size_t k = 0; k < count; ++k) {
      bench::keep(hermite_curve<4, double>(d.points[k], d.points[k + 1], d.steps[k], choice));
    }
  };
  std::vector<hermite_detail::Segment<double, 4>> segments(count);
  bench::compare("C4 segment",
                 {{"the same with a differentiating scalar (1 direction)",
                   [&] {
                     using T = Taylor<double, 1>;
                     for (std::size_t k = 0; k < count; ++k) {
                       HermitePoint<4, T> a, b;
                       for (std::size_t r = 0; r <= 4; ++r) {
                         for (std::size_t c = 0; c < 3; ++c) {
                           a[r][c] = T(d.points[k][r][c]);
                           b[r][c] = T(d.points[k + 1][r][c]);
                         }
                       }
                       bench::keep(hermite_curve<4, T>(a, b, T(d.steps[k])));
                     }
                   },
                   items},
                  {"one by one, order_six", [&] { one_by_one(HermiteChoice::order_six); }, items},
                  {"one by one, order_ten", [&] { one_by_one(HermiteChoice::order_ten); }, items},
                  {"batch of preimages, order_ten",
                   [&] {
                     for (std::size_t k = 0; k < count; k += hermite_detail::longest_batch) {
                       hermite_detail::twist_free_segments(&d.points[k], &d.steps[k], 1.0,
                                                           hermite_detail::longest_batch,
                                                           &segments[k]);
                     }
                     bench::keep(segments.back());
                   },
                   items}});
}

void long_path() {
  constexpr std::size_t count = 100000;
  const Data d = data(count, 100.0);
  const auto items = static_cast<double>(count);
  const auto path = hermite_path<4, double>(d.knots, std::span(d.points)).value();
  const auto one_by_one = [&] {
    std::vector<SpatialPhCurve<8>> curves;
    for (std::size_t k = 0; k < count; ++k) {
      curves.push_back(hermite_curve<4, double>(d.points[k], d.points[k + 1], d.steps[k]).value());
    }
    bench::keep(curves.back());
  };
  bench::compare(
      "path of 100000 segments of degree 17, a segment",
      {
        {"curves one by one, no path", one_by_one, items},
            {"hermite_path",
             [&] { bench::keep(hermite_path<4, double>(d.knots, std::span(d.points))); }, items},
#if defined(HODOGRAPH_HAS_CERTIFY)
            {"certified_error of that path", [&] { bench::keep(certified_error(Curve23{}, path)); },
             items},
#endif
      },
      7);
  std::printf("  %.0f bytes a segment beyond its coefficients\n",
              static_cast<double>(path.memory() - path.coefficient_memory()) / items);
}

}  // namespace

int main() {
  single_segments();
  long_path();
}
