// SPDX-License-Identifier: MIT
#include "hodograph/cad/step.hpp"

#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_Sewing.hxx>
#include <BRepLib.hxx>
#include <BRep_Builder.hxx>
#include <Geom_BSplineCurve.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_PrinterOStream.hxx>
#include <Precision.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <Standard_Failure.hxx>
#include <StepData_Protocol.hxx>
#include <StepData_StepModel.hxx>
#include <StepData_StepWriter.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TColStd_Array2OfReal.hxx>
#include <TColgp_Array1OfPnt.hxx>
#include <TColgp_Array2OfPnt.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>
#include <UnitsMethods.hxx>
#include <algorithm>
#include <cmath>
#include <gp_Pln.hxx>
#include <mutex>
#include <sstream>
#include <vector>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/io/file.hpp"

namespace hodograph {
namespace {

Fault failure(const std::string& what) {
  return {FaultCode::not_written, what, std::nullopt, "step", std::nullopt, std::nullopt};
}

gp_Pnt point(const Vector3<double>& p) { return {p.x, p.y, p.z}; }

int whole(std::size_t n) { return static_cast<int>(n); }

struct Knots {
  TColStd_Array1OfReal values{1, 2};
  TColStd_Array1OfInteger multiplicities{1, 2};
  Knots(double begin, double end, std::size_t degree) {
    values(1) = begin;
    values(2) = end;
    multiplicities(1) = multiplicities(2) = whole(degree + 1);
  }
};

/// The patch with v of ours as U of theirs reversed: their normal is U × V, ours S_u × S_v.
Handle(Geom_BSplineSurface) surface_of(const RationalPatch& patch) {
  const std::size_t rows = patch.degree_u + 1, columns = patch.degree_v + 1;
  TColgp_Array2OfPnt poles(1, whole(rows), 1, whole(columns));
  TColStd_Array2OfReal weights(1, whole(rows), 1, whole(columns));
  const auto control = patch.control_points();
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      poles(whole(j + 1), whole(i + 1)) = point(control[patch.index(i, j)]);
      weights(whole(j + 1), whole(i + 1)) = patch.weights[patch.index(i, j)];
    }
  }
  const Knots u(patch.begin_u, patch.end_u, patch.degree_u);
  const Knots v(patch.begin_v, patch.end_v, patch.degree_v);
  return new Geom_BSplineSurface(poles, weights, u.values, v.values, u.multiplicities,
                                 v.multiplicities, whole(patch.degree_u), whole(patch.degree_v));
}

/// The boundary of a patch at the begin or end of v.
Handle(Geom_BSplineCurve) end_curve(const RationalPatch& patch, bool at_end) {
  const std::size_t i = at_end ? patch.degree_v : 0, count = patch.degree_u + 1;
  TColgp_Array1OfPnt poles(1, whole(count));
  TColStd_Array1OfReal weights(1, whole(count));
  for (std::size_t j = 0; j < count; ++j) {
    const double weight = patch.weights[patch.index(i, j)];
    poles(whole(j + 1)) = point((1.0 / weight) * patch.weighted[patch.index(i, j)]);
    weights(whole(j + 1)) = weight;
  }
  const Knots u(patch.begin_u, patch.end_u, patch.degree_u);
  return new Geom_BSplineCurve(poles, weights, u.values, u.multiplicities, whole(patch.degree_u));
}

TopoDS_Face cap_of(const std::vector<RationalPatch>& patches, std::size_t first, std::size_t count,
                   bool at_end, const MotionState& state) {
  BRepBuilderAPI_MakeWire wire;
  for (std::size_t k = 0; k < count; ++k) {
    wire.Add(BRepBuilderAPI_MakeEdge(end_curve(patches[first + k], at_end)).Edge());
  }
  const Vector3<double> normal = at_end ? state.frame.e1 : -state.frame.e1;
  const gp_Pln plane(point(state.position), gp_Dir(normal.x, normal.y, normal.z));
  return BRepBuilderAPI_MakeFace(plane, wire.Wire(), Standard_True).Face();
}

/// The name of a unit as OpenCASCADE writes it, and its length in millimetres.
struct Unit {
  const char* name;
  double millimetres;
};
Unit unit_of(const std::string& name) {
  constexpr Unit known[] = {{"MM", 1.0},   {"CM", 10.0},   {"M", 1000.0},
                            {"KM", 1.0e6}, {"INCH", 25.4}, {"FT", 304.8}};
  const char* const names[] = {"mm", "cm", "m", "km", "in", "ft"};
  for (std::size_t i = 0; i < std::size(names); ++i) {
    if (name == names[i]) return known[i];
  }
  return known[0];
}

/// Patches for sewing: a face whose opposite sides are the same edge is halved.
std::vector<RationalPatch> parted(const Sweep& sweep, std::vector<RationalPatch> patches,
                                  std::size_t& columns) {
  columns = sweep.profile.pieces().size();
  constexpr std::size_t enough = 3;
  if (sweep.profile.is_closed() && columns < enough) {
    std::vector<RationalPatch> parts;
    for (const auto& patch : patches) {
      for (std::size_t i = 0; i < enough; ++i) {
        const double from = static_cast<double>(i) / enough;
        const double to = i + 1 == enough ? 1.0 : static_cast<double>(i + 1) / enough;
        parts.push_back(patch.restricted_u(from, to));
      }
    }
    patches = std::move(parts);
    columns *= enough;
  }
  if (sweep.motion.is_closed() && patches.size() / columns < enough) {
    std::vector<RationalPatch> parts;
    for (std::size_t row = 0; row < patches.size(); row += columns) {
      for (std::size_t i = 0; i < enough; ++i) {
        const double from = static_cast<double>(i) / enough;
        const double to = i + 1 == enough ? 1.0 : static_cast<double>(i + 1) / enough;
        for (std::size_t k = 0; k < columns; ++k) {
          parts.push_back(patches[row + k].restricted_v(from, to));
        }
      }
    }
    patches = std::move(parts);
  }
  return patches;
}

