// SPDX-License-Identifier: MIT
// Round numbers on an axis.
#pragma once

#include <string>
#include <vector>

namespace hodograph::io_detail {

struct Tick {
  double value;
  std::string label;
};

/// A range of an axis and its ticks. On a logarithmic axis `lower`, `upper` and the values of the
/// ticks are decimal logarithms.
struct TickedRange {
  double lower = 0.0, upper = 1.0;
  std::vector<Tick> ticks{};
  std::string factor{};  // "×10⁻³" where the labels are to be multiplied by it; else empty
};

/// Ticks at multiples of 1, 2 or 5 times a power of ten, at most about `count` of them.
/// Domain: finite lower < upper, upper - lower finite.
TickedRange linear_ticks(double lower, double upper, int count);

/// Ticks at powers of ten; the range is widened to whole decades. Domain: lower ≤ upper,
/// the logarithms of doubles.
TickedRange decade_ticks(double log_lower, double log_upper, int count);

/// 10 to the power as text: "10⁻³".
std::string power_of_ten(int exponent);

}  // namespace hodograph::io_detail
