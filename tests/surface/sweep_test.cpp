// SPDX-License-Identifier: MIT
// Sweeps against golden values, their own exact patches, and closed forms.
#include "hodograph/surface/sweep.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/planar_spline.hpp"
#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/surface/sweep_mesh.hpp"
#include "tests/support/compare.hpp"
#include "tests/support/json.hpp"
#include "tests/support/random.hpp"

namespace hodograph {
namespace {

using test::Json;
constexpr double pi = std::numbers::pi;

void expect_near(const Vector3<double>& a, const Vector3<double>& b, double rel_tol) {
  EXPECT_LE(largest_component(a - b), rel_tol * std::max(1.0, largest_component(b)))
      << a.x << " " << a.y << " " << a.z << " for " << b.x << " " << b.y << " " << b.z;
}

/// The plane curve of a path in z = 0.
std::vector<RationalBezier> plane_curve(const SpatialPath<3>& path) {
  std::vector<RationalBezier> pieces;
  for (const auto& curve : path.segments()) {
    RationalBezier piece{0.0, 1.0, {}, std::vector<double>(8, 1.0)};
    for (const auto& d : curve.displacement().coefficients()) {
      piece.control_points.push_back({curve.start().x + d.x, curve.start().y + d.y});
    }
    pieces.push_back(piece);
  }
  return pieces;
}

TEST(SweepGolden, SweptSurfacesOfClosedLoops) {
  const Json file = test::golden_file("surfaces.json");
  for (const Json& one : file["swept"].list()) {
    SCOPED_TRACE(one["name"].string());
    const double psi = one["input"]["psi"].number(), tol = one["rel_tol"].number();
    const auto path = closed_loop({one["input"]["xi"].number(), psi}).value();
    const double gamma = one["expected"]["gamma"].number();
    const auto oval =
        closed_loop({0.0, pi}, {one["input"]["profile_length"].number(), {}, {1, 0, 0, 0}}).value();
    const Sweep sweep{Motion::along(path, periodic_roll(path, gamma).value()).value(),
                      Profile::of(plane_curve(oval), true).value()};
    EXPECT_EQ(sweep.motion.roll(), nullptr);
    const auto patches = rational_patches(sweep).value();
    for (const Json& point : one["expected"]["points"].list()) {
      const double t = point["t"].number(), u = point["u"].number();
      const Vector3<double> expected = point["point"].vector();
      expect_near(point_of(sweep, 0, t, 0, u).position, expected, tol);
      // The profile has one piece; halving the weights may have made several patches.
      for (const auto& patch : patches) {
        if (t < patch.begin_v || patch.end_v < t) continue;
        const double v = (t - patch.begin_v) / (patch.end_v - patch.begin_v);
        expect_near(patch.position(v, u), expected, tol);
      }
    }
  }
}

TEST(SweepGolden, TubularFamilies) {
  const Json file = test::golden_file("surfaces.json");
  for (const Json& one : file["tube"].list()) {
    SCOPED_TRACE(one["name"].string());
    const Json& in = one["input"];
    const AnyPath loop = closed_loop({in["xi"].number(), in["psi"].number()}).value();
    const auto numbers = [&](const char* name) {
      std::vector<double> list;
      for (const Json& x : in[name].list()) list.push_back(x.number());
      return list;
    };
    const auto u = numbers("u"), v = numbers("v"), p = numbers("p"), q = numbers("q");
    std::vector<Quaternion<double>> rotation;
    for (std::size_t i = 0; i < u.size(); ++i) rotation.push_back({u[i], v[i], p[i], q[i]});
    std::vector<Vector3<double>> center;
    for (const Json& c : in["c"].list()) center.push_back(c.vector());
    const Sweep family{Motion::polynomial(DynamicPolynomial<Vector3<double>>(center),
                                          DynamicPolynomial<Quaternion<double>>(rotation),
                                          DynamicPolynomial<double>(numbers("rho")))
                           .value(),
                       Profile::in_space(loop).value()};
    const auto patches = rational_patches(family).value();
    for (const Json& point : one["expected"]["points"].list()) {
      const double t = point["t"].number(), s = point["u"].number();
      const Vector3<double> expected = point["point"].vector();
      expect_near(point_of(family, 0, s, 0, t).position, expected, one["rel_tol"].number());
      for (const auto& patch : patches) {
        if (s < patch.begin_v || patch.end_v < s) continue;
        const double v = (s - patch.begin_v) / (patch.end_v - patch.begin_v);
        expect_near(patch.position(v, t), expected, one["rel_tol"].number());
      }
    }
  }
}

// ---- meshes -------------------------------------------------------------------------------------

/// The circle of radius R about the origin, nearly: a C2 spline through its points.
PlanarPath<2> ring(double radius, std::size_t points = 12) {
  std::vector<Vector2<double>> nodes;
  for (std::size_t i = 0; i < points; ++i) {
    const double a = 2 * pi * static_cast<double>(i) / static_cast<double>(points);
    nodes.push_back({radius * std::cos(a), radius * std::sin(a)});
  }
  PlanarSplineOptions options;
  options.closed = true;
  return planar_spline(nodes, options).value().path;
}
AnyPath straight(double length) {
  const double w = std::sqrt(length);
  return AnyPath(SpatialPath<1>::create(
                     {0.0, 1.0},
                     {{{1.0, 2.0, 3.0},
                       BernsteinPolynomial<Quaternion<double>, 1>(
                           {Quaternion<double>{w, 0, 0, 0}, Quaternion<double>{w, 0, 0, 0}}),
                       1.0}},
                     false)
                     .value());
}

/// Facts that every mesh must have; the deviation is also measured at random points of triangles.
MeshFacts checked(const Sweep& sweep, double tolerance, long long euler) {
  const auto made = mesh_of(sweep, {tolerance}).value();
  EXPECT_LE(made.deviation, tolerance);
  const MeshFacts facts = facts_of(made.mesh);
  EXPECT_TRUE(facts.is_manifold());
  EXPECT_EQ(facts.euler_characteristic, euler);
  for (const auto& n : made.mesh.normals) EXPECT_NEAR(norm(n), 1.0, 8 * epsilon<double>());
  return facts;
}

TEST(SweepMesh, TorusIsClosedOrientedAndHasItsAreaAndVolume) {
  const double big = 2.0, small = 0.5;
  const Sweep torus{Motion::along(ring(big, 64)).value(), Profile::circle(small).value()};
  const double area = 4 * pi * pi * big * small, volume = 2 * pi * pi * big * small * small;
  for (const double tolerance : {0.05, 0.005, 0.0005}) {
    const MeshFacts facts = checked(torus, tolerance, 0);
    EXPECT_TRUE(facts.is_closed());
    // The mesh lies within the tolerance of the surface: its volume within area times tolerance,
    // and a margin for the spline, which is within 1e-6 of the circle.
    EXPECT_NEAR(facts.volume, volume, 1.2 * area * tolerance);
    EXPECT_NEAR(facts.area, area, area * tolerance / small);
    EXPECT_LT(facts.volume, volume);
  }
}

TEST(SweepMesh, PrismHasExactVolumeAndArea) {
  const std::vector<Vector2<double>> corners{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 3}, {0, 3}};
  const Sweep prism{Motion::along(straight(4.0)).value(), Profile::polygon(corners).value()};
  const MeshFacts facts = checked(prism, 0.01, 2);
  EXPECT_TRUE(facts.is_closed());
  EXPECT_NEAR(facts.volume, 4.0 * 4.0, 64 * epsilon<double>() * 16.0);
  EXPECT_NEAR(facts.area, 2 * 4.0 + 4.0 * 10.0, 64 * epsilon<double>() * 48.0);
  EXPECT_EQ(facts.triangles, 2u * 6u + 2u * 4u);
}

TEST(SweepMesh, ConeOfLinearScale) {
  const Sweep cone{Motion::along(straight(3.0), MotionFrame::closing, {1.0, 0.25}).value(),
                   Profile::circle(1.0).value()};
  const double volume = pi * 3.0 / 3.0 * (1.0 + 0.25 + 0.0625);
  const MeshFacts facts = checked(cone, 0.001, 2);
  EXPECT_TRUE(facts.is_closed());
  const double tolerance = 0.001;
  EXPECT_LE(std::abs(facts.volume - volume), tolerance * 2 * pi * 3.2);
}

TEST(SweepMesh, LoopsCloseWhateverTheHolonomy) {
  test::Random random("SweepMesh.LoopsClose");
  for (int i = 0; i < 6; ++i) {
    const AnyPath loop =
        AnyPath(closed_loop({random.uniform(-1.5, 1.5), random.uniform(-pi, pi)}).value());
    for (const Profile& profile :
         {Profile::circle(0.01).value(),
          Profile::polygon(std::vector<Vector2<double>>{{-0.01, -0.02}, {0.01, -0.02}, {0.0, 0.02}})
              .value()}) {
      const Sweep sweep{Motion::along(loop).value(), profile};
      const MeshFacts facts = checked(sweep, 0.0005, 0);
      EXPECT_TRUE(facts.is_closed());
      EXPECT_GT(facts.volume, 0.0);
    }
  }
}

/// A bent path in space, open.
SpatialPath<3> bent() {
  const auto loop = closed_loop({0.7, 1.9}, {8.0, {1, -2, 3}, {1, 0, 0, 0}}).value();
  return SpatialPath<3>::create({0.0, 1.0}, {loop.segment(0)}, false).value();
}

/// No mesh of the same surface may depend on the frame by more than the tolerance; here the frames
/// differ and the closed forms of the volume agree: an odd profile about the path sweeps, by
/// Pappus, its area times the length where its centroid is on the path.
TEST(SweepMesh, EveryRollIsWithinTheTolerance) {
  const auto path = bent();
  const std::vector<Vector2<double>> square{{-0.1, -0.1}, {0.1, -0.1}, {0.1, 0.1}, {-0.1, 0.1}};
  const Profile profile = Profile::polygon(square).value();
  const double volume = 0.04 * path.arc_length();
  const PreimageTable table(path);
  for (const FrameRoll& roll :
       {FrameRoll::none(table), FrameRoll::linear(table, 0.3, 9.0),
        rotation_minimising_roll(table, 0.2).value(), least_twist_roll(table, 0.0, 4.0).value()}) {
    const Sweep sweep{Motion::along(path, roll).value(), profile};
    for (const double tolerance : {0.01, 0.001}) {
      const auto made = mesh_of(sweep, {tolerance}).value();
      EXPECT_LE(made.deviation, tolerance);
      const MeshFacts facts = facts_of(made.mesh);
      EXPECT_TRUE(facts.is_manifold() && facts.is_closed());
      EXPECT_EQ(facts.euler_characteristic, 2);
      EXPECT_LE(std::abs(facts.volume - volume), facts.area * tolerance);
      // Sampled: the middles of edges along the path against the surface there.
      const AdaptedFrame frame(path, roll);
      for (const double xi : {0.0, 0.1234, 0.5, 0.987, 1.0}) {
        const auto r = frame.at(xi);
        for (std::size_t i = 0; i < square.size(); ++i) {
          const Vector3<double> expected =
              path.position(xi) + square[i].x * r.e2 + square[i].y * r.e3;
          expect_near(point_of(sweep, 0, xi, i, 0.0).position, expected, 256 * epsilon<double>());
        }
      }
    }
    EXPECT_EQ(static_cast<bool>(rational_patches(sweep)), roll.kind() == RollKind::none);
  }
}

/// The distance of a point from a segment, and from a triangle: from its plane where the foot of
/// the perpendicular lies inside, else from its nearest side.
double distance_to_segment(const Vector3<double>& x, const Vector3<double>& a,
                           const Vector3<double>& b) {
  const Vector3<double> side = b - a;
  const double length = dot(side, side);
  const double t = length > 0.0 ? std::clamp(dot(x - a, side) / length, 0.0, 1.0) : 0.0;
  return norm(x - a - t * side);
}
double distance_to_triangle(const Vector3<double>& x, const std::array<Vector3<double>, 3>& c) {
  const Vector3<double> n = cross(c[1] - c[0], c[2] - c[0]);
  bool inside = dot(n, n) > 0.0;
  double sides = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3<double>&p = c[i], &q = c[(i + 1) % 3];
    if (dot(cross(q - p, x - p), n) < 0.0) inside = false;
    sides = std::min(sides, distance_to_segment(x, p, q));
  }
  return inside ? std::abs(dot(x - c[0], n)) / norm(n) : sides;
}

