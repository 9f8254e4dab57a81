// SPDX-License-Identifier: MIT
// Curves between end points with given tangents, as they are asked for, found, and told: what
// `hodograph rational-hermite` and the request "rational_hermite" have in common. All exact.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "cli/rationals.hpp"
#include "hodograph/rational/cusp_free.hpp"
#include "hodograph/rational/hermite_preimage.hpp"

namespace hodograph::cli {

inline constexpr std::size_t usual_largest_degree = 16;

/// What is asked for. T: directions (G¹ data), v: derivatives (C¹ data); without A one is chosen.
/// With alpha and a degree: that space; with one of them, or none: the smallest space, of the
/// powers base^least_power ... base^most_power where a base is given.
struct RationalHermiteProblem {
  std::optional<RationalVector> begin_point{}, end_point{};
  std::optional<RationalVector> begin_direction{}, end_direction{};
  std::optional<RationalVector> begin_derivative{}, end_derivative{};
  Rational begin = 0, end = 1;
  std::optional<QuaternionPolynomial> a{};
  std::optional<RationalPolynomial> alpha{}, base{};
  std::optional<std::size_t> degree{};
  std::optional<std::size_t> largest_degree{};  ///< of the search; 16 and the degree of alpha
  std::size_t least_power = 0, most_power = 0;
  long direction_bits = default_direction_bits;
  CuspFreeLimits limits{};
};

/// The definitions P0, P1, T0, T1, v0, v1, begin, end, A, alpha, base, degree of a text, and the
/// members of the same names (also least_power, most_power, largest_degree, direction_bits,
/// rounds) of a JSON object. Throw Error.
void define(RationalHermiteProblem& problem, std::string_view text);
void define(RationalHermiteProblem& problem, Members& members);

struct RationalHermiteAnswer {
  RationalHermiteProblem problem;
  RationalHermiteData data;  ///< with the derivatives that were met
  QuaternionPolynomial a;
  bool a_chosen = false;
  /// Of the directions or derivatives that were given.
  std::optional<RationalDirection> begin_direction{}, end_direction{};
  ConeTest cone{};
  RationalPolynomial alpha{1};
  std::optional<std::size_t> degree{};     ///< of the space that the answer is about
  std::optional<HermiteCurves> curves{};   ///< of that space
  std::optional<CuspFreeAnswer> answer{};  ///< of that space
  std::optional<DegreeSearch> search{};
  std::string sentence{};
  std::optional<DescribedCurve> curve{};
};
/// Throws Error.
RationalHermiteAnswer answer_of(const RationalHermiteProblem& problem);

/// The answer for people, and for programs (docs/requests.md).
std::string text_of(const RationalHermiteAnswer& answer);
Json json_of(const RationalHermiteAnswer& answer);

}  // namespace hodograph::cli
