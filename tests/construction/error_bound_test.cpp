// SPDX-License-Identifier: MIT
// Bounds of differences of polynomials contain the truth, rounding included, and are sharp.
#include "hodograph/construction/error_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "hodograph/construction/fit.hpp"
#include "hodograph/construction/piecewise_error.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/random.hpp"
#include "tests/support/true_error.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::Wide;

template <class V, std::size_t d>
auto widened_polynomial(const BernsteinPolynomial<V, d>& f) {
  return f.mapped([](const V& c) { return test::widened(c); });
}

/// The largest norm at `samples` + 1 points: a lower bound of the truth.
template <class V, std::size_t d>
Wide sampled_norm(const BernsteinPolynomial<V, d>& f, int samples) {
  const auto wide = widened_polynomial(f);
  Wide largest(0);
  for (int i = 0; i <= samples; ++i) {
    const Wide size = norm(wide.value(Wide(i) / Wide(samples)));
    if (largest < size) largest = size;
  }
  return largest;
}

TEST(LargestNorm, ContainsTheTruth) {
  Random rng("largest norm");
  for (int repeat = 0; repeat < 200; ++repeat) {
    BernsteinPolynomial<Vector3<double>, 17> f;
    // Every third polynomial vanishes to fifth order at both ends, as interpolation errors do.
    const std::size_t margin = repeat % 3 == 0 ? 5 : 0;
    const double scale = repeat % 5 == 0 ? rng.spread(-499, 499) : 1.0;
    for (std::size_t i = margin; i + margin <= 17; ++i) f[i] = rng.vector3(std::abs(scale));
    const NormBound bound = largest_norm(f);
    const Wide seen = sampled_norm(f, 200);
    EXPECT_LE(seen, Wide(bound.norm.upper()));
    EXPECT_GE(norm(widened_polynomial(f).value(Wide(bound.at))), Wide(bound.norm.lower()));
    // 1/64 for the search, and rounding.
    EXPECT_LE(bound.norm.upper(), (1.0 + 1.0 / 60.0) * bound.norm.lower());
  }
}

TEST(LargestNorm, CountsTheRadiusOnBothSides) {
  BernsteinPolynomial<Vector2<double>, 3> f;
  for (std::size_t i = 0; i <= 3; ++i) f[i] = {3.0, 4.0};
  const NormBound bound = largest_norm(f, 2.0);
  EXPECT_LE(bound.norm.lower(), 3.0);
  EXPECT_GE(bound.norm.upper(), 7.0);
  // 2 · roundings(6 · 3 + 6) of 1, scaled by 4 · 2: the noise allowed for.
  EXPECT_CLOSE(bound.norm.lower(), 3.0, 256.0, 1.0);
  EXPECT_CLOSE(bound.norm.upper(), 7.0, 256.0, 1.0);
}

TEST(LargestNorm, HostileCoefficients) {
  const double infinity = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double smallest = std::numeric_limits<double>::denorm_min();
  const double huge = std::numeric_limits<double>::max();
  BernsteinPolynomial<Vector3<double>, 5> f;
  EXPECT_EQ(largest_norm(f).norm, Enclosure(0.0));
  EXPECT_EQ(largest_norm(f, 0.5).norm, Enclosure(0.0, 0.5));
  f[2].y = nan;
  EXPECT_EQ(largest_norm(f).norm, Enclosure(0.0, infinity));
  f[2].y = infinity;
  EXPECT_EQ(largest_norm(f).norm, Enclosure(0.0, infinity));
  f[2].y = smallest;
  EXPECT_GE(largest_norm(f).norm.upper(), smallest);
  EXPECT_EQ(largest_norm(f, infinity).norm, Enclosure(0.0, infinity));
  f[0] = {huge, huge, -huge};  // the norm exceeds the range of double
  EXPECT_EQ(largest_norm(f).norm.upper(), infinity);
  EXPECT_GE(largest_norm(f).norm.lower(), 0.0);
}

TEST(PositionError, CoversStoredAndComputedPositions) {
  Random rng("position error");
  for (int repeat = 0; repeat < 100; ++repeat) {
    BernsteinPolynomial<Quaternion<double>, 8> preimage;
    const double size = std::abs(rng.spread(-20, 20));
    for (std::size_t i = 0; i <= 8; ++i) preimage[i] = rng.quaternion(size);
    const SpatialPhCurve<8> curve(rng.vector3(std::abs(rng.spread(-60, 60))), preimage,
                                  std::abs(rng.spread(-30, 30)));
    const auto exact = test::widened_curve(curve);
    const auto stored = widened_polynomial(curve.displacement());
    const Wide stored_bound(displacement_error(curve)), computed_bound(position_error(curve));
    for (int i = 0; i < 30; ++i) {
      const double u = i == 0 ? 1.0 : rng.unit();
      EXPECT_LE(norm(stored.value(Wide(u)) - exact.displacement().value(Wide(u))), stored_bound);
      EXPECT_LE(norm(test::widened(curve.position(u)) - exact.position(Wide(u))), computed_bound);
    }
  }
}

TEST(ErrorBound, LargerOfTwo) {
  const ErrorBound a{Enclosure(1.0, 2.0), true, 0.25}, b{Enclosure(0.5, 3.0), false, 0.75};
  const ErrorBound both = larger_error(a, b);
  EXPECT_EQ(both.error, Enclosure(1.0, 3.0));
  EXPECT_FALSE(both.certified);
  EXPECT_EQ(both.at_xi, 0.25);
}

// ---- piecewise polynomials
// -------------------------------------------------------------------------

constexpr std::size_t spline_degree = 5;

struct Pieces {
  std::vector<double> knots;
  std::vector<BernsteinPolynomial<Vector3<double>, spline_degree>> pieces;

