// SPDX-License-Identifier: MIT
// Bounds of paths: no value of the exact curve, by ball arithmetic, is outside them.
#include "hodograph/path/bounds.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "hodograph/curve/preimage_jet.hpp"
#include "support/arb_judge.hpp"
#include "support/random.hpp"

namespace hodograph {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// The width asked for in these tests: 24 bits.
constexpr RangeGoal goal{std::numeric_limits<float>::epsilon()};

/// A path of segments with random preimages, joined in position.
template <class A, std::size_t n>
Path<A, n> random_path(test::Random& random, std::size_t count, double scale = 1.0) {
  std::vector<double> knots{random.uniform(-2.0, 2.0)};
  std::vector<PhCurve<A, n>> segments;
  auto start = random.components<point_t<A>>(scale * scale);
  for (std::size_t k = 0; k < count; ++k) {
    BernsteinPolynomial<A, n> preimage;
    for (std::size_t i = 0; i <= n; ++i) preimage[i] = random.components<A>(scale);
    knots.push_back(knots.back() + random.uniform(0.01, 2.0));
    segments.push_back({start, preimage, knots[k + 1] - knots[k]});
    start = segments.back().end();
  }
  return Path<A, n>::create(std::move(knots), std::move(segments), false).value();
}

TEST(PathBounds, OfAStraightLineAreExact) {
  // w = 2: a line along x of speed 4.
  const auto path =
      PlanarPath<0>::create(
          {0.0, 3.0}, {{{1.0, -1.0}, PlanarPhCurve<0>::Preimage({Complex<double>{2.0, 0.0}}), 3.0}},
          false)
          .value();
  EXPECT_TRUE(arc_length_enclosure(path).contains(12.0));
  const Extremes speed = speed_extremes(path, goal);
  EXPECT_TRUE(speed.minimum.contains(4.0) && speed.maximum.contains(4.0));
  EXPECT_EQ(curvature_extremes(path, goal).range(), Enclosure(0.0));
  const auto box = bounding_box(path, goal);
  EXPECT_TRUE(box[0].minimum.contains(1.0) && box[0].maximum.contains(13.0));
  EXPECT_EQ(box[1].range(), Enclosure(-1.0));
}

TEST(PathBounds, AreInfiniteAtACusp) {
  // w = u - 1/2 + 0i and a turn of it: σ = 0 at the middle.
  const Complex<double> a{-0.5, -0.25}, b{0.5, 0.25};
  const auto path = PlanarPath<1>::create(
                        {0.0, 1.0}, {{{0.0, 0.0}, PlanarPhCurve<1>::Preimage({a, b}), 1.0}}, false)
                        .value();
  const Extremes speed = speed_extremes(path, goal);
  EXPECT_LE(speed.minimum.lower(), 0.0);
  EXPECT_EQ(curvature_extremes(path, goal).maximum.upper(), infinity);
  EXPECT_EQ(angular_rate_extremes_per_xi(path, goal).maximum.upper(), infinity);
  // A path that stands still.
  const auto point = SpatialPath<1>::create({0.0, 1.0}, {SpatialPhCurve<1>()}, false).value();
  EXPECT_EQ(arc_length_enclosure(point), Enclosure(0.0));
  EXPECT_EQ(curvature_extremes(point, goal).maximum.upper(), infinity);
}

TEST(PathBounds, KnowTheCurvatureOfAParabola) {
  // w = 1 + i u: r' = (1 - u², 2u), σ = 1 + u², κ = 2/(1 + u²)².
  const auto path =
      PlanarPath<1>::create(
          {0.0, 1.0},
          {{{0.0, 0.0}, PlanarPhCurve<1>::Preimage({Complex<double>{1.0, 0.0}, {1.0, 1.0}}), 1.0}},
          false)
          .value();
  const Extremes kappa = curvature_extremes(path, goal);
  EXPECT_TRUE(kappa.maximum.contains(2.0));
  EXPECT_TRUE(kappa.minimum.contains(0.5));
  EXPECT_LT(kappa.range().width(), 1.5 * (1 + 2 * goal.relative_width));
  EXPECT_TRUE(angular_rate_extremes_per_xi(path, goal).minimum.contains(1.0));
}

#if HODOGRAPH_TEST_HAS_ARB

using test::encloses;
using test::Judge;

template <class V>
struct Judged;
template <>
struct Judged<Complex<double>> {
  using type = Complex<Judge>;
};
template <>
struct Judged<Quaternion<double>> {
  using type = Quaternion<Judge>;
};

/// The exact curve at u: the preimage and its derivative with respect to ξ.
template <class A, std::size_t n>
std::array<typename Judged<A>::type, 2> exact_jet(const PhCurve<A, n>& curve, double u) {
  using B = typename Judged<A>::type;
  const Judge t(u), v = Judge(1.0) - t;
  std::vector<B> point(n + 1);
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j < A::dimension; ++j) point[i][j] = Judge(curve.preimage()[i][j]);
  }
  B derivative{};
  for (std::size_t left = n; left > 0; --left) {
    if (left == 1) {
      derivative =
          (Judge(static_cast<double>(n)) / Judge(curve.parameter_step())) * (point[1] - point[0]);
    }
    for (std::size_t i = 0; i < left; ++i) point[i] = v * point[i] + t * point[i + 1];
  }
  return {point[0], derivative};
}

