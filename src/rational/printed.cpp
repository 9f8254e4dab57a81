// SPDX-License-Identifier: MIT
// What values of a text are wanted as, places in it, and values printed.
#include <algorithm>
#include <array>
#include <utility>

#include "flint.hpp"
#include "hodograph/rational/text.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

Fault wrong_value(const std::string& name, const std::string& what) {
  return {FaultCode::malformed_document, name + " " + what, std::nullopt, name};
}

/// A text cut to a length that a sentence bears.
std::string cut(const std::string& text) {
  constexpr std::size_t longest = 80;
  return text.size() <= longest ? text : text.substr(0, longest) + "...";
}

/// The bytes of the UTF-8 character that begins with c (1 for a byte that begins none).
std::size_t character_length(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte >= 0xF0 ? 4 : byte >= 0xE0 ? 3 : byte >= 0xC0 ? 2 : 1;
}
bool is_real(const QuaternionFunction& value) {
  return value.numerator.x.is_zero() && value.numerator.y.is_zero() && value.numerator.z.is_zero();
}

}  // namespace

Result<QuaternionPolynomial> quaternion_polynomial(const QuaternionFunction& value,
                                                   const std::string& name) {
  if (!value.denominator.is_one()) {
    return wrong_value(
        name, "should be a polynomial; it has the denominator " + cut(to_text(value.denominator)));
  }
  return value.numerator;
}
Result<RationalPolynomial> real_polynomial(const QuaternionFunction& value,
                                           const std::string& name) {
  auto function = real_function(value, name);
  if (!function) return function.fault();
  if (!function->is_polynomial()) {
    return wrong_value(
        name, "should be a polynomial; it has the denominator " + cut(to_text(value.denominator)));
  }
  return function->numerator();
}
Result<RationalFunction> real_function(const QuaternionFunction& value, const std::string& name) {
  if (!is_real(value)) {
    return wrong_value(
        name, "should be real; it is " + cut(to_text(value.numerator)) +
                  (value.denominator.is_one() ? "" : " over " + cut(to_text(value.denominator))));
  }
  return RationalFunction(value.numerator.w, value.denominator);
}
Result<VectorFunction> vector_function(const QuaternionFunction& value, const std::string& name) {
  if (!value.numerator.w.is_zero()) {
    return wrong_value(name, "should be a vector (x, y, z); it has the real part " +
                                 cut(to_text(value.numerator.w)));
  }
  return VectorFunction(vector_part(value.numerator), value.denominator);
}
Result<std::size_t> whole_number(const QuaternionFunction& value, const std::string& name,
                                 std::size_t largest) {
  const Rational number = value.numerator.w.coefficient(0);
  if (!is_real(value) || !value.denominator.is_one() || value.numerator.w.degree() > 0 ||
      !number.is_integer() || number.sign() < 0) {
    return wrong_value(name, "should be a whole number; it is " + cut(to_text(value.numerator)));
  }
  if (number > Rational(static_cast<std::int64_t>(largest))) {
    Fault fault = wrong_value(name, "is " + cut(to_text(number)) + "; at most " +
                                        std::to_string(largest) + " is offered");
    fault.code = FaultCode::unsupported;
    fault.bound = static_cast<double>(largest);
    return fault;
  }
  return static_cast<std::size_t>(fmpz_get_ui(&raw(number)->num));
}

TextPlace place_in(std::string_view text, std::size_t index) {
  const auto starts_character = [](char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
  };
  index = std::min(index, text.size());
  while (index > 0 && index < text.size() && !starts_character(text[index])) --index;
  const std::string_view before = text.substr(0, index);
  TextPlace place;
  place.line = 1 + static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  const std::size_t begin =
      before.rfind('\n') == std::string_view::npos ? 0 : before.rfind('\n') + 1;
  place.column =
      1 + static_cast<std::size_t>(std::count_if(
              before.begin() + static_cast<std::ptrdiff_t>(begin), before.end(), starts_character));
  place.text = text.substr(begin, std::min(text.find('\n', begin), text.size()) - begin);
  if (place.text.ends_with('\r')) place.text.pop_back();
  return place;
}

std::string pointed_out(const TextPlace& place) {
  constexpr std::size_t before = 60, longest = 100;  // characters of a line of a terminal
  std::vector<std::string> characters;
  for (std::size_t i = 0; i < place.text.size();) {
    const std::size_t length = std::min(character_length(place.text[i]), place.text.size() - i);
    const bool control = static_cast<unsigned char>(place.text[i]) < 0x20;
    characters.push_back(control ? " " : place.text.substr(i, length));
    i += length;
  }
  const std::size_t caret = std::min(place.column - 1, characters.size());
  const std::size_t from = caret > before ? caret - before : 0;
  std::string line = from > 0 ? "..." : "", pointer(line.size() + (caret - from), ' ');
  for (std::size_t i = from; i < std::min(characters.size(), from + longest); ++i) {
    line += characters[i];
  }
  return line + (characters.size() > from + longest ? "..." : "") + "\n" + pointer + "^\n";
}

std::string to_text(const QuaternionPolynomial& a) {
  constexpr std::array names = {"", "i", "j", "k"};
  std::string text;
  for (int k = degree(a); k >= 0; --k) {
    // The coefficient of t^k: its parts, each with a sign.
    std::vector<std::pair<bool, std::string>> parts;
    for (std::size_t c = 0; c < 4; ++c) {
      const Rational x = a[c].coefficient(static_cast<std::size_t>(k));
      if (x.is_zero()) continue;
      const Rational size = x.sign() < 0 ? -x : x;
      const bool one = size == Rational(1);
      std::string part = one && (c > 0 || k > 0) ? "" : to_text(size);
      if (c > 0) part += (part.empty() ? "" : "*") + std::string(names[c]);
      parts.emplace_back(x.sign() < 0, part);
    }
    if (parts.empty()) continue;
    const bool negative =
        std::all_of(parts.begin(), parts.end(), [](const auto& part) { return part.first; });
    const std::string monomial = k == 0 ? "" : k == 1 ? "t" : "t^" + std::to_string(k);
    const auto put = [&](bool minus, const std::string& term) {
      text += text.empty() ? (minus ? "-" : "") : (minus ? " - " : " + ");
      text += term;
    };
    if (k == 0) {
      for (const auto& [minus, part] : parts) put(minus, part);
    } else if (parts.size() == 1) {
      put(negative, parts[0].second + (parts[0].second.empty() ? "" : "*") + monomial);
    } else {
      std::string sum;
      for (const auto& [minus, part] : parts) {
        const bool shown_minus = minus != negative;
        sum += sum.empty() ? (shown_minus ? "-" : "") : (shown_minus ? " - " : " + ");
        sum += part.empty() ? "1" : part;
      }
      put(negative, std::string("(").append(sum).append(")*").append(monomial));
    }
  }
  return text.empty() ? "0" : text;
}

std::string to_text(const RationalVector& v) {
  return "(" + to_text(v.x) + ", " + to_text(v.y) + ", " + to_text(v.z) + ")";
}
std::string to_text(const VectorPolynomial& v) {
  return "(" + to_text(v.x) + ", " + to_text(v.y) + ", " + to_text(v.z) + ")";
}
std::string to_text(const VectorFunction& r) {
  const std::string numerator = to_text(r.numerator());
  return r.is_polynomial() ? numerator : numerator + "/(" + to_text(r.denominator()) + ")";
}

}  // namespace hodograph
