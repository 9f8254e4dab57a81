// SPDX-License-Identifier: MIT
// Reads worlds from GeoJSON.
#ifdef HODOGRAPH_HAS_PLANNING
#include "hodograph/io/geojson.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <new>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "foreign_text.hpp"
#include "hodograph/io/file.hpp"

namespace hodograph {
namespace {

using io_detail::in_quotes;
using Json = nlohmann::json;
using Point = Vector2<double>;

enum class Role { obstacle, bounds, start, goal, ignored };

/// What the feature around a geometry says.
struct Meaning {
  Role role = Role::obstacle;
  std::string name{};
};

/// Geometries within geometries; deeper is refused, so that no file exhausts the stack.
constexpr int deepest = 32;

class Reader {
 public:
  explicit Reader(const std::string& source) : source_(source) {}

  Result<WorldDocument> read(const Json& root) {
    if (!object(root, "", {}, 0)) return *fault_;
    auto world = World::create(std::move(obstacles_), std::move(bounds_));
    if (!world) {
      Fault fault = world.fault();
      fault.sentence = source_ + ": " + fault.sentence;
      return fault;
    }
    return WorldDocument{std::move(*world), start_, goal_};
  }

 private:
  bool fail(const std::string& pointer, const std::string& what,
            FaultCode code = FaultCode::malformed_document) {
    const std::string place = pointer.empty() ? ": " : ", at " + pointer + ": ";
    fault_ = Fault{code, source_ + place + what, std::nullopt, pointer};
    return false;
  }

  const Json* member(const Json& value, const char* name) const {
    const auto found = value.find(name);
    return found == value.end() ? nullptr : &*found;
  }

  /// Any GeoJSON object.
  bool object(const Json& value, const std::string& pointer, const Meaning& meaning, int depth) {
    if (depth > deepest) return fail(pointer, "collections are nested too deeply");
    if (!value.is_object()) return fail(pointer, "a GeoJSON object is needed");
    const Json* type = member(value, "type");
    if (type == nullptr || !type->is_string())
      return fail(pointer, "the member \"type\" is missing");
    const auto& name = type->get_ref<const std::string&>();
    if (name == "FeatureCollection") {
      return each(value, pointer, "features", [&](const Json& item, const std::string& place) {
        return object(item, place, {}, depth + 1);
      });
    }
    if (name == "Feature") return feature(value, pointer, depth);
    if (meaning.role == Role::ignored) return true;
    if (name == "GeometryCollection") {
      return each(value, pointer, "geometries", [&](const Json& item, const std::string& place) {
        return object(item, place, meaning, depth + 1);
      });
    }
    if (name == "Polygon") return polygon_geometry(value, pointer, meaning);
    if (name == "MultiPolygon") {
      if (meaning.role != Role::obstacle) {
        return fail(pointer, "a MultiPolygon is an obstacle only", FaultCode::unsupported);
      }
      return each(value, pointer, "coordinates", [&](const Json& item, const std::string& place) {
        return polygon(item, place, meaning);
      });
    }
    if (name == "Point") return place_geometry(value, pointer, meaning);
    return fail(pointer,
                in_quotes(name) + " is no obstacle; obstacles are 'Polygon' or 'MultiPolygon'",
                FaultCode::unsupported);
  }

  template <class Read>
  bool each(const Json& value, const std::string& pointer, const char* name, const Read& read) {
    const Json* list = member(value, name);
    const std::string place = pointer + "/" + name;
    if (list == nullptr)
      return fail(pointer, std::string("the member \"") + name + "\" is missing");
    if (!list->is_array()) return fail(place, "an array is needed");
    std::size_t i = 0;
    for (const Json& item : *list) {
      if (!read(item, place + "/" + std::to_string(i++))) return false;
    }
    return true;
  }

  bool feature(const Json& value, const std::string& pointer, int depth) {
    Meaning meaning;
    if (const Json* id = member(value, "id")) {
      if (id->is_string()) meaning.name = id->get<std::string>();
      if (id->is_number()) meaning.name = id->dump();
    }
    if (const Json* properties = member(value, "properties");
        properties && properties->is_object()) {
      if (const Json* name = member(*properties, "name"); name && name->is_string()) {
        meaning.name = name->get<std::string>();
      }
      if (const Json* role = member(*properties, "role")) {
        if (!set_role(*role, pointer + "/properties/role", meaning)) return false;
      }
    }
    const Json* geometry = member(value, "geometry");
    if (geometry == nullptr) return fail(pointer, "the member \"geometry\" is missing");
    if (geometry->is_null()) return true;  // an unlocated feature
    return object(*geometry, pointer + "/geometry", meaning, depth + 1);
  }

