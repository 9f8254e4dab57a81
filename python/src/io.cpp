// SPDX-License-Identifier: MIT
// What other programs read and write: worlds and scenes as GeoJSON, tables, missions of drones,
// meshes. io/geojson.hpp, geojson_scene.hpp, table.hpp, geodesy.hpp, mission.hpp, mesh_file.hpp.
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "hodograph/io/geojson.hpp"
#include "hodograph/io/geojson_scene.hpp"
#include "hodograph/io/mesh_file.hpp"
#include "hodograph/io/table.hpp"
#include "python/src/bindings.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;
using File = std::filesystem::path;

std::optional<Point> maybe_point(const std::optional<Doubles>& array, const char* name) {
  if (!array) return std::nullopt;
  return point_of<Point>(*array, name);
}

void bind_worlds(py::module_& m) {
  Record<WorldDocument> document(m, "WorldDocument",
                                 "A world, and the places that its file names.");
  document.def(
      py::init([](const World& world, const std::optional<Doubles>& start,
                  const std::optional<Doubles>& goal) {
        return WorldDocument{world, maybe_point(start, "start"), maybe_point(goal, "goal")};
      }),
      py::arg("world"), py::arg("start") = py::none(), py::arg("goal") = py::none());
  document.field("world", &WorldDocument::world)
      .field("start", &WorldDocument::start, "(2,), or None.")
      .field("goal", &WorldDocument::goal, "(2,), or None.");
  m.def(
      "parse_world",
      [](const std::string& text, const std::string& source) {
        return unlocked([&] { return parse_world(text, source).value(); });
      },
      py::arg("text"), py::arg("source") = "the world",
      "The world of a GeoJSON text (RFC 7946), coordinates taken as they stand. Properties: "
      "\"role\" (obstacle,\nbounds, start, goal, ignored) and \"name\". Raises HodographError: "
      "malformed_document, unsupported, those of World.");
  m.def(
      "load_world",
      [](const File& file) {
        const std::string name = file.string();
        return unlocked([&] { return load_world(name).value(); });
      },
      py::arg("file"), "The same from a file.");
}

void bind_scenes(py::module_& m) {
  Record<GeoJsonPath> path(m, "GeoJsonPath", "A path as a line, with what its properties say.");
  path.def(py::init([](const Doubles& points, const std::string& name, const std::string& kind,
                       std::optional<double> chord_tolerance, const Promises& promises) {
             GeoJsonPath made;
             made.name = name;
             made.kind = kind;
             made.spatial = points.ndim() == 2 && points.shape(1) == 3;
             if (made.spatial) {
               made.points = points_of<Vector3<double>>(points, "points");
             } else {
               for (const Point& p : points_of<Point>(points, "points")) {
                 made.points.push_back({p.x, p.y, 0.0});
               }
             }
             made.chord_tolerance = chord_tolerance;
             made.promises = promises;
             return made;
           }),
           py::arg("points"), py::kw_only(), py::arg("name") = "", py::arg("kind") = "",
           py::arg("chord_tolerance") = py::none(), py::arg("promises") = Promises{},
           "points: (n, 2) or (n, 3); chord_tolerance: how far the path may be from the line.");
  path.field("name", &GeoJsonPath::name)
      .field("kind", &GeoJsonPath::kind)
      .field("points", &GeoJsonPath::points, "(n, 3); z is 0 in the plane.")
      .field("spatial", &GeoJsonPath::spatial)
      .field("chord_tolerance", &GeoJsonPath::chord_tolerance)
      .field("promises", &GeoJsonPath::promises);
  m.def(
      "to_geojson",
      [](const World& world, const std::vector<GeoJsonPath>& paths,
         const std::optional<Doubles>& start, const std::optional<Doubles>& goal,
         const std::optional<GeodeticPoint>& datum, double altitude) {
        const GeoJsonScene scene{
            world, maybe_point(start, "start"), maybe_point(goal, "goal"), paths, datum, altitude};
        return unlocked([&] { return to_geojson(scene).value(); });
      },
      py::arg("world") = World{}, py::arg("paths") = std::vector<GeoJsonPath>{}, py::kw_only(),
      py::arg("start") = py::none(), py::arg("goal") = py::none(), py::arg("datum") = py::none(),
      py::arg("altitude") = 0.0,
      "Paths in a world as GeoJSON, which reads back as the same world. With a datum coordinates "
      "become\nlongitudes and latitudes; `altitude` is the height of what is planar. Raises "
      "HodographError: too_few, not_finite.");
}

/// Names in a header and rows of numbers.
Table table_of(const Doubles& values, std::vector<std::string> names) {
  if (values.ndim() != 2) refuse_shape("values", "(rows, columns)", values);
  Table table;
  table.column_count = static_cast<std::size_t>(values.shape(1));
  if (!names.empty() && names.size() != table.column_count) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "there should be a name for each of " + std::to_string(table.column_count) +
                          " columns; got " + std::to_string(names.size()),
                      std::nullopt, "names", static_cast<double>(names.size()),
                      static_cast<double>(table.column_count)});
  }
  require_finite(numbers(values), "values");
  table.names = std::move(names);
  table.values.assign(numbers(values).begin(), numbers(values).end());
  for (py::ssize_t row = 0; row < values.shape(0); ++row) {
    table.lines.push_back(static_cast<std::uint32_t>(row + 1 + (table.names.empty() ? 0 : 1)));
  }
  return table;
}

