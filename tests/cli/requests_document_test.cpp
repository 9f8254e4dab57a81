// SPDX-License-Identifier: MIT
// docs/requests.md is true: every example is run and its result compared. And the schemas hold for
// all of them, says an independent validator.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "cli/program.hpp"
#include "support/schema_validator.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

struct Example {
  std::string request, result;
};

std::vector<Example> examples() {
  const std::string text =
      text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/docs/requests.md");
  const auto block = [&](const std::string& kind, std::size_t& from) {
    const std::string fence = "```json " + kind + "\n";
    const std::size_t begin = text.find(fence, from);
    if (begin == std::string::npos) return std::string();
    const std::size_t end = text.find("\n```", begin);
    from = end;
    return text.substr(begin + fence.size(), end - begin - fence.size());
  };
  std::vector<Example> found;
  std::size_t at = 0;
  for (;;) {
    Example example;
    example.request = block("request", at);
    if (example.request.empty()) return found;
    example.result = block("result", at);
    found.push_back(example);
  }
}

/// Whether a value is what the document shows: "..." stands for anything; numbers agree to the last
/// few bits, for the sine of another C library may differ in its last one.
bool agrees(const Json& shown, const Json& value) {
  constexpr double last_bits = 0x1p-44;  // 2^8 ulps, some hundred operations of one rounding each
  if (shown == "...") return true;
  if (shown.is_number() && value.is_number()) {
    const auto a = shown.get<double>(), b = value.get<double>();
    return std::abs(a - b) <= last_bits * std::max(1.0, std::abs(a));
  }
  if (shown.type() != value.type() || shown.size() != value.size()) return false;
  if (shown.is_object()) {
    for (const auto& [key, member] : shown.items()) {
      if (!value.contains(key) || !agrees(member, value[key])) return false;
    }
    return true;
  }
  if (shown.is_array()) {
    for (std::size_t i = 0; i < shown.size(); ++i) {
      if (!agrees(shown[i], value[i])) return false;
    }
    return true;
  }
  return shown == value;
}

TEST(RequestsDocument, EveryExampleGivesWhatItShows) {
  const Program program;
  const auto all = examples();
  ASSERT_GE(all.size(), 10u);
  for (const Example& example : all) {
    const Outcome outcome = program.run({"batch"}, example.request + "\n");
    ASSERT_EQ(outcome.code, 0);
    EXPECT_TRUE(agrees(Json::parse(example.result), Json::parse(outcome.out)))
        << example.request << "\n"
        << outcome.out;
  }
}

TEST(RequestsDocument, EveryRequestHasASectionAndASchema) {
  const std::string text =
      text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/docs/requests.md");
  const Json schema = Json::parse(
      text_of_file(std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/docs/schema/request-1.schema.json"));
  const Program program;
  const std::string help = program.run({"batch", "--help"}).out;
  std::size_t count = 0;
  for (const auto& kind : schema["oneOf"]) {
    const auto reference = kind["$ref"].get<std::string>();
    const std::string name = reference.substr(reference.rfind('/') + 1);
    EXPECT_NE(text.find("\n## " + name + "\n"), std::string::npos) << name;
    EXPECT_NE(help.find("\n  " + name + " "), std::string::npos) << name;
    ++count;
  }
  // As many as the help lists: lines of a name and a sentence, up to an empty one.
  const std::size_t begin = help.find("\nRequests (");
  ASSERT_NE(begin, std::string::npos);
  const std::string list = help.substr(begin + 1, help.find("\n\n", begin) - begin);
  EXPECT_EQ(count, line_count(list) - 1);
}

TEST(RequestsDocument, ExamplesAndResultsObeyTheSchemas) {
  const std::string python = python_with_jsonschema();
  ASSERT_NE(python, "") << "needs Debian's python3-jsonschema";
  const Program program;
  std::string requests, results;
  for (const Example& example : examples()) requests += example.request + "\n";
  results = program.run({"batch"}, requests).out;
  write_text(program.path("requests.jsonl"), requests);
  write_text(program.path("results.jsonl"), results);
  write_text(program.path("validate.py"), R"(
import json, pathlib, sys
import jsonschema
folder = pathlib.Path(sys.argv[1])
for kind in ("request", "result"):
    path = folder / f"{kind}-1.schema.json"
    schema = json.loads(path.read_text())
    resolver = jsonschema.RefResolver(path.as_uri(), schema)
    schema.pop("$id")
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema, resolver=resolver)
    for line in open(f"{kind}s.jsonl"):
        value = json.loads(line)
        if value.get("id") == 7 and kind == "request":
            assert not validator.is_valid(value), "the step of the example is negative"
            continue
        for error in validator.iter_errors(value):
            sys.exit(f"{line[:200]}: {error.message[:400]}")
)");
  const Outcome outcome =
      program.shell(python + " validate.py '" HODOGRAPH_SOURCE_DIRECTORY "/docs/schema'");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
}

}  // namespace
}  // namespace hodograph::test
