// SPDX-License-Identifier: MIT
// The words that `hodograph rational` and `hodograph rational-hermite` take: definitions, JSON
// objects, and files of either.
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/requests/members.hpp"

namespace hodograph::cli {

/// What takes a text of definitions (Error with the index of a byte, quantity "text"), and what
/// takes a JSON object.
struct RationalReaders {
  std::function<void(std::string_view)> text;
  std::function<void(Members&)> members;
};

/// Hands every word to the reader it is for: a definition, a JSON object, or the name of a file.
/// Where a text cannot be read, its place is remembered for the terminal. Throws Error.
void read_rational_input(const std::vector<std::string>& words, const RationalReaders& readers);

}  // namespace hodograph::cli
