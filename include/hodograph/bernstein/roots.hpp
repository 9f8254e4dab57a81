// SPDX-License-Identifier: MIT
// The real roots of a Bernstein polynomial on [0, 1], isolated rigorously.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/bernstein/polynomial.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph {

/// What is known of an interval that may hold roots.
enum class RootKind {
  simple,   ///< exactly one root, where the derivative is not zero: certain
  cluster,  ///< undecided: a multiple root, several close roots, or none, within rounding
};

/// An interval of [0, 1] and the sign of the polynomial on either side of it: -1, +1, or 0 where
/// that is not known or the interval reaches the end of [0, 1]. For a simple root they are
/// opposite, also at the ends of [0, 1], where they continue the polynomial.
struct IsolatedRoot {
  Enclosure u;
  RootKind kind = RootKind::cluster;
  int sign_before = 0, sign_after = 0;

  friend bool operator==(const IsolatedRoot&, const IsolatedRoot&) = default;
};

/// The roots on [0, 1] of f(u) = Σ c_i B_i^n(u), where each c_i is any number in the i-th enclosure
/// (a double is the enclosure of itself).
///
/// Promise, rounding included: every real root in [0, 1] lies in one of the intervals; an interval
/// called simple holds exactly one. The intervals are disjoint and ascending. The width of a simple
/// one is a few times the rounding noise of f divided by |f'|, at least about an ulp; the width of
/// a cluster, the size of the set where f is not distinguished from 0.
///
/// Method: subdivision at midpoints in outward rounded arithmetic. A piece whose coefficients have
/// one sign holds no root; one whose coefficients increase (decrease) strictly is monotone, so the
/// signs at its ends decide, and interval Newton steps refine. Depth and work are bounded for every
/// input; what is then undecided is a cluster. Where pieces meet at a root, they are joined and the
/// join is examined again.
///
/// Faults: too_few (no coefficient), not_finite (with the index), outside_domain (all coefficients
/// are exactly 0: every point is a root). Domain: any degree; the work grows like its cube.
Result<std::vector<IsolatedRoot>> isolated_roots(std::span<const Enclosure> coefficients);

/// The same for coefficients that are doubles or enclosures.
template <class S, std::size_t n>
  requires(std::convertible_to<S, Enclosure>)
Result<std::vector<IsolatedRoot>> isolated_roots(const BernsteinPolynomial<S, n>& f) {
  std::array<Enclosure, n + 1> coefficients;
  for (std::size_t i = 0; i <= n; ++i) coefficients[i] = Enclosure(f[i]);
  return isolated_roots(std::span<const Enclosure>(coefficients));
}

}  // namespace hodograph
