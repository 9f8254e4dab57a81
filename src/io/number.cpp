// SPDX-License-Identifier: MIT
// Decimal numbers to doubles and back.
#include "number.hpp"

#include <array>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>
#include <system_error>

namespace hodograph::io_detail {
namespace {

// from_chars says "out of range" for both ends of the range without saying which; a stream rounds
// tiny numbers and fails on large ones.
ParsedNumber at_the_end_of_the_range(std::string_view text) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  double value = 0.0;
  stream >> value;
  if (std::abs(value) < 1.0) return {NumberKind::finite, value};
  return {NumberKind::too_large, value};
}

}  // namespace

ParsedNumber parse_number(std::string_view text) {
  std::string_view digits = text;
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  if (digits.empty()) return {};
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::invalid_argument || end != digits.data() + digits.size()) return {};
  if (error == std::errc::result_out_of_range) return at_the_end_of_the_range(digits);
  return {std::isfinite(value) ? NumberKind::finite : NumberKind::not_finite, value};
}

void append_number(std::string& out, double value) {
  if (value == 0.0) {
    out += std::signbit(value) ? "-0.0" : "0";
    return;
  }
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), error == std::errc{} ? end : buffer.data());
}

}  // namespace hodograph::io_detail
