// SPDX-License-Identifier: MIT
#include "roll_integral.hpp"

#include <complex>
#include <cstdint>
#include <numbers>

#include "complex_roots.hpp"
#include "hodograph/foundation/accuracy.hpp"

namespace hodograph::frame_detail {

std::optional<Estimated> integral_by_partial_fractions(const Row<double>& p, const Row<double>& q) {
  using Number = std::complex<double>;
  const Row<double> numerator = power_coefficients(p), denominator = power_coefficients(q);
  const auto roots = complex_roots(Row<Number>(denominator.begin(), denominator.end()));
  if (!roots) return std::nullopt;
  Estimated total;
  const auto n = static_cast<double>(q.size() - 1);
  for (const Number& z : *roots) {
    if (!(z.imag() > 0.0)) continue;
    const PowerJet top = power_jet(numerator, z), bottom = power_jet(denominator, z);
    const Number residue = top.value / bottom.first, log = -std::log(-z);
    const double slope = std::abs(bottom.first);
    const double delta = 2.0 * (n + 1.0) * epsilon<double>() * bottom.size / slope;
    const double residue_error =
        (delta * (std::abs(top.first) + std::abs(residue * bottom.second)) +
         n * epsilon<double>() * (top.size + std::abs(residue) * bottom.slope_size)) /
        slope;
    total.value += 2.0 * (residue * log).real();
    total.error += 2.0 * (residue_error * std::abs(log) +
                          std::abs(residue) * (delta / std::abs(z) + 4.0 * epsilon<double>()));
  }
  if (!std::isfinite(total.value) || !std::isfinite(total.error)) return std::nullopt;
  return total;
}

std::optional<HelicalPart> helical_part(const Row<Quaternion<double>>& preimage) {
  double largest = 0.0;
  const Quaternion<double>* first = nullptr;
  for (const auto& a : preimage) {
    if (const double size = norm(a); largest < size) {
      largest = size;
      first = &a;
    }
  }
  if (first == nullptr) return std::nullopt;
  const Quaternion<double> e0 = (1.0 / largest) * *first;
  const auto without = [](const Quaternion<double>& a, const Quaternion<double>& e) {
    return a - dot(a, e) * e;
  };
  const double negligible = accuracy::join_error<double>() * largest;
  Quaternion<double> widest{};
  double width = 0.0;
  for (const auto& a : preimage) {
    const auto rest = without(without(a, e0), e0);
    if (const double size = norm(rest); width < size) {
      width = size;
      widest = rest;
    }
  }
  HelicalPart part;
  if (!(width > negligible)) {
    for (const auto& a : preimage) part.w.push_back({dot(a, e0), 0.0});
    return part;
  }
  const Quaternion<double> e1 = (1.0 / width) * widest;
  for (const auto& a : preimage) {
    const auto rest = without(without(a, e0), e1);
    if (!(norm(rest) <= negligible)) return std::nullopt;
    part.w.push_back({dot(a, e0), dot(a, e1)});
  }
  part.factor = 2.0 * twist_form(e0, e1);
  return part;
}

}  // namespace hodograph::frame_detail