/// Random points of the surface are no further from the nearest triangle, found among all, than the
/// bound says; and some of them nearly as far.
TEST(SweepMesh, SampledDeviationIsWithinTheBound) {
  const auto path = bent();
  const PreimageTable table(path);
  const Profile ellipse = Profile::ellipse(0.3, 0.1).value();
  test::Random random("SweepMesh.SampledDeviation");
  for (const FrameRoll& roll : {FrameRoll::none(table), rotation_minimising_roll(table).value(),
                                FrameRoll::linear(table, 0.0, 20.0)}) {
    const Sweep sweep{Motion::along(path, roll, {1.0, 0.4, 1.3}).value(), ellipse};
    const auto made = mesh_of(sweep, {0.004}).value();
    double worst = 0.0;
    for (int i = 0; i < 400; ++i) {
      const Vector3<double> x = point_of(sweep, 0, random.unit(),
                                         random.index(ellipse.smooth_piece_count()), random.unit())
                                    .position;
      double nearest = std::numeric_limits<double>::infinity();
      for (std::size_t t = 0; t < made.mesh.triangles.size() - made.cap_triangles; ++t) {
        nearest = std::min(nearest,
                           distance_to_triangle(x, {made.mesh.corner(t, 0), made.mesh.corner(t, 1),
                                                    made.mesh.corner(t, 2)}));
      }
      worst = std::max(worst, nearest);
    }
    EXPECT_LE(worst, made.deviation);
    EXPECT_GT(worst, made.deviation / 16);
  }
}

