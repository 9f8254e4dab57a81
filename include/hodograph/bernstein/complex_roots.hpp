// SPDX-License-Identifier: MIT
// All complex roots of a polynomial at once.
#pragma once

#include <complex>
#include <optional>
#include <vector>

namespace hodograph {

/// The roots of Σ a_k z^k, as many as its degree (leading zeros taken away). Each is an exact root
/// of a polynomial whose coefficients differ by a few n ε. Nothing where the iteration does not
/// settle, a coefficient is not finite or the polynomial is 0. Method: Aberth's, from circles of
/// the sizes of the roots.
std::optional<std::vector<std::complex<double>>> complex_roots(std::vector<std::complex<double>> a);

}  // namespace hodograph
