// SPDX-License-Identifier: MIT
// Closed loops, which of them to take, and what is certain of one: construction/closed_loop.hpp,
// loop_choice.hpp, loop_facts.hpp, start_frame.hpp.
#include "hodograph/construction/closed_loop.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "hodograph/construction/loop_choice.hpp"
#include "hodograph/construction/loop_facts.hpp"
#include "hodograph/construction/start_frame.hpp"
#include "hodograph/path/any_operations.hpp"
#include "python/src/bindings.hpp"
#include "python/src/convert.hpp"
#include "python/src/curves.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

namespace {

using Point = Vector3<double>;

struct Chosen {
  LoopShape shape;
  double roll = 0.0;
  AnyPath path = unit_line();
  Enclosure value;
  std::array<double, 3> grid_steps{};
  std::size_t evaluations = 0;
};
struct Facts {
  Extremes speed, curvature, torsion;
  std::optional<Enclosure> energy;
  std::vector<Extremes> box;
  TubeRadius tube;
};
struct Juncture {
  double curvature = 0.0, torsion_begin = 0.0, torsion_end = 0.0;
};

LoopPlacement placement_of(double length, const std::optional<Doubles>& start,
                           const std::optional<Doubles>& frame) {
  LoopPlacement placement;
  placement.length = length;
  if (start) placement.start = point_of<Point>(*start, "start");
  if (frame) placement.frame = point_of<Quaternion<double>>(*frame, "frame");
  return placement;
}

Chosen choose(LoopPurpose purpose, const std::optional<Doubles>& point,
              const std::optional<Doubles>& extents, const std::optional<Doubles>& within,
              std::optional<double> xi, std::optional<double> psi, bool free_roll,
              double largest_xi, double length, const std::optional<Doubles>& start,
              const std::optional<Doubles>& frame) {
  LoopWish wish;
  wish.purpose = purpose;
  const auto wanted = [](const char* name) {
    throw Error(Fault{FaultCode::mismatched_size,
                      std::string("this purpose needs `") + name + "`, three numbers; got none",
                      std::nullopt, name, 0.0, 3.0});
  };
  if (point) wish.point = point_of<Point>(*point, "point");
  if (extents) wish.extents = point_of<Point>(*extents, "extents");
  if (!point && purpose == LoopPurpose::near_point) wanted("point");
  if (!extents && purpose == LoopPurpose::extents) wanted("extents");
  if (within) {
    const auto corners = points_of<Point>(*within, "within");
    if (corners.size() != 2) refuse_shape("within", "(2, 3): low and high", *within);
    wish.within = LoopBox{corners[0], corners[1]};
  }
  wish.xi = xi;
  wish.psi = psi;
  wish.free_roll = free_roll;
  wish.largest_xi = largest_xi;
  const LoopPlacement placement = placement_of(length, start, frame);
  auto made = unlocked([&] { return choose_loop(placement, wish).value(); });
  return {made.shape, made.roll,       AnyPath(std::move(made.path)),
          made.value, made.grid_steps, made.evaluations};
}

Facts facts_of_loop(const AnyPath& path) {
  const AnyPath own = path.dimension() == 3 && path.preimage_degree() < 3
                          ? with_preimage_degree(path, 3).value()
                          : path;
  const auto* loop = own.get_if<SpatialPath<3>>();
  if (loop == nullptr) {
    throw Error(Fault{FaultCode::unsupported,
                      "a loop is a path in space of degree 7; this one is of degree " +
                          std::to_string(path.degree()) + " in " +
                          std::to_string(path.dimension()) + " dimensions",
                      std::nullopt, "degree", static_cast<double>(path.degree()), 7.0});
  }
  auto facts = unlocked([&] { return loop_facts(*loop); });
  return {facts.speed,
          facts.curvature,
          facts.torsion,
          facts.energy,
          {facts.box.begin(), facts.box.end()},
          std::move(facts.tube)};
}

void bind_types(py::module_& m) {
  Record<LoopShape> shape(m, "LoopShape", "Which member of the family of loops.");
  shape.def(py::init([](double xi, double psi) {
              return LoopShape{xi, psi};
            }),
            py::arg("xi") = 0.0, py::arg("psi") = LoopShape{}.psi);
  shape.field("xi", &LoopShape::xi, "Any number; +-inf are the limit members.")
      .field("psi", &LoopShape::psi, "In [-pi, pi]: half the roll of the frame round the loop.");
  py::enum_<LoopPurpose>(m, "LoopPurpose", "What is least in the chosen loop.")
      .value("least_energy", LoopPurpose::least_energy)
      .value("least_torsion_range", LoopPurpose::least_torsion_range)
      .value("near_point", LoopPurpose::near_point)
      .value("extents", LoopPurpose::extents);
  Record<Juncture>(m, "LoopJuncture", "Curvature and torsion where a loop of length 1 closes.")
      .field("curvature", &Juncture::curvature)
      .field("torsion_begin", &Juncture::torsion_begin)
      .field("torsion_end", &Juncture::torsion_end);
  Record<Chosen>(m, "ChosenLoop", "A loop chosen for a purpose.")
      .field("shape", &Chosen::shape)
      .field("roll", &Chosen::roll, "Of the frame beyond the one given, radians.")
      .field("path", &Chosen::path)
      .field("value", &Chosen::value, "Contains what the purpose makes least.")
      .field("grid_steps", &Chosen::grid_steps, "Of the search: arctan xi, psi, roll; 0: held.")
      .field("evaluations", &Chosen::evaluations);
  Record<Facts>(m, "LoopFacts", "What is certain of a loop, enclosed.")
      .field("speed", &Facts::speed)
      .field("curvature", &Facts::curvature)
      .field("torsion", &Facts::torsion)
      .field("energy", &Facts::energy, "None for limit members.")
      .field("box", &Facts::box, "Of each coordinate.")
      .field("tube", &Facts::tube);
}

}  // namespace

