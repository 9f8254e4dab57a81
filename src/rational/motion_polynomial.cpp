// SPDX-License-Identifier: MIT
// Dual quaternion polynomials: norm, action on points, the framing property.
#include "hodograph/rational/motion_polynomial.hpp"

#include <cassert>

namespace hodograph {

DualQuaternionPolynomial conjugate(const DualQuaternionPolynomial& c) {
  return {conjugate(c.primal), conjugate(c.dual)};
}

DualNorm norm(const DualQuaternionPolynomial& c) {
  // P D* + D P* is twice the real part of P D*.
  return {norm_polynomial(c.primal), RationalPolynomial(2) * dot(c.primal, c.dual)};
}
bool satisfies_study_condition(const DualQuaternionPolynomial& c) {
  return dot(c.primal, c.dual).is_zero();
}
bool is_motion_polynomial(const DualQuaternionPolynomial& c) {
  return degree(c.primal) >= 0 && satisfies_study_condition(c);
}
RationalPolynomial content(const DualQuaternionPolynomial& c) {
  return gcd(content(c.primal), content(c.dual));
}

VectorFunction trajectory(const DualQuaternionPolynomial& c, const RationalVector& x) {
  assert(is_motion_polynomial(c));
  const VectorPolynomial point{RationalPolynomial(x.x), RationalPolynomial(x.y),
                               RationalPolynomial(x.z)};
  const VectorPolynomial turned = sandwich(c.primal, point);
  const VectorPolynomial moved = RationalPolynomial(2) * vector_part(c.primal * conjugate(c.dual));
  return {turned + moved, norm_polynomial(c.primal)};
}

DualQuaternionPolynomial framing_motion(const QuaternionPolynomial& a,
                                        const RationalPolynomial& alpha,
                                        const VectorPolynomial& b) {
  return {alpha * a, pure(b) * a};
}

bool is_framing(const DualQuaternionPolynomial& c) {
  const VectorFunction velocity = trajectory(c, {}).derivative();
  return degree(cross(velocity.numerator(), indicatrix(c.primal))) < 0;
}

RationalPolynomial norm_polynomial(const QuaternionPolynomial& a) { return dot(a, a); }
VectorPolynomial indicatrix(const QuaternionPolynomial& a) {
  return vector_part(times_i(a) * conjugate(a));
}

}  // namespace hodograph
