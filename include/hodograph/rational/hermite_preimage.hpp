// SPDX-License-Identifier: MIT
// Preimages A over ℚ whose tangents have given directions at the ends of an interval.
//
// A direction T with rational coordinates and length 1 is that of a i a* for a = T + i (a = k where
// T = -i), and of a (x + y i) for every complex number x + y i ≠ 0: those are free factors, of
// which only the ratio of the two ends matters. Between the ends A is free: Bézier coefficients.
#pragma once

#include <optional>
#include <vector>

#include "hodograph/rational/cone_test.hpp"

namespace hodograph {

/// A vector of length 1 over ℚ.
struct RationalDirection {
  RationalVector unit;
  /// The length of the vector it came from where that is rational, else a number near it (relative
  /// error at most 2^-62).
  Rational length;
  bool exact = true;  ///< parallel to that vector
  /// The sine of the angle between them, rounded; 0 where exact.
  double deviation = 0.0;
};
/// How near a direction of irrational length is replaced: the angle is at most 2^-bits.
inline constexpr long default_direction_bits = 30;

/// The direction of v: v / |v| where |v| is rational; else the simplest point of the stereographic
/// projection, whose points are rational, within the angle 2^-bits of v (1 ≤ bits ≤ 60).
/// Faults: zero_speed (v = 0), outside_domain (bits).
Result<RationalDirection> rational_direction(const RationalVector& v,
                                             long bits = default_direction_bits);

/// a with a i a* a positive multiple of T, |T| = 1 (contract): the multiple of T + i, or k for T =
/// -i, whose coordinates are whole and coprime.
Quaternion<Rational> direction_preimage(const RationalVector& unit);

/// What is free in a preimage.
struct PreimageFreedom {
  Rational factor_re = 1, factor_im = 0;  ///< the free factor at the end; that at the begin is 1
  std::vector<Quaternion<Rational>> inner{};  ///< Bézier coefficients between the ends
};
/// A = Σ B_k^n(u) a_k, u = (t - begin) / (end - begin), a_0 and a_n those of the two directions,
/// n = 1 + the number of inner coefficients: F has the directions at the ends. Domain: directions
/// of length 1 (contract). Faults: not_increasing; outside_domain (factor 0).
Result<QuaternionPolynomial> preimage_between(const RationalVector& begin_direction,
                                              const RationalVector& end_direction,
                                              const PreimageFreedom& freedom,
                                              const Rational& begin = 0, const Rational& end = 1);

/// What a curve is asked to do, for the choice of A.
struct HermiteEnds {
  RationalVector chord;                                ///< P_1 - P_0
  RationalVector begin_direction, end_direction;       ///< of length 1 (contract)
  std::optional<Rational> begin_speed{}, end_speed{};  ///< > 0; of C¹ data
  Rational begin = 0, end = 1;
};
/// A choice of what is free, for those who have no A: the preimage of degree 2 of the PH quintic
/// in double through the data (hermite.hpp), with speeds of the size of the chord where only
/// directions are given, rounded to few digits with the end directions kept exactly; the first with
/// a polynomial λ > 0 of degree 2 (4 for C¹ data), so that there is a curve of degree 7 (9); else
/// the first whose cone of tangents holds the chord. Where no such quintic serves (a closed curve,
/// tangents that ask it to turn back), a grid of small inner coefficients.
struct ChosenPreimage {
  QuaternionPolynomial preimage;
  PreimageFreedom freedom;
  ConeTest cone;  ///< inside
};
/// Faults: not_increasing; zero_speed (a speed ≤ 0); outside_domain (numbers beyond the range of
/// doubles); no_interpolant (none of those tried).
Result<ChosenPreimage> chosen_preimage(const HermiteEnds& ends);

}  // namespace hodograph
