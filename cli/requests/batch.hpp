// SPDX-License-Identifier: MIT
// Requests: how other languages reach the library. One JSON object a line asks for one construction
// or analysis by name; one line answers it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "cli/json.hpp"
#include "cli/requests/members.hpp"

namespace hodograph::cli {

/// What a request is answered with: members, and a path document where one was made.
struct Answer {
  Json result = Json::object();
  std::string document;  ///< JSON text; empty: none
};

/// One kind of request. A new construction adds one entry to the table in registry.cpp.
struct RequestKind {
  std::string_view name;
  std::string_view summary;            ///< one line for --help
  Answer (*answer)(Members& request);  ///< throws Error
};
std::span<const RequestKind> request_kinds();

/// The longest line that is read: a document of some 60000 segments of degree 17. Larger paths are
/// given by file.
inline constexpr std::size_t longest_request = std::size_t{1} << 26U;
/// The deepest nesting of brackets in a request; a document needs 6.
inline constexpr std::size_t deepest_request = 32;

/// The value of a JSON text of limited depth without repeated members. Throws Error
/// (malformed_document); `what` is how its sentence calls the text.
Json parsed_json(std::string_view text, const std::string& what);

/// The answer to one line, without a line feed at its end. Nothing is thrown but std::bad_alloc.
std::string answer_line(std::string_view line);

/// Answers every line of a file ("-": standard input) in order. Empty lines are skipped. Memory:
/// one request and its answer. Standard output is flushed after every line; a file appears when all
/// is done. Throws Error: malformed_document (the input cannot be read), not_written.
void run_batch(const std::string& input, const std::string& output);

}  // namespace hodograph::cli
