// SPDX-License-Identifier: MIT
// The derivatives of the models in path coordinates against 40 digits and the
// solver's own checker.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "src/control/follow_program.hpp"
#include "src/control/framed_model.hpp"
#include "tests/support/ascent_judge.hpp"
#include "tests/support/derivative_judge.hpp"
#include "tests/support/exact_reference.hpp"
#include "tests/support/paths.hpp"

namespace hodograph {
namespace {

using namespace control_detail;
using test::expect_right_derivatives;
using test::expect_right_end_derivatives;
using test::expect_right_stage_derivatives;
using test::Wide;

/// Four stages of some hundred operations each, whose sizes the path's
/// derivatives by ξ multiply: up to the fourth of those of a tame preimage.
constexpr double step_operations = 2000.0;

/// The functions of a path at a ξ that carries derivatives.
template <class A, std::size_t n>
void expect_right_functions(const AnyPath& path, ProgressBy by, test::Random& random) {
  const test::ExactReference<A, n> reference(path, by);
  const auto all = [&]<class S>(const std::array<S, 1>& at) {
    const ReferenceValue<A, S> value = reference.on(at[0]);
    std::vector<S> numbers{value.speed};
    const auto add = [&numbers](const auto& v) {
      for (std::size_t i = 0; i < std::remove_cvref_t<decltype(v)>::dimension; ++i) {
        numbers.push_back(v[i]);
      }
    };
    add(value.position);
    add(value.frame.e1);
    add(value.frame.e2);
    if constexpr (A::dimension == 4) {
      add(value.frame.e3);
      add(value.body_rate);
    } else {
      numbers.push_back(value.body_rate);
    }
    return numbers;
  };
  for (int i = 0; i < 5; ++i) {
    const std::array<double, 1> at{random.uniform(reference.begin(), reference.end())};
    expect_right_derivatives(all, at, step_operations);
  }
}

TEST(PathDerivatives, OfTheReferenceFunctionsAgreeWithFortyDigits) {
  test::Random random("derivatives: reference");
  const auto space = test::random_path<SpatialPath<4>>(random, 3);
  const auto plane = test::random_path<PlanarPath<2>>(random, 3);
  for (const ProgressBy by : {ProgressBy::xi, ProgressBy::arc_length}) {
    expect_right_functions<Quaternion<double>, 4>(space, by, random);
    expect_right_functions<Complex<double>, 2>(plane, by, random);
  }
}

/// A vehicle on a path of one segment, at random states near its middle.
template <class Vehicle, bool by_progress, class Path>
void expect_right_vehicle(Vehicle vehicle, const std::shared_ptr<const Path>& path,
                          test::Random& random) {
  using Model = FollowModel<Vehicle, by_progress, Path>;
  constexpr std::size_t intervals = 20;
  Model model;
  model.path = path;
  model.vehicle = vehicle;
  model.intervals = intervals;
  const double middle = 0.5 * (path->begin() + path->end());
  model.begin = middle;
  model.end = path->end();
  model.effort_weight = 0.3;
  model.progress_weight = 0.7;
  model.centre_weight = 0.2;
  if constexpr (by_progress) model.find_stages();
  const MultipleShooting<Model> program(model, intervals);
  using Program = MultipleShooting<Model>;
  for (int round = 0; round < 2; ++round) {
    std::array<double, Program::local> at;
    for (double& number : at) number = random.uniform(-0.3, 0.3);
    at[0] = middle + random.uniform(-0.1, 0.1);
    if constexpr (Vehicle::A::dimension == 2) {
      at[3] = random.uniform(0.5, 1.5);
    } else {  // forwards, more or less
      const auto frame = path->value(middle).frame;
      for (std::size_t i = 0; i < 3; ++i) at[3 + i] += frame.e1[i];
    }
    if constexpr (!by_progress) at.back() = random.uniform(0.5, 2.0);
    expect_right_stage_derivatives(program, at, step_operations);
    std::array<double, Program::n + Program::q> end;
    std::copy_n(at.begin(), Program::n, end.begin());
    if constexpr (Program::q > 0) end.back() = at.back();
    expect_right_end_derivatives(program, end, step_operations);
  }
}

template <class Vehicle, class Path>
void expect_right_vehicle_both_ways(const Vehicle& vehicle, const Path& path,
                                    test::Random& random) {
  const auto shared = std::make_shared<const Path>(path);
  expect_right_vehicle<Vehicle, false>(vehicle, shared, random);
  expect_right_vehicle<Vehicle, true>(vehicle, shared, random);
}

TEST(PathDerivatives, OfACarAgreeWithFortyDigits) {
  test::Random random("derivatives: car");
  const auto path = test::random_path<PlanarPath<2>>(random, 1);
  for (const ProgressBy by : {ProgressBy::xi, ProgressBy::arc_length}) {
    expect_right_vehicle_both_ways(Car{{2.0, 0.5}},
                                   test::ExactReference<Complex<double>, 2>(path, by), random);
  }
}

TEST(PathDerivatives, OfACarWithSoftLimitsAgreeWithFortyDigits) {
  test::Random random("derivatives: soft car");
  const auto path = test::random_path<PlanarPath<2>>(random, 1);
  using Path = test::ExactReference<Complex<double>, 2>;
  expect_right_vehicle<SoftCar, false>(SoftCar{{2.0, 0.5, 3.0}, 0.4, 5.0},
                                       std::make_shared<const Path>(path), random);
}

TEST(PathDerivatives, OfAPointInSpaceAgreeWithFortyDigits) {
  test::Random random("derivatives: space");
  const auto path = test::random_path<SpatialPath<2>>(random, 1);
  expect_right_vehicle_both_ways(Glider{{2.0, 2.0, 2.0}},
                                 test::ExactReference<Quaternion<double>, 2>(path), random);
}

TEST(PathDerivatives, OfTheAscentAlongThePathAgreeWithFortyDigits) {
  using Path = test::ExactReference<Quaternion<double>, 8>;
  using Model = ascent_detail::FramedModel<Path>;
  using Program = MultipleShooting<Model>;
  const AscentReference& reference = test::gateway();
  constexpr std::size_t intervals = 100;
  const ascent_detail::PoweredModel motion{
      reference, ascent_detail::PoweredUnits(reference.orbit().system), false, intervals};
  const auto path =
      std::make_shared<const Path>(ascent_detail::path_from_the_moon(reference, motion).value());
  const Program program({motion, path}, intervals);
  test::Random random("derivatives: framed");
  for (int round = 0; round < 2; ++round) {
    std::array<double, Program::local> at;
    for (double& number : at) number = random.uniform(-2, 2);
    at[0] = path->end() * random.uniform(0.48, 0.52);  // 4000 km from the Moon, and 2000 off
    at[9] = random.uniform(1, 6);
    expect_right_stage_derivatives(program, at, step_operations);
    std::array<double, Program::n + Program::q> end;
    std::copy_n(at.begin(), Program::n, end.begin());
    end.back() = at.back();
    expect_right_end_derivatives(program, end, step_operations);
  }
}

// ---- the solver's own checker
// -------------------------------------------------------------------

template <class Vehicle, bool by_progress>
std::size_t wrong_following(const AnyPath& path) {
  using A = typename Vehicle::A;
  FollowLimits limits;
  limits.speed = 2.0;
  limits.acceleration = 1.0;
  if (A::dimension == 2) limits.lateral_acceleration = 1.0;
  limits.offset = 0.1;
  FollowStart start;
  start.xi = path.xi_begin();
  start.speed = 0.5;
  FollowOptions options;
  options.intervals = 2;
  if (std::is_same_v<Vehicle, SoftCar>) {  // as a receding horizon uses it
    options.aim = FollowAim::most_progress;
    options.duration = 1.0;
  }
  FollowedStretch stretch;
  stretch.begin = path.xi_begin();
  stretch.end = path.xi_end();
  stretch.length = path.arc_length();
  stretch.tube = 1.0;
  stretch.bend = 1.0;
  FollowProgram<Vehicle, by_progress> program(
      std::make_shared<const ReferencePath<A>>(ReferencePath<A>::of(path).value()), stretch, limits,
      start, options);
  SolverPoint point = program.guess();
  test::Random random("derivatives: checker");
  for (double& z : point.variables) z += random.uniform(0.01, 0.05);
  return test::wrong_derivatives(program.program(), point);
}

TEST(PathDerivatives, PassTheSolversCheck) {
  test::Random random("derivatives: checked");
  const AnyPath plane = test::random_path<PlanarPath<2>>(random, 1);
  const AnyPath space = test::random_path<SpatialPath<2>>(random, 1);
  EXPECT_EQ((wrong_following<Car, false>(plane)), 0U);
  EXPECT_EQ((wrong_following<Car, true>(plane)), 0U);
  EXPECT_EQ((wrong_following<SoftCar, false>(plane)), 0U);
  EXPECT_EQ((wrong_following<Glider, false>(space)), 0U);
  EXPECT_EQ((wrong_following<Glider, true>(space)), 0U);
}

TEST(PathDerivatives, OfTheAscentAlongThePathPassTheSolversCheck) {
  using Program = MultipleShooting<ascent_detail::FramedModel<>>;
  const AscentReference& reference = test::gateway();
  const ascent_detail::PoweredModel motion{
      reference, ascent_detail::PoweredUnits(reference.orbit().system), true, 2.0};
  const AnyPath path = ascent_detail::path_from_the_moon(reference, motion).value();
  Program program({motion, std::make_shared<const ReferencePath<Quaternion<double>>>(
                               ReferencePath<Quaternion<double>>::of(path).value())},
                  2);
  test::Random random("derivatives: framed check");
  SolverPoint point;
  for (std::size_t i = 0; i < program.variable_ranges().size(); ++i) {
    point.variables.push_back(random.uniform(0.2, 0.8));
  }
  for (std::size_t k = 0; k <= 2; ++k) {
    point.variables[program.state_at(k)] = path.xi_end() * random.uniform(0.495, 0.505);
  }
  point.variables[program.parameters_at()] = 0.5;
  EXPECT_EQ(test::wrong_derivatives(program, point), 0U);
}

}  // namespace
}  // namespace hodograph
