// SPDX-License-Identifier: MIT
// The answer to a question that rounding may leave open.
#pragma once

namespace hodograph {

/// yes and no are certain, rounding included.
enum class Answer {
  yes,
  no,
  undecided,  ///< either, within rounding
};

}  // namespace hodograph
