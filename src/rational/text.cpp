// SPDX-License-Identifier: MIT
// Recursive descent over text, with exact values and bounds on their size.
#include "hodograph/rational/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "flint.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

/// What all operations of one text may cost together, in words of 64 bits that are multiplied;
/// a machine does some hundred millions a second, and no more of them are ever held.
constexpr std::uint64_t most_work = std::uint64_t{1} << 27U;
/// Degree times bits of a power of quaternions: about a second of multiplications.
constexpr std::size_t largest_power_work = std::size_t{1} << 22U;
constexpr std::size_t most_definitions = 1000;
constexpr std::size_t largest_decimal_exponent = 1000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_unit_or_variable(char c) { return c == 'i' || c == 'j' || c == 'k' || c == 't'; }

/// The length of the UTF-8 character that begins with c (1 for a byte that begins none).
std::size_t character_length(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
}

/// Characters that stand for others.
struct Spelling {
  std::string_view typed, meant;
};
constexpr std::array spellings = {Spelling{"\u2212", "-"},     Spelling{"\u2013", "-"},
                                  Spelling{"\u00B7", "*"},     Spelling{"\u22C5", "*"},
                                  Spelling{"\u00D7", "*"},     Spelling{"**", "^"},
                                  Spelling{"\u03B1", "alpha"}, Spelling{"\u2264", "<="}};
constexpr std::array superscripts = {std::string_view("\u2070"), std::string_view("\u00B9"),
                                     std::string_view("\u00B2"), std::string_view("\u00B3"),
                                     std::string_view("\u2074"), std::string_view("\u2075"),
                                     std::string_view("\u2076"), std::string_view("\u2077"),
                                     std::string_view("\u2078"), std::string_view("\u2079")};

/// The number of coefficients, and of words of the longest of them.
struct Size {
  std::size_t length = 1, bits = 1;
  void include(const RationalPolynomial& p) {
    const auto count = fmpq_poly_length(raw(p));
    length = std::max(length, static_cast<std::size_t>(count));
    const slong top = std::abs(_fmpz_vec_max_bits(fmpq_poly_numref(raw(p)), count));
    bits = std::max({bits, static_cast<std::size_t>(top),
                     static_cast<std::size_t>(fmpz_bits(fmpq_poly_denref(raw(p))))});
  }
  std::uint64_t words() const { return bits / 64 + 1; }
};
Size size_of(const QuaternionFunction& value) {
  Size size;
  for (std::size_t c = 0; c < 4; ++c) size.include(value.numerator[c]);
  size.include(value.denominator);
  return size;
}

bool is_real(const QuaternionFunction& value) {
  return value.numerator.x.is_zero() && value.numerator.y.is_zero() && value.numerator.z.is_zero();
}
bool is_zero(const QuaternionFunction& value) {
  return is_real(value) && value.numerator.w.is_zero();
}
/// A rational number.
bool is_number(const QuaternionFunction& value) {
  return is_real(value) && value.denominator.is_one() && value.numerator.w.is_constant();
}

QuaternionFunction real(RationalPolynomial p) { return {{std::move(p), {}, {}, {}}, 1}; }

