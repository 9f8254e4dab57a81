// SPDX-License-Identifier: MIT
// The part that depends on the degree is small: it finds the jet of the preimage. All else follows
// from the jet and is compiled once for the plane and once for space.
#include "cli/point_state.hpp"

#include <cstddef>

#include "hodograph/frame/angular_velocity.hpp"
#include "hodograph/frame/frenet.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t rate_count = 3;   // a rate and two derivatives
constexpr std::size_t frame_count = 3;  // a frame and two derivatives

std::vector<double> numbers(double value) { return {value}; }
template <class V>
  requires requires { V::dimension; }
std::vector<double> numbers(const V& value) {
  std::vector<double> result(V::dimension);
  for (std::size_t i = 0; i < V::dimension; ++i) result[i] = value[i];
  return result;
}
Derivatives axes(const Frame2<double>& frame) { return {numbers(frame.e1), numbers(frame.e2)}; }
Derivatives axes(const Frame3<double>& frame) {
  return {numbers(frame.e1), numbers(frame.e2), numbers(frame.e3)};
}
template <class Array>
Derivatives rows(const Array& values, std::size_t count) {
  Derivatives result;
  for (std::size_t r = 0; r < count; ++r) result.push_back(numbers(values[r]));
  return result;
}

/// The first rates of a longer jet of them.
template <class Rate, std::size_t size>
std::array<Rate, rate_count> first_rates(const std::array<Rate, size>& all) {
  return {all[0], all[1], all[2]};
}

template <class A, class Rate, class Frames>
void set_rates(PointState& state, const std::array<A, rate_count + 1>& jet,
               const std::array<Rate, rate_count>& body, const std::array<Rate, rate_count>& world,
               const Frames& frames) {
  for (std::size_t r = 0; r < frame_count; ++r) state.frame.push_back(axes(frames[r]));
  state.rates.body_per_xi = rows(body, rate_count);
  state.rates.world_per_xi = rows(world, rate_count);
  state.rates.body_per_arc_length = rows(rate_detail::per_arc_length(jet, body), rate_count);
  state.rates.world_per_arc_length = rows(rate_detail::per_arc_length(jet, world), rate_count);
}

template <class A>
std::array<A, rate_count + 1> shortened(const PreimageJet<A, 4>& jet) {
  return {jet[0], jet[1], jet[2], jet[3]};
}

void set_frame(PointState& state, const PreimageJet<Complex<double>, 4>& jet,
               const std::optional<LinearRoll<double>>&) {
  const auto first = shortened(jet);
  set_rates(state, first, body_rate_per_xi(first), world_rate_per_xi(first),
            euler_rodrigues_frame_derivatives(first));
}

void set_frame(PointState& state, const PreimageJet<Quaternion<double>, 4>& jet,
               const std::optional<LinearRoll<double>>& roll) {
  const auto first = shortened(jet);
  auto body = body_rate_per_xi(first);
  auto world = world_rate_per_xi(first);
  const auto erf = euler_rodrigues_frame_derivatives(first);
  Frame3<double> frame = erf[0];
  if (roll) {
    const auto theta = roll->derivatives<rate_count>(state.xi);
    frame = rolled(frame, theta[0]);
    body = rolled_rates(body, theta);
    for (std::size_t r = 0; r < rate_count; ++r) world[r] += theta[1] * erf[r].e1;  // θ'' = 0
  }
  set_rates(state, first, body, world, frame_derivatives(frame, body));
  if (const auto tau = torsion(first)) state.torsion = *tau;
}

template <class A>
void set_from_jet(PointState& state, const point_t<A>& position, const PreimageJet<A, 4>& jet,
                  const std::optional<LinearRoll<double>>& roll) {
  const auto derivatives = hodograph_derivatives(jet);
  state.position.push_back(numbers(position));
  for (std::size_t r = 0; r + 1 < jet.size(); ++r)
    state.position.push_back(numbers(derivatives[r]));
  state.preimage = rows(jet, jet.size());
  const auto sigma = speed_derivatives(jet);
  state.speed.assign(sigma.begin(), sigma.end());
  state.moves = sigma[0] > 0.0;
  if (!state.moves) return;
  state.tangent = numbers(tangent(jet));
  state.curvature = curvature(jet);
  set_frame(state, jet, roll);
}

}  // namespace

PointState state_at(const AnyPath& path, double xi, const std::optional<LinearRoll<double>>& roll) {
  PointState state;
  state.xi = xi;
  path.visit([&](const auto& p) {
    const auto at = p.locate(xi);
    const auto& curve = p.segment(at.segment);
    state.arc_length = p.arc_length(at);
    set_from_jet(state, curve.position(at.u), curve.template preimage_jet<4>(at.u), roll);
    if constexpr (std::remove_cvref_t<decltype(curve)>::Point::dimension == 3) {
      if (const auto frame = frenet(p, xi)) {
        state.frenet = FrenetNumbers{numbers(frame->frame.e1), numbers(frame->frame.e2),
                                     numbers(frame->frame.e3), frame->curvature,
                                     frame->torsion,           frame->roll};
      }
    }
  });
  return state;
}

}  // namespace hodograph::cli
