// SPDX-License-Identifier: MIT
// Batches on paths of any kind give the bits of batches on paths of static type.
#include "hodograph/frame/any_batch.hpp"

#include <gtest/gtest.h>

#include <cstring>

#include "hodograph/frame/batch.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

template <class T>
void expect_same_bits(const std::vector<double>& flat, const std::vector<T>& items) {
  ASSERT_EQ(flat.size() * sizeof(double), items.size() * sizeof(T));
  EXPECT_EQ(std::memcmp(flat.data(), items.data(), items.size() * sizeof(T)), 0);
}

template <class P>
void expect_same_batches(Random& random) {
  using A = typename P::Algebra;
  const P path = random_path<P>(random, 4);
  const AnyPath any = path;
  constexpr std::size_t count = 100, d = P::Point::dimension;
  std::vector<double> xi(count), s(count);
  for (std::size_t i = 0; i < count; ++i) {
    xi[i] = random.uniform(path.xi_begin(), path.xi_end());
    s[i] = random.uniform(0.0, path.arc_length());
  }
  std::vector<point_t<A>> positions(count), points(count);
  std::vector<frame_t<A>> frames(count);
  std::vector<rate_t<A>> rates(count);
  std::vector<double> speeds(count), lengths(count), parameters(count);
  evaluate(path, std::span<const double>(xi),
           PathStateSpans<A>{positions, frames, rates, speeds, lengths});
  parameters_at_arc_lengths(path, std::span<const double>(s), std::span<double>(parameters));
  points_at_arc_lengths(path, std::span<const double>(s), std::span<point_t<A>>(points));

  std::vector<double> flat_positions(d * count), flat_frames(d * d * count),
      flat_rates(sizeof(rate_t<A>) / sizeof(double) * count), flat_speeds(count),
      flat_lengths(count), flat_parameters(count), flat_points(d * count);
  evaluate(any, xi, {flat_positions, flat_frames, flat_rates, flat_speeds, flat_lengths});
  parameters_at_arc_lengths(any, s, flat_parameters);
  points_at_arc_lengths(any, s, flat_points);
  expect_same_bits(flat_positions, positions);
  expect_same_bits(flat_frames, frames);
  expect_same_bits(flat_rates, rates);
  expect_same_bits(flat_speeds, speeds);
  expect_same_bits(flat_lengths, lengths);
  expect_same_bits(flat_parameters, parameters);
  expect_same_bits(flat_points, points);

  std::vector<PreimageJet<A, 4>> jets(count);
  preimage_jets(any, xi, jets);
  for (std::size_t i = 0; i < count; ++i) {
    EXPECT_EQ(jets[i], path.template preimage_jet<4>(xi[i]));
  }
}

TEST(AnyBatch, GivesTheBitsOfTheStaticType) {
  Random random("batches of any path");
  expect_same_batches<PlanarPath<2>>(random);
  expect_same_batches<SpatialPath<8>>(random);
}

FaultCode code_of(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.fault().code;
  }
  return FaultCode::cancelled;
}

TEST(AnyBatch, RefusesWhatDoesNotFit) {
  Random random("batches that do not fit");
  const AnyPath path = random_path<SpatialPath<2>>(random, 2);
  const std::vector<double> inside{path.xi_begin(), path.xi_end()};
  const std::vector<double> outside{path.xi_begin(), path.xi_end() + 1.0};
  std::vector<double> six(6), seven(7);
  std::vector<PreimageJet<Complex<double>, 4>> planar_jets(2);
  std::vector<PreimageJet<Quaternion<double>, 4>> jets(1);
  EXPECT_EQ(code_of([&] { evaluate(path, inside, {.positions = seven}); }),
            FaultCode::mismatched_size);
  EXPECT_EQ(code_of([&] { evaluate(path, outside, {.positions = six}); }),
            FaultCode::outside_domain);
  EXPECT_EQ(code_of([&] { points_at_arc_lengths(path, outside, six); }), FaultCode::outside_domain);
  EXPECT_EQ(code_of([&] { points_at_arc_lengths(path, std::vector<double>{0.0}, six); }),
            FaultCode::mismatched_size);
  EXPECT_EQ(code_of([&] { preimage_jets(path, inside, planar_jets); }), FaultCode::unsupported);
  EXPECT_EQ(code_of([&] { preimage_jets(path, inside, jets); }), FaultCode::mismatched_size);
}

}  // namespace
}  // namespace hodograph
