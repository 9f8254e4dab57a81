// SPDX-License-Identifier: MIT
// Rational PH curves as they are asked for, found, and told: what `hodograph rational` and the
// request "rational" have in common. Everything is exact; doubles appear in pictures and exports.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cli/json.hpp"
#include "cli/made_path.hpp"
#include "hodograph/io/svg.hpp"
#include "hodograph/rational/conversion.hpp"
#include "hodograph/rational/existence.hpp"
#include "hodograph/rational/rational_ph_curve.hpp"
#include "hodograph/rational/solution_space.hpp"
#include "hodograph/rational/text.hpp"

namespace hodograph::cli {

class Members;

/// How many curves are described in full unless the user says otherwise.
inline constexpr std::size_t usual_described_curves = 8;

/// What is asked for. Without a degree: the least one whose space holds a truly rational curve, or
/// a polynomial one where none exists, and the curve r or of f. Without alpha: the denominator of
/// that curve.
struct RationalProblem {
  std::optional<QuaternionPolynomial> a{};
  std::optional<RationalPolynomial> alpha{};
  std::optional<std::size_t> degree{};
  std::optional<VectorFunction> curve{};     ///< r
  std::optional<RationalFunction> planes{};  ///< f of the osculating planes u · x = f
  std::vector<Rational> coefficients{};      ///< of a curve in the canonical basis
  std::size_t described = usual_described_curves;
};

/// Takes the definitions A, alpha, degree, r, f of a text; others serve within the text alone.
/// Throws Error, whose index is that of the byte in the text.
void define(RationalProblem& problem, std::string_view text);
/// The same from the members A, alpha, degree, r, f, coefficients, curves of a JSON object:
/// polynomials as text, or as lists of coefficients, the constant one first. Throws Error.
void define(RationalProblem& problem, Members& members);

/// A curve with what is known of it.
struct DescribedCurve {
  std::string name;                    ///< for sentences: "curve 2 of the basis"
  std::optional<std::size_t> index{};  ///< in the canonical basis, from 0
  RationalPhCurve curve;
  RationalIntegral length;
  std::vector<RealRoot> poles;
  std::optional<std::vector<RealRoot>> stationary;  ///< nothing where that would take too long
  std::optional<RationalFunction> planes{};         ///< f; nothing for planar curves
  DualQuaternionPolynomial motion;
  RationalPhCurve::Decomposition decomposition;
  /// The curve is the sum of these multiples of the canonical basis; empty where it is not in the
  /// space, or the basis is not known.
  std::vector<Rational> coordinates{};
};

/// F around the roots of an irreducible factor q of α: f_k modulo q, whose value at a root is f_k
/// there, F = Σ f_k (t - root)^k; k up to the order of the pole.
struct TaylorRow {
  RationalPolynomial factor;
  std::size_t order = 1;
  std::vector<VectorPolynomial> coefficients;
};

/// The dimension of V_degree, and what was predicted.
struct DegreeRow {
  std::size_t degree = 0, dimension = 0, points = 0, polynomials = 0;
  Existence::Dimension predicted{};
  std::size_t rationals() const { return dimension - points - polynomials; }
};

struct RationalAnswer {
  RationalProblem problem;
  SolutionSpace space;
  Existence existence;
  std::vector<DegreeRow> rows{};  ///< of all degrees up to the space's; of that alone without basis
  std::optional<std::vector<VectorPolynomial>> basis{};  ///< canonical
  std::string basis_refused{};                           ///< why there is none
  std::vector<DescribedCurve> curves{};                  ///< those of the basis that are no points
  std::size_t curves_left_out = 0;
  std::optional<DescribedCurve> chosen{};                ///< r, f, or the combination
  std::vector<RealRoot> inflections{}, torsion_zeros{};  ///< of every curve
  std::vector<TaylorRow> taylor{};
};

/// Throws Error.
RationalAnswer answer_of(const RationalProblem& problem);

/// The curve that pictures and exports show: the chosen one, else the first that is truly rational,
/// else the first that is no point. Throws Error (outside_domain) where there is none.
DescribedCurve shown_curve(const RationalAnswer& answer);

/// Refuses an A, alpha and degree for which an answer would take hours. Throws Error. Domain: an A.
void require_small(const RationalProblem& problem);

/// What is told of a curve; isolating the zeros of λ may take a second.
DescribedCurve described_curve(RationalPhCurve curve, const std::string& name);

/// The polynomial that a member of a request is, as text or as a list of coefficients. Throw Error.
RationalPolynomial polynomial_member(Members& members, std::string_view name);
QuaternionPolynomial quaternion_member(Members& members, std::string_view name);

/// Exact numbers as strings, polynomials as lists of coefficients, a root with its isolating
/// interval.
Json json_of(const RationalPolynomial& p);
Json json_of(const RationalVector& v);
Json json_of(const VectorPolynomial& v);
Json json_of(const QuaternionPolynomial& a);
Json json_of(const RealRoot& root);

/// The answer for people, for programs (docs/requests.md), and as a LaTeX document.
std::string text_of(const RationalAnswer& answer);
Json json_of(const RationalAnswer& answer);
std::string latex_of(const RationalAnswer& answer);
std::string text_of(const DescribedCurve& described);
Json json_of(const DescribedCurve& described);
std::string latex_of(const DescribedCurve& described);
/// A whole LaTeX document of several of them, with their headings ("": none).
std::string latex_document(const std::vector<std::pair<std::string, std::string>>& sections);

/// Three views of the curve and its speed, between its poles over the whole line, or over
/// [begin, end]; parts near a pole leave the picture.
std::vector<Plot> rational_pictures(const DescribedCurve& described,
                                    const std::optional<std::pair<double, double>>& interval);
/// The curve over [begin, end] as rational Bézier pieces and as one NURBS curve. Throws Error.
Json nurbs_of(const DescribedCurve& curve, double begin, double end);
/// A curve in a plane z = constant over [begin, end] as DXF, without that z. Throws Error.
std::string dxf_of(const DescribedCurve& curve, double begin, double end);
/// The polynomial curve over [begin, end] as a path document. Throws Error.
MadePath path_of(const DescribedCurve& curve, double begin, double end, const std::string& source);

/// One of the paper's examples, as text, with the degrees and curves that the paper looks at.
struct PaperExample {
  const char *name, *text;
  std::size_t degree;
  const char* remark;
  std::vector<std::pair<const char*, const char*>> curves;  ///< label and r(t), as printed
};
/// The six of section 5, in the paper's order.
const std::vector<PaperExample>& paper_examples();

}  // namespace hodograph::cli
