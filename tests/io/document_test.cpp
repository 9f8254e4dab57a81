// SPDX-License-Identifier: MIT
// The path document: bit for bit there and back, one clear sentence for anything else.
#include "hodograph/io/document.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "document_samples.hpp"
#include "hodograph/io/file.hpp"
#include "temporary_directory.hpp"
#include "tests/support/paths.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Random;

bool same_bits(const std::vector<double>& a, const std::vector<double>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  }
  return true;
}

void expect_same_bits(const AnyPath& actual, const AnyPath& expected) {
  const PathNumbers a = actual.numbers(), e = expected.numbers();
  EXPECT_EQ(a.dimension, e.dimension);
  EXPECT_EQ(a.preimage_degree, e.preimage_degree);
  EXPECT_EQ(a.closed, e.closed);
  EXPECT_TRUE(same_bits(a.knots, e.knots));
  EXPECT_TRUE(same_bits(a.starts, e.starts));
  EXPECT_TRUE(same_bits(a.preimages, e.preimages));
}

template <class P>
void round_trip(Random& random, std::size_t segments) {
  const AnyPath path = test::random_path<P>(random, segments);
  const auto read = parse_document(to_json(PathDocument{path}));
  ASSERT_TRUE(read) << read.fault().sentence;
  expect_same_bits(read->path, path);
}

TEST(Document, RandomPathsRoundTripBitForBit) {
  Random random("Document.RandomPathsRoundTripBitForBit");
  for (std::size_t segments = 1; segments <= 20; ++segments) {
    round_trip<SpatialPath<0>>(random, segments);
    round_trip<SpatialPath<2>>(random, segments);
    round_trip<SpatialPath<8>>(random, segments);
    round_trip<SpatialPath<12>>(random, segments);
    round_trip<PlanarPath<1>>(random, segments);
    round_trip<PlanarPath<2>>(random, segments);
    round_trip<PlanarPath<4>>(random, segments);
  }
}

TEST(Document, HostileNumbersRoundTripBitForBit) {
  Random random("Document.HostileNumbersRoundTripBitForBit");
  int read_back = 0;
  for (int i = 0; i < 3000; ++i) {
    PathNumbers numbers;
    numbers.dimension = random.chance(0.5) ? 2 : 3;
    numbers.preimage_degree = random.index(4);
    const double first = random.hostile(), last = random.hostile();
    numbers.knots = {std::min(first, last), std::max(first, last)};
    for (std::size_t k = 0; k < numbers.dimension; ++k) numbers.starts.push_back(random.hostile());
    const std::size_t count = (numbers.preimage_degree + 1) * numbers.components_per_coefficient();
    for (std::size_t k = 0; k < count; ++k) numbers.preimages.push_back(random.hostile());
    const auto path = AnyPath::create(numbers);
    if (!path) continue;  // the squares overflow
    const auto read = parse_document(to_json(PathDocument{*path}));
    ASSERT_TRUE(read) << read.fault().sentence;
    expect_same_bits(read->path, *path);
    ++read_back;
  }
  EXPECT_GT(read_back, 100);
}

TEST(Document, EveryMemberRoundTrips) {
  Random random("Document.EveryMemberRoundTrips");
  const PathDocument document = test::full_document(random);
  const auto read = parse_document(to_json(document));
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_EQ(read->name, document.name);
  EXPECT_EQ(read->length_unit, "LU");
  EXPECT_EQ(read->parameter_unit, "TU");
  EXPECT_EQ(read->roll->xi_begin, document.roll->xi_begin);
  EXPECT_EQ(read->roll->theta_begin, document.roll->theta_begin);
  EXPECT_EQ(read->roll->rate, document.roll->rate);
  EXPECT_EQ(read->provenance, document.provenance);
  EXPECT_EQ(read->promises, document.promises);
  EXPECT_EQ(to_json(*read), to_json(document));
}

TEST(Document, APlansPromisesRoundTrip) {
  Random random("Document.APlansPromisesRoundTrip");
  PathDocument document = test::planar_document(random);
  const auto read = parse_document(to_json(document));
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_EQ(read->promises, document.promises);
  document.promises.clearance = ClearancePromise{};
  const auto empty = parse_document(to_json(document));
  ASSERT_TRUE(empty) << empty.fault().sentence;
  EXPECT_EQ(empty->promises, document.promises);
}

