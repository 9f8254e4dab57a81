// SPDX-License-Identifier: MIT
// Rational functions, scalar and vectorial, and texts of definitions:
// rational/rational_function.hpp, text.hpp.
#include "hodograph/rational/rational_function.hpp"

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "python/src/rational/exact.hpp"

namespace hodograph::python {

/// What texts define, by name.
class Definitions : public py::dict {
  using py::dict::dict;
};

}  // namespace hodograph::python

template <>
struct pybind11::detail::handle_type_name<hodograph::python::Definitions> {
  static constexpr auto name = const_name(
      "Dict[str, Union[hodograph._rational.RationalPolynomial, "
      "hodograph._rational.RationalFunction, hodograph._rational.QuaternionPolynomial, "
      "hodograph._rational.VectorFunction]]");
};

namespace hodograph::python {

namespace {

using F = RationalFunction;
using R = VectorFunction;

[[noreturn]] void refuse_pole(const Rational& t) {
  throw Error(Fault{FaultCode::outside_domain, "the function has a pole at " + to_text(t),
                    std::nullopt, "t", t.to_double(), std::nullopt});
}

/// The exact value at a double, rounded.
Rational exact_time(double t, std::size_t index) {
  auto exact = Rational::exactly(t);
  if (exact) return *std::move(exact);
  Fault fault = exact.fault();
  fault.index = index;
  throw Error(fault);
}

template <class T, class A>
void add_arithmetic(py::class_<T>& c, const char* name) {
  c.def_property_readonly("numerator", &T::numerator)
      .def_property_readonly("denominator", &T::denominator, "Monic, in lowest terms.")
      .def_property_readonly("is_polynomial", &T::is_polynomial)
      .def("derivative", &T::derivative)
      .def(
          "__add__", [](const T& a, const A& b) { return a + b.value; }, py::arg("b"))
      .def(
          "__sub__", [](const T& a, const A& b) { return a - b.value; }, py::arg("b"))
      .def("__str__", [](const T& value) { return to_text(value); })
      .def("__repr__", [shown = std::string(name)](
                           const T& value) { return shown + "('" + to_text(value) + "')"; })
      .def(
          "__eq__",
          [](const T& a, const py::object& b) {
            A other;
            try {
              return read(b, other) && a == other.value;
            } catch (const Error&) {
              return false;
            }
          },
          py::arg("other"))
      .def("__hash__", [](const T& value) { return py::hash(py::str(to_text(value))); })
      .def(py::pickle([](const T& value) { return py::make_tuple(to_text(value)); },
                      [](const py::tuple& t) {
                        A argument;
                        if (!read(t[0], argument)) throw py::type_error("a text was expected");
                        return argument.value;
                      }));
}

void bind_function(py::module_& m) {
  py::class_<F> f(m, "RationalFunction",
                  "A quotient of polynomials in lowest terms with monic denominator, exactly.");
  f.def(py::init([](const FunctionArgument& numerator, const FunctionArgument& denominator) {
          if (denominator.value.is_zero()) {
            throw Error(Fault{FaultCode::outside_domain, "the denominator is 0", std::nullopt,
                              "denominator", 0.0, std::nullopt});
          }
          return numerator.value / denominator.value;
        }),
        py::arg("numerator"), py::arg("denominator") = 1,
        "From a text (\"(3t^2 + 1)/t\") or from polynomials.");
  add_arithmetic<F, FunctionArgument>(f, "RationalFunction");
  f.def(
       "__mul__", [](const F& a, const FunctionArgument& b) { return a * b.value; }, py::arg("b"))
      .def(
          "__truediv__",
          [](const F& a, const FunctionArgument& b) {
            if (b.value.is_zero()) {
              throw Error(Fault{FaultCode::outside_domain, "there is no division by 0",
                                std::nullopt, "b", 0.0, std::nullopt});
            }
            return a / b.value;
          },
          py::arg("b"))
      .def(
          "value",
          [](const F& a, const Rational& t) {
            if (a.denominator().value(t).is_zero()) refuse_pole(t);
            return a.value(t);
          },
          py::arg("t"), "The value at t, which is no pole, exactly.")
      .def(
          "__call__",
          [](const F& a, const Doubles& t) {
            return numbers_like(t, [&](auto from, auto to) {
              for (std::size_t i = 0; i < from.size(); ++i) {
                const Rational x = exact_time(from[i], i);
                if (a.denominator().value(x).is_zero()) refuse_pole(x);
                to[i] = a.value(x).to_double();
              }
            });
          },
          py::arg("t"), "The exact values at numbers or arrays, rounded once.");
  Record<RationalIntegral>(m, "RationalIntegral",
                           "An integral as a rational function and what is left: zero exactly "
                           "when it is rational.")
      .field("rational", &RationalIntegral::rational)
      .field("obstruction", &RationalIntegral::obstruction);
  m.def(
      "integral", [](const FunctionArgument& g) { return integral(g.value); }, py::arg("f"),
      "The integral of f, by Hermite's reduction.");
  Record<PartialFractions::Part>(m, "PartialFraction", "A proper fraction over one factor.")
      .field("pole", &PartialFractions::Part::pole)
      .field("value", &PartialFractions::Part::value);
  Record<PartialFractions>(m, "PartialFractions", "A function split over coprime denominators.")
      .field("polynomial", &PartialFractions::polynomial)
      .field("parts", &PartialFractions::parts);
  m.def(
      "partial_fractions", [](const FunctionArgument& g) { return partial_fractions(g.value); },
      py::arg("f"),
      "f split over coprime denominators: a polynomial and a proper fraction for each factor.");
}

void bind_vector_function(py::module_& m) {
  py::class_<R> r(m, "VectorFunction",
                  "A rational curve in space, in lowest terms with monic denominator, exactly.");
  r.def(
      py::init([](const VectorFunctionArgument& numerator, const PolynomialArgument& denominator) {
        if (denominator.value.is_zero()) {
          throw Error(Fault{FaultCode::outside_domain, "the denominator is 0", std::nullopt,
                            "denominator", 0.0, std::nullopt});
        }
        return F(1, denominator.value) * numerator.value;
      }),
      py::arg("numerator"), py::arg("denominator") = 1,
      "From a text (\"(t, 3t^2, 1)/t^3\") or from polynomials.");
  add_arithmetic<R, VectorFunctionArgument>(r, "VectorFunction");
  r.def_property_readonly("is_constant", &R::is_constant)
      .def(
          "value",
          [](const R& a, const Rational& t) {
            if (a.denominator().value(t).is_zero()) refuse_pole(t);
            return a.value(t);
          },
          py::arg("t"), "The point at t, which is no pole, as three fractions.")
      .def(
          "__call__",
          [](const R& a, const Doubles& t) {
            return filled_like(t, {3}, [&](auto from, auto to) {
              for (std::size_t i = 0; i < from.size(); ++i) {
                const Rational x = exact_time(from[i], i);
                if (a.denominator().value(x).is_zero()) refuse_pole(x);
                const RationalVector p = a.value(x);
                for (std::size_t j = 0; j < 3; ++j) to[3 * i + j] = p[j].to_double();
              }
            });
          },
          py::arg("t"), "The exact points (..., 3) at numbers or arrays, rounded once.");
}

/// A definition's value as the simplest type that it is.
py::object simplest(const QuaternionFunction& value) {
  if (const auto p = real_polynomial(value, "value")) return py::cast(*p);
  if (const auto f = real_function(value, "value")) return py::cast(*f);
  if (const auto q = quaternion_polynomial(value, "value")) return py::cast(*q);
  if (const auto v = vector_function(value, "value")) return py::cast(*v);
  throw Error(Fault{FaultCode::unsupported,
                    "a quaternion with a denominator and a real part is no curve", std::nullopt,
                    "text", std::nullopt, std::nullopt});
}

}  // namespace

void bind_functions(py::module_& m) {
  bind_function(m);
  bind_vector_function(m);
  m.def(
      "parse_definitions",
      [](const std::string& text) {
        Definitions result;
        for (const TextDefinition& one : parse_definitions(text).value()) {
          result[py::str(one.name)] = simplest(one.value);
        }
        return result;
      },
      py::arg("text"),
      "The definitions of a text (\"A = t^2 - (i + j)*t + k; alpha = 3t(t - 1)\") by name: each a\n"
      "RationalPolynomial, RationalFunction, QuaternionPolynomial or VectorFunction, the first "
      "that it is.\nRaises HodographError: malformed_document (index: of the byte), unsupported.");
}

}  // namespace hodograph::python
