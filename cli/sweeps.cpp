// SPDX-License-Identifier: MIT
#include "cli/sweeps.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <numbers>

#include "cli/drawing.hpp"
#include "cli/frames.hpp"
#include "cli/made_path.hpp"
#include "hodograph/io/mesh_file.hpp"
#include "hodograph/io/mesh_picture.hpp"
#include "hodograph/io/table.hpp"
#include "hodograph/path/any_bounds.hpp"
#include "hodograph/surface/sweep_contact.hpp"

namespace hodograph::cli {
namespace {

Fault unsupported(const std::string& sentence, const std::string& quantity) {
  return {FaultCode::unsupported, sentence, std::nullopt, quantity, std::nullopt, std::nullopt};
}

Profile profile_of(const SweepRequest& request) {
  if (request.circle) return Profile::circle(*request.circle).value();
  if (!request.ellipse.empty()) {
    return Profile::ellipse(request.ellipse[0], request.ellipse[1]).value();
  }
  if (!request.rectangle.empty()) {
    const double x = 0.5 * request.rectangle[0], y = 0.5 * request.rectangle[1];
    for (const double side : request.rectangle) {
      if (!(side > 0.0)) {
        throw Error(Fault{FaultCode::outside_domain,
                          "a side of the rectangle is " + to_text(side) + "; it must be positive",
                          std::nullopt, "rectangle", side, 0.0});
      }
    }
    return Profile::polygon(std::vector<Vector2<double>>{{-x, -y}, {x, -y}, {x, y}, {-x, y}})
        .value();
  }
  if (!request.ribbon.empty()) {
    const double left = request.ribbon[0], right = request.ribbon[1];
    if (!(left + right > 0.0)) {
      throw Error(Fault{FaultCode::outside_domain,
                        "the ribbon reaches " + to_text(left) + " to the left and " +
                            to_text(right) + " to the right; together they must be positive",
                        std::nullopt, "ribbon", left + right, 0.0});
    }
    return Profile::polyline(std::vector<Vector2<double>>{{-right, 0.0}, {left, 0.0}}).value();
  }
  if (!request.polygon.empty()) return Profile::polygon(request.polygon).value();
  return Profile::of(*request.curve).value();
}

Motion motion_of(const AnyPath& path, const SweepRequest& request, const std::string& word,
                 std::optional<double>& gamma) {
  if ((request.gamma || !request.found_gamma.empty()) && word != "periodic") {
    throw Error(unsupported("gamma belongs to the frame periodic; the frame is " + word, "gamma"));
  }
  if (word == "erf") {
    return Motion::along(path, MotionFrame::euler_rodrigues, request.scale).value();
  }
  if (word == "closing") {
    if (!path.is_closed()) {
      throw Error(
          unsupported("the frame closing belongs to closed paths; this path is open", "frame"));
    }
    return Motion::along(path, MotionFrame::closing, request.scale).value();
  }
  const AnyPath spatial = in_space(path);
  const PreimageTable table = PreimageTable::of(spatial).value();
  if (word == "rotation-minimising") {
    return Motion::along(spatial, rotation_minimising_roll(table).value(), request.scale).value();
  }
  if (word == "least-twist") {
    return Motion::along(spatial, least_twist_roll(table).value(), request.scale).value();
  }
  if (word == "frenet") {
    return Motion::along(spatial, frenet_roll(table).value(), request.scale).value();
  }
  const std::string& found = request.found_gamma;
  if (request.gamma) {
    gamma = *request.gamma;
  } else if (found.empty() || found == found_gammas[0]) {
    gamma = least_twist_gamma(table).value().gamma;
  } else {
    const SmoothGammas smooth = smooth_periodic_gammas(table).value();
    gamma = found == found_gammas[1] ? smooth.negative : smooth.positive;
  }
  return Motion::along(spatial, periodic_roll(table, *gamma).value(), request.scale).value();
}

/// The largest radius to 1/1024 of itself.
constexpr RangeGoal tube_goal{0x1p-10};

std::string suffix_of(const std::string& file) {
  std::string suffix = std::filesystem::path(file).extension().string();
  if (!suffix.empty()) suffix.erase(0, 1);
  for (char& c : suffix) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return suffix == "stp" ? "step" : suffix;
}

std::string format_of(const std::string& file, const std::string& format) {
  std::string word = format.empty() ? suffix_of(file) : format;
  for (const char* known : {"stl", "obj", "glb", "step"}) {
    if (word == known) return word;
  }
  throw Error(unsupported((file == "-" ? std::string("standard output") : "the name " + file) +
                              " does not tell the format; end it with .stl, .obj, .glb or .step, "
                              "or name the format",
                          "format"));
}

/// The format of a mesh that a word names; nothing for step and none.
std::optional<MeshFormat> mesh_kind(const std::string& format) {
  if (format == "stl") return MeshFormat::stl;
  if (format == "obj") return MeshFormat::obj;
  if (format == "glb") return MeshFormat::glb;
  return std::nullopt;
}

}  // namespace

std::string sweep_format(const std::string& file, const std::string& format) {
  return format_of(file, format);
}

TubeRadius tube_radius_of(const AnyPath& path) { return largest_tube_radius(path, tube_goal); }

namespace {

/// A hundredth of the profile's extent, where no tolerance is given.
double tolerance_of(const Sweep& sweep, const SweepRequest& request) {
  constexpr double fine_enough = 0.01;
  return request.tolerance ? *request.tolerance
                           : fine_enough * sweep.profile.extent() * sweep.motion.largest_scale();
}

void set_contact(MadeSweep& made) {
  const SweepContact contact = contact_of(made.sweep);
  made.certainly_free = contact.free;
  if (!contact.free && contact.pairs > 0) made.may_meet = {contact.xi[0], contact.xi[1]};
}

MadeSweep made_family(const AnyPath& path, const SweepRequest& request) {
  if (request.frame != "automatic" || request.gamma || !request.found_gamma.empty()) {
    throw Error(unsupported("a tubular family turns the path itself and takes no frame", "frame"));
  }
  const DynamicPolynomial<Vector3<double>> along(
      request.along.empty() ? std::vector<Vector3<double>>{{0.0, 0.0, 0.0}} : request.along);
  const DynamicPolynomial<Quaternion<double>> turn(
      request.turn.empty() ? std::vector<Quaternion<double>>{{1.0, 0.0, 0.0, 0.0}} : request.turn);
  MadeSweep made{
      Sweep{Motion::polynomial(along, turn, DynamicPolynomial<double>(request.scale)).value(),
            Profile::in_space(in_space(path)).value()},
      "",
      std::nullopt,
      {}};
  made.free_factor = 0.0;
  set_contact(made);
  made.tolerance = tolerance_of(made.sweep, request);
  return made;
}

std::string frame_of(const AnyPath& path, const SweepRequest& request) {
  if (request.frame != "automatic") return request.frame;
  return path.is_closed() ? "closing" : "erf";
}

}  // namespace

MadeTrack made_track(const AnyPath& path, const SweepRequest& request, double left, double up) {
  const std::string frame = frame_of(path, request);
  std::optional<double> gamma;
  const Motion motion = motion_of(path, request, frame, gamma);
  return {offset_track(motion, {0.0, left, up}).value(), frame};
}

Json json_of(const MadeTrack& track) {
  Json json;
  json["frame"] = track.frame;
  Json& curves = json["curves"] = Json::array();
  for (const auto& curve : track.curves) {
    Json points = Json::array();
    for (const auto& p : curve.control_points) points.push_back({p.x, p.y, p.z});
    curves.push_back({{"xi", {curve.begin, curve.end}},
                      {"degree", curve.degree()},
                      {"control_points", points},
                      {"weights", curve.weights}});
  }
  return json;
}

std::string csv_of(const MadeTrack& track, std::size_t per_curve) {
  std::string text;
  append_csv_header(text, std::array<std::string, 4>{"xi", "x", "y", "z"});
  for (std::size_t k = 0; k < track.curves.size(); ++k) {
    const auto& curve = track.curves[k];
    std::vector<Vector3<double>> weighted;
    for (std::size_t i = 0; i <= curve.degree(); ++i) {
      weighted.push_back(curve.weights[i] * curve.control_points[i]);
    }
    const DynamicPolynomial<Vector3<double>> top(weighted);
    const DynamicPolynomial<double> bottom(curve.weights);
    for (std::size_t i = k == 0 ? 0 : 1; i < per_curve; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(per_curve - 1);
      const Vector3<double> at = (1.0 / bottom.value(u)) * top.value(u);
      const double xi =
          i + 1 == per_curve ? curve.end : curve.begin + u * (curve.end - curve.begin);
      append_csv_row(text, std::array{xi, at.x, at.y, at.z});
    }
  }
  return text;
}

MadeSweep made_sweep(const AnyPath& path, const SweepRequest& request) {
  if (request.is_family()) return made_family(path, request);
  const std::string frame = frame_of(path, request);
  std::optional<double> gamma;
  Profile profile = profile_of(request);
  Motion motion = motion_of(path, request, frame, gamma);
  MadeSweep made{Sweep{std::move(motion), std::move(profile)}, frame, gamma, {}};
  made.tube = tube_radius_of(in_space(path));
  made.in_tube = is_certainly_free(made.sweep, made.tube);
  if (made.in_tube) {
    made.certainly_free = true;
  } else {
    set_contact(made);
  }
  if (!request.allow_contact && !made.certainly_free) {
    if (const auto fault = contact_fault(made.sweep, made.tube)) throw Error(*fault);
  }
  if (!made.certainly_free) made.free_factor = largest_free_factor(made.sweep, made.tube, 1.0);
  made.tolerance = tolerance_of(made.sweep, request);
  return made;
}

MeasuredMesh measured_mesh(const MadeSweep& made, const SweepRequest& request,
                           const std::string& format) {
  SweepMeshOptions options{made.tolerance, request.most_triangles, request.caps};
  MeasuredMesh result{mesh_of(made.sweep, options).value(), {}, 0.0};
  if (const auto kind = mesh_kind(format)) {
    result.rounding = rounding_of(result.made.mesh, *kind);
    if (result.rounding > 0.5 * made.tolerance) {
      throw Error(Fault{FaultCode::tolerance_not_reached,
                        "the coordinates of " + format + " are in single precision, here within " +
                            to_text(result.rounding) + "; the tolerance " +
                            to_text(made.tolerance) + " needs the format obj or step",
                        std::nullopt, "tolerance", made.tolerance, 2.0 * result.rounding});
    }
    if (result.made.deviation + result.rounding > made.tolerance) {
      options.tolerance = made.tolerance - result.rounding;
      result.made = mesh_of(made.sweep, options).value();
    }
  }
  result.facts = facts_of(result.made.mesh);
  return result;
}

std::optional<StepAnswer> write_sweep(const MadeSweep& made, const SweepRequest& request,
                                      const MeasuredMesh* mesh, const PathDocument& document,
                                      const std::string& file, const std::string& format) {
  const std::string name = document.name.empty() ? "sweep" : document.name;
  if (format == "step") {
    return write_step(made.sweep, {file, name, document.length_unit, request.caps});
  }
  if (const auto fault = save_mesh(mesh->made.mesh, *mesh_kind(format), name, file)) {
    throw Error(*fault);
  }
  return std::nullopt;
}

Json json_of(const MadeSweep& made, const MeasuredMesh& mesh) {
  const MeshFacts& facts = mesh.facts;
  Json json;
  if (!made.frame.empty()) {
    json["frame"] = made.frame;
    if (made.gamma) json["gamma"] = *made.gamma;
    json["tube"] = {{"radius", json_of(made.tube.radius)}, {"limit", name_of(made.tube.limit)}};
    json["outer_radius"] = outer_radius(made.sweep);
    json["certainly_free_of_contact"] = made.certainly_free;
    if (!made.certainly_free) json["free_factor"] = made.free_factor;
  } else {
    json["certainly_free_of_contact"] = made.certainly_free;
  }
  if (made.may_meet) json["may_meet"] = *made.may_meet;
  json["mesh"] = {{"tolerance", made.tolerance},
                  {"deviation", mesh.made.deviation + mesh.rounding},
                  {"rings", mesh.made.rings},
                  {"columns", mesh.made.columns},
                  {"positions", facts.positions},
                  {"edges", facts.edges},
                  {"triangles", facts.triangles},
                  {"euler_characteristic", facts.euler_characteristic},
                  {"boundary_edges", facts.boundary_edges},
                  {"closed", facts.is_closed()},
                  {"manifold", facts.is_manifold()},
                  {"area", facts.area}};
  if (facts.is_closed()) json["mesh"]["volume"] = facts.volume;
  const auto patches = rational_patches(made.sweep);
  if (patches) {
    std::size_t along = 0, round = 0;
    for (const auto& patch : *patches) {
      along = std::max(along, patch.degree_v);
      round = std::max(round, patch.degree_u);
    }
    json["patches"] = {
        {"count", patches->size()}, {"degree_along", along}, {"degree_round", round}};
  } else {
    json["patches"] = nullptr;
  }
  return json;
}

namespace {

/// ", undecided next to xi 0.2 and 0.7" where that is known.
std::string place_of_contact(const MadeSweep& made) {
  if (!made.may_meet) return "";
  const auto& [first, second] = *made.may_meet;
  return ", undecided next to xi " + to_six_digits(first) +
         (first == second ? "" : " and " + to_six_digits(second));
}

}  // namespace

std::vector<std::pair<std::string, std::string>> rows_of(const MadeSweep& made,
                                                         const MeasuredMesh* mesh,
                                                         const std::string& unit) {
  const std::string in_unit = unit.empty() ? "" : " " + unit;
  std::vector<std::pair<std::string, std::string>> rows;
  if (made.frame.empty()) {
    rows.emplace_back("Surface", "a tubular family");
    rows.emplace_back("Contact with itself", made.certainly_free
                                                 ? "none, certified"
                                                 : "not excluded" + place_of_contact(made));
  } else {
    rows.emplace_back("Frame", made.frame + (made.gamma ? ", gamma " + to_six_digits(*made.gamma)
                                                        : std::string()));
    const double radius = made.tube.radius.lower();
    rows.emplace_back("Free tube radius",
                      made.tube.radius.upper() == std::numeric_limits<double>::infinity()
                          ? "any"
                          : to_six_digits(radius) + in_unit + ", limited by " +
                                name_of(made.tube.limit) + ", certified");
    rows.emplace_back(
        "Contact with itself",
        made.in_tube ? "none, certified: within " + to_six_digits(outer_radius(made.sweep)) +
                           in_unit + " of the path"
        : made.certainly_free
            ? "none, certified by the profile's extent in each direction"
            : "not excluded: it reaches " + to_six_digits(outer_radius(made.sweep)) + in_unit +
                  " from the path" + place_of_contact(made) +
                  (made.free_factor > 0.0
                       ? "; none, certified, " + to_six_digits(made.free_factor) + " times as large"
                       : std::string()));
  }
  if (mesh == nullptr) return rows;
  const MeshFacts& facts = mesh->facts;
  rows.emplace_back("Triangles", std::to_string(facts.triangles) + ", " +
                                     std::to_string(mesh->made.rings) + " rings of " +
                                     std::to_string(mesh->made.columns) + " points");
  rows.emplace_back("Mesh", std::string(facts.is_closed() ? "closed" : "with boundary") +
                                (facts.is_manifold() ? ", manifold, oriented" : ", NOT manifold") +
                                ", Euler characteristic " +
                                std::to_string(facts.euler_characteristic));
  rows.emplace_back("Deviation", "at most " + to_six_digits(mesh->made.deviation + mesh->rounding) +
                                     in_unit + ", certified");
  rows.emplace_back("Area", to_six_digits(facts.area) + (unit.empty() ? "" : in_unit + "^2"));
  if (facts.is_closed()) {
    rows.emplace_back("Volume", to_six_digits(facts.volume) + (unit.empty() ? "" : in_unit + "^3"));
  }
  return rows;
}

ReportData report_of(const MadeSweep& made, const SweepRequest& request,
                     const PathDocument& document,
                     std::vector<std::pair<std::string, std::string>> rows, bool drawn) {
  ReportData data;
  data.title = document.name.empty() ? "Swept surface" : document.name;
  data.segments = document.path.segment_count();
  data.preimage_degree = document.path.preimage_degree();
  data.closed = document.path.is_closed();
  data.length_unit = document.length_unit;
  data.parameter_unit = document.parameter_unit;
  data.dimension = document.path.dimension();
  data.more = std::move(rows);
  if (!drawn) return data;
  data.first_heading = "The surface";
  constexpr std::size_t most_drawn = 12'000;  // triangles, some megabyte of SVG
  constexpr int attempts = 24;
  SweepMeshOptions options{made.tolerance, most_drawn, request.caps};
  for (int i = 0; i < attempts && data.drawings.empty(); ++i, options.tolerance *= 4.0) {
    const auto mesh = mesh_of(made.sweep, options);
    if (!mesh) continue;
    MeshView view;
    view.closed = made.sweep.profile.is_closed() &&
                  (made.sweep.motion.is_closed() || mesh->cap_triangles > 0);
    data.drawings.emplace_back("Seen from the side.", mesh_svg(mesh->mesh, view));
    constexpr double quarter_turn = 0.5 * std::numbers::pi;
    view.azimuth = -quarter_turn;
    view.elevation = quarter_turn;
    data.drawings.emplace_back("Seen from above: x to the right, y up.",
                               mesh_svg(mesh->mesh, view));
  }
  constexpr std::size_t drawn_points = 600;
  data.path = framed_polyline(document, drawn_points, 0);
  return data;
}

}  // namespace hodograph::cli
