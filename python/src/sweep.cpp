// SPDX-License-Identifier: MIT
// Profiles, motions and the surfaces they sweep: surface/profile.hpp, motion.hpp, sweep.hpp,
// sweep_contact.hpp.
#include "hodograph/surface/sweep.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/surface/sweep_contact.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/swept.hpp"

namespace hodograph::python {

namespace {

void bind_profile(py::module_& m) {
  py::enum_<Profile::SelfContact>(m, "SelfContact",
                                  "Whether a profile that touches or crosses itself is refused.")
      .value("refuse", Profile::SelfContact::refuse)
      .value("allow", Profile::SelfContact::allow);
  made_class<Profile>(m, "Profile",
                      "The curve that a sweep carries: (x, y) along e2 and e3 of the frame; closed "
                      "for tubes, open for\nribbons.")
      .def_static(
          "circle",
          [](double radius) { return made(Profile::circle(radius).value(), "circle", radius); },
          py::arg("radius"), "The circle about the path. Raises HodographError: outside_domain.")
      .def_static(
          "ellipse",
          [](double a, double b) { return made(Profile::ellipse(a, b).value(), "ellipse", a, b); },
          py::arg("a"), py::arg("b"), "Half axes a along e2 and b along e3.")
      .def_static(
          "polygon",
          [](const Doubles& corners) {
            return made(Profile::polygon(points_of<Vector2<double>>(corners, "corners")).value(),
                        "polygon", corners);
          },
          py::arg("corners"), "The closed polygon with these corners, (n, 2).")
      .def_static(
          "polyline",
          [](const Doubles& points) {
            return made(Profile::polyline(points_of<Vector2<double>>(points, "points")).value(),
                        "polyline", points);
          },
          py::arg("points"),
          "The open polyline through points (n, 2): a ribbon. Its first coordinate is along e2, to "
          "the left.")
      .def_static(
          "of",
          [](const AnyPath& path, Profile::SelfContact contact) {
            auto profile = unlocked([&] { return Profile::of(path, contact).value(); });
            return made(std::move(profile), "of", path, contact);
          },
          py::arg("path"), py::arg("contact") = Profile::SelfContact::refuse,
          "A planar path as a profile, closed as the path is.")
      .def_static(
          "of",
          [](const std::vector<RationalBezier>& pieces, bool closed, Profile::SelfContact contact) {
            return made(Profile::of(pieces, closed, contact).value(), "of", pieces, closed,
                        contact);
          },
          py::arg("pieces"), py::arg("closed"), py::arg("contact") = Profile::SelfContact::refuse,
          "Rational curves in sequence.")
      .def_static(
          "in_space",
          [](const AnyPath& path) {
            return made(Profile::in_space(path).value(), "in_space", path);
          },
          py::arg("path"), "A path in space, by components along e1, e2, e3: for tubular families.")
      .def_static(
          "in_space",
          [](const std::vector<SpatialRationalBezier>& pieces, bool closed) {
            return made(Profile::in_space(pieces, closed).value(), "in_space", pieces, closed);
          },
          py::arg("pieces"), py::arg("closed"), "Rational curves in space in sequence.")
      .def_property_readonly("pieces", &Profile::pieces, "The exact curves, x along e1.")
      .def_property_readonly("is_closed", &Profile::is_closed)
      .def_property_readonly("is_planar", &Profile::is_planar)
      .def_property_readonly("circle_radius", &Profile::circle_radius, "None unless a circle.")
      .def_property_readonly("reach", &Profile::reach, "An upper bound of |p|.")
      .def_property_readonly("extent", &Profile::extent,
                             "An upper bound of the distance of two of its points.")
      .def_property_readonly("smooth_piece_count", &Profile::smooth_piece_count,
                             "Pieces that point_of counts: a circle is one.")
      .def("__repr__", [](const Profile& profile) {
        return std::string("<hodograph.Profile: ") + (profile.is_closed() ? "closed, " : "open, ") +
               std::to_string(profile.pieces().size()) + " pieces>";
      });
}

const MotionPiece& piece_of(const Motion& motion, std::size_t piece) {
  if (piece < motion.pieces().size()) return motion.pieces()[piece];
  throw Error(Fault{FaultCode::outside_domain,
                    "the motion has " + std::to_string(motion.pieces().size()) +
                        " pieces, counted from 0; got " + std::to_string(piece),
                    std::nullopt, "piece", static_cast<double>(piece),
                    static_cast<double>(motion.pieces().size() - 1)});
}

void require_unit(double v, const char* name) {
  if (v >= 0.0 && v <= 1.0) return;
  throw Error(Fault{FaultCode::outside_domain,
                    std::string("the local parameter ") + name + " is " + to_text(v) +
                        "; it should lie between 0 and 1",
                    std::nullopt, name, v, v < 0.0 ? 0.0 : 1.0});
}

template <class Point>
DynamicPolynomial<Point> polynomial_of(const Doubles& array, const char* name) {
  auto points = points_of<Point>(array, name);
  if (points.empty()) refuse_shape(name, "at least one row", array);
  return DynamicPolynomial<Point>(std::move(points));
}

void bind_motion(py::module_& m) {
  py::enum_<MotionFrame>(m, "MotionFrame", "Which frame goes along a path.")
      .value("euler_rodrigues", MotionFrame::euler_rodrigues)
      .value("closing", MotionFrame::closing, "Turned so that it returns on a closed path.");
  Record<MotionPiece>(m, "MotionPiece", "A piece of a motion; Bernstein coefficients on [0, 1].")
      .field("begin", &MotionPiece::begin)
      .field("end", &MotionPiece::end)
      .field("start", &MotionPiece::start, "c = start + displacement, (3,).")
      .field("displacement", &MotionPiece::displacement, "(m, 3).")
      .field("preimage", &MotionPiece::preimage, "(k, 4).")
      .field("scale", &MotionPiece::scale, "(j,).");
  Record<MotionState>(m, "MotionState", "Where a motion is, per unit of the local parameter.")
      .field("position", &MotionState::position)
      .field("velocity", &MotionState::velocity)
      .field("frame", &MotionState::frame, "The axes as columns, (3, 3).")
      .field("body_rate", &MotionState::body_rate)
      .field("scale", &MotionState::scale)
      .field("scale_rate", &MotionState::scale_rate);
  const auto one = [] {
    Doubles scale(1);
    *scale.mutable_data() = 1.0;
    return scale;
  };
  made_class<Motion>(m, "Motion", "What carries a profile: places, frames and a scale.")
      .def_static(
          "along",
          [](const AnyPath& path, MotionFrame frame, const Doubles& scale) {
            const auto factors = numbers_of(scale, "scale");
            auto motion = unlocked([&] { return Motion::along(path, frame, factors).value(); });
            return made(std::move(motion), "along", path, frame, scale);
          },
          py::arg("path"), py::arg("frame") = MotionFrame::closing, py::arg("scale") = one(),
          "Along a path; scale: Bernstein coefficients of the profile's size over the whole of it. "
          "Raises\nHodographError: outside_domain, not_continuous, zero_speed.")
      .def_static(
          "along",
          [](const AnyPath& path, const Made<FrameRoll>& roll, const Doubles& scale) {
            const auto factors = numbers_of(scale, "scale");
            auto motion = unlocked([&] { return Motion::along(path, roll, factors).value(); });
            return made(std::move(motion), "along", path, roll, scale);
          },
          py::arg("path"), py::arg("roll"), py::arg("scale") = one(),
          "Along a path with a roll made for it.")
      .def_static(
          "polynomial",
          [](const Doubles& position, const Doubles& rotation, const Doubles& scale) {
            auto factors = numbers_of(scale, "scale");
            if (factors.empty()) refuse_shape("scale", "(n,) with at least one number", scale);
            auto motion =
                Motion::polynomial(polynomial_of<Vector3<double>>(position, "position"),
                                   polynomial_of<Quaternion<double>>(rotation, "rotation"),
                                   DynamicPolynomial<double>(std::move(factors)))
                    .value();
            return made(std::move(motion), "polynomial", position, rotation, scale);
          },
          py::arg("position"), py::arg("rotation"), py::arg("scale") = one(),
          "Any polynomial motion over [0, 1] by Bernstein coefficients (m, 3), (k, 4), (j,).")
      .def_property_readonly("pieces", &Motion::pieces)
      .def_property_readonly("is_closed", &Motion::is_closed)
      .def_property_readonly("is_adapted", &Motion::is_adapted, "Whether e1 is the tangent.")
      .def_property_readonly("largest_scale", &Motion::largest_scale, "An upper bound.")
      .def_property_readonly("least_scale", &Motion::least_scale, "A lower bound.")
      .def(
          "at",
          [](const Motion& motion, std::size_t piece, double v) {
            piece_of(motion, piece);
            require_unit(v, "v");
            return motion.at(piece, v);
          },
          py::arg("piece"), py::arg("v"), "The state at v in [0, 1] of a piece.")
      .def("__repr__", [](const Motion& motion) {
        return "<hodograph.Motion: " + std::to_string(motion.pieces().size()) +
               (motion.is_closed() ? " pieces, closed>" : " pieces>");
      });
}

/// SurfacePoint at many parameters.
struct SurfacePoints {
  Doubles position, normal;
};

SurfacePoints points_at(const Sweep& sweep, std::size_t piece, const Doubles& v,
                        std::size_t smooth_piece, const Doubles& w) {
  piece_of(sweep.motion, piece);
  if (smooth_piece >= sweep.profile.smooth_piece_count()) {
    throw Error(Fault{FaultCode::outside_domain,
                      "the profile has " + std::to_string(sweep.profile.smooth_piece_count()) +
                          " smooth pieces, counted from 0; got " + std::to_string(smooth_piece),
                      std::nullopt, "smooth_piece", static_cast<double>(smooth_piece),
                      static_cast<double>(sweep.profile.smooth_piece_count() - 1)});
  }
  const auto both = py::module_::import("numpy").attr("broadcast_arrays")(v, w);
  const Doubles at_v(both.attr("__getitem__")(0)), at_w(both.attr("__getitem__")(1));
  const auto ws = numbers(at_w);
  Shape shape = shape_of(at_v);
  shape.push_back(3);
  Doubles normals(shape);
  double* normal = normals.mutable_data();
  Doubles positions = filled_like(at_v, {3}, [&](auto vs, auto to) {
    for (std::size_t i = 0; i < vs.size(); ++i) {
      require_unit(vs[i], "v");
      require_unit(ws[i], "w");
      const SurfacePoint point = point_of(sweep, piece, vs[i], smooth_piece, ws[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        to[3 * i + j] = point.position[j];
        normal[3 * i + j] = point.normal[j];
      }
    }
  });
  return {positions, normals};
}

void bind_surface(py::module_& m) {
  made_class<Sweep>(m, "Sweep", "The surface that a profile sweeps along a motion, exactly.")
      .def(py::init([](const Made<Motion>& motion, const Made<Profile>& profile) {
             return made(Sweep{motion, profile}, "", motion, profile);
           }),
           py::arg("motion"), py::arg("profile"))
      .def_property_readonly(
          "motion", [](const Made<Sweep>& self) { return self.of[0].cast<const Made<Motion>&>(); })
      .def_property_readonly(
          "profile",
          [](const Made<Sweep>& self) { return self.of[1].cast<const Made<Profile>&>(); })
      .def("__repr__", [](const Made<Sweep>& self) {
        return "Sweep(" + std::string(py::repr(self.of[0])) + ", " +
               std::string(py::repr(self.of[1])) + ")";
      });
  Record<SurfacePoints>(m, "SurfacePoint", "Points of a sweep and the unit normals there.")
      .field("position", &SurfacePoints::position, "(..., 3).")
      .field("normal", &SurfacePoints::normal, "(..., 3); outwards for a closed profile.");
  m.def("point_of", &points_at, py::arg("sweep"), py::arg("piece"), py::arg("v"),
        py::arg("smooth_piece"), py::arg("w"),
        "Points at v of a piece of the motion and w of a smooth piece of the profile, which are "
        "broadcast,\nboth in [0, 1].");
  m.def(
      "rational_patches",
      [](const Sweep& sweep) { return unlocked([&] { return rational_patches(sweep).value(); }); },
      py::arg("sweep"),
      "The surface as exact rational Bezier patches with positive weights. Raises HodographError:\n"
      "unsupported (a roll that is not rational), zero_speed.");
  m.def(
      "offset_track",
      [](const Motion& motion, const Doubles& point) {
        return offset_track(motion, hodograph::python::point_of<Vector3<double>>(point, "point"))
            .value();
      },
      py::arg("motion"), py::arg("point"),
      "The track of one point of the frame, (3,), as exact rational Bezier curves.");
  m.def(
      "in_space", [](const AnyPath& path) { return in_space(path); }, py::arg("path"),
      "A planar path in z = 0 of space with the frame (tangent, left normal, k); a spatial one as "
      "it is.");
}

void bind_contact(py::module_& m) {
  py::enum_<SweepFold::Kind>(m, "SweepFoldKind", "Whether a sweep folds.")
      .value("none", SweepFold::Kind::none, "Certainly it advances.")
      .value("certain", SweepFold::Kind::certain, "It certainly does not, at xi.")
      .value("undecided", SweepFold::Kind::undecided);
  Record<SweepFold>(m, "SweepFold", "Whether a sweep advances everywhere.")
      .field("kind", &SweepFold::kind)
      .field("xi", &SweepFold::xi, "Where it folds, or may.");
  m.def("fold_of", &fold_of, py::arg("sweep"), py::call_guard<py::gil_scoped_release>(),
        "Whether cross-sections near each other meet: the surface then folds.");
  m.def("outer_radius", &outer_radius, py::arg("sweep"),
        "An upper bound of the distance of the surface from the path.");
  m.def(
      "contact_fault",
      [](const Sweep& sweep, const TubeRadius& tube) -> std::optional<std::string> {
        if (const auto fault = unlocked([&] { return contact_fault(sweep, tube); })) {
          return fault->sentence;
        }
        return std::nullopt;
      },
      py::arg("sweep"), py::arg("tube"),
      "Why a sweep certainly folds or may touch itself, as a sentence that says what would do; "
      "None where\nit may be made. `tube` is largest_tube_radius of the path.");
  m.def("is_certainly_free", &is_certainly_free, py::arg("sweep"), py::arg("tube"),
        "Whether the sweep lies inside the largest tube that does not touch itself.");
  Record<SweepContact>(m, "SweepContact", "What is known of the contact of a sweep with itself.")
      .field("free", &SweepContact::free, "Certainly no two cross-sections meet.")
      .field("xi", &SweepContact::xi, "Where this was not decided, (2,).")
      .field("pairs", &SweepContact::pairs, "Parts compared.");
  m.def(
      "contact_of",
      [](const Sweep& sweep, double factor) {
        if (!(factor > 0.0) || !std::isfinite(factor)) {
          throw Error(
              Fault{FaultCode::outside_domain,
                    "the factor of a profile is a positive, finite number; got " + to_text(factor),
                    std::nullopt, "factor", factor, 0.0});
        }
        return unlocked([&] { return contact_of(sweep, factor); });
      },
      py::arg("sweep"), py::arg("factor") = 1.0,
      "Whether the sweep, its profile `factor` times as large, is certainly free of contact with "
      "itself.");
  m.def(
      "largest_free_factor",
      [](const Sweep& sweep, const TubeRadius& tube, double most) {
        return unlocked([&] { return largest_free_factor(sweep, tube, most); });
      },
      py::arg("sweep"), py::arg("tube"), py::arg("most") = 64.0,
      "The largest factor of the profile that contact_of certifies, to 2^-10; 0 where none is.");
}

}  // namespace

void bind_sweep(py::module_& m) {
  bind_profile(m);
  bind_motion(m);
  bind_surface(m);
  bind_contact(m);
}

}  // namespace hodograph::python
