// SPDX-License-Identifier: MIT
// `hodograph batch`: order, faults, exact numbers, hostile lines.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <numbers>

#include "cli/program.hpp"
#include "support/random.hpp"

namespace hodograph::test {
namespace {

using Json = nlohmann::json;

std::vector<Json> answers(const Program& program, const std::string& lines) {
  const Outcome outcome = program.run({"batch"}, lines);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  std::vector<Json> result;
  for (const std::string& line : lines_of(outcome.out)) result.push_back(Json::parse(line));
  return result;
}
Json answer(const Program& program, const Json& request) {
  const auto all = answers(program, request.dump() + "\n");
  EXPECT_EQ(all.size(), 1u);
  return all.empty() ? Json() : all.front();
}

Json quarter_circle() {
  const double h = std::numbers::pi / 2;
  return {{"request", "hermite"},
          {"order", 1},
          {"begin", {{1, 0, 0}, {0, h, 0}}},
          {"end", {{0, 1, 0}, {-h, 0, 0}}}};
}

void expect_fault(const Json& answer, const std::string& code, const std::string& part) {
  ASSERT_TRUE(answer.is_object()) << answer;
  EXPECT_FALSE(answer["ok"].get<bool>());
  EXPECT_EQ(answer["fault"]["code"], code) << answer;
  EXPECT_NE(answer["fault"]["sentence"].get<std::string>().find(part), std::string::npos) << answer;
  for (const char* member : {"code", "sentence", "index", "quantity", "value", "bound"}) {
    EXPECT_TRUE(answer["fault"].contains(member)) << member;
  }
}

TEST(Batch, AnswersInOrderAndGoesOnAfterAFault) {
  const Program program;
  std::string lines;
  for (int i = 0; i < 20; ++i) {
    Json request = quarter_circle();
    request["id"] = i;
    if (i % 3 == 1) request["step"] = -1.0;
    lines += request.dump() + "\n";
    if (i % 5 == 0) lines += "not json\n\n";
  }
  const auto all = answers(program, lines);
  ASSERT_EQ(all.size(), 24u);
  int id = 0;
  for (const Json& one : all) {
    if (!one.contains("id")) {
      expect_fault(one, "malformed_document", "no JSON");
      continue;
    }
    EXPECT_EQ(one["id"], id);
    EXPECT_EQ(one["ok"].get<bool>(), id % 3 != 1);
    ++id;
  }
  EXPECT_EQ(id, 20);
}

TEST(Batch, HermiteMeetsItsData) {
  const Program program;
  Json request = quarter_circle();
  request["evaluate"] = {0, 0.5, 1};
  const Json result = answer(program, request)["result"];
  EXPECT_EQ(result["samples"].size(), 3u);
  EXPECT_EQ(result["control_points"].size(), 6u);
  EXPECT_EQ(result["preimage"].size(), 3u);
  EXPECT_EQ(result["document"]["preimage_degree"], 2);
  EXPECT_EQ(result["samples"][0]["position"][0], Json({1.0, 0.0, 0.0}));
}

TEST(Batch, DocumentsGoInAsTheyCameOut) {
  const Program program;
  const Json document = answer(program, quarter_circle())["result"]["document"];
  const Json inspected = answer(program, {{"request", "inspect"}, {"document", document}});
  EXPECT_TRUE(inspected["ok"].get<bool>()) << inspected;
  const Json back = answer(
      program,
      {{"request", "operate"}, {"operation", "close"}, {"closed", false}, {"document", document}});
  EXPECT_EQ(back["result"]["document"]["segments"], document["segments"]);
  EXPECT_EQ(back["result"]["document"]["promises"], document["promises"]);

  write_text(program.path("path.json"), document.dump());
  const Json by_file =
      answer(program, {{"request", "evaluate"}, {"file", "path.json"}, {"arc_length", {0, 1}}});
  EXPECT_EQ(by_file["result"]["points"].size(), 2u) << by_file;
}

TEST(Batch, NumbersRoundTripExactly) {
  const Program program;
  Random rng("Batch.NumbersRoundTripExactly");
  std::string lines;
  std::vector<std::vector<double>> sent;
  for (int i = 0; i < 50; ++i) {
    std::vector<double> start = {rng.uniform(-1, 1), std::ldexp(rng.uniform(-1, 1), -990), -0.0};
    sent.push_back(start);
    lines += Json({{"request", "hermite"},
                   {"order", 1},
                   {"begin", {start, {1, 0.1, 0.2}}},
                   {"end", {{start[0] + 1, 0.3, 0.1}, {1, 0.2, 0.1}}}})
                 .dump() +
             "\n";
  }
  const auto all = answers(program, lines);
  ASSERT_EQ(all.size(), sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    const auto start =
        all[i]["result"]["document"]["segments"][0]["start"].get<std::vector<double>>();
    EXPECT_EQ(std::memcmp(start.data(), sent[i].data(), sizeof(double) * 3), 0) << all[i];
  }
}

TEST(Batch, EveryRequestAnswers) {
  const Program program;
  const Json document = answer(program, quarter_circle())["result"]["document"];
  const double h = std::numbers::pi / 2;
  const std::vector<Json> requests = {
      {{"request", "hermite_path"},
       {"order", 1},
       {"knots", {0, 1, 2}},
       {"points", {{{1, 0, 0}, {0, h, 0}}, {{0, 1, 0}, {-h, 0, 0}}, {{-1, 0, 0}, {0, -h, 0}}}}},
      {{"request", "fit"},
       {"formula", "cos(t), sin(t), t"},
       {"to", 6},
       {"tolerance", 1e-6}},  // not a tolerance: request data
      {{"request", "fit"},
       {"orbit", {{"name", "gateway"}}},
       {"tolerance", 1e-6}},  // not a tolerance: request data
      {{"request", "fit"},
       {"tolerance", 1e-3},  // not a tolerance: request data
       {"samples",
        {{"parameters", {0, 1, 2, 3, 4, 5}},
         {"points", {{0, 0, 0}, {1, 1, 0}, {2, 0, 1}, {3, 1, 1}, {4, 0, 0}, {5, 1, 0}}}}}},
      {{"request", "orbit"}},
      {{"request", "orbit"}, {"initial", {{"x", 1.0273}, {"z", -0.18552}, {"vy", -0.1145}}}},
      {{"request", "evaluate"}, {"document", document}, {"xi", {0, 0.25, 1}}},
      {{"request", "sample"}, {"document", document}, {"count", 5}},
      {{"request", "nearest"}, {"document", document}, {"point", {2, 2, 0}}},
      {{"request", "inspect"}, {"document", document}},
      {{"request", "operate"}, {"operation", "reverse"}, {"document", document}},
      {{"request", "operate"},
       {"operation", "subpath"},
       {"from", 0.25},
       {"to", 0.5},
       {"document", document}},
      {{"request", "operate"},
       {"operation", "move"},
       {"translation", {1, 2, 3}},
       {"document", document}},
      {{"request", "operate"}, {"operation", "scale"}, {"factor", 2}, {"document", document}},
      {{"request", "operate"},
       {"operation", "reflect"},
       {"normal", {1, 0, 0}},
       {"document", document}},
      {{"request", "operate"},
       {"operation", "reparametrise"},
       {"from", 5},
       {"to", 7},
       {"document", document}},
      {{"request", "operate"},
       {"operation", "elevate"},
       {"preimage_degree", 8},
       {"document", document}},
  };
  for (const Json& request : requests) {
    const Json one = answer(program, request);
    EXPECT_TRUE(one["ok"].get<bool>()) << request << "\n" << one;
  }
  const Json moved = answer(program, {{"request", "operate"},
                                      {"operation", "move"},
                                      {"translation", {-1, 1, 0}},
                                      {"rotation", {std::sqrt(0.5), 0, 0, std::sqrt(0.5)}},
                                      {"document", document}})["result"]["document"];
  const Json joined = answer(
      program,
      {{"request", "operate"}, {"operation", "join"}, {"document", document}, {"other", moved}});
  EXPECT_FALSE(joined["ok"].get<bool>());  // it starts elsewhere
}

TEST(Batch, MistakesInRequestsAreNamed) {
  const Program program;
  const auto fault = [&](Json change, const std::string& part) {
    Json request = quarter_circle();
    request.update(change);
    expect_fault(answer(program, request), "malformed_document", part);
  };
  fault({{"request", "teleport"}}, "teleport");
  fault({{"order", 3}}, "1, 2 or 4");
  fault({{"begin", "here"}}, "/begin");
  fault({{"begin", {{1, 0, 0}}}}, "/begin");
  fault({{"begin", {{1, 0}, {0, 1, 0}}}}, "/begin/0");
  fault({{"stepp", 1}}, "stepp");
  fault({{"choice", "order_eleven"}}, "order_eleven");
  fault({{"evaluate", {0, 2}}}, "/evaluate/1");
  fault({{"id", {1, 2}}}, "id");
  expect_fault(answers(program, "[1]\n").front(), "malformed_document", "object");
  expect_fault(answers(program, "{\"request\": \"orbit\", \"request\": \"orbit\"}\n").front(),
               "malformed_document", "twice");
  expect_fault(answers(program, "{\"request\": \"hermite\", \"step\": 1e999}\n").front(),
               "malformed_document", "range");
  expect_fault(answers(program, std::string(1000, '[') + "\n").front(), "malformed_document",
               "nests");
  expect_fault(answers(program, std::string("{\"request\": \"\xff\xfe\"}\n")).front(),
               "malformed_document", "");
}

TEST(Batch, SurvivesMutatedRequests) {
  const Program program;
  Random rng("Batch.SurvivesMutatedRequests");
  const Json document = answer(program, quarter_circle())["result"]["document"];
  const std::vector<std::string> seeds = {
      quarter_circle().dump(),
      Json({{"request", "evaluate"}, {"document", document}, {"xi", {0.5}}}).dump(),
      Json({{"request", "fit"}, {"formula", "t, t^2, sin(t)"}, {"tolerance", 0.01}})
          .dump()};  // not a tolerance: request data
  std::string lines;
  constexpr int count = 600;
  const std::string alphabet = "{}[]\",:0123456789eE+-.tfn\\u x^()";
  for (int i = 0; i < count; ++i) {
    std::string line = seeds[static_cast<std::size_t>(i) % seeds.size()];
    for (int k = 0; k < 1 + i % 4; ++k) {
      const auto at = static_cast<std::size_t>(rng.integer(0, static_cast<int>(line.size()) - 1));
      const char c =
          alphabet[static_cast<std::size_t>(rng.integer(0, static_cast<int>(alphabet.size()) - 1))];
      if (i % 2 == 0) {
        line[at] = c;
      } else {
        line.erase(at, 1);
      }
    }
    if (line.find_first_not_of(' ') == std::string::npos) line = "{}";
    lines += line + "\n";
  }
  const auto all = answers(program, lines);
  EXPECT_EQ(all.size(), static_cast<std::size_t>(count));
  for (const Json& one : all) EXPECT_TRUE(one.contains("ok"));
}

TEST(Batch, WritesAFileWhenAskedAndRefusesAMissingInput) {
  const Program program;
  write_text(program.path("in.jsonl"), quarter_circle().dump() + "\n" + "{}");
  EXPECT_EQ(program.run({"batch", "in.jsonl", "-o", "out.jsonl"}).code, 0);
  EXPECT_EQ(line_count(text_of_file(program.path("out.jsonl"))), 2u);
  const Outcome missing = program.run({"batch", "missing.jsonl"});
  EXPECT_EQ(missing.code, 2);
  EXPECT_EQ(line_count(missing.err), 1u);
}

}  // namespace
}  // namespace hodograph::test