/// Whether x may lie between the enclosed minimum and maximum.
void expect_within(const Extremes& extremes, const Judge& x) {
  EXPECT_TRUE(encloses(extremes.range(), x));
}

/// The minimum and maximum as enclosed must not exclude the values found on a grid either.
template <class A, std::size_t n>
void check(const Path<A, n>& path) {
  const Extremes speed = speed_extremes(path, goal), kappa = curvature_extremes(path, goal);
  const Extremes per_xi = angular_rate_extremes_per_xi(path, goal);
  const Extremes per_length = angular_rate_extremes_per_arc_length(path, goal);
  const auto box = bounding_box(path, goal);
  double least_speed = infinity, greatest_curvature = 0.0, greatest_rate = 0.0;
  for (const auto& curve : path.segments()) {
    constexpr int grid = 64;
    for (int i = 0; i <= grid; ++i) {
      const auto jet = exact_jet(curve, static_cast<double>(i) / grid);
      const Judge sigma = speed_form(jet[0], jet[0]);
      const auto rate = body_rate_form(jet[0], jet[1]);
      expect_within(speed, sigma);
      least_speed = std::min(least_speed, sigma.approximately());
      Judge bend, turn;
      if constexpr (A::dimension == 2) {
        bend = Judge(2.0) * rate / (sigma * sigma);
        turn = abs(Judge(2.0) * rate / sigma);
      } else {
        bend = Judge(2.0) * sqrt(rate.y * rate.y + rate.z * rate.z) / (sigma * sigma);
        turn = Judge(2.0) * norm(rate) / sigma;
      }
      expect_within(kappa, bend);
      expect_within(per_xi, turn);
      expect_within(per_length, turn / sigma);
      greatest_curvature = std::max(greatest_curvature, bend.approximately());
      greatest_rate = std::max(greatest_rate, turn.approximately());
    }
    // Positions at the ends of the segment, exactly.
    for (std::size_t j = 0; j < box.size(); ++j) {
      expect_within(box[j], Judge(curve.start()[j]));
    }
  }
  // The ends that say how far the extremes are reached.
  EXPECT_LE(speed.minimum.lower(), least_speed);
  EXPECT_GE(least_speed * (1 + goal.relative_width), speed.minimum.lower());
  EXPECT_LE(kappa.maximum.lower(), kappa.maximum.upper());
  EXPECT_GE(kappa.maximum.upper(), greatest_curvature * (1 - goal.relative_width));
  EXPECT_GE(per_xi.maximum.upper(), greatest_rate * (1 - goal.relative_width));
  if (speed.minimum.lower() > 0.0) {
    const auto refined = [](const Enclosure& e) {
      return e.width() <= 2 * goal.relative_width * e.magnitude();
    };
    EXPECT_TRUE(refined(speed.minimum) && refined(speed.maximum));
    EXPECT_TRUE(refined(kappa.maximum));
    EXPECT_TRUE(refined(per_xi.maximum) && refined(per_length.maximum));
  }
}

