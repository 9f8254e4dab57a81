// SPDX-License-Identifier: MIT
// STEP models read back by OpenCASCADE: topology, volume, area, and every surface against ours.
#include "hodograph/cad/step.hpp"

#include <gtest/gtest.h>

#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <UnitsMethods.hxx>
#include <filesystem>
#include <fstream>
#include <limits>
#include <numbers>

#include "hodograph/construction/closed_loop.hpp"
#include "hodograph/construction/planar_spline.hpp"

namespace hodograph {
namespace {

constexpr double pi = std::numbers::pi;
/// Asked of OpenCASCADE's adaptive integration, relative to each face; it answers with its estimate
/// of what was reached.
constexpr double asked = 0x1p-30;

TopoDS_Shape read_back(const std::string& text) {
  const auto file = std::filesystem::path(::testing::TempDir()) / "hodograph_step_test.step";
  std::ofstream(file) << text;
  UnitsMethods::SetCasCadeLengthUnit(1.0);  // millimetres
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  STEPControl_Reader reader;
  EXPECT_EQ(reader.ReadFile(file.c_str()), IFSelect_RetDone);
  reader.TransferRoots();
  return reader.OneShape();
}
/// A measure and how far it may be off, relatively: an estimate, doubled, and the rounding of sums.
struct Measured {
  double value = 0.0, error = 0.0;
};
Measured measured(const GProp_GProps& properties, double estimate) {
  constexpr double roundings = 0x1p-44;  // of some hundred Gauss points a face
  return {properties.Mass(), 2.0 * std::max(std::abs(estimate), asked) + roundings};
}
Measured volume_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  const double estimate = BRepGProp::VolumeProperties(shape, properties, asked, true);
  return measured(properties, estimate);
}
Measured area_of(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  const double estimate = BRepGProp::SurfaceProperties(shape, properties, asked);
  return measured(properties, estimate);
}
void expect_measure(const Measured& found, double expected) {
  EXPECT_LE(std::abs(found.value / expected - 1.0), found.error);
  constexpr double useful = 0x1p-26;  // sixteen times what was asked: the estimate says something
  EXPECT_LE(found.error, useful);
}
std::size_t count(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  std::size_t n = 0;
  for (TopExp_Explorer at(shape, kind); at.More(); at.Next()) ++n;
  return n;
}

/// Every B-spline surface that was read is one of our patches: control points to the last bit but
/// for one division, and points at parameters in between.
void expect_our_patches(const TopoDS_Shape& shape, const std::vector<RationalPatch>& patches,
                        double scale) {
  for (TopExp_Explorer at(shape, TopAbs_FACE); at.More(); at.Next()) {
    const auto surface =
        Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(at.Current())));
    if (surface.IsNull()) continue;  // a cap
    double best = std::numeric_limits<double>::infinity();
    for (const auto& patch : patches) {
      double u1 = 0, u2 = 0, v1 = 0, v2 = 0, worst = 0.0;
      surface->Bounds(u1, u2, v1, v2);
      for (const double v : {0.0, 0.37, 1.0}) {
        for (const double u : {0.0, 0.61, 1.0}) {
          const gp_Pnt theirs = surface->Value(u1 + u * (u2 - u1), v1 + v * (v2 - v1));
          const auto ours = patch.position(v, u);
          worst = std::max(worst, norm(ours - Vector3<double>{theirs.X(), theirs.Y(), theirs.Z()}));
        }
      }
      best = std::min(best, worst);
    }
    EXPECT_LE(best, 512 * epsilon<double>() * scale);
  }
}

PlanarPath<2> ring(double radius) {
  std::vector<Vector2<double>> nodes;
  for (int i = 0; i < 12; ++i) {
    nodes.push_back({radius * std::cos(pi * i / 6), radius * std::sin(pi * i / 6)});
  }
  PlanarSplineOptions options;
  options.closed = true;
  return planar_spline(nodes, options).value().path;
}

