// SPDX-License-Identifier: MIT
// The words that `hodograph rational` and `hodograph rational-hermite` take: definitions, JSON
// objects, and files of either.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/requests/members.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph::cli {

/// What takes a text of definitions (Error with the index of a byte, quantity "text"), and what
/// takes a JSON object.
struct RationalReaders {
  std::function<void(std::string_view)> text;
  std::function<void(Members&)> members;
};

/// The fault with the place of a byte of the text in its sentence.
Fault placed(Fault fault, std::string_view text, std::size_t index);

/// The value, or Error with its fault and the place in the text.
template <class T>
T taken(Result<T> value, std::string_view text, std::size_t index) {
  if (!value) throw Error(placed(value.fault(), text, index));
  return *std::move(value);
}

/// Hands every word to the reader it is for: a definition, a JSON object, or the name of a file.
/// Definitions that follow each other are one text, one word a line.
/// Where a text cannot be read, its place is remembered for the terminal. Throws Error.
void read_rational_input(const std::vector<std::string>& words, const RationalReaders& readers);

}  // namespace hodograph::cli
