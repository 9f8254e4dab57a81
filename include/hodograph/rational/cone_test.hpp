// SPDX-License-Identifier: MIT
// Can any curve with the tangents of A run from one point to another without a cusp? Decided before
// any space is solved, whatever α and the degree.
//
// With λ > 0 the chord ∫ λ F is a positive combination of the F(t), t in [begin, end]: it lies in
// the relative interior of their convex cone. Conversely, every chord in there belongs to some
// polynomial λ > 0, since polynomials come as close as one likes to any positive weight.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hodograph/rational/polynomial.hpp"

namespace hodograph {

struct ConeTest {
  enum class Outcome {
    inside,     ///< cusp-free curves exist for polynomial λ of high enough degree
    outside,    ///< no curve without a cusp, whatever α and the degree
    undecided,  ///< the chord is too near to the boundary of the cone for the rounds allowed
  };
  Outcome outcome = Outcome::undecided;
  std::string sentence;

  /// Proof of `outside`: n · F ≥ 0 on [begin, end] and n · chord ≤ 0, one of them not with
  /// equality throughout (n · F is not identically 0, or n · chord < 0).
  RationalVector normal;
  /// Proof of `inside`: chord = Σ weights F(nodes), all weights positive, and these F(t) span what
  /// all F span.
  std::vector<Rational> nodes, weights;
  /// Linear programs that were solved.
  std::size_t rounds = 0;
};

/// The most linear programs that a search solves before it says that it has not decided.
inline constexpr std::size_t default_rounds = 48;

/// Whether the chord lies in the relative interior of the convex cone of the F(t), exactly.
/// `undecided` can only happen where the boundary itself passes through the chord, or within what
/// the rounds can tell from it. Domain: F(t) ≠ 0 on [begin, end], begin < end (contract).
ConeTest cone_test(const VectorPolynomial& indicatrix, const RationalVector& chord,
                   const Rational& begin, const Rational& end,
                   std::size_t most_rounds = default_rounds);

/// True when the proof that the answer carries holds: recomputed without linear programming.
bool holds(const ConeTest& answer, const VectorPolynomial& indicatrix, const RationalVector& chord,
           const Rational& begin, const Rational& end);

}  // namespace hodograph
