// SPDX-License-Identifier: MIT
// Writes paths in their world as GeoJSON.
#ifdef HODOGRAPH_HAS_PLANNING
#include "hodograph/io/geojson_scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <utility>

#include "number.hpp"

namespace hodograph {
namespace {

using Point = Vector3<double>;

std::string quoted(const std::string& text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

/// Features, one a line; the first fault stays.
class Writer {
 public:
  explicit Writer(const GeoJsonScene& scene) : scene_(scene) {}

  Result<std::string> text() {
    if (scene_.datum) {
      auto plane = LocalTangentPlane::create(*scene_.datum);
      if (!plane) return plane.fault();
      plane_ = std::move(*plane);
    }
    out_ = "{\"type\": \"FeatureCollection\",\n";
    if (plane_) {
      const GeodeticPoint& datum = plane_->datum();
      out_ += "\"datum\": {\"latitude\": ";
      number(datum.latitude);
      out_ += ", \"longitude\": ";
      number(datum.longitude);
      out_ += ", \"altitude\": ";
      number(datum.altitude);
      out_ += "},\n";
    } else {
      out_ += "\"coordinates\": \"local\",\n";
    }
    out_ += "\"features\": [";
    world();
    place(scene_.start, "start");
    place(scene_.goal, "goal");
    for (std::size_t i = 0; i < scene_.paths.size() && !fault_; ++i) path(i);
    if (fault_) return *fault_;
    out_ += "\n]}\n";
    return std::move(out_);
  }

 private:
  void number(double value) { io_detail::append_number(out_, value == 0.0 ? 0.0 : value); }

  void position(const Point& local, bool with_height) {
    if (fault_) return;
    Point p = local;
    if (plane_) {
      const auto place = plane_->to_geodetic(local);
      if (!place) {
        fault_ = place.fault();
        return;
      }
      p = {place->longitude, place->latitude, place->altitude};
    } else if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) {
      fault_ = Fault{FaultCode::not_finite, "a point of a path is not finite"};
      return;
    }
    out_ += '[';
    number(p.x);
    out_ += ", ";
    number(p.y);
    if (with_height) {
      out_ += ", ";
      number(p.z);
    }
    out_ += ']';
  }
  Point over_the_plane(const Vector2<double>& p) const { return {p.x, p.y, scene_.altitude}; }

  void begin(const char* type) {
    out_ += features_++ == 0 ? "\n" : ",\n";
    out_ += "{\"type\": \"Feature\", \"geometry\": {\"type\": \"" + std::string(type) +
            "\", \"coordinates\": ";
  }

  void ring(const Ring& ring) {
    out_ += '[';
    for (std::size_t i = 0; i <= ring.size() && !fault_; ++i) {
      if (i > 0) out_ += ", ";
      position(over_the_plane(ring[i % ring.size()]), false);
    }
    out_ += ']';
  }

  void world() {
    for (const Polygon& polygon : scene_.world.obstacles()) {
      begin("Polygon");
      out_ += '[';
      ring(polygon.outer);
      for (const Ring& hole : polygon.holes) {
        out_ += ", ";
        ring(hole);
      }
      out_ += "]}, \"properties\": {\"role\": \"obstacle\"";
      if (!polygon.name.empty()) out_ += ", \"name\": " + quoted(polygon.name);
      out_ += "}}";
      if (fault_) return;
    }
    if (const auto& bounds = scene_.world.bounds()) {
      begin("Polygon");
      out_ += '[';
      ring(*bounds);
      out_ += "]}, \"properties\": {\"role\": \"bounds\"}}";
    }
  }

  void place(const std::optional<Vector2<double>>& point, const std::string& role) {
    if (!point || fault_) return;
    begin("Point");
    position(over_the_plane(*point), false);
    out_ += "}, \"properties\": {\"role\": \"" + role + "\"}}";
  }

  void path(std::size_t index) {
    const GeoJsonPath& path = scene_.paths[index];
    if (path.points.size() < 2) {
      fault_ = Fault{FaultCode::too_few,
                     "path " + std::to_string(index) + " has " +
                         std::to_string(path.points.size()) + " points; a line needs two",
                     index,
                     "points",
                     static_cast<double>(path.points.size()),
                     2.0};
      return;
    }
    begin("LineString");
    out_ += '[';
    for (std::size_t i = 0; i < path.points.size() && !fault_; ++i) {
      if (i > 0) out_ += ", ";
      Point local = path.points[i];
      if (!path.spatial) local.z = scene_.altitude;
      position(local, path.spatial || plane_.has_value());
    }
    out_ += "]}, \"properties\": {\"role\": \"ignored\"";
    const auto text = [&](const char* key, const std::string& value) {
      if (!value.empty()) out_ += ", \"" + std::string(key) + "\": " + quoted(value);
    };
    const auto one = [&](const char* key, const std::optional<double>& value) {
      if (!value || !std::isfinite(*value)) return;
      out_ += ", \"" + std::string(key) + "\": ";
      number(*value);
    };
    const auto ends = [&](const char* key, const std::optional<Enclosure>& value) {
      if (!value || !is_finite(*value)) return;
      out_ += ", \"" + std::string(key) + "\": [";
      number(value->lower());
      out_ += ", ";
      number(value->upper());
      out_ += ']';
    };
    text("name", path.name);
    text("kind", path.kind);
    one("chord_tolerance", path.chord_tolerance);
    const Promises& promises = path.promises;
    ends("arc_length", promises.arc_length);
    one("curvature_bound", promises.curvature_bound);
    ends("largest_curvature", promises.largest_curvature);
    if (const auto& clearance = promises.clearance) {
      std::optional<Enclosure> least = clearance->bounds;
      for (const ObstacleDistance& near : clearance->obstacles) {
        if (!least || near.distance.lower() < least->lower()) least = near.distance;
      }
      ends("clearance", least);
      one("reach", clearance->reach);
    }
    out_ += "}}";
  }

  const GeoJsonScene& scene_;
  std::optional<LocalTangentPlane> plane_;
  std::optional<Fault> fault_;
  std::string out_;
  std::size_t features_ = 0;
};

}  // namespace

Result<std::string> to_geojson(const GeoJsonScene& scene) { return Writer(scene).text(); }

}  // namespace hodograph
#endif  // HODOGRAPH_HAS_PLANNING
