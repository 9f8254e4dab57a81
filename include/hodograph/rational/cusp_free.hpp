// SPDX-License-Identifier: MIT
// A curve without cusps among all that meet Hermite data, or a proof that there is none.
//
// λ > 0 on [begin, end] is asked of finitely many parameters, the nodes, first: the largest least
// speed there is a linear program. At most 0: its dual solution, weights w ≥ 0 at the nodes with
// Σ w_i σ(t_i) ≤ 0 for every curve of the space, proves that there is none. Above 0: the curve is
// rounded to small numbers and certified by Sturm's sequence on the whole interval; where it dips
// between the nodes, the dips become nodes.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/rational/cone_test.hpp"
#include "hodograph/rational/hermite_curves.hpp"

namespace hodograph {

/// The largest least speed at some nodes, exactly.
struct NodeOptimum {
  Rational least_speed;              ///< max over x of min over the nodes of σ(t_i)
  bool capped = false;               ///< the cap was reached: there are faster curves
  std::vector<Rational> parameters;  ///< the x that attains it
  /// Its proof: weights w_i ≥ 0, Σ w_i = 1 (less where capped), Σ w_i σ_k(t_i) = 0 for every
  /// direction k of the space, so that Σ w_i σ(t_i) is the same for all curves.
  std::vector<Rational> weights;
};
/// Exact, re-checked in rationals whatever Clp found. A least speed above `cap` is not asked for,
/// since it may be unbounded. Domain: solvable, a node at least (contract).
NodeOptimum fastest_at_nodes(const HermiteCurves& curves, std::span<const Rational> nodes,
                             const Rational& cap);

struct CuspFreeAnswer {
  enum class Outcome {
    found,      ///< `curve`, certified
    none,       ///< proved, see `reason`
    undecided,  ///< after the rounds allowed
  };
  /// Why there is none.
  enum class Reason {
    not_applicable,
    contradiction,  ///< the conditions have no common solution: HermiteCurves::contradiction
    cone,           ///< the chord is outside the cone of tangents: `cone`
    single_curve,   ///< the only curve has a cusp: `cusp`
    weights,        ///< `nodes` and `weights`: the mean speed of every curve is at most 0
  };
  Outcome outcome = Outcome::undecided;
  Reason reason = Reason::not_applicable;
  std::string sentence;  ///< one that a person can read

  std::optional<RationalPhCurve> curve;
  std::vector<Rational> parameters;      ///< its x
  std::optional<RealRoot> cusp;          ///< of the only curve
  std::optional<ConeTest> cone;          ///< where the cone decided
  std::vector<Rational> nodes, weights;  ///< those with positive weight
  /// No curve of the space is faster than this everywhere on [begin, end] (or it was not asked
  /// for); ≤ 0 where weights prove that there is none. Of the last linear program.
  std::optional<Rational> speed_bound;
  std::size_t rounds = 0;
};

struct CuspFreeLimits {
  std::size_t most_rounds = default_rounds;
  /// Equidistant nodes of the first round; at least as many as decide a polynomial are taken.
  std::size_t nodes = 0;
};

/// The largest freedom() for which the linear programs are offered.
inline constexpr std::size_t largest_freedom = 48;

/// A curve with λ > 0 on [begin, end], certified, or a proof that the space holds none, or
/// `undecided`, with what is known. Everything stated is exact. Faults: unsupported
/// (freedom() above largest_freedom).
Result<CuspFreeAnswer> cusp_free_curve(const HermiteCurves& curves,
                                       const CuspFreeLimits& limits = {});

/// True when the certificate or proof that the answer carries holds: recomputed without linear
/// programming; false for `undecided`.
bool holds(const CuspFreeAnswer& answer, const HermiteCurves& curves);

/// Which spaces a search looks through: α = base^k, least_power ≤ k ≤ most_power, deg B up to
/// largest_degree.
struct SpaceSearch {
  RationalPolynomial base;
  std::size_t least_power = 0, most_power = 0;
  std::size_t largest_degree = 0;
  CuspFreeLimits limits;
};

/// What a search found in one space. Larger spaces contain smaller ones, so that a proof for one
/// is a proof for all below it.
struct SearchedSpace {
  std::size_t power = 0, degree = 0;
  CuspFreeAnswer answer;
};
struct DegreeSearch {
  /// The space of least curve degree max(deg B, deg α) that holds a certified curve; then of least
  /// power; then of least deg B.
  std::optional<SearchedSpace> found;
  /// The spaces before it that could hold one by their dimension, in the order of the search.
  std::vector<SearchedSpace> before;
  /// True when every one of those before was proved to hold none: `found` is then the smallest.
  bool proved_smallest = true;
  std::optional<ConeTest> cone;  ///< where no space at all holds one
  std::string sentence;
};

/// The smallest space with a certified cusp-free curve. Faults: those of solve, of
/// HermiteCurves::create and of cusp_free_curve; outside_domain (least_power > most_power).
Result<DegreeSearch> smallest_cusp_free(const QuaternionPolynomial& a,
                                        const RationalHermiteData& data, const SpaceSearch& search);

}  // namespace hodograph