TEST(Document, TheTextIsMadeToBeRead) {
  using C = PlanarPhCurve<1>;
  const auto path = PlanarPath<1>::create({0.0, 0.5, 2.0},
                                          {C({-0.0, 1}, C::Preimage({{{1, 0}, {1, 0}}}), 0.5),
                                           C({0.5, 1}, C::Preimage({{{1, 0}, {1, 0.1}}}), 1.5)},
                                          false);
  PathDocument document{path.value()};
  document.name = "bend";
  EXPECT_EQ(to_json(document), R"({
  "format": "hodograph-path",
  "version": 1,
  "name": "bend",
  "algebra": "complex",
  "preimage_degree": 1,
  "closed": false,
  "knots": [
    0, 0.5, 2
  ],
  "segments": [
    {"start": [-0.0, 1], "preimage": [[1, 0], [1, 0]]},
    {"start": [0.5, 1], "preimage": [[1, 0], [1, 0.1]]}
  ]
}
)");
}

// What is not JSON, what cannot stand in JSON.
TEST(Document, WhatCannotBeWrittenIsLeftOut) {
  Random random("Document.WhatCannotBeWrittenIsLeftOut");
  PathDocument document = test::full_document(random);
  document.name = "bad \xff byte";
  document.promises.error->distance = Enclosure::whole_line();
  document.promises.largest_speed = Enclosure(1.0, INFINITY);
  document.promises.curvature_bound = INFINITY;
  const auto read = parse_document(to_json(document));
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_EQ(read->name, "bad \xef\xbf\xbd byte");
  EXPECT_FALSE(read->promises.error || read->promises.largest_speed ||
               read->promises.curvature_bound);
}

constexpr std::string_view small_document =
    R"({"format": "hodograph-path", "version": 1, "algebra": "complex", "preimage_degree": 1,
 "closed": false, "knots": [0, 1], "segments": [{"start": [0, 0], "preimage": [[1, 0], [1, 1]]}]})";

std::string replaced(std::string_view what, std::string_view by) {
  std::string text(small_document);
  const std::size_t at = text.find(what);
  EXPECT_NE(at, std::string::npos) << what;
  return text.replace(at, what.size(), by);
}

std::string refusal(std::string_view text) {
  const auto document = parse_document(text);
  return document ? "accepted" : document.fault().sentence;
}
std::string refusal(std::string_view what, std::string_view by) {
  return refusal(replaced(what, by));
}

TEST(Document, MembersStandInAnyOrder) {
  const auto one = parse_document(small_document);
  ASSERT_TRUE(one) << one.fault().sentence;
  const auto other = parse_document(
      "\xef\xbb\xbf"
      R"({"segments": [{"preimage": [[1, 0], [1.0e0, 1]], "start": [0, -0]}], "knots": [0.0, 1],
          "closed": false, "algebra": "complex", "preimage_degree": 1.0, "version": 1,
          "format": "hodograph-path"})");
  ASSERT_TRUE(other) << other.fault().sentence;
  EXPECT_EQ(one->path, other->path);
  EXPECT_TRUE(std::signbit(other->path.numbers().starts[1]));
}

