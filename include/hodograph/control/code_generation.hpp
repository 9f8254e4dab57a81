// SPDX-License-Identifier: MIT
// One path as C99 source text, for programs and solvers that do not link this library.
#pragma once

#include <string>

#include "hodograph/foundation/result.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

struct CodeOptions {
  /// What every name begins with, and the files are called: a C identifier of at most
  /// most_name_letters letters that is no word of C or C++ and has no leading underscore.
  std::string name = "path";
  /// Also the external functions `name`, `jac_name` and `jac_jac_name` that CasADi looks for.
  bool casadi = false;
};

inline constexpr std::size_t most_name_letters = 63;  ///< of the name itself

/// A header and a source file; the source includes the header by name.
struct GeneratedCode {
  std::string header_name, header, source_name, source;
};

/// C99 functions of ξ for one path, whose values are those of the library bit for bit where the
/// compiler keeps to double precision and contracts nothing (cc -std=c99 or -ffp-contract=off):
///
///   int name_position(xi, order, result)    r, r', ..., r^(order)        order ≤ 4
///   int name_arc_length(xi, order, result)  s, σ, σ', ...                order ≤ 4
///   int name_speed(xi, order, result)       σ, σ', ...                   order ≤ 3
///   int name_frame(xi, order, result)       R = [e₁ e₂ e₃], R', ...      order ≤ 3
///   int name_body_rate, name_world_rate     χ, ω per unit ξ, χ', ...     order ≤ 2
///   int name_curvature(xi, order, result)   κ, κ', κ''                   order ≤ 2
///
/// Each writes order + 1 values one after the other (a vector as its components, a frame axis after
/// axis) and returns 0; or it writes nothing and returns 1 (ξ outside the knots or not a number), 2
/// (the speed is zero: no frame, rate or curvature), 3 (derivatives of the curvature of a space
/// curve where it is zero) or 4 (an order that is not offered). In the plane a rate is one number
/// and there is no name_world_rate. Nothing is allocated, and all data are constant.
///
/// The values are those of path.position_derivatives<order>, speed_derivatives,
/// euler_rodrigues_frame_derivatives, body_rate_per_xi, world_rate_per_xi and
/// curvature_derivatives of the preimage_jet with just the derivatives that are needed.
///
/// For CasADi, `name` has the input xi and the outputs position, frame, body_rate, (world_rate,)
/// speed, curvature and arc_length; jac_name and jac_jac_name their first and second derivatives
/// as CasADi 3.6 and later name and order them. They return 1 where a requested value does not
/// exist, ξ outside the knots included; nothing is extrapolated.
///
/// Cost: a few hundred nanoseconds a call. Size: about 25 letters a coefficient.
/// Faults: unsupported (the name).
Result<GeneratedCode> generate_code(const AnyPath& path, const CodeOptions& options);

}  // namespace hodograph
