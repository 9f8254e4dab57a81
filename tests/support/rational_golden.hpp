// SPDX-License-Identifier: MIT
// Exact values from tests/golden/rational.json, and small random exact ones.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "hodograph/rational/rational_function.hpp"
#include "support/json.hpp"
#include "support/random.hpp"

namespace hodograph::test {

inline Rational golden_rational(const Json& text) { return Rational::parse(text.string()).value(); }
inline RationalPolynomial golden_polynomial(const Json& list) {
  std::vector<Rational> coefficients;
  for (const Json& c : list.list()) coefficients.push_back(golden_rational(c));
  return RationalPolynomial(coefficients);
}
inline VectorPolynomial golden_vector(const Json& list) {
  return {golden_polynomial(list[0]), golden_polynomial(list[1]), golden_polynomial(list[2])};
}
inline QuaternionPolynomial golden_quaternion(const Json& list) {
  return {golden_polynomial(list[0]), golden_polynomial(list[1]), golden_polynomial(list[2]),
          golden_polynomial(list[3])};
}
inline RationalFunction golden_function(const Json& fraction) {
  return {golden_polynomial(fraction["num"]), golden_polynomial(fraction["den"])};
}
inline std::vector<RationalPolynomial> golden_polynomials(const Json& list) {
  std::vector<RationalPolynomial> result;
  for (const Json& p : list.list()) result.push_back(golden_polynomial(p));
  return result;
}

/// Whole coefficients in [-size, size]; the leading one is not 0.
inline RationalPolynomial random_polynomial(Random& random, std::size_t degree, std::int64_t size) {
  std::vector<Rational> c;
  for (std::size_t k = 0; k <= degree; ++k) c.emplace_back(random.integer(-size, size));
  while (c.back().is_zero()) c.back() = Rational(random.integer(-size, size));
  return RationalPolynomial(c);
}
inline QuaternionPolynomial random_quaternion_polynomial(Random& random, std::size_t degree,
                                                         std::int64_t size) {
  return {random_polynomial(random, degree, size), random_polynomial(random, degree, size),
          random_polynomial(random, degree, size), random_polynomial(random, degree, size)};
}
inline VectorPolynomial random_vector_polynomial(Random& random, std::size_t degree,
                                                 std::int64_t size) {
  return vector_part(random_quaternion_polynomial(random, degree, size));
}

}  // namespace hodograph::test

namespace hodograph {

// What a failed comparison prints.
inline void PrintTo(const Rational& x, std::ostream* out) { *out << to_text(x); }
inline void PrintTo(const RationalPolynomial& p, std::ostream* out) { *out << to_text(p); }
inline void PrintTo(const RationalFunction& f, std::ostream* out) { *out << to_text(f); }
inline void PrintTo(const VectorPolynomial& v, std::ostream* out) {
  *out << "(" << to_text(v.x) << ", " << to_text(v.y) << ", " << to_text(v.z) << ")";
}

}  // namespace hodograph
