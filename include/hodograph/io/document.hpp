// SPDX-License-Identifier: MIT
// The path document: a path, its frame, where it came from and what it promises, as JSON.
//
// Format "hodograph-path", version 1; docs/schema/path-document-1.schema.json describes it. What is
// written reads back bit for bit: numbers are the shortest decimals that round to the same double.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "hodograph/algebra/vector.hpp"
#include "hodograph/foundation/enclosure.hpp"
#include "hodograph/foundation/result.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/path/any_path.hpp"

namespace hodograph {

/// The value of "format" and the newest "version" this library reads and the one it writes.
inline constexpr std::string_view document_format = "hodograph-path";
inline constexpr int document_version = 1;

/// How a path was made; every member free text or absent.
struct Provenance {
  std::string program{};              ///< what wrote the document, with its version
  std::string source{};               ///< the data the path stands for: a file, an orbit, a formula
  std::string method{};               ///< the construction: "C4 Hermite, adaptive knots"
  std::string choice{};               ///< its free parameters: "order ten"
  std::optional<double> tolerance{};  ///< the position error asked for, in units of length

  bool empty() const {
    return program.empty() && source.empty() && method.empty() && choice.empty() && !tolerance;
  }
  friend bool operator==(const Provenance&, const Provenance&) = default;
};

/// The derivatives that are continuous at every knot: C^0 is the value itself, -1 means it jumps.
struct ContinuityOrders {
  int position = 0;
  int preimage = -1;
  int frame = -1;
  int angular_velocity = -1;
  friend bool operator==(const ContinuityOrders&, const ContinuityOrders&) = default;
};

/// The largest distance between the path and what it stands for, at equal parameters, in units of
/// length: certainly inside `distance` where `certified`, else an estimate from samples.
struct ErrorPromise {
  Enclosure distance{};
  bool certified = false;
  std::string against{};  ///< what the path was compared with
  friend bool operator==(const ErrorPromise&, const ErrorPromise&) = default;
};

/// The distance of the whole path from one obstacle of a world, by its number there.
struct ObstacleDistance {
  std::size_t obstacle = 0;
  Enclosure distance{};
  friend bool operator==(const ObstacleDistance&, const ObstacleDistance&) = default;
};

/// How far the path stays from the obstacles of a world; see planning/clearance.hpp.
struct ClearancePromise {
  std::string world{};                        ///< the file that holds the world
  double reach = 0.0;                         ///< everything that is not listed is at least so far
  std::vector<ObstacleDistance> obstacles{};  ///< in ascending order
  std::optional<Enclosure> bounds{};          ///< the distance from the bounds, inside them
  friend bool operator==(const ClearancePromise&, const ClearancePromise&) = default;
};

/// From a segment on, up to the next row's, the sine of the angle at which the path climbs along
/// the axis is in `sine` everywhere.
struct HelixSine {
  std::size_t first_segment = 0;
  Enclosure sine{};
  friend bool operator==(const HelixSine&, const HelixSine&) = default;
};

/// A path of constant climb, or of several angles one after the other; see path/helix.hpp.
struct HelixPromise {
  Vector3<double> axis{0.0, 0.0, 1.0};
  std::vector<HelixSine> sines{};  ///< in ascending order, the first from segment 0 on
  friend bool operator==(const HelixPromise&, const HelixPromise&) = default;
};

/// What a path promises. Each number can be computed again from the path alone, the error from the
/// path and its source, the clearance from the path and the world. Absent means: nothing is
/// promised.
struct Promises {
  std::optional<ContinuityOrders> continuity{};
  std::optional<ErrorPromise> error{};
  std::optional<Enclosure> arc_length{};      ///< of the whole path
  std::optional<Enclosure> smallest_speed{};  ///< contains min σ(ξ)
  std::optional<Enclosure> largest_speed{};   ///< contains max σ(ξ)
  std::optional<double> curvature_bound{};    ///< |κ| ≤ this everywhere
  /// Where the path ends, within accuracy::join_error of the last segment's coordinates; z is 0 in
  /// the plane.
  std::optional<Vector3<double>> end{};
  std::optional<Enclosure> largest_curvature{};  ///< contains max |κ(ξ)|
  std::optional<ClearancePromise> clearance{};
  std::optional<HelixPromise> helix{};

  bool empty() const {
    return !continuity && !error && !arc_length && !smallest_speed && !largest_speed &&
           !curvature_bound && !end && !largest_curvature && !clearance && !helix;
  }
  friend bool operator==(const Promises&, const Promises&) = default;
};

/// A path and all that belongs to it. Texts are UTF-8.
struct PathDocument {
  AnyPath path;
  std::string name{};
  std::string length_unit{};     ///< of positions and arc length: "LU", "m"
  std::string parameter_unit{};  ///< of ξ: "TU", "s"
  std::optional<LinearRoll<double>>
      roll{};  ///< the frame's roll against the ERF (radians), in space
  Provenance provenance{};
  Promises promises{};
};

/// The document as JSON text, one segment a line. Bytes that are not UTF-8 become U+FFFD; a bound
/// that is infinite promises nothing and is left out. Domain: the roll's numbers are finite.
std::string to_json(const PathDocument& document);

/// The document that a text holds; members may stand in any order. Memory: at most a few times that
/// of the path, whatever the text.
///
/// Faults: malformed_document for anything that is not such a document: broken JSON (with line and
/// column), a wrong type, a missing, unknown or repeated member, a wrong number of coefficients, a
/// number beyond the range of double (with the JSON pointer, also in Fault::quantity); unsupported
/// for a newer version or a degree that is too high; and those of AnyPath::create (knots that do
/// not increase, a torn path). Nothing is thrown.
/// `source` is how sentences call the text, for example the file's name.
Result<PathDocument> parse_document(std::string_view text,
                                    const std::string& source = "the document");

/// The same from and to a file ("-": standard input and output; see file.hpp for the faults). The
/// file is replaced in one step.
Result<PathDocument> load_document(const std::string& path);
std::optional<Fault> save_document(const PathDocument& document, const std::string& path);

}  // namespace hodograph