TEST(Step, TorusIsASolidOfItsVolume) {
  const PlanarPath<2> path = ring(20.0);
  const Sweep torus{Motion::along(path).value(), Profile::circle(5.0).value()};
  const auto model = step_of(torus, {"torus", "mm"}).value();
  EXPECT_TRUE(model.solid);
  EXPECT_EQ(model.faces, 12u * 4u);
  EXPECT_EQ(model.degree_along, 9u);
  EXPECT_EQ(model.degree_round, 2u);
  const TopoDS_Shape shape = read_back(model.text);
  EXPECT_EQ(count(shape, TopAbs_SOLID), 1u);
  EXPECT_EQ(count(shape, TopAbs_FACE), model.faces);
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  // Pappus: the disc's area times the length of the path through its centre; so for the area.
  const double length = path.arc_length();
  expect_measure(volume_of(shape), pi * 25.0 * length);
  expect_measure(area_of(shape), 2 * pi * 5.0 * length);
  expect_our_patches(shape, rational_patches(torus).value(), 25.0);
}

TEST(Step, LoopsWithHolonomyClose) {
  const auto loop = closed_loop({0.5, 2.0}, {100.0, {7, 8, 9}, {1, 0, 0, 0}}).value();
  const Sweep sweep{Motion::along(loop).value(), Profile::ellipse(1.0, 0.6).value()};
  const auto model = step_of(sweep).value();
  EXPECT_TRUE(model.solid);
  EXPECT_EQ(model.degree_along, 15u);
  const TopoDS_Shape shape = read_back(model.text);
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  expect_measure(volume_of(shape), pi * 0.6 * loop.arc_length());
}

TEST(Step, OpenSweepsGetPlaneEnds) {
  const auto loop = closed_loop({0.5, 2.0}, {100.0, {}, {1, 0, 0, 0}}).value();
  const auto open = SpatialPath<3>::create({0.0, 1.0}, {loop.segment(0)}, false).value();
  const std::vector<Vector2<double>> corners{{-1, -1}, {2, -1}, {2, 0}, {0, 0}, {0, 1}, {-1, 1}};
  const Sweep sweep{Motion::along(open, MotionFrame::euler_rodrigues, {1.0, 0.5}).value(),
                    Profile::polygon(corners).value()};
  const auto model = step_of(sweep).value();
  EXPECT_TRUE(model.solid);
  EXPECT_EQ(model.faces, 2u * 6u + 2u);  // halved, for positive weights
  const TopoDS_Shape shape = read_back(model.text);
  EXPECT_TRUE(BRepCheck_Analyzer(shape).IsValid());
  expect_our_patches(shape, rational_patches(sweep).value(), 100.0);
}

TEST(Step, UnitsAreNamedAndNumbersStay) {
  const PlanarPath<2> path = ring(2.0);
  const Sweep torus{Motion::along(path).value(), Profile::circle(0.5).value()};
  const auto model = step_of(torus, {"torus", "m"}).value();
  EXPECT_NE(model.text.find("SI_UNIT($,.METRE.)"), std::string::npos);
  // Read into millimetres a metre is a thousand.
  const TopoDS_Shape shape = read_back(model.text);
  expect_measure(volume_of(shape), 1e9 * pi * 0.25 * path.arc_length());
}

TEST(Step, RibbonsAreShells) {
  const std::vector<Vector2<double>> edge{{-1.0, 0.0}, {2.0, 0.0}};
  const PlanarPath<2> path = ring(20.0);
  const Sweep band{Motion::along(path).value(), Profile::polyline(edge).value()};
  const auto model = step_of(band).value();
  EXPECT_FALSE(model.solid);
  const TopoDS_Shape shape = read_back(model.text);
  // From 1 to the right to 2 to the left: the integral of 1 - κp over both.
  expect_measure(area_of(shape), 3.0 * path.arc_length() - 1.5 * 2 * pi);
}

TEST(Step, RefusesWhatIsNotRationalOrTooHigh) {
  const auto loop = closed_loop({0.5, 2.0}).value();
  const auto open = SpatialPath<3>::create({0.0, 1.0}, {loop.segment(0)}, false).value();
  const Sweep rolled{Motion::along(open, rotation_minimising_roll(open).value()).value(),
                     Profile::circle(0.01).value()};
  EXPECT_EQ(step_of(rolled).fault().code, FaultCode::unsupported);
  const auto high =
      SpatialPath<8>::create({0.0, 1.0}, {open.segment(0).elevated<8>()}, false).value();
  const auto fault = step_of({Motion::along(high).value(), Profile::circle(0.01).value()}).fault();
  EXPECT_EQ(fault.code, FaultCode::unsupported);
  EXPECT_EQ(*fault.value, 33.0);
}

}  // namespace
}  // namespace hodograph
