// SPDX-License-Identifier: MIT
// How the preimage turns from the end of one curve to the start of another: by a roll (in the
// plane: a sign) where the tangents agree, and by something else where they do not.
#pragma once

#include <cmath>
#include <cstddef>
#include <string>

#include "hodograph/algebra/preimage_algebra.hpp"
#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/foundation/fault.hpp"

namespace hodograph::path_detail {

/// The largest component of the coefficients.
template <class A, std::size_t n>
typename A::Scalar largest_coefficient(const BernsteinPolynomial<A, n>& f) {
  typename A::Scalar largest(0);
  for (const A& c : f.coefficients()) {
    if (const auto size = largest_component(c); largest < size) largest = size;
  }
  return largest;
}

/// conj(B_0) A_n up to a positive factor. Its w and i parts (in the plane the real part), of size
/// `along`, are what a roll (a sign) makes up for; the others, of size `across`, vanish where the
/// tangents agree, and count as zero up to `allowed` times `along`.
template <class A>
struct PreimageTurn {
  using S = typename A::Scalar;
  A q{};
  S along{}, across{}, allowed{};

  bool is_break() const { return !(across <= allowed * along); }
  /// The angle between the tangents, radians.
  S angle() const {
    using std::atan2;
    return S(2) * S(atan2(across, along));
  }
};

template <class S>
void set_sizes(PreimageTurn<Quaternion<S>>& turn) {
  using std::sqrt;
  turn.along = sqrt(S(turn.q.w * turn.q.w + turn.q.x * turn.q.x));
  turn.across = sqrt(S(turn.q.y * turn.q.y + turn.q.z * turn.q.z));
}
template <class S>
void set_sizes(PreimageTurn<Complex<S>>& turn) {
  using std::abs;
  turn.along = abs(turn.q.re);
  turn.across = abs(turn.q.im);
}

/// The turn from the end of `before` to the start of `after`. Domain: neither is zero there.
/// Allowed is accuracy::join_error of the largest coefficients over the values at the join.
template <class A, std::size_t m, std::size_t n>
PreimageTurn<A> preimage_turn(const BernsteinPolynomial<A, m>& before,
                              const BernsteinPolynomial<A, n>& after) {
  using S = typename A::Scalar;
  const S end = largest_component(before.back()), begin = largest_component(after.front());
  PreimageTurn<A> turn;
  turn.q = conjugate((S(1) / begin) * after.front()) * ((S(1) / end) * before.back());
  set_sizes(turn);
  turn.allowed = S(accuracy::join_error<S>()) *
                 (largest_coefficient(before) / end + largest_coefficient(after) / begin);
  return turn;
}

/// The fault of tangents that break at a knot.
template <class A>
Fault tangent_fault(const PreimageTurn<A>& turn, std::size_t knot, const std::string& what) {
  const double angle = to_double(turn.angle());
  const double bound = 2.0 * to_double(turn.allowed);
  return {FaultCode::not_continuous,
          what + " at an angle of " + to_text(angle) + " rad; at most " + to_text(bound) +
              " is rounding",
          knot,
          "tangent",
          angle,
          bound};
}

}  // namespace hodograph::path_detail
