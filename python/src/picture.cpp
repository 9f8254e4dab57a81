// SPDX-License-Identifier: MIT
// Pictures without any other library: curves in axes as SVG, drawings as DXF, meshes as SVG.
// io/svg.hpp, io/dxf.hpp, io/mesh_picture.hpp.
#include <optional>
#include <string>
#include <vector>

#include "hodograph/io/dxf.hpp"
#include "hodograph/io/mesh_picture.hpp"
#include "hodograph/io/svg.hpp"
#include "python/src/bindings.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

void bind_enums(py::module_& m) {
  py::enum_<PlotColor>(m, "PlotColor", "The colours of a picture, in the order series take them.")
      .value("blue", PlotColor::blue)
      .value("vermilion", PlotColor::vermilion)
      .value("green", PlotColor::green)
      .value("purple", PlotColor::purple)
      .value("gold", PlotColor::gold)
      .value("grey", PlotColor::grey);
  py::enum_<SeriesStyle>(m, "SeriesStyle", "How a series is drawn.")
      .value("line", SeriesStyle::line)
      .value("dashed_line", SeriesStyle::dashed_line)
      .value("thin_line", SeriesStyle::thin_line)
      .value("dots", SeriesStyle::dots);
  py::enum_<Projection>(m, "Projection", "Two axes of space to look at.")
      .value("xy", Projection::xy)
      .value("xz", Projection::xz)
      .value("yz", Projection::yz);
}

void bind_series(py::module_& m) {
  Record<Series> series(m, "Series",
                        "One curve of a picture: points (x_i, y_i) in order; one that is not "
                        "finite makes a gap.");
  series.def(py::init([](const Doubles& x, const Doubles& y, const std::string& label,
                         SeriesStyle style, std::optional<PlotColor> color) {
               Series made{label, numbers_of(x, "x"), numbers_of(y, "y"), style, color};
               if (made.x.size() != made.y.size()) refuse_shape("y", "that of x", y);
               return made;
             }),
             py::arg("x"), py::arg("y"), py::kw_only(), py::arg("label") = "",
             py::arg("style") = SeriesStyle::line, py::arg("color") = py::none(),
             "color: the next one unless given.");
  series.field("x", &Series::x)
      .field("y", &Series::y)
      .field("label", &Series::label, "In the legend; empty: not in it.")
      .field("style", &Series::style)
      .field("color", &Series::color);
  Record<PlotMark> mark(m, "PlotMark", "A dot with a name.");
  mark.def(py::init([](const Doubles& at, const std::string& label, PlotColor color) {
             return PlotMark{point_of<Point>(at, "at"), label, color};
           }),
           py::arg("at"), py::arg("label") = "", py::arg("color") = PlotColor::grey);
  mark.field("at", &PlotMark::at, "(2,).")
      .field("label", &PlotMark::label)
      .field("color", &PlotMark::color);
  Record<PlotLevel> level(m, "PlotLevel", "A horizontal line across the picture.");
  level.def(py::init([](double y, const std::string& label) {
              return PlotLevel{y, label};
            }),
            py::arg("y"), py::arg("label") = "");
  level.field("y", &PlotLevel::y).field("label", &PlotLevel::label);
  Record<PlotAxis> axis(m, "PlotAxis", "An axis of a picture.");
  axis.def(py::init([](const std::string& label, bool logarithmic) {
             return PlotAxis{label, logarithmic};
           }),
           py::arg("label") = "", py::arg("logarithmic") = false);
  axis.field("label", &PlotAxis::label).field("logarithmic", &PlotAxis::logarithmic);
}

void bind_arrows(py::module_& m) {
  Record<Arrows> record(m, "Arrows", "Arrows of one colour, for example a vector of a frame.");
  record.field("label", &Arrows::label)
      .field("color", &Arrows::color)
      .field("_from_to", &Arrows::from_to);
  record
      .def(py::init([](const Doubles& from_points, const Doubles& to_points,
                       const std::string& label, PlotColor color) {
             const auto from = points_of<Point>(from_points, "from_points");
             const auto to = points_of<Point>(to_points, "to_points");
             if (from.size() != to.size()) {
               refuse_shape("to_points", "that of from_points", to_points);
             }
             Arrows made{label, color, {}};
             for (std::size_t i = 0; i < from.size(); ++i) made.from_to.push_back({from[i], to[i]});
             return made;
           }),
           py::arg("from_points"), py::arg("to_points"), py::kw_only(), py::arg("label") = "",
           py::arg("color") = PlotColor::vermilion)
      .def_property_readonly("from_points",
                             [](const Arrows& arrows) {
                               std::vector<Point> points;
                               for (const auto& one : arrows.from_to) points.push_back(one.first);
                               return points;
                             })
      .def_property_readonly("to_points", [](const Arrows& arrows) {
        std::vector<Point> points;
        for (const auto& one : arrows.from_to) points.push_back(one.second);
        return points;
      });
}