TEST(SweepMesh, FrenetFramesOfLoopsClose) {
  const auto loop = closed_loop({0.5, 2.0}, {10.0, {}, {1, 0, 0, 0}}).value();
  const Profile ellipse = Profile::ellipse(0.3, 0.1).value();
  const Sweep sweep{Motion::along(loop, frenet_roll(loop).value()).value(), ellipse};
  const MeshFacts facts = checked(sweep, 0.001, 0);
  EXPECT_TRUE(facts.is_closed());
  const double volume = pi * 0.3 * 0.1 * loop.arc_length();
  EXPECT_LE(std::abs(facts.volume - volume), 0.001 * facts.area);
  // A figure of eight has inflections, where the normal changes sides.
  const auto eight = closed_loop({0.0, 0.0}).value();
  EXPECT_EQ(Motion::along(eight, frenet_roll(eight).value()).fault().code,
            FaultCode::not_continuous);
}

/// A planar path as profile, and a tube whose radius varies: the volume is the integral of the
/// area, of scale² times that of the profile.
TEST(SweepMesh, PathsAsProfilesAndVaryingRadius) {
  const Sweep sweep{Motion::along(straight(3.0), MotionFrame::closing, {1.0, 2.0, 1.0}).value(),
                    Profile::of(AnyPath(ring(0.5, 64))).value()};
  const MeshFacts facts = checked(sweep, 0.001, 2);
  // ∫ (1 + 2t(1-t))² dt = 1 + 2/3 + 2/15.
  const double volume = pi * 0.25 * 3.0 * (1.0 + 2.0 / 3.0 + 2.0 / 15.0);
  EXPECT_LE(std::abs(facts.volume - volume), 0.001 * facts.area);
}