TEST(Document, BrokenJsonIsLocated) {
  EXPECT_EQ(refusal(""),
            "the document, line 1, column 1: this is no JSON: unexpected end of input; "
            "expected '[', '{', or a literal");
  EXPECT_EQ(
      refusal(small_document.substr(0, 120)),
      "the document, line 2, column 34: this is no JSON: unexpected end of input; expected '}'");
  EXPECT_EQ(refusal("{\n\"a\": nul}"),
            "the document, line 2, column 9: this is no JSON: invalid literal after '\"a\": nul}'");
  EXPECT_EQ(refusal("[0, 1]", "[0, NaN]"),
            "the document, line 2, column 32: 'NaN' is not a finite number");
  EXPECT_EQ(refusal("[0, 1]", "[0, -Infinity]"),
            "the document, line 2, column 33: '-Infinity' is not a finite number");
  EXPECT_EQ(refusal(std::string(small_document) + "x"),
            "the document, line 2, column 98: this is no JSON: invalid literal after '1]]}]}x'; "
            "expected end of input");
  EXPECT_EQ(
      refusal("\"complex\"", "\"\xff\""),
      "the document, line 1, column 56: this is no JSON: invalid string: ill-formed UTF-8 byte "
      "after '\"\\xff'");
  EXPECT_EQ(refusal("\"complex\"", "\"a\nb\""),
            "the document, line 1, column 57: this is no JSON: invalid string: control character "
            "U+000A (LF) must be escaped to \\u000A or \\n after '\"a<U+000A>'");
  EXPECT_EQ(
      refusal("[0, 1]", "[0, 01]"),
      "the document, line 2, column 33: this is no JSON: unexpected number literal; expected ']'");
  EXPECT_EQ(refusal(std::string("\0\0", 2)), refusal(""));
}

TEST(Document, NumbersBeyondTheRangeAreRefusedWhereTheyStand) {
  EXPECT_EQ(refusal("[0, 1]", "[0, 1e999]"),
            "the document, at /knots/1: '1e999' is beyond the largest double");
  EXPECT_EQ(refusal("[1, 1]", "[1, -1e400]"),
            "the document, at /segments/0/preimage/1/1: '-1e400' is beyond the largest double");
  EXPECT_EQ(refusal("[1, 1]", "[1, 1e-999]"), "accepted");
  EXPECT_EQ(refusal("[1, 1]", "[1, 1e200]"),
            "the document: segment 0 has a coefficient that is infinite or not a number");
}

TEST(Document, EveryWrongMemberIsNamed) {
  EXPECT_EQ(refusal("null"),
            "the document: this is no path document: it has no member \"format\": "
            "\"hodograph-path\"");
  EXPECT_EQ(refusal("{\"type\": \"Feature\"}"), refusal("null"));
  EXPECT_EQ(refusal("[\"hodograph-path\"]"),
            "the document: a path document is a JSON object; got an array");
  EXPECT_EQ(refusal("\"hodograph-path\"", "\"hodograph-path-2\""),
            "the document, at /format: the format is 'hodograph-path-2'; a path document has "
            "'hodograph-path'");
  EXPECT_EQ(refusal("\"version\": 1", "\"version\": 2"),
            "the document, at /version: the document has version 2; this program reads version 1");
  EXPECT_EQ(refusal("\"closed\": false, ", ""), "the document: the member \"closed\" is missing");
  EXPECT_EQ(refusal("\"closed\": false", "\"closed\": 0"),
            "the document, at /closed: true or false is needed; got 0");
  EXPECT_EQ(refusal("\"closed\"", "\"close\""), "the document, at /close: this member is unknown");
  EXPECT_EQ(refusal("\"closed\": false", "\"closed\": false, \"closed\": false"),
            "the document, at /closed: this member stands here twice");
  EXPECT_EQ(refusal("\"algebra\": \"complex\"", "\"algebra\": \"octonion\""),
            "the document, at /algebra: 'octonion' is unknown; it is 'complex' in the plane, "
            "'quaternion' in space");
  EXPECT_EQ(
      refusal("\"complex\"", "\"quaternion\""),
      "the document, at /segments/0/start: the algebra 'quaternion' needs 3 coordinates; got 2");
  EXPECT_EQ(
      refusal("\"preimage_degree\": 1", "\"preimage_degree\": 2"),
      "the document, at /segments/0/preimage: the preimage degree 2 needs 3 coefficients; got 2");
  EXPECT_EQ(refusal("\"preimage_degree\": 1", "\"preimage_degree\": 13"),
            "the document, at /preimage_degree: the degree is 13; 0 to 12 can be read");
  EXPECT_EQ(refusal("\"preimage_degree\": 1", "\"preimage_degree\": 1.5"),
            "the document, at /preimage_degree: a whole number is needed; got 1.5");
  EXPECT_EQ(refusal("\"preimage_degree\": 1", "\"preimage_degree\": -1"),
            "the document, at /preimage_degree: the degree is -1; 0 to 12 can be read");
  EXPECT_EQ(refusal("[0, 1]", "[0, 1, 2]"),
            "the document, at /knots: 1 segment needs 2 knots; got 3");
  EXPECT_EQ(refusal("[0, 1]", "[0, \"1\"]"),
            "the document, at /knots/1: a number is needed; got a string");
  EXPECT_EQ(refusal("[0, 1]", "[0, [1]]"),
            "the document, at /knots/1: a number is needed; got an array");
  EXPECT_EQ(refusal("[0, 1]", "{}"), "the document, at /knots: an array is needed; got an object");
  EXPECT_EQ(refusal("[0, 1]", "[1, 0]"),
            "the document: knots must increase strictly; knot 1 is 0 after 1");
}

