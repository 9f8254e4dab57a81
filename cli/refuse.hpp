// SPDX-License-Identifier: MIT
// How the program refuses what it was given.
#pragma once

#include <string>

#include "hodograph/foundation/fault.hpp"

namespace hodograph::cli {

/// Throws Error with the sentence; the code is that of input in the wrong form unless it is named.
[[noreturn]] inline void refuse(const std::string& sentence, const char* quantity,
                                FaultCode code = FaultCode::malformed_document) {
  throw Error(Fault{code, sentence, std::nullopt, quantity, std::nullopt, std::nullopt});
}

}  // namespace hodograph::cli
