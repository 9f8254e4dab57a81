// SPDX-License-Identifier: MIT
// Text as a mathematician types it: what is read, what is refused and where, and that what is
// printed reads back.
#include "hodograph/rational/text.hpp"

#include <gtest/gtest.h>

#include <string>

#include "support/rational_golden.hpp"

namespace hodograph {
namespace {

using namespace test;

QuaternionFunction value(const std::string& text) {
  const auto result = parse_expression(text);
  EXPECT_TRUE(result) << text << ": " << (result ? "" : result.fault().sentence);
  return result ? *result : QuaternionFunction{};
}
const RationalPolynomial t = RationalPolynomial::monomial(1, 1);
QuaternionPolynomial quaternion(const std::string& text) {
  return quaternion_polynomial(value(text), "A").value();
}
RationalFunction function(const std::string& text) {
  return real_function(value(text), "f").value();
}

TEST(RationalText, ReadsWhatAMathematicianTypes) {
  const QuaternionPolynomial a{t * t, -t, -t, 1};
  for (const char* text :
       {"t^2 - (i+j)*t + k", "t^2-(i+j)t+k", "t**2 - t i - t j + k",
        "t\u00B2 \u2212 (i + j)\u00B7t + k", "(t^2, -t, -t, 1)", "tt - it - jt + k",
        "k\n+ t^2 - {i + j} t", "[t^2] + (-t, -t, 1) # Example 5.1"}) {
    const std::string whole = std::string(text);
    EXPECT_EQ(parse_definitions("A = (" + whole.substr(0, whole.find('#')) + ")").value()[0].value,
              (QuaternionFunction{a, 1}))
        << text;
  }
  EXPECT_EQ(quaternion("i*j"), quaternion("k"));
  EXPECT_EQ(quaternion("j*i"), quaternion("-k"));
  EXPECT_EQ(quaternion("ijk"), quaternion("-1"));
  EXPECT_EQ(quaternion("k i^3"), quaternion("-j"));
  EXPECT_EQ(quaternion("(1 + i t)(j - t)"), quaternion("j - t + k t - i t^2"));
  EXPECT_EQ(function("-t^2").numerator(), -(t * t));
  EXPECT_EQ(function("2^3^2").numerator(), RationalPolynomial(512));
  EXPECT_EQ(function("0.125").numerator(), RationalPolynomial(Rational(1, 8)));
  EXPECT_EQ(function(".5 - 1.").numerator(), RationalPolynomial(Rational(-1, 2)));
  EXPECT_EQ(function("25e-3").numerator(), RationalPolynomial(Rational(1, 40)));
  EXPECT_EQ(function("1E2").numerator(), RationalPolynomial(100));
  EXPECT_EQ(function("3/4 t").numerator(), RationalPolynomial(Rational(3, 4)) * t);
  EXPECT_EQ(function("2/3/4 t^2").numerator(), RationalPolynomial(Rational(1, 6)) * t * t);
  EXPECT_EQ(function("2*-t + --3").numerator(), RationalPolynomial({3, -2}));
  EXPECT_EQ(function("(t^2 - 1)/(2t + 2)").numerator(),
            RationalPolynomial({Rational(-1, 2), Rational(1, 2)}));
  EXPECT_EQ(function("(t + 1)^-2"), RationalFunction(1, (t + 1).power(2)));
  EXPECT_EQ(function("t\u00B9\u2070").numerator(), t.power(10));
  EXPECT_EQ(vector_function(value("(t^2, 1, t)/t"), "r").value(), VectorFunction({t * t, 1, t}, t));
}

TEST(RationalText, ReadsDefinitions) {
  const auto all = parse_definitions(
                       "# Example 5.6\r\n"
                       "u = t (t - 1);  \u03B1 = 3 u // a comment\n\n"
                       "deg B \u2264 5\n"
                       "B = 2 * (t,\n 0, 1/2)\n"
                       "r = -2 B /\n   alpha")
                       .value();
  ASSERT_EQ(all.size(), 5u);
  EXPECT_EQ(all[1].name, "alpha");
  EXPECT_EQ(real_polynomial(all[1].value, "alpha").value(), RationalPolynomial({0, -3, 3}));
  EXPECT_EQ(all[2].name, "degree");
  EXPECT_EQ(whole_number(all[2].value, "degree", 10).value(), 5u);
  EXPECT_EQ(
      vector_function(all[4].value, "r").value(),
      VectorFunction({RationalPolynomial(-4) * t, 0, -2}, RationalPolynomial(3) * t * (t - 1)));
  EXPECT_EQ(parse_definitions("").value().size(), 0u);
  EXPECT_EQ(parse_definitions(" ;\n# nothing\n").value().size(), 0u);
}

struct Mistake {
  const char *text, *place, *says;
};

TEST(RationalText, PointsAtTheCharacterThatIsWrong) {
  for (const Mistake& mistake : {
           Mistake{"A = t^2 - * t", "line 1, column 11: ", "got '*'"},
           Mistake{"A = t^2\nalpha = (t + 1", "line 2, column 15: ", "expected ')'"},
           Mistake{"A = t^2\nalpha = (t + 1", "line 2, column 15: ", "line 2, column 9"},
           Mistake{"A = t^2 +", "line 1, column 10: ", "got the end"},
           Mistake{"A = 1 \u00B7 \u00BD", "line 1, column 9: ", "got '\u00BD'"},
           Mistake{"A = foo + t", "line 1, column 5: ", "'foo' is not known"},
           Mistake{"A = t2", "line 1, column 5: ", "'t2' is not known"},
           Mistake{"A t", "line 1, column 3: ", "expected '='"},
           Mistake{"= t", "line 1, column 1: ", "expected a definition"},
           Mistake{"t = 4", "line 1, column 1: ", "'t' is the variable"},
           Mistake{"j = 4", "line 1, column 1: ", "'j' is a unit"},
           Mistake{"A = t; A = 1", "line 1, column 8: ", "defined twice"},
           Mistake{"A = t/(1 + i)", "line 1, column 7: ", "a divisor is real"},
           Mistake{"A = t/(i*i + 1)", "line 1, column 7: ", "division by zero"},
           Mistake{"A = 1/t (t + 1)", "line 1, column 9: ", "two ways"},
           Mistake{"A = t/2 t", "line 1, column 9: ", "two ways"},
           Mistake{"A = t 2", "line 1, column 7: ", "a number after a factor"},
           Mistake{"A = t^(1/2)", "line 1, column 7: ", "whole number"},
           Mistake{"A = t^t", "line 1, column 7: ", "whole number"},
           Mistake{"A = i^-1", "line 1, column 7: ", "real base"},
           Mistake{"A = 0^-1", "line 1, column 7: ", "power of zero"},
           Mistake{"A = (1, t)", "line 1, column 5: ", "three items"},
           Mistake{"A = (1, i, 2)", "line 1, column 5: ", "items of a list are real"},
           Mistake{"A = (t]", "line 1, column 7: ", "expected ')'"},
           Mistake{"A = t)", "line 1, column 6: ", "expected an operator"},
           Mistake{"A = 1.2.3", "line 1, column 8: ", "a number after a factor"},
           Mistake{"A = t\x01", "line 1, column 6: ", "a control character"},
           Mistake{"A = \xFF", "line 1, column 5: ", "got '"},
       }) {
    const auto result = parse_definitions(mistake.text);
    ASSERT_FALSE(result) << mistake.text;
    EXPECT_EQ(result.fault().code, FaultCode::malformed_document);
    const std::string& sentence = result.fault().sentence;
    EXPECT_TRUE(sentence.starts_with(mistake.place)) << mistake.text << "\n" << sentence;
    EXPECT_NE(sentence.find(mistake.says), std::string::npos) << mistake.text << "\n" << sentence;
    EXPECT_TRUE(result.fault().index.has_value());
  }
}

TEST(RationalText, ShowsTheLineWithACaret) {
  const std::string text = "A = \u03B1\nalpha = t + * 2\n";
  const auto fault = parse_definitions("A = t\nalpha = t + * 2\n").fault();
  EXPECT_EQ(pointed_out(place_in("A = t\nalpha = t + * 2\n", *fault.index)),
            "alpha = t + * 2\n            ^\n");
  EXPECT_EQ(place_in(text, 5).column, 5u);  // inside the letter
  EXPECT_EQ(place_in(text, 1000).line, 3u);
  const std::string line(500, 'x');
  EXPECT_EQ(pointed_out(place_in(line, 300)),
            "..." + std::string(100, 'x') + "...\n" + std::string(63, ' ') + "^\n");
  EXPECT_EQ(pointed_out(place_in("", 0)), "\n^\n");
}

TEST(RationalText, RefusesWhatWouldTakeTooLong) {
  const std::string ones(1'000'000, '1');
  std::string sum = "t^1000";
  for (int i = 0; i < 50'000; ++i) sum += "+t^1000";
  std::string fractions = "1/(t+1)";
  for (int i = 2; i < 2000; ++i) fractions += "+1/(t+" + std::to_string(i) + ")";
  std::string names = "a0 = 1 + t\n";
  for (int i = 1; i < 60; ++i) {
    const std::string before = "a" + std::to_string(i - 1);
    names += "a" + std::to_string(i) + " = " + before + "*" + before + "\n";
  }
  std::string nested = "a0 = 2\n";
  for (int i = 1; i < 200; ++i) {
    nested += "a" + std::to_string(i) + " = a" + std::to_string(i - 1) + "^1024\n";
  }
  std::string work = "u = (3 + 5t)^1000\n";
  for (int i = 0; i < 900; ++i) work += "v" + std::to_string(i) + " = u + u\n";
  for (const std::string& text :
       {std::string("A = t^999999999"), std::string("A = t^(2^40)"), "A = t^" + ones, "A = " + ones,
        std::string("A = t^99999999999999999999999999999999"), std::string("A = 2^2^2^2^2^2"),
        std::string("A = (t^1000)^1000"), "A = " + std::string(100'000, '('),
        "A = " + std::string(100'000, '-') + "t", "A = t" + std::string(100'000, '^'),
        std::string("A = (t + 1)^1024 (t + 1)"), std::string("A = 1e999999999"), "A = " + sum,
        "A = " + fractions, names, nested, work, "A = " + std::string(5'000'000, ' ') + "t",
        std::string("A = (1 + i + j + k)^1025")}) {
    const auto result = parse_definitions(text);
    ASSERT_FALSE(result) << text.substr(0, 60);
    EXPECT_LT(result.fault().sentence.size(), 400u);
  }
}

TEST(RationalText, SaysWhatAValueShouldBe) {
  EXPECT_EQ(quaternion_polynomial(value("1/t"), "A").fault().sentence,
            "A should be a polynomial; it has the denominator t");
  EXPECT_EQ(real_polynomial(value("t + i"), "alpha").fault().sentence,
            "alpha should be real; it is t + i");
  EXPECT_EQ(real_polynomial(value("1/(t + 1)"), "alpha").fault().sentence,
            "alpha should be a polynomial; it has the denominator t + 1");
  EXPECT_EQ(vector_function(value("1 + i"), "r").fault().sentence,
            "r should be a vector (x, y, z); it has the real part 1");
  for (const char* text : {"-1", "1/2", "t", "i", "1/t"}) {
    EXPECT_FALSE(whole_number(value(text), "degree", 9)) << text;
  }
  EXPECT_EQ(whole_number(value("10"), "degree", 9).fault().code, FaultCode::unsupported);
}

TEST(RationalText, PrintsWhatReadsBack) {
  EXPECT_EQ(to_text(QuaternionPolynomial{t * t, -t, -t, 1}), "t^2 - (i + j)*t + k");
  EXPECT_EQ(to_text(quaternion("(1 - i) t - 3/2 k t + j - 4")), "(1 - i - 3/2*k)*t - 4 + j");
  EXPECT_EQ(to_text(QuaternionPolynomial{}), "0");
  EXPECT_EQ(to_text(quaternion("-i t^2")), "-i*t^2");
  EXPECT_EQ(to_text(VectorFunction({t, 1, {}}, t * t)), "(t, 1, 0)/(t^2)");
  EXPECT_EQ(to_text(RationalVector{1, Rational(-1, 2), 0}), "(1, -1/2, 0)");
  Random random("texts");
  for (int i = 0; i < 200; ++i) {
    const auto scale = RationalPolynomial(Rational(static_cast<std::int64_t>(1 + random.index(9)),
                                                   static_cast<std::int64_t>(1 + random.index(9))));
    const auto a = scale * random_quaternion_polynomial(random, random.index(4), 2);
    EXPECT_EQ(quaternion(to_text(a)), a) << to_text(a);
    const auto q = scale * random_polynomial(random, random.index(4), 3);
    const RationalFunction f(random_polynomial(random, random.index(4), 3), q);
    EXPECT_EQ(function(to_text(f)), f) << to_text(f);
    const VectorFunction r(random_vector_polynomial(random, random.index(4), 3), q);
    EXPECT_EQ(vector_function(value(to_text(r)), "r").value(), r) << to_text(r);
  }
}

}  // namespace
}  // namespace hodograph
