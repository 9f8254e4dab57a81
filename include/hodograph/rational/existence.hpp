// SPDX-License-Identifier: MIT
// Does a truly rational PH curve exist for A and α, and why; how large every space of solutions is.
// Decided exactly, without finding a root: by square-free factors and greatest common divisors.
//
// Write f_0, f_1, ... for the Taylor coefficients of F = A i A* at a root z of α of multiplicity n.
// λ F has a rational antiderivative with a pole of order at most n at z exactly when the principal
// part Σ_{k=1}^{n+1} c_k (t - z)^-k of λ satisfies Σ c_k f_{k-1} = 0: of n + 1 numbers c_k,
// n + 1 - rank(f_0 ... f_n) are free, and what happens at one root does not touch another.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "hodograph/rational/polynomial.hpp"
#include "hodograph/rational/reduction.hpp"

namespace hodograph {

/// The poles of one order.
struct PoleStratum {
  std::size_t order = 1;        ///< n
  RationalPolynomial poles;     ///< s_n: its roots are the roots of α of multiplicity n
  RationalPolynomial rank_two;  ///< divides s_n: rank(f_0 ... f_n) ≤ 2 at its roots
  RationalPolynomial rank_one;  ///< divides that: rank 1 at its roots
  /// Σ n + 1 - rank over the roots of s_n: deg s_n (n - 2) + deg rank_two + deg rank_one.
  std::size_t freedom() const;
};

/// The answer of Theorem 4.6 of "Rational Framing Motions and Spatial Rational Pythagorean
/// Hodograph Curves", and what predicts every dimension.
struct Existence {
  bool exists = false;                ///< N > 0
  std::size_t freedom = 0;            ///< N = Σ over the roots of n + 1 - rank(f_0 ... f_n)
  std::vector<PoleStratum> strata;    ///< by increasing order
  std::string reason;                 ///< one sentence a person can read
  std::size_t alpha_degree = 0;       ///< m
  std::size_t indicatrix_degree = 0;  ///< e
  /// rank(F_k ... F_e) for k = 0 ... e, F_k the coefficient of t^k in F.
  std::vector<std::size_t> tail_ranks;

  /// dim V_d: `exact` for d ≥ m + e, where it is 3 + (d - m - e) + N; below, a lower bound
  /// 3 [d ≥ m] + max(0, N - κ), κ = k - rank(F_0 ... F_e) + rank(F_k ... F_e), k = m + e - d.
  struct Dimension {
    std::size_t value = 0;
    bool exact = true;
  };
  Dimension dimension(std::size_t d) const;
};

/// Whether α admits truly rational PH curves with the indicatrix of A, which is reduced first.
/// Exact. Faults: those of solve for A and α.
Result<Existence> existence(const QuaternionPolynomial& a, const RationalPolynomial& alpha);

}  // namespace hodograph
