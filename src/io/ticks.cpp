// SPDX-License-Identifier: MIT
// Round numbers on an axis.
#include "ticks.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>

namespace hodograph::io_detail {
namespace {

constexpr std::string_view minus_sign = "\xe2\x88\x92";

std::string fixed_text(double value, int decimals) {
  std::array<char, 64> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                          std::chars_format::fixed, decimals);
  std::string text(buffer.data(), error == std::errc{} ? end : buffer.data());
  if (text.find_first_not_of("-0.") == std::string::npos && !text.empty() && text[0] == '-') {
    text.erase(0, 1);
  }
  if (!text.empty() && text[0] == '-') text.replace(0, 1, minus_sign);
  return text;
}

/// 10 to a whole power, as exact as a double is.
double ten_to(int exponent) {
  std::array<char, 16> text{'1', 'e'};
  const auto [end, error] = std::to_chars(text.data() + 2, text.data() + text.size(), exponent);
  double value = 0.0;
  std::from_chars(text.data(), error == std::errc{} ? end : text.data() + 3, value);
  return value;
}

int decimal_exponent(double size) { return static_cast<int>(std::floor(std::log10(size))); }

}  // namespace

std::string power_of_ten(int exponent) {
  constexpr std::array<std::string_view, 10> digits = {
      "\xe2\x81\xb0", "\xc2\xb9",     "\xc2\xb2",     "\xc2\xb3",     "\xe2\x81\xb4",
      "\xe2\x81\xb5", "\xe2\x81\xb6", "\xe2\x81\xb7", "\xe2\x81\xb8", "\xe2\x81\xb9"};
  std::string out = exponent < 0 ? "10\xe2\x81\xbb" : "10";
  for (const char c : std::to_string(std::abs(exponent))) {
    out += digits[static_cast<std::size_t>(c - '0')];
  }
  return out;
}

TickedRange linear_ticks(double lower, double upper, int count) {
  assert(lower < upper && upper - lower < std::numeric_limits<double>::infinity());
  TickedRange range{lower, upper};
  const double rough = (upper - lower) / std::max(count, 1);
  int exponent = decimal_exponent(rough);
  constexpr int smallest_exponent = -300;
  exponent = std::max(exponent, smallest_exponent);
  double multiple = rough / ten_to(exponent);
  multiple = multiple <= 1.0 ? 1.0 : multiple <= 2.0 ? 2.0 : multiple <= 5.0 ? 5.0 : 10.0;
  if (multiple == 10.0) {
    multiple = 1.0;
    ++exponent;
  }
  const double size = std::max(std::abs(lower), std::abs(upper));
  const int largest = decimal_exponent(size);
  // Labels without a factor where they stay short: up to 99999 and down to 0.001.
  const bool plain = largest < 5 && largest >= -3 && exponent >= -6;
  const int factor = plain ? 0 : largest;
  if (!plain) range.factor = "\xc3\x97" + power_of_ten(factor);
  const int decimals = std::clamp(factor - exponent, 0, 15);
  // Ticks are counted in steps, so that each is rounded once.
  const double first = std::ceil(lower / ten_to(exponent) / multiple);
  const int most = 2 * count + 2;  // rounding a step to 1, 2 or 5 never doubles their number
  for (int i = 0; i < most; ++i) {
    const double k = first + i;
    const double value = k * multiple * ten_to(exponent);
    if (!(value <= upper)) break;
    // k times the multiple, shifted by exponent - factor, avoids dividing two rounded powers.
    range.ticks.push_back({value, fixed_text(k * multiple / ten_to(factor - exponent), decimals)});
  }
  return range;
}

TickedRange decade_ticks(double log_lower, double log_upper, int count) {
  assert(log_lower <= log_upper && std::abs(log_lower) < 400.0 && std::abs(log_upper) < 400.0);
  TickedRange range{std::floor(log_lower), std::ceil(log_upper)};
  if (range.lower == range.upper) {
    range.lower -= 1.0;
    range.upper += 1.0;
  }
  const int first = static_cast<int>(range.lower), last = static_cast<int>(range.upper);
  const int step = (last - first) / std::max(count, 1) + 1;
  for (int exponent = last; exponent >= first; exponent -= step) {
    range.ticks.push_back({static_cast<double>(exponent), power_of_ten(exponent)});
  }
  return range;
}

}  // namespace hodograph::io_detail
