// SPDX-License-Identifier: MIT
// Operations on paths of any kind are those on paths of static type, and refuse what those cannot
// be called with.
#include "hodograph/path/any_operations.hpp"

#include <gtest/gtest.h>

#include <array>

#include "hodograph/path/operations.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

/// The same bits, or the same fault.
template <class P>
void expect_same(const Result<AnyPath>& any, const Result<P>& known) {
  ASSERT_EQ(any.has_value(), known.has_value());
  if (known) {
    EXPECT_TRUE(*any == AnyPath(*known));
  } else {
    EXPECT_EQ(any.fault().sentence, known.fault().sentence);
  }
}

template <class P>
void expect_same_operations(Random& random) {
  const P path = random_path<P>(random, 3);
  const AnyPath any = path;
  const double a = path.knots()[0], b = path.knots()[3];
  const double from = 0.75 * a + 0.25 * b, to = 0.25 * a + 0.75 * b;
  expect_same(reversed(any), reversed(path));
  expect_same(subpath(any, from, to), subpath(path, from, to));
  expect_same(subpath(any, to, from), subpath(path, to, from));
  expect_same(joined(any, any), joined(path, path));
  const auto first = subpath(path, a, from).value(), second = subpath(path, from, b).value();
  expect_same(joined(AnyPath(first), AnyPath(second)), joined(first, second));
  expect_same(with_closure(any, true), with_closure(path, true));
  expect_same(reparametrised(any, -1.0, 5.0), reparametrised(path, -1.0, 5.0));
  expect_same(scaled(any, 3.0), scaled(path, 3.0));
  expect_same(scaled(any, -3.0), scaled(path, -3.0));
  typename P::Point normal{}, point{};
  normal[0] = 1.0, normal[1] = -2.0, point[1] = 4.0;
  constexpr std::size_t d = P::Point::dimension;
  expect_same(reflected(any, {&normal[0], d}, {&point[0], d}), reflected(path, normal, point));
}

TEST(AnyOperations, AreThoseOfTheStaticType) {
  Random random("operations on any path");
  expect_same_operations<PlanarPath<2>>(random);
  expect_same_operations<SpatialPath<4>>(random);
}

TEST(AnyOperations, OfThePlaneAndOfSpace) {
  Random random("operations of the plane and of space");
  const auto planar = random_path<PlanarPath<2>>(random, 2);
  const auto spatial = random_path<SpatialPath<2>>(random, 2);
  const Quaternion<double> turn{0.5, 0.5, -0.5, 0.5};
  expect_same(lifted(AnyPath(planar)), lifted(planar));
  expect_same(moved(AnyPath(planar), 0.5, {1.0, 2.0}), moved(planar, 0.5, {1.0, 2.0}));
  expect_same(moved(AnyPath(spatial), turn, {1.0, 2.0, 3.0}),
              moved(spatial, turn, Vector3<double>{1.0, 2.0, 3.0}));
}

TEST(AnyOperations, RaiseDegreesToMeet) {
  Random random("joined in different degrees");
  const auto path = random_path<SpatialPath<2>>(random, 2);
  const double middle = path.knots()[1];
  const AnyPath first =
      with_preimage_degree(subpath(AnyPath(path), path.xi_begin(), middle).value(), std::size_t{5})
          .value();
  const AnyPath second = subpath(AnyPath(path), middle, path.xi_end()).value();
  EXPECT_EQ(first.preimage_degree(), 5U);
  const auto whole = joined(first, second);
  ASSERT_TRUE(whole) << whole.fault().sentence;
  EXPECT_EQ(whole->preimage_degree(), 5U);
}

TEST(AnyOperations, RefuseWhatDoesNotFit) {
  Random random("operations that do not fit");
  const AnyPath planar = random_path<PlanarPath<2>>(random, 2);
  const AnyPath spatial = random_path<SpatialPath<2>>(random, 2);
  EXPECT_EQ(joined(planar, spatial).fault().code, FaultCode::unsupported);
  EXPECT_EQ(lifted(spatial).fault().code, FaultCode::unsupported);
  EXPECT_EQ(moved(spatial, 0.5, {0.0, 0.0}).fault().code, FaultCode::unsupported);
  EXPECT_EQ(moved(planar, Quaternion<double>{1, 0, 0, 0}, {}).fault().code, FaultCode::unsupported);
  const std::array<double, 3> three{1.0, 0.0, 0.0};
  const std::array<double, 2> two{1.0, 0.0};
  EXPECT_EQ(reflected(planar, three, two).fault().code, FaultCode::mismatched_size);
  EXPECT_EQ(reflected(spatial, three, two).fault().quantity, "point");
  EXPECT_EQ(with_preimage_degree(planar, 1).fault().code, FaultCode::outside_domain);
  EXPECT_EQ(with_preimage_degree(planar, 13).fault().bound, 12.0);
}

}  // namespace
}  // namespace hodograph
