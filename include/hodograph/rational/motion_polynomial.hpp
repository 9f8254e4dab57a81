// SPDX-License-Identifier: MIT
// Dual quaternion polynomials and the rational motions they describe.
#pragma once

#include "hodograph/rational/rational_function.hpp"

namespace hodograph {

/// P + ε D with ε² = 0, P and D quaternion polynomials. It describes a rational motion when P ≠ 0
/// and the Study condition P D* + D P* = 0 holds.
struct DualQuaternionPolynomial {
  QuaternionPolynomial primal, dual;

  friend DualQuaternionPolynomial operator+(const DualQuaternionPolynomial& a,
                                            const DualQuaternionPolynomial& b) {
    return {a.primal + b.primal, a.dual + b.dual};
  }
  friend DualQuaternionPolynomial operator-(const DualQuaternionPolynomial& a,
                                            const DualQuaternionPolynomial& b) {
    return {a.primal - b.primal, a.dual - b.dual};
  }
  friend DualQuaternionPolynomial operator*(const DualQuaternionPolynomial& a,
                                            const DualQuaternionPolynomial& b) {
    return {a.primal * b.primal, a.primal * b.dual + a.dual * b.primal};
  }
  friend bool operator==(const DualQuaternionPolynomial&,
                         const DualQuaternionPolynomial&) = default;
};

/// P* + ε D*.
DualQuaternionPolynomial conjugate(const DualQuaternionPolynomial& c);
/// The norm c c* = P P* + ε (P D* + D P*): a pair of real polynomials.
struct DualNorm {
  RationalPolynomial primal, dual;
};
DualNorm norm(const DualQuaternionPolynomial& c);
/// P D* + D P* = 0.
bool satisfies_study_condition(const DualQuaternionPolynomial& c);
/// P ≠ 0 and the Study condition.
bool is_motion_polynomial(const DualQuaternionPolynomial& c);
/// The monic greatest common real factor of all eight components, which does not change the motion.
RationalPolynomial content(const DualQuaternionPolynomial& c);

/// The trajectory of the point x under the motion polynomial c:
///   (P - ε D)(1 + ε x)(P* + ε D*) / (P P*) = 1 + ε (P x P* + P D* - D P*) / (P P*).
/// Domain: is_motion_polynomial(c) (contract). Source: equation (2) of "Rational Framing Motions
/// and Spatial Rational Pythagorean Hodograph Curves".
VectorFunction trajectory(const DualQuaternionPolynomial& c, const RationalVector& x);

/// The motion (α + ε B) A, which moves the origin along r = -2 B / α and turns by A (equation (5)).
DualQuaternionPolynomial framing_motion(const QuaternionPolynomial& a,
                                        const RationalPolynomial& alpha, const VectorPolynomial& b);
/// True when the image P i P* of i is tangent to the trajectory of the origin everywhere
/// (Definition 3.3). Domain: a motion polynomial (contract).
bool is_framing(const DualQuaternionPolynomial& c);

/// |A|² = A A*.
RationalPolynomial norm_polynomial(const QuaternionPolynomial& a);
/// F = A i A*, the tangent indicatrix up to its length |A|².
VectorPolynomial indicatrix(const QuaternionPolynomial& a);

}  // namespace hodograph
