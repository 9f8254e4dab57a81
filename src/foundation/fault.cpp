// SPDX-License-Identifier: MIT
#include "hodograph/foundation/fault.hpp"

#include <array>
#include <charconv>
#include <utility>

namespace hodograph {

std::string_view name_of(FaultCode code) {
  switch (code) {
    case FaultCode::not_finite:
      return "not_finite";
    case FaultCode::too_few:
      return "too_few";
    case FaultCode::not_increasing:
      return "not_increasing";
    case FaultCode::outside_domain:
      return "outside_domain";
    case FaultCode::zero_speed:
      return "zero_speed";
    case FaultCode::not_continuous:
      return "not_continuous";
    case FaultCode::mismatched_size:
      return "mismatched_size";
    case FaultCode::malformed_document:
      return "malformed_document";
    case FaultCode::unsupported:
      return "unsupported";
    case FaultCode::broken_promise:
      return "broken_promise";
    case FaultCode::not_written:
      return "not_written";
    case FaultCode::no_interpolant:
      return "no_interpolant";
    case FaultCode::tolerance_not_reached:
      return "tolerance_not_reached";
    case FaultCode::no_convergence:
      return "no_convergence";
    case FaultCode::no_route:
      return "no_route";
    case FaultCode::not_separated:
      return "not_separated";
    case FaultCode::cancelled:
      return "cancelled";
  }
  return "unknown";
}

bool is_no_solution(FaultCode code) {
  switch (code) {
    case FaultCode::no_interpolant:
    case FaultCode::tolerance_not_reached:
    case FaultCode::no_convergence:
    case FaultCode::no_route:
    case FaultCode::not_separated:
      return true;
    default:
      return false;
  }
}

Error::Error(Fault fault) : std::runtime_error(fault.sentence), fault_(std::move(fault)) {}

std::string to_text(double value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  return error == std::errc{} ? std::string(buffer.data(), end) : std::string("?");
}

}  // namespace hodograph