TEST(Document, EveryWrongSegmentIsNamed) {
  const std::string_view segment = "{\"start\": [0, 0], \"preimage\": [[1, 0], [1, 1]]}";
  EXPECT_EQ(refusal(segment, ""), "the document, at /segments: a path needs at least one segment");
  EXPECT_EQ(
      refusal(segment, "7"),
      "the document, at /segments/0: a segment, an object with \"start\" and \"preimage\", is "
      "needed; got a number");
  EXPECT_EQ(refusal(segment, "{\"start\": [0, 0]}"),
            "the document, at /segments/0: the segment has no \"preimage\"");
  EXPECT_EQ(refusal(segment, "{}"), "the document, at /segments/0: the segment has no \"start\"");
  EXPECT_EQ(
      refusal("\"start\"", "\"Start\""),
      "the document, at /segments/0/Start: this member is unknown; a segment has \"start\" and "
      "\"preimage\"");
  EXPECT_EQ(refusal("\"start\": [0, 0]", "\"start\": [0, 0], \"start\": [0, 0]"),
            "the document, at /segments/0/start: this member stands here twice");
  EXPECT_EQ(refusal("\"start\": [0, 0]", "\"start\": [0, 0, 0, 0]"),
            "the document, at /segments/0/start/3: at most 3 coordinates are needed");
  EXPECT_EQ(refusal("\"start\": [0, 0]", "\"start\": [0, null]"),
            "the document, at /segments/0/start/1: a number is needed; got null");
  EXPECT_EQ(refusal("\"start\": [0, 0]", "\"start\": 0"),
            "the document, at /segments/0/start: an array is needed; got a number");
  EXPECT_EQ(
      refusal("[1, 1]", "[1, 1, 1]"),
      "the document, at /segments/0/preimage/1: a preimage coefficient has 3 numbers, the one "
      "before it 2");
  EXPECT_EQ(
      refusal("[1, 1]", "1"),
      "the document, at /segments/0/preimage/1: a coefficient, an array of numbers, is needed; "
      "got a number");
  EXPECT_EQ(refusal("[1, 1]", "[1, [1]]"),
            "the document, at /segments/0/preimage/1/1: a number is needed; got an array");
  EXPECT_EQ(refusal("[1, 1]", "[1, {}]"),
            "the document, at /segments/0/preimage/1/1: a number is needed; got an object");
  EXPECT_EQ(
      refusal("[[1, 0], [1, 1]]", "[]"),
      "the document, at /segments/0/preimage: the preimage degree 1 needs 2 coefficients; got 0");
  const std::string two =
      std::string(segment) + ", {\"start\": [9, 9], \"preimage\": [[1, 0], [1, 1]]}";
  std::string torn = replaced(segment, two);
  torn.replace(torn.find("[0, 1]"), 6, "[0, 1, 2]");
  EXPECT_NE(refusal(torn).find("the document: the path is torn at knot 1"), std::string::npos);
}

