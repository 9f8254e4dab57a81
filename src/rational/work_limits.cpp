// SPDX-License-Identifier: MIT
#include "hodograph/rational/work_limits.hpp"

#include <algorithm>
#include <string>

namespace hodograph {
namespace {

std::string whole(double x) { return std::to_string(static_cast<long long>(x)); }

}  // namespace

double input_size(const QuaternionPolynomial& a, const RationalPolynomial& alpha) {
  std::size_t bits = 0;
  int most = 1;
  for (std::size_t c = 0; c < 4; ++c) {
    bits = std::max(bits, a[c].bits());
    most = std::max(most, a[c].degree());
  }
  return static_cast<double>(most) * static_cast<double>(bits) +
         static_cast<double>(std::max(1, alpha.degree())) * static_cast<double>(alpha.bits());
}

double root_work(const RationalPolynomial& p) {
  const auto degree = static_cast<double>(std::max(0, p.degree()));
  return degree * degree * static_cast<double>(p.bits());
}

std::optional<Fault> input_size_fault(const QuaternionPolynomial& a,
                                      const RationalPolynomial& alpha) {
  const double size = input_size(a, alpha);
  if (size <= largest_input_size) return std::nullopt;
  return Fault{FaultCode::unsupported,
               "the numbers of A and alpha are too large: degree times bits is " + whole(size) +
                   "; at most " + whole(largest_input_size) + " is offered",
               std::nullopt,
               "A",
               size,
               largest_input_size};
}

std::optional<Fault> root_work_fault(const RationalPolynomial& p) {
  const double work = root_work(p);
  if (work <= largest_root_work) return std::nullopt;
  return Fault{FaultCode::unsupported,
               "the zeros would take too long: the square of the degree times bits is " +
                   whole(work) + "; at most " + whole(largest_root_work) + " is offered",
               std::nullopt,
               "p",
               work,
               largest_root_work};
}

}  // namespace hodograph
