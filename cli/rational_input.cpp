// SPDX-License-Identifier: MIT
#include "cli/rational_input.hpp"

#include "cli/options.hpp"
#include "cli/requests/batch.hpp"
#include "cli/terminal.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/rational/text.hpp"

namespace hodograph::cli {
namespace {

void read_text(const RationalReaders& readers, const std::string& text, const std::string& name) {
  try {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin != std::string::npos && text[begin] == '{') {
      const Json json = parsed_json(text, name.empty() ? "the input" : name);
      Members members(json, "", name.empty() ? "the input" : name);
      readers.members(members);
      members.require_all_known();
    } else {
      readers.text(text);
    }
  } catch (const Error& error) {
    Fault fault = error.fault();
    if (fault.quantity == "text" && fault.index) {
      const TextPlace place = place_in(text, *fault.index);
      remember_place(pointed_out(place));
      if (!name.empty()) fault.sentence = name + ", " + fault.sentence;
    }
    throw Error(fault);
  }
}

}  // namespace

Fault placed(Fault fault, std::string_view text, std::size_t index) {
  const TextPlace place = place_in(text, index);
  fault.sentence = "line " + std::to_string(place.line) + ", column " +
                   std::to_string(place.column) + ": " + fault.sentence;
  fault.index = index;
  fault.quantity = "text";
  return fault;
}

void read_rational_input(const std::vector<std::string>& words, const RationalReaders& readers) {
  std::string definitions;  // of the words so far, one a line: names go from one word to the next
  const auto read_definitions = [&] {
    if (!definitions.empty()) read_text(readers, definitions, "");
    definitions.clear();
  };
  for (const std::string& word : words) {
    const std::size_t begin = word.find_first_not_of(" \t\r\n");
    const bool is_json = begin != std::string::npos && word[begin] == '{';
    if (word != "-" && !is_json && word.find_first_of("=\n") != std::string::npos) {
      definitions += (definitions.empty() ? "" : "\n") + word;
      continue;
    }
    read_definitions();
    if (is_json) {
      read_text(readers, word, "");
    } else {
      std::string text = read_file(word, longest_rational_text).value();
      constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
      if (text.starts_with(byte_order_mark)) text.erase(0, byte_order_mark.size());
      read_text(readers, text, input_name(word));
    }
  }
  read_definitions();
}

}  // namespace hodograph::cli
