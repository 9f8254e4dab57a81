// SPDX-License-Identifier: MIT
// What is known of rational PH curves, as LaTeX (amsmath).
#include <array>
#include <cctype>
#include <string>
#include <string_view>
#include <type_traits>

#include "cli/rationals.hpp"

namespace hodograph::cli {
namespace {

/// A formula stands on a line of its own, or, where it is wider than the page, it is broken into
/// lines: TeX does so at signs and commas outside of fractions, columns and growing brackets.
enum class Layout { line, broken };

/// About as wide as the page, in characters that are seen.
constexpr std::size_t latex_width = 120;

/// The characters of a formula that are seen, about: commands and braces are not.
std::size_t width(std::string_view formula) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < formula.size(); ++i) {
    if (formula[i] == '\\') {
      while (i + 1 < formula.size() && std::isalpha(static_cast<unsigned char>(formula[i + 1])))
        ++i;
    } else if (std::string_view("{} ^").find(formula[i]) == std::string_view::npos) {
      ++count;
    }
  }
  return count;
}

std::string bracketed(const std::string& formula, Layout layout) {
  return layout == Layout::line ? "\\left(" + formula + "\\right)" : "(" + formula + ")";
}

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

std::string latex(const QuaternionPolynomial& a, Layout layout = Layout::line) {
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
      sum += (sum.empty() ? "" : " + ") + bracketed(part, layout) + units[c];
    }
  }
  return sum.empty() ? "0" : sum;
}

std::string column(const std::string& x, const std::string& y, const std::string& z,
                   Layout layout = Layout::line) {
  if (layout == Layout::broken) {
    return "\\bigl(" + x + ",\\allowbreak\\; " + y + ",\\allowbreak\\; " + z + "\\bigr)^T";
  }
  return "\\begin{pmatrix} " + x + " \\\\ " + y + " \\\\ " + z + " \\end{pmatrix}";
}
std::string latex(const VectorPolynomial& v, Layout layout = Layout::line) {
  return column(latex(v.x), latex(v.y), latex(v.z), layout);
}
std::string latex(const RationalVector& v) { return column(latex(v.x), latex(v.y), latex(v.z)); }

/// The factors of a polynomial over ℚ, where they are short.
std::string latex_factored(const RationalPolynomial& p) {
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
std::string latex(const RationalFunction& f, Layout layout = Layout::line) {
  if (f.is_polynomial()) return latex(f.numerator());
  const std::string above = latex(f.numerator()), below = latex_factored(f.denominator());
  return layout == Layout::line ? "\\frac{" + above + "}{" + below + "}"
                                : "\\frac{1}{" + below + "} (" + above + ")";
}
std::string latex(const VectorFunction& r, Layout layout = Layout::line) {
  return (r.is_polynomial() ? "" : "\\frac{1}{" + latex_factored(r.denominator()) + "}") +
         latex(r.numerator(), layout);
}

/// The formula of formula(Layout) on lines of its own; `end` follows it.
template <class Formula>
  requires std::is_invocable_v<Formula, Layout>
std::string displayed(const Formula& formula, const std::string& end = "") {
  const std::string line = formula(Layout::line) + end;
  if (width(line) <= latex_width) return "\\[ " + line + " \\]\n";
  return "\\begin{flushleft}$\\displaystyle " + formula(Layout::broken) + end +
         "$\\end{flushleft}\n";
}
/// left = what value(Layout) gives, or the value itself.
template <class Value>
std::string shown(const std::string& left, const Value& value) {
  return displayed([&](Layout layout) {
    if constexpr (std::is_invocable_v<Value, Layout>) {
      return left + " = " + value(layout);
    } else if constexpr (std::is_same_v<Value, RationalPolynomial>) {
      return left + " = " + latex(value);
    } else {
      return left + " = " + latex(value, layout);
    }
  });
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
  std::string text = heading(capital(described.name)) + shown("r(t)", curve.position());
  if (curve.kind() == CurveKind::constant) return text;
  text += shown("\\lambda", curve.lambda());
  text += shown("\\sigma", curve.speed());
  text += described.length.obstruction.is_zero()
              ? shown("s(t)", described.length.rational)
              : "The arc length is not rational: the part with simple poles of $\\sigma$ is\n" +
                    displayed(
                        [&](Layout layout) { return latex(described.length.obstruction, layout); },
                        ".");
  text += "Poles: " + places(described.poles) + ".";
  if (described.stationary) text += " Zeros of $\\lambda$: " + places(*described.stationary) + ".";
  text += "\n";
  if (described.planes) text += shown("f = (F \\times F') \\cdot r", *described.planes);
  text += shown("C", [&](Layout layout) {
    return latex(described.motion.primal, layout) + " + \\varepsilon " +
           bracketed(latex(described.motion.dual, layout), layout);
  });
  const auto& parts = described.decomposition;
  if (parts.pieces.size() > 1 || !parts.polynomial_lambda.is_zero()) {
    text += shown("r(t)", [&](Layout layout) {
      std::string sum;
      for (const auto& piece : parts.pieces) {
        sum += (sum.empty() ? "" : " + ") + latex(piece.curve, layout);
      }
      if (!parts.polynomial_lambda.is_zero()) {
        sum += (sum.empty() ? "" : " + ") + std::string("\\int ") +
               bracketed(latex(parts.polynomial_lambda), layout) + " F \\, dt";
      }
      return sum + " + " + latex(parts.constant);
    });
  }
  return text;
}

std::string latex_of(const RationalAnswer& answer) {
  const SolutionSpace& space = answer.space;
  std::string text = shown("A", *answer.problem.a) +
                     shown("\\alpha", [&](Layout) { return latex_factored(space.alpha()); });
  const Reduction& reduction = space.preimage_reduction();
  if (!reduction.was_reduced()) {
    text += "Reduced with respect to $\\mathbf{i}$, $A$ becomes\n" +
            displayed([&](Layout layout) { return latex(reduction.reduced, layout); }, ".");
  }
  text += shown("F = A \\mathbf{i} A^*", space.indicatrix());
  text += shown("|A|^2", norm_polynomial(space.preimage()));
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
