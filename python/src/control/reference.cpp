// SPDX-License-Identifier: MIT
// Paths as a solver needs them: control/reference_path.hpp, path_coordinates.hpp.
#include "hodograph/control/reference_path.hpp"

#include <cmath>
#include <string>
#include <variant>
#include <vector>

#include "hodograph/control/path_coordinates.hpp"
#include "python/src/control/solving.hpp"

namespace hodograph::python {

namespace {

using Plane = Complex<double>;
using Space = Quaternion<double>;

/// A reference of either dimension.
struct Reference {
  AnyPath path;
  std::variant<ReferencePath<Plane>, ReferencePath<Space>> either;

  template <class Function>
  auto visit(const Function& function) const {
    return std::visit(function, either);
  }
};

Reference reference_of(const AnyPath& path, ProgressBy by) {
  return unlocked([&] {
    if (path.dimension() == 2) return Reference{path, ReferencePath<Plane>::of(path, by).value()};
    return Reference{path, ReferencePath<Space>::of(path, by).value()};
  });
}

/// Jets at many places, each with its two derivatives in front.
struct Jets {
  Doubles position, body_rate, speed;
  Doubles frame;  // rows are components, columns axes
};

template <class A>
Jets jets_at(const ReferencePath<A>& reference, const Doubles& progress) {
  constexpr auto d = static_cast<py::ssize_t>(point_t<A>::dimension);
  const auto with = [&](const Shape& tail) {
    Shape shape = shape_of(progress);
    shape.push_back(3);
    shape.insert(shape.end(), tail.begin(), tail.end());
    return Doubles(shape);
  };
  Jets made{with({d}), with(d == 3 ? Shape{3} : Shape{}), with({}), with({d, d})};
  double *p = made.position.mutable_data(), *w = made.body_rate.mutable_data(),
         *s = made.speed.mutable_data(), *f = made.frame.mutable_data();
  const auto from = numbers(progress);
  unlocked([&] {
    std::vector<ReferenceJet<A>> jets(from.size());
    reference.at(from, jets);
    for (const auto& jet : jets) {
      for (std::size_t r = 0; r < 3; ++r) {
        for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
          *p++ = jet.position[r][i];
          *f++ = jet.frame[r].e1[i];
          *f++ = jet.frame[r].e2[i];
          if constexpr (d == 3) *f++ = jet.frame[r].e3[i];
        }
        if constexpr (d == 3) {
          for (std::size_t i = 0; i < 3; ++i) *w++ = jet.body_rate[r][i];
        } else {
          *w++ = jet.body_rate[r];
        }
        *s++ = jet.speed[r];
      }
    }
  });
  return made;
}

/// The offset (1,) or a number in the plane, (2,) in space.
template <class A>
auto offset_of(const Doubles& offset) {
  constexpr std::size_t count = A::dimension == 2 ? 1 : 2;
  const bool fits = static_cast<std::size_t>(offset.size()) == count && offset.ndim() <= 1;
  if (!fits) refuse_shape("offset", count == 1 ? "() or (1,)" : "(2,)", offset);
  require_finite(numbers(offset), "offset");
  std::array<double, count> eta{};
  for (std::size_t i = 0; i < count; ++i) eta[i] = offset.data()[i];
  return eta;
}

template <class P>
struct AlgebraOf;
template <class A>
struct AlgebraOf<ReferencePath<A>> {
  using type = A;
};

void bind_coordinates(py::module_& m) {
  m.def(
      "progress_stretch",
      [](const Reference& reference, double progress, const Doubles& offset) {
        require_finite({&progress, 1}, "progress");
        return reference.visit([&](const auto& r) {
          using A = typename AlgebraOf<std::remove_cvref_t<decltype(r)>>::type;
          return progress_stretch(r.value(progress), offset_of<A>(offset));
        });
      },
      py::arg("reference"), py::arg("progress"), py::arg("offset"),
      "h = sigma - eta_2 chi_3 + eta_3 chi_2 (in the plane sigma - eta chi); coordinates are "
      "regular where h > 0.");
  m.def(
      "place_of",
      [](const Reference& reference, double progress, const Doubles& offset) {
        require_finite({&progress, 1}, "progress");
        return reference.visit([&](const auto& r) {
          using A = typename AlgebraOf<std::remove_cvref_t<decltype(r)>>::type;
          return array_of(place_of(r.value(progress), offset_of<A>(offset)));
        });
      },
      py::arg("reference"), py::arg("progress"), py::arg("offset"),
      "The point r + eta_2 e2 + eta_3 e3 (in the plane r + eta e2), (d,).");
  m.def(
      "coordinate_rates",
      [](const Reference& reference, double progress, const Doubles& offset,
         const Doubles& velocity) {
        require_finite({&progress, 1}, "progress");
        require_finite(numbers(velocity), "velocity");
        return reference.visit([&](const auto& r) {
          using A = typename AlgebraOf<std::remove_cvref_t<decltype(r)>>::type;
          const auto rates = coordinate_rates(r.value(progress), offset_of<A>(offset),
                                              point_of<point_t<A>>(velocity, "velocity"));
          return array_of(std::vector<double>(rates.begin(), rates.end()));
        });
      },
      py::arg("reference"), py::arg("progress"), py::arg("offset"), py::arg("velocity"),
      "The rates of progress and offset of a point with a velocity (d,): (3,) in space, (2,) in "
      "the plane.");
  Record<OffsetLimits>(m, "OffsetLimits",
                       "How far a path may be left to its sides such that its coordinates are "
                       "regular.")
      .field("left", &OffsetLimits::left, "Infinite where no bend limits it; in space to any side.")
      .field("right", &OffsetLimits::right)
      .field("curvature_minimum", &OffsetLimits::curvature_minimum)
      .field("curvature_maximum", &OffsetLimits::curvature_maximum);
  m.def(
      "offset_limits",
      [](const AnyPath& path) { return unlocked([&] { return offset_limits(path); }); },
      py::arg("path"), "The largest offsets with h > 0 at every xi, certified.");
}

}  // namespace

