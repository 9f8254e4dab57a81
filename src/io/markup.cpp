// SPDX-License-Identifier: MIT
// Numbers and text inside markup.
#include "markup.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstddef>

#include "foreign_text.hpp"

namespace hodograph {

void io_detail::append_pixels(std::string& out, double pixels) {
  std::array<char, 64> buffer{};
  constexpr int decimals = 2;
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), pixels,
                                          std::chars_format::fixed, decimals);
  std::string_view text(
      buffer.data(),
      static_cast<std::size_t>((error == std::errc{} ? end : buffer.data()) - buffer.data()));
  while (text.ends_with('0')) text.remove_suffix(1);
  if (text.ends_with('.')) text.remove_suffix(1);
  out += text == "-0" || text.empty() ? "0" : text;
}

std::string escaped_markup(std::string_view text) {
  constexpr unsigned char first_printable = 0x20;
  std::string out;
  while (!text.empty()) {
    const std::size_t length = io_detail::utf8_length(text);
    const char c = text[0];
    if (length == 0 ||
        (static_cast<unsigned char>(c) < first_printable && c != '\n' && c != '\t')) {
      out += "\xef\xbf\xbd";
    } else if (c == '&') {
      out += "&amp;";
    } else if (c == '<') {
      out += "&lt;";
    } else if (c == '>') {
      out += "&gt;";
    } else if (c == '"') {
      out += "&quot;";
    } else {
      out += text.substr(0, length);
    }
    text.remove_prefix(std::max<std::size_t>(length, 1));
  }
  return out;
}

}  // namespace hodograph