void bind_plot(py::module_& m) {
  Record<Plot> plot(m, "Plot",
                    "A picture of curves in axes; the ranges follow from what it shows.");
  const Plot usual{};
  plot.def(py::init([](std::vector<Series> series, const std::string& title, const PlotAxis& x,
                       const PlotAxis& y, std::vector<Arrows> arrows, std::vector<PlotMark> marks,
                       std::vector<PlotLevel> levels, const Doubles& x_marks, bool equal_aspect,
                       bool clip_outliers, double width, double height) {
             const double sizes[] = {width, height};
             require_finite(sizes, "width and height");
             if (!(width > 0.0 && height > 0.0)) {
               throw Error(Fault{FaultCode::outside_domain,
                                 "a picture's width and height are positive; got " +
                                     to_text(width) + " and " + to_text(height),
                                 std::nullopt, "width", width, 0.0});
             }
             return Plot{title,
                         x,
                         y,
                         std::move(series),
                         std::move(arrows),
                         std::move(marks),
                         std::move(levels),
                         numbers_of(x_marks, "x_marks"),
                         equal_aspect,
                         clip_outliers,
                         width,
                         height};
           }),
           py::arg("series") = std::vector<Series>{}, py::kw_only(), py::arg("title") = "",
           py::arg("x") = PlotAxis{}, py::arg("y") = PlotAxis{},
           py::arg("arrows") = std::vector<Arrows>{}, py::arg("marks") = std::vector<PlotMark>{},
           py::arg("levels") = std::vector<PlotLevel>{}, py::arg("x_marks") = std::vector<double>{},
           py::arg("equal_aspect") = false, py::arg("clip_outliers") = false,
           py::arg("width") = usual.width, py::arg("height") = usual.height,
           "x_marks: short lines on the lower edge; width, height: pixels of 1/96 inch.");
  plot.field("title", &Plot::title)
      .field("x", &Plot::x)
      .field("y", &Plot::y)
      .field("series", &Plot::series)
      .field("arrows", &Plot::arrows)
      .field("marks", &Plot::marks)
      .field("levels", &Plot::levels)
      .field("x_marks", &Plot::x_marks)
      .field("equal_aspect", &Plot::equal_aspect)
      .field("clip_outliers", &Plot::clip_outliers)
      .field("width", &Plot::width)
      .field("height", &Plot::height);
  m.def(
      "to_svg", [](const Plot& one) { return to_svg(one); }, py::arg("plot"),
      "A whole SVG file of one picture.");
  m.def(
      "to_svg",
      [](const std::vector<Plot>& plots, std::size_t columns) {
        if (plots.empty() || columns == 0) {
          throw Error(Fault{FaultCode::too_few,
                            "there should be at least one picture and one column", std::nullopt,
                            "plots", static_cast<double>(plots.size()), 1.0});
        }
        return to_svg(plots, columns);
      },
      py::arg("plots"), py::arg("columns"), "Of several pictures in a grid, row by row.");
  m.def(
      "svg_element", [](const Plot& one) { return svg_element(one); }, py::arg("plot"),
      "The picture as an <svg> element for a page that contains plot_style() in a <style>.");
  m.def(
      "plot_style", [] { return std::string(plot_style()); },
      "The style sheet (CSS) of the pictures.");
  m.def(
      "escaped_markup", [](const std::string& text) { return escaped_markup(text); },
      py::arg("text"), "Text with the characters that mean something in XML escaped.");
}

