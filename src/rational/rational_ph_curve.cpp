// SPDX-License-Identifier: MIT
// What a rational PH curve is and has, exactly.
#include "hodograph/rational/rational_ph_curve.hpp"

#include <cassert>
#include <utility>

#include "hodograph/rational/reduction.hpp"

namespace hodograph {

namespace {

VectorPolynomial binormal(const VectorPolynomial& f) { return cross(f, derivative(f)); }
RationalPolynomial torsion(const VectorPolynomial& f) {
  return determinant(f, derivative(f), derivative(derivative(f)));
}
std::vector<RealRoot> roots_unless_zero(const RationalPolynomial& p) {
  return p.is_zero() ? std::vector<RealRoot>() : real_roots(p);
}

/// ∫ λ F, known to be rational.
VectorFunction integral(const RationalFunction& lambda, const VectorPolynomial& f) {
  VectorFunction sum;
  for (std::size_t c = 0; c < 3; ++c) {
    const RationalIntegral part = hodograph::integral(lambda * RationalFunction(f[c]));
    assert(part.obstruction.is_zero());
    VectorPolynomial numerator;
    numerator[c] = part.rational.numerator();
    sum = sum + VectorFunction(numerator, part.rational.denominator());
  }
  return sum;
}

}  // namespace

Result<RationalPhCurve> RationalPhCurve::create(const QuaternionPolynomial& a, VectorFunction r) {
  auto reduced = reduction(a);
  if (!reduced) return reduced.fault();
  RationalPhCurve curve;
  curve.preimage_ = std::move(reduced->reduced);
  curve.indicatrix_ = hodograph::indicatrix(curve.preimage_);
  const VectorFunction velocity = r.derivative();
  const VectorPolynomial& f = curve.indicatrix_;
  if (degree(cross(velocity.numerator(), f)) >= 0) {
    return Fault{FaultCode::outside_domain,
                 "the hodograph of the curve is not parallel to A i A* = (" + to_text(f.x) + ", " +
                     to_text(f.y) + ", " + to_text(f.z) +
                     "); right would be a curve whose tangent A gives",
                 std::nullopt, "hodograph"};
  }
  for (std::size_t c = 0; c < 3; ++c) {
    if (f[c].is_zero()) continue;
    curve.lambda_ = RationalFunction(velocity.numerator()[c], velocity.denominator() * f[c]);
    break;
  }
  curve.position_ = std::move(r);
  return curve;
}

Result<RationalPhCurve> RationalPhCurve::create(const QuaternionPolynomial& a,
                                                const RationalPolynomial& alpha,
                                                const VectorPolynomial& b) {
  if (alpha.is_zero()) {
    return Fault{FaultCode::outside_domain,
                 "the denominator alpha is 0; right would be any polynomial other than 0",
                 std::nullopt, "alpha", 0.0};
  }
  return create(a, VectorFunction(RationalPolynomial(-2) * b, alpha));
}

Result<RationalPhCurve> RationalPhCurve::from_osculating_planes(const QuaternionPolynomial& a,
                                                                const RationalFunction& f) {
  const auto reduced = reduction(a);
  if (!reduced) return reduced.fault();
  const VectorPolynomial u = binormal(hodograph::indicatrix(reduced->reduced));
  const VectorPolynomial u1 = derivative(u), u2 = derivative(u1);
  const RationalPolynomial d = determinant(u, u1, u2);
  if (d.is_zero()) {
    return Fault{FaultCode::outside_domain,
                 "det(F, F', F'') of F = A i A* is identically 0: the curve is planar, and its one "
                 "osculating plane does not determine it; right would be an A whose indicatrix "
                 "lies in no plane through 0",
                 std::nullopt, "det(F, F', F'')", 0.0};
  }
  const RationalFunction f1 = f.derivative(), f2 = f1.derivative();
  const RationalPolynomial one(1);
  const VectorFunction sum = f * VectorFunction(cross(u1, u2), one) +
                             f1 * VectorFunction(cross(u2, u), one) +
                             f2 * VectorFunction(cross(u, u1), one);
  return create(a, RationalFunction(one, d) * sum);
}

RationalFunction RationalPhCurve::speed() const {
  return lambda_ * RationalFunction(norm_polynomial(preimage_));
}

CurveKind RationalPhCurve::kind() const {
  if (lambda_.is_zero()) return CurveKind::constant;
  return position_.is_polynomial() ? CurveKind::polynomial : CurveKind::rational;
}

DualQuaternionPolynomial RationalPhCurve::motion() const {
  const RationalPolynomial half(Rational(-1, 2));
  const auto whole =
      framing_motion(preimage_, position_.denominator(), half * position_.numerator());
  const RationalPolynomial common = content(whole);
  return {divided(whole.primal, common), divided(whole.dual, common)};
}

RationalFunction RationalPhCurve::osculating_planes() const {
  return dot(VectorFunction(binormal(indicatrix_), RationalPolynomial(1)), position_);
}

std::vector<RealRoot> RationalPhCurve::stationary_points() const {
  return roots_unless_zero(lambda_.numerator());
}
std::vector<RealRoot> RationalPhCurve::inflections() const {
  return roots_unless_zero(content(binormal(indicatrix_)));
}
std::vector<RealRoot> RationalPhCurve::torsion_zeros() const {
  return roots_unless_zero(torsion(indicatrix_));
}
bool RationalPhCurve::is_planar() const { return torsion(indicatrix_).is_zero(); }

RationalPhCurve::Frame RationalPhCurve::frame() const {
  const RationalPolynomial zero, one(1);
  return {indicatrix_, sandwich(preimage_, VectorPolynomial{zero, one, zero}),
          sandwich(preimage_, VectorPolynomial{zero, zero, one})};
}

VectorPolynomial RationalPhCurve::angular_velocity() const {
  return RationalPolynomial(2) * vector_part(conjugate(preimage_) * derivative(preimage_));
}

RationalPhCurve::Decomposition RationalPhCurve::decomposition() const {
  Decomposition result;
  PartialFractions split = partial_fractions(lambda_);
  result.polynomial_lambda = std::move(split.polynomial);
  VectorFunction rest =
      position_ - integral(RationalFunction(result.polynomial_lambda), indicatrix_);
  for (auto& part : split.parts) {
    VectorFunction curve = integral(part.value, indicatrix_);
    rest = rest - curve;
    result.pieces.push_back({std::move(part.pole), std::move(part.value), std::move(curve)});
  }
  assert(rest.is_constant());
  for (std::size_t c = 0; c < 3; ++c) result.constant[c] = rest.numerator()[c].coefficient(0);
  return result;
}

}  // namespace hodograph
