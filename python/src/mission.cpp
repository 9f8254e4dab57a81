// SPDX-License-Identifier: MIT
// Places on the Earth and missions of drones: io/geodesy.hpp, io/mission.hpp.
#include "hodograph/io/mission.hpp"

#include <optional>
#include <string>
#include <vector>

#include "hodograph/path/any_sampling.hpp"
#include "python/src/bindings.hpp"
#include "python/src/made.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

void bind_geodesy(py::module_& m) {
  Record<GeodeticPoint> point(m, "GeodeticPoint",
                              "A place near the Earth: degrees, and metres above the "
                              "ellipsoid WGS 84.");
  point.def(py::init([](double latitude, double longitude, double altitude) {
              const GeodeticPoint made{latitude, longitude, altitude};
              if (const auto fault = fault_of(made, "the place")) throw Error(*fault);
              return made;
            }),
            py::arg("latitude"), py::arg("longitude"), py::arg("altitude") = 0.0);
  point.field("latitude", &GeodeticPoint::latitude)
      .field("longitude", &GeodeticPoint::longitude)
      .field("altitude", &GeodeticPoint::altitude);
  m.def("has_geodesy", &has_geodesy, "Whether this build can turn metres into degrees.");
  m.attr("lowest_altitude") = lowest_altitude;
  m.attr("highest_altitude") = highest_altitude;
  m.attr("farthest_from_datum") = farthest_from_datum;
  py::class_<LocalTangentPlane>(m, "LocalTangentPlane",
                                "The plane of local metres (east, north, up) that touches the "
                                "Earth at a datum.")
      .def(py::init(
               [](const GeodeticPoint& datum) { return LocalTangentPlane::create(datum).value(); }),
           py::arg("datum"), "Raises HodographError: outside_domain, unsupported.")
      .def_property_readonly("datum", &LocalTangentPlane::datum)
      .def(
          "to_geodetic",
          [](const LocalTangentPlane& plane, const Doubles& local) {
            return plane.to_geodetic(point_of<Vector3<double>>(local, "local")).value();
          },
          py::arg("local"), "The place of a local point (3,), metres; to 1e-8 m.")
      .def(
          "to_local",
          [](const LocalTangentPlane& plane, const GeodeticPoint& place) {
            return plane.to_local(place).value();
          },
          py::arg("place"), "The local point (3,) of a place.")
      .def("__repr__",
           [](const LocalTangentPlane& plane) {
             return "<hodograph.LocalTangentPlane: at " + to_text(plane.datum().latitude) + ", " +
                    to_text(plane.datum().longitude) + ", " + to_text(plane.datum().altitude) + ">";
           })
      .def(py::pickle([](const LocalTangentPlane& plane) { return py::make_tuple(plane.datum()); },
                      [](const py::tuple& t) {
                        return LocalTangentPlane::create(t[0].cast<GeodeticPoint>()).value();
                      }));
}

/// Waypoints of points (n, 3) and speeds: None, one for all, or (n,).
std::vector<LocalWaypoint> waypoints_of(const Doubles& points,
                                        const std::optional<Doubles>& speeds) {
  std::vector<LocalWaypoint> waypoints;
  for (const auto& p : points_of<Vector3<double>>(points, "points")) waypoints.push_back({p, {}});
  if (!speeds) return waypoints;
  const bool same = speeds->ndim() == 0;
  if (!same && (speeds->ndim() != 1 || speeds->shape(0) != points.shape(0))) {
    refuse_shape("speeds", "() or (" + std::to_string(points.shape(0)) + ",)", *speeds);
  }
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    waypoints[i].speed = speeds->data()[same ? 0 : i];
  }
  return waypoints;
}

void bind_missions(py::module_& m) {
  Record<MissionWaypoint>(m, "MissionWaypoint", "A waypoint on the Earth.")
      .field("latitude", &MissionWaypoint::latitude, "Degrees.")
      .field("longitude", &MissionWaypoint::longitude, "Degrees.")
      .field("height", &MissionWaypoint::height, "Above home, metres.")
      .field("speed", &MissionWaypoint::speed, "Over ground (m/s), on the way here, or None.");
  Record<Mission>(m, "Mission", "What a mission file holds.")
      .field("home", &Mission::home)
      .field("waypoints", &Mission::waypoints)
      .field("acceptance_radius", &Mission::acceptance_radius,
             "Within it a waypoint counts as reached, metres; 0: the autopilot's own.");
  m.attr("most_waypoints") = most_waypoints;
  m.def(
      "mission",
      [](const Doubles& points, const GeodeticPoint& datum, const std::optional<Doubles>& speeds,
         double acceptance_radius) {
        const auto waypoints = waypoints_of(points, speeds);
        return unlocked([&] {
          Mission made = mission(waypoints, datum).value();
          made.acceptance_radius = acceptance_radius;
          if (const auto fault = fault_of(made)) throw Error(*fault);
          return made;
        });
      },
      py::arg("points"), py::arg("datum"), py::kw_only(), py::arg("speeds") = py::none(),
      py::arg("acceptance_radius") = 0.0,
      "The mission through points (n, 3) in local metres, home at the datum, at speeds over ground "
      "(m/s), one\nfor all or (n,). Raises HodographError, with the waypoint's index: not_finite, "
      "outside_domain, too_few, unsupported.");
  m.def(
      "to_qgroundcontrol_plan",
      [](const Mission& mission) { return to_qgroundcontrol_plan(mission).value(); },
      py::arg("mission"), "The mission as a plan file of QGroundControl.");
  m.def(
      "to_waypoint_file", [](const Mission& mission) { return to_waypoint_file(mission).value(); },
      py::arg("mission"), "The mission as \"QGC WPL 110\".");
  m.def(
      "waypoints_along",
      [](const AnyPath& path, double tolerance, double altitude) {
        require_finite({&altitude, 1}, "altitude");
        return unlocked([&] {
          std::vector<Vector3<double>> points;
          std::vector<double> at(path.dimension());
          for (const double xi : polyline_parameters(path, tolerance).value()) {
            path.position(xi, at);
            points.push_back({at[0], at[1], altitude + (at.size() > 2 ? at[2] : 0.0)});
          }
          return points;
        });
      },
      py::arg("path"), py::arg("tolerance"), py::arg("altitude") = 0.0,
      "Points (n, 3) along a path, every knot among them, so that every point of the path is "
      "within a tolerance of\nthe lines between them, certified; a planar path at z = altitude, a "
      "spatial one with it added.");
}

}  // namespace

void bind_mission(py::module_& m) {
  bind_geodesy(m);
  add_equality_of_states(py::type::of<LocalTangentPlane>());
  bind_missions(m);
}

}  // namespace hodograph::python
