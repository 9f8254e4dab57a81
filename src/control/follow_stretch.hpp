// SPDX-License-Identifier: MIT
// Private to control/: whether a following is well posed, and the stretch of the path it is on.
#pragma once

#include "follow_program.hpp"

namespace hodograph::control_detail {

/// The faults of follow() that do not need the solver.
Result<FollowedStretch> followed_stretch(const AnyPath& path, const FollowLimits& limits,
                                         const FollowStart& start, const FollowOptions& options);

}  // namespace hodograph::control_detail
