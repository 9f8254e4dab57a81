// SPDX-License-Identifier: MIT
#include "hodograph/io/mesh_file.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "hodograph/foundation/version.hpp"
#include "hodograph/io/file.hpp"
#include "number.hpp"

namespace hodograph {
namespace {

/// Little-endian bytes, handed on in blocks.
class Bytes {
 public:
  explicit Bytes(const ByteSink& sink) : sink_(sink) { buffer_.reserve(block + 64); }
  ~Bytes() { flush(); }
  Bytes(const Bytes&) = delete;
  Bytes& operator=(const Bytes&) = delete;

  void raw(std::string_view text) {
    buffer_ += text;
    if (buffer_.size() >= block) flush();
  }
  template <class Number>
  void number(Number x) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &x, sizeof x);
    if constexpr (std::endian::native == std::endian::big) {
      std::reverse(bytes.begin(), bytes.end());
    }
    raw({bytes.data(), bytes.size()});
  }
  void vector(const Vector3<double>& v) {
    for (std::size_t j = 0; j < 3; ++j) number(static_cast<float>(v[j]));
  }

 private:
  static constexpr std::size_t block = 1 << 16;
  void flush() {
    if (!buffer_.empty()) sink_(buffer_);
    buffer_.clear();
  }
  const ByteSink& sink_;
  std::string buffer_;
};

/// The nearest numbers of single precision. GCC 12 leaves out pairs of such roundings at -O2, which
/// a volatile between them keeps it from.
Vector3<double> rounded(const Vector3<double>& v) {
  const auto single = [](double x) {
    volatile float nearest = static_cast<float>(x);
    return static_cast<double>(nearest);
  };
  return {single(v.x), single(v.y), single(v.z)};
}

/// Text on one line of printable characters.
std::string plain(const std::string& text) {
  std::string result;
  for (const char c : text) result += static_cast<unsigned char>(c) < 0x20 || c == 0x7f ? ' ' : c;
  return result;
}

std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// Where the coordinates of a glTF start: the middle where it is far from the origin, else the
/// origin itself.
Vector3<double> gltf_origin(const TriangleMesh& mesh) {
  const Vector3<double> middle = middle_of(mesh);
  double extent = 0.0;
  for (const auto& p : mesh.positions) extent = std::max(extent, largest_component(p - middle));
  constexpr double far = 4.0;  // two bits of the single precision
  return largest_component(middle) > far * extent ? rounded(middle) : Vector3<double>{};
}

}  // namespace

void write_stl(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink) {
  constexpr std::size_t header_size = 80;
  std::string header = plain("Hodograph " + std::string(version) + " " + name);
  header.resize(header_size, ' ');
  Bytes out(sink);
  out.raw(header);
  out.number(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto &a = mesh.corner(t, 0), &b = mesh.corner(t, 1), &c = mesh.corner(t, 2);
    const Vector3<double> across = cross(b - a, c - a);
    const double size = norm(across);
    out.vector(size > 0.0 ? (1.0 / size) * across : Vector3<double>{});
    out.vector(a);
    out.vector(b);
    out.vector(c);
    out.number(std::uint16_t{0});
  }
}

void write_obj(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink) {
  Bytes out(sink);
  std::string line = "# Hodograph " + std::string(version) + "\no " +
                     (name.empty() ? "sweep" : plain(name)) + "\n";
  out.raw(line);
  const auto triple = [&](const char* key, const Vector3<double>& v) {
    line = key;
    for (std::size_t j = 0; j < 3; ++j) {
      line += ' ';
      io_detail::append_number(line, v[j]);
    }
    line += '\n';
    out.raw(line);
  };
  for (const auto& p : mesh.positions) triple("v", p);
  constexpr double digits = 1e6;  // of a normal's components
  for (const auto& n : mesh.normals) {
    const auto few = [](double x) { return std::round(x * digits) / digits + 0.0; };
    triple("vn", {few(n.x), few(n.y), few(n.z)});
  }
  for (const auto& triangle : mesh.triangles) {
    line = "f";
    for (const TriangleMesh::Index vertex : triangle) {
      line += ' ' + std::to_string(std::size_t{mesh.position_index(vertex)} + 1) + "//" +
              std::to_string(std::size_t{vertex} + 1);
    }
    line += '\n';
    out.raw(line);
  }
}

