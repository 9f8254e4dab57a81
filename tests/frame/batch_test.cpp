// SPDX-License-Identifier: MIT
// Batches: the same bits as single values, nothing written on bad input, nothing allocated.
#include "hodograph/frame/batch.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <new>
#include <vector>

#include "tests/support/random.hpp"

namespace {
std::atomic<long> allocations{0};
}

// Counts every allocation of this program. The sanitizers bring their own operator new.
#if !defined(__SANITIZE_ADDRESS__)
[[gnu::noinline]] void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
#endif

namespace hodograph {
namespace {

using test::Random;

template <class A, std::size_t n>
Path<A, n> random_path(Random& random, std::size_t count, double wildness) {
  using S = typename A::Scalar;
  std::vector<S> knots{S(0)};
  std::vector<PhCurve<A, n>> segments;
  point_t<A> start{};
  for (std::size_t k = 0; k < count; ++k) {
    BernsteinPolynomial<A, n> preimage;
    for (std::size_t i = 0; i <= n; ++i) {
      for (std::size_t j = 0; j < A::dimension; ++j) {
        preimage[i][j] = S((j == 0 ? 1.0 : 0.0) + random.uniform(-wildness, wildness));
      }
    }
    knots.push_back(knots.back() + S(random.uniform(0.25, 2.0)));
    segments.emplace_back(start, preimage, knots[k + 1] - knots[k]);
    start = segments.back().end();
  }
  return Path<A, n>::create(knots, segments, false).value();
}

/// Sorted in part, shuffled in part, knots and both ends included.
std::vector<double> places(Random& random, const std::vector<double>& knots, std::size_t count) {
  std::vector<double> x(knots);
  while (x.size() < count) x.push_back(random.uniform(knots.front(), knots.back()));
  std::sort(x.begin(), x.end());
  for (std::size_t i = 0; i < count / 2; ++i) std::swap(x[i], x[random.index(count / 2)]);
  return x;
}

template <class A, std::size_t n>
void check_bits(Random& random, double wildness) {
  const auto path = random_path<A, n>(random, 9, wildness);
  for (const std::size_t count : {10UL, 37UL, 1500UL}) {
    const std::vector<double> xi = places(random, path.knots(), count);
    std::vector<point_t<A>> positions(count), only_positions(count), points(count);
    std::vector<frame_t<A>> frames(count);
    std::vector<rate_t<A>> rates(count);
    std::vector<double> speeds(count), lengths(count), only_lengths(count), parameters(count);
    evaluate(path, std::span<const double>(xi),
             PathStateSpans<A>{positions, frames, rates, speeds, lengths});
    evaluate(path, std::span<const double>(xi),
             PathStateSpans<A>{.positions = only_positions, .arc_lengths = only_lengths});
    const std::vector<double> s = places(random, path.knot_arc_lengths(), count);
    points_at_arc_lengths(path, std::span<const double>(s), std::span<point_t<A>>(points));
    parameters_at_arc_lengths(path, std::span<const double>(s), std::span<double>(parameters));
    for (std::size_t i = 0; i < count; ++i) {
      const PathState<A> state = evaluate(path, xi[i]);
      ASSERT_EQ(positions[i], state.position) << i;
      ASSERT_EQ(frames[i], state.frame) << i;
      ASSERT_EQ(rates[i], state.body_rate_per_xi) << i;
      ASSERT_EQ(speeds[i], state.speed) << i;
      ASSERT_EQ(lengths[i], state.arc_length) << i;
      ASSERT_EQ(only_positions[i], state.position) << i;
      ASSERT_EQ(only_lengths[i], state.arc_length) << i;
      ASSERT_EQ(points[i], point_at_arc_length(path, s[i])) << i;
      ASSERT_EQ(parameters[i], parameter_at_arc_length(path, s[i])) << i;
    }
  }
}

TEST(Batch, SameBitsAsSingleValues) {
  Random random("batch bits");
  for (const double wildness : {0.05, 0.4, 2.0}) {
    check_bits<Quaternion<double>, 8>(random, wildness);
    check_bits<Quaternion<double>, 4>(random, wildness);
    check_bits<Quaternion<double>, 3>(random, wildness);
    check_bits<Quaternion<double>, 2>(random, wildness);
    check_bits<Quaternion<double>, 1>(random, wildness);
    check_bits<Quaternion<double>, 5>(random, wildness);  // no kernel of this degree
    check_bits<Complex<double>, 1>(random, wildness);
    check_bits<Complex<double>, 2>(random, wildness);
    check_bits<Complex<double>, 3>(random, wildness);
    check_bits<Complex<double>, 4>(random, wildness);
  }
}

TEST(Batch, OtherScalarsGoOneByOne) {
  Random random("batch long double");
  const auto path = random_path<Quaternion<long double>, 2>(random, 3, 0.3);
  const std::vector<long double> xi(20, path.xi_end() / 3);
  std::vector<long double> speeds(20);
  evaluate(path, std::span<const long double>(xi),
           PathStateSpans<Quaternion<long double>>{.speeds = speeds});
  EXPECT_EQ(speeds[7], evaluate(path, xi[7]).speed);
}

TEST(Batch, ChecksAllInputBeforeWriting) {
  Random random("batch input");
  const auto path = random_path<Quaternion<double>, 2>(random, 3, 0.3);
  for (const double wrong :
       {-1.0, 2.0 * path.xi_end() + 1.0, std::numeric_limits<double>::quiet_NaN()}) {
    std::vector<double> xi(40, 0.5 * path.xi_end());
    xi[39] = wrong;
    std::vector<double> speeds(40, -7.0);
    try {
      evaluate(path, std::span<const double>(xi),
               PathStateSpans<Quaternion<double>>{.speeds = speeds});
      FAIL();
    } catch (const Error& error) {
      EXPECT_EQ(error.fault().code, FaultCode::outside_domain);
      EXPECT_EQ(error.fault().index, 39U);
    }
    EXPECT_EQ(speeds, std::vector<double>(40, -7.0));
    EXPECT_THROW(
        parameters_at_arc_lengths(path, std::span<const double>(xi), std::span<double>(speeds)),
        Error);
    EXPECT_EQ(speeds, std::vector<double>(40, -7.0));
  }
  const std::vector<double> xi(40, 0.5 * path.xi_end());
  std::vector<double> short_span(39, -7.0);
  try {
    evaluate(path, std::span<const double>(xi),
             PathStateSpans<Quaternion<double>>{.speeds = short_span});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().code, FaultCode::mismatched_size);
  }
  EXPECT_EQ(short_span, std::vector<double>(39, -7.0));
}

TEST(Batch, NoFrameWhereThePathStandsStill) {
  BernsteinPolynomial<Quaternion<double>, 2> preimage;  // (2u - 1) in degree 2
  preimage[0].w = -1.0;
  preimage[2].w = 1.0;
  const auto path =
      Path<Quaternion<double>, 2>::create({0.0, 1.0}, {{{}, preimage, 1.0}}, false).value();
  const std::vector<double> xi{0.25, 0.375, 0.5, 0.625, 0.75};
  std::vector<Frame3<double>> frames(5);
  std::vector<double> speeds(5);
  try {
    evaluate(path, std::span<const double>(xi),
             PathStateSpans<Quaternion<double>>{.frames = frames});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.fault().code, FaultCode::zero_speed);
  }
  evaluate(path, std::span<const double>(xi), PathStateSpans<Quaternion<double>>{.speeds = speeds});
  EXPECT_EQ(speeds[2], 0.0);
}

