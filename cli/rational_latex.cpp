// SPDX-License-Identifier: MIT
// What is known of rational PH curves, as LaTeX (amsmath).
#include <array>
#include <string>

#include "cli/rationals.hpp"

namespace hodograph::cli {
namespace {

std::string latex(const Rational& x) {
  const std::string text = to_text(x.sign() < 0 ? -x : x);
  const std::size_t slash = text.find('/');
  const std::string size = slash == std::string::npos ? text
                                                      : "\\frac{" + text.substr(0, slash) + "}{" +
                                                            text.substr(slash + 1) + "}";
  return (x.sign() < 0 ? "-" : "") + size;
}

std::string monomial(std::size_t k) {
  return k == 0 ? "" : k == 1 ? "t" : "t^{" + std::to_string(k) + "}";
}

/// Adds c · name with its sign.
void add(std::string& sum, const Rational& c, const std::string& name) {
  if (c.is_zero()) return;
  const Rational size = c.sign() < 0 ? -c : c;
  sum += c.sign() < 0 ? (sum.empty() ? "-" : " - ") : (sum.empty() ? "" : " + ");
  if (name.empty() || size != Rational(1)) sum += latex(size);
  if (!name.empty()) sum += (size != Rational(1) ? " " : "") + name;
}

std::string latex(const RationalPolynomial& p) {
  std::string sum;
  for (int k = p.degree(); k >= 0; --k) {
    const auto at = static_cast<std::size_t>(k);
    add(sum, p.coefficient(at), monomial(at));
  }
  return sum.empty() ? "0" : sum;
}

std::string latex(const QuaternionPolynomial& a) {
  constexpr std::array units = {"", "\\mathbf{i}", "\\mathbf{j}", "\\mathbf{k}"};
  std::string sum;
  for (std::size_t c = 0; c < 4; ++c) {
    if (a[c].is_zero()) continue;
    const std::string part = latex(a[c]);
    const bool alone = part.find(' ') == std::string::npos;
    if (c == 0) {
      sum += part;
    } else if (alone && part == "1") {
      sum += (sum.empty() ? "" : " + ") + std::string(units[c]);
    } else if (alone && part == "-1") {
      sum += (sum.empty() ? "-" : " - ") + std::string(units[c]);
    } else if (alone && part[0] != '-') {
      sum += (sum.empty() ? "" : " + ") + part + "\\," + units[c];
    } else {
      sum += (sum.empty() ? "" : " + ") + std::string("\\left(") + part + "\\right)" + units[c];
    }
  }
  return sum.empty() ? "0" : sum;
}

std::string column(const std::string& x, const std::string& y, const std::string& z) {
  return "\\begin{pmatrix} " + x + " \\\\ " + y + " \\\\ " + z + " \\end{pmatrix}";
}
std::string latex(const VectorPolynomial& v) { return column(latex(v.x), latex(v.y), latex(v.z)); }
std::string latex(const RationalVector& v) { return column(latex(v.x), latex(v.y), latex(v.z)); }

/// The factors of a polynomial over ℚ, where they are short.
std::string factored(const RationalPolynomial& p) {
  if (p.is_constant()) return latex(p);
  std::string product = p.leading() == Rational(1) ? "" : latex(p.leading());
  for (const PolynomialFactor& f : irreducible_factors(p)) {
    const std::string base = latex(f.factor);
    const bool alone = base.find(' ') == std::string::npos;
    product += alone ? base : "\\left(" + base + "\\right)";
    if (f.multiplicity > 1) product += "^{" + std::to_string(f.multiplicity) + "}";
  }
  return product;
}
std::string latex(const RationalFunction& f) {
  return f.is_polynomial()
             ? latex(f.numerator())
             : "\\frac{" + latex(f.numerator()) + "}{" + factored(f.denominator()) + "}";
}
std::string latex(const VectorFunction& r) {
  return (r.is_polynomial() ? "" : "\\frac{1}{" + factored(r.denominator()) + "}") +
         latex(r.numerator());
}

std::string shown(const std::string& left, const std::string& right) {
  return "\\[ " + left + " = " + right + " \\]\n";
}

/// Plain text with the characters that mean something in LaTeX escaped; powers in math.
std::string escaped(const std::string& text) {
  std::string out;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '^' || c == '_') {  // a power, an index
      std::string digits;
      while (i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9') digits += text[++i];
      out += "$" + std::string(1, c) + "{" + digits + "}$";
    } else if (c == '*') {
      out += "$\\cdot$";
    } else if (std::string_view("%&#${}").find(c) != std::string_view::npos) {
      out += std::string("\\") + c;
    } else if (c == '\\' || c == '~') {
      out += c == '~' ? "\\textasciitilde{}" : "\\textbackslash{}";
    } else {
      out += c;
    }
  }
  return out;
}

std::string places(const std::vector<RealRoot>& roots) {
  if (roots.empty()) return "none";
  std::string text;
  for (const RealRoot& root : roots) {
    if (!text.empty()) text += "; ";
    text += root.is_rational() ? "$t = " + latex(root.lower()) + "$"
                               : "$t \\approx " + to_six_digits(root.to_double()) + "$";
    text += " (order " + std::to_string(root.multiplicity()) + ")";
  }
  return text;
}

/// The sentence with a capital.
std::string capital(std::string text) {
  if (!text.empty() && text[0] >= 'a' && text[0] <= 'z') {
    text[0] = static_cast<char>(text[0] - 'a' + 'A');
  }
  return text;
}

std::string heading(const std::string& title) { return "\\subsection*{" + escaped(title) + "}\n"; }

}  // namespace