class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<TextDefinition> definitions() {
    require_length();
    for (;;) {
      skip(true);
      while (accept(";")) skip(true);
      if (at_ == text_.size()) return std::move(definitions_);
      definition();
      skip(false);
      if (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != ';') {
        refuse(at_, "expected an operator or the end of the line, got " + shown(at_));
      }
    }
  }
  QuaternionFunction expression() {
    require_length();
    QuaternionFunction value = sum();
    skip(true);
    if (at_ < text_.size()) {
      refuse(at_, "expected an operator or the end, got " + shown(at_));
    }
    return value;
  }

 private:
  [[noreturn]] void refuse(std::size_t index, const std::string& what,
                           FaultCode code = FaultCode::malformed_document) const {
    const TextPlace place = place_in(text_, index);
    throw Error(Fault{code,
                      "line " + std::to_string(place.line) + ", column " +
                          std::to_string(place.column) + ": " + what,
                      index, "text", std::nullopt, std::nullopt});
  }
  [[noreturn]] void refuse_size(std::size_t index, const std::string& what, std::size_t value,
                                std::size_t most) const {
    refuse(index,
           what + " " + std::to_string(value) + "; at most " + std::to_string(most) + " is offered",
           FaultCode::unsupported);
  }
  void require_length() const {
    if (text_.size() > longest_rational_text) {
      refuse_size(0, "the number of bytes is", text_.size(), longest_rational_text);
    }
  }

  /// The character at a place, for sentences.
  std::string shown(std::size_t index) const {
    if (index >= text_.size()) return "the end";
    const char c = text_[index];
    if (c == '\n' || c == '\r') return "the end of the line";
    const std::size_t length = std::min(character_length(c), text_.size() - index);
    const bool plain = static_cast<unsigned char>(c) >= 0x20 && c != 0x7f;
    return plain ? "'" + std::string(text_.substr(index, length)) + "'" : "a control character";
  }

  /// Skips blanks and comments, and line breaks where they end nothing.
  void skip(bool line_breaks) {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#' || text_.substr(at_).starts_with("//")) {
        at_ = std::min(text_.find('\n', at_), text_.size());
      } else if (c == ' ' || c == '\t' || c == '\r' || (c == '\n' && (line_breaks || open_ > 0))) {
        ++at_;
      } else if (text_.substr(at_).starts_with("\u00A0")) {
        at_ += 2;
      } else {
        return;
      }
    }
  }
  /// Goes past `meant`, or what is spelled in its place.
  bool accept(std::string_view meant) {
    const std::string_view rest = text_.substr(at_);
    for (const Spelling& s : spellings) {
      if (rest.starts_with(s.typed)) {
        if (s.meant != meant) return false;
        at_ += s.typed.size();
        return true;
      }
    }
    if (!rest.starts_with(meant)) return false;
    at_ += meant.size();
    return true;
  }

  /// A name, if one stands here: letters and digits, or the Greek alpha.
  std::string word() {
    if (accept("alpha")) return "alpha" + word_tail();
    if (at_ == text_.size() || !is_letter(text_[at_])) return "";
    return word_tail();
  }
  std::string word_tail() {
    std::string name;
    while (at_ < text_.size() && (is_letter(text_[at_]) || is_digit(text_[at_]))) {
      name += text_[at_++];
    }
    return name;
  }
  const TextDefinition* find(const std::string& name) const {
    for (const TextDefinition& d : definitions_) {
      if (d.name == name) return &d;
    }
    return nullptr;
  }

  void definition() {
    const std::size_t begin = at_;
    std::string name = word();
    if (name.empty()) {
      refuse(at_, "expected a definition such as \"A = t^2 + k\", got " + shown(at_));
    }
    if (name == "deg") {
      skip(false);
      const std::size_t before = at_;
      if (word() != "B") at_ = before;
      name = "degree";
    }
    if (name.size() == 1 && is_unit_or_variable(name[0])) {
      refuse(begin, "'" + name + "' is " + (name == "t" ? "the variable" : "a unit") +
                        "; it cannot be defined");
    }
    if (find(name) != nullptr) refuse(begin, "'" + name + "' is defined twice");
    if (definitions_.size() == most_definitions) {
      refuse_size(begin, "the number of definitions becomes", most_definitions + 1,
                  most_definitions);
    }
    skip(false);
    if (!(name == "degree" && accept("<=")) && !accept(":=") && !accept("=")) {
      refuse(at_, "expected '=' after '" + name + "', got " + shown(at_));
    }
    skip(true);
    const std::size_t index = at_;
    QuaternionFunction value = sum();
    definitions_.push_back({std::move(name), index, std::move(value)});
  }

  /// Goes one level deeper as long as it lives.
  class Level {
   public:
    explicit Level(Parser& parser) : parser_(parser) {
      if (++parser_.depth_ > deepest_text_nesting) {
        parser_.refuse(parser_.at_,
                       "brackets, signs and powers nest deeper than " +
                           std::to_string(deepest_text_nesting) + " levels",
                       FaultCode::unsupported);
      }
    }
    ~Level() { --parser_.depth_; }
    Level(const Level&) = delete;
    Level& operator=(const Level&) = delete;

   private:
    Parser& parser_;
  };

  QuaternionFunction sum() {
    const Level level(*this);
    QuaternionFunction value = product();
    for (;;) {
      skip(false);
      const std::size_t place = at_;
      const bool minus = accept("-");
      if (!minus && !accept("+")) return value;
      skip(true);
      const QuaternionFunction next = product();
      value = added(value, minus ? negated(next) : next, place);
    }
  }

  QuaternionFunction product() {
    skip(true);
    QuaternionFunction value = factor();
    bool divided = false;            // the last sign was a division
    bool number = is_number(value);  // so far a number, so that what is divided is a fraction
    for (;;) {
      skip(false);
      const std::size_t place = at_;
      if (accept("*")) {
        skip(true);
        value = multiplied(value, factor(), place);
        divided = false;
      } else if (accept("/")) {
        skip(true);
        const std::size_t at = at_;
        const QuaternionFunction divisor = factor();
        if (!is_real(divisor)) {
          refuse(at,
                 "a divisor is real, and this one is a quaternion; right would be a product "
                 "with its inverse on one side");
        }
        if (is_zero(divisor)) refuse(at, "a division by zero");
        number = number && is_number(divisor);
        divided = !number;
        value = multiplied(value, {{divisor.denominator, {}, {}, {}}, divisor.numerator.w}, place);
      } else if (begins_factor()) {
        if (divided) {
          refuse(at_,
                 "a product without its sign after a division can be read in two ways; right "
                 "would be * or brackets");
        }
        if (is_digit(text_[at_]) || text_[at_] == '.') {
          refuse(at_, "a number after a factor needs the sign * (or ^ for a power)");
        }
        value = multiplied(value, power(), place);
      } else {
        return value;
      }
      number = number && is_number(value);
    }
  }
  /// Whether a factor without a sign begins here.
  bool begins_factor() const {
    if (at_ == text_.size()) return false;
    const char c = text_[at_];
    return is_digit(c) || c == '.' || is_letter(c) || c == '(' || c == '[' || c == '{' ||
           text_.substr(at_).starts_with("\u03B1");
  }

  QuaternionFunction factor() {
    if (at_ < text_.size()) {
      if (accept("-")) {
        const Level level(*this);
        skip(true);
        return negated(factor());
      }
      if (accept("+")) {
        const Level level(*this);
        skip(true);
        return factor();
      }
    }
    return power();
  }

  QuaternionFunction power() {
    QuaternionFunction base = primary();
    const std::size_t before = at_;
    skip(false);
    std::size_t place = at_;
    if (accept("^")) {
      skip(true);
      place = at_;
      return raised(base, exponent(), place);
    }
    std::size_t digits = 0, k = 0;
    for (bool more = true; more;) {
      more = false;
      for (std::size_t digit = 0; digit < superscripts.size(); ++digit) {
        if (!text_.substr(at_).starts_with(superscripts[digit])) continue;
        at_ += superscripts[digit].size();
        k = std::min(10 * k + digit, 10 * largest_text_exponent);
        ++digits;
        more = true;
      }
    }
    if (digits == 0) {
      at_ = before;
      return base;
    }
    return raised(base, real(Rational(static_cast<std::int64_t>(k))), place);
  }
  QuaternionFunction exponent() {
    const Level level(*this);
    if (accept("-")) {
      skip(true);
      return negated(exponent());
    }
    if (accept("+")) {
      skip(true);
      return exponent();
    }
    return power();
  }

  QuaternionFunction primary() {
    if (at_ == text_.size()) refuse(at_, "expected a number, t, i, j, k or a bracket, got the end");
    const char c = text_[at_];
    if (is_digit(c) || (c == '.' && at_ + 1 < text_.size() && is_digit(text_[at_ + 1]))) {
      return number();
    }
    if (c == '(') return bracket(')');
    if (c == '[') return bracket(']');
    if (c == '{') return bracket('}');
    const std::size_t begin = at_;
    const std::string name = word();
    if (name.empty()) {
      refuse(at_, "expected a number, t, i, j, k or a bracket, got " + shown(at_));
    }
    if (const TextDefinition* known = find(name)) {
      const Size size = size_of(known->value);
      charge(size.length * size.words(), begin);
      return known->value;
    }
    if (!std::all_of(name.begin(), name.end(), is_unit_or_variable)) {
      constexpr std::size_t longest = 40;
      refuse(begin, "the name '" + name.substr(0, longest) +
                        "' is not known here; there are t, i, j, k and what was defined before");
    }
    at_ = begin + 1;  // the letters that follow are factors of their own
    const RationalPolynomial one(1);
    switch (c) {
      case 'i':
        return {{{}, one, {}, {}}, 1};
      case 'j':
        return {{{}, {}, one, {}}, 1};
      case 'k':
        return {{{}, {}, {}, one}, 1};
      default:
        return real(RationalPolynomial::monomial(1, 1));
    }
  }

  QuaternionFunction number() {
    const std::size_t begin = at_;
    std::size_t digits = 0;
    const auto read = [&] {
      std::string result;
      for (; at_ < text_.size() && is_digit(text_[at_]); ++at_) {
        if (++digits <= most_text_digits) result += text_[at_];
      }
      return result;
    };
    std::string whole = read(), decimals;
    if (at_ < text_.size() && text_[at_] == '.') {
      ++at_;
      decimals = read();
    }
    if (digits > most_text_digits) {
      refuse_size(begin, "a number whose digits are", digits, most_text_digits);
    }
    if (whole.empty()) whole = "0";
    Rational value = Rational::parse(decimals.empty() ? whole : whole + "." + decimals).value();
    // 1.5e-3: a letter e with digits after it.
    std::size_t next = at_;
    if (next < text_.size() && (text_[next] == 'e' || text_[next] == 'E')) {
      ++next;
      const bool negative = next < text_.size() && text_[next] == '-';
      if (negative || (next < text_.size() && text_[next] == '+')) ++next;
      if (next < text_.size() && is_digit(text_[next])) {
        std::size_t size = 0;
        for (; next < text_.size() && is_digit(text_[next]); ++next) {
          constexpr std::size_t most_shown = 1'000'000'000'000;
          size = std::min(10 * size + static_cast<std::size_t>(text_[next] - '0'), most_shown);
        }
        if (size > largest_decimal_exponent) {
          refuse_size(at_, "the exponent of ten is", size, largest_decimal_exponent);
        }
        Rational ten(1);
        for (std::size_t n = 0; n < size; ++n) ten *= Rational(10);
        value = negative ? value / ten : value * ten;
        at_ = next;
      }
    }
    return checked(real(value), begin);
  }

  QuaternionFunction bracket(char closing) {
    const std::size_t begin = at_;
    const Level level(*this);
    ++open_;
    std::vector<QuaternionFunction> items;
    do {
      ++at_;  // the bracket, or a comma
      skip(true);
      items.push_back(sum());
      skip(true);
    } while (at_ < text_.size() && text_[at_] == ',');
    if (at_ == text_.size() || text_[at_] != closing) {
      const TextPlace opened = place_in(text_, begin);
      refuse(at_, "expected '" + std::string(1, closing) + "' for the bracket in line " +
                      std::to_string(opened.line) + ", column " + std::to_string(opened.column) +
                      ", got " + shown(at_));
    }
    ++at_;
    --open_;
    if (items.size() == 1) return std::move(items[0]);
    if (items.size() != 3 && items.size() != 4) {
      refuse(begin, "a list has three items (x, y, z) or four (w, x, y, z); got " +
                        std::to_string(items.size()));
    }
    QuaternionFunction result;
    const RationalPolynomial one(1);
    for (std::size_t c = 0; c < items.size(); ++c) {
      if (!is_real(items[c])) refuse(begin, "the items of a list are real");
      const std::size_t unit = items.size() == 4 ? c : c + 1;
      QuaternionFunction item{{}, items[c].denominator};
      item.numerator[unit] = items[c].numerator.w;
      result = added(result, item, begin);
    }
    return result;
  }

  // ---- arithmetic, with its cost
  // -----------------------------------------------------------------

  void charge(std::uint64_t work, std::size_t place) {
    work_ += work;
    if (work_ > most_work) {
      refuse(place,
             "the text asks for more work than is offered here; right would be smaller "
             "numbers and degrees",
             FaultCode::unsupported);
    }
  }
  QuaternionFunction checked(QuaternionFunction value, std::size_t place) const {
    const Size size = size_of(value);
    if (size.length > largest_text_degree + 1) {
      refuse_size(place, "the degree becomes", size.length - 1, largest_text_degree);
    }
    if (size.bits > largest_text_bits) {
      refuse_size(place, "the bits of a number become", size.bits, largest_text_bits);
    }
    return value;
  }
  /// In lowest terms.
  QuaternionFunction lowest(QuaternionFunction value, std::size_t place) {
    if (!value.denominator.is_constant()) {
      const Size above = size_of(value);
      Size below;
      below.include(value.denominator);
      charge(std::uint64_t{above.length} * below.length * above.words(), place);
      const RationalPolynomial common = gcd(content(value.numerator), value.denominator);
      if (!common.is_one()) {
        value.numerator = divided(value.numerator, common);
        value.denominator = value.denominator / common;
      }
    }
    if (!value.denominator.is_zero() && value.denominator.leading() != Rational(1)) {
      const RationalPolynomial scale(Rational(1) / value.denominator.leading());
      value.numerator = scale * value.numerator;
      value.denominator = value.denominator.monic();
    }
    return checked(std::move(value), place);
  }
  static QuaternionFunction negated(QuaternionFunction value) {
    value.numerator = -value.numerator;
    return value;
  }
  QuaternionFunction added(const QuaternionFunction& a, const QuaternionFunction& b,
                           std::size_t place) {
    const Size size_a = size_of(a), size_b = size_of(b);
    charge((size_a.length + size_b.length) * (size_a.words() + size_b.words()), place);
    if (a.denominator == b.denominator) {
      return lowest({a.numerator + b.numerator, a.denominator}, place);
    }
    require_small(size_a, size_b, place);
    return lowest(
        {b.denominator * a.numerator + a.denominator * b.numerator, a.denominator * b.denominator},
        place);
  }
  QuaternionFunction multiplied(const QuaternionFunction& a, const QuaternionFunction& b,
                                std::size_t place) {
    const Size size_a = size_of(a), size_b = size_of(b);
    require_small(size_a, size_b, place);
    return lowest({a.numerator * b.numerator, a.denominator * b.denominator}, place);
  }
  /// Refuses a product of too large a degree before it is made, and counts its cost.
  void require_small(const Size& a, const Size& b, std::size_t place) {
    const std::size_t length = a.length + b.length - 1;
    if (length > largest_text_degree + 1) {
      refuse_size(place, "the degree becomes", length - 1, largest_text_degree);
    }
    constexpr std::uint64_t products = 16;  // of components of quaternions
    charge(products * (std::uint64_t{a.length} * b.words() + std::uint64_t{b.length} * a.words() +
                       length * (a.words() + b.words())),
           place);
  }
  QuaternionFunction raised(const QuaternionFunction& base, const QuaternionFunction& by,
                            std::size_t place) {
    if (!is_number(by) || !by.numerator.w.coefficient(0).is_integer()) {
      refuse(place, "an exponent is a whole number");
    }
    const Rational k = by.numerator.w.coefficient(0);
    const bool negative = k.sign() < 0;
    const Rational size = negative ? -k : k;
    if (size > Rational(static_cast<std::int64_t>(largest_text_exponent))) {
      const std::string digits = hodograph::to_text(k);
      constexpr std::size_t longest = 40;
      refuse(place,
             "the exponent " +
                 (digits.size() > longest ? "of " + std::to_string(digits.size()) + " digits"
                                          : digits) +
                 " is beyond " + std::to_string(largest_text_exponent),
             FaultCode::unsupported);
    }
    QuaternionFunction value = base;
    if (negative) {
      if (!is_real(base)) refuse(place, "a negative power needs a real base");
      if (is_zero(base)) refuse(place, "a negative power of zero");
      value = lowest({{base.denominator, {}, {}, {}}, base.numerator.w}, place);
    }
    auto n = static_cast<unsigned>(fmpz_get_ui(&raw(size)->num));
    const Size one = size_of(value);
    if ((one.length - 1) * n > largest_text_degree) {
      refuse_size(place, "the degree becomes", (one.length - 1) * n, largest_text_degree);
    }
    if (one.bits > 1 && one.bits * n > 2 * largest_text_bits) {
      refuse_size(place, "the bits of a number become about", one.bits * n, largest_text_bits);
    }
    // Powers of quaternions have no short cut: their work grows with both.
    if (!is_real(base) && (one.length - 1) * n > largest_power_work / (one.bits * n)) {
      refuse_size(place, "degree times bits of the power becomes",
                  (one.length - 1) * n * one.bits * n, largest_power_work);
    }
    QuaternionFunction result = real(1);
    for (; n > 0; n >>= 1U) {
      if ((n & 1U) != 0) result = multiplied(result, value, place);
      if (n > 1) value = multiplied(value, value, place);
    }
    return result;
  }

  std::string_view text_;
  std::size_t at_ = 0, depth_ = 0, open_ = 0;
  std::uint64_t work_ = 0;
  std::vector<TextDefinition> definitions_;
};

}  // namespace

Result<std::vector<TextDefinition>> parse_definitions(std::string_view text) {
  try {
    return Parser(text).definitions();
  } catch (const Error& error) {
    return error.fault();
  }
}
Result<QuaternionFunction> parse_expression(std::string_view text) {
  try {
    return Parser(text).expression();
  } catch (const Error& error) {
    return error.fault();
  }
}

}  // namespace hodograph
