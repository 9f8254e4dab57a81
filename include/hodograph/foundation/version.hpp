// SPDX-License-Identifier: MIT
// The version of the library: CMake, the program and the documents read it here.
#pragma once

#define HODOGRAPH_VERSION_MAJOR 0
#define HODOGRAPH_VERSION_MINOR 1
#define HODOGRAPH_VERSION_PATCH 0
#define HODOGRAPH_VERSION_STRING "0.1.0"

namespace hodograph {

/// The library's version as "major.minor.patch".
inline constexpr const char* version = HODOGRAPH_VERSION_STRING;

}  // namespace hodograph