/// The polyline of points (n, 2) or (n, 3) with frames (k, d, d), the axes as columns.
FramedPolyline framed(const Doubles& points, const std::optional<Doubles>& origins,
                      const std::optional<Doubles>& frames, const std::optional<Doubles>& knots,
                      bool closed) {
  const auto in_space = [](const Doubles& array, const char* name) {
    if (array.ndim() == 2 && array.shape(1) == 3) return points_of<Vector3<double>>(array, name);
    std::vector<Vector3<double>> result;
    for (const Point& p : points_of<Point>(array, name)) result.push_back({p.x, p.y, 0.0});
    return result;
  };
  FramedPolyline made;
  made.points = in_space(points, "points");
  if (origins) made.frame_origins = in_space(*origins, "frame_origins");
  if (knots) made.knots = in_space(*knots, "knots");
  made.closed = closed;
  const std::size_t count = made.frame_origins.size();
  if (!frames) {
    if (count > 0) refuse_shape("frame_origins", "(0, 3) without frames", *origins);
    return made;
  }
  const py::ssize_t d = frames->ndim() == 3 ? frames->shape(1) : 0;
  if ((d != 2 && d != 3) || frames->shape(2) != d ||
      frames->shape(0) != static_cast<py::ssize_t>(count)) {
    refuse_shape("frames",
                 "(" + std::to_string(count) + ", 3, 3) or (" + std::to_string(count) +
                     ", 2, 2), one for each origin",
                 *frames);
  }
  const auto side = static_cast<std::size_t>(d);
  for (std::size_t k = 0; k < count; ++k) {
    Frame3<double> frame{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (std::size_t i = 0; i < side; ++i) {
      const double* row = frames->data() + (k * side + i) * side;
      frame.e1[i] = row[0];
      frame.e2[i] = row[1];
      if (side == 3) frame.e3[i] = row[2];
    }
    made.frames.push_back(frame);
  }
  return made;
}

void bind_framed_polyline(py::module_& m) {
  Record<FramedPolyline> curve(m, "FramedPolyline",
                               "A curve in space (or in the plane z = 0) as points, with frames at "
                               "some of them.");
  curve.def(py::init(&framed), py::arg("points"), py::kw_only(),
            py::arg("frame_origins") = py::none(), py::arg("frames") = py::none(),
            py::arg("knots") = py::none(), py::arg("closed") = false,
            "points, frame_origins, knots: (n, 2) or (n, 3); frames: (k, d, d), the axes as "
            "columns.");
  curve.field("points", &FramedPolyline::points, "(n, 3).")
      .field("frame_origins", &FramedPolyline::frame_origins, "(k, 3).")
      .field("frames", &FramedPolyline::frames, "The axes as columns, (3, 3) each.")
      .field("knots", &FramedPolyline::knots, "Drawn as dots, (m, 3).")
      .field("closed", &FramedPolyline::closed);
  m.def("projected", &projected, py::arg("curve"), py::arg("projection"),
        py::arg("length_unit") = "", py::arg("arrow_fraction") = 0.07,
        "A curve seen along one axis, with equal scales.");
  m.def("plane_picture", &plane_picture, py::arg("curve"), py::arg("length_unit") = "",
        "A plane curve with its tangent and normal.");
}

void bind_dxf(py::module_& m) {
  py::enum_<DxfUnit>(m, "DxfUnit", "The unit of a drawing's coordinates.")
      .value("none", DxfUnit::none)
      .value("inch", DxfUnit::inch)
      .value("foot", DxfUnit::foot)
      .value("millimetre", DxfUnit::millimetre)
      .value("centimetre", DxfUnit::centimetre)
      .value("metre", DxfUnit::metre)
      .value("kilometre", DxfUnit::kilometre);
  m.def(
      "dxf_unit", [](const std::string& name) { return dxf_unit(name); }, py::arg("name"),
      "The unit that a name means: \"mm\", \"cm\", \"m\", \"km\", \"in\", \"ft\".");
  Record<DxfCurves> record(m, "DxfCurves", "Curves on one layer of a drawing.");
  record.def(py::init([](std::vector<RationalBezier> pieces, const std::string& layer, int color) {
               return DxfCurves{layer, color, std::move(pieces)};
             }),
             py::arg("pieces"), py::kw_only(), py::arg("layer") = "", py::arg("color") = 7,
             "pieces: in sequence; color: of the layer, 1 to 255 in AutoCAD's index.");
  record.field("layer", &DxfCurves::layer)
      .field("color", &DxfCurves::color)
      .field("pieces", &DxfCurves::pieces);
  m.def(
      "to_dxf",
      [](const std::vector<DxfCurves>& curves, DxfUnit unit) {
        return unlocked([&] { return to_dxf(curves, unit).value(); });
      },
      py::arg("curves"), py::arg("unit") = DxfUnit::none,
      "Rational Bezier curves as exact SPLINE entities of an ASCII DXF (AC1015); pieces that join "
      "become one.\nRaises HodographError: mismatched_size, outside_domain, not_finite.");
}

void bind_mesh_picture(py::module_& m) {
  const MeshView usual{};
  m.def(
      "mesh_svg",
      [](const TriangleMesh& mesh, double azimuth, double elevation, double width, double height,
         double margin, bool closed) {
        const double all[] = {azimuth, elevation, width, height, margin};
        require_finite(all, "the view");
        return unlocked([&] {
          return mesh_svg(mesh, {azimuth, elevation, width, height, margin, closed});
        });
      },
      py::arg("mesh"), py::kw_only(), py::arg("azimuth") = usual.azimuth,
      py::arg("elevation") = usual.elevation, py::arg("width") = usual.width,
      py::arg("height") = usual.height, py::arg("margin") = usual.margin,
      py::arg("closed") = usual.closed,
      "A mesh as an <svg> element, seen from an azimuth and elevation (radians); closed: leave out "
      "what is seen\nfrom behind.");
}

}  // namespace

void bind_picture(py::module_& m) {
  bind_enums(m);
  bind_series(m);
  bind_arrows(m);
  bind_plot(m);
  bind_framed_polyline(m);
  bind_dxf(m);
  bind_mesh_picture(m);
}

}  // namespace hodograph::python
