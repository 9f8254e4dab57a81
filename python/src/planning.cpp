// SPDX-License-Identifier: MIT
// Shortest polylines, clearance, corner sizes: planning/.
#include <string>
#include <vector>

#include "hodograph/planning/clearance.hpp"
#include "hodograph/planning/corner_sizes.hpp"
#include "hodograph/planning/shortest_polyline.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

Polyline polyline_of(const MitredWorld& world, const Doubles& start, const Doubles& goal,
                     std::vector<CornerOffset> corner_offsets,
                     std::vector<ObstacleOffset> obstacle_offsets,
                     std::vector<ForbiddenCorner> forbidden_corners,
                     std::vector<ForbiddenLeg> forbidden_legs) {
  const PolylineQuery query{point_of<Point>(start, "start"), point_of<Point>(goal, "goal"),
                            std::move(corner_offsets),       std::move(obstacle_offsets),
                            std::move(forbidden_corners),    std::move(forbidden_legs)};
  return unlocked([&] { return shortest_polyline(world, query).value(); });
}

/// The clearance of a planar path of any degree that constructions of the plane make.
PathClearance clearance_of(const ClearanceIndex& index, const AnyPath& path, double reach) {
  return unlocked([&] {
    if (const auto* line = path.get_if<PlanarPath<0>>()) {
      return index.clearance(*line, reach).value();
    }
    if (const auto* cubic = path.get_if<PlanarPath<1>>()) {
      return index.clearance(*cubic, reach).value();
    }
    if (const auto* septic = path.get_if<PlanarPath<3>>()) {
      return index.clearance(*septic, reach).value();
    }
    if (const auto* nonic = path.get_if<PlanarPath<4>>()) {
      return index.clearance(*nonic, reach).value();
    }
    return index.clearance(path_as<PlanarPath<2>>(path, "planar paths of degree 9 at most"), reach)
        .value();
  });
}

void bind_polylines(py::module_& m) {
  py::enum_<TurnSide>(m, "TurnSide",
                      "To which side a path turns at a corner; the obstacle is on that side.")
      .value("right", TurnSide::right)
      .value("left", TurnSide::left);
  Record<CornerOffset> corner_offset(m, "CornerOffset",
                                     "Another offset at one vertex: its mitre tip moves.");
  corner_offset.def(py::init([](const WorldVertex& vertex, double offset) {
                      return CornerOffset{vertex, offset};
                    }),
                    py::arg("vertex"), py::arg("offset"));
  corner_offset.field("vertex", &CornerOffset::vertex).field("offset", &CornerOffset::offset);
  Record<ObstacleOffset> obstacle_offset(m, "ObstacleOffset",
                                         "Another offset of a whole obstacle.");
  obstacle_offset.def(py::init([](std::uint32_t obstacle, double offset) {
                        return ObstacleOffset{obstacle, offset};
                      }),
                      py::arg("obstacle"), py::arg("offset"));
  obstacle_offset.field("obstacle", &ObstacleOffset::obstacle)
      .field("offset", &ObstacleOffset::offset);
  Record<ForbiddenCorner> forbidden_corner(
      m, "ForbiddenCorner", "A corner not to be turned at, to that side. Passing it is allowed.");
  forbidden_corner.def(py::init([](const WorldVertex& vertex, TurnSide side) {
                         return ForbiddenCorner{vertex, side};
                       }),
                       py::arg("vertex"), py::arg("side"));
  forbidden_corner.field("vertex", &ForbiddenCorner::vertex).field("side", &ForbiddenCorner::side);
  Record<ForbiddenLeg> forbidden_leg(
      m, "ForbiddenLeg",
      "A leg not to be used, in this direction; None stands for the start, or the goal.");
  forbidden_leg.def(py::init([](std::optional<WorldVertex> from, std::optional<WorldVertex> to) {
                      return ForbiddenLeg{from, to};
                    }),
                    py::arg("from_vertex") = py::none(), py::arg("to_vertex") = py::none());
  forbidden_leg.field("from_vertex", &ForbiddenLeg::from).field("to_vertex", &ForbiddenLeg::to);

  Record<PolylineCorner>(m, "PolylineCorner", "A point where a polyline turns.")
      .field("point", &PolylineCorner::point, "(2,).")
      .field("vertex", &PolylineCorner::vertex, "Whose mitre tip it is.")
      .field("side", &PolylineCorner::side);
  Record<Polyline>(m, "Polyline", "A polyline from a start over corners to a goal.")
      .field("points", &Polyline::points, "Start, corners, goal, (n, 2).")
      .field("corners", &Polyline::corners, "Strictly turning, in order.")
      .field("length", &Polyline::length, "Of the legs, summed.")
      .field("expanded", &Polyline::expanded, "Corners from which the search went on.")
      .field("visibility_tests", &Polyline::visibility_tests, "Segments that were tested.");
  m.def("shortest_polyline", &polyline_of, py::arg("world"), py::arg("start"), py::arg("goal"),
        py::kw_only(), py::arg("corner_offsets") = std::vector<CornerOffset>{},
        py::arg("obstacle_offsets") = std::vector<ObstacleOffset>{},
        py::arg("forbidden_corners") = std::vector<ForbiddenCorner>{},
        py::arg("forbidden_legs") = std::vector<ForbiddenLeg>{},
        "The shortest polyline in the free space of a MitredWorld from start (2,) to goal (2,) "
        "whose corners and\nlegs are not forbidden; offsets replace those of the world for this "
        "query alone.\nRaises HodographError: not_finite, outside_domain (start or goal not free), "
        "no_route.");
}