void bind_reference(py::module_& m) {
  py::enum_<ProgressBy>(m, "ProgressBy", "What a place on a reference is named by.")
      .value("xi", ProgressBy::xi)
      .value("arc_length", ProgressBy::arc_length);
  Record<Jets>(m, "ReferenceJet",
               "Position, frame, angular velocity and speed, each with two derivatives by the "
               "progress: the\nfirst axis after the places counts the derivatives, 0 to 2.")
      .field("position", &Jets::position, "(..., 3, d).")
      .field("frame", &Jets::frame, "(..., 3, d, d), the axes as columns.")
      .field("body_rate", &Jets::body_rate, "(..., 3, 3) in space, (..., 3) in the plane.")
      .field("speed", &Jets::speed, "(..., 3).");
  py::class_<Reference>(m, "ReferencePath",
                        "A path as a solver needs it: everything with two exact derivatives at any "
                        "progress, fast.")
      .def(py::init(&reference_of), py::arg("path"), py::arg("progress_by") = ProgressBy::xi)
      .def_readonly("path", &Reference::path)
      .def_property_readonly(
          "progress_by",
          [](const Reference& r) { return r.visit([](const auto& p) { return p.progress_by(); }); })
      .def_property_readonly(
          "begin",
          [](const Reference& r) { return r.visit([](const auto& p) { return p.begin(); }); })
      .def_property_readonly(
          "end", [](const Reference& r) { return r.visit([](const auto& p) { return p.end(); }); })
      .def_property_readonly(
          "is_periodic",
          [](const Reference& r) { return r.visit([](const auto& p) { return p.is_periodic(); }); })
      .def(
          "xi_of",
          [](const Reference& r, const Doubles& progress) {
            require_finite(numbers(progress), "progress");
            return numbers_like(progress, [&](auto from, auto to) {
              r.visit([&](const auto& p) {
                for (std::size_t i = 0; i < from.size(); ++i) to[i] = p.xi_of(from[i]);
              });
            });
          },
          py::arg("progress"), "xi of a progress.")
      .def(
          "progress_of",
          [](const Reference& r, const Doubles& xi) {
            require_finite(numbers(xi), "xi");
            return numbers_like(xi, [&](auto from, auto to) {
              r.visit([&](const auto& p) {
                for (std::size_t i = 0; i < from.size(); ++i) to[i] = p.progress_of(from[i]);
              });
            });
          },
          py::arg("xi"), "The progress of a xi.")
      .def(
          "at",
          [](const Reference& r, const Doubles& progress) {
            require_finite(numbers(progress), "progress");
            return r.visit([&](const auto& p) { return jets_at(p, progress); });
          },
          py::arg("progress"),
          "The jets at numbers or arrays; beyond the ends the first and the last polynomial go on, "
          "or round.")
      .def("__repr__",
           [](const Reference& r) {
             return r.visit([](const auto& p) {
               return "<hodograph.ReferencePath: progress from " + to_text(p.begin()) + " to " +
                      to_text(p.end()) + (p.is_periodic() ? ", periodic>" : ">");
             });
           })
      .def(
          "__eq__",
          [](const Reference& a, const Reference& b) {
            const auto by = [](const Reference& r) {
              return r.visit([](const auto& p) { return p.progress_by(); });
            };
            return a.path == b.path && by(a) == by(b);
          },
          py::is_operator())
      .def(py::pickle(
          [](const Reference& r) {
            return py::make_tuple(r.path, r.visit([](const auto& p) { return p.progress_by(); }));
          },
          [](const py::tuple& t) {
            return reference_of(t[0].cast<AnyPath>(), t[1].cast<ProgressBy>());
          }));
  bind_coordinates(m);
}

}  // namespace hodograph::python