TEST(Document, WrongPromisesAndFramesAreNamed) {
  const auto with = [](std::string_view members) {
    return refusal(replaced("\"closed\"", std::string(members) + ", \"closed\""));
  };
  EXPECT_EQ(with(R"("promises": {"arc_length": {"lower": 2, "upper": 1}})"),
            "the document, at /promises/arc_length: the bounds should be 0 <= lower <= upper; got "
            "lower 2 and upper 1");
  EXPECT_EQ(with(R"("promises": {"arc_length": {"lower": 2}})"),
            "the document, at /promises/arc_length: the member \"upper\" is missing");
  EXPECT_EQ(with(R"("promises": {"curvature_bound": -1})"),
            "the document, at /promises/curvature_bound: -1 is negative");
  EXPECT_EQ(
      with(R"("promises": {"continuity": {"position": 1, "preimage": 0, "frame": 0,
                    "angular_velocity": 1000}})"),
      "the document, at /promises/continuity/angular_velocity: an order of continuity is -1 to "
      "100; got 1000");
  EXPECT_EQ(with(R"("promises": {"end": [1]})"),
            "the document, at /promises/end: 2 coordinates are needed; got 1");
  EXPECT_EQ(with(R"("promises": {"end": [1, "2"]})"),
            "the document, at /promises/end/1: a number is needed; got a string");
  EXPECT_EQ(with(R"("promises": {"end": [1, 2, 3, 4]})"),
            "the document, at /promises/end/3: at most 3 coordinates are needed");
  const auto clearance = [&](std::string_view rows) {
    return with(R"("promises": {"clearance": {"reach": 1, "obstacles": )" + std::string(rows) +
                "}}");
  };
  EXPECT_EQ(clearance("[[1, 2, 3]]"), "accepted");
  EXPECT_EQ(clearance("[[1, 2]]"),
            "the document, at /promises/clearance/obstacles/0: an obstacle number and two bounds "
            "are needed; got 2 numbers");
  EXPECT_EQ(clearance("[3]"),
            "the document, at /promises/clearance/obstacles/0: a row, an array of an obstacle "
            "number and two bounds, is needed; got a number");
  EXPECT_EQ(clearance("[[1, [2], 3]]"),
            "the document, at /promises/clearance/obstacles/0/1: a number is needed; got an array");
  EXPECT_EQ(clearance("[[2, 0, 1], [1, 0, 1]]"),
            "the document, at /promises/clearance/obstacles/1: the obstacle numbers should be "
            "whole and increase; got 1");
  EXPECT_EQ(clearance("[[2, 3, 1]]"),
            "the document, at /promises/clearance/obstacles/0: the bounds should be 0 <= lower <= "
            "upper; got lower 3 and upper 1");
  EXPECT_EQ(clearance("{}"),
            "the document, at /promises/clearance/obstacles: an array is needed; got an object");
  EXPECT_EQ(with(R"("promises": {"helix": {"axis": {"x": 0, "y": 0, "z": 1},
                                          "sines": [[0, 0.5, 0.5]]}})"),
            "the document, at /promises/helix: a path in the plane does not climb");
  EXPECT_EQ(with(R"("promises": {"helix": {"axis": {"x": 0, "y": 0, "z": 1}, "sines": [[0]]}})"),
            "the document, at /promises/helix/sines/0: a segment number and two bounds are needed; "
            "got 1 numbers");
  EXPECT_EQ(with(R"("promises": [])"),
            "the document, at /promises: an object is needed; got an array");
  EXPECT_EQ(
      with(R"("frame": {"roll": {"kind": "linear", "xi_begin": 0, "theta_begin": 0, "rate": 1}})"),
      "the document, at /frame/roll: a path in the plane has no roll");
  EXPECT_EQ(
      with(R"("frame": {"roll": {"kind": "cubic", "xi_begin": 0, "theta_begin": 0, "rate": 1}})"),
      "the document, at /frame/roll/kind: 'cubic' is unknown; a roll is 'linear'");
  EXPECT_EQ(with(R"("frame": {})"), "the document, at /frame: the member \"roll\" is missing");
  EXPECT_EQ(with(R"("name": null)"), "the document, at /name: a string is needed; got null");
  EXPECT_EQ(with(R"("a/b~": 1)"), "the document, at /a~1b~0: this member is unknown");
}

TEST(Document, DeepAndHugeTextsAreRefusedInOneLine) {
  for (const std::string& text : {std::string(1000000, '['), std::string(1000000, '{'),
                                  replaced("[0, 1]", std::string(1000000, '[')),
                                  replaced("complex", std::string(1000000, 'x')),
                                  replaced("\"closed\"", "\"" + std::string(1000000, 'x') + "\""),
                                  replaced("[0, 1]", "[" + std::string(1000000, '1') + "]")}) {
    const std::string sentence = refusal(text);
    EXPECT_NE(sentence, "accepted");
    EXPECT_LT(sentence.size(), 300U) << sentence;
  }
}

