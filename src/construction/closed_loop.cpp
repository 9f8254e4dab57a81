// SPDX-License-Identifier: MIT
// Closed loops: checks, the member's numbers, placement.
#include "hodograph/construction/closed_loop.hpp"

#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "hodograph/construction/detail/closed_loop_kernel.hpp"
#include "hodograph/foundation/accuracy.hpp"

namespace hodograph {

namespace {

constexpr double pi = std::numbers::pi;

std::optional<Fault> shape_fault(const LoopShape& shape) {
  if (std::isnan(shape.xi)) {
    return Fault{FaultCode::not_finite,
                 "xi is not a number; give it a real number, or an infinity for a limit member",
                 std::nullopt,
                 "xi",
                 std::nullopt,
                 std::nullopt};
  }
  if (!std::isfinite(shape.psi)) {
    return Fault{FaultCode::not_finite,
                 "psi must be a finite number of radians in [-pi, pi]; got " + to_text(shape.psi),
                 std::nullopt,
                 "psi",
                 std::nullopt,
                 std::nullopt};
  }
  if (!(std::abs(shape.psi) <= pi)) {
    return Fault{FaultCode::outside_domain,
                 "psi must be in [-pi, pi] (radians); got " + to_text(shape.psi),
                 std::nullopt,
                 "psi",
                 shape.psi,
                 std::copysign(pi, shape.psi)};
  }
  return std::nullopt;
}

std::optional<Fault> placement_fault(const LoopPlacement& placement) {
  if (!(std::isfinite(placement.length) && placement.length > 0.0)) {
    return Fault{
        std::isfinite(placement.length) ? FaultCode::outside_domain : FaultCode::not_finite,
        "the length of a loop must be positive and finite; got " + to_text(placement.length),
        std::nullopt,
        "length",
        std::isfinite(placement.length) ? std::optional<double>(placement.length) : std::nullopt,
        0.0};
  }
  if (!is_finite(placement.start)) {
    return Fault{FaultCode::not_finite, "the start has a coordinate that is not a finite number",
                 std::nullopt,          "start",
                 std::nullopt,          std::nullopt};
  }
  const double square = dot(placement.frame, placement.frame);
  if (!std::isfinite(square)) {
    return Fault{FaultCode::not_finite, "the frame has a component that is not a finite number",
                 std::nullopt,          "frame",
                 std::nullopt,          std::nullopt};
  }
  const double off = std::abs(std::sqrt(square) - 1.0);
  if (!(off <= accuracy::unit_error<double>())) {
    return Fault{
        FaultCode::outside_domain,
        "the frame must be a unit quaternion; its length differs from 1 by " + to_text(off),
        std::nullopt,
        "frame",
        off,
        accuracy::unit_error<double>()};
  }
  return std::nullopt;
}

loop_detail::Member<double> member_of(const LoopShape& shape) {
  loop_detail::Member<double> member{shape.xi, 1.0, std::cos(shape.psi), std::sin(shape.psi)};
  if (std::abs(shape.psi) == pi) {
    member.cosine = -1.0;
    member.sine = 0.0;
  } else if (std::abs(shape.psi) == 0.5 * pi) {
    member.cosine = 0.0;
  }
  if (std::abs(shape.xi) > 1.0) {
    member.x = std::copysign(1.0, shape.xi);
    member.y = 1.0 / std::abs(shape.xi);
  }
  return member;
}

}  // namespace

Result<SpatialPath<3>> closed_loop(const LoopShape& shape, const LoopPlacement& placement) {
  if (auto fault = shape_fault(shape)) return *std::move(fault);
  if (auto fault = placement_fault(placement)) return *std::move(fault);
  const Quaternion<double>& frame = placement.frame;
  const Quaternion<double> turn =
      (std::sqrt(placement.length) / std::sqrt(dot(frame, frame))) * frame;
  const auto preimage =
      loop_detail::canonical_preimage(member_of(shape)).mapped([&](const Quaternion<double>& a) {
        return turn * a;
      });
  const SpatialPhCurve<3> curve(placement.start, preimage, 1.0);
  for (const auto& c : curve.integral().coefficients()) {
    if (!is_finite(placement.start + c.displacement)) {
      return Fault{FaultCode::not_finite,
                   "a loop of length " + to_text(placement.length) +
                       " from there exceeds the range of numbers",
                   std::nullopt,
                   "length",
                   placement.length,
                   std::nullopt};
    }
  }
  return SpatialPath<3>::create({0.0, 1.0}, {curve}, true);
}

Result<std::array<Vector3<double>, 8>> closed_loop_control_points(const LoopShape& shape) {
  if (auto fault = shape_fault(shape)) return *std::move(fault);
  return loop_detail::canonical_control_points(member_of(shape));
}

Result<LoopJuncture> closed_loop_juncture(const LoopShape& shape) {
  if (auto fault = shape_fault(shape)) return *std::move(fault);
  const auto member = member_of(shape);
  const double w = member.size() * member.y, c = member.cosine, s = member.sine;
  const double c0 = member.c0();
  const double d = 2.0 * s * (3.0 + c);
  const double xi = shape.xi;
  const double f = -(260.0 - 144.0 * c + 4.0 * c * c + 9.0 * xi * xi) / (20.0 * c0 * c0);
  return LoopJuncture{6.0 * member.lambda() / (w * w * w), (d - c0 * xi) * f, (d + c0 * xi) * f};
}

}  // namespace hodograph
