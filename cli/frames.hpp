// SPDX-License-Identifier: MIT
// An adapted frame as it is asked for, made, and told: what `hodograph frame` and the request
// "frame" have in common.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "hodograph/frame/rolled_state.hpp"
#include "hodograph/frame/twist.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/svg.hpp"

namespace hodograph::cli {

/// The words for the kinds of frames, and for a γ that is found.
inline constexpr std::array<const char*, 5> frame_kinds = {"erf", "frenet", "rotation-minimising",
                                                           "periodic", "least-twist"};
inline constexpr std::array<const char*, 3> found_gammas = {"least", "smooth-negative",
                                                            "smooth-positive"};

struct FrameRequest {
  std::string kind = frame_kinds[2];
  std::optional<double> gamma{};  ///< of a periodic frame
  std::string found_gamma{};      ///< one of found_gammas, where no γ is given; empty: least
  /// Where e₂ points at the start (rotation-minimising, least-twist): an angle from the ERF, or a
  /// direction; and at the end (least-twist on an open path).
  std::optional<double> begin{}, end{};
  std::optional<Vector3<double>> begin_normal{}, end_normal{};
};

struct MadeFrame {
  PreimageTable table;
  FrameRoll roll;
  FrameTwist twist;      ///< of this frame
  FrameTwist erf_twist;  ///< of the Euler-Rodrigues frame
};

/// Throws Error.
MadeFrame make_frame(const PathDocument& document, const FrameRequest& request);

/// A γ as text: a number, or one of found_gammas. Throws Error.
void set_gamma(FrameRequest& request, const std::string& text);

/// Kind, γ and ψ, twist, inflections, rounding of the angle, how it was found.
Json json_of(const MadeFrame& frame, const FrameRequest& request);
/// The same as rows of the table: name and text.
std::vector<std::pair<std::string, std::string>> rows_of(const MadeFrame& frame,
                                                         const FrameRequest& request);

/// One frame along the path.
struct FramePlace {
  double xi = 0.0, arc_length = 0.0;
  Vector3<double> position{};
  RolledState state;
};
std::vector<FramePlace> places_of(const MadeFrame& frame, const AnyPath& path,
                                  const std::vector<double>& xi);
/// The names of the columns of a table of frames, and a row of it.
std::vector<std::string> frame_columns();
std::vector<double> row_of(const FramePlace& place);
Json json_of(const FramePlace& place);

/// The path with frames, and the roll, the rotation about the tangent (beside that of the ERF) and
/// the bending along ξ.
struct FramePictures {
  FramedPolyline path;
  std::vector<Plot> plots;
};
FramePictures pictures_of(const MadeFrame& frame, const PathDocument& document);

}  // namespace hodograph::cli
