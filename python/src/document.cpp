// SPDX-License-Identifier: MIT
// Path documents with all their members and promises: io/document.hpp.
#include "hodograph/io/document.hpp"

#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/src/bindings.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Roll = LinearRoll<double>;

PathDocument document_of(const AnyPath& path, const std::string& name,
                         const std::string& length_unit, const std::string& parameter_unit) {
  PathDocument document{path};
  document.name = name;
  document.length_unit = length_unit;
  document.parameter_unit = parameter_unit;
  return document;
}

void save(const PathDocument& document, const std::filesystem::path& file) {
  const std::string name = file.string();
  if (const auto fault = unlocked([&] { return save_document(document, name); })) {
    throw Error(*fault);
  }
}

void bind_provenance(py::module_& m) {
  Record<Roll> roll(m, "LinearRoll",
                    "A roll theta = theta_begin + rate (xi - xi_begin) of a frame against the "
                    "Euler-Rodrigues frame, radians.");
  roll.def(py::init([](double xi_begin, double theta_begin, double rate) {
             const double all[] = {xi_begin, theta_begin, rate};
             require_finite(all, "the roll");
             return Roll{xi_begin, theta_begin, rate};
           }),
           py::arg("xi_begin"), py::arg("theta_begin"), py::arg("rate"));
  roll.field("xi_begin", &Roll::xi_begin)
      .field("theta_begin", &Roll::theta_begin)
      .field("rate", &Roll::rate)
      .def(
          "angle", [](const Roll& self, double xi) { return self.angle(xi); }, py::arg("xi"),
          "theta(xi), radians.");
  Record<Provenance> provenance(m, "Provenance",
                                "How a path was made; every member free text or absent.");
  provenance.def(
      py::init([](const std::string& program, const std::string& source, const std::string& method,
                  const std::string& choice, std::optional<double> tolerance) {
        return Provenance{program, source, method, choice, tolerance};
      }),
      py::kw_only(), py::arg("program") = "", py::arg("source") = "", py::arg("method") = "",
      py::arg("choice") = "", py::arg("tolerance") = py::none());
  provenance.field("program", &Provenance::program, "What wrote the document.")
      .field("source", &Provenance::source, "The data the path stands for.")
      .field("method", &Provenance::method, "The construction.")
      .field("choice", &Provenance::choice, "Its free parameters.")
      .field("tolerance", &Provenance::tolerance, "The position error asked for.");
}

