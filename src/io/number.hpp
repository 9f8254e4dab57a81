// SPDX-License-Identifier: MIT
// Decimal numbers to doubles and back, correctly rounded, whatever the locale.
#pragma once

#include <string>
#include <string_view>

namespace hodograph::io_detail {

enum class NumberKind { finite, not_finite, too_large, not_a_number };

struct ParsedNumber {
  NumberKind kind = NumberKind::not_a_number;
  double value = 0.0;
};

/// A whole text as a decimal number, an optional sign in front. `not_finite` for nan and inf in any
/// spelling, `too_large` beyond the largest double, `not_a_number` for anything else. What is
/// below the smallest double becomes 0.
ParsedNumber parse_number(std::string_view text);

/// Appends the shortest decimal that reads back to the same double; "-0" keeps its sign as "-0.0".
void append_number(std::string& out, double value);

}  // namespace hodograph::io_detail
