// SPDX-License-Identifier: MIT
// Faults of A and α.
#include "input_faults.hpp"

#include <string>

#include "hodograph/rational/solution_space.hpp"

namespace hodograph::rational_detail {

Fault degree_fault(const char* what, std::size_t degree, std::size_t bound) {
  return {FaultCode::unsupported,
          std::string(what) + " has degree " + std::to_string(degree) + "; at most " +
              std::to_string(bound) + " is offered",
          std::nullopt,
          what,
          static_cast<double>(degree),
          static_cast<double>(bound)};
}

std::optional<Fault> input_fault(const QuaternionPolynomial& a, const RationalPolynomial& alpha) {
  if (degree(a) < 0) return reduction(a).fault();
  if (alpha.is_zero()) {
    return Fault{FaultCode::outside_domain,
                 "the denominator alpha is 0; right would be any polynomial other than 0",
                 std::nullopt, "alpha", 0.0};
  }
  const auto a_degree = static_cast<std::size_t>(degree(a));
  const auto alpha_degree = static_cast<std::size_t>(alpha.degree());
  if (a_degree > largest_input_degree) return degree_fault("A", a_degree, largest_input_degree);
  if (alpha_degree > largest_input_degree) {
    return degree_fault("alpha", alpha_degree, largest_input_degree);
  }
  return std::nullopt;
}

}  // namespace hodograph::rational_detail
