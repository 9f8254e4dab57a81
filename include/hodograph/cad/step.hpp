// SPDX-License-Identifier: MIT
// Swept surfaces as STEP: exact rational B-spline surfaces, sewn to a solid where they close. The
// only part of the library that needs OpenCASCADE.
#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "hodograph/foundation/result.hpp"
#include "hodograph/surface/sweep.hpp"

namespace hodograph {

struct StepOptions {
  std::string name{};         ///< of the product
  std::string length_unit{};  ///< "mm", "cm", "m", "km", "in", "ft"; anything else: millimetres
  bool caps = true;           ///< close the ends of an open sweep with plane faces
};

/// What a STEP file holds.
struct StepModel {
  std::string text;       ///< ISO 10303-21, application protocol AP214
  std::size_t faces = 0;  ///< surfaces and caps
  bool solid = false;     ///< one closed solid, oriented outwards; else a shell
  std::size_t degree_along = 0, degree_round = 0;  ///< the largest
};

/// The largest degree of a B-spline surface that OpenCASCADE and the CAD programs on it take.
inline constexpr std::size_t largest_cad_degree = 25;

/// The sweep as a STEP model: each patch of rational_patches one B_SPLINE_SURFACE, its parameters
/// those of the path and the profile, its control points and weights written with 17 digits, so
/// that they read back as the same doubles; edges are the exact curves between patches. The ends
/// of an open sweep of a closed planar profile become plane faces. The numbers stand for the unit
/// named.
///
/// Faults: those of rational_patches; unsupported (a degree above largest_cad_degree: the preimage
/// degree of the path times 4 plus 1, or 4 more on a closed path whose frame is turned to close);
/// not_written (OpenCASCADE could not make or sew the faces, with its reason).
Result<StepModel> step_of(const Sweep& sweep, const StepOptions& options = {});

/// The same into a file ("-": standard output), in one step. Faults: those, and not_written.
Result<StepModel> save_step(const Sweep& sweep, const StepOptions& options,
                            const std::string& path);

}  // namespace hodograph
