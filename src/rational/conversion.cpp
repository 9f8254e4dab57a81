// SPDX-License-Identifier: MIT
// Exact Bernstein coefficients, rounded; the preimage of a polynomial curve.
#include "hodograph/rational/conversion.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <string>
#include <utility>

#include "flint.hpp"
#include "hodograph/bernstein/complex_roots.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

/// The coefficients of p(a + (b - a) u) in the Bernstein basis of degree n ≥ deg p, exactly.
std::vector<Rational> bernstein_coefficients(const RationalPolynomial& p, const Rational& a,
                                             const Rational& b, std::size_t n) {
  RationalPolynomial q;
  fmpq_poly_compose(raw(q), raw(p), raw(RationalPolynomial{a, b - a}));
  // b_i = Σ_k C(i,k) c_k / C(n,k): n rounds of sums of neighbours.
  std::vector<Rational> c(n + 1);
  Rational choose(1);
  for (std::size_t k = 0; k <= n; ++k) {
    c[k] = q.coefficient(k) / choose;
    choose *= Rational(static_cast<std::int64_t>(n - k), static_cast<std::int64_t>(k + 1));
  }
  for (std::size_t round = 1; round <= n; ++round) {
    for (std::size_t i = n; i >= round; --i) c[i] += c[i - 1];
  }
  return c;
}

std::size_t degree_of(const RationalPolynomial& p) {
  return static_cast<std::size_t>(std::max(p.degree(), 0));
}

std::optional<Fault> interval_fault(double begin, double end) {
  for (const double x : {begin, end}) {
    if (!std::isfinite(x)) {
      return Fault{FaultCode::not_finite,
                   "an end of the interval is " + to_text(x) + "; right would be a finite number",
                   std::nullopt, "interval", x};
    }
  }
  if (begin < end) return std::nullopt;
  return Fault{FaultCode::not_increasing,
               "the interval runs from " + to_text(begin) + " to " + to_text(end) +
                   "; right would be an end beyond the beginning",
               std::nullopt,
               "interval",
               end,
               begin};
}

std::optional<Fault> pole_fault(const RationalPhCurve& curve, const Rational& begin,
                                const Rational& end) {
  for (const RealRoot& pole : curve.poles()) {
    if (pole.compare(begin) < 0 || pole.compare(end) > 0) continue;
    return Fault{FaultCode::outside_domain,
                 "the curve has a pole at t = " + to_text(pole.to_double()) + ", within [" +
                     to_text(begin) + ", " + to_text(end) +
                     "]; right would be an interval without it",
                 std::nullopt, "t", pole.to_double()};
  }
  return std::nullopt;
}

Fault range_fault(const char* what, double t) {
  return {FaultCode::outside_domain,
          std::string(what) + " near t = " + to_text(t) +
              " is beyond the range of doubles; right would be a curve scaled to it",
          std::nullopt, "t", t};
}

constexpr std::size_t most_pieces = std::size_t{1} << 10;

/// One rational Bézier curve over [begin, end], or nothing where the weights differ in sign.
std::optional<SpatialRationalBezier> bezier_piece(const VectorFunction& r, double begin,
                                                  double end) {
  const Rational a = *Rational::exactly(begin), b = *Rational::exactly(end);
  const auto n =
      static_cast<std::size_t>(std::max({degree(r.numerator()), r.denominator().degree(), 0}));
  std::vector<Rational> w = bernstein_coefficients(r.denominator(), a, b, n);
  Rational largest;
  for (const Rational& weight : w) {
    if (weight.sign() == 0 || weight.sign() != w[0].sign()) return std::nullopt;
    if (largest < weight * Rational(weight.sign())) largest = weight * Rational(weight.sign());
  }
  SpatialRationalBezier piece;
  piece.begin = begin;
  piece.end = end;
  piece.control_points.resize(n + 1);
  for (std::size_t c = 0; c < 3; ++c) {
    const auto p = bernstein_coefficients(r.numerator()[c], a, b, n);
    for (std::size_t i = 0; i <= n; ++i) piece.control_points[i][c] = (p[i] / w[i]).to_double();
  }
  for (const Rational& weight : w) {
    piece.weights.push_back((weight * Rational(weight.sign()) / largest).to_double());
  }
  return piece;
}

/// G with |G(u)|² = s(a + (b - a) u) / (leading coefficient of that), as Bernstein coefficients of
/// quaternions in ℂ; nothing where the roots are not found.
std::optional<DynamicPolynomial<Quaternion<double>>> square_root_factor(const RationalPolynomial& s,
                                                                        const Rational& a,
                                                                        const Rational& b) {
  using Factor = DynamicPolynomial<Quaternion<double>>;
  RationalPolynomial q;
  fmpq_poly_compose(raw(q), raw(s), raw(RationalPolynomial{a, b - a}));
  std::vector<std::complex<double>> coefficients;
  for (const Rational& c : q.monic().coefficients()) coefficients.emplace_back(c.to_double());
  const auto roots = complex_roots(coefficients);
  if (!roots) return std::nullopt;
  Factor result{Quaternion<double>{1.0, 0.0, 0.0, 0.0}};
  std::size_t count = 0;
  for (const auto& z : *roots) {
    if (!(z.imag() > 0.0)) continue;
    ++count;
    const Factor linear{{-z.real(), -z.imag(), 0.0, 0.0}, {1.0 - z.real(), -z.imag(), 0.0, 0.0}};
    result = product(result, linear, [](const auto& x, const auto& y) { return x * y; });
  }
  if (2 * count != degree_of(s)) return std::nullopt;
  return result;
}

}  // namespace

