// SPDX-License-Identifier: MIT
// Coordinates of a path against the geometry itself, and the motions that are found in them.
#include "hodograph/control/path_following.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "hodograph/control/path_coordinates.hpp"
#include "hodograph/control/runge_kutta.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
// A thousand roundings of numbers of size one to ten: sums of two hundred terms, twice over.
constexpr double rounding = 1000.0 * epsilon;

template <class A>
std::vector<double> numbers_of(const ReferenceJet<A>& jet, std::size_t r) {
  std::vector<double> all;
  const auto add = [&all](const auto& v) {
    for (std::size_t i = 0; i < std::remove_cvref_t<decltype(v)>::dimension; ++i) {
      all.push_back(v[i]);
    }
  };
  add(jet.position[r]);
  add(jet.frame[r].e1);
  add(jet.frame[r].e2);
  if constexpr (A::dimension == 4) {
    add(jet.frame[r].e3);
    add(jet.body_rate[r]);
  } else {
    all.push_back(jet.body_rate[r]);
  }
  all.push_back(jet.speed[r]);
  return all;
}

/// The same from the path itself, in its own terms.
template <class P>
std::vector<double> numbers_of(const P& path, double xi, std::size_t r) {
  using A = typename P::Algebra;
  const auto jet = path.template preimage_jet<3>(xi);
  ReferenceJet<A> expected;
  const auto position = path.template position_derivatives<2>(xi);
  const auto frame = euler_rodrigues_frame_derivatives(jet);
  const auto rate = body_rate_per_xi(jet);
  const auto speed = speed_derivatives(jet);
  for (std::size_t i = 0; i < 3; ++i) {
    expected.position[i] = position[i];
    expected.frame[i] = frame[i];
    expected.body_rate[i] = rate[i];
    expected.speed[i] = speed[i];
  }
  return numbers_of(expected, r);
}

template <class P>
void expect_reference_of(const P& path, test::Random& random) {
  const auto reference = ReferencePath<typename P::Algebra>::of(AnyPath(path)).value();
  for (int i = 0; i < 20; ++i) {
    const double xi = random.uniform(path.xi_begin(), path.xi_end());
    for (std::size_t r = 0; r < 3; ++r) {
      const auto expected = numbers_of(path, xi, r), got = numbers_of(reference.at(xi), r);
      double size = 1.0;
      for (const double e : expected) size = std::max(size, std::abs(e));
      for (std::size_t k = 0; k < got.size(); ++k) {
        EXPECT_NEAR(got[k], expected[k], rounding * size) << "number " << k << " of order " << r;
      }
    }
  }
}

TEST(ReferencePath, GivesWhatThePathGivesWithTwoDerivatives) {
  test::Random random("reference path");
  expect_reference_of(test::random_path<PlanarPath<2>>(random, 4), random);
  expect_reference_of(test::random_path<SpatialPath<4>>(random, 3), random);
}

TEST(ReferencePath, ByArcLengthItsDerivativesAreThoseByArcLength) {
  test::Random random("reference by arc length");
  const auto path = test::random_path<SpatialPath<4>>(random, 3);
  const auto by_xi = ReferencePath<Quaternion<double>>::of(path).value();
  const auto by_length =
      ReferencePath<Quaternion<double>>::of(path, ProgressBy::arc_length).value();
  EXPECT_EQ(by_length.end(), path.arc_length());
  for (int i = 0; i < 20; ++i) {
    const double xi = random.uniform(path.xi_begin(), path.xi_end());
    const double s = by_length.progress_of(xi);
    EXPECT_NEAR(s, path.arc_length(xi), rounding * path.arc_length());
    EXPECT_NEAR(by_length.xi_of(s), xi, rounding * path.arc_length());
    const auto a = by_xi.at(xi), b = by_length.at(s);
    const double sigma = a.speed[0], slope = a.speed[1];
    EXPECT_EQ(b.speed[0], 1.0);
    for (std::size_t k = 0; k < 3; ++k) {
      const double first = a.frame[1].e2[k] / sigma;
      const double second = (a.frame[2].e2[k] - slope * first) / (sigma * sigma);
      EXPECT_NEAR(b.frame[1].e2[k], first, rounding * 10.0);
      EXPECT_NEAR(b.frame[2].e2[k], second, rounding * 100.0);
      EXPECT_NEAR(b.position[1][k], a.frame[0].e1[k], rounding);
    }
  }
}

