// SPDX-License-Identifier: MIT
// Every reason for failure, in one place: what was wrong, where, and what would be right.
#pragma once

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace hodograph {

/// Why something could not be done. The first group is bad input, the second a well-posed request
/// that has no answer.
enum class FaultCode {
  // bad input
  not_finite,          ///< a number is infinite or not a number
  too_few,             ///< fewer items than the construction needs
  not_increasing,      ///< knots or parameters that should increase strictly
  outside_domain,      ///< a value outside the range where the function is defined
  zero_speed,          ///< derivative data whose velocity vanishes
  not_continuous,      ///< pieces that should meet and do not
  mismatched_size,     ///< two lists that should have the same length
  malformed_document,  ///< a file or request that cannot be read
  unsupported,         ///< well formed, but not offered
  broken_promise,      ///< a document whose numbers contradict what it states
  not_written,         ///< a file that could not be written
  // no solution
  no_interpolant,         ///< Hermite data that this construction cannot join
  tolerance_not_reached,  ///< a fit that would need more segments than allowed
  no_convergence,         ///< an iteration that did not settle
  no_route,               ///< start and goal that nothing allowed joins
  not_separated,          ///< vehicles that nothing within the search keeps apart
  cancelled,              ///< stopped on request
};

/// The stable snake_case name of a code, as it stands in files and messages.
std::string_view name_of(FaultCode code);

/// True for the codes of a well-posed request without an answer (the program exits 3 for them,
/// 2 for the others).
bool is_no_solution(FaultCode code);

/// One failure. `sentence` is complete in itself; the other members repeat its parts for programs.
struct Fault {
  FaultCode code{};
  std::string sentence;                ///< what was wrong and what would be right
  std::optional<std::size_t> index{};  ///< which item of the input, counted from 0
  std::string quantity{};              ///< the name of the offending quantity
  std::optional<double> value{};       ///< what it was
  std::optional<double> bound{};       ///< the limit it violates
};

/// A Fault as an exception, for those who prefer them; what() is the fault's sentence.
class Error : public std::runtime_error {
 public:
  explicit Error(Fault fault);
  const Fault& fault() const noexcept { return fault_; }

 private:
  Fault fault_;
};

/// A number as it appears in sentences: shortest decimal that reads back to the same double.
std::string to_text(double value);

}  // namespace hodograph
