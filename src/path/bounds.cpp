// SPDX-License-Identifier: MIT
// The bounds of paths, compiled once for every degree an AnyPath holds.
#include "hodograph/path/bounds.hpp"

namespace hodograph {

HODOGRAPH_FOR_COMPILED_DEGREES(HODOGRAPH_COMPILED_BOUNDS, )

}  // namespace hodograph
