// SPDX-License-Identifier: MIT
// A small check of XML and of our HTML: tags nest, attributes are quoted, nothing is left
// unescaped.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>
#include <vector>

namespace hodograph {

/// Empty where the text is well-formed, else the first problem with what follows it.
inline std::string markup_problem(std::string_view text) {
  std::vector<std::string> open;
  const auto problem = [&](const char* what, std::size_t at) {
    return std::string(what) + ": " + std::string(text.substr(at, 60));
  };
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] != '<') {
      const std::size_t next = std::min(text.find('<', at), text.size());
      const std::string_view content = text.substr(at, next - at);
      const bool style = !open.empty() && open.back() == "style";
      if (!style && content.find('>') != std::string_view::npos) return problem("bare >", at);
      for (std::size_t i = content.find('&'); i != std::string_view::npos;
           i = content.find('&', i + 1)) {
        if (content.find(';', i) > i + 6) return problem("bare &", at + i);
      }
      at = next;
      continue;
    }
    std::size_t end = at + 1;
    bool quoted = false;
    while (end < text.size() && (quoted || text[end] != '>')) {
      if (text[end] == '"') quoted = !quoted;
      if (text[end] == '<') return problem("< inside a tag", at);
      ++end;
    }
    if (end >= text.size()) return problem("a tag without an end", at);
    const std::string_view tag = text.substr(at + 1, end - at - 1);
    const std::string name(tag.substr(0, tag.find_first_of(" \n/", tag.starts_with('/') ? 1 : 0)));
    if (tag.starts_with('/')) {
      if (open.empty() || "/" + open.back() != name) return problem("a tag closes another", at);
      open.pop_back();
    } else if (!tag.starts_with('!') && !tag.starts_with('?') && !tag.ends_with('/') &&
               name != "meta") {
      open.push_back(name);
    }
    at = end + 1;
  }
  return open.empty() ? "" : "not closed: " + open.back();
}

}  // namespace hodograph
