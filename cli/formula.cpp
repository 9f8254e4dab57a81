// SPDX-License-Identifier: MIT
// Recursive descent over the text of a formula.
#include "cli/formula.hpp"

#include <array>
#include <charconv>
#include <numbers>
#include <optional>
#include <utility>

namespace hodograph::cli {
namespace {

constexpr std::size_t longest_formula = 20000;  // characters
constexpr int deepest_nesting = 200;            // brackets, signs and powers inside each other
constexpr double largest_exponent = 1024;       // of a power computed by multiplication

struct Function {
  std::string_view name;
  Operation operation;
};
constexpr std::array functions = {
    Function{"sqrt", Operation::sqrt}, Function{"exp", Operation::exp},
    Function{"log", Operation::log},   Function{"sin", Operation::sin},
    Function{"cos", Operation::cos},   Function{"tan", Operation::tan},
    Function{"asin", Operation::asin}, Function{"acos", Operation::acos},
    Function{"atan", Operation::atan}, Function{"sinh", Operation::sinh},
    Function{"cosh", Operation::cosh}, Function{"tanh", Operation::tanh},
    Function{"abs", Operation::abs},   Function{"atan2", Operation::atan2},
};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// The text on one line, without control characters.
std::string shown(std::string_view text) {
  constexpr std::size_t longest = 200;
  std::string out;
  for (const char c : text.substr(0, longest)) {
    out += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? '?' : c;
  }
  return text.size() > longest ? out + "..." : out;
}

class Parser {
 public:
  Parser(std::string_view text, std::vector<Instruction>& program)
      : text_(text), program_(program) {}

  /// One component, up to a comma or the end.
  bool component() { return sum(0); }

  bool at_end() {
    skip_blanks();
    return position_ == text_.size();
  }
  bool accept(char c) {
    skip_blanks();
    if (position_ >= text_.size() || text_[position_] != c) return false;
    ++position_;
    return true;
  }
  bool fail(const std::string& what) { return fail_at(position_, what); }
  std::string found() const {
    return position_ < text_.size() ? std::string("'") + shown(text_.substr(position_, 1)) + "'"
                                    : std::string("the end");
  }
  Fault fault() const { return fault_; }

 private:
  bool fail_at(std::size_t place, const std::string& what) {
    fault_ = Fault{
        FaultCode::malformed_document,
        "formula, character " + std::to_string(place + 1) + " of \"" + shown(text_) + "\": " + what,
        place,
        "formula",
        std::nullopt,
        std::nullopt};
    return false;
  }
  void skip_blanks() {
    while (position_ < text_.size() && (text_[position_] == ' ' || text_[position_] == '\t' ||
                                        text_[position_] == '\n' || text_[position_] == '\r')) {
      ++position_;
    }
  }
  void emit(Operation operation, double number = 0.0, int exponent = 0) {
    program_.push_back({operation, number, exponent});
  }

