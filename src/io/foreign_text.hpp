// SPDX-License-Identifier: MIT
// Foreign text inside our sentences: always one line, never a control character, never too long.
#pragma once

#include <string>
#include <string_view>

namespace hodograph::io_detail {

/// The text in single quotes, cut to a readable length; bytes that are not printable (also those
/// that are no UTF-8) appear as \xNN, so that a hostile name cannot break a line or a terminal.
std::string in_quotes(std::string_view text);

/// True when the text is valid UTF-8 (no surrogates, nothing overlong, nothing above U+10FFFF).
bool is_utf8(std::string_view text);

/// The number of bytes of the UTF-8 character at the front of a non-empty text; 0 where there is
/// none.
std::size_t utf8_length(std::string_view text);

}  // namespace hodograph::io_detail
