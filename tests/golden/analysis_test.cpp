// SPDX-License-Identifier: MIT
// Everything a path knows, from given preimages, against reference values in 40 digits.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/continuity.hpp"
#include "hodograph/frame/frenet.hpp"
#include "hodograph/path/continuity.hpp"
#include "hodograph/path/path.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"

namespace hodograph {
namespace {

using test::golden_file;
using test::Json;

/// The path of the given segments: start, step and local Bernstein coefficients, √h A.
SpatialPath<8> golden_path(const Json& knots, const Json& segments) {
  std::vector<double> xi;
  for (const Json& knot : knots.list()) xi.push_back(knot.number());
  std::vector<SpatialPhCurve<8>> curves;
  for (std::size_t k = 0; k < segments.size(); ++k) {
    const double h = xi[k + 1] - xi[k];
    std::array<Quaternion<double>, 9> a{};
    for (std::size_t i = 0; i < 9; ++i) {
      a[i] = (1 / std::sqrt(h)) * segments[k]["A"][i].quaternion();
    }
    curves.emplace_back(segments[k]["p0"].vector(), BernsteinPolynomial<Quaternion<double>, 8>(a),
                        h);
  }
  return SpatialPath<8>::create(xi, curves, false).value();
}

/// How far a value computed from the coefficients rounded to double may be from the reference, as a
/// first-order bound: sizes and errors of A, A', A'', A''' at the point, then of what is made of
/// them.
struct Bounds {
  frame_detail::Sizes<double, 4> preimage;  ///< |A^(r)|, and its error
  frame_detail::Sizes<double, 4> square;    ///< of σ, and of every entry of A x A*
  frame_detail::Sizes<double, 4> twice_v;   ///< of 2 vec(A* A') and its derivatives
  frame_detail::Sizes<double, 4> rate;      ///< of ω and χ