  bool set_role(const Json& role, const std::string& pointer, Meaning& meaning) {
    if (!role.is_string()) return fail(pointer, "a string is needed");
    const auto& name = role.get_ref<const std::string&>();
    constexpr std::pair<const char*, Role> roles[] = {{"obstacle", Role::obstacle},
                                                      {"bounds", Role::bounds},
                                                      {"start", Role::start},
                                                      {"goal", Role::goal},
                                                      {"ignored", Role::ignored}};
    for (const auto& [known, value] : roles) {
      if (name == known) {
        meaning.role = value;
        return true;
      }
    }
    return fail(pointer,
                in_quotes(name) +
                    " is unknown; a role is 'obstacle', 'bounds', 'start', 'goal' or 'ignored'",
                FaultCode::unsupported);
  }

  bool polygon_geometry(const Json& value, const std::string& pointer, const Meaning& meaning) {
    const Json* coordinates = member(value, "coordinates");
    if (coordinates == nullptr) return fail(pointer, "the member \"coordinates\" is missing");
    return polygon(*coordinates, pointer + "/coordinates", meaning);
  }

  bool polygon(const Json& value, const std::string& pointer, const Meaning& meaning) {
    if (!value.is_array()) return fail(pointer, "an array of rings is needed");
    if (value.empty()) return true;  // RFC 7946 lets an empty geometry stand for none
    std::vector<Ring> rings;
    for (const Json& item : value) {
      rings.emplace_back();
      if (!ring(item, pointer + "/" + std::to_string(rings.size() - 1), rings.back())) return false;
    }
    switch (meaning.role) {
      case Role::obstacle:
        obstacles_.push_back(
            {std::move(rings.front()),
             {std::make_move_iterator(rings.begin() + 1), std::make_move_iterator(rings.end())},
             meaning.name});
        return true;
      case Role::bounds:
        if (bounds_) return fail(pointer, "there are bounds already");
        if (rings.size() > 1) {
          return fail(pointer, "bounds have no holes; make them obstacles", FaultCode::unsupported);
        }
        bounds_ = std::move(rings.front());
        return true;
      default:
        return fail(pointer, "a start or goal is a 'Point'", FaultCode::unsupported);
    }
  }

  bool ring(const Json& value, const std::string& pointer, Ring& points) {
    if (!value.is_array()) return fail(pointer, "an array of positions is needed");
    points.reserve(value.size());
    for (const Json& item : value) {
      Point p;
      if (!position(item, p)) return wrong_position(item, pointer, points.size());
      points.push_back(p);
    }
    if (points.size() > 1 && points.front() == points.back()) points.pop_back();
    return true;
  }

  static bool position(const Json& value, Point& p) {
    if (!value.is_array() || value.size() < 2 || !value[0].is_number() || !value[1].is_number()) {
      return false;
    }
    p = {value[0].get<double>(), value[1].get<double>()};
    return true;
  }
  bool wrong_position(const Json&, const std::string& pointer, std::size_t i) {
    return fail(pointer + "/" + std::to_string(i), "a position needs two numbers");
  }

  bool place_geometry(const Json& value, const std::string& pointer, const Meaning& meaning) {
    if (meaning.role != Role::start && meaning.role != Role::goal) {
      return fail(
          pointer,
          "a 'Point' is no obstacle; obstacles are 'Polygon' or 'MultiPolygon', and a start "
          "or goal has that \"role\" in its properties",
          FaultCode::unsupported);
    }
    const Json* coordinates = member(value, "coordinates");
    if (coordinates == nullptr) return fail(pointer, "the member \"coordinates\" is missing");
    auto& place = meaning.role == Role::start ? start_ : goal_;
    if (place)
      return fail(pointer, meaning.role == Role::start ? "there is a start already"
                                                       : "there is a goal already");
    Point p;
    if (!position(*coordinates, p)) {
      return fail(pointer + "/coordinates", "a position needs two numbers");
    }
    place = p;
    return true;
  }

  const std::string& source_;
  std::optional<Fault> fault_;
  std::vector<Polygon> obstacles_;
  std::optional<Ring> bounds_;
  std::optional<Point> start_, goal_;
};

/// "line 3, column 7" of a byte of the text.
std::string place_of(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, std::min(byte == 0 ? 0 : byte - 1, text.size()));
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t last = before.rfind('\n');
  const std::size_t column = before.size() - (last == std::string_view::npos ? 0 : last + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

}  // namespace

Result<WorldDocument> parse_world(std::string_view text, const std::string& source) {
  const auto malformed = [&](const std::string& what) {
    return Fault{FaultCode::malformed_document, source + ": " + what};
  };
  try {
    const Json root = Json::parse(text.begin(), text.end());
    return Reader(source).read(root);
  } catch (const Json::parse_error& error) {
    return malformed("broken JSON at " + place_of(text, error.byte));
  } catch (const Json::out_of_range&) {
    return malformed("it has a number beyond the range of double");
  } catch (const std::bad_alloc&) {
    return malformed("it does not fit into memory");
  } catch (const std::exception&) {
    return malformed("it is no GeoJSON that can be read");
  }
}

Result<WorldDocument> load_world(const std::string& path) {
  const auto text = read_file(path);
  if (!text) return text.fault();
  return parse_world(*text, in_quotes(path == "-" ? "standard input" : path));
}

}  // namespace hodograph
#endif  // HODOGRAPH_HAS_PLANNING