void bind_clearance(py::module_& m) {
  Record<ObstacleClearance>(m, "ObstacleClearance", "How near a path comes to one obstacle.")
      .field("obstacle", &ObstacleClearance::obstacle, "WorldVertex.bounds for the bounds.")
      .field("distance", &ObstacleClearance::distance,
             "Contains the least distance between the path and the solid.")
      .field("xi", &ObstacleClearance::xi, "Where the path comes as near as distance.upper.")
      .field("nearest", &ObstacleClearance::nearest,
             "The nearest point of the obstacle's boundary, (2,).");
  Record<PathClearance> clearance(m, "PathClearance",
                                  "How near a path comes to the obstacles of a world.");
  clearance.field("near", &PathClearance::near, "In ascending order of obstacles, the bounds last.")
      .field("reach", &PathClearance::reach, "Everything that is not in `near` is so far.")
      .def("least", &PathClearance::least, "The least distance to any.");
  py::class_<ClearanceIndex>(m, "ClearanceIndex", "The edges of a world, indexed.")
      .def(py::init(
               [](const World& world) { return unlocked([&] { return ClearanceIndex(world); }); }),
           py::arg("world"))
      .def_property_readonly("world", &ClearanceIndex::world)
      .def("clearance", &clearance_of, py::arg("path"), py::arg("reach"),
           "The distance of a planar path (degree 9 at most) from every obstacle, and from the "
           "bounds, that it\ncomes within `reach` of; certified for every point of the path.\n"
           "Raises HodographError: outside_domain, unsupported.")
      .def("__repr__",
           [](const ClearanceIndex& index) {
             return "<hodograph.ClearanceIndex: " + std::to_string(index.world().vertex_count()) +
                    " vertices>";
           })
      .def(py::pickle([](const ClearanceIndex& index) { return py::make_tuple(index.world()); },
                      [](const py::tuple& t) { return ClearanceIndex(t[0].cast<World>()); }));
}

void bind_corner_sizes(py::module_& m) {
  py::enum_<CornerAim>(m, "CornerAim", "What the sizes of rounded corners are chosen for.")
      .value("smallest", CornerAim::smallest, "Every leg as small as it may be.")
      .value("largest", CornerAim::largest, "All rise together from least to most.")
      .value("least_length", CornerAim::least_length, "The path is as short as it can be.")
      .value("least_peak_curvature", CornerAim::least_peak_curvature,
             "The largest curvature is least; of those, the smallest corners.");
  Record<CornerRoom> room(m, "CornerRoom", "What one corner asks, and what its leg L does.");
  room.def(py::init([](double least, double most, double saving, double peak_curvature) {
             return CornerRoom{least, most, saving, peak_curvature};
           }),
           py::arg("least"), py::arg("most"), py::arg("saving") = 0.0,
           py::arg("peak_curvature") = 0.0);
  room.field("least", &CornerRoom::least)
      .field("most", &CornerRoom::most)
      .field("saving", &CornerRoom::saving, "By how much the path gets shorter for a unit of L.")
      .field("peak_curvature", &CornerRoom::peak_curvature, "|kappa| at the middle, times L.");
  m.def(
      "corner_sizes",
      [](const Doubles& lines, const std::vector<CornerRoom>& corners, CornerAim aim) {
        const auto lengths = numbers_of(lines, "lines");
        return array_of(unlocked([&] { return corner_sizes(lengths, corners, aim).value(); }));
      },
      py::arg("lines"), py::arg("corners"), py::arg("aim"),
      "The legs (n,) of n corners between n + 1 lines of the given lengths.\nRaises "
      "HodographError: mismatched_size, outside_domain, no_interpolant (no room; index).");
}

}  // namespace

void bind_planning(py::module_& m) {
  bind_polylines(m);
  bind_clearance(m);
  add_equality_of_states(py::type::of<ClearanceIndex>());
  bind_corner_sizes(m);
}

}  // namespace hodograph::python
