// SPDX-License-Identifier: MIT
// The published schema and the reader agree: member by member, and by an independent validator.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "document_samples.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/file.hpp"
#include "support/schema_validator.hpp"
#include "temporary_directory.hpp"

namespace hodograph {
namespace {

using Json = nlohmann::json;
using Pointer = Json::json_pointer;

const std::string schema_file =
    std::string(HODOGRAPH_SOURCE_DIRECTORY) + "/docs/schema/path-document-1.schema.json";

Json schema() { return Json::parse(read_file(schema_file).value()); }

/// Calls visit(pointer, required) for every member that the schema knows, parents first.
template <class Visit>
void for_each_member(const Json& root, const Json& object, const Pointer& at, const Visit& visit) {
  if (object.contains("$ref")) {
    const std::string reference = object["$ref"];
    for_each_member(root, root.at(Pointer(reference.substr(1))), at, visit);
    return;
  }
  if (!object.contains("properties")) return;
  const Json required = object.value("required", Json::array());
  EXPECT_EQ(object.value("additionalProperties", true), false) << at;
  for (const auto& [name, member] : object["properties"].items()) {
    visit(at / name, std::find(required.begin(), required.end(), name) != required.end());
    for_each_member(root, member, at / name, visit);
    if (member.contains("items")) for_each_member(root, member["items"], at / name / 0, visit);
  }
}

/// Documents with one thing wrong, and one with nothing wrong, by name.
std::map<std::string, Json> documents(const Json& good) {
  std::map<std::string, Json> all;
  all["good"] = good;
  for_each_member(schema(), schema(), Pointer(), [&](const Pointer& at, bool required) {
    if (!good.contains(at)) return;  // of a path of the other dimension
    Json changed = good;
    changed.at(at.parent_pointer()).erase(at.back());
    all[(required ? "bad, without " : "good, without ") + at.to_string()] = changed;
    const Json value = good.at(at);
    for (const Json& other :
         {Json("text"), Json(true), Json(0.5), Json::object(), Json::array(), Json()}) {
      if (other.type() == value.type() || (other.is_number() && value.is_number())) continue;
      changed = good;
      changed.at(at) = other;
      all["bad, " + at.to_string() + " is " + other.type_name()] = changed;
    }
    if (value.is_object()) {
      changed = good;
      changed.at(at)["another"] = 0;
      all["bad, more in " + at.to_string()] = changed;
    }
    const std::string place = at.to_string();
    if (place == "/version" || place == "/preimage_degree" ||
        place.find("continuity/") != std::string::npos) {
      changed = good;
      changed.at(at) = 0.5;
      all["bad, half in " + place] = changed;
    }
  });
  const auto with = [&](const std::string& name, const char* at, const Json& value) {
    if (!good.contains(Pointer(at))) return;
    all[name] = good;
    all[name].at(Pointer(at)) = value;
  };
  with("bad, negative tolerance", "/provenance/tolerance", -1);
  with("bad, negative length", "/promises/arc_length/lower", -1);
  with("bad, order too low", "/promises/continuity/frame", -2);
  with("bad, format", "/format", "hodograph");
  with("bad, version", "/version", 2);
  with("bad, degree", "/preimage_degree", 13);
  with("bad, algebra", "/algebra", good["algebra"] == "complex" ? "quaternion" : "complex");
  with("bad, kind", "/frame/roll/kind", "cubic");
  with("bad, start", "/segments/0/start", {0, 0, 0, 0});
  with("bad, coefficient", "/segments/1/preimage/1", {0, 0, 0});
  with("bad, number", "/knots/1", "1");
  with("bad, row", "/promises/clearance/obstacles/0", {1, 2});
  with("bad, helix row", "/promises/helix/sines/0", {1, 2});
  with("bad, reach", "/promises/clearance/reach", -1);
  with("bad, end", "/promises/end", {1, 2, 3, 4});
  return all;
}

class Schema : public ::testing::Test {
 protected:
  test::Random random_{"Schema"};
  const std::vector<Json> good_ = {Json::parse(to_json(test::full_document(random_))),
                                   Json::parse(to_json(test::planar_document(random_)))};
};

TEST_F(Schema, EveryMemberStandsInOneOfTheDocuments) {
  for_each_member(schema(), schema(), Pointer(), [&](const Pointer& at, bool) {
    EXPECT_TRUE(good_[0].contains(at) || good_[1].contains(at)) << at;
  });
}

TEST_F(Schema, TheReaderKnowsTheSameMembers) {
  std::size_t count = 0;
  for (const Json& good : good_) {
    for (const auto& [name, document] : documents(good)) {
      const auto read = parse_document(document.dump());
      EXPECT_EQ(read.has_value(), name.starts_with("good"))
          << name << ": " << (read ? "accepted" : read.fault().sentence);
      ++count;
    }
  }
  EXPECT_GT(count, 200U);
}

TEST_F(Schema, AnIndependentValidatorAgrees) {
  const std::string python = test::python_with_jsonschema();
  ASSERT_NE(python, "") << "needs Debian's python3-jsonschema";
  const TemporaryDirectory directory;
  Json all = Json::object();
  for (const Json& good : good_) {
    for (const auto& [name, document] : documents(good)) {
      all[name + " (" + good["algebra"].get<std::string>() + ")"] = document;
    }
  }
  all["good, a plane path"] = Json::parse(
      R"({"format": "hodograph-path", "version": 1, "algebra": "complex", "preimage_degree": 1,
          "closed": false, "knots": [0, 1],
          "segments": [{"start": [0, 0], "preimage": [[1, 0], [1, 1]]}]})");
  ASSERT_FALSE(write_file(directory.path("documents.json"), all.dump()));
  ASSERT_FALSE(write_file(directory.path("validate.py"), R"(
import json, sys
from jsonschema.validators import Draft202012Validator
schema = json.load(open(sys.argv[1], encoding="utf-8"))
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
wrong = [name for name, document in json.load(open(sys.argv[2], encoding="utf-8")).items()
         if validator.is_valid(document) != name.startswith("good")]
print("\n".join(wrong))
sys.exit(1 if wrong else 0)
)"));
  const std::string command = python + " '" + directory.path("validate.py") + "' '" + schema_file +
                              "' '" + directory.path("documents.json") + "' > '" +
                              directory.path("wrong") + "' 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << read_file(directory.path("wrong")).value();
}

}  // namespace
}  // namespace hodograph
