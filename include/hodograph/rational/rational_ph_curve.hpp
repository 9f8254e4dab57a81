// SPDX-License-Identifier: MIT
// A rational PH curve as an exact value: position, speed, arc length, singular points, framing
// motion, dual form, decomposition by poles.
#pragma once

#include <optional>
#include <vector>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/real_roots.hpp"
#include "hodograph/rational/solution_space.hpp"

namespace hodograph {

/// r = p / q in lowest terms with r' = λ F, F = A i A*, A reduced with respect to i. Immutable.
/// Equations are those of "Rational Framing Motions and Spatial Rational Pythagorean Hodograph
/// Curves".
class RationalPhCurve {
 public:
  /// The curve r, which A frames. A is reduced first.
  /// Faults: outside_domain (A = 0; a hodograph that is not parallel to A i A*).
  static Result<RationalPhCurve> create(const QuaternionPolynomial& a, VectorFunction r);
  /// r = -2 B / α. Faults: those of create, and outside_domain for α = 0.
  static Result<RationalPhCurve> create(const QuaternionPolynomial& a,
                                        const RationalPolynomial& alpha, const VectorPolynomial& b);
  /// The curve whose osculating planes are u · x = f, u = F × F' (equation (4)):
  ///   r = (f u' × u'' + f' u'' × u + f'' u × u') / det(u, u', u'').
  /// Faults: outside_domain for A = 0 and where det(F, F', F'') vanishes identically: all
  /// osculating planes are then parallel, and f says nothing of the curve within them.
  static Result<RationalPhCurve> from_osculating_planes(const QuaternionPolynomial& a,
                                                        const RationalFunction& f);

  const QuaternionPolynomial& preimage() const { return preimage_; }
  /// F = A i A*.
  const VectorPolynomial& indicatrix() const { return indicatrix_; }
  const VectorFunction& position() const { return position_; }
  /// λ.
  const RationalFunction& lambda() const { return lambda_; }
  /// σ = λ |A|², with the sign of λ: r' · r' = σ², and the unit tangent is F / |A|² where σ > 0.
  RationalFunction speed() const;
  CurveKind kind() const;

  /// ∫ σ: the arc length is rational exactly when the obstruction is 0.
  RationalIntegral arc_length() const { return integral(speed()); }
  bool arc_length_is_rational() const { return arc_length().obstruction.is_zero(); }

  /// The motion (α + ε B) A with α = q, B = -p/2, and no common real factor left.
  DualQuaternionPolynomial motion() const;
  /// f = u · r with u = F × F': the osculating planes are u · x = f.
  RationalFunction osculating_planes() const;

  /// The real poles of r.
  std::vector<RealRoot> poles() const { return real_roots(position_.denominator()); }
  /// The real zeros of λ, where the curve stops; it turns back (a cusp) where the multiplicity is
  /// odd. Empty for a point.
  std::vector<RealRoot> stationary_points() const;
  /// The real zeros of F × F', where the curvature vanishes or the indicatrix has a cusp. Empty for
  /// straight lines.
  std::vector<RealRoot> inflections() const;
  /// The real zeros of det(F, F', F''), where the torsion vanishes. Empty for planar curves.
  std::vector<RealRoot> torsion_zeros() const;
  /// True when F lies in a plane through 0: the curve is planar.
  bool is_planar() const;

  /// The frame (e_1, e_2, e_3) that A carries, |A|² times: A i A*, A j A*, A k A*.
  struct Frame {
    VectorPolynomial e1, e2, e3;
  };
  Frame frame() const;
  /// 2 vec(A* A'): |A|² times the angular velocity with respect to t, in components of the frame.
  VectorPolynomial angular_velocity() const;
  /// True when the frame is rotation-minimising: its first component of angular velocity is 0.
  bool frame_is_rotation_minimising() const { return angular_velocity().x.is_zero(); }

  /// r = Σ pieces + ∫ polynomial_lambda F + constant: λ split into principal parts over the
  /// irreducible factors of its denominator, each of which integrates to a rational PH curve with
  /// poles there alone (and no constant term).
  struct Piece {
    RationalPolynomial pole;
    RationalFunction lambda;
    VectorFunction curve;
  };
  struct Decomposition {
    RationalPolynomial polynomial_lambda;
    std::vector<Piece> pieces;
    RationalVector constant;
  };
  Decomposition decomposition() const;

 private:
  RationalPhCurve() = default;
  QuaternionPolynomial preimage_;
  VectorPolynomial indicatrix_;
  VectorFunction position_;
  RationalFunction lambda_;
};

}  // namespace hodograph