  bool sum(int depth) {
    if (depth > deepest_nesting) {
      return fail("more than " + std::to_string(deepest_nesting) + " levels of brackets and signs");
    }
    if (!term(depth)) return false;
    for (;;) {
      if (accept('+')) {
        if (!term(depth)) return false;
        emit(Operation::add);
      } else if (accept('-')) {
        if (!term(depth)) return false;
        emit(Operation::subtract);
      } else {
        return true;
      }
    }
  }
  bool term(int depth) {
    if (!signed_factor(depth)) return false;
    for (;;) {
      if (accept('*')) {
        if (position_ < text_.size() && text_[position_] == '*') {
          return fail("a power is written ^");
        }
        if (!signed_factor(depth)) return false;
        emit(Operation::multiply);
      } else if (accept('/')) {
        if (!signed_factor(depth)) return false;
        emit(Operation::divide);
      } else {
        return true;
      }
    }
  }
  bool signed_factor(int depth) {
    if (depth > deepest_nesting) {
      return fail("more than " + std::to_string(deepest_nesting) + " levels of brackets and signs");
    }
    if (accept('+')) return signed_factor(depth + 1);
    if (accept('-')) {
      if (!signed_factor(depth + 1)) return false;
      emit(Operation::negate);
      return true;
    }
    return factor(depth);
  }
  bool factor(int depth) {
    if (!primary(depth)) return false;
    if (!accept('^')) return true;
    const std::size_t exponent = program_.size();
    if (!signed_factor(depth + 1)) return false;
    if (const auto whole = whole_number(exponent)) {
      program_.resize(exponent);
      emit(Operation::whole_power, 0.0, *whole);
    } else {
      emit(Operation::power);
    }
    return true;
  }
  /// The exponent just compiled, if it is a whole number made of whole numbers, signs and powers.
  std::optional<int> whole_number(std::size_t first) const {
    if (program_[first].operation != Operation::number) return std::nullopt;
    double value = program_[first].number;
    for (std::size_t i = first + 1; i < program_.size(); ++i) {
      const Instruction& step = program_[i];
      if (step.operation == Operation::negate) {
        value = -value;
      } else if (step.operation == Operation::whole_power && step.exponent >= 0) {
        value = std::pow(value, step.exponent);  // exact below the limit, for whole numbers
      } else {
        return std::nullopt;
      }
      if (value != std::floor(value)) return std::nullopt;
    }
    if (!(std::abs(value) <= largest_exponent) || value != std::floor(value)) return std::nullopt;
    return static_cast<int>(value);
  }
  bool primary(int depth) {
    skip_blanks();
    if (accept('(')) {
      if (!sum(depth + 1)) return false;
      return accept(')') || fail("a ')' is missing; here is " + found());
    }
    if (position_ < text_.size() && (is_digit(text_[position_]) || text_[position_] == '.')) {
      return number();
    }
    if (position_ < text_.size() && is_letter(text_[position_])) return name(depth);
    return fail("a number, t, a function or '(' is needed; here is " + found());
  }
  bool number() {
    double value = 0.0;
    const char* const begin = text_.data() + position_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{}) return fail("this is no number that a double can hold");
    position_ += static_cast<std::size_t>(end - begin);
    emit(Operation::number, value);
    return true;
  }
  bool name(int depth) {
    const std::size_t start = position_;
    while (position_ < text_.size() &&
           (is_letter(text_[position_]) || is_digit(text_[position_]))) {
      ++position_;
    }
    const std::string_view word = text_.substr(start, position_ - start);
    if (word == "t" || word == "xi") return emit(Operation::parameter), true;
    if (word == "pi") return emit(Operation::number, std::numbers::pi), true;
    if (word == "e") return emit(Operation::number, std::numbers::e), true;
    for (const Function& function : functions) {
      if (function.name != word) continue;
      if (!accept('('))
        return fail(std::string("'") + std::string(word) + "' needs a '('; here is " + found());
      if (!sum(depth + 1)) return false;
      if (function.operation == Operation::atan2) {
        if (!accept(',')) return fail("atan2 needs two numbers, atan2(y, x); here is " + found());
        if (!sum(depth + 1)) return false;
      }
      if (!accept(')')) return fail("a ')' is missing; here is " + found());
      emit(function.operation);
      return true;
    }
    return fail_at(start, std::string("'") + shown(word) +
                              "' is unknown; there are t, pi, e, sqrt, exp, log, sin, cos, tan, "
                              "asin, acos, atan, atan2, sinh, cosh, tanh and abs");
  }

  std::string_view text_;
  std::vector<Instruction>& program_;
  std::size_t position_ = 0;
  Fault fault_;
};

}  // namespace

Result<Formula> Formula::parse(std::string_view text) {
  if (text.size() > longest_formula) {
    return Fault{FaultCode::malformed_document,
                 "the formula has " + std::to_string(text.size()) + " characters; at most " +
                     std::to_string(longest_formula) + " are read",
                 std::nullopt,
                 "formula",
                 static_cast<double>(text.size()),
                 static_cast<double>(longest_formula)};
  }
  std::vector<Instruction> program;
  std::vector<std::size_t> starts;
  Parser parser(text, program);
  do {
    starts.push_back(program.size());
    if (!parser.component()) return parser.fault();
    if (starts.size() == 3) break;
  } while (parser.accept(','));
  if (!parser.at_end()) {
    parser.fail(starts.size() == 3
                    ? "the formula should end here, after x, y and z; here is " + parser.found()
                    : "an operator or a comma is needed; here is " + parser.found());
    return parser.fault();
  }
  if (starts.size() == 1) {
    parser.fail("a curve needs \"x, y, z\" (or \"x, y\"); this is one formula alone");
    return parser.fault();
  }
  if (starts.size() == 2) {
    starts.push_back(program.size());
    program.push_back({Operation::number, 0.0, 0});
  }
  starts.push_back(program.size());

  Formula formula;
  formula.text_ = std::make_shared<const std::string>(text);
  formula.programs_ = std::make_shared<const Program>(std::move(program));
  formula.starts_ = std::make_shared<const std::vector<std::size_t>>(std::move(starts));
  return formula;
}

}  // namespace hodograph::cli
