// SPDX-License-Identifier: MIT
#include "hodograph/orbit/three_body.hpp"

#include <string>

namespace hodograph {

std::optional<Fault> check_system(const ThreeBodySystem& system) {
  const double mu = system.mass_ratio;
  if (!(mu > 0.0 && mu <= 0.5)) {
    return Fault{FaultCode::outside_domain,
                 "the mass ratio is " + to_text(mu) +
                     "; it is the smaller primary's share of the mass, in (0, 0.5]",
                 {},
                 "mass_ratio",
                 mu,
                 0.5};
  }
  const auto check_unit = [](double unit, const char* name,
                             const char* measure) -> std::optional<Fault> {
    if (unit > 0.0 && is_finite(unit)) return std::nullopt;
    return Fault{FaultCode::outside_domain,
                 std::string("the ") + name + " is " + to_text(unit) + " " + measure +
                     "; it must be positive and finite",
                 {},
                 name,
                 unit,
                 0.0};
  };
  if (auto fault = check_unit(system.length_unit_km, "length unit", "km")) return fault;
  return check_unit(system.time_unit_s, "time unit", "s");
}

}  // namespace hodograph
