// SPDX-License-Identifier: MIT
// Tables in every common dialect; what is wrong with a table is said with its line and column.
#include "hodograph/io/table.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "hodograph/io/file.hpp"

namespace hodograph {
namespace {

using Numbers = std::vector<double>;

std::string refusal(std::string_view text) {
  const auto table = read_table(text);
  return table ? "accepted" : table.fault().sentence;
}

TEST(Table, EveryDialectReadsTheSame) {
  for (const std::string_view text : {
           "t,x,y\n0,1,-2\n.5,+1.5e1,3.\n",
           "t;x;y\r\n0;1;-2\r\n0.5;15;3\r\n",
           "\xef\xbb\xbft\tx\ty\n0\t1\t-2\n0.5\t15\t3",
           "t  x y \n 0 1   -2\n0.5\t15 3 \n\n\n",
           "# a comment\n\n% another\nt, x, y\n# inside\n0, 1, -2\n 0.5 ,15 , 3\n",
           "\"t\",\"x\", \"y\"\n\"0\",1,\"-2\"\n0.5,\" 15 \",3\n",
           "t,x,y\r0,1,-2\r0.5,15,3\r",
       }) {
    const auto table = read_table(text);
    ASSERT_TRUE(table) << text << ": " << table.fault().sentence;
    EXPECT_EQ(table->names, (std::vector<std::string>{"t", "x", "y"})) << text;
    EXPECT_EQ(table->values, (Numbers{0, 1, -2, 0.5, 15, 3})) << text;
    EXPECT_EQ(table->column_count, 3U);
    EXPECT_EQ(table->row_count(), 2U);
  }
}

TEST(Table, AHeaderIsOptional) {
  const Table table = read_table("0 1\n1 2\n").value();
  EXPECT_TRUE(table.names.empty());
  EXPECT_EQ(table.title(1), "2");
  EXPECT_EQ(table.column("2").value(), 1U);
}

TEST(Table, NamesAreFoundWithoutCaseAndUnit) {
  const Table table = read_table("Time (TU),X (LU),x [m],\"a \"\"b\"\"\"\n1,2,3,4\n").value();
  EXPECT_EQ(table.column("time").value(), 0U);
  EXPECT_EQ(table.column(" TIME (tu) ").value(), 0U);
  EXPECT_EQ(table.column("x (LU)").value(), 1U);
  EXPECT_EQ(table.column("a \"b\"").value(), 3U);
  EXPECT_EQ(table.column("4").value(), 3U);
  EXPECT_EQ(table.column("x").fault().sentence,
            "two columns are called 'x': number 2 and number 3; give the number");
  EXPECT_EQ(table.column("z").fault().sentence,
            "there is no column 'z'; the columns are 'Time (TU)', 'X (LU)', 'x [m]', 'a \"b\"'");
  EXPECT_EQ(unit_of(table.names[0]), "TU");
  EXPECT_EQ(unit_of(table.names[2]), "m");
  EXPECT_EQ(unit_of("plain"), "");
}

TEST(Table, NumbersAreRoundedCorrectlyToTheEndsOfTheRange) {
  const Table table = read_table("1e-400,4.9e-324,-1e-310,1.7976931348623157e308,-0\n").value();
  EXPECT_EQ(table.values[0], 0.0);
  EXPECT_EQ(table.values[1], std::numeric_limits<double>::denorm_min());
  EXPECT_EQ(table.values[2], -1e-310);  // not a tolerance: a subnormal number
  EXPECT_EQ(table.values[3], std::numeric_limits<double>::max());
  EXPECT_TRUE(std::signbit(table.values[4]));
}

TEST(Table, FaultsNameTheLineAndTheColumn) {
  EXPECT_EQ(refusal(""), "the table is empty");
  EXPECT_EQ(refusal("# only\n\n"), "the table is empty");
  EXPECT_EQ(refusal("t,x\n"), "the table has a header and no row of numbers");
  EXPECT_EQ(refusal("t,x\n0,1\n\n1,abc\n"), "the table, line 4, column 'x': 'abc' is not a number");
  EXPECT_EQ(refusal("0,1\n1,x\n"), "the table, line 2, column 2: 'x' is not a number");
  EXPECT_EQ(refusal("t,x\n0,nan\n"), "the table, line 2, column 'x': 'nan' is not a finite number");
  EXPECT_EQ(refusal("0,-Inf\n"), "the table, line 1, column 2: '-Inf' is not a finite number");
  EXPECT_EQ(refusal("0,1e999\n"),
            "the table, line 1, column 2: '1e999' is beyond the largest double");
  EXPECT_EQ(refusal("0,1\n1\n"), "the table, line 2 has 1 field; line 1 has 2");
  EXPECT_EQ(refusal("t,x\n0,1,2\n"), "the table, line 2 has 3 fields; line 1 has 2");
  EXPECT_EQ(refusal("t,x\n0,\n"),
            "the table, line 2, column 'x': the field is empty; a number is needed");
  EXPECT_EQ(refusal("0;1,5\n"),
            "the table, line 1, column 2: '1,5' has a decimal comma; write 1.5");
  EXPECT_EQ(refusal("0,\"1\n"), "the table, line 1: a quote is not closed, or text follows it");
  EXPECT_EQ(refusal("0,\"1\"2\n"), "the table, line 1: a quote is not closed, or text follows it");
  EXPECT_EQ(refusal("\xff\xfe"
                    "0"),
            "the table is UTF-16; save it as UTF-8");
  EXPECT_EQ(refusal("t,x\n0,0x10\n"), "the table, line 2, column 'x': '0x10' is not a number");
  EXPECT_EQ(refusal("t,x\n0,1 2\n"), "the table, line 2, column 'x': '1 2' is not a number");
  EXPECT_EQ(refusal("t\xff,x\n0,1\n"), "the table, line 1: the text is not UTF-8");
  EXPECT_EQ(refusal("0,\x1b[2J\n"), "the table, line 1, column 2: '\\x1b[2J' is not a number");
}

TEST(Table, WhatIsWrittenIsRead) {
  std::mt19937_64 engine(20260722);
  Table table;
  table.names = {"a", "b, \"c\"", "# d (m)"};
  table.column_count = 3;
  for (std::uint32_t line = 2; line < 500; ++line) {
    table.lines.push_back(line);
    while (table.values.size() < 3 * table.lines.size()) {
      const double value = std::bit_cast<double>(engine());
      if (std::isfinite(value)) table.values.push_back(value);
    }
  }
  const Table read = read_table(to_csv(table)).value();
  EXPECT_EQ(read.names, table.names);
  EXPECT_EQ(read.values, table.values);
  EXPECT_EQ(read.lines, table.lines);
}

TEST(CurveSamples, ColumnsAreFoundByPlaceOrByName) {
  const Table table = read_table("Time (s),speed,X (m),Y (m)\n0,9,1,2\n1,9,3,4\n").value();
  CurveSamples samples = curve_samples(table).value();
  EXPECT_EQ(samples.dimension, 2U);
  EXPECT_EQ(samples.parameters, (Numbers{0, 1}));
  EXPECT_EQ(samples.points[1], (Vector3<double>{3, 4, 0}));
  EXPECT_EQ(samples.parameter_unit, "s");
  EXPECT_EQ(samples.length_unit, "m");
  samples = curve_samples(table, {"x", {"2", "time", "y"}}).value();
  EXPECT_EQ(samples.dimension, 3U);
  EXPECT_EQ(samples.points[1], (Vector3<double>{9, 1, 4}));
  samples = curve_samples(read_table("0 1 2 3 4\n1 5 6 7 8\n").value()).value();
  EXPECT_EQ(samples.dimension, 3U);
  EXPECT_EQ(samples.points[1], (Vector3<double>{5, 6, 7}));
}

TEST(CurveSamples, FaultsSayWhatWouldBeRight) {
  const auto sentence = [](std::string_view text, const SampleColumns& columns = {}) {
    const auto samples = curve_samples(read_table(text).value(), columns, "'a.csv'");
    return samples ? "accepted" : samples.fault().sentence;
  };
  EXPECT_EQ(sentence("t,x\n0,1\n"),
            "'a.csv' has 2 columns; a parameter and two or three coordinates are needed");
  EXPECT_EQ(sentence("t,x,y\n0,1,2\n"), "'a.csv' has one row; a curve needs at least two");
  EXPECT_EQ(sentence("t,x,y\n0,1,2\n# skipped\n0,3,4\n"),
            "'a.csv', line 4: the parameter 't' must increase; 0 follows 0");
  EXPECT_EQ(sentence("t,x,y\n0,1,2\n1,3,4\n", {"u", {}}),
            "'a.csv': there is no column 'u'; the columns are 't', 'x', 'y'");
  EXPECT_EQ(sentence("t,x,y\n0,1,2\n1,3,4\n", {"t", {"x"}}),
            "two or three coordinate columns are needed; got 1");
}

TEST(Table, HostileBytesNeverCrash) {
  std::mt19937_64 engine(4);
  const std::string_view alphabet = "0123456789.,;\t \"\n\r-+eEnaxif#%\xff\xc3\x80";
  for (int i = 0; i < 20000; ++i) {
    std::string text;
    for (std::uint64_t n = engine() % 40; n > 0; --n) text += alphabet[engine() % alphabet.size()];
    if (const auto table = read_table(text)) {
      for (const double value : table->values) ASSERT_TRUE(std::isfinite(value));
      (void)curve_samples(*table).has_value();
    } else {
      ASSERT_EQ(table.fault().sentence.find('\n'), std::string::npos) << text;
    }
  }
}

// A table as the JPL catalogue of orbits writes it; its own file is not part of this repository,
// but may be named and is then read, too.
TEST(CurveSamples, AnOrbitTableReads) {
  const std::string header = "Time (TU),X (LU),Y (LU),Z (LU),VX (LU/TU),VY (LU/TU),VZ (LU/TU)\n";
  std::vector<std::string> tables = {
      header +
      "0,1.03,3.9e-27,-0.19,2.2e-14,-0.11,4.1e-13\n0.5,1.02,-0.05,-0.18,-0.06,-0.11,0.2\n"
      "1,0.99,-0.04,-0.03,-0.09,0.23,0.61\n"};
  if (const char* file = std::getenv("HODOGRAPH_ORBIT_TABLE"); file != nullptr) {
    tables.push_back(read_file(file).value());
  }
  for (const std::string& text : tables) {
    const auto samples = curve_samples(read_table(text).value());
    ASSERT_TRUE(samples) << samples.fault().sentence;
    EXPECT_EQ(samples->dimension, 3U);
    EXPECT_EQ(samples->parameter_unit, "TU");
    EXPECT_EQ(samples->length_unit, "LU");
    // The position's columns alone, one point a line after the header.
    const auto ends = std::count(text.begin(), text.end(), '\n');
    const auto lines = static_cast<std::size_t>(text.back() == '\n' ? ends : ends + 1);
    EXPECT_EQ(samples->points.size(), lines - 1);
    const auto x = text.find(',', text.find('\n')) + 1;
    EXPECT_EQ(samples->points.front()[0], std::stod(text.substr(x)));
  }
}

}  // namespace
}  // namespace hodograph
