// SPDX-License-Identifier: MIT
// The making of paths, compiled once for every degree an AnyPath holds.
#include "hodograph/path/path.hpp"

#include <string>

namespace hodograph {

void path_detail::throw_outside(double x, double low, double high, const char* quantity) {
  throw Error(Fault{FaultCode::outside_domain,
                    std::string(quantity) + " " + to_text(x) + " is outside [" + to_text(low) +
                        ", " + to_text(high) + "]",
                    std::nullopt, quantity, x, x < low ? low : high});
}

HODOGRAPH_FOR_COMPILED_DEGREES(HODOGRAPH_COMPILED_PATH, )

}  // namespace hodograph