  /// Each coefficient is rounded when it is read, divided by √h (rounded) and summed by Bernstein
  /// weights: 4 roundings and those of the evaluation, that is 2 + (3n + 2)/2 = 15 ε of the largest
  /// component (√4 for the norm). Derivative r sums with weights of total 2^r n!/(n-r)!/h^r.
  Bounds(const SpatialPath<8>& path, double xi) {
    const auto at = path.locate(xi);
    const auto& curve = path.segment(at.segment);
    const auto jet = curve.preimage_jet<3>(at.u);
    const double largest = path_detail::largest_coefficient(curve.preimage());
    double weight = 2 * 15 * epsilon<double>();
    const double sigma = dot(jet[0], jet[0]);
    frame_detail::Sizes<double, 4> unit_square, derivative;
    for (std::size_t r = 0; r < 4; ++r) {
      preimage.size[r] = norm(jet[r]);
      preimage.error[r] = weight * largest + 8 * epsilon<double>() * preimage.size[r];
      weight *= 2.0 * static_cast<double>(8 - r) / curve.parameter_step();
    }
    for (std::size_t r = 0; r < 3; ++r) {
      derivative.size[r] = 2 * preimage.size[r + 1];
      derivative.error[r] = 2 * preimage.error[r + 1];
    }
    square = frame_detail::form_sizes(preimage, preimage);
    twice_v = frame_detail::form_sizes(preimage, derivative);
    unit_square = square;  // quotient_sizes divides by numbers of size 1
    auto unit_v = twice_v;
    for (std::size_t r = 0; r < 4; ++r) {
      unit_square.size[r] /= sigma;
      unit_square.error[r] /= sigma;
      unit_v.size[r] /= sigma;
      unit_v.error[r] /= sigma;
    }
    rate = frame_detail::quotient_sizes(unit_v, unit_square);
  }
};

/// |actual - expected| ≤ bound/8, a bound in the units of the quantity: the bounds add up the worst
/// of more than 64 roundings, which are of either sign and grow like the root of their number.
template <class V>
void expect_within(const V& actual, const V& expected, double bound) {
  EXPECT_CLOSE(actual, expected, 0.125, bound / epsilon<double>());
}

void expect_sample(const SpatialPath<8>& path, const Json& sample) {
  const double xi = sample["t"].number();
  SCOPED_TRACE("xi = " + to_text(xi));
  const auto at = path.locate(xi);
  const Bounds bounds(path, xi);
  const auto jet = path.preimage_jet<3>(xi);
  const double sigma = path.speed(xi);

  // Positions and arc lengths add up to here from h |A|²: error 2 · 15 ε relative to h M² per
  // segment.
  double travelled = largest_component(path.segment(0).start());
  for (std::size_t k = 0; k <= at.segment; ++k) {
    const double largest = path_detail::largest_coefficient(path.segment(k).preimage());
    travelled += 4 * path.segment(k).parameter_step() * largest * largest;
  }
  const double travel_bound = 2 * 15 * epsilon<double>() * travelled;
  const auto p = path.position_derivatives<4>(xi);
  expect_within(p[0], sample["p"][0].vector(), travel_bound);
  expect_within(path.arc_length(xi), sample["s"].number(), travel_bound);
  for (std::size_t r = 0; r < 4; ++r) {
    expect_within(p[r + 1], sample["p"][r + 1].vector(), bounds.square.error[r]);
    expect_within(jet[r], sample["A_global"][r].quaternion(), bounds.preimage.error[r]);
    expect_within(speed_derivatives(jet)[r], sample["sigma"][r].number(), bounds.square.error[r]);
  }

  const auto frame = euler_rodrigues_frame_derivatives(jet);
  const double frame_bound = 2 * bounds.square.error[0] / sigma;
  const auto frame_of = [](const Json& r) {
    return Frame3<double>{r[0].vector(), r[1].vector(), r[2].vector()};
  };
  expect_within(frame[0], frame_of(sample["R"]), frame_bound);
  expect_within(frame[1], frame_of(sample["R_d1"]),
                2 * (bounds.rate.error[0] + frame_bound * bounds.rate.size[0]));

  const AdaptedFrame adapted(path);
  const auto chi = adapted.body_rate_per_xi_derivatives<2>(xi);
  const auto omega = adapted.world_rate_per_xi_derivatives<2>(xi);
  for (std::size_t r = 0; r < 3; ++r) {
    expect_within(chi[r], sample["chi"][r].vector(), bounds.rate.error[r]);
    expect_within(omega[r], sample["omega"][r].vector(), bounds.rate.error[r]);
  }
  const double per_arc_length = (bounds.rate.error[0] + bounds.rate.size[0] * frame_bound) / sigma;
  expect_within(adapted.world_rate_per_arc_length(xi), sample["omega_s"].vector(), per_arc_length);

  // κ = |(V₂, V₃)| 2/σ²; τ divides twice by |(V₂, V₃)|, so its error grows by |V|/|(V₂, V₃)|.
  const double kappa = curvature(jet);
  const double kappa_bound = bounds.twice_v.error[0] / (sigma * sigma) + 2 * kappa * frame_bound;
  expect_within(kappa, sample["kappa"][0].number(), kappa_bound);
  const double bend = kappa * sigma * sigma / 2;
  const double v = bounds.twice_v.size[0] / 2, dv = bounds.twice_v.size[1] / 2;
  const double v_error = bounds.twice_v.error[0] / 2, dv_error = bounds.twice_v.error[1] / 2;
  const double tau_bound = (2 * v_error / sigma + (v * dv_error + dv * v_error) / (bend * bend) +
                            2 * (v * dv / (bend * bend)) * (v_error / bend)) /
                           sigma;
  const auto state = frenet(path, xi);
  ASSERT_TRUE(state);
  expect_within(state->torsion, sample["tau"][0].number(), tau_bound);
  expect_within(state->curvature, sample["kappa"][0].number(), kappa_bound);
}

TEST(GoldenAnalysis, Curve23FromItsPreimages) {
  const Json file = golden_file("phodcos.json");
  for (const Json& curve : file["curves"].list()) {
    SCOPED_TRACE(curve["name"].string() + ", " + std::to_string(curve["segments"].size()) +
                 " segments");
    const auto path = golden_path(curve["knots"], curve["segments"]);
    double size = 0;
    for (const auto& segment : path.segments()) {
      const double largest = path_detail::largest_coefficient(segment.preimage());
      size += 4 * segment.parameter_step() * largest * largest;
    }
    EXPECT_CLOSE(path.arc_length(), curve["length"].number(), 2 * 15.0, size);
    for (const Json& sample : curve["samples"].list()) expect_sample(path, sample);
  }
}

TEST(GoldenAnalysis, HermiteInterpolantsFromTheirPreimages) {
  const Json file = golden_file("phodcos.json");
  for (const Json& item : file["hermite"].list()) {
    SCOPED_TRACE(item["name"].string());
    std::array<Quaternion<double>, 9> a{};
    for (std::size_t i = 0; i < 9; ++i) a[i] = item["A"][i].quaternion();
    const SpatialPhCurve<8> curve(item["b"]["p"].vector(),
                                  BernsteinPolynomial<Quaternion<double>, 8>(a), 1.0);
    const auto path = SpatialPath<8>::create({0.0, 1.0}, {curve}, false).value();
    for (const Json& sample : item["samples"].list()) expect_sample(path, sample);
  }
}

/// The reference preimages, each rounded on its own, still join as smoothly as the paper states.
TEST(GoldenAnalysis, Curve23IsAsSmoothAsThePaperStates) {
  const Json file = golden_file("phodcos.json");
  for (const Json& curve : file["curves"].list()) {
    const auto path = golden_path(curve["knots"], curve["segments"]);
    EXPECT_EQ(continuity(path).preimage.order(), 3);
    EXPECT_EQ(continuity(path).position.order(), 4);
    EXPECT_EQ(frame_continuity(path).frame.order(), 3);
    EXPECT_EQ(frame_continuity(path).angular_velocity.order(), 2);
  }
}

}  // namespace
}  // namespace hodograph