std::string latex_of(const DescribedCurve& described) {
  const RationalPhCurve& curve = described.curve;
  std::string text = heading(capital(described.name)) + shown("r(t)", latex(curve.position()));
  if (curve.kind() == CurveKind::constant) return text;
  text += shown("\\lambda", latex(curve.lambda()));
  text += shown("\\sigma", latex(curve.speed()));
  text += described.length.obstruction.is_zero()
              ? shown("s(t)", latex(described.length.rational))
              : "The arc length is not rational: the part with simple poles of $\\sigma$ is\n\\[ " +
                    latex(described.length.obstruction) + ". \\]\n";
  text += "Poles: " + places(described.poles) + ".";
  if (described.stationary) text += " Zeros of $\\lambda$: " + places(*described.stationary) + ".";
  text += "\n";
  if (described.planes) text += shown("f = (F \\times F') \\cdot r", latex(*described.planes));
  text += shown("C", latex(described.motion.primal) + " + \\varepsilon\\left(" +
                         latex(described.motion.dual) + "\\right)");
  const auto& parts = described.decomposition;
  if (parts.pieces.size() > 1 || !parts.polynomial_lambda.is_zero()) {
    std::string sum;
    for (const auto& piece : parts.pieces) {
      sum += (sum.empty() ? "" : " + ") + latex(piece.curve);
    }
    if (!parts.polynomial_lambda.is_zero()) {
      sum += (sum.empty() ? "" : " + ") + std::string("\\int \\left(") +
             latex(parts.polynomial_lambda) + "\\right) F \\, dt";
    }
    text += shown("r(t)", sum + " + " + latex(parts.constant));
  }
  return text;
}

std::string latex_of(const RationalAnswer& answer) {
  const SolutionSpace& space = answer.space;
  std::string text =
      shown("A", latex(*answer.problem.a)) + shown("\\alpha", factored(space.alpha()));
  const Reduction& reduction = space.preimage_reduction();
  if (!reduction.was_reduced()) {
    text += "Reduced with respect to $\\mathbf{i}$, $A$ becomes\n\\[ " + latex(reduction.reduced) +
            ". \\]\n";
  }
  text += shown("F = A \\mathbf{i} A^*", latex(space.indicatrix()));
  text += shown("|A|^2", latex(norm_polynomial(space.preimage())));
  text += escaped(capital(answer.existence.reason)) + ".\n";
  text +=
      "\\begin{center}\\begin{tabular}{rrrr}\n$\\deg B$ & dimension & predicted & truly rational "
      "\\\\ \\hline\n";
  for (const DegreeRow& row : answer.rows) {
    text += std::to_string(row.degree) + " & " + std::to_string(row.dimension) + " & " +
            (row.predicted.exact ? "" : "$\\ge$ ") + std::to_string(row.predicted.value) + " & " +
            std::to_string(row.rationals()) + " \\\\\n";
  }
  text += "\\end{tabular}\\end{center}\n";
  if (!answer.basis) text += escaped(answer.basis_refused) + ".\n";
  for (const DescribedCurve& curve : answer.curves) text += latex_of(curve);
  if (answer.curves_left_out > 0) {
    text += std::to_string(answer.curves_left_out) + " more curves of the basis are left out.\n";
  }
  if (answer.chosen) text += latex_of(*answer.chosen);
  return text;
}

std::string latex_document(const std::vector<std::pair<std::string, std::string>>& sections) {
  std::string text =
      "\\documentclass{article}\n\\usepackage{amsmath}\n"
      "\\usepackage[landscape,margin=15mm]{geometry}\n\\begin{document}\n";
  for (const auto& [title, body] : sections) {
    if (!title.empty()) text += "\\section*{" + escaped(title) + "}\n";
    text += body;
  }
  return text + "\\end{document}\n";
}

}  // namespace hodograph::cli
