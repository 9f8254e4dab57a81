// SPDX-License-Identifier: MIT
// Requests: how other languages reach the library. One JSON object a line asks for one construction
// or analysis by name; one line answers it.
#pragma once

#include <cstddef>
#include <optional>
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

/// Whether requests of a kind may be answered by several threads at once. Ipopt with MUMPS and Clp
/// have state that threads share: one thread at a time is inside them.
enum class RequestRuns : unsigned char { side_by_side, one_at_a_time };

/// One kind of request. A new construction adds one entry to the table in registry.cpp.
struct RequestKind {
  std::string_view name;
  std::string_view summary;            ///< one line for --help
  Answer (*answer)(Members& request);  ///< throws Error
  RequestRuns runs = RequestRuns::side_by_side;
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

/// One line of results, without a line feed at its end.
struct AnsweredLine {
  std::string text;
  std::optional<Fault> fault;  ///< what `text` says, where the request was refused
};

/// The answer to one line; `too_long`: it was passed over. Several threads may ask at once. Nothing
/// is thrown but std::bad_alloc.
AnsweredLine answered_line(std::string_view line, bool too_long = false);

}  // namespace hodograph::cli
