// SPDX-License-Identifier: MIT
// Mesh files read back: by assimp where it is there, which is nobody's but its own.
#include "hodograph/io/mesh_file.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <filesystem>
#include <map>
#include <numbers>
#include <tuple>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/io/file.hpp"
#include "hodograph/surface/sweep_mesh.hpp"

#if HODOGRAPH_TEST_HAS_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>
#endif

namespace hodograph {
namespace {

/// A bent tube with flat ends, or a closed one.
SweepMesh example(bool closed, const Vector3<double>& start = {}) {
  const AnyPath loop = closed_loop({0.5, 2.0}, {10.0, start, {1, 0, 0, 0}}).value();
  PathNumbers numbers = loop.numbers();
  numbers.closed = closed;
  const AnyPath path = AnyPath::create(numbers).value();
  return mesh_of({Motion::along(path).value(),
                  Profile::polygon(std::vector<Vector2<double>>{{-0.1, -0.1}, {0.2, 0}, {0, 0.2}})
                      .value()},
                 {0.005})
      .value();
}

std::string bytes_of(void (*write)(const TriangleMesh&, const std::string&, const ByteSink&),
                     const TriangleMesh& mesh, const std::string& name = "tube") {
  std::string text;
  write(mesh, name, [&text](std::string_view part) { text += part; });
  return text;
}

/// A mesh of what a file holds, equal positions taken for one.
struct Joined {
  std::map<std::tuple<double, double, double>, TriangleMesh::Index> index;
  TriangleMesh mesh;
  TriangleMesh::Index add(double x, double y, double z) {
    const auto [at, fresh] =
        index.try_emplace({x, y, z}, static_cast<TriangleMesh::Index>(mesh.positions.size()));
    if (fresh) {
      mesh.positions.push_back({x, y, z});
      mesh.normals.push_back({});
    }
    return at->second;
  }
};

void expect_same_solid(const MeshFacts& read, const MeshFacts& made, double rounding) {
  EXPECT_TRUE(read.is_manifold() && read.is_closed());
  EXPECT_EQ(read.triangles, made.triangles);
  EXPECT_EQ(read.positions, made.positions);
  EXPECT_EQ(read.euler_characteristic, made.euler_characteristic);
  EXPECT_LE(std::abs(read.volume - made.volume), 2 * rounding * made.area);
  EXPECT_LE(std::abs(read.area - made.area),
            8 * rounding * made.area * std::sqrt(static_cast<double>(made.triangles)));
}

TEST(MeshFile, StlHoldsEveryTriangleInSinglePrecision) {
  for (const bool closed : {false, true}) {
    const TriangleMesh mesh = example(closed).mesh;
    const std::string text = bytes_of(write_stl, mesh);
    ASSERT_EQ(text.size(), 84 + 50 * mesh.triangles.size());
    EXPECT_NE(text.substr(0, 5), "solid");
    Joined read;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      float numbers[12];
      std::memcpy(numbers, text.data() + 84 + 50 * t, sizeof numbers);
      std::array<TriangleMesh::Index, 3> corners;
      for (std::size_t i = 0; i < 3; ++i) {
        const float* p = numbers + 3 + 3 * i;
        corners[i] = read.add(p[0], p[1], p[2]);
      }
      read.mesh.triangles.push_back(corners);
    }
    expect_same_solid(facts_of(read.mesh), facts_of(mesh), rounding_of(mesh, MeshFormat::stl));
  }
}

TEST(MeshFile, ObjHoldsTheSameDoubles) {
  const TriangleMesh mesh = example(false).mesh;
  std::istringstream text(bytes_of(write_obj, mesh));
  std::string key;
  std::size_t positions = 0, normals = 0, triangles = 0;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    words >> key;
    if (key == "v") {
      std::string x, y, z;
      words >> x >> y >> z;
      const Vector3<double> p{std::stod(x), std::stod(y), std::stod(z)};
      EXPECT_EQ(p, mesh.positions.at(positions++));
    }
    normals += key == "vn";
    triangles += key == "f";
  }
  EXPECT_EQ(positions, mesh.positions.size());
  EXPECT_EQ(normals, mesh.normals.size());
  EXPECT_EQ(triangles, mesh.triangles.size());
}

