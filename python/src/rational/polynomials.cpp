// SPDX-License-Identifier: MIT
// Polynomials over the rationals, quaternion and vector polynomials, their real roots, and texts:
// rational/polynomial.hpp, real_roots.hpp, text.hpp.
#include <string>
#include <vector>

#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/real_roots.hpp"
#include "hodograph/rational/work_limits.hpp"
#include "python/src/made.hpp"
#include "python/src/rational/exact.hpp"

namespace hodograph::python {

namespace {

using P = RationalPolynomial;
using Q = QuaternionPolynomial;
using V = VectorPolynomial;
using Argument = PolynomialArgument;

[[noreturn]] void refuse(FaultCode code, const std::string& sentence, const char* quantity) {
  throw Error(Fault{code, sentence, std::nullopt, quantity, std::nullopt, std::nullopt});
}

const P& divisor(const Argument& argument) {
  if (argument.value.is_zero()) {
    refuse(FaultCode::outside_domain, "there is no division by the polynomial 0", "divisor");
  }
  return argument.value;
}

const P& not_zero(const Argument& argument) {
  if (argument.value.is_zero()) {
    refuse(FaultCode::outside_domain, "every number is a root of the polynomial 0", "p");
  }
  return argument.value;
}

void require_degree(double degree) {
  if (degree > static_cast<double>(largest_text_degree)) {
    refuse(FaultCode::unsupported,
           "degrees up to " + std::to_string(largest_text_degree) + " are offered; got " +
               to_text(degree),
           "degree");
  }
}

/// p at many doubles, by Horner's rule on the rounded coefficients.
FloatOrArray at_doubles(const P& p, const Doubles& t) {
  std::vector<double> coefficients;
  for (const Rational& c : p.coefficients()) coefficients.push_back(c.to_double());
  return numbers_like(t, [&](auto from, auto to) {
    for (std::size_t i = 0; i < from.size(); ++i) {
      double sum = 0.0;
      for (std::size_t k = coefficients.size(); k-- > 0;) sum = sum * from[i] + coefficients[k];
      to[i] = sum;
    }
  });
}

/// Equality with what can be read as the same type; not equal to anything else.
template <class T, class A>
auto equality() {
  return [](const T& a, const py::object& b) {
    if (py::isinstance<T>(b)) return a == b.cast<const T&>();
    A other;
    try {
      return read(b, other) && a == other.value;
    } catch (const Error&) {
      return false;
    }
  };
}

template <class T, class A>
void add_text_methods(py::class_<T>& c, const char* name) {
  c.def("__str__", [](const T& value) { return to_text(value); })
      .def("__repr__", [shown = std::string(name)](
                           const T& value) { return shown + "('" + to_text(value) + "')"; })
      .def("__eq__", equality<T, A>(), py::arg("other"))
      .def("__hash__", [](const T& value) { return py::hash(py::str(to_text(value))); })
      .def("__copy__", [](const py::object& self) { return self; })
      .def(
          "__deepcopy__", [](const py::object& self, const py::dict&) { return self; },
          py::arg("memo"))
      .def(py::pickle([](const T& value) { return py::make_tuple(to_text(value)); },
                      [](const py::tuple& t) {
                        A argument;
                        if (!read(t[0], argument)) throw py::type_error("a text was expected");
                        return argument.value;
                      }));
}

void bind_scalar(py::module_& m) {
  py::class_<P> c(m, "RationalPolynomial",
                  "A polynomial in t with rational coefficients, exactly. Numbers are "
                  "fractions.Fraction; where one\nis taken, a whole number, a float (exactly what "
                  "it is) or a text serve, too.");
  c.def(py::init([](const Argument& argument) { return argument.value; }), py::arg("p") = 0,
        "From a text (\"3t(t - 1)\"), the coefficients (the constant one first), or a number.\n"
        "Raises HodographError: malformed_document, with the place in the text.")
      .def_property_readonly("degree", &P::degree, "-1 for the zero polynomial.")
      .def_property_readonly("coefficients", &P::coefficients, "The constant one first.")
      .def("coefficient", &P::coefficient, py::arg("k"), "0 above the degree.")
      .def_property_readonly("leading", &P::leading)
      .def_property_readonly("is_zero", &P::is_zero)
      .def_property_readonly("bits", &P::bits, "Of the largest numerator or denominator.")
      .def("value", &P::value, py::arg("t"), "p(t), exactly.")
      .def("__call__", &at_doubles, py::arg("t"), "p(t) in floating point, at numbers or arrays.")
      .def("derivative", &P::derivative)
      .def("integral", &P::integral, "The antiderivative without constant term.")
      .def("taylor_coefficient", &P::taylor_coefficient, py::arg("k"), "p^(k) / k!.")
      .def("monic", &P::monic)
      .def("shifted", &P::shifted, py::arg("c"), "p(t + c).")
      .def("__neg__", [](const P& a) { return -a; })
      .def(
          "__add__", [](const P& a, const Argument& b) { return a + b.value; }, py::arg("b"))
      .def(
          "__radd__", [](const P& a, const Argument& b) { return b.value + a; }, py::arg("b"))
      .def(
          "__sub__", [](const P& a, const Argument& b) { return a - b.value; }, py::arg("b"))
      .def(
          "__rsub__", [](const P& a, const Argument& b) { return b.value - a; }, py::arg("b"))
      .def(
          "__mul__", [](const P& a, const Argument& b) { return a * b.value; }, py::arg("b"))
      .def(
          "__rmul__", [](const P& a, const Argument& b) { return b.value * a; }, py::arg("b"))
      .def(
          "__floordiv__", [](const P& a, const Argument& b) { return a / divisor(b); },
          py::arg("b"), "The quotient of the division with remainder.")
      .def(
          "__mod__", [](const P& a, const Argument& b) { return a % divisor(b); }, py::arg("b"),
          "Its remainder.")
      .def(
          "__pow__",
          [](const P& a, std::size_t k) {
            require_degree(static_cast<double>(k) * std::max(1, a.degree()));
            return a.power(k);
          },
          py::arg("k"));
  add_text_methods<P, Argument>(c, "RationalPolynomial");
}

template <class T>
struct ComponentsOf;
template <>
struct ComponentsOf<Q> {
  static constexpr const char* names[] = {"w", "x", "y", "z"};
};
template <>
struct ComponentsOf<V> {
  static constexpr const char* names[] = {"x", "y", "z"};
};

template <class T, class A>
void bind_components(py::module_& m, py::class_<T>& c, const char* name, const char* doc) {
  constexpr std::size_t count = std::size(ComponentsOf<T>::names);
  c.def(py::init([](const A& argument) { return argument.value; }), py::arg("value"), doc);
  for (std::size_t i = 0; i < count; ++i) {
    c.def_property_readonly(ComponentsOf<T>::names[i], [i](const T& a) -> P {
      if constexpr (std::is_same_v<T, Q>) {
        const P* parts[] = {&a.w, &a.x, &a.y, &a.z};
        return *parts[i];
      } else {
        return a[i];
      }
    });
  }
  c.def_property_readonly(
       "degree", [](const T& a) { return degree(a); }, "-1 for zero.")
      .def("derivative", [](const T& a) { return derivative(a); })
      .def(
          "content", [](const T& a) { return content(a); },
          "The monic greatest common divisor of the components.")
      .def("__neg__", [](const T& a) { return -a; })
      .def(
          "__add__", [](const T& a, const A& b) { return a + b.value; }, py::arg("b"))
      .def(
          "__sub__", [](const T& a, const A& b) { return a - b.value; }, py::arg("b"));
  add_text_methods<T, A>(c, name);
  (void)m;
}

void bind_quaternion(py::module_& m) {
  py::class_<Q> q(m, "QuaternionPolynomial",
                  "A quaternion polynomial w + x i + y j + z k over the rationals, exactly.");
  bind_components<Q, QuaternionArgument>(
      m, q, "QuaternionPolynomial",
      "From a text (\"t^2 - (i + j)*t + k\") or four polynomials w, x, y, z.");
  q.def(
       "__mul__", [](const Q& a, const QuaternionArgument& b) { return a * b.value; }, py::arg("b"))
      .def("conjugate", [](const Q& a) { return conjugate(a); })
      .def(
          "norm_polynomial", [](const Q& a) { return norm_polynomial(a); }, "|A|^2 = A A*.")
      .def(
          "indicatrix", [](const Q& a) { return indicatrix(a); },
          "F = A i A*, the tangent indicatrix up to its length |A|^2.");
}

/// The values of three polynomials at many doubles.
Doubles at_doubles(const V& v, const Doubles& t) {
  std::vector<double> rows[3];
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Rational& c : v[i].coefficients()) rows[i].push_back(c.to_double());
  }
  return filled_like(t, {3}, [&](auto from, auto to) {
    for (std::size_t j = 0; j < from.size(); ++j) {
      for (std::size_t i = 0; i < 3; ++i) {
        double sum = 0.0;
        for (std::size_t k = rows[i].size(); k-- > 0;) sum = sum * from[j] + rows[i][k];
        to[3 * j + i] = sum;
      }
    }
  });
}