/// All places at once as one by one, bit for bit: any number of them, in any order, on few segments
/// and on many, beyond the ends and round a closed path.
template <class A>
void expect_batch_as_single(const AnyPath& path, ProgressBy by, test::Random& random) {
  const auto reference = ReferencePath<A>::of(path, by).value();
  const double length = reference.end() - reference.begin();
  for (const std::size_t count : {0U, 1U, 2U, 7U, 8U, 9U, 40U, 300U}) {
    for (const double share : {0.05, 1.0, 1.2}) {
      std::vector<double> places;
      for (std::size_t i = 0; i < count; ++i) {
        places.push_back(reference.begin() +
                         length * random.uniform(0.5 - 0.5 * share, 0.5 * (1 + share)));
      }
      if (random.uniform(0, 1) < 0.5) std::sort(places.begin(), places.end());
      std::vector<ReferenceJet<A>> jets(count);
      reference.at(places, jets);
      for (std::size_t i = 0; i < count; ++i) {
        const auto single = reference.at(places[i]);
        for (std::size_t r = 0; r < 3; ++r) {
          EXPECT_EQ(numbers_of(jets[i], r), numbers_of(single, r)) << i << " of " << count;
        }
      }
    }
  }
}

TEST(ReferencePath, ManyPlacesAtOnceHaveTheBitsOfEachAlone) {
  test::Random random("reference batch");
  for (const auto by : {ProgressBy::xi, ProgressBy::arc_length}) {
    expect_batch_as_single<Quaternion<double>>(test::random_path<SpatialPath<4>>(random, 9), by,
                                               random);
    expect_batch_as_single<Quaternion<double>>(test::random_path<SpatialPath<8>>(random, 2), by,
                                               random);
    expect_batch_as_single<Complex<double>>(test::random_path<PlanarPath<2>>(random, 9), by,
                                            random);
    expect_batch_as_single<Complex<double>>(test::ring(6), by, random);
    expect_batch_as_single<Complex<double>>(test::random_path<PlanarPath<0>>(random, 2), by,
                                            random);
  }
}

TEST(ReferencePath, RefusesAPathOfTheOtherDimension) {
  test::Random random("reference refused");
  const AnyPath plane = test::random_path<PlanarPath<2>>(random, 1);
  EXPECT_EQ(ReferencePath<Quaternion<double>>::of(plane).fault().code, FaultCode::unsupported);
}

// Whatever the velocity, the coordinates move so that the place moves with it.
TEST(PathCoordinates, ThePlaceMovesWithTheVelocity) {
  test::Random random("coordinates");
  const auto space =
      ReferencePath<Quaternion<double>>::of(test::random_path<SpatialPath<4>>(random, 2)).value();
  const auto plane =
      ReferencePath<Complex<double>>::of(test::random_path<PlanarPath<4>>(random, 2)).value();
  using T = SecondOrder<double, 1>;  // the time
  for (int i = 0; i < 50; ++i) {
    const double xi = random.uniform(space.begin(), space.end());
    const Vector3<double> v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    const std::array<double, 2> eta{random.uniform(-0.1, 0.1), random.uniform(-0.1, 0.1)};
    const auto rates = coordinate_rates(space.value(xi), eta, v);
    const auto moving = [](double x, double rate) {
      T t(x);
      t.gradient(0) = rate;
      return t;
    };
    const auto place =
        place_of(space.on(moving(xi, rates[0])),
                 std::array<T, 2>{moving(eta[0], rates[1]), moving(eta[1], rates[2])});
    for (std::size_t k = 0; k < 3; ++k) EXPECT_NEAR(place[k].gradient(0), v[k], rounding * 10.0);

    const double x = random.uniform(plane.begin(), plane.end());
    const Vector2<double> w{v.x, v.y};
    const auto flat = coordinate_rates(plane.value(x), std::array<double, 1>{eta[0]}, w);
    const auto there =
        place_of(plane.on(moving(x, flat[0])), std::array<T, 1>{moving(eta[0], flat[1])});
    for (std::size_t k = 0; k < 2; ++k) EXPECT_NEAR(there[k].gradient(0), w[k], rounding * 10.0);
  }
}

PlanarPath<0> straight(double length) {
  const PlanarPhCurve<0> line(
      {0.0, 0.0}, BernsteinPolynomial<Complex<double>, 0>({Complex<double>{1.0, 0.0}}), length);
  return PlanarPath<0>::create({0.0, length}, {line}, false).value();
}

TEST(OffsetLimits, ARingIsLimitedInsideAloneAndALineNowhere) {
  const auto ring = offset_limits(test::ring(8));
  const auto bend = ring.curvature_maximum;
  EXPECT_LE(ring.left * bend.upper(), 1.0);
  EXPECT_GE(ring.left * bend.upper(), 1.0 - rounding);
  EXPECT_TRUE(std::isinf(ring.right));
  EXPECT_TRUE(std::isinf(offset_limits(straight(3.0)).left));
}

FollowLimits car() {
  FollowLimits limits;
  limits.speed = 2.0;
  limits.acceleration = 1.0;
  limits.lateral_acceleration = 1.0;
  limits.offset = 0.1;
  return limits;
}

