// SPDX-License-Identifier: MIT
#include "hodograph/frame/rolled_state.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "segment_rates.hpp"

namespace hodograph {
namespace {

struct Place {
  std::array<Quaternion<double>, 2> jet;  ///< A and A', up to a power of two
  double speed;
};

Place place_at(const PreimageTable& path, double xi) {
  const auto& knots = path.knots;
  if (!(knots.front() <= xi && xi <= knots.back())) {
    throw Error(Fault{FaultCode::outside_domain,
                      "path parameter xi " + to_text(xi) + " is outside [" +
                          to_text(knots.front()) + ", " + to_text(knots.back()) + "]",
                      std::nullopt, "path parameter xi", xi,
                      xi < knots.front() ? knots.front() : knots.back()});
  }
  const auto after = std::upper_bound(knots.begin(), knots.end() - 1, xi);
  const auto k = static_cast<std::size_t>(after - knots.begin()) - 1;
  const double u = (xi - knots[k]) / path.step(k);
  const auto preimage = frame_detail::scaled_preimage(path, k);
  auto point = preimage.a;
  for (std::size_t r = point.size() - 1; r > 1; --r) {
    for (std::size_t i = 0; i < r; ++i) point[i] = (1.0 - u) * point[i] + u * point[i + 1];
  }
  Place place;
  if (point.size() > 1) {
    place.jet = {(1.0 - u) * point[0] + u * point[1],
                 (static_cast<double>(path.degree) / path.step(k)) * (point[1] - point[0])};
  } else {
    place.jet = {point[0], {}};
  }
  const double speed = dot(place.jet[0], place.jet[0]);
  if (!(speed > 0.0)) {
    throw Error(Fault{FaultCode::zero_speed,
                      "the path stands still at xi = " + to_text(xi) + ": no frame exists there", k,
                      "speed", 0.0, std::nullopt});
  }
  place.speed = std::ldexp(speed, 2 * preimage.exponent);
  return place;
}

}  // namespace

RolledState rolled_state(const PreimageTable& path, const FrameRoll& roll, double xi) {
  if (roll.knots() != path.knots) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "the roll was made for other knots than those of the path", std::nullopt,
                      "knots", static_cast<double>(roll.knots().size()),
                      static_cast<double>(path.knots.size())});
  }
  const Place place = place_at(path, xi);
  const auto theta = roll.derivatives<1>(xi);
  const double half = 0.5 * theta[0], size = 1.0 / norm(place.jet[0]);
  RolledState state;
  state.rotation = (size * place.jet[0]) * Quaternion<double>{std::cos(half), std::sin(half), 0, 0};
  state.frame = rolled(euler_rodrigues_frame(place.jet), theta[0]);
  state.body_rate_per_xi = rolled_rate(body_rate_per_xi(place.jet)[0], theta[0], theta[1]);
  state.roll = theta[0];
  state.speed = place.speed;
  return state;
}

double roll_towards(const PreimageTable& path, double xi, const Vector3<double>& side) {
  const Frame3<double> frame = euler_rodrigues_frame(place_at(path, xi).jet);
  const double y = dot(side, frame.e2), z = dot(side, frame.e3);
  const double across = std::hypot(y, z);
  if (!(across > accuracy::join_error<double>() * norm(side)) || !std::isfinite(across)) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the direction for the second axis of the frame is along the tangent or not "
                      "finite; it needs a part across the path",
                      std::nullopt, "normal", across, 0.0});
  }
  return std::atan2(z, y);
}

}  // namespace hodograph
