// SPDX-License-Identifier: MIT
// Hermite's reduction for one denominator and many numerators.
#pragma once

#include <vector>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph::rational_detail {

/// ∫ p / (α rad α) = q / α + ∫ l / rad α for proper p / (α rad α), with deg q < deg α and
/// deg l < deg rad α. Linear in p. What depends on α alone (inverses modulo its square-free parts)
/// is computed once.
class HermiteReduction {
 public:
  /// α ≠ 0; its leading coefficient counts.
  explicit HermiteReduction(const RationalPolynomial& alpha);

  const RationalPolynomial& alpha() const { return alpha_; }
  const RationalPolynomial& radical() const { return radical_; }
  /// α rad α.
  const RationalPolynomial& denominator() const { return denominator_; }

  struct Parts {
    RationalPolynomial rational;     ///< q
    RationalPolynomial logarithmic;  ///< l
  };
  /// The parts for p, deg p < deg α + deg rad α (contract).
  Parts reduce(RationalPolynomial p) const;

 private:
  // With g_0 = α, g_{i+1} = gcd(g_i, g_i'), s_i = g_i / g_{i+1}: p / (g_i rad α) is the derivative
  // of b / g_i plus c / (g_{i+1} rad α), where b (-rad α g_i' / g_i) + c s_i = p.
  struct Stage {
    RationalPolynomial squares, slope, inverse, rest, cofactor;
  };
  RationalPolynomial alpha_, radical_, denominator_;
  std::vector<Stage> stages_;
};

}  // namespace hodograph::rational_detail
