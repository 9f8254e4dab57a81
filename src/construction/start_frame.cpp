// SPDX-License-Identifier: MIT
// Rotations to a frame given by a direction and a normal.
#include "hodograph/construction/start_frame.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/construction/detail/hermite_kernel.hpp"
#include "hodograph/foundation/accuracy.hpp"

namespace hodograph {

namespace {

using Vector = Vector3<double>;

std::optional<Fault> vector_fault(const Vector& v, std::size_t index, const char* name) {
  if (!is_finite(v)) {
    return Fault{FaultCode::not_finite,
                 std::string("the ") + name + " has a component that is not a finite number",
                 index,
                 name,
                 std::nullopt,
                 std::nullopt};
  }
  if (largest_component(v) == 0.0) {
    return Fault{FaultCode::outside_domain,
                 std::string("the ") + name + " is zero; give it a vector with a length",
                 index,
                 name,
                 0.0,
                 std::nullopt};
  }
  return std::nullopt;
}

/// v/|v|, for every size of v but zero.
Vector unit(const Vector& v) {
  int exponent = 0;
  std::frexp(largest_component(v), &exponent);
  const Vector scaled{std::ldexp(v.x, -exponent), std::ldexp(v.y, -exponent),
                      std::ldexp(v.z, -exponent)};
  return (1.0 / std::sqrt(dot(scaled, scaled))) * scaled;
}

/// cos φ/2 + i sin φ/2 from (cos φ, sin φ) times any positive number.
Roll<double> half_of(double cosine, double sine) {
  const double size = std::hypot(cosine, sine);
  const double c = cosine / size, s = sine / size;
  if (c >= 0.0) {
    const double half = std::sqrt(0.5 * (1.0 + c));
    return {half, 0.5 * s / half};
  }
  const double half = std::sqrt(0.5 * (1.0 - c));
  return {0.5 * std::abs(s) / half, std::copysign(half, s)};
}

/// Domain: unit e1, e2 not parallel to it.
Quaternion<double> frame_of(const Vector& e1, const Vector& e2) {
  const Quaternion<double> any = hermite_detail::fibre(e1);
  const auto frame = scaled_frame(any);
  Quaternion<double> q = any * half_of(dot(frame.e2, e2), dot(frame.e3, e2));
  q = (1.0 / std::sqrt(dot(q, q))) * q;
  return q.w < 0.0 ? -q : q;
}

}  // namespace

Result<Quaternion<double>> frame_towards(const Vector& direction, const Vector& normal) {
  if (auto fault = vector_fault(direction, 0, "direction")) return *std::move(fault);
  if (auto fault = vector_fault(normal, 1, "normal")) return *std::move(fault);
  const Vector e1 = unit(direction), other = unit(normal);
  const Vector across = other - dot(e1, other) * e1;
  const double sine = std::sqrt(dot(across, across));
  if (!(sine > accuracy::join_error<double>())) {
    return Fault{FaultCode::outside_domain,
                 "the normal is parallel to the direction; give it a part across the direction",
                 1,
                 "normal",
                 sine,
                 accuracy::join_error<double>()};
  }
  return frame_of(e1, across);
}

Result<Quaternion<double>> level_frame(const Vector& direction, double roll) {
  if (auto fault = vector_fault(direction, 0, "direction")) return *std::move(fault);
  if (!std::isfinite(roll)) {
    return Fault{FaultCode::not_finite, "the roll is not a finite number of radians",
                 std::nullopt,          "roll",
                 std::nullopt,          std::nullopt};
  }
  const Vector e1 = unit(direction);
  const bool vertical = e1.x == 0.0 && e1.y == 0.0;
  const Quaternion<double> level =
      frame_of(e1, vertical ? Vector{0.0, 1.0, 0.0} : unit(Vector{-e1.y, e1.x, 0.0}));
  if (roll == 0.0) return level;
  const Quaternion<double> q = level * Roll<double>{std::cos(0.5 * roll), std::sin(0.5 * roll)};
  return q.w < 0.0 ? -q : q;
}

}  // namespace hodograph
