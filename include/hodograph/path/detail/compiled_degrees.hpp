// SPDX-License-Identifier: MIT
// The preimage degrees whose longest templates are compiled once, in the library, for paths in
// double: all that an AnyPath holds. A header ends with the `extern` declarations of its own; one
// source file defines them. Other degrees and scalars are compiled where they are used.
#pragma once

/// line(prefix, n) for every compiled degree n; the prefix is `extern` or empty.
#define HODOGRAPH_FOR_COMPILED_DEGREES(line, prefix)                                              \
  line(prefix, 0) line(prefix, 1) line(prefix, 2) line(prefix, 3) line(prefix, 4) line(prefix, 5) \
      line(prefix, 6) line(prefix, 7) line(prefix, 8) line(prefix, 9) line(prefix, 10)            \
          line(prefix, 11) line(prefix, 12)