  Vector3<Wide> operator()(const Wide& xi) const {
    std::size_t j = 0;
    while (j + 1 < pieces.size() && Wide(knots[j + 1]) <= xi) ++j;
    const Wide v = (xi - Wide(knots[j])) / (Wide(knots[j + 1]) - Wide(knots[j]));
    return widened_polynomial(pieces[j]).value(v);
  }
};

/// A path of random segments and pieces that wander about it at the given distance: pieces are the
/// path's own Taylor-like samples, displaced.
struct Case {
  SpatialPath<2> path;
  Pieces gamma;
};

Case random_case(Random& rng, double offset) {
  std::vector<double> knots{rng.uniform(-1.0, 1.0)};
  std::vector<SpatialPhCurve<2>> segments;
  Vector3<double> start = rng.vector3(4.0);
  for (int k = 0; k < 6; ++k) {
    knots.push_back(knots.back() + rng.uniform(0.125, 1.0));
    BernsteinPolynomial<Quaternion<double>, 2> preimage;
    for (std::size_t i = 0; i <= 2; ++i) preimage[i] = rng.quaternion(1.0);
    segments.emplace_back(start, preimage, knots[knots.size() - 1] - knots[knots.size() - 2]);
    start = segments.back().end();
  }
  // The pieces: the quintic displacement itself on the path's own knots, moved by offset; the first
  // and the last reach beyond the path.
  Pieces gamma;
  gamma.knots = knots;
  for (const auto& segment : segments) {
    gamma.pieces.push_back(segment.displacement().mapped(
        [&](const Vector3<double>& c) { return segment.start() + c + rng.vector3(offset); }));
  }
  return {SpatialPath<2>::create(knots, segments, false).value(), gamma};
}

void check(const Pieces& gamma, const SpatialPath<2>& path, double most) {
  const auto bound = piecewise_error<spline_degree>(
      std::span<const double>(gamma.knots),
      std::span<const BernsteinPolynomial<Vector3<double>, spline_degree>>(gamma.pieces), path);
  ASSERT_TRUE(bound.has_value());
  EXPECT_TRUE(bound->certified);
  Wide truth(0);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const Wide here =
        test::true_segment_error(gamma, path.segment(k), path.knots()[k], path.knots()[k + 1], 60);
    if (truth < here) truth = here;
  }
  EXPECT_LE(truth, Wide(bound->error.upper()));
  EXPECT_GE(truth * Wide(1.0 + 1.0 / 32.0), Wide(bound->error.lower()));
  EXPECT_LE(bound->error.upper(), most);
}

TEST(PiecewiseError, SameKnots) {
  Random rng("piecewise error, same knots");
  for (const double offset : {0.5, std::ldexp(1.0, -30), std::ldexp(1.0, -50), 0.0}) {
    const Case c = random_case(rng, offset);
    // √3 of the offset, and rounding of numbers near 16.
    check(c.gamma, c.path, 2.0 * offset + 100.0 * 16.0 * epsilon<double>());
  }
}

TEST(PiecewiseError, DifferentKnots) {
  Random rng("piecewise error, different knots");
  for (int repeat = 0; repeat < 10; ++repeat) {
    const Case c = random_case(rng, 0.0);
    Pieces other;
    other.knots.push_back(c.path.xi_begin() - rng.uniform(0.0, 0.5));
    Vector3<double> last = c.path.segment(0).start();
    while (other.knots.back() < c.path.xi_end()) {
      other.knots.push_back(other.knots.back() + rng.uniform(0.03125, 0.75));
      BernsteinPolynomial<Vector3<double>, spline_degree> piece;
      piece[0] = last;
      for (std::size_t i = 1; i <= spline_degree; ++i) piece[i] = last + rng.vector3(1.0);
      last = piece[spline_degree];
      other.pieces.push_back(piece);
    }
    check(other, c.path, std::numeric_limits<double>::max());
  }
}

TEST(PiecewiseError, RefusesPiecesThatDoNotCoverThePath) {
  Random rng("piecewise error, faults");
  const Case c = random_case(rng, 0.0);
  using Piece = BernsteinPolynomial<Vector3<double>, spline_degree>;
  const auto code = [&](const std::vector<double>& knots, const std::vector<Piece>& pieces) {
    return piecewise_error<spline_degree>(std::span<const double>(knots),
                                          std::span<const Piece>(pieces), c.path)
        .fault()
        .code;
  };
  EXPECT_EQ(code({}, {}), FaultCode::mismatched_size);
  EXPECT_EQ(code({0.0, 1.0, 2.0}, {Piece()}), FaultCode::mismatched_size);
  EXPECT_EQ(code({1.0, 1.0}, {Piece()}), FaultCode::not_increasing);
  EXPECT_EQ(code({50.0, 51.0}, {Piece()}), FaultCode::outside_domain);
  EXPECT_EQ(code({c.path.xi_begin(), std::nextafter(c.path.xi_end(), -100.0)}, {Piece()}),
            FaultCode::outside_domain);
}

TEST(EstimatedError, IsCalledAnEstimate) {
  Random rng("estimated error");
  const Case c = random_case(rng, 0.0);
  const DerivativeCurve gamma = [&](double xi) {
    return HermitePoint<4>{c.path.position(xi) + Vector3<double>{0.0, 0.0, 0.25}};
  };
  const ErrorBound bound =
      estimated_error(gamma, c.path.segment(0).elevated<8>(), c.path.knots()[0], c.path.knots()[1]);
  EXPECT_FALSE(bound.certified);
  EXPECT_LE(std::abs(bound.error.upper() - 0.25), 100.0 * 16.0 * epsilon<double>());
}

}  // namespace
}  // namespace hodograph
