// SPDX-License-Identifier: MIT
// Failure is a value: what a construction from data returns.
#pragma once

#include <type_traits>
#include <utility>
#include <variant>

#include "hodograph/foundation/fault.hpp"

namespace hodograph {

/// A value of type T, or the Fault that explains why there is none.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : content_(std::in_place_index<0>, std::move(value)) {}
  /// A value made in place from the arguments of one of its constructors.
  template <class... Arguments>
  explicit Result(std::in_place_t, Arguments&&... arguments)
      : content_(std::in_place_index<0>, std::forward<Arguments>(arguments)...) {}
  Result(Fault fault) : content_(std::in_place_index<1>, std::move(fault)) {}

  bool has_value() const noexcept { return content_.index() == 0; }
  explicit operator bool() const noexcept { return has_value(); }

  /// The value; throws Error with the fault's sentence when there is none.
  const T& value() const& {
    require_value();
    return std::get<0>(content_);
  }
  T value() && {
    require_value();
    return std::get<0>(std::move(content_));
  }

  /// The value, known to be there (contract).
  const T& operator*() const& { return *std::get_if<0>(&content_); }
  T& operator*() & { return *std::get_if<0>(&content_); }
  T&& operator*() && { return std::move(*std::get_if<0>(&content_)); }
  const T* operator->() const { return std::get_if<0>(&content_); }
  T* operator->() { return std::get_if<0>(&content_); }

  /// The fault, known to be there (contract).
  const Fault& fault() const { return *std::get_if<1>(&content_); }

 private:
  void require_value() const {
    if (!has_value()) throw Error(fault());
  }
  std::variant<T, Fault> content_;
};

}  // namespace hodograph
