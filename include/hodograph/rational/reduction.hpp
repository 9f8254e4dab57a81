// SPDX-License-Identifier: MIT
// Reduction of a quaternion polynomial with respect to i: what turns about the tangent, and what
// only scales, is divided out.
#pragma once

#include "hodograph/rational/polynomial.hpp"

namespace hodograph {

/// A = reduced · (re + im i), re + im i monic. `reduced` has no real factor of positive degree and
/// no right factor with coefficients in ℚ(i); A and `reduced` have the same tangent indicatrix, and
/// A i A* = (re² + im²) · reduced i reduced*.
struct Reduction {
  QuaternionPolynomial reduced;
  RationalPolynomial re, im;

  /// True when nothing was divided out.
  bool was_reduced() const { return re.is_one() && im.is_zero(); }
  /// re² + im², the content of A i A*.
  RationalPolynomial content() const { return re * re + im * im; }
};

/// The reduction of A with respect to i. With A = u + j v, u = w + x i and v = y - z i, the right
/// factors of A in ℚ(i)[t] are the common divisors of u and v; the largest one is divided out.
/// Exact. Faults: outside_domain for A = 0. Source: Definition 3.4; the algorithm is our own.
Result<Reduction> reduction(const QuaternionPolynomial& a);

}  // namespace hodograph
