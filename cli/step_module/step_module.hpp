// SPDX-License-Identifier: MIT
// The program's side and the module's side of writing STEP.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "hodograph/foundation/fault.hpp"
#include "hodograph/surface/sweep.hpp"

namespace hodograph::cli {

struct StepRequest {
  std::string path, name, length_unit;
  bool caps = true;
};
struct StepAnswer {
  std::optional<Fault> fault{};
  std::size_t faces = 0, degree_along = 0, degree_round = 0;
  bool solid = false;
};

/// The module's one function, and its name.
using WriteStep = void (*)(const Sweep&, const StepRequest&, StepAnswer&);
inline constexpr const char* write_step_name = "hodograph_write_step";

/// Loads the module, writes the file, and says what stands in it. Throws Error: unsupported where
/// the program was built without it or it is not where it was installed; the faults of save_step.
StepAnswer write_step(const Sweep& sweep, const StepRequest& request);

}  // namespace hodograph::cli