// Without effort, on a straight road: full acceleration to the limit, then on.
TEST(Follow, AStraightRoadTakesTheTimeThatTheLimitsTake) {
  const double length = 6.0;
  FollowOptions options;
  options.intervals = 30;
  options.effort = 0.0001;
  const Following found = follow(straight(length), car(), {}, options).value();
  const double exact = 2.0 + (length - 2.0) / 2.0;  // v²/2a to reach the speed
  EXPECT_GE(found.duration, exact - options.effort);
  EXPECT_LE(found.duration, exact + 0.02);  // the speed limit is met at a node, not between
  EXPECT_LE(found.largest_offset, 0.1);
  EXPECT_EQ(found.nodes.size(), 31u);
  EXPECT_NEAR(found.nodes.back().xi, length, default_constraint_tolerance * 10.0);
}

// Both forms find the same motion, within what thirty intervals tell apart.
TEST(Follow, TimeAndProgressAsIndependentVariableAgree) {
  const auto ring = test::ring(6);
  FollowOptions options;
  options.intervals = 60;
  options.xi_end = 3.0;
  FollowStart start;
  start.speed = 0.5;
  const Following by_time = follow(ring, car(), start, options).value();
  options.independent = FollowIndependent::progress;
  const Following by_progress = follow(ring, car(), start, options).value();
  EXPECT_NEAR(by_time.duration, by_progress.duration, 0.01 * by_time.duration);
  EXPECT_EQ(by_progress.nodes.back().xi, 3.0);
  for (const Following* found : {&by_time, &by_progress}) {
    EXPECT_LE(found->largest_offset, 0.1);
    EXPECT_GT(found->least_stretch, 0.0);
    for (const FollowNode& node : found->nodes) {
      EXPECT_LE(node.speed, 2.0 + default_constraint_tolerance);
      EXPECT_LE(std::abs(node.lateral), 1.0 + 0.2);  // held over the last node
      const double drift = std::abs(norm(node.velocity) - node.speed);
      EXPECT_LE(drift, rounding);
    }
  }
}

TEST(Follow, APointInSpaceKeepsItsLimits) {
  test::Random random("follow in space");
  const auto path = test::random_path<SpatialPath<4>>(random, 1);
  const double tube = offset_limits(path).left;
  FollowLimits limits;
  limits.speed = 1.0;
  limits.acceleration = 0.8;
  limits.offset = 0.2 * tube;
  FollowOptions options;
  options.intervals = 30;
  FollowStart start;
  start.xi = path.xi_begin();
  const Following found = follow(path, limits, start, options).value();
  EXPECT_LE(found.largest_offset, limits.offset);
  for (std::size_t k = 0; k < found.nodes.size(); ++k) {
    const FollowNode& node = found.nodes[k];
    EXPECT_LE(norm(node.velocity), limits.speed + default_constraint_tolerance);
    EXPECT_LE(norm(node.acceleration), limits.acceleration + default_constraint_tolerance);
    EXPECT_LE(norm(node.position - path.position(std::min(node.xi, path.xi_end()))),
              limits.offset + rounding);
  }
  EXPECT_GE(found.duration * limits.speed, 0.9 * path.arc_length() - limits.offset);
}

// The bound holds for the motion between the nodes, looked at a hundred times as often, and is not
// far from it.
TEST(Follow, TheOffsetIsBoundedBetweenTheNodes) {
  const auto ring = test::ring(6);
  const auto path = ReferencePath<Complex<double>>::of(ring).value();
  FollowLimits limits = car();
  limits.offset = 0.2;
  FollowStart start;
  start.speed = 0.5;
  for (const std::size_t intervals : {6U, 25U}) {
    FollowOptions options;
    options.intervals = intervals;
    options.xi_end = 3.0;
    const Following found = follow(ring, limits, start, options).value();
    double largest = 0.0, lateral = 0.0;
    constexpr std::size_t looks = 1600;
    for (std::size_t k = 0; k < intervals; ++k) {
      const FollowNode& node = found.nodes[k];
      const double a = node.along, bend = node.lateral / (node.speed * node.speed);
      std::array<double, 4> x{node.xi, node.offset[0], node.heading, node.speed};
      const auto rates = [&](double, const std::array<double, 4>& y) {
        const auto at = path.value(y[0]);
        const double progress =
            y[3] * std::cos(y[2]) / progress_stretch(at, std::array<double, 1>{y[1]});
        return std::array<double, 4>{progress, y[3] * std::sin(y[2]),
                                     y[3] * bend - progress * at.body_rate, a};
      };
      const double step = found.duration / static_cast<double>(intervals * looks);
      for (std::size_t i = 0; i < looks; ++i) {
        largest = std::max(largest, std::abs(x[1]));
        lateral = std::max(lateral, x[3] * x[3] * std::abs(bend));
        x = runge_kutta_step<double, 4>(rates, 0.0, step, x);
      }
    }
    EXPECT_GE(found.largest_offset, largest - rounding);
    EXPECT_LE(found.largest_offset, 1.01 * largest);
    EXPECT_LE(found.largest_offset, limits.offset);
    EXPECT_GE(found.largest_lateral, lateral - rounding);
    EXPECT_LE(found.largest_lateral, 1.01 * lateral);
  }
}