Result<Vector3<double>> position(const RationalPhCurve& curve, double t) {
  const auto exact = Rational::exactly(t);
  if (!exact) return exact.fault();
  if (auto fault = pole_fault(curve, *exact, *exact)) return *fault;
  const RationalVector r = curve.position().value(*exact);
  const Vector3<double> point{r.x.to_double(), r.y.to_double(), r.z.to_double()};
  if (!is_finite(point)) return range_fault("the curve", t);
  return point;
}

Result<std::vector<SpatialRationalBezier>> rational_bezier(const RationalPhCurve& curve,
                                                           double begin, double end) {
  if (auto fault = interval_fault(begin, end)) return *fault;
  if (auto fault = pole_fault(curve, *Rational::exactly(begin), *Rational::exactly(end))) {
    return *fault;
  }
  std::vector<SpatialRationalBezier> pieces;
  std::vector<double> ends{end};  // of what is still to do, the nearest last
  for (double from = begin; !ends.empty();) {
    const double to = ends.back();
    if (auto piece = bezier_piece(curve.position(), from, to)) {
      for (std::size_t i = 0; i < piece->weights.size(); ++i) {
        if (!is_finite(piece->control_points[i]) || !(piece->weights[i] > 0.0)) {
          return range_fault("a control point or weight", from);
        }
      }
      pieces.push_back(*std::move(piece));
      ends.pop_back();
      from = to;
      continue;
    }
    const double middle = from + 0.5 * (to - from);
    if (!(from < middle && middle < to) || pieces.size() + ends.size() > most_pieces) {
      return Fault{FaultCode::unsupported,
                   "a pole is so close to t = " + to_text(from) +
                       " that positive weights need too many pieces; right would be an interval "
                       "farther from it",
                   std::nullopt, "t", from};
    }
    ends.push_back(middle);
  }
  return pieces;
}

Result<PathNumbers> path_numbers(const RationalPhCurve& curve, double begin, double end) {
  if (auto fault = interval_fault(begin, end)) return *fault;
  if (curve.kind() != CurveKind::polynomial) {
    const bool point = curve.kind() == CurveKind::constant;
    return Fault{FaultCode::outside_domain,
                 point
                     ? "the curve is a point, and a path moves"
                     : "the curve has the denominator " + to_text(curve.position().denominator()) +
                           ", and a path is polynomial; rational Bézier curves hold it",
                 std::nullopt, "denominator"};
  }
  const RationalPolynomial& lambda = curve.lambda().numerator();
  RationalPolynomial q(1), s(1);
  for (const PolynomialFactor& f : square_free_factors(lambda)) {
    q *= f.factor.power(f.multiplicity / 2);
    if (f.multiplicity % 2 != 0) s *= f.factor;
  }
  if (const auto turns = real_roots(s); !turns.empty()) {
    return Fault{FaultCode::outside_domain,
                 "lambda = " + to_text(lambda) +
                     " changes its sign at t = " + to_text(turns[0].to_double()) +
                     ", so no polynomial preimage gives the curve; right would be a lambda of one "
                     "sign, or rational Bézier curves",
                 std::nullopt, "lambda", turns[0].to_double()};
  }
  const QuaternionPolynomial base = q * curve.preimage();
  const auto n = static_cast<std::size_t>(degree(base));
  if (const std::size_t whole = n + degree_of(s) / 2; whole > maximum_dynamic_degree) {
    return Fault{FaultCode::unsupported,
                 "the preimage has degree " + std::to_string(whole) + "; at most " +
                     std::to_string(maximum_dynamic_degree) + " is offered in a path",
                 std::nullopt,
                 "preimage degree",
                 static_cast<double>(whole),
                 static_cast<double>(maximum_dynamic_degree)};
  }
  const Rational a = *Rational::exactly(begin), b = *Rational::exactly(end);
  const auto factor = square_root_factor(s, a, b);
  if (!factor) {
    return Fault{FaultCode::no_convergence,
                 "the complex roots of " + to_text(s) + " were not found in double precision",
                 std::nullopt, "lambda"};
  }
  std::vector<Quaternion<double>> preimage(n + 1);
  for (std::size_t c = 0; c < 4; ++c) {
    const auto exact = bernstein_coefficients(base[c], a, b, n);
    for (std::size_t i = 0; i <= n; ++i) preimage[i][c] = exact[i].to_double();
  }
  // s(a + h u) = h^deg s Π |u - z|².
  Rational scale = lambda.leading();
  for (int i = 0; i < s.degree(); ++i) scale *= b - a;
  const double size = std::sqrt(std::abs(scale.to_double()));
  const Quaternion<double> last = scale.sign() > 0 ? Quaternion<double>{size, 0.0, 0.0, 0.0}
                                                   : Quaternion<double>{0.0, 0.0, 0.0, size};
  const auto whole = product(DynamicPolynomial<Quaternion<double>>(std::move(preimage)), *factor,
                             [&](const auto& x, const auto& y) { return x * y * last; });
  PathNumbers numbers;
  numbers.preimage_degree = whole.degree();
  numbers.knots = {begin, end};
  const RationalVector start = curve.position().value(a);
  for (std::size_t c = 0; c < 3; ++c) {
    numbers.starts.push_back(start[c].to_double());
    if (!std::isfinite(numbers.starts.back())) return range_fault("the curve", begin);
  }
  for (const auto& coefficient : whole.coefficients()) {
    if (!is_finite(coefficient)) return range_fault("the preimage", begin);
    for (std::size_t c = 0; c < 4; ++c) numbers.preimages.push_back(coefficient[c]);
  }
  return numbers;
}

}  // namespace hodograph
