// SPDX-License-Identifier: MIT
// Existence of rational PH curves and their spaces: rational/reduction.hpp, existence.hpp,
// solution_space.hpp.
#include <string>
#include <vector>

#include "hodograph/rational/existence.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "hodograph/rational/work_limits.hpp"
#include "python/src/made.hpp"
#include "python/src/rational/exact.hpp"

namespace hodograph::python {

namespace {

/// Throws Error (unsupported) where the numbers are larger than the program takes.
void require_small(const QuaternionPolynomial& a, const RationalPolynomial& alpha) {
  if (const auto fault = input_size_fault(a, alpha)) throw Error(*fault);
}

void bind_existence(py::module_& m) {
  Record<Reduction> reduced(m, "Reduction",
                            "A = reduced (re + im i): what turns about the tangent, and what "
                            "only scales, divided out.");
  reduced.field("reduced", &Reduction::reduced)
      .field("re", &Reduction::re)
      .field("im", &Reduction::im)
      .def("was_reduced", &Reduction::was_reduced, "True when nothing was divided out.")
      .def("content", &Reduction::content, "re^2 + im^2, the content of A i A*.");
  m.def(
      "reduction", [](const QuaternionArgument& a) { return reduction(a.value).value(); },
      py::arg("a"), "The reduction of A with respect to i. Raises HodographError for A = 0.");
  Record<PoleStratum> stratum(m, "PoleStratum", "The poles of one order.");
  stratum.field("order", &PoleStratum::order)
      .field("poles", &PoleStratum::poles, "Its roots are the roots of alpha of that multiplicity.")
      .field("rank_two", &PoleStratum::rank_two)
      .field("rank_one", &PoleStratum::rank_one)
      .def("freedom", &PoleStratum::freedom);
  Record<Existence> answer(m, "Existence",
                           "Whether truly rational PH curves exist, why, and how many.");
  Record<Existence::Dimension>(answer, "Dimension", "The dimension of a space.")
      .field("value", &Existence::Dimension::value)
      .field("exact", &Existence::Dimension::exact, "Else it is a lower bound.");
  answer.field("exists", &Existence::exists)
      .field("freedom", &Existence::freedom, "N.")
      .field("strata", &Existence::strata, "By increasing order.")
      .field("reason", &Existence::reason)
      .field("alpha_degree", &Existence::alpha_degree)
      .field("indicatrix_degree", &Existence::indicatrix_degree)
      .field("tail_ranks", &Existence::tail_ranks)
      .def("dimension", &Existence::dimension, py::arg("d"), "Of the space of degree d.");
  m.def(
      "existence",
      [](const QuaternionArgument& a, const PolynomialArgument& alpha) {
        require_small(a.value, alpha.value);
        return unlocked([&] { return existence(a.value, alpha.value).value(); });
      },
      py::arg("a"), py::arg("alpha"),
      "Whether alpha admits truly rational PH curves with the indicatrix of A. Exact.\nRaises "
      "HodographError: outside_domain (A = 0, alpha = 0), unsupported (degrees).");
}

/// B = -alpha r / 2 of the combination of the canonical basis.
VectorPolynomial combination(const SolutionSpace& space, const std::vector<Rational>& multiples) {
  const auto basis = space.canonical_basis();
  if (multiples.size() != basis.size()) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "the canonical basis has " + std::to_string(basis.size()) +
                          " elements; got " + std::to_string(multiples.size()) + " multiples",
                      std::nullopt, "multiples", static_cast<double>(multiples.size()),
                      static_cast<double>(basis.size())});
  }
  VectorPolynomial sum{};
  for (std::size_t i = 0; i < basis.size(); ++i) {
    sum = sum + RationalPolynomial(multiples[i]) * basis[i];
  }
  return sum;
}

void require_affordable(const SolutionSpace& space) {
  if (space.canonical_basis_work() > largest_canonical_basis_work) {
    throw Error(Fault{FaultCode::unsupported,
                      "the canonical basis would take about " +
                          to_text(space.canonical_basis_work()) + " operations; at most " +
                          to_text(largest_canonical_basis_work) + " are offered (basis is there)",
                      std::nullopt, "canonical_basis_work", space.canonical_basis_work(),
                      largest_canonical_basis_work});
  }
}

}  // namespace

