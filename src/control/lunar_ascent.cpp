// SPDX-License-Identifier: MIT
#include "hodograph/control/lunar_ascent.hpp"

#include <utility>

#include "hodograph/construction/fit.hpp"
#include "hodograph/orbit/orbit_curve.hpp"

namespace hodograph {

std::array<AscentStart, 6> ascent_starts() {
  return {{{"+z", {0.0, 0.0, 1.0}},
           {"-z", {0.0, 0.0, -1.0}},
           {"+x", {1.0, 0.0, 0.0}},
           {"-x", {-1.0, 0.0, 0.0}},
           {"-y", {0.0, -1.0, 0.0}},
           {"+y", {0.0, 1.0, 0.0}}}};
}

Result<AscentStart> ascent_start(const std::string& name) {
  for (const AscentStart& start : ascent_starts()) {
    if (start.name == name) return start;
  }
  return Fault{FaultCode::unsupported,
               "there is no start '" + name + "'; the starts are +z, -z, +x, -x, -y and +y",
               std::nullopt,
               "start",
               std::nullopt,
               std::nullopt};
}

Result<AscentReference> AscentReference::make(const PeriodicOrbit& orbit, double tolerance) {
  const auto curve = OrbitCurve::make(orbit, OrbitFrame::rotating, OrbitParameter::revolutions, 1);
  if (!curve) return curve.fault();
  FitOptions options;
  options.tolerance = tolerance;
  options.closed = true;
  auto fitted = fit([&](double xi) { return (*curve)(xi); }, 0.0, curve->end(), options);
  if (!fitted) return fitted.fault();
  return AscentReference(
      std::make_shared<const Parts>(Parts{orbit, std::move((*std::move(fitted)).path)}));
}

Result<AscentReference> AscentReference::gateway() {
  const auto orbit = lunar_gateway_nrho();
  if (!orbit) return orbit.fault();
  return make(*orbit);
}

double AscentReference::period_s() const {
  return static_cast<double>(orbit().period) * orbit().system.time_unit_s;
}

Vector3<double> AscentReference::moon() const {
  return {1.0 - orbit().system.mass_ratio, 0.0, 0.0};
}

std::array<Vector3<double>, 4> AscentReference::derivatives(double revolutions) const {
  return path().position_derivatives<3>(path().wrapped(revolutions));
}

}  // namespace hodograph
