// SPDX-License-Identifier: MIT
// A path that a construction has made: its document with the promises, and how it is written. What
// the constructing subcommands and requests have in common.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "cli/options.hpp"
#include "cli/path_facts.hpp"
#include "hodograph/io/document.hpp"

namespace hodograph::cli {

struct MadePath {
  PathDocument document;
  PathFacts facts;
};

/// The document of a path with its provenance and every promise that its numbers allow.
MadePath made_path(AnyPath path, const std::string& source, const std::string& method,
                   const std::string& choice = "");

/// Writes the document and the report that the flags name, and ends with the short table, `more`
/// rows (name, text) in it, and the names of the files; on standard error where a file itself goes
/// to standard output. Throws Error.
void write_made_path(const MadePath& made, const OutputFlags& output,
                     const std::vector<std::pair<std::string, std::string>>& more);

/// A number to six digits, for people.
std::string to_six_digits(double value);

}  // namespace hodograph::cli
