// SPDX-License-Identifier: MIT
// What is known of rational PH curves, for people.
#include <algorithm>
#include <string>
#include <utility>

#include "cli/rationals.hpp"

namespace hodograph::cli {
namespace {

constexpr std::size_t label_width = 18;     // characters
constexpr std::size_t longest_value = 400;  // characters; longer ones are for programs

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string shown(const std::string& text) {
  if (text.size() <= longest_value) return text;
  return text.substr(0, longest_value) + "... (" + std::to_string(text.size()) +
         " characters; --json has them)";
}

void append(std::string& out, const Rows& rows, const std::string& indent) {
  for (const auto& [label, value] : rows) {
    std::string line = indent + label;
    line.resize(std::max(line.size() + 1, indent.size() + label_width), ' ');
    out += line + shown(value) + "\n";
  }
}

bool is_one_term(const std::string& text) {
  return text.find(' ') == std::string::npos && text.find('/') == std::string::npos;
}
/// The polynomial as a product over its irreducible factors.
std::string factored(const RationalPolynomial& p) {
  if (p.is_constant()) return to_text(p);
  std::string product = p.leading() == Rational(1) ? "" : to_text(p.leading());
  for (const PolynomialFactor& f : irreducible_factors(p)) {
    const std::string base = to_text(f.factor);
    product += (product.empty() ? "" : "*") + (is_one_term(base) ? base : "(" + base + ")");
    if (f.multiplicity > 1) product += "^" + std::to_string(f.multiplicity);
  }
  return product;
}
/// "numerator/denominator", as it can be typed.
std::string over(const std::string& numerator, const RationalPolynomial& denominator) {
  if (denominator.is_one()) return numerator;
  const std::string below = factored(denominator);
  const bool product = below.find('*') != std::string::npos;
  const bool list = numerator[0] == '(';
  return (list || is_one_term(numerator) ? numerator : "(" + numerator + ")") + "/" +
         (product ? "(" + below + ")" : below);
}
std::string shown(const RationalFunction& f) {
  return over(to_text(f.numerator()), f.denominator());
}
std::string shown(const VectorFunction& r) { return over(to_text(r.numerator()), r.denominator()); }

std::string place_of(const RealRoot& root) {
  if (root.is_rational()) return "t = " + to_text(root.lower());
  return "t = " + to_six_digits(root.to_double()) + ", a root of " + shown(to_text(root.factor()));
}
/// "none", or the places, with what `kind` says of each.
template <class Kind>
std::string places_of(const std::vector<RealRoot>& roots, const Kind& kind) {
  if (roots.empty()) return "none";
  std::string text;
  for (const RealRoot& root : roots) {
    text += (text.empty() ? "" : "; ") + place_of(root) + kind(root);
  }
  return text;
}
std::string order_of(const RealRoot& root) {
  return " (order " + std::to_string(root.multiplicity()) + ")";
}

std::string kind_in_words(CurveKind kind) {
  return kind == CurveKind::rational     ? "truly rational"
         : kind == CurveKind::polynomial ? "polynomial"
                                         : "a point";
}

std::string motion_of(const DualQuaternionPolynomial& c) {
  return to_text(c.primal) + " + eps*(" + to_text(c.dual) + ")";
}

/// "0-2" or "5".
std::string degrees(std::size_t first, std::size_t last) {
  return first == last ? std::to_string(first) : std::to_string(first) + "-" + std::to_string(last);
}

std::string table_of(const std::vector<DegreeRow>& rows) {
  std::string text = "  deg B     dimension  predicted   points  polynomial  truly rational\n";
  for (std::size_t i = 0; i < rows.size();) {
    // Degrees with the same answer stand in one line.
    std::size_t last = i;
    const auto same = [&](const DegreeRow& a, const DegreeRow& b) {
      return a.dimension == b.dimension && a.points == b.points && a.polynomials == b.polynomials &&
             a.predicted.value == b.predicted.value && a.predicted.exact == b.predicted.exact;
    };
    while (last + 1 < rows.size() && same(rows[i], rows[last + 1])) ++last;
    const DegreeRow& row = rows[i];
    char line[120];
    std::snprintf(
        line, sizeof line, "  %-9s %-10zu %-11s %-7zu %-11zu %zu\n",
        degrees(row.degree, rows[last].degree).c_str(), row.dimension,
        ((row.predicted.exact ? "" : ">= ") + std::to_string(row.predicted.value)).c_str(),
        row.points, row.polynomials, row.rationals());
    text += line;
    i = last + 1;
  }
  return text;
}

}  // namespace

std::string text_of(const DescribedCurve& described) {
  const RationalPhCurve& curve = described.curve;
  std::string text = "\n" + described.name + ", " + kind_in_words(curve.kind()) + "\n";
  text[1] = static_cast<char>(text[1] == 'c' ? 'C' : text[1] == 't' ? 'T' : text[1]);
  Rows rows = {{"r(t)", shown(curve.position())}};
  if (curve.kind() == CurveKind::constant) {
    append(text, rows, "  ");
    return text;
  }
  rows.emplace_back("lambda", shown(curve.lambda()));
  rows.emplace_back("speed", shown(curve.speed()));
  rows.emplace_back("arc length",
                    described.length.obstruction.is_zero()
                        ? "rational: " + shown(described.length.rational)
                        : "not rational: the part with simple poles is the integral of " +
                              shown(described.length.obstruction));
  rows.emplace_back("poles", places_of(described.poles, order_of));
  if (described.stationary) {
    rows.emplace_back("cusps", places_of(*described.stationary, [](const RealRoot& root) {
                        return root.multiplicity() % 2 != 0 ? std::string()
                                                            : " (it stops and goes on: no cusp)";
                      }));
  } else {
    rows.emplace_back("cusps", "the numerator of lambda is too large to isolate its zeros here");
  }
  rows.emplace_back("planes u.x = f",
                    described.planes ? "f = " + shown(*described.planes) : "the curve is planar");
  rows.emplace_back("motion", motion_of(described.motion));
  const auto& parts = described.decomposition;
  if (parts.pieces.size() > 1 || !parts.polynomial_lambda.is_zero()) {
    for (const auto& piece : parts.pieces) {
      rows.emplace_back("part at " + to_text(piece.pole), shown(piece.curve));
    }
    if (!parts.polynomial_lambda.is_zero()) {
      rows.emplace_back("polynomial part",
                        "the integral of (" + to_text(parts.polynomial_lambda) + ")*F");
    }
    rows.emplace_back("constant", to_text(parts.constant));
  }
  if (!described.coordinates.empty()) {
    std::string sum;
    for (std::size_t n = 0; n < described.coordinates.size(); ++n) {
      const Rational& c = described.coordinates[n];
      if (c.is_zero()) continue;
      sum += c.sign() < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
      const Rational size = c.sign() < 0 ? -c : c;
      sum += (size == Rational(1) ? "" : to_text(size) + "*") + "B" + std::to_string(n + 1);
    }
    rows.emplace_back("in the basis", "B = " + (sum.empty() ? "0" : sum));
  }
  append(text, rows, "  ");
  return text;
}

std::string text_of(const RationalAnswer& answer) {
  const SolutionSpace& space = answer.space;
  const Reduction& reduction = space.preimage_reduction();
  std::string text;
  Rows rows = {{"A", to_text(*answer.problem.a)}, {"alpha", factored(space.alpha())}};
  if (reduction.was_reduced()) {
    rows.emplace_back("", "A is reduced with respect to i");
  } else {
    rows.emplace_back("reduced A", to_text(reduction.reduced));
    rows.emplace_back("divided out",
                      to_text(QuaternionPolynomial{reduction.re, reduction.im, {}, {}}));
  }
  rows.emplace_back("F = A i A*", to_text(space.indicatrix()));
  rows.emplace_back("|A|^2", to_text(norm_polynomial(space.preimage())));
  rows.emplace_back("inflections", places_of(answer.inflections, order_of));
  const auto frame = RationalPhCurve::create(space.preimage(), VectorFunction()).value();
  rows.emplace_back("torsion zeros", frame.is_planar() ? "everywhere: all curves are planar"
                                                       : places_of(answer.torsion_zeros, order_of));
  rows.emplace_back("frame",
                    frame.frame_is_rotation_minimising()
                        ? "rotation-minimising"
                        : "angular velocity " + to_text(frame.angular_velocity()) + "/|A|^2");
  append(text, rows, "");
  std::string reason = answer.existence.reason;
  if (!reason.empty() && reason[0] >= 'a' && reason[0] <= 'z') {
    reason[0] = static_cast<char>(reason[0] - 'a' + 'A');
  }
  text += "\n" + shown(reason) + ".\n";
  for (const TaylorRow& row : answer.taylor) {
    std::string f;
    for (std::size_t k = 0; k < row.coefficients.size(); ++k) {
      f += (k == 0 ? "" : ", ") + std::string("f_") + std::to_string(k) + " = " +
           to_text(row.coefficients[k]);
    }
    const std::string place = row.factor.degree() == 1
                                  ? "t = " + to_text(-row.factor.coefficient(0))
                                  : "a root t of " + to_text(row.factor);
    text += "  F at " + place + ": " + shown(f) + "\n";
  }
  text += "\n" + table_of(answer.rows);

  text += "\nDegree " + std::to_string(space.degree()) + ": r = -2 B/alpha, lambda = h/(" +
          shown(factored(space.alpha().monic() * space.radical())) + ")\n";
  if (answer.basis) {
    for (std::size_t i = 0; i < answer.basis->size(); ++i) {
      const VectorPolynomial& b = (*answer.basis)[i];
      append(text,
             {{"B" + std::to_string(i + 1),
               shown(to_text(b)) + "   " + kind_in_words(kind_of(b, space.alpha()))}},
             "  ");
    }
  } else {
    text += "  " + answer.basis_refused +
            ".\n  A compact basis: " + std::to_string(space.rational_dimension()) +
            " truly rational, alpha int t^k F with k < " +
            std::to_string(space.polynomial_dimension()) + ", and the points\n";
  }
  for (const DescribedCurve& curve : answer.curves) text += text_of(curve);
  if (answer.curves_left_out > 0) {
    text += "\n" + std::to_string(answer.curves_left_out) +
            " more curves are not described; --curves N describes N\n";
  }
  if (answer.chosen) text += text_of(*answer.chosen);
  return text;
}

}  // namespace hodograph::cli