// Cut anywhere, with bytes and members changed at random: a document or a sentence, never more.
TEST(Document, DamagedTextsGiveOneSentence) {
  Random random("Document.DamagedTextsGiveOneSentence");
  const std::string whole = to_json(test::full_document(random));
  const std::vector<std::string_view> pieces = {"{",
                                                "}",
                                                "[",
                                                "]",
                                                ",",
                                                ":",
                                                "\"",
                                                "null",
                                                "true",
                                                "-",
                                                "1e999",
                                                "NaN",
                                                "\\u0000",
                                                "\\ud800",
                                                "\xff",
                                                "[[[[",
                                                "0",
                                                "\"knots\"",
                                                "\"segments\":",
                                                "{}",
                                                "1e-999",
                                                "\n",
                                                "-0",
                                                "\xef\xbb\xbf"};
  int accepted = 0;
  const auto check = [&](const std::string& text) {
    const auto document = parse_document(text);
    if (document) {
      ++accepted;
      ASSERT_TRUE(parse_document(to_json(*document)));
    } else {
      const std::string& sentence = document.fault().sentence;
      ASSERT_FALSE(sentence.empty());
      ASSERT_LT(sentence.size(), 400U) << sentence;
      for (const char c : sentence) ASSERT_GE(static_cast<unsigned char>(c), 0x20U) << sentence;
    }
  };
  for (std::size_t cut = 0; cut + 2 < whole.size(); ++cut) {
    const auto document = parse_document(std::string_view(whole).substr(0, cut));
    ASSERT_FALSE(document) << "cut at " << cut;
  }
  for (int i = 0; i < test::cases(20000); ++i) {
    std::string text = whole;
    for (std::int64_t changes = random.integer(1, 3); changes > 0; --changes) {
      const std::size_t at = random.index(text.size());
      switch (random.integer(0, 3)) {
        case 0:
          text[at] = static_cast<char>(random.integer(0, 255));
          break;
        case 1:
          text.insert(at, pieces[random.index(pieces.size())]);
          break;
        case 2:
          text.erase(at, random.index(20));
          break;
        default:
          text.insert(at, text.substr(random.index(text.size()), random.index(200)));
      }
      if (text.empty()) text = "x";
    }
    check(text);
  }
  EXPECT_GT(accepted, 0);
}

TEST(Document, FilesNameThemselvesInFaults) {
  const TemporaryDirectory directory;
  Random random("Document.FilesNameThemselvesInFaults");
  const PathDocument document = test::full_document(random);
  const std::string path = directory.path("path.json");
  ASSERT_FALSE(save_document(document, path));
  const auto read = load_document(path);
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_EQ(read->path, document.path);
  ASSERT_FALSE(write_file(path, "{"));
  EXPECT_TRUE(
      load_document(path).fault().sentence.starts_with("'" + path + "', line 1, column 2: "));
  EXPECT_EQ(load_document(directory.path("none")).fault().sentence,
            "cannot read '" + directory.path("none") + "': No such file or directory");
  const auto fault = save_document(document, directory.path("no/f"));
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code, FaultCode::not_written);
}

TEST(Document, ManySegmentsAreRead) {
  using C = SpatialPhCurve<2>;
  const std::size_t count = 100000;
  std::vector<double> knots{0.0};
  std::vector<C> segments;
  for (std::size_t k = 0; k < count; ++k) {
    const auto x = static_cast<double>(k);
    knots.push_back(x + 1.0);
    segments.emplace_back(Vector3<double>{x, 0, 0},
                          C::Preimage({{{1, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}}}), 1.0);
  }
  const AnyPath path = SpatialPath<2>::create(std::move(knots), std::move(segments), false).value();
  const auto read = parse_document(to_json(PathDocument{path}));
  ASSERT_TRUE(read) << read.fault().sentence;
  EXPECT_TRUE(read->path == path);
}

}  // namespace
}  // namespace hodograph