TEST(MeshFile, SuffixesTellTheFormat) {
  EXPECT_EQ(mesh_format_of("a/b.STL"), MeshFormat::stl);
  EXPECT_EQ(mesh_format_of("b.obj"), MeshFormat::obj);
  EXPECT_EQ(mesh_format_of("b.glb"), MeshFormat::glb);
  EXPECT_FALSE(mesh_format_of("b.gltf"));
  EXPECT_FALSE(mesh_format_of("stl"));
  const auto fault = save_mesh(example(true).mesh, MeshFormat::stl, "", "/no/such/folder/a.stl");
  ASSERT_TRUE(fault);
  EXPECT_EQ(fault->code, FaultCode::not_written);
}

TEST(MeshFile, RefusesWhatSinglePrecisionDoesNotHold) {
  TriangleMesh mesh = example(true).mesh;
  for (auto& p : mesh.positions) p = 1e40 * p;
  for (const MeshFormat format : {MeshFormat::stl, MeshFormat::glb}) {
    const auto fault = write_mesh(mesh, format, "", [](std::string_view) { FAIL(); });
    ASSERT_TRUE(fault);
    EXPECT_EQ(fault->code, FaultCode::outside_domain);
    const std::string file = std::filesystem::path(::testing::TempDir()) / "mesh_file_test_far";
    ASSERT_TRUE(save_mesh(mesh, format, "", file));
    EXPECT_FALSE(std::filesystem::exists(file));
  }
}

#if HODOGRAPH_TEST_HAS_ASSIMP
class ReadByAssimp : public ::testing::TestWithParam<std::tuple<MeshFormat, bool, bool>> {};

TEST_P(ReadByAssimp, IsTheSameSolid) {
  const auto [format, closed, far] = GetParam();
  const TriangleMesh mesh =
      example(closed, far ? Vector3<double>{3000, -2000, 1000} : Vector3<double>{}).mesh;
  const std::string name = std::string("mesh_file_test") + (closed ? "_closed" : "") +
                           (far ? "_far" : "") +
                           (format == MeshFormat::stl   ? ".stl"
                            : format == MeshFormat::obj ? ".obj"
                                                        : ".glb");
  const std::string file = std::filesystem::path(::testing::TempDir()) / name;
  ASSERT_FALSE(save_mesh(mesh, format, "tube", file));
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFile(file, 0);
  ASSERT_NE(scene, nullptr) << importer.GetErrorString();
  ASSERT_EQ(scene->mNumMeshes, 1u);
  const aiMesh& read = *scene->mMeshes[0];
  // Where the node that holds the mesh puts it.
  const aiNode* node = scene->mRootNode;
  while (node->mNumMeshes == 0 && node->mNumChildren > 0) node = node->mChildren[0];
  aiVector3D scaling, shift;
  aiQuaternion turn;
  node->mTransformation.Decompose(scaling, turn, shift);
  Joined joined;
  // assimp holds single precision, the OBJ's as well; positions that were distinct stay so.
  for (unsigned t = 0; t < read.mNumFaces; ++t) {
    ASSERT_EQ(read.mFaces[t].mNumIndices, 3u);
    std::array<TriangleMesh::Index, 3> corners;
    for (unsigned i = 0; i < 3; ++i) {
      const aiVector3D& p = read.mVertices[read.mFaces[t].mIndices[i]];
      corners[i] = joined.add(p.x, p.y, p.z);
    }
    joined.mesh.triangles.push_back(corners);
  }
  const double rounding = std::max(rounding_of(mesh, format),
                                   format == MeshFormat::obj ? single_precision_error(mesh) : 0.0);
  expect_same_solid(facts_of(joined.mesh), facts_of(mesh), rounding);
  const Vector3<double> shifted =
      middle_of(joined.mesh) + Vector3<double>{shift.x, shift.y, shift.z};
  EXPECT_LE(largest_component(shifted - middle_of(mesh)), rounding);
  // Normals agree with the triangles: outwards.
  ASSERT_TRUE(read.HasNormals());
  for (unsigned t = 0; t < read.mNumFaces; ++t) {
    const aiFace& f = read.mFaces[t];
    const aiVector3D a = read.mVertices[f.mIndices[0]];
    const aiVector3D across =
        (read.mVertices[f.mIndices[1]] - a) ^ (read.mVertices[f.mIndices[2]] - a);
    for (unsigned i = 0; i < 3; ++i) EXPECT_GT(across * read.mNormals[f.mIndices[i]], 0.0f);
  }
}

INSTANTIATE_TEST_SUITE_P(MeshFile, ReadByAssimp,
                         ::testing::Combine(::testing::Values(MeshFormat::stl, MeshFormat::obj,
                                                              MeshFormat::glb),
                                            ::testing::Bool(), ::testing::Bool()));
#endif

}  // namespace
}  // namespace hodograph
