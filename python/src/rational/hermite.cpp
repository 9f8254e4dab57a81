// SPDX-License-Identifier: MIT
// Rational curves through Hermite data, without cusps: rational/hermite_preimage.hpp,
// hermite_curves.hpp, cone_test.hpp, cusp_free.hpp.
#include <optional>
#include <string>
#include <vector>

#include "hodograph/rational/cusp_free.hpp"
#include "hodograph/rational/hermite_preimage.hpp"
#include "python/src/made.hpp"
#include "python/src/rational/exact.hpp"

namespace hodograph::python {

namespace {

using Numbers = std::vector<Rational>;

Quaternion<Rational> quaternion_of(const Numbers& n) {
  if (n.size() != 4) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "a quaternion has 4 numbers; got " + std::to_string(n.size()), std::nullopt,
                      "inner", static_cast<double>(n.size()), 4.0});
  }
  return {n[0], n[1], n[2], n[3]};
}

void require_unit(const RationalVector& v, const char* name) {
  const Rational square = v.x * v.x + v.y * v.y + v.z * v.z;
  if (square == Rational(1)) return;
  throw Error(Fault{FaultCode::outside_domain,
                    std::string(name) +
                        " should have length 1, exactly (rational_direction makes "
                        "such); its square is " +
                        to_text(square),
                    std::nullopt, name, square.to_double(), 1.0});
}

void require_interval(const Rational& begin, const Rational& end) {
  if (begin < end) return;
  throw Error(Fault{
      FaultCode::not_increasing,
      "an interval runs from begin to a larger end; got " + to_text(begin) + " and " + to_text(end),
      std::nullopt, "end", end.to_double(), begin.to_double()});
}

/// The directions as unit vectors over the rationals: rounded where their length is irrational.
RationalVector unit(const RationalVector& v) { return rational_direction(v).value().unit; }

void bind_directions(py::module_& m) {
  Record<RationalDirection>(m, "RationalDirection", "A vector of length 1 over the rationals.")
      .field("unit", &RationalDirection::unit)
      .field("length", &RationalDirection::length, "Of the vector it came from, or near it.")
      .field("exact", &RationalDirection::exact, "Parallel to that vector.")
      .field("deviation", &RationalDirection::deviation, "The sine of the angle between them.");
  m.def(
      "rational_direction",
      [](const RationalVector& v, long bits) { return rational_direction(v, bits).value(); },
      py::arg("v"), py::arg("bits") = default_direction_bits,
      "The direction of v: v/|v| where that is rational, else one within the angle 2^-bits.\n"
      "Raises HodographError: zero_speed, outside_domain.");
  m.def(
      "preimage_between",
      [](const RationalVector& begin_direction, const RationalVector& end_direction,
         const Rational& factor_re, const Rational& factor_im, const std::vector<Numbers>& inner,
         const Rational& begin, const Rational& end) {
        require_unit(begin_direction, "begin_direction");
        require_unit(end_direction, "end_direction");
        PreimageFreedom freedom{factor_re, factor_im, {}};
        for (const Numbers& one : inner) freedom.inner.push_back(quaternion_of(one));
        return preimage_between(begin_direction, end_direction, freedom, begin, end).value();
      },
      py::arg("begin_direction"), py::arg("end_direction"), py::kw_only(),
      py::arg("factor_re") = Rational(1), py::arg("factor_im") = Rational(0),
      py::arg("inner") = std::vector<Numbers>{}, py::arg("begin") = Rational(0),
      py::arg("end") = Rational(1),
      "The A whose indicatrix has the directions (of length 1, exactly) at the ends; inner: Bezier "
      "coefficients\n(w, x, y, z) between. Raises HodographError: not_increasing, outside_domain.");
  Record<ConeTest> cone(m, "ConeTest",
                        "Whether any curve of an indicatrix runs along a chord without a cusp.");
  py::enum_<ConeTest::Outcome>(cone, "Outcome")
      .value("inside", ConeTest::Outcome::inside)
      .value("outside", ConeTest::Outcome::outside)
      .value("undecided", ConeTest::Outcome::undecided);
  cone.field("outcome", &ConeTest::outcome)
      .field("sentence", &ConeTest::sentence)
      .field("normal", &ConeTest::normal, "Proof of `outside`.")
      .field("nodes", &ConeTest::nodes, "Proof of `inside`.")
      .field("weights", &ConeTest::weights, "Proof of `inside`.")
      .field("rounds", &ConeTest::rounds);
  m.def(
      "cone_test",
      [](const VectorArgument& f, const RationalVector& chord, const Rational& begin,
         const Rational& end, std::size_t most_rounds) {
        require_interval(begin, end);
        const RationalPolynomial square =
            f.value.x * f.value.x + f.value.y * f.value.y + f.value.z * f.value.z;
        if (square.is_zero() || !is_positive(square, begin, end)) {
          throw Error(Fault{FaultCode::outside_domain,
                            "the indicatrix should not vanish on the interval", std::nullopt,
                            "indicatrix", std::nullopt, std::nullopt});
        }
        return unlocked([&] { return cone_test(f.value, chord, begin, end, most_rounds); });
      },
      py::arg("indicatrix"), py::arg("chord"), py::arg("begin") = Rational(0),
      py::arg("end") = Rational(1), py::arg("most_rounds") = default_rounds,
      "Whether a chord lies in the cone of the tangents F(t), exactly, with the proof.");
  Record<ChosenPreimage>(m, "ChosenPreimage", "A choice of A for Hermite data.")
      .field("preimage", &ChosenPreimage::preimage)
      .field("cone", &ChosenPreimage::cone);
  m.def(
      "chosen_preimage",
      [](const RationalVector& chord, const RationalVector& begin_direction,
         const RationalVector& end_direction, std::optional<Rational> begin_speed,
         std::optional<Rational> end_speed, const Rational& begin, const Rational& end) {
        const HermiteEnds ends{
            chord, unit(begin_direction), unit(end_direction), begin_speed, end_speed, begin, end};
        return unlocked([&] { return chosen_preimage(ends).value(); });
      },
      py::arg("chord"), py::arg("begin_direction"), py::arg("end_direction"), py::kw_only(),
      py::arg("begin_speed") = py::none(), py::arg("end_speed") = py::none(),
      py::arg("begin") = Rational(0), py::arg("end") = Rational(1),
      "An A of degree 2 for those who have none; directions are made rational by "
      "rational_direction.\nRaises HodographError: not_increasing, zero_speed, no_interpolant.");
}

