// SPDX-License-Identifier: MIT
#include "python/src/rational/exact.hpp"

#include "hodograph/rational/rational_function.hpp"

namespace hodograph::python {

namespace {

/// The polynomial of a coefficient, a text or a list of coefficients; nothing for other objects.
std::optional<RationalPolynomial> polynomial_of(py::handle source) {
  if (py::isinstance<RationalPolynomial>(source)) return source.cast<const RationalPolynomial&>();
  if (py::isinstance<py::str>(source)) {
    return real_polynomial(parse_expression(source.cast<std::string>()).value(), "the polynomial")
        .value();
  }
  if (const auto number = rational_of(source)) return RationalPolynomial(*number);
  if (!py::isinstance<py::sequence>(source) && !py::isinstance<py::array>(source)) {
    return std::nullopt;
  }
  std::vector<Rational> coefficients;
  for (const py::handle item : source) {
    const auto number = rational_of(item);
    if (!number) return std::nullopt;
    coefficients.push_back(*number);
    if (coefficients.size() > largest_text_degree + 1) {
      throw Error(Fault{FaultCode::unsupported,
                        "polynomials have at most " + std::to_string(largest_text_degree + 1) +
                            " coefficients here",
                        std::nullopt, "coefficients", std::nullopt, std::nullopt});
    }
  }
  return RationalPolynomial(coefficients);
}

/// As many polynomials as wanted.
std::optional<std::vector<RationalPolynomial>> polynomials_of(py::handle source,
                                                              std::size_t count) {
  if (!py::isinstance<py::sequence>(source)) return std::nullopt;
  std::vector<RationalPolynomial> components;
  for (const py::handle item : source) {
    auto one = polynomial_of(item);
    if (!one) return std::nullopt;
    components.push_back(*std::move(one));
  }
  if (components.size() != count) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "there should be " + std::to_string(count) + " components; got " +
                          std::to_string(components.size()),
                      std::nullopt, "components", static_cast<double>(components.size()),
                      static_cast<double>(count)});
  }
  return components;
}

std::string text_in(py::handle source) { return source.cast<std::string>(); }

}  // namespace

std::optional<Rational> rational_of(py::handle source) {
  if (py::isinstance<py::str>(source)) return Rational::parse(text_in(source)).value();
  if (PyFloat_Check(source.ptr())) return Rational::exactly(source.cast<double>()).value();
  if (PyLong_Check(source.ptr())) return Rational::parse(text_in(py::str(source))).value();
  if (py::hasattr(source, "numerator") && py::hasattr(source, "denominator")) {
    return Rational::parse(text_in(py::str(source.attr("numerator"))) + "/" +
                           text_in(py::str(source.attr("denominator"))))
        .value();
  }
  if (py::isinstance(source, py::module_::import("numpy").attr("floating"))) {
    return Rational::exactly(source.cast<double>()).value();
  }
  return std::nullopt;
}

py::object fraction_of(const Rational& x) {
  return py::module_::import("fractions").attr("Fraction")(to_text(x));
}

bool read(py::handle source, PolynomialArgument& to) {
  auto value = polynomial_of(source);
  if (!value) return false;
  to.value = *std::move(value);
  return true;
}

bool read(py::handle source, QuaternionArgument& to) {
  if (py::isinstance<QuaternionPolynomial>(source)) {
    to.value = source.cast<const QuaternionPolynomial&>();
    return true;
  }
  if (py::isinstance<py::str>(source)) {
    to.value = quaternion_polynomial(parse_expression(text_in(source)).value(),
                                     "the quaternion polynomial")
                   .value();
    return true;
  }
  const auto parts = polynomials_of(source, 4);
  if (parts) to.value = {(*parts)[0], (*parts)[1], (*parts)[2], (*parts)[3]};
  return parts.has_value();
}

bool read(py::handle source, VectorArgument& to) {
  if (py::isinstance<VectorPolynomial>(source)) {
    to.value = source.cast<const VectorPolynomial&>();
    return true;
  }
  if (py::isinstance<py::str>(source)) {
    const auto value =
        vector_function(parse_expression(text_in(source)).value(), "the vector").value();
    if (!value.is_polynomial()) {
      throw Error(Fault{FaultCode::malformed_document,
                        "the vector should be of polynomials, without a denominator", std::nullopt,
                        "vector", std::nullopt, std::nullopt});
    }
    to.value = value.numerator();
    return true;
  }
  const auto parts = polynomials_of(source, 3);
  if (parts) to.value = {(*parts)[0], (*parts)[1], (*parts)[2]};
  return parts.has_value();
}

bool read(py::handle source, VectorFunctionArgument& to) {
  if (py::isinstance<VectorFunction>(source)) {
    to.value = source.cast<const VectorFunction&>();
    return true;
  }
  if (py::isinstance<py::str>(source)) {
    to.value = vector_function(parse_expression(text_in(source)).value(), "the curve").value();
    return true;
  }
  VectorArgument polynomials;
  if (!read(source, polynomials)) return false;
  to.value = VectorFunction(polynomials.value, 1);
  return true;
}

bool read(py::handle source, FunctionArgument& to) {
  if (py::isinstance<RationalFunction>(source)) {
    to.value = source.cast<const RationalFunction&>();
    return true;
  }
  if (py::isinstance<py::str>(source)) {
    to.value = real_function(parse_expression(text_in(source)).value(), "the function").value();
    return true;
  }
  PolynomialArgument polynomial;
  if (!read(source, polynomial)) return false;
  to.value = RationalFunction(polynomial.value);
  return true;
}

RationalVector vector_of(const std::vector<Rational>& numbers, const std::string& name) {
  if (numbers.size() != 3) {
    throw Error(Fault{FaultCode::mismatched_size,
                      name + " has 3 coordinates; got " + std::to_string(numbers.size()),
                      std::nullopt, name, static_cast<double>(numbers.size()), 3.0});
  }
  return {numbers[0], numbers[1], numbers[2]};
}

std::vector<Rational> list_of(const RationalVector& v) { return {v.x, v.y, v.z}; }

}  // namespace hodograph::python
