// SPDX-License-Identifier: MIT
#include "hodograph/path/any_path.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using test::Random;
using test::random_path;

template <class P>
void expect_held(const P& path) {
  constexpr std::size_t point_size = P::Point::dimension, size = P::Algebra::dimension;
  const AnyPath any = path;
  EXPECT_EQ(any.dimension(), point_size);
  EXPECT_EQ(any.preimage_degree(), P::preimage_degree);
  EXPECT_EQ(any.degree(), P::Curve::degree);
  EXPECT_EQ(any.preimage_components(), size);
  EXPECT_EQ(any.segment_count(), path.segment_count());
  EXPECT_EQ(any.is_closed(), path.is_closed());
  EXPECT_EQ(any.knots(), path.knots());
  EXPECT_EQ(any.arc_length(), path.arc_length());
  ASSERT_NE(any.get_if<P>(), nullptr);
  EXPECT_EQ(*any.get_if<P>(), path);
  EXPECT_EQ(any.memory(), any.get_if<P>()->memory());

  const double xi = 0.25 * path.xi_begin() + 0.75 * path.xi_end();
  std::array<double, point_size> position{};
  any.position(xi, position);
  std::array<double, size> preimage{};
  any.preimage(xi, preimage);
  for (std::size_t i = 0; i < point_size; ++i) EXPECT_EQ(position[i], path.position(xi)[i]);
  for (std::size_t i = 0; i < size; ++i) EXPECT_EQ(preimage[i], path.preimage(xi)[i]);
  EXPECT_EQ(any.speed(xi), path.speed(xi));
  EXPECT_EQ(any.arc_length(xi), path.arc_length(xi));

  const auto again = AnyPath::create(any.numbers());
  ASSERT_TRUE(again) << again.fault().sentence;
  EXPECT_TRUE(*again == any);
  EXPECT_EQ(again->numbers(), any.numbers());
}

template <std::size_t... n>
void expect_all_held(Random& random, std::index_sequence<n...>) {
  (expect_held(random_path<PlanarPath<n>>(random, 3)), ...);
  (expect_held(random_path<SpatialPath<n>>(random, 3)), ...);
}

TEST(AnyPath, HoldsEveryDegreeAndReturnsItsNumbers) {
  Random random("any path");
  expect_all_held(random, std::make_index_sequence<maximum_dynamic_degree + 1>{});
}

TEST(AnyPath, VisitsTheStaticType) {
  Random random("any path visit");
  const AnyPath any = random_path<SpatialPath<4>>(random, 2);
  const auto degree = any.visit([]<class P>(const P&) { return P::preimage_degree; });
  EXPECT_EQ(degree, 4U);
  EXPECT_EQ(any.get_if<PlanarPath<4>>(), nullptr);
}

PathNumbers straight() {
  PathNumbers numbers;
  numbers.dimension = 2;
  numbers.preimage_degree = 1;
  numbers.knots = {0, 1, 3};
  numbers.starts = {0, 0, 1, 0};
  numbers.preimages = {1, 0, 1, 0, 1, 0, 1, 0};
  return numbers;
}

void expect_fault(const PathNumbers& numbers, FaultCode code, const std::string& sentence) {
  const auto path = AnyPath::create(numbers);
  ASSERT_FALSE(path);
  EXPECT_EQ(name_of(path.fault().code), name_of(code));
  EXPECT_EQ(path.fault().sentence, sentence);
}

TEST(AnyPath, RefusesWhatIsNoPath) {
  ASSERT_TRUE(AnyPath::create(straight()));
  auto numbers = straight();
  numbers.dimension = 4;
  expect_fault(numbers, FaultCode::unsupported, "the dimension of a path is 2 or 3; got 4");
  numbers = straight();
  numbers.preimage_degree = 13;
  expect_fault(numbers, FaultCode::unsupported, "the preimage degree is at most 12; got 13");
  numbers = straight();
  numbers.knots = {0};
  expect_fault(numbers, FaultCode::too_few, "a path needs at least two knots; got 1");
  numbers.knots = {};
  expect_fault(numbers, FaultCode::too_few, "a path needs at least two knots; got 0");
  numbers = straight();
  numbers.starts.pop_back();
  expect_fault(numbers, FaultCode::mismatched_size,
               "2 segments of preimage degree 1 in dimension 2 need 4 starts; got 3");
  numbers = straight();
  numbers.preimages.push_back(1);
  expect_fault(numbers, FaultCode::mismatched_size,
               "2 segments of preimage degree 1 in dimension 2 need 8 preimages; got 9");
  numbers = straight();
  numbers.knots[1] = 3;
  expect_fault(numbers, FaultCode::not_increasing,
               "knots must increase strictly; knot 2 is 3 after 3");
  numbers = straight();
  numbers.preimages[5] = std::numeric_limits<double>::quiet_NaN();
  expect_fault(numbers, FaultCode::not_finite,
               "segment 1 has a coefficient that is infinite or not a number");
  numbers = straight();
  numbers.starts[2] = 2;
  ASSERT_FALSE(AnyPath::create(numbers));
  EXPECT_EQ(AnyPath::create(numbers).fault().code, FaultCode::not_continuous);
}

TEST(AnyPath, QuestionsOutsideTheKnotsAreErrors) {
  const AnyPath path = AnyPath::create(straight()).value();
  std::array<double, 2> out{};
  EXPECT_THROW(path.position(3.5, out), Error);
  EXPECT_THROW((void)path.speed(std::numeric_limits<double>::quiet_NaN()), Error);
}

}  // namespace
}  // namespace hodograph
