// SPDX-License-Identifier: MIT
#include "cli/sample_plan.hpp"

#include "hodograph/path/arc_length_map.hpp"
#include "hodograph/path/sampling.hpp"

namespace hodograph::cli {
namespace {

static_assert(maximum_count == maximum_sample_count);

/// The fault of the first value outside [low, high], if there is one.
std::optional<Fault> outside(const std::vector<double>& values, double low, double high,
                             const char* quantity) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (low <= values[i] && values[i] <= high) continue;
    return Fault{FaultCode::outside_domain,
                 std::string(quantity) + " " + to_text(values[i]) + " is outside [" + to_text(low) +
                     ", " + to_text(high) + "]",
                 i,
                 quantity,
                 values[i],
                 values[i] < low ? low : high};
  }
  return std::nullopt;
}

}  // namespace

double parameter_at(const AnyPath& path, double arc_length) {
  return path.visit([&](const auto& p) { return parameter_at_arc_length(p, arc_length); });
}

Result<std::vector<double>> sampled_parameters(const AnyPath& path, const SamplePlan& plan) {
  return path.visit([&](const auto& p) -> Result<std::vector<double>> {
    if (plan.count) return parameters_even_in_arc_length(p, *plan.count);
    if (plan.count_in_xi) return parameters_even_in_xi(p, *plan.count_in_xi);
    if (plan.count_per_segment) return parameters_per_segment(p, *plan.count_per_segment);
    if (plan.step) return parameters_by_arc_length_step(p, *plan.step);
    if (plan.chord_tolerance) return polyline_parameters(p, *plan.chord_tolerance);
    if (plan.xi) {
      if (auto fault = outside(*plan.xi, p.xi_begin(), p.xi_end(), "xi")) return *fault;
      return *plan.xi;
    }
    const std::vector<double>& lengths = plan.arc_length.value();
    if (auto fault = outside(lengths, 0.0, p.arc_length(), "arc length")) return *fault;
    std::vector<double> xi;
    xi.reserve(lengths.size());
    for (const double s : lengths) xi.push_back(parameter_at_arc_length(p, s));
    return xi;
  });
}

}  // namespace hodograph::cli