void bind_loop(py::module_& m) {
  bind_types(m);
  m.def(
      "closed_loop",
      [](double xi, double psi, double length, const std::optional<Doubles>& start,
         const std::optional<Doubles>& frame) -> AnyPath {
        return closed_loop({xi, psi}, placement_of(length, start, frame)).value();
      },
      py::arg("xi") = 0.0, py::arg("psi") = LoopShape{}.psi, py::kw_only(), py::arg("length") = 1.0,
      py::arg("start") = py::none(), py::arg("frame") = py::none(),
      "The closed loop of degree 7 of exactly this length from a start (3,), its Frenet frame "
      "there a unit\nquaternion (4,). Raises HodographError: not_finite, outside_domain.");
  m.def(
      "closed_loop_control_points",
      [](double xi, double psi) {
        const auto points = closed_loop_control_points({xi, psi}).value();
        return array_of(std::vector<Point>(points.begin(), points.end()));
      },
      py::arg("xi") = 0.0, py::arg("psi") = LoopShape{}.psi,
      "The Bezier control points (8, 3) of the canonical loop, in closed form.");
  m.def(
      "closed_loop_juncture",
      [](double xi, double psi) {
        const auto found = closed_loop_juncture({xi, psi}).value();
        return Juncture{found.curvature, found.torsion_begin, found.torsion_end};
      },
      py::arg("xi") = 0.0, py::arg("psi") = LoopShape{}.psi,
      "Curvature and torsion where the loop of length 1 closes; infinite for limit members.");
  m.def("choose_loop", &choose, py::arg("purpose") = LoopPurpose::least_energy, py::kw_only(),
        py::arg("point") = py::none(), py::arg("extents") = py::none(),
        py::arg("within") = py::none(), py::arg("xi") = py::none(), py::arg("psi") = py::none(),
        py::arg("free_roll") = false, py::arg("largest_xi") = LoopWish{}.largest_xi,
        py::arg("length") = 1.0, py::arg("start") = py::none(), py::arg("frame") = py::none(),
        "The loop of a length, start and frame that serves a purpose best: near a point (3,), of "
        "wanted extents\n(3,), within a box (2, 3) of low and high; xi and psi may be held. Raises "
        "HodographError: not_finite,\noutside_domain, no_interpolant (none within the box).");
  m.def("loop_facts", &facts_of_loop, py::arg("path"),
        "Speed, curvature, torsion, energy, box and tube of a loop, enclosed. Raises "
        "HodographError: unsupported.");
  m.def(
      "frame_towards",
      [](const Doubles& direction, const Doubles& normal) {
        return array_of(frame_towards(point_of<Point>(direction, "direction"),
                                      point_of<Point>(normal, "normal"))
                            .value());
      },
      py::arg("direction"), py::arg("normal"),
      "The unit quaternion (4,) that turns i to a direction and j towards a normal, (3,) each. "
      "Raises\nHodographError: not_finite, outside_domain.");
  m.def(
      "level_frame",
      [](const Doubles& direction, double roll) {
        return array_of(level_frame(point_of<Point>(direction, "direction"), roll).value());
      },
      py::arg("direction"), py::arg("roll") = 0.0,
      "The same with a level normal to the left, then turned about the direction, radians.");
}

}  // namespace hodograph::python
