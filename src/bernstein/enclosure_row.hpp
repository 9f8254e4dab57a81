// SPDX-License-Identifier: MIT
// A Bernstein polynomial of run-time degree with enclosures as coefficients, ends in separate rows
// so that subdivision runs over plain arrays. The workhorse of root isolation and of bounds.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "hodograph/foundation/enclosure.hpp"

namespace hodograph {

/// Coefficients c_0, ..., c_n. Invariant: every end is finite and at most 2^1000 in size.
class EnclosureRow {
 public:
  EnclosureRow() = default;
  explicit EnclosureRow(std::size_t size) : lower_(size), upper_(size) {}
  explicit EnclosureRow(std::span<const Enclosure> coefficients);

  std::size_t size() const { return lower_.size(); }
  std::size_t degree() const { return size() - 1; }
  Enclosure operator[](std::size_t i) const { return {lower_[i], upper_[i]}; }
  double lower(std::size_t i) const { return lower_[i]; }
  double upper(std::size_t i) const { return upper_[i]; }
  void set(std::size_t i, const Enclosure& c) {
    lower_[i] = c.lower();
    upper_[i] = c.upper();
  }

  /// The smallest enclosure of all coefficients: it contains the polynomial's values on [0, 1].
  Enclosure hull() const;
  /// The largest width of a coefficient.
  double noise() const;
  /// n (c_{i+1} - c_i): the derivative.
  EnclosureRow derivative() const;
  /// The values at every number of the enclosure u, which lies in [0, 1].
  Enclosure value(const Enclosure& u) const;
  /// The value of the polynomial with the middle coefficients, up to rounding.
  double approximate_value(double u) const;
  /// The polynomial on [a, b], where 0 ≤ a ≤ b ≤ 1, again on [0, 1].
  EnclosureRow restricted(const Enclosure& a, const Enclosure& b) const;
  /// Becomes the part on [1/2, 1] and returns the part on [0, 1/2]. End coefficients that stay are
  /// kept exactly.
  EnclosureRow split_off_left_half();

 private:
  std::vector<double> lower_, upper_;
};

/// Enclosures times 2^exponent, rounded outwards where that is not exact.
Enclosure scaled(const Enclosure& x, int exponent);

/// The exponent e with 2^(e-1) ≤ magnitude < 2^e of the largest magnitude; 0 where all are 0.
int largest_exponent(std::span<const Enclosure> numbers);

}  // namespace hodograph
