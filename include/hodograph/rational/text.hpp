// SPDX-License-Identifier: MIT
// Quaternion polynomials, rational functions and curves as a mathematician types them, exactly:
// "A = t^2 - (i + j)*t + k", "alpha = 3t(t - 1)", "r = (t, 3t^2, 1)/t^3"; read and printed.
//
// Grammar. A text holds definitions `name = expression`, ended by line breaks or semicolons; a line
// break inside brackets or after an operator ends nothing. # and // begin comments. Expressions
// have + - * / ^ (also ** and superscripts), brackets ( ) [ ] { }, whole numbers and decimals
// (exact), the variable t, the units i, j, k (whose products keep their order), names that were
// defined before, and lists (x, y, z) = x i + y j + z k and (w, x, y, z). A product needs no sign:
// 2t(t - 1), it^2. Signs bind weaker than powers, and powers group to the right: -t^2 = -(t^2).
// After a division a product needs its sign or brackets, but for fractions of numbers: 3/2 t is
// (3/2)*t, and 1/t (t + 1) is refused. Divisors are real. The minus of typesetters, · and × are
// understood.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/foundation/result.hpp"
#include "hodograph/rational/rational_function.hpp"

namespace hodograph {

/// What a text may hold, so that no text takes longer than some seconds: its bytes, the digits of
/// one number, every exponent, the degree and the bits of everything that is computed on the way,
/// brackets (also signs and powers) inside each other.
inline constexpr std::size_t longest_rational_text = std::size_t{1} << 22U;
inline constexpr std::size_t most_text_digits = 20'000;
inline constexpr std::size_t largest_text_exponent = 1024;
inline constexpr std::size_t largest_text_degree = 1024;
inline constexpr std::size_t largest_text_bits = std::size_t{1} << 16U;
inline constexpr std::size_t deepest_text_nesting = 200;

/// numerator / denominator in lowest terms, the denominator real and monic.
struct QuaternionFunction {
  QuaternionPolynomial numerator{};
  RationalPolynomial denominator{1};
  friend bool operator==(const QuaternionFunction&, const QuaternionFunction&) = default;
};

/// One line `name = expression` of a text. "deg B" is the name "degree", the Greek letter "alpha".
struct TextDefinition {
  std::string name;
  std::size_t index = 0;  ///< of the byte where its expression begins
  QuaternionFunction value{};
};

/// All definitions of a text, in order. Exact.
/// Faults: malformed_document, with the index of the byte where the text cannot be read, its line
/// and column in the sentence; unsupported where one of the limits above is reached, in the same
/// manner.
Result<std::vector<TextDefinition>> parse_definitions(std::string_view text);
/// A single expression. Exact. Faults: those of parse_definitions.
Result<QuaternionFunction> parse_expression(std::string_view text);

/// The value as what is wanted. Exact. Faults: malformed_document, which say what the value is, and
/// begin with `name`: a quaternion polynomial without a denominator; a real polynomial; a real
/// rational function; a curve, without a real part; a whole number in [0, largest] (above it:
/// unsupported).
Result<QuaternionPolynomial> quaternion_polynomial(const QuaternionFunction& value,
                                                   const std::string& name);
Result<RationalPolynomial> real_polynomial(const QuaternionFunction& value,
                                           const std::string& name);
Result<RationalFunction> real_function(const QuaternionFunction& value, const std::string& name);
Result<VectorFunction> vector_function(const QuaternionFunction& value, const std::string& name);
Result<std::size_t> whole_number(const QuaternionFunction& value, const std::string& name,
                                 std::size_t largest);

/// Where a byte of a text is: its line and column (characters), from 1, and the line itself.
struct TextPlace {
  std::size_t line = 1, column = 1;
  std::string text{};
};
TextPlace place_in(std::string_view text, std::size_t index);
/// The line, and a caret below the character; long lines are cut round it.
std::string pointed_out(const TextPlace& place);

/// As parse_expression reads them back: "t^2 - (i + j)*t + k"; "(x, y, z)"; "(x, y, z)/(q)".
std::string to_text(const QuaternionPolynomial& a);
std::string to_text(const RationalVector& v);
std::string to_text(const VectorPolynomial& v);
std::string to_text(const VectorFunction& r);

}  // namespace hodograph