TEST(Batch, AllocatesNothing) {
  Random random("batch allocations");
  const auto path = random_path<Quaternion<double>, 8>(random, 20, 0.4);
  const std::vector<double> xi = places(random, path.knots(), 2000);
  const std::vector<double> s = places(random, path.knot_arc_lengths(), 2000);
  std::vector<Vector3<double>> points(2000);
  std::vector<Frame3<double>> frames(2000);
  std::vector<double> parameters(2000);
  const long before = allocations;
  evaluate(path, std::span<const double>(xi),
           PathStateSpans<Quaternion<double>>{.positions = points, .frames = frames});
  points_at_arc_lengths(path, std::span<const double>(s), std::span<Vector3<double>>(points));
  parameters_at_arc_lengths(path, std::span<const double>(s), std::span<double>(parameters));
  EXPECT_EQ(allocations, before);
}

/// One evaluation on a wild segment is within 16 units in the last place of the position: of its
/// largest coordinate or, where the path passes close by its start, of the largest control value.
TEST(Evaluation, SixteenUlpsOnAWildSegment) {
  using Multi = boost::multiprecision::cpp_bin_float_50;
  Random random("wild segments");
  for (int round = 0; round < 60; ++round) {
    BernsteinPolynomial<Quaternion<double>, 8> preimage;
    BernsteinPolynomial<Quaternion<Multi>, 8> exact_preimage;
    for (std::size_t i = 0; i <= 8; ++i) {
      preimage[i] = random.quaternion(std::ldexp(1.0, static_cast<int>(random.integer(-2, 3))));
      for (std::size_t j = 0; j < 4; ++j) exact_preimage[i][j] = Multi(preimage[i][j]);
    }
    const PhCurve<Quaternion<double>, 8> curve({}, preimage, 1.0);
    const PhCurve<Quaternion<Multi>, 8> exact({}, exact_preimage, Multi(1));
    double largest = 0.0;
    for (const auto& c : curve.integral().coefficients()) {
      largest = std::max(largest, largest_component(c.displacement));
    }
    for (int i = 0; i < 50; ++i) {
      const double u = random.unit();
      const Vector3<double> computed = curve.evaluate(u).integral.displacement;
      const Vector3<Multi> truth = exact.position(Multi(u));
      for (std::size_t j = 0; j < 3; ++j) {
        const double error = std::abs(static_cast<double>(Multi(computed[j]) - truth[j]));
        EXPECT_LE(error, 16 * epsilon<double>() / 2 * largest);
      }
    }
  }
}

}  // namespace
}  // namespace hodograph
