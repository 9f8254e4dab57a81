// SPDX-License-Identifier: MIT
// Worlds of polygons, and where a point stands in one: planning/world.hpp, mitred_world.hpp.
#include "hodograph/planning/world.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hodograph/planning/mitred_world.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector2<double>;

Ring ring_of(py::handle source, const std::string& name) {
  const auto array = Doubles::ensure(source);
  if (!array) throw py::type_error(name + " should be points, an array of shape (n, 2)");
  return points_of<Point>(array, name);
}

Polygon polygon_of(py::handle outer, const py::iterable& holes, const std::string& name) {
  Polygon polygon;
  polygon.outer = ring_of(outer, "the outer ring");
  for (const py::handle hole : holes) {
    polygon.holes.push_back(ring_of(hole, "hole " + std::to_string(polygon.holes.size())));
  }
  polygon.name = name;
  return polygon;
}

World world_of(const py::iterable& obstacles, const std::optional<Doubles>& bounds) {
  std::vector<Polygon> polygons;
  for (const py::handle item : obstacles) {
    if (py::isinstance<Polygon>(item)) {
      polygons.push_back(item.cast<Polygon>());
    } else {
      Polygon& polygon = polygons.emplace_back();
      polygon.outer = ring_of(item, "obstacle " + std::to_string(polygons.size() - 1));
    }
  }
  std::optional<Ring> ring;
  if (bounds) ring = points_of<Point>(*bounds, "bounds");
  return unlocked([&] { return World::create(std::move(polygons), std::move(ring)).value(); });
}

[[noreturn]] void refuse_vertex(const WorldVertex& v) {
  throw Error(Fault{FaultCode::outside_domain,
                    "the world has no vertex " + std::to_string(v.vertex) + " in ring " +
                        std::to_string(v.ring) + " of obstacle " + std::to_string(v.obstacle),
                    v.obstacle, "vertex", static_cast<double>(v.vertex), std::nullopt});
}

/// The ring, which may not exist.
const Ring& ring_at(const World& world, std::uint32_t obstacle, std::uint32_t ring) {
  const bool exists =
      obstacle == WorldVertex::bounds
          ? world.bounds() && ring == 0
          : obstacle < world.obstacles().size() && ring <= world.obstacles()[obstacle].holes.size();
  if (!exists) refuse_vertex({obstacle, ring, 0});
  return world.ring(obstacle, ring);
}

const WorldVertex& existing(const World& world, const WorldVertex& vertex) {
  if (vertex.vertex >= ring_at(world, vertex.obstacle, vertex.ring).size()) refuse_vertex(vertex);
  return vertex;
}

/// A ring as it stood in the data, repeated points and all.
Ring source_ring(const World& world, std::uint32_t obstacle, std::uint32_t ring) {
  const Ring& clean = world.ring(obstacle, ring);
  std::size_t size = clean.size();
  for (const WorldRepair& repair : world.repairs()) {
    size += repair.kind == WorldRepair::Kind::repeated_point && repair.obstacle == obstacle &&
            repair.ring == ring;
  }
  std::vector<std::optional<Point>> given(size);
  for (std::size_t i = 0; i < clean.size(); ++i) {
    given[world.source_vertex({obstacle, ring, static_cast<std::uint32_t>(i)})] = clean[i];
  }
  Ring result(size);
  Point last{};
  for (std::size_t i = 0; i < 2 * size; ++i) {  // twice round: the first may repeat the last
    if (given[i % size]) last = *given[i % size];
    result[i % size] = last;
  }
  return result;
}

py::tuple state_of(const World& world) {
  py::list obstacles;
  for (std::uint32_t k = 0; k < world.obstacles().size(); ++k) {
    const Polygon& clean = world.obstacles()[k];
    Polygon source;
    source.name = clean.name;
    source.outer = source_ring(world, k, 0);
    for (std::uint32_t h = 0; h < clean.holes.size(); ++h) {
      source.holes.push_back(source_ring(world, k, h + 1));
    }
    obstacles.append(py::cast(source));
  }
  py::object bounds = py::none();
  if (world.bounds()) bounds = py::cast(source_ring(world, WorldVertex::bounds, 0));
  return py::make_tuple(obstacles, bounds);
}

std::string text_of(const World& world) {
  const std::size_t obstacles = world.obstacles().size(), vertices = world.vertex_count();
  return "<hodograph.World: " + std::to_string(obstacles) +
         (obstacles == 1 ? " obstacle, " : " obstacles, ") + std::to_string(vertices) +
         (vertices == 1 ? " vertex" : " vertices") + (world.bounds() ? ", with bounds>" : ">");
}

