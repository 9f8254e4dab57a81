// SPDX-License-Identifier: MIT
// Curves typed as text: "cos(9*t), sin(9*t), t/2" becomes a curve whose value can be taken for any
// scalar, so that it is differentiated and enclosed like a curve written in C++.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/result.hpp"

namespace hodograph::cli {

enum class Operation : std::uint8_t {
  number,
  parameter,  // push
  negate,
  add,
  subtract,
  multiply,
  divide,
  power,
  whole_power,  // a^b = exp(b log a); a^k for a whole number k
  sqrt,
  exp,
  log,
  sin,
  cos,
  tan,
  asin,
  acos,
  atan,
  sinh,
  cosh,
  tanh,
  abs,
  atan2,
};

struct Instruction {
  Operation operation{};
  double number{};
  int exponent{};
};

/// Three formulas in one parameter, compiled for a stack machine.
///
/// Grammar: + - * / ^ (right to left, binding tighter than a sign in front), brackets, numbers, pi
/// and e, the parameter t (also written xi), and the functions sqrt exp log sin cos tan asin acos
/// atan atan2 sinh cosh tanh abs. Three formulas are separated by commas; two stand for z = 0.
/// Every number is the double nearest to it, pi and e too: the curve is the one that those define.
class Formula {
 public:
  /// Faults: malformed_document; index is the place of the character that cannot be read, counted
  /// from 0, and the sentence names it.
  static Result<Formula> parse(std::string_view text);

  const std::string& text() const { return *text_; }

  /// The point at t.
  template <class S>
  Vector3<S> operator()(const S& t) const {
    return {value(0, t), value(1, t), value(2, t)};
  }

 private:
  using Program = std::vector<Instruction>;
  Formula() = default;

  template <class S>
  S value(std::size_t component, const S& t) const {
    return run<S>(*programs_, (*starts_)[component], (*starts_)[component + 1], t);
  }
  template <class S>
  static S run(const Program& program, std::size_t first, std::size_t last, const S& t);

  std::shared_ptr<const std::string> text_;
  std::shared_ptr<const Program> programs_;  // of all components, one after the other
  std::shared_ptr<const std::vector<std::size_t>> starts_;  // where each begins, and the end
};

// ------------------------------------------------------------------------------------------------

template <class S>
S Formula::run(const Program& program, std::size_t first, std::size_t last, const S& t) {
  using std::abs, std::acos, std::asin, std::atan, std::atan2, std::cos, std::cosh, std::exp;
  using std::log, std::pow, std::sin, std::sinh, std::sqrt, std::tan, std::tanh;
  std::vector<S> stack;
  constexpr std::size_t usual_depth = 8;
  stack.reserve(usual_depth);
  const auto take = [&stack] {
    S top = std::move(stack.back());
    stack.pop_back();
    return top;
  };
  for (std::size_t i = first; i < last; ++i) {
    const Instruction& step = program[i];
    if (step.operation == Operation::number) {
      stack.push_back(S(step.number));
      continue;
    }
    if (step.operation == Operation::parameter) {
      stack.push_back(t);
      continue;
    }
    S a = take();
    switch (step.operation) {
      case Operation::add:
        stack.back() = stack.back() + a;
        break;
      case Operation::subtract:
        stack.back() = stack.back() - a;
        break;
      case Operation::multiply:
        stack.back() = stack.back() * a;
        break;
      case Operation::divide:
        stack.back() = stack.back() / a;
        break;
      case Operation::power:
        stack.back() = exp(a * log(stack.back()));
        break;
      case Operation::atan2:
        stack.back() = atan2(stack.back(), a);
        break;
      case Operation::negate:
        stack.push_back(-a);
        break;
      case Operation::whole_power: {
        S power(1.0);  // by squaring
        for (unsigned k = static_cast<unsigned>(step.exponent < 0 ? -step.exponent : step.exponent);
             k > 0; k >>= 1U) {
          if ((k & 1U) != 0) power = power * a;
          if (k > 1) a = a * a;
        }
        stack.push_back(step.exponent < 0 ? S(1.0) / power : power);
        break;
      }
      case Operation::sqrt:
        stack.push_back(sqrt(a));
        break;
      case Operation::exp:
        stack.push_back(exp(a));
        break;
      case Operation::log:
        stack.push_back(log(a));
        break;
      case Operation::sin:
        stack.push_back(sin(a));
        break;
      case Operation::cos:
        stack.push_back(cos(a));
        break;
      case Operation::tan:
        stack.push_back(tan(a));
        break;
      case Operation::asin:
        stack.push_back(asin(a));
        break;
      case Operation::acos:
        stack.push_back(acos(a));
        break;
      case Operation::atan:
        stack.push_back(atan(a));
        break;
      case Operation::sinh:
        stack.push_back(sinh(a));
        break;
      case Operation::cosh:
        stack.push_back(cosh(a));
        break;
      case Operation::tanh:
        stack.push_back(tanh(a));
        break;
      case Operation::abs:
        stack.push_back(abs(a));
        break;
      case Operation::number:
      case Operation::parameter:
        break;
    }
  }
  return take();
}

}  // namespace hodograph::cli