void bind_spaces(py::module_& m) {
  bind_existence(m);
  py::enum_<CurveKind>(m, "CurveKind", "What kind of curve -2 B / alpha is.")
      .value("constant", CurveKind::constant)
      .value("polynomial", CurveKind::polynomial)
      .value("rational", CurveKind::rational);
  m.def(
      "kind_of",
      [](const VectorArgument& b, const PolynomialArgument& alpha) {
        if (alpha.value.is_zero()) {
          throw Error(Fault{FaultCode::outside_domain, "alpha is 0", std::nullopt, "alpha", 0.0,
                            std::nullopt});
        }
        return kind_of(b.value, alpha.value);
      },
      py::arg("b"), py::arg("alpha"), "The kind of -2 B / alpha.");
  py::class_<SolutionSpace>(m, "SolutionSpace",
                            "All B of degree at most d for which r = -2 B / alpha has the tangent "
                            "indicatrix of A.")
      .def_property_readonly("preimage", &SolutionSpace::preimage, "A, reduced.")
      .def_property_readonly("preimage_reduction", &SolutionSpace::preimage_reduction)
      .def_property_readonly("alpha", &SolutionSpace::alpha)
      .def_property_readonly("radical", &SolutionSpace::radical)
      .def_property_readonly("indicatrix", &SolutionSpace::indicatrix, "F = A i A*.")
      .def_property_readonly("degree", &SolutionSpace::degree)
      .def_property_readonly("dimension", &SolutionSpace::dimension)
      .def_property_readonly("constant_dimension", &SolutionSpace::constant_dimension)
      .def_property_readonly("polynomial_dimension", &SolutionSpace::polynomial_dimension)
      .def_property_readonly("rational_dimension", &SolutionSpace::rational_dimension)
      .def_property_readonly(
          "basis", &SolutionSpace::basis,
          "First the truly rational elements, then polynomial ones, then points.")
      .def("lambda_numerators", &SolutionSpace::lambda_numerators,
           "h of lambda = h / (alpha rad alpha), a reduced basis.")
      .def("rational_length_numerators", &SolutionSpace::rational_length_numerators,
           "The same for the curves of rational arc length.")
      .def(
          "canonical_basis",
          [](const SolutionSpace& space) {
            require_affordable(space);
            return unlocked([&] { return space.canonical_basis(); });
          },
          "The reduced row echelon form. Raises HodographError: unsupported where it is too much "
          "work.")
      .def("canonical_basis_work", &SolutionSpace::canonical_basis_work)
      .def(
          "combination",
          [](const SolutionSpace& space, const std::vector<Rational>& multiples) {
            require_affordable(space);
            return combination(space, multiples);
          },
          py::arg("multiples"), "B, the sum of these multiples of the canonical basis.")
      .def("__repr__",
           [](const SolutionSpace& space) {
             return "<hodograph.SolutionSpace: dimension " + std::to_string(space.dimension()) +
                    ", degree " + std::to_string(space.degree()) + ", alpha " +
                    to_text(space.alpha()) + ">";
           })
      .def(py::pickle(
          [](const SolutionSpace& space) {
            const Reduction& r = space.preimage_reduction();
            const QuaternionPolynomial factor{r.re, r.im, 0, 0};
            return py::make_tuple(r.reduced * factor, space.alpha(), space.degree());
          },
          [](const py::tuple& t) {
            return solve(t[0].cast<QuaternionPolynomial>(), t[1].cast<RationalPolynomial>(),
                         t[2].cast<std::size_t>())
                .value();
          }));
  m.def(
      "solve",
      [](const QuaternionArgument& a, const PolynomialArgument& alpha, std::size_t degree) {
        require_small(a.value, alpha.value);
        return unlocked([&] { return solve(a.value, alpha.value, degree).value(); });
      },
      py::arg("a"), py::arg("alpha"), py::arg("degree"),
      "The space of a quaternion polynomial A, a denominator and a degree of B. Exact.\nRaises "
      "HodographError: outside_domain (A = 0, alpha = 0), unsupported (degrees; numbers with more "
      "digits than\nthe program takes).");
  m.attr("largest_input_degree") = largest_input_degree;
  m.attr("largest_solution_degree") = largest_solution_degree;
  add_equality_of_states(py::type::of<SolutionSpace>());
}

}  // namespace hodograph::python