/// The exact arc length by Judge arithmetic: mean of the coefficients of |A|².
template <class A, std::size_t n>
Judge exact_length(const Path<A, n>& path) {
  Judge total(0.0);
  for (const auto& curve : path.segments()) {
    Judge mean(0.0);
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j <= n; ++j) {
        const Judge weight = Judge(static_cast<double>(binomial(n, i) * binomial(n, j))) /
                             Judge(static_cast<double>(binomial(2 * n, i + j)));
        for (std::size_t d = 0; d < A::dimension; ++d) {
          mean = mean + weight * (Judge(curve.preimage()[i][d]) * Judge(curve.preimage()[j][d]));
        }
      }
    }
    total = total + Judge(curve.parameter_step()) * mean / Judge(2.0 * n + 1.0);
  }
  return total;
}

TEST(PathBounds, HoldOnRandomPaths) {
  test::Random random("bounds: random paths");
  for (int i = 0; i < 6; ++i) {
    check(random_path<Complex<double>, 2>(random, 4));
    check(random_path<Complex<double>, 5>(random, 3));
    check(random_path<Quaternion<double>, 1>(random, 4));
    check(random_path<Quaternion<double>, 4>(random, 3));
    check(random_path<Quaternion<double>, 8>(random, 2));
  }
}

TEST(PathBounds, EncloseTheArcLengthTightly) {
  test::Random random("bounds: arc length");
  constexpr double ulp = std::numeric_limits<double>::epsilon();
  for (const std::size_t count : {1u, 3u, 200u}) {
    const auto path = random_path<Quaternion<double>, 8>(random, count);
    const Enclosure length = arc_length_enclosure(path);
    EXPECT_TRUE(encloses(length, exact_length(path)));
    EXPECT_LT(length.width(), 256 * ulp * length.magnitude());
    EXPECT_LT(std::abs(length.middle() - path.arc_length()), 256 * ulp * path.arc_length());
  }
}

TEST(PathBounds, HoldAtEveryScale) {
  test::Random random("bounds: scales");
  for (const double scale : {1e-75, 1e75, 1e-40, 1e40}) {  // not a tolerance: sizes of preimages
    const auto path = random_path<Quaternion<double>, 3>(random, 2, scale);
    const Extremes kappa = curvature_extremes(path, goal);
    EXPECT_TRUE(kappa.maximum.is_bounded()) << scale;
    EXPECT_TRUE(encloses(arc_length_enclosure(path), exact_length(path))) << scale;
    check(path);
  }
}

TEST(PathBounds, HoldOnHostilePreimages) {
  test::Random random("bounds: hostile preimages");
  for (int i = 0; i < 300; ++i) {
    SpatialPhCurve<2>::Preimage preimage;
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t j = 0; j < 4; ++j) {
        preimage[k][j] = random.chance(0.3) ? random.hostile() : random.uniform(-1.0, 1.0);
      }
    }
    const double step = std::exp2(random.uniform(-60.0, 60.0));
    const auto made = SpatialPath<2>::create({0.0, step}, {{{}, preimage, step}}, false);
    if (!made) continue;
    const Extremes speed = speed_extremes(*made, goal), kappa = curvature_extremes(*made, goal);
    const Extremes rate = angular_rate_extremes_per_xi(*made, goal);
    EXPECT_TRUE(encloses(arc_length_enclosure(*made), exact_length(*made)));
    for (int k = 0; k <= 16; ++k) {
      const auto jet = exact_jet(made->segment(0), k / 16.0);
      const Judge sigma = speed_form(jet[0], jet[0]);
      const auto v = body_rate_form(jet[0], jet[1]);
      expect_within(speed, sigma);
      if (!(Judge(0.0) < sigma)) continue;
      expect_within(kappa, Judge(2.0) * sqrt(v.y * v.y + v.z * v.z) / (sigma * sigma));
      expect_within(rate, Judge(2.0) * norm(v) / sigma);
    }
  }
}

#endif  // HODOGRAPH_TEST_HAS_ARB

}  // namespace
}  // namespace hodograph
