// SPDX-License-Identifier: MIT
// Whether a surface is free of contact with itself, from the surface alone: for tubular families,
// whose profiles are curves in space.
//
// Derivation. The surface S(v, u) is covered by patches, each the image of a unit square of its own
// parameters. On a convex block of patches S is injective where, for two directions a and b, the
// matrix (a·S_v, a·S_u; b·S_v, b·S_u) is regular for every choice of its entries within their
// ranges: S(q) = S(p) would make the mean of that matrix along the segment from p to q take q - p
// to 0. Patches that touch in the parameters are shown to be parts of such a block, others to be
// apart by a plane between them; what is not shown is halved both ways. S, S_v and S_u are
// quotients of Bernstein polynomials with positive denominators, so that they lie in the convex
// hulls of the quotients of their coefficients.
#pragma once

#include "hodograph/surface/sweep_contact.hpp"

namespace hodograph::surface_detail {

/// Whether the surface, its profile `factor` times as large, certainly does not meet itself: no two
/// parameters have the same point, but for those that a closed profile or a closed motion
/// identifies. For motions without a roll beside their frames; others are never free. Rounding: as
/// contact_of.
SweepContact surface_contact(const Sweep& sweep, double factor);

}  // namespace hodograph::surface_detail