void write_glb(const TriangleMesh& mesh, const std::string& name, const ByteSink& sink) {
  const std::size_t vertices = mesh.vertex_count(), corners = 3 * mesh.triangles.size();
  const std::size_t vectors = 3 * sizeof(float) * vertices;
  const std::size_t indices = sizeof(std::uint32_t) * corners;
  const Vector3<double> origin = gltf_origin(mesh);

  // The document states the box of the positions as they stand in the file.
  Vector3<double> low{}, high{};
  for (std::size_t i = 0; i < vertices; ++i) {
    const Vector3<double> p =
        rounded(mesh.positions[mesh.position_index(static_cast<TriangleMesh::Index>(i))] - origin);
    for (std::size_t j = 0; j < 3; ++j) {
      low[j] = i == 0 ? p[j] : std::min(low[j], p[j]);
      high[j] = i == 0 ? p[j] : std::max(high[j], p[j]);
    }
  }
  using Json = nlohmann::ordered_json;
  constexpr int float_type = 5126, index_type = 5125, array_buffer = 34962, index_buffer = 34963;
  const std::string shown = name.empty() ? "sweep" : name;
  Json node = {{"name", shown}, {"mesh", 0}};
  if (origin != Vector3<double>{}) node["translation"] = {origin.x, origin.y, origin.z};
  const Json document = {
      {"asset", {{"version", "2.0"}, {"generator", "Hodograph " + std::string(version)}}},
      {"scene", 0},
      {"scenes", Json::array({{{"nodes", Json::array({0})}}})},
      {"nodes", Json::array({node})},
      {"meshes",
       Json::array({{{"name", shown},
                     {"primitives", Json::array({{{"attributes", {{"POSITION", 0}, {"NORMAL", 1}}},
                                                  {"indices", 2}}})}}})},
      {"accessors", Json::array({{{"bufferView", 0},
                                  {"componentType", float_type},
                                  {"count", vertices},
                                  {"type", "VEC3"},
                                  {"min", {low.x, low.y, low.z}},
                                  {"max", {high.x, high.y, high.z}}},
                                 {{"bufferView", 1},
                                  {"componentType", float_type},
                                  {"count", vertices},
                                  {"type", "VEC3"}},
                                 {{"bufferView", 2},
                                  {"componentType", index_type},
                                  {"count", corners},
                                  {"type", "SCALAR"}}})},
      {"bufferViews",
       Json::array(
           {{{"buffer", 0}, {"byteOffset", 0}, {"byteLength", vectors}, {"target", array_buffer}},
            {{"buffer", 0},
             {"byteOffset", vectors},
             {"byteLength", vectors},
             {"target", array_buffer}},
            {{"buffer", 0},
             {"byteOffset", 2 * vectors},
             {"byteLength", indices},
             {"target", index_buffer}}})},
      {"buffers", Json::array({{{"byteLength", 2 * vectors + indices}}})}};
  std::string text = document.dump(-1, ' ', false, Json::error_handler_t::replace);
  text.resize(padded(text.size()), ' ');

  constexpr std::uint32_t magic = 0x46546c67, container_version = 2;
  constexpr std::uint32_t json_chunk = 0x4e4f534a, binary_chunk = 0x004e4942;
  constexpr std::size_t header_size = 12, chunk_header_size = 8;
  const std::size_t binary = 2 * vectors + indices;  // a multiple of 4
  Bytes out(sink);
  out.number(magic);
  out.number(container_version);
  out.number(
      static_cast<std::uint32_t>(header_size + 2 * chunk_header_size + text.size() + binary));
  out.number(static_cast<std::uint32_t>(text.size()));
  out.number(json_chunk);
  out.raw(text);
  out.number(static_cast<std::uint32_t>(binary));
  out.number(binary_chunk);
  for (std::size_t i = 0; i < vertices; ++i) {
    out.vector(mesh.positions[mesh.position_index(static_cast<TriangleMesh::Index>(i))] - origin);
  }
  for (const auto& n : mesh.normals) out.vector(n);
  for (const auto& triangle : mesh.triangles) {
    for (const TriangleMesh::Index vertex : triangle) out.number(vertex);
  }
}

std::optional<MeshFormat> mesh_format_of(const std::string& file_name) {
  std::string suffix = std::filesystem::path(file_name).extension().string();
  for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (suffix == ".stl") return MeshFormat::stl;
  if (suffix == ".obj") return MeshFormat::obj;
  if (suffix == ".glb") return MeshFormat::glb;
  return std::nullopt;
}

std::optional<Fault> write_mesh(const TriangleMesh& mesh, MeshFormat format,
                                const std::string& name, const ByteSink& sink) {
  constexpr double most_bytes = 4294967295.0;  // the sizes of a glTF have 32 bits
  const double glb_bytes = 24.0 * static_cast<double>(mesh.vertex_count()) +
                           12.0 * static_cast<double>(mesh.triangles.size()) + 65536.0;
  if (format == MeshFormat::glb && glb_bytes > most_bytes) {
    return Fault{FaultCode::unsupported,
                 "the mesh has " + std::to_string(mesh.triangles.size()) +
                     " triangles, too many for one glTF file of 4 GiB; use STL or a larger "
                     "tolerance",
                 std::nullopt,
                 "triangles",
                 static_cast<double>(mesh.triangles.size()),
                 std::nullopt};
  }
  if (std::isinf(rounding_of(mesh, format))) {
    return Fault{FaultCode::outside_domain,
                 "a coordinate of the mesh is beyond the range of single precision; write obj, or "
                 "take a larger unit of length",
                 std::nullopt,
                 "positions",
                 std::nullopt,
                 std::nullopt};
  }
  switch (format) {
    case MeshFormat::stl:
      write_stl(mesh, name, sink);
      break;
    case MeshFormat::obj:
      write_obj(mesh, name, sink);
      break;
    case MeshFormat::glb:
      write_glb(mesh, name, sink);
      break;
  }
  return std::nullopt;
}

std::optional<Fault> save_mesh(const TriangleMesh& mesh, MeshFormat format, const std::string& name,
                               const std::string& path) {
  auto file = OutputFile::create(path);
  if (!file) return file.fault();
  if (auto fault =
          write_mesh(mesh, format, name, [&file](std::string_view bytes) { file->write(bytes); })) {
    return fault;
  }
  return file->commit();
}

double rounding_of(const TriangleMesh& mesh, MeshFormat format) {
  switch (format) {
    case MeshFormat::stl:
      return single_precision_error(mesh);
    case MeshFormat::glb:
      return single_precision_error(mesh, gltf_origin(mesh));
    case MeshFormat::obj:
      break;
  }
  return 0.0;
}

}  // namespace hodograph