void bind_vertices(py::module_& m) {
  Record<WorldVertex> vertex(
      m, "WorldVertex",
      "A vertex of a world: obstacle, ring (0 the outer one, k its hole k - 1) and vertex, counted "
      "in\nthe world's own rings. WorldVertex.bounds is the number of the bounds.");
  vertex
      .def(py::init([](std::uint32_t obstacle, std::uint32_t ring, std::uint32_t vertex_number) {
             return WorldVertex{obstacle, ring, vertex_number};
           }),
           py::arg("obstacle"), py::arg("ring") = 0, py::arg("vertex") = 0)
      .def("__hash__", [](const WorldVertex& v) {
        return py::hash(py::make_tuple(v.obstacle, v.ring, v.vertex));
      });
  vertex.attr("bounds") = std::uint32_t{WorldVertex::bounds};
  vertex.field("obstacle", &WorldVertex::obstacle)
      .field("ring", &WorldVertex::ring)
      .field("vertex", &WorldVertex::vertex);

  Record<WorldRepair> repair(m, "WorldRepair", "Something about the data that was mended.");
  py::enum_<WorldRepair::Kind>(repair, "Kind", "What was mended.")
      .value("repeated_point", WorldRepair::Kind::repeated_point,
             "The vertex equals the one before it and was taken out.")
      .value("turned_ring", WorldRepair::Kind::turned_ring, "The ring went round the other way.");
  repair.field("kind", &WorldRepair::kind)
      .field("obstacle", &WorldRepair::obstacle, "WorldVertex.bounds for the bounds.")
      .field("ring", &WorldRepair::ring, "In the data: 0 the outer one, k hole k - 1.")
      .field("vertex", &WorldRepair::vertex, "In the data.")
      .def("__str__", [](const WorldRepair& r) { return to_text(r); });

  Record<RingContact>(m, "RingContact",
                      "A vertex that lies on an edge, or on a vertex, of its own polygon.")
      .field("vertex", &RingContact::vertex)
      .field("edge", &RingContact::edge, "Where the edge starts.");
}

void bind_polygons(py::module_& m) {
  Record<Polygon> polygon(m, "Polygon",
                          "What an outer ring surrounds, without what its holes surround. "
                          "Rings are points (n, 2); the last\nis joined to the first, which is "
                          "not repeated; either direction is right.");
  polygon.def(py::init(&polygon_of), py::arg("outer"), py::arg("holes") = py::tuple(),
              py::arg("name") = "");
  polygon.field("outer", &Polygon::outer, "The outer ring, (n, 2).")
      .field("holes", &Polygon::holes, "The holes, each (n, 2).")
      .field("name", &Polygon::name);
  Record<PlanarBox>(m, "PlanarBox", "An axis-parallel box.")
      .field("lower", &PlanarBox::lower, "The corner (x, y) with the least coordinates.")
      .field("upper", &PlanarBox::upper, "The corner (x, y) with the largest.")
      .def(
          "contains",
          [](const PlanarBox& box, const Doubles& p) {
            return box.contains(point_of<Point>(p, "point"));
          },
          py::arg("point"), "True for a point inside or on the border.");
}

void bind_world_class(py::module_& m) {
  py::class_<World>(m, "World",
                    "The polygonal obstacles that a vehicle avoids and the bounds it stays in, "
                    "checked once.\n\nObstacles may be concave, have holes, touch, overlap and "
                    "contain each other. A value.")
      .def(py::init(&world_of), py::arg("obstacles") = py::tuple(), py::arg("bounds") = py::none(),
           "The world of obstacles, each a Polygon or a ring (n, 2), and of bounds, a ring (n, 2) "
           "or None.\nRaises HodographError: not_finite, too_few, outside_domain (a ring that "
           "crosses itself and the like;\nindex: the obstacle).")
      .def_property_readonly("obstacles", &World::obstacles,
                             "The polygons, outer rings anticlockwise, holes clockwise.")
      .def_property_readonly("bounds", &World::bounds, "The bounds' ring (n, 2), or None.")
      .def_property_readonly("repairs", &World::repairs, "What was mended.")
      .def_property_readonly("contacts", &World::contacts,
                             "Where rings touch themselves or others of their polygon.")
      .def_property_readonly("vertex_count", &World::vertex_count)
      .def_property_readonly("box", &World::box, "The box about everything; None without anything.")
      .def(
          "ring",
          [](const World& world, std::uint32_t obstacle, std::uint32_t ring) {
            return ring_at(world, obstacle, ring);
          },
          py::arg("obstacle"), py::arg("ring") = 0,
          "A ring of an obstacle or of the bounds, (n, 2).")
      .def(
          "point",
          [](const World& world, const WorldVertex& v) { return world.point(existing(world, v)); },
          py::arg("vertex"), "The coordinates of a vertex, (2,).")
      .def(
          "source_vertex",
          [](const World& world, const WorldVertex& v) {
            return world.source_vertex(existing(world, v));
          },
          py::arg("vertex"), "Its index in the ring of the data, repeated points counted.")
      .def(
          "name_of",
          [](const World& world, std::uint32_t obstacle) {
            ring_at(world, obstacle, 0);
            return world.name_of(obstacle);
          },
          py::arg("obstacle"), "How sentences call an obstacle: \"obstacle 3 ('shed')\".")
      .def("__repr__", &text_of)
      .def("__copy__", [](const World& world) { return world; })
      .def(
          "__deepcopy__", [](const World& world, const py::dict&) { return world; },
          py::arg("memo"))
      .def(
          "__eq__",
          [](const World& a, const World& b) {
            return a.obstacles() == b.obstacles() && a.bounds() == b.bounds() &&
                   a.repairs() == b.repairs();
          },
          py::is_operator())
      .def(py::pickle(&state_of,
                      [](const py::tuple& state) {
                        std::optional<Doubles> bounds;
                        if (!state[1].is_none()) bounds = state[1].cast<Doubles>();
                        return world_of(state[0].cast<py::list>(), bounds);
                      }))
      .attr("__hash__") = py::none();
}