TEST(Follow, RefusesAnEndSpeedThatCannotBeReachedAndSaysWhichCan) {
  const auto refusal = [](double from, double to, double duration) {
    FollowLimits limits = car();
    limits.speed = 5.0;
    FollowStart start;
    start.speed = from;
    FollowOptions options;
    options.end_speed = to;
    if (duration > 0.0) {
      options.aim = FollowAim::most_progress;
      options.duration = duration;
    }
    const auto found = follow(straight(4.5), limits, start, options);
    EXPECT_FALSE(found);
    return found ? Fault{} : found.fault();
  };
  Fault fault = refusal(0.0, 3.5, 0.0);  // v² = 2 · 1 · 4.5
  EXPECT_EQ(fault.code, FaultCode::outside_domain);
  EXPECT_EQ(fault.bound, 3.0);
  EXPECT_NE(fault.sentence.find("at most 3"), std::string::npos) << fault.sentence;
  EXPECT_EQ(refusal(5.0, 3.0, 0.0).bound, 4.0);
  EXPECT_EQ(refusal(0.0, 2.0, 1.5).bound, 1.5);
  EXPECT_EQ(refusal(2.0, 6.0, 0.0).bound, std::sqrt(13.0));
}

TEST(Follow, AsFarAsPossibleEndsWithTheTime) {
  FollowOptions options;
  options.aim = FollowAim::most_progress;
  options.duration = 3.0;
  options.intervals = 30;
  const Following found = follow(straight(100.0), car(), {}, options).value();
  EXPECT_EQ(found.duration, 3.0);
  EXPECT_LE(found.progress, 2.0 + 2.0 + default_constraint_tolerance);
  EXPECT_GE(found.progress, 2.0 + 1.98);  // the speed limit is met at a node
}

TEST(Follow, RefusesWhatIsNotPossible) {
  const auto ring = test::ring(6);
  const auto code = [&](auto&& change) {
    FollowLimits limits = car();
    FollowStart start;
    start.speed = 0.5;
    FollowOptions options;
    change(limits, start, options);
    const auto found = follow(ring, limits, start, options);
    return found ? std::string() : std::string(name_of(found.fault().code));
  };
  using L = FollowLimits;
  using S = FollowStart;
  using O = FollowOptions;
  const std::string outside = "outside_domain", unsupported = "unsupported";
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(code([](L& l, S&, O&) { l.speed = 0.0; }), outside);
  EXPECT_EQ(code([&](L& l, S&, O&) { l.acceleration = nan; }), outside);
  EXPECT_EQ(code([](L& l, S&, O&) { l.offset = 0.0; }), outside);
  EXPECT_EQ(code([](L& l, S&, O&) { l.offset = 100.0; }), outside);  // beyond the tube
  EXPECT_EQ(code([](L& l, S&, O&) { l.lateral_acceleration = -1.0; }), outside);
  EXPECT_EQ(code([](L&, S& s, O&) { s.offset[0] = 0.2; }), outside);
  EXPECT_EQ(code([](L&, S& s, O&) { s.xi = -1.0; }), outside);
  EXPECT_EQ(code([](L&, S& s, O&) { s.speed = 3.0; }), outside);
  EXPECT_EQ(code([](L&, S& s, O&) { s.heading = 2.0; }), outside);
  EXPECT_EQ(code([](L&, S&, O& o) { o.intervals = 1; }), outside);
  EXPECT_EQ(code([](L&, S&, O& o) { o.xi_end = 0.0; }), outside);
  EXPECT_EQ(code([](L&, S&, O& o) { o.aim = FollowAim::most_progress; }), outside);  // no duration
  EXPECT_EQ(code([](L&, S& s, O& o) {
              s.speed = 0.0;  // v · e₁ = 0
              o.independent = FollowIndependent::progress;
            }),
            outside);
  EXPECT_EQ(code([](L&, S&, O& o) {
              o.aim = FollowAim::most_progress;
              o.duration = 1.0;
              o.independent = FollowIndependent::progress;
            }),
            unsupported);
  test::Random random("follow refused");
  EXPECT_EQ(follow(test::random_path<SpatialPath<2>>(random, 1), car(), {}).fault().code,
            FaultCode::unsupported);
}

}  // namespace
}  // namespace hodograph