/// OpenCASCADE's settings of STEP are global: one writer at a time, and it keeps quiet.
std::mutex& writer_mutex() {
  static std::mutex mutex;
  return mutex;
}

std::string written(const TopoDS_Shape& shape, const StepOptions& options) {
  const std::lock_guard<std::mutex> lock(writer_mutex());
  Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_PrinterOStream));
  STEPControl_Controller::Init();
  const Unit unit = unit_of(options.length_unit);
  // Numbers stay as they are: the unit of the file is the one they are in.
  Interface_Static::SetCVal("xstep.cascade.unit", unit.name);
  Interface_Static::SetCVal("write.step.unit", unit.name);
  UnitsMethods::SetCasCadeLengthUnit(unit.millimetres);
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
  Interface_Static::SetCVal("write.step.product.name",
                            options.name.empty() ? "sweep" : options.name.c_str());
  // Curves in parameter planes are not needed: readers make their own.
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) return {};
  const Handle(StepData_StepModel) model = writer.Model();
  StepData_StepWriter text(model);
  text.FloatWriter().SetFormat("%.16E");
  text.SendModel(Handle(StepData_Protocol)::DownCast(model->Protocol()));
  std::ostringstream out;
  if (!text.Print(out)) return {};
  return out.str();
}

}  // namespace

Result<StepModel> step_of(const Sweep& sweep, const StepOptions& options) {
  const auto exact = rational_patches(sweep);
  if (!exact) return exact.fault();
  StepModel model;
  for (const auto& patch : *exact) {
    model.degree_along = std::max(model.degree_along, patch.degree_v);
    model.degree_round = std::max(model.degree_round, patch.degree_u);
  }
  if (std::max(model.degree_along, model.degree_round) > largest_cad_degree) {
    const std::size_t degree = std::max(model.degree_along, model.degree_round);
    return Fault{FaultCode::unsupported,
                 "the exact surface has degree " + std::to_string(degree) +
                     ", and CAD programs take at most " + std::to_string(largest_cad_degree) +
                     "; write a mesh, or sweep along a path of lower degree",
                 std::nullopt,
                 "degree",
                 static_cast<double>(degree),
                 static_cast<double>(largest_cad_degree)};
  }
  std::size_t columns = 0;
  const auto patches = parted(sweep, *exact, columns);
  double size = 0.0;
  for (const auto& patch : patches) {
    for (const auto& p : patch.control_points()) size = std::max(size, largest_component(p));
  }
  // Edges of neighbours are the same curves but for rounding; nothing else comes so near.
  constexpr double rounding_of_curves = 0x1p-30;  // of the largest coordinate: 2^22 roundings
  const double tolerance = std::max(rounding_of_curves * size, Precision::Confusion());
  try {
    BRepBuilderAPI_Sewing sewing(tolerance);
    for (const auto& patch : patches) {
      const BRepBuilderAPI_MakeFace face(surface_of(patch), tolerance);
      if (!face.IsDone()) return failure("OpenCASCADE could not make a face of a patch");
      sewing.Add(face.Face());
      ++model.faces;
    }
    const bool caps = options.caps && !sweep.motion.is_closed() && sweep.profile.is_closed() &&
                      sweep.profile.is_planar();
    if (caps) {
      const auto& pieces = sweep.motion.pieces();
      sewing.Add(cap_of(patches, 0, columns, false, sweep.motion.at(0, 0.0)));
      sewing.Add(cap_of(patches, patches.size() - columns, columns, true,
                        sweep.motion.at(pieces.size() - 1, 1.0)));
      model.faces += 2;
    }
    sewing.Perform();
    TopoDS_Shape shape = sewing.SewedShape();
    const bool closes = sweep.profile.is_closed() && (caps || sweep.motion.is_closed());
    if (closes) {
      if (sewing.NbFreeEdges() != 0 || shape.ShapeType() != TopAbs_SHELL) {
        return failure("OpenCASCADE could not sew the faces to a closed shell: " +
                       std::to_string(sewing.NbFreeEdges()) + " edges are free");
      }
      TopoDS_Solid solid;
      BRep_Builder builder;
      builder.MakeSolid(solid);
      builder.Add(solid, TopoDS::Shell(shape));
      if (!BRepLib::OrientClosedSolid(solid)) {
        return failure("OpenCASCADE could not orient the solid");
      }
      shape = solid;
      model.solid = true;
    }
    model.text = written(shape, options);
  } catch (const Standard_Failure& error) {
    return failure(std::string("OpenCASCADE: ") + error.GetMessageString());
  }
  if (model.text.empty()) return failure("OpenCASCADE could not write the model");
  return model;
}

Result<StepModel> save_step(const Sweep& sweep, const StepOptions& options,
                            const std::string& path) {
  auto model = step_of(sweep, options);
  if (!model) return model;
  if (auto fault = write_file(path, model->text)) return *fault;
  return model;
}

}  // namespace hodograph
