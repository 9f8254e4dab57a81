// SPDX-License-Identifier: MIT
// Surfaces swept along a path: from the request to mesh, facts and files. What the subcommand
// `sweep` and the request "sweep" have in common.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "cli/step_module/step_module.hpp"
#include "hodograph/io/document.hpp"
#include "hodograph/io/report.hpp"
#include "hodograph/surface/sweep_mesh.hpp"

namespace hodograph::cli {

/// The words for frames, as options and requests spell them; the first takes closing on a closed
/// path and erf on an open one. The others but closing are those of the subcommand `frame`.
inline constexpr const char* sweep_frames[] = {
    "automatic", "erf", "closing", "frenet", "rotation-minimising", "periodic", "least-twist"};

/// What is to be swept. One of the profiles is given.
struct SweepRequest {
  std::optional<double> circle{};
  std::vector<double> ellipse{};    ///< two half axes
  std::vector<double> rectangle{};  ///< width along e₂, height along e₃, about the path
  std::vector<double> ribbon{};     ///< distances to the left and to the right
  std::vector<Vector2<double>> polygon{};
  std::optional<AnyPath> curve{};  ///< a planar path

  /// Instead of a profile, a tubular family: the path itself, turned by the quaternion with these
  /// Bernstein coefficients and carried along the polynomial with these, scaled by `scale`.
  std::vector<Vector3<double>> along{};
  std::vector<Quaternion<double>> turn{};
  bool is_family() const { return !along.empty() || !turn.empty(); }

  std::string frame = "automatic";
  std::optional<double> gamma{};  ///< of a periodic frame
  std::string found_gamma{};      ///< one of found_gammas, where no γ is given; empty: least
  std::vector<double> scale{1.0};
  std::optional<double> tolerance{};  ///< a hundredth of the profile's extent without
  std::size_t most_triangles = SweepMeshOptions{}.most_triangles;
  bool caps = true, allow_contact = false;
};

struct MadeSweep {
  Sweep sweep;
  std::string frame;  ///< the one taken; empty: a tubular family
  std::optional<double> gamma{};
  TubeRadius tube;  ///< means nothing for a family
  bool certainly_free = false;
  /// Where contact is not excluded: two parameters next to which sections may meet.
  std::optional<std::array<double, 2>> may_meet{};
  bool in_tube = false;      ///< because it stays within the tube's radius
  double free_factor = 1.0;  ///< where it is not certain: the profile's, for which it would be
  double tolerance = 0.0;
};

/// The sweep, refused where it meets itself unless that is allowed. Throws Error: those of the
/// profile, the motion, contact_fault.
MadeSweep made_sweep(const AnyPath& path, const SweepRequest& request);

/// The track of the point `left` along e₂ and `up` along e₃ of the request's frame, its profile
/// left aside. Throws Error: those of the motion, and of frames that are not rational.
struct MadeTrack {
  std::vector<SpatialRationalBezier> curves;
  std::string frame;
};
MadeTrack made_track(const AnyPath& path, const SweepRequest& request, double left, double up);
Json json_of(const MadeTrack& track);
/// xi, x, y, z of so many points of each curve, ends included.
std::string csv_of(const MadeTrack& track, std::size_t per_curve);

/// The certified largest radius of a tube round a path of any kind.
TubeRadius tube_radius_of(const AnyPath& path);

/// The format of a file: `format` where it is not empty, else by the suffix: "stl", "obj", "glb" or
/// "step" (also .stp). Throws Error (unsupported).
std::string sweep_format(const std::string& file, const std::string& format);

/// The mesh with its facts, within the tolerance also after the rounding of the format ("stl", ...;
/// empty: none). Throws Error: those of mesh_of; tolerance_not_reached where the rounding alone
/// takes half of the tolerance.
struct MeasuredMesh {
  SweepMesh made;
  MeshFacts facts;
  double rounding = 0.0;  ///< of the coordinates in the file
};
MeasuredMesh measured_mesh(const MadeSweep& made, const SweepRequest& request,
                           const std::string& format);

/// Writes the file; `mesh` is not needed for STEP, for which the answer tells what it holds. Throws
/// Error.
std::optional<StepAnswer> write_sweep(const MadeSweep& made, const SweepRequest& request,
                                      const MeasuredMesh* mesh, const PathDocument& document,
                                      const std::string& file, const std::string& format);

Json json_of(const MadeSweep& made, const MeasuredMesh& mesh);
std::vector<std::pair<std::string, std::string>> rows_of(const MadeSweep& made,
                                                         const MeasuredMesh* mesh,
                                                         const std::string& unit);

/// The report: the path's size, the rows, and, `drawn`, the surface from two sides by a mesh coarse
/// enough for it.
ReportData report_of(const MadeSweep& made, const SweepRequest& request,
                     const PathDocument& document,
                     std::vector<std::pair<std::string, std::string>> rows, bool drawn);

}  // namespace hodograph::cli
