// SPDX-License-Identifier: MIT
#include "cli/sample_plan.hpp"

#include "hodograph/frame/any_batch.hpp"
#include "hodograph/path/any_sampling.hpp"

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
  double xi = 0.0;
  parameters_at_arc_lengths(path, {&arc_length, 1}, {&xi, 1});
  return xi;
}

Result<std::vector<double>> sampled_parameters(const AnyPath& path, const SamplePlan& plan) {
  if (plan.count) return parameters_even_in_arc_length(path, *plan.count);
  if (plan.count_in_xi) return parameters_even_in_xi(path, *plan.count_in_xi);
  if (plan.count_per_segment) return parameters_per_segment(path, *plan.count_per_segment);
  if (plan.step) return parameters_by_arc_length_step(path, *plan.step);
  if (plan.chord_tolerance) return polyline_parameters(path, *plan.chord_tolerance);
  if (plan.xi) {
    if (auto fault = outside(*plan.xi, path.xi_begin(), path.xi_end(), "xi")) return *fault;
    return *plan.xi;
  }
  const std::vector<double>& lengths = plan.arc_length.value();
  if (auto fault = outside(lengths, 0.0, path.arc_length(), "arc length")) return *fault;
  std::vector<double> xi(lengths.size());
  parameters_at_arc_lengths(path, lengths, xi);
  return xi;
}

}  // namespace hodograph::cli