Numbers fitting(const HermiteCurves& curves, const std::optional<Numbers>& x) {
  if (!curves.solvable()) {
    throw Error(Fault{FaultCode::no_interpolant,
                      "no curve of the space meets the data: their equations contradict each other",
                      std::nullopt, "data", std::nullopt, std::nullopt});
  }
  const Numbers given = x.value_or(Numbers(curves.freedom()));
  if (given.size() != curves.freedom()) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "the curves have " + std::to_string(curves.freedom()) + " parameters; got " +
                          std::to_string(given.size()),
                      std::nullopt, "x", static_cast<double>(given.size()),
                      static_cast<double>(curves.freedom())});
  }
  return given;
}

void bind_family(py::module_& m) {
  using H = HermiteCurves;
  const auto x = py::arg("x") = py::none();
  py::class_<H>(m, "HermiteCurves",
                "All curves of a space that run between two points, with derivatives there if "
                "wished: an affine space\nwith parameters x (`freedom` of them, 0 unless given).")
      .def(py::init([](const SolutionSpace& space, const RationalVector& begin_point,
                       const RationalVector& end_point,
                       std::optional<RationalVector> begin_derivative,
                       std::optional<RationalVector> end_derivative, const Rational& begin,
                       const Rational& end) {
             RationalHermiteData data{begin_point,    end_point, begin_derivative,
                                      end_derivative, begin,     end};
             return unlocked([&] { return H::create(space, std::move(data)).value(); });
           }),
           py::arg("space"), py::arg("begin_point"), py::arg("end_point"), py::kw_only(),
           py::arg("begin_derivative") = py::none(), py::arg("end_derivative") = py::none(),
           py::arg("begin") = Rational(0), py::arg("end") = Rational(1),
           "Raises HodographError: not_increasing, zero_speed, outside_domain.")
      .def_property_readonly("space", &H::space)
      .def_property_readonly("unknowns", &H::unknowns)
      .def_property_readonly("equations", &H::equations)
      .def_property_readonly("solvable", &H::solvable)
      .def_property_readonly("contradiction", &H::contradiction)
      .def_property_readonly("freedom", &H::freedom)
      .def_property_readonly("system", &H::system, "The equations' rows, right sides last.")
      .def(
          "lambda_",
          [](const H& c, const std::optional<Numbers>& p) { return c.lambda(fitting(c, p)); }, x)
      .def(
          "speed",
          [](const H& c, const std::optional<Numbers>& p) { return c.speed(fitting(c, p)); }, x)
      .def(
          "is_cusp_free",
          [](const H& c, const std::optional<Numbers>& p) { return c.is_cusp_free(fitting(c, p)); },
          x, "True when lambda > 0 on the whole of [begin, end], by Sturm's sequence.")
      .def(
          "curve",
          [](const H& c, const std::optional<Numbers>& p) { return c.curve(fitting(c, p)); }, x)
      .def(
          "nearest_to_speed",
          [](const H& c, const Rational& target, const Numbers& nodes) {
            fitting(c, std::nullopt);
            if (nodes.empty()) {
              throw Error(Fault{FaultCode::too_few, "there should be at least one node",
                                std::nullopt, "nodes", 0.0, 1.0});
            }
            return unlocked([&] { return c.nearest_to_speed(target, nodes); });
          },
          py::arg("target"), py::arg("nodes"),
          "The parameters whose speed at the nodes is nearest to a target, exactly.")
      .def(py::pickle(
          [](const H& c) {
            const auto& d = c.data();
            return py::make_tuple(c.space(), d.begin_point, d.end_point, d.begin_derivative,
                                  d.end_derivative, d.begin, d.end);
          },
          [](const py::tuple& t) {
            require_members(t, 7);
            RationalHermiteData data{t[1].cast<RationalVector>(),
                                     t[2].cast<RationalVector>(),
                                     t[3].cast<std::optional<RationalVector>>(),
                                     t[4].cast<std::optional<RationalVector>>(),
                                     t[5].cast<Rational>(),
                                     t[6].cast<Rational>()};
            return H::create(t[0].cast<SolutionSpace>(), std::move(data)).value();
          }))
      .def("__repr__", [](const H& c) {
        return "<hodograph.HermiteCurves: " + std::to_string(c.unknowns()) + " unknowns, " +
               std::to_string(c.equations()) + " equations, " +
               (c.solvable() ? std::to_string(c.freedom()) + " free" : "no solution") + ">";
      });
}