void bind_vector(py::module_& m) {
  py::class_<V> v(m, "VectorPolynomial", "A vector of polynomials over the rationals, exactly.");
  bind_components<V, VectorArgument>(m, v, "VectorPolynomial",
                                     "From a text (\"(t, 3t^2, 1)\") or three polynomials.");
  v.def(
       "value", [](const V& a, const Rational& t) { return value(a, t); }, py::arg("t"),
       "The three values at t, exactly.")
      .def(
          "__call__", [](const V& a, const Doubles& t) { return at_doubles(a, t); }, py::arg("t"),
          "The values (..., 3) in floating point.")
      .def(
          "taylor_coefficient", [](const V& a, std::size_t k) { return taylor_coefficient(a, k); },
          py::arg("k"));
}

void bind_roots(py::module_& m) {
  Record<PolynomialFactor>(m, "PolynomialFactor", "One factor of a polynomial.")
      .field("factor", &PolynomialFactor::factor, "Monic.")
      .field("multiplicity", &PolynomialFactor::multiplicity);
  m.def(
      "square_free_factors", [](const Argument& p) { return square_free_factors(p.value); },
      py::arg("p"), "Square-free, pairwise coprime factors by multiplicity; none for constants.");
  m.def(
      "irreducible_factors",
      [](const Argument& p) { return unlocked([&] { return irreducible_factors(p.value); }); },
      py::arg("p"), "Factors irreducible over the rationals.");
  m.def(
      "gcd", [](const Argument& a, const Argument& b) { return gcd(a.value, b.value); },
      py::arg("a"), py::arg("b"), "The monic greatest common divisor; 0 where both are 0.");
  m.def(
      "divides", [](const Argument& b, const Argument& a) { return divides(b.value, a.value); },
      py::arg("b"), py::arg("a"), "True when b divides a; only 0 is divided by 0.");
  m.def(
      "radical", [](const Argument& p) { return radical(not_zero(p)); }, py::arg("p"),
      "The monic product of the distinct irreducible factors of p, which is not 0.");
  m.def(
      "determinant",
      [](const VectorArgument& a, const VectorArgument& b, const VectorArgument& c) {
        return determinant(a.value, b.value, c.value);
      },
      py::arg("a"), py::arg("b"), py::arg("c"),
      "det(a, b, c) = a . (b x c) of vector polynomials.");
  py::class_<RealRoot>(m, "RealRoot",
                       "One real root of a polynomial: the only root of an irreducible factor in "
                       "(lower, upper), or\nlower = upper where it is rational.")
      .def_property_readonly("factor", &RealRoot::factor)
      .def_property_readonly("multiplicity", &RealRoot::multiplicity)
      .def_property_readonly("lower", &RealRoot::lower)
      .def_property_readonly("upper", &RealRoot::upper)
      .def_property_readonly("is_rational", &RealRoot::is_rational)
      .def("compare", &RealRoot::compare, py::arg("x"), "The sign of the root minus x, exactly.")
      .def("halved", &RealRoot::halved, "The same root in an interval half as wide.")
      .def("__float__", &RealRoot::to_double, "The double nearest to the root.")
      .def("__repr__",
           [](const RealRoot& root) {
             return "<hodograph.RealRoot: " + to_text(root.to_double()) + " of " +
                    to_text(root.factor()) + ">";
           })
      .def(py::pickle(
          [](const RealRoot& root) {
            return py::make_tuple(root.factor(), root.multiplicity(), root.lower(), root.upper());
          },
          [](const py::tuple& t) {
            return RealRoot(t[0].cast<P>(), t[1].cast<std::size_t>(), t[2].cast<Rational>(),
                            t[3].cast<Rational>());
          }));
  m.def(
      "real_roots",
      [](const Argument& p) {
        const P& checked = not_zero(p);
        if (const auto fault = root_work_fault(checked)) throw Error(*fault);
        return unlocked([&] { return real_roots(checked); });
      },
      py::arg("p"),
      "The distinct real roots of p, increasing, isolated exactly. Raises HodographError: "
      "outside_domain (p = 0),\nunsupported (more than about a second's work).");
  const auto between = [](auto decide) {
    return [decide](const Argument& p, const Rational& a, const Rational& b) {
      if (a > b) {
        refuse(FaultCode::not_increasing,
               "an interval runs from a to b >= a; got " + to_text(a) + " and " + to_text(b), "a");
      }
      const P& checked = not_zero(p);
      if (const auto fault = root_work_fault(checked)) throw Error(*fault);
      return unlocked([&] { return decide(checked, a, b); });
    };
  };
  m.def("count_real_roots", between([](const P& p, const Rational& a, const Rational& b) {
          return count_real_roots(p, a, b);
        }),
        py::arg("p"), py::arg("a"), py::arg("b"), "How many distinct real roots lie in [a, b].");
  m.def("is_positive", between([](const P& p, const Rational& a, const Rational& b) {
          return is_positive(p, a, b);
        }),
        py::arg("p"), py::arg("a"), py::arg("b"), "True when p > 0 everywhere in [a, b]. Exact.");
  m.def("is_nonnegative", between([](const P& p, const Rational& a, const Rational& b) {
          return is_nonnegative(p, a, b);
        }),
        py::arg("p"), py::arg("a"), py::arg("b"), "True when p >= 0 everywhere in [a, b]. Exact.");
}

}  // namespace

void bind_polynomials(py::module_& m) {
  bind_scalar(m);
  bind_vector(m);  // before what returns it, so that signatures name it
  bind_quaternion(m);
  bind_roots(m);
  add_equality_of_states(py::type::of<RealRoot>());
}

}  // namespace hodograph::python
