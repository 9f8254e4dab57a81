// SPDX-License-Identifier: MIT
// Exact numbers and polynomials between Python and rational/: a Rational is a fractions.Fraction;
// where one is taken, a whole number, a Fraction, a float (exactly what it is) or a text ("-3/4")
// serve. Where a polynomial is taken, its text serves, too, or a list of coefficients.
#pragma once

#include <string>
#include <vector>

#include "hodograph/rational/polynomial.hpp"
#include "hodograph/rational/text.hpp"
#include "python/src/records.hpp"

namespace hodograph::python {

/// The number that an object of Python is. Throws Error where it is malformed or not finite;
/// nothing where the object is no number at all.
std::optional<Rational> rational_of(py::handle source);
py::object fraction_of(const Rational& x);

/// What a function takes as a polynomial, and the same for quaternions, vectors and functions.
struct PolynomialArgument {
  RationalPolynomial value;
};
struct QuaternionArgument {
  QuaternionPolynomial value;
};
struct VectorArgument {
  VectorPolynomial value;
};
struct VectorFunctionArgument {
  VectorFunction value;
};
struct FunctionArgument {
  RationalFunction value;
};
bool read(py::handle source, PolynomialArgument& to);
bool read(py::handle source, QuaternionArgument& to);
bool read(py::handle source, VectorArgument& to);
bool read(py::handle source, VectorFunctionArgument& to);
bool read(py::handle source, FunctionArgument& to);

/// A point over the rationals.
RationalVector vector_of(const std::vector<Rational>& numbers, const std::string& name);
std::vector<Rational> list_of(const RationalVector& v);

void bind_polynomials(py::module_& m);
void bind_functions(py::module_& m);
void bind_spaces(py::module_& m);
void bind_curves(py::module_& m);
void bind_hermite_preimages(py::module_& m);
void bind_hermite_curves(py::module_& m);

}  // namespace hodograph::python

namespace pybind11::detail {

template <>
struct type_caster<hodograph::Rational> {
  PYBIND11_TYPE_CASTER(hodograph::Rational, const_name("fractions.Fraction"));
  bool load(handle source, bool) {
    const auto read = hodograph::python::rational_of(source);
    if (!read) return false;
    value = *read;
    return true;
  }
  static handle cast(const hodograph::Rational& x, return_value_policy, handle) {
    return hodograph::python::fraction_of(x).release();
  }
};

/// A point as three fractions.
template <>
struct type_caster<hodograph::RationalVector> {
  PYBIND11_TYPE_CASTER(hodograph::RationalVector, const_name("List[fractions.Fraction]"));
  bool load(handle source, bool convert) {
    make_caster<std::vector<hodograph::Rational>> list;
    if (isinstance<str>(source) || !list.load(source, convert)) return false;
    value = hodograph::python::vector_of(
        cast_op<std::vector<hodograph::Rational>&&>(std::move(list)), "a point");
    return true;
  }
  static handle cast(const hodograph::RationalVector& v, return_value_policy policy,
                     handle parent) {
    return make_caster<std::vector<hodograph::Rational>>::cast(hodograph::python::list_of(v),
                                                               policy, parent);
  }
};

#define HODOGRAPH_ARGUMENT(Type, text)                                                \
  template <>                                                                         \
  struct type_caster<hodograph::python::Type> {                                       \
    PYBIND11_TYPE_CASTER(hodograph::python::Type, const_name(text));                  \
    bool load(handle source, bool) { return hodograph::python::read(source, value); } \
    static handle cast(const hodograph::python::Type& x, return_value_policy policy,  \
                       handle parent) {                                               \
      return make_caster<decltype(x.value)>::cast(x.value, policy, parent);           \
    }                                                                                 \
  }
HODOGRAPH_ARGUMENT(PolynomialArgument,
                   "Union[hodograph._rational.RationalPolynomial, str, fractions.Fraction, "
                   "List[fractions.Fraction]]");
HODOGRAPH_ARGUMENT(QuaternionArgument,
                   "Union[hodograph._rational.QuaternionPolynomial, str, List[sequence]]");
HODOGRAPH_ARGUMENT(VectorArgument,
                   "Union[hodograph._rational.VectorPolynomial, str, List[sequence]]");
HODOGRAPH_ARGUMENT(FunctionArgument,
                   "Union[hodograph._rational.RationalFunction, "
                   "hodograph._rational.RationalPolynomial, str, fractions.Fraction]");
HODOGRAPH_ARGUMENT(
    VectorFunctionArgument,
    "Union[hodograph._rational.VectorFunction, hodograph._rational.VectorPolynomial, "
    "str]");
#undef HODOGRAPH_ARGUMENT

}  // namespace pybind11::detail