TEST(SweepTracks, AreOffsetsInTheFrame) {
  const auto path = bent();
  const Motion motion = Motion::along(path).value();
  const AdaptedFrame frame(path, FrameRoll::none(path));
  const auto curves = offset_track(motion, {0.0, 0.3, -0.1}).value();
  EXPECT_EQ(curves.front().begin, 0.0);
  EXPECT_EQ(curves.back().end, 1.0);
  for (const auto& curve : curves) {
    EXPECT_EQ(curve.degree(), 13u);
    for (const double u : {0.0, 0.3, 1.0}) {
      const double xi = curve.begin + u * (curve.end - curve.begin);
      const auto r = frame.at(xi);
      expect_near(curve.position(u), path.position(xi) + 0.3 * r.e2 - 0.1 * r.e3,
                  256 * epsilon<double>());
    }
  }
}

TEST(SweepMesh, RibbonHasABoundary) {
  const std::vector<Vector2<double>> edge{{-0.2, 0.0}, {0.3, 0.0}};
  const Profile line = Profile::polyline(edge).value();
  const Sweep band{Motion::along(ring(2.0)).value(), line};
  const MeshFacts closed = checked(band, 0.001, 0);
  EXPECT_GT(closed.boundary_edges, 0u);
  EXPECT_TRUE(closed.is_manifold());
  // Between the radii 1.7 and 2.2: e2 is the left normal, inwards on a counterclockwise circle.
  EXPECT_LE(std::abs(closed.area - pi * (2.2 * 2.2 - 1.7 * 1.7)), 0.01 * pi);
  const Sweep strip{Motion::along(straight(4.0)).value(), line};
  EXPECT_EQ(checked(strip, 0.001, 1).boundary_edges, 4u);
}

/// The largest sampled distance of the mesh from the surface at the same parameters would need the
/// parameters; distances from a torus have a closed form.
TEST(SweepMesh, StaysWithinItsDeviationOfATorus) {
  const double big = 2.0, small = 0.5;
  const Sweep torus{Motion::along(ring(big, 128)).value(), Profile::circle(small).value()};
  const auto made = mesh_of(torus, {0.01}).value();
  double worst = 0.0;
  for (std::size_t t = 0; t < made.mesh.triangles.size(); ++t) {
    const Vector3<double> a = made.mesh.corner(t, 0), b = made.mesh.corner(t, 1),
                          c = made.mesh.corner(t, 2);
    for (const auto& x : {0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (1.0 / 3) * (a + b + c)}) {
      const double distance = std::abs(std::hypot(std::hypot(x.x, x.y) - big, x.z) - small);
      worst = std::max(worst, distance);
    }
  }
  EXPECT_LT(worst, made.deviation);
  EXPECT_GT(worst, 0.3 * made.deviation);  // the bound is not idle
}

