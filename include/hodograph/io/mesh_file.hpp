// SPDX-License-Identifier: MIT
// Triangle meshes as files: binary STL, OBJ, and binary glTF (.glb), the last two with normals.
//
// STL and glTF hold coordinates in single precision: single_precision_error (triangle_mesh.hpp)
// says what that costs; glTF's are relative to the middle of the mesh where that is far from the
// origin, with a translation of the node. OBJ holds the shortest decimals that read back to the
// same doubles.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "hodograph/foundation/result.hpp"
#include "hodograph/surface/triangle_mesh.hpp"

namespace hodograph {

enum class MeshFormat { stl, obj, glb };

/// Where the bytes of a file go, part by part.
using ByteSink = std::function<void(std::string_view)>;

/// Binary STL: an 80-byte header that holds `name` (and does not begin with "solid"), the number of
/// triangles, and for each its normal, from its corners, and the corners. Vertices are not shared;
/// equal corners have equal bytes, so that readers can join them.
void write_stl(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink);
/// Wavefront OBJ: v lines for positions, vn lines for normals (6 digits), f lines with both.
void write_obj(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink);
/// Binary glTF 2.0: one mesh of one primitive with POSITION, NORMAL and 32-bit indices; no
/// material, so that viewers take their own. Axes are those of the path (a viewer shows y upwards).
/// Domain: at most 4 GiB, about 10^8 vertices.
void write_glb(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink);

/// The format that the suffix of a file name tells: .stl, .obj, .glb, in small letters or capitals.
std::optional<MeshFormat> mesh_format_of(const std::string& file_name);

/// The bytes of such a file. Returns the fault, with nothing written: unsupported where a glTF
/// would be larger than 4 GiB, outside_domain where a coordinate is beyond single precision (STL,
/// glTF).
std::optional<Fault> write_mesh(const TriangleMesh& mesh, MeshFormat format,
                                const std::string& name, const ByteSink& sink);
/// The file in one step (see OutputFile). Returns the fault if that failed: not_written, or
/// write_mesh's.
std::optional<Fault> save_mesh(const TriangleMesh& mesh, MeshFormat format, const std::string& name,
                               const std::string& path);

/// How far the positions of the file may be from those of the mesh: 0 for OBJ.
double rounding_of(const TriangleMesh& mesh, MeshFormat format);

}  // namespace hodograph