void bind_single_promises(py::module_& m) {
  Record<ContinuityOrders> orders(
      m, "ContinuityOrders",
      "The derivatives that are continuous at every knot; 0 is the value itself, -1 means it "
      "jumps.");
  orders.def(py::init([](int position, int preimage, int frame, int angular_velocity) {
               return ContinuityOrders{position, preimage, frame, angular_velocity};
             }),
             py::kw_only(), py::arg("position") = 0, py::arg("preimage") = -1,
             py::arg("frame") = -1, py::arg("angular_velocity") = -1);
  orders.field("position", &ContinuityOrders::position)
      .field("preimage", &ContinuityOrders::preimage)
      .field("frame", &ContinuityOrders::frame)
      .field("angular_velocity", &ContinuityOrders::angular_velocity);
  Record<ErrorPromise> error(m, "ErrorPromise",
                             "The largest distance between a path and what it stands for.");
  error.def(py::init([](const Enclosure& distance, bool certified, const std::string& against) {
              return ErrorPromise{distance, certified, against};
            }),
            py::arg("distance"), py::arg("certified") = false, py::arg("against") = "");
  error.field("distance", &ErrorPromise::distance)
      .field("certified", &ErrorPromise::certified, "Else it is an estimate from samples.")
      .field("against", &ErrorPromise::against, "What the path was compared with.");
  Record<ObstacleDistance> distance(m, "ObstacleDistance",
                                    "The distance of the whole path from one obstacle of a world.");
  distance.def(py::init([](std::size_t obstacle, const Enclosure& enclosed) {
                 return ObstacleDistance{obstacle, enclosed};
               }),
               py::arg("obstacle"), py::arg("distance"));
  distance.field("obstacle", &ObstacleDistance::obstacle, "Its number in the world.")
      .field("distance", &ObstacleDistance::distance);
  Record<ClearancePromise> clearance(m, "ClearancePromise",
                                     "How far a path stays from the obstacles of a world.");
  clearance.def(
      py::init([](const std::string& world, double reach, std::vector<ObstacleDistance> obstacles,
                  std::optional<Enclosure> bounds) {
        return ClearancePromise{world, reach, std::move(obstacles), bounds};
      }),
      py::kw_only(), py::arg("world") = "", py::arg("reach") = 0.0,
      py::arg("obstacles") = std::vector<ObstacleDistance>{}, py::arg("bounds") = py::none());
  clearance.field("world", &ClearancePromise::world, "The file that holds the world.")
      .field("reach", &ClearancePromise::reach, "Everything that is not listed is so far.")
      .field("obstacles", &ClearancePromise::obstacles, "In ascending order.")
      .field("bounds", &ClearancePromise::bounds, "The distance from the bounds, inside them.");
  Record<HelixSine> sine(m, "HelixSine",
                         "From a segment on, the sine of the climb angle is in `sine`.");
  sine.def(py::init([](std::size_t first_segment, const Enclosure& enclosed) {
             return HelixSine{first_segment, enclosed};
           }),
           py::arg("first_segment"), py::arg("sine"));
  sine.field("first_segment", &HelixSine::first_segment).field("sine", &HelixSine::sine);
  Record<HelixPromise> helix(m, "HelixPromise",
                             "A path of constant climb, or of several angles in turn.");
  helix.def(py::init([](const std::optional<Doubles>& axis, std::vector<HelixSine> sines) {
              HelixPromise promise;
              if (axis) promise.axis = point_of<Vector3<double>>(*axis, "axis");
              promise.sines = std::move(sines);
              return promise;
            }),
            py::kw_only(), py::arg("axis") = py::none(),
            py::arg("sines") = std::vector<HelixSine>{});
  helix.field("axis", &HelixPromise::axis, "(3,); (0, 0, 1) unless given.")
      .field("sines", &HelixPromise::sines, "In ascending order, the first from segment 0 on.");
}

void bind_promises(py::module_& m) {
  Record<Promises> promises(m, "Promises", "What a path promises; None means that nothing is.");
  promises
      .def(py::init(
               [](std::optional<ContinuityOrders> continuity, std::optional<ErrorPromise> error,
                  std::optional<Enclosure> arc_length, std::optional<Enclosure> smallest_speed,
                  std::optional<Enclosure> largest_speed, std::optional<double> curvature_bound,
                  const std::optional<Doubles>& end, std::optional<Enclosure> largest_curvature,
                  std::optional<ClearancePromise> clearance, std::optional<HelixPromise> helix) {
                 std::optional<Vector3<double>> place;
                 if (end) place = point_of<Vector3<double>>(*end, "end");
                 return Promises{continuity,      std::move(error),  arc_length,
                                 smallest_speed,  largest_speed,     curvature_bound,
                                 place,           largest_curvature, std::move(clearance),
                                 std::move(helix)};
               }),
           py::kw_only(), py::arg("continuity") = py::none(), py::arg("error") = py::none(),
           py::arg("arc_length") = py::none(), py::arg("smallest_speed") = py::none(),
           py::arg("largest_speed") = py::none(), py::arg("curvature_bound") = py::none(),
           py::arg("end") = py::none(), py::arg("largest_curvature") = py::none(),
           py::arg("clearance") = py::none(), py::arg("helix") = py::none())
      .def("empty", &Promises::empty, "True where nothing is promised.");
  promises.field("continuity", &Promises::continuity)
      .field("error", &Promises::error)
      .field("arc_length", &Promises::arc_length, "Of the whole path.")
      .field("smallest_speed", &Promises::smallest_speed)
      .field("largest_speed", &Promises::largest_speed)
      .field("curvature_bound", &Promises::curvature_bound, "|kappa| is at most this.")
      .field("end", &Promises::end, "Where the path ends, (3,); z is 0 in the plane.")
      .field("largest_curvature", &Promises::largest_curvature)
      .field("clearance", &Promises::clearance)
      .field("helix", &Promises::helix);
}

