// SPDX-License-Identifier: MIT
// Where a function dips, on a grid that is refined; and simple rationals.
#pragma once

#include <functional>
#include <vector>

#include "hodograph/rational/rational.hpp"

namespace hodograph::rational_detail {

/// The places of local minima of f on [begin, end] with f < bound, found on a grid of `cells`
/// cells and narrowed by halving to (end - begin) / (cells 2^bits'), bits' such that the places are
/// multiples of (end - begin) / cells / 2^bits. Ends of the interval count. What the grid does not
/// show is not found.
std::vector<Rational> dips(const std::function<Rational(const Rational&)>& f, const Rational& begin,
                           const Rational& end, std::size_t cells, long bits,
                           const Rational& bound);

/// The rational of least denominator within 2^-bits |x| of x; 0 for 0.
Rational simplest(const Rational& x, long bits);
/// The rational of least denominator within 2^-bits of x.
Rational simplest_within(const Rational& x, long bits);

}  // namespace hodograph::rational_detail