void bind_mitred_world(py::module_& m) {
  Record<WorldPosition> position(m, "WorldPosition", "Where a point stands.");
  py::enum_<WorldPosition::Kind>(position, "Kind", "Where a point stands.")
      .value("free", WorldPosition::Kind::free, "In the closed free space.")
      .value("in_obstacle", WorldPosition::Kind::in_obstacle,
             "Inside an obstacle, or between two that touch.")
      .value("in_band", WorldPosition::Kind::in_band, "Outside, but inside a grown obstacle.")
      .value("out_of_bounds", WorldPosition::Kind::out_of_bounds, "Outside the bounds.");
  position.field("kind", &WorldPosition::kind)
      .field("obstacle", &WorldPosition::obstacle,
             "Whose: the one with the largest `missing`; WorldVertex.bounds for the bounds.")
      .field("missing", &WorldPosition::missing,
             "in_band: by how much the offset had to be smaller for the point to be free.");
  py::class_<MitredWorld>(m, "MitredWorld",
                          "A world whose obstacles are grown by a distance, with mitred corners, "
                          "indexed for queries.")
      .def(py::init([](const World& world, double offset, std::optional<double> bounds_offset) {
             return unlocked(
                 [&] { return MitredWorld::create(world, offset, bounds_offset).value(); });
           }),
           py::arg("world"), py::arg("offset"), py::arg("bounds_offset") = py::none(),
           "Grows obstacles by `offset` and the bounds inwards by `bounds_offset` (the same unless "
           "given).\nRaises HodographError: not_finite, outside_domain.")
      .def_property_readonly("world", &MitredWorld::world)
      .def_property_readonly("offset", &MitredWorld::offset)
      .def_property_readonly("bounds_offset", &MitredWorld::bounds_offset)
      .def_property_readonly("corner_count", &MitredWorld::corner_count,
                             "The mitre tips that a shortest path may turn at.")
      .def(
          "mitre_tip",
          [](const MitredWorld& world, const WorldVertex& v, std::optional<double> d) {
            return world.mitre_tip(existing(world.world(), v), d);
          },
          py::arg("vertex"), py::arg("d") = py::none(),
          "The tip of a vertex for an offset d (by default the world's), (2,); None where it does "
          "not stick out.")
      .def(
          "locate",
          [](const MitredWorld& world, const Doubles& point) {
            const auto p = point_of<Point>(point, "point");
            require_finite(numbers(point), "point");
            return world.locate(p);
          },
          py::arg("point"), "Where a point (2,) stands; exact.")
      .def(
          "sees",
          [](const MitredWorld& world, const Doubles& a, const Doubles& b) {
            const auto from = point_of<Point>(a, "a"), to = point_of<Point>(b, "b");
            require_finite(numbers(a), "a");
            require_finite(numbers(b), "b");
            return unlocked([&] { return world.sees(from, to); });
          },
          py::arg("a"), py::arg("b"), "True where the closed segment stays in free space. Exact.")
      .def("__repr__",
           [](const MitredWorld& world) {
             return "<hodograph.MitredWorld: offset " + to_text(world.offset()) + ", " +
                    std::to_string(world.corner_count()) + " corners>";
           })
      .def(py::pickle(
          [](const MitredWorld& world) {
            return py::make_tuple(world.world(), world.offset(), world.bounds_offset());
          },
          [](const py::tuple& state) {
            return MitredWorld::create(state[0].cast<World>(), state[1].cast<double>(),
                                       state[2].cast<double>())
                .value();
          }));
}

}  // namespace

void bind_world(py::module_& m) {
  bind_vertices(m);
  bind_polygons(m);
  bind_world_class(m);
  bind_mitred_world(m);
  add_equality_of_states(py::type::of<MitredWorld>());
  m.attr("largest_world_coordinate") = largest_world_coordinate;
  m.attr("least_offset_ratio") = least_offset_ratio;
}

}  // namespace hodograph::python