void bind_cusp_free(py::module_& m) {
  using A = CuspFreeAnswer;
  Record<A> answer(m, "CuspFreeAnswer",
                   "A certified curve without cusps, or a proof that there is none.");
  py::enum_<A::Outcome>(answer, "Outcome")
      .value("found", A::Outcome::found)
      .value("none", A::Outcome::none)
      .value("undecided", A::Outcome::undecided);
  py::enum_<A::Reason>(answer, "Reason")
      .value("not_applicable", A::Reason::not_applicable)
      .value("contradiction", A::Reason::contradiction)
      .value("cone", A::Reason::cone)
      .value("single_curve", A::Reason::single_curve)
      .value("weights", A::Reason::weights);
  answer.field("outcome", &A::outcome)
      .field("reason", &A::reason, "Why there is none.")
      .field("sentence", &A::sentence)
      .field("curve", &A::curve)
      .field("parameters", &A::parameters, "Its x.")
      .field("cusp", &A::cusp, "Of the only curve.")
      .field("cone", &A::cone)
      .field("nodes", &A::nodes, "Those with positive weight.")
      .field("weights", &A::weights)
      .field("speed_bound", &A::speed_bound, "No curve is faster than this everywhere.")
      .field("rounds", &A::rounds);
  const CuspFreeLimits usual{};
  m.def(
      "cusp_free_curve",
      [](const HermiteCurves& curves, std::size_t most_rounds, std::size_t nodes) {
        return unlocked([&] { return cusp_free_curve(curves, {most_rounds, nodes}).value(); });
      },
      py::arg("curves"), py::kw_only(), py::arg("most_rounds") = usual.most_rounds,
      py::arg("nodes") = usual.nodes,
      "A curve with lambda > 0 on [begin, end], certified, or a proof that there is none, or "
      "`undecided`.\nRaises HodographError: unsupported.");
  m.def(
      "holds",
      [](const A& one, const HermiteCurves& curves) {
        return unlocked([&] { return holds(one, curves); });
      },
      py::arg("answer"), py::arg("curves"),
      "True when the certificate or proof of an answer holds: recomputed.");
  Record<SearchedSpace>(m, "SearchedSpace", "What a search found in one space.")
      .field("power", &SearchedSpace::power)
      .field("degree", &SearchedSpace::degree)
      .field("answer", &SearchedSpace::answer);
  Record<DegreeSearch>(m, "DegreeSearch", "The smallest space with a curve without cusps.")
      .field("found", &DegreeSearch::found)
      .field("before", &DegreeSearch::before, "The spaces before it that could have held one.")
      .field("proved_smallest", &DegreeSearch::proved_smallest)
      .field("cone", &DegreeSearch::cone, "Where no space at all holds one.")
      .field("sentence", &DegreeSearch::sentence);
  m.def(
      "smallest_cusp_free",
      [](const QuaternionArgument& a, const RationalVector& begin_point,
         const RationalVector& end_point, const PolynomialArgument& base,
         std::size_t largest_degree, std::size_t least_power, std::size_t most_power,
         std::optional<RationalVector> begin_derivative,
         std::optional<RationalVector> end_derivative, const Rational& begin, const Rational& end,
         std::size_t most_rounds) {
        const RationalHermiteData data{begin_point,    end_point, begin_derivative,
                                       end_derivative, begin,     end};
        SpaceSearch search{base.value, least_power, most_power, largest_degree, {}};
        search.limits.most_rounds = most_rounds;
        return unlocked([&] { return smallest_cusp_free(a.value, data, search).value(); });
      },
      py::arg("a"), py::arg("begin_point"), py::arg("end_point"), py::arg("base"),
      py::arg("largest_degree"), py::kw_only(), py::arg("least_power") = 0,
      py::arg("most_power") = 1, py::arg("begin_derivative") = py::none(),
      py::arg("end_derivative") = py::none(), py::arg("begin") = Rational(0),
      py::arg("end") = Rational(1), py::arg("most_rounds") = usual.most_rounds,
      "The smallest space of alpha = base^k, least_power <= k <= most_power, and deg B up to "
      "largest_degree, that\nholds a certified curve without cusps.");
}

}  // namespace

void bind_hermite_preimages(py::module_& m) { bind_directions(m); }

void bind_hermite_curves(py::module_& m) {
  bind_family(m);
  add_equality_of_states(py::type::of<HermiteCurves>());
  bind_cusp_free(m);
}

}  // namespace hodograph::python