void bind_path_document(py::module_& m) {
  Record<PathDocument> document(m, "PathDocument",
                                "A path and all that belongs to it. Texts are UTF-8.",
                                PathDocument{unit_line()});
  document.def(
      py::init([](const AnyPath& path, const std::string& name, const std::string& length_unit,
                  const std::string& parameter_unit, std::optional<Roll> roll,
                  const Provenance& provenance, const Promises& promises) {
        PathDocument made = document_of(path, name, length_unit, parameter_unit);
        made.roll = roll;
        made.provenance = provenance;
        made.promises = promises;
        return made;
      }),
      py::arg("path"), py::kw_only(), py::arg("name") = "", py::arg("length_unit") = "",
      py::arg("parameter_unit") = "", py::arg("roll") = py::none(),
      py::arg("provenance") = Provenance{}, py::arg("promises") = Promises{});
  document.field("path", &PathDocument::path)
      .field("name", &PathDocument::name)
      .field("length_unit", &PathDocument::length_unit, "Of positions and arc length: \"m\".")
      .field("parameter_unit", &PathDocument::parameter_unit, "Of xi: \"s\".")
      .field("roll", &PathDocument::roll, "The frame's roll, in space.")
      .field("provenance", &PathDocument::provenance)
      .field("promises", &PathDocument::promises);
}

}  // namespace

void bind_document(py::module_& m) {
  bind_provenance(m);
  bind_single_promises(m);
  bind_promises(m);
  bind_path_document(m);
  m.attr("document_format") = std::string(document_format);
  m.attr("document_version") = document_version;

  m.def(
      "to_json", [](const PathDocument& document) { return to_json(document); },
      py::arg("document"), "The document as JSON text; it reads back bit for bit.");
  m.def(
      "to_json",
      [](const AnyPath& path, const std::string& name, const std::string& length_unit,
         const std::string& parameter_unit) {
        return to_json(document_of(path, name, length_unit, parameter_unit));
      },
      py::arg("path"), py::kw_only(), py::arg("name") = "", py::arg("length_unit") = "",
      py::arg("parameter_unit") = "", "The document of a path as JSON text.");
  m.def(
      "parse_document",
      [](const std::string& text, const std::string& source) {
        return unlocked([&] { return parse_document(text, source).value(); });
      },
      py::arg("text"), py::arg("source") = "the document",
      "The document of a JSON text; `source` is how sentences call it.\nRaises HodographError: "
      "malformed_document (line and column, or the JSON pointer), unsupported.");
  m.def(
      "load_document",
      [](const std::filesystem::path& file) {
        const std::string name = file.string();
        return unlocked([&] { return load_document(name).value(); });
      },
      py::arg("file"), "The document in a file.");
  m.def("save_document", &save, py::arg("document"), py::arg("file"),
        "Writes the document, in one step: the old file is whole until the new one is.\nRaises "
        "HodographError: not_written.");
  m.def(
      "save_document",
      [](const AnyPath& path, const std::filesystem::path& file, const std::string& name,
         const std::string& length_unit, const std::string& parameter_unit) {
        save(document_of(path, name, length_unit, parameter_unit), file);
      },
      py::arg("path"), py::arg("file"), py::kw_only(), py::arg("name") = "",
      py::arg("length_unit") = "", py::arg("parameter_unit") = "",
      "Writes the document of a path likewise.");
}

}  // namespace hodograph::python