// ---- bad input ----------------------------------------------------------------------------------

TEST(SweepMesh, RefusesWhatItCannotDo) {
  const Sweep tube{Motion::along(straight(4.0)).value(), Profile::circle(0.5).value()};
  for (const double bad : {0.0, -1.0, std::numeric_limits<double>::infinity(),
                           std::numeric_limits<double>::quiet_NaN()}) {
    EXPECT_EQ(mesh_of(tube, {bad}).fault().code, FaultCode::outside_domain);
  }
  const auto many = mesh_of(Sweep{Motion::along(ring(2.0)).value(), Profile::circle(0.5).value()},
                            {ldexp(1.0, -30)});
  ASSERT_FALSE(many);
  EXPECT_EQ(many.fault().code, FaultCode::tolerance_not_reached);
  EXPECT_GT(*many.fault().value, 2e7);
  EXPECT_EQ(mesh_of(tube, {ldexp(1.0, -52)}).fault().code, FaultCode::tolerance_not_reached);
  // A huge tolerance makes a coarse mesh, still a closed one.
  const MeshFacts coarse = facts_of(mesh_of(tube, {1e300}).value().mesh);
  EXPECT_TRUE(coarse.is_closed() && coarse.is_manifold());
  EXPECT_GT(coarse.volume, 0.0);
}

TEST(SweepMotion, RefusesCornersStandstillsAndScales) {
  EXPECT_EQ(Motion::along(straight(1.0), MotionFrame::closing, {}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(Motion::along(straight(1.0), MotionFrame::closing, {1.0, 0.0}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(Motion::along(straight(1.0), MotionFrame::closing, {1.0, -2.0, 1.0}).fault().code,
            FaultCode::outside_domain);
  EXPECT_EQ(Motion::along(ring(1.0), MotionFrame::closing, {1.0, 2.0}).fault().code,
            FaultCode::outside_domain);
  // A rotation-minimising frame does not return, nor does a loop's Euler-Rodrigues frame.
  const auto loop = closed_loop({1.0, 1.0}).value();
  EXPECT_EQ(Motion::along(loop, MotionFrame::euler_rodrigues).fault().code,
            FaultCode::not_continuous);
  EXPECT_EQ(Motion::along(loop, rotation_minimising_roll(loop).value()).fault().code,
            FaultCode::not_continuous);
  // The limit members stand still at their start.
  const AnyPath limit = closed_loop({std::numeric_limits<double>::infinity(), 1.0}).value();
  EXPECT_EQ(Motion::along(limit).fault().code, FaultCode::zero_speed);
}

TEST(SweepContact, TubesThatMeetThemselvesAreRefusedWithTheRadiusThatWouldDo) {
  const PlanarPath<2> path = ring(2.0);
  const TubeRadius limit = largest_tube_radius(path, {1.0 / 1024});
  EXPECT_GT(limit.radius.lower(), 1.9);
  EXPECT_LT(limit.radius.upper(), 2.1);  // the spline is not quite a circle
  const auto tube = [&](double r) {
    return Sweep{Motion::along(path).value(), Profile::circle(r).value()};
  };
  EXPECT_TRUE(is_certainly_free(tube(1.9), limit));
  EXPECT_FALSE(contact_fault(tube(1.9), limit));
  const auto fault = contact_fault(tube(2.1), limit);
  ASSERT_TRUE(fault);
  EXPECT_EQ(*fault->bound, limit.radius.lower());
  // A square that reaches past the centre folds, one that reaches outwards does not.
  const std::vector<Vector2<double>> inwards{{0, -1}, {2.5, -1}, {2.5, 1}, {0, 1}};
  const std::vector<Vector2<double>> outwards{{-2.5, -1}, {0, -1}, {0, 1}, {-2.5, 1}};
  const Sweep in{Motion::along(path).value(), Profile::polygon(inwards).value()};
  const Sweep out{Motion::along(path).value(), Profile::polygon(outwards).value()};
  EXPECT_EQ(fold_of(in).kind, SweepFold::Kind::certain);
  EXPECT_EQ(fold_of(out).kind, SweepFold::Kind::none);
  EXPECT_TRUE(contact_fault(in, limit));
  EXPECT_FALSE(contact_fault(out, limit));
}

}  // namespace
}  // namespace hodograph
