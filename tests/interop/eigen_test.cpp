// SPDX-License-Identifier: MIT
#include "hodograph/interop/eigen.hpp"

#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "hodograph/construction/hermite.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Random;
using Vector = Vector3<double>;

TEST(Eigen, VectorsAndQuaternionsComeBackAsTheyWere) {
  Random random("interop there and back");
  for (int round = 0; round < 20; ++round) {
    const auto planar = random.components<Vector2<double>>(1e3);
    const auto spatial = random.components<Vector>(1e3);
    const auto quaternion = random.components<Quaternion<double>>(1e3);
    EXPECT_EQ(from_eigen(to_eigen(planar)), planar);
    EXPECT_EQ(from_eigen(to_eigen(spatial)), spatial);
    EXPECT_EQ(from_eigen(to_eigen(quaternion)), quaternion);
    EXPECT_EQ(to_eigen(quaternion).w(), quaternion.w);
    EXPECT_EQ(to_eigen(quaternion).z(), quaternion.z);
  }
  const Eigen::RowVector2f row(1.5F, -2.0F);
  EXPECT_EQ(from_eigen(row), (Vector2<float>{1.5F, -2.0F}));
  const Eigen::Vector3d a(1.0, 2.0, 3.0), b(0.5, 0.25, 0.125);
  EXPECT_EQ(from_eigen(a - 2.0 * b), (Vector{0.0, 1.5, 2.75}));
}

TEST(Eigen, ProductsAndRotationsAreThoseOfEigen) {
  Random random("interop rotations");
  for (int round = 0; round < 20; ++round) {
    const auto p = random.components<Quaternion<double>>(1.0);
    const auto q = random.components<Quaternion<double>>(1.0);
    const auto v = random.components<Vector>(1.0);
    // Products of numbers of at most 2 in size, four of them summed: some roundings of 8.
    constexpr double allowed = 64 * epsilon<double>();
    const Quaternion<double> product = from_eigen(to_eigen(p) * to_eigen(q));
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(product[i], (p * q)[i], allowed);
    const double size = dot(p, p);
    if (size < 0.1) continue;
    const Eigen::Vector3d turned = to_eigen(p).normalized() * to_eigen(v);
    const Vector expected = (1.0 / size) * sandwich(p, v);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_NEAR(from_eigen(turned)[i], expected[i], allowed / size);
    }
  }
}

TEST(Eigen, AFrameIsTheMatrixOfItsAxesAndTheRotationOfItsPreimage) {
  const HermitePoint<1> begin{Vector{0, 0, 0}, {1, 0.2, 0}},
      end{Vector{1, 0.4, -0.2}, {0.7, 0.1, 0.3}};
  const auto path = hermite_path<1, double>({0.0, 1.0}, std::vector{begin, end}).value();
  const Frame3<double> frame = AdaptedFrame(path).at(0.7);
  const Eigen::Matrix3d matrix = to_eigen(frame);
  EXPECT_EQ(matrix(2, 0), frame.e1.z);
  EXPECT_EQ(matrix(0, 2), frame.e3.x);
  EXPECT_EQ(frame_from_eigen(matrix), frame);
  EXPECT_EQ(frame_from_eigen(2.0 * matrix), 2.0 * frame);
  constexpr double allowed = 32 * epsilon<double>();
  EXPECT_NEAR(matrix.determinant(), 1.0, allowed);
  const Eigen::Matrix3d same =
      to_eigen(path.preimage_jet<0>(0.7)[0]).normalized().toRotationMatrix();
  EXPECT_LE((same - matrix).cwiseAbs().maxCoeff(), allowed);

  const Eigen::Isometry3d pose = to_eigen(path.position(0.7), frame);
  EXPECT_EQ(from_eigen(Eigen::Vector3d(pose * Eigen::Vector3d(0, 0, 0))), path.position(0.7));
  EXPECT_EQ(from_eigen(Eigen::Vector3d(pose.linear() * Eigen::Vector3d::UnitY())), frame.e2);
  const Eigen::Vector3d there = pose * Eigen::Vector3d(0.1, 0.2, 0.3);
  EXPECT_LE((pose.inverse() * there - Eigen::Vector3d(0.1, 0.2, 0.3)).norm(), allowed);

  const Frame2<double> turn{{0.6, 0.8}, {-0.8, 0.6}};
  EXPECT_EQ(frame_from_eigen(to_eigen(turn)), turn);
  const Eigen::Isometry2d plane = to_eigen(Vector2<double>{3.0, 4.0}, turn);
  EXPECT_EQ(from_eigen(Eigen::Vector2d(plane * Eigen::Vector2d(1.0, 0.0))),
            (Vector2<double>{3.6, 4.8}));
}

TEST(Eigen, RowsAreThePointsThemselves) {
  std::vector<Vector> points{{1, 2, 3}, {4, 5, 6}};
  auto rows = rows_of(std::span(points));
  static_assert(decltype(rows)::ColsAtCompileTime == 3);
  EXPECT_EQ(rows.rows(), 2);
  EXPECT_EQ(rows(1, 2), 6.0);
  rows(0, 1) = -7.0;
  EXPECT_EQ(points[0].y, -7.0);
  rows.rowwise() += Eigen::RowVector3d(1, 1, 1);
  EXPECT_EQ(points[1], (Vector{5, 6, 7}));
  const std::vector<Vector2<double>> still{{0.5, 1.5}, {2.5, 3.5}, {4.5, 5.5}};
  EXPECT_EQ(rows_of(std::span(still)).colwise().sum(), Eigen::RowVector2d(7.5, 10.5));
  EXPECT_EQ(rows_of(std::span<const Vector>()).rows(), 0);
}

TEST(Eigen, DerivativesAreVectorsAndSymmetricMatrices) {
  using J = SecondOrder<double, 3>;
  const J x = J::variable(2.0, 0), y = J::variable(3.0, 1), z = J::variable(5.0, 2);
  const J f = x * x * y + z * y;
  EXPECT_EQ(gradient_of(f), Eigen::Vector3d(12, 9, 3));
  const Eigen::Matrix3d expected{{6, 4, 0}, {4, 0, 1}, {0, 1, 0}};
  EXPECT_EQ(hessian_of(f), expected);
}

}  // namespace
}  // namespace hodograph
