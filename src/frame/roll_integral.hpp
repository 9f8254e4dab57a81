// SPDX-License-Identifier: MIT
// The twist of the Euler-Rodrigues frame over one segment, ∫ 2N/σ, in closed form.
#pragma once

#include <optional>

#include "hodograph/algebra/quaternion.hpp"
#include "rows.hpp"

namespace hodograph::frame_detail {

/// A value and an estimate of its error from above.
struct Estimated {
  double value = 0.0, error = 0.0;
};

/// ∫₀¹ P/Q of real polynomials, deg P ≤ deg Q - 2, Q > 0 on [0, 1], by partial fractions:
///   Σ over the roots r of Q with Im r > 0 of 2 Re[ P(r)/Q'(r) log((1-r)/(-r)) ].
/// In z = u/(1-u) the polynomials have the coefficients C(n,i) c_i, the residue is P(z)/Q'(z) and
/// the logarithm -log(-z), whatever the degree of Q really is.
/// Source: errata of the loops paper (P = 2N, Q = σ).
///
/// The error: a root is known to δ = 2 (n + 1) ε Σ |a_k z^k|/|Q'(z)|; to first order the residue
/// then changes by δ (|P'| + |P Q''/Q'|)/|Q'| and the logarithm by δ/|z|. Close roots make all of
/// these large: at a distance d the error grows like ε/d². Nothing where a root is not found or the
/// sum is not finite.
std::optional<Estimated> integral_by_partial_fractions(const Row<double>& p, const Row<double>& q);

/// The real span of the coefficients of a preimage has two dimensions (or one) where the path is
/// helical: A = E₀ a + E₁ b with orthonormal E₀, E₁. With w = a + i b: σ = |w|², and
/// 2N/σ = factor · (arg w)', factor = 2 twist_form(E₀, E₁), which is twice the sine of the angle
/// between the tangent and the plane across the axis.
struct HelicalPart {
  Row<Complex<double>> w;
  double factor = 0.0;
};
/// The decomposition, by orthogonalising (no axis is looked for: path/helix.hpp), where what is
/// left of every coefficient is below accuracy::join_error of the largest. Source: (24), (33) and
/// Remark 2 of the helical paper.
std::optional<HelicalPart> helical_part(const Row<Quaternion<double>>& preimage);

}  // namespace hodograph::frame_detail