void bind_tables(py::module_& m) {
  Record<Table> record(m, "Table", "Rows of finite numbers in named columns.");
  record.field("names", &Table::names, "Of the columns; empty without a header.")
      .field("column_count", &Table::column_count)
      .field("_values", &Table::values)
      .field("lines", &Table::lines, "The line of the text on which each row stands, from 1.")
      .property("row_count", &Table::row_count);
  record
      .def(py::init(&table_of), py::arg("values"), py::arg("names") = std::vector<std::string>{},
           "From values (rows, columns) and the names of the columns.")
      .def_property_readonly(
          "values",
          [](const py::object& self) {
            const auto& table = self.cast<const Table&>();
            return view_of(table.values.data(),
                           {static_cast<py::ssize_t>(table.row_count()),
                            static_cast<py::ssize_t>(table.column_count)},
                           self);
          },
          "(rows, columns). A view.")
      .def(
          "title",
          [](const Table& table, std::size_t column) {
            if (column >= table.column_count) {
              throw py::index_error("the table has " + std::to_string(table.column_count) +
                                    " columns");
            }
            return table.title(column);
          },
          py::arg("column"), "Its name, or its number from 1.")
      .def(
          "column",
          [](const Table& table, const std::string& name) { return table.column(name).value(); },
          py::arg("name"),
          "The column (from 0) with a name, or with a number from 1; case and units do not "
          "matter.");
  m.def(
      "read_table",
      [](const std::string& text, const std::string& source) {
        return unlocked([&] { return read_table(text, source).value(); });
      },
      py::arg("text"), py::arg("source") = "the table",
      "A table from text: fields separated by commas, semicolons, tabs or blanks.\nRaises "
      "HodographError: malformed_document, with line and column.");
  m.def(
      "to_csv", [](const Table& table) { return to_csv(table); }, py::arg("table"),
      "The table as CSV; numbers read back to the same doubles.");
  m.def(
      "unit_of", [](const std::string& name) { return unit_of(name); }, py::arg("column_name"),
      "The unit a name states in brackets: \"TU\" of \"Time (TU)\".");
  Record<CurveSamples>(m, "CurveSamples", "Points of a curve at increasing parameters.")
      .field("parameters", &CurveSamples::parameters)
      .field("_points", &CurveSamples::points)
      .field("dimension", &CurveSamples::dimension)
      .field("parameter_unit", &CurveSamples::parameter_unit)
      .field("length_unit", &CurveSamples::length_unit)
      .property(
          "points",
          [](const CurveSamples& s) {
            Doubles rows(
                {static_cast<py::ssize_t>(s.points.size()), static_cast<py::ssize_t>(s.dimension)});
            double* to = rows.mutable_data();
            for (const auto& p : s.points) {
              for (std::size_t i = 0; i < s.dimension; ++i) *to++ = p[i];
            }
            return rows;
          },
          "(n, 2) or (n, 3).");
  m.def(
      "curve_samples",
      [](const Table& table, const std::string& parameter,
         const std::vector<std::string>& coordinates, const std::string& source) {
        return curve_samples(table, {parameter, coordinates}, source).value();
      },
      py::arg("table"), py::kw_only(), py::arg("parameter") = "",
      py::arg("coordinates") = std::vector<std::string>{}, py::arg("source") = "the table",
      "The samples that a table holds: by default the first column is the parameter, x, y and z "
      "(or those\nafter it) the coordinates. Raises HodographError: malformed_document, too_few, "
      "not_increasing.");
}

void bind_mesh_files(py::module_& m) {
  py::enum_<MeshFormat>(m, "MeshFormat", "Files of triangle meshes.")
      .value("stl", MeshFormat::stl, "Binary STL, single precision.")
      .value("obj", MeshFormat::obj, "Wavefront OBJ, with normals.")
      .value("glb", MeshFormat::glb, "Binary glTF 2.0, with normals, single precision.");
  m.def(
      "mesh_format_of", [](const std::string& name) { return mesh_format_of(name); },
      py::arg("file_name"), "The format that a suffix tells; None for others.");
  m.def(
      "save_mesh",
      [](const TriangleMesh& mesh, const File& file, std::optional<MeshFormat> format,
         const std::string& name) {
        const std::string path = file.string();
        if (!format) format = mesh_format_of(path);
        if (!format) {
          throw Error(Fault{FaultCode::unsupported,
                            path + " should end in .stl, .obj or .glb, or the format be given",
                            std::nullopt, "file", std::nullopt, std::nullopt});
        }
        if (const auto fault = unlocked([&] { return save_mesh(mesh, *format, name, path); })) {
          throw Error(*fault);
        }
      },
      py::arg("mesh"), py::arg("file"), py::kw_only(), py::arg("format") = py::none(),
      py::arg("name") = "",
      "Writes a mesh as STL, OBJ or glTF, by the file's suffix unless the format is given; in one "
      "step.");
  m.def(
      "mesh_bytes",
      [](const TriangleMesh& mesh, MeshFormat format, const std::string& name) {
        std::string bytes;
        const auto append = [&bytes](std::string_view part) { bytes += part; };
        if (const auto fault = unlocked([&] { return write_mesh(mesh, format, name, append); })) {
          throw Error(*fault);
        }
        return py::bytes(bytes);
      },
      py::arg("mesh"), py::arg("format"), py::kw_only(), py::arg("name") = "",
      "The bytes of such a file.");
  m.def("rounding_of", &rounding_of, py::arg("mesh"), py::arg("format"),
        "How far the positions of the file may be from those of the mesh: 0 for OBJ.");
}

}  // namespace

void bind_io(py::module_& m) {
  bind_worlds(m);
  bind_scenes(m);
  bind_tables(m);
  bind_mesh_files(m);
}

}  // namespace hodograph::python
