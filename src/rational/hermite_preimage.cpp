// SPDX-License-Identifier: MIT
// Rational directions, preimages between them, and a choice among those.
#include "hodograph/rational/hermite_preimage.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "flint.hpp"
#include "hodograph/construction/hermite.hpp"
#include "hodograph/rational/cusp_free.hpp"
#include "hodograph/rational/motion_polynomial.hpp"
#include "hodograph/rational/reduction.hpp"
#include "hodograph/rational/text.hpp"
#include "least_value.hpp"
#include "linear_program.hpp"

namespace hodograph {

using rational_detail::raw;

namespace {

using RationalQuaternion = Quaternion<Rational>;

/// √x where it is rational, x ≥ 0.
std::optional<Rational> exact_root(const Rational& x) {
  if (fmpz_is_square(&raw(x)->num) == 0 || fmpz_is_square(&raw(x)->den) == 0) return std::nullopt;
  Rational root;
  fmpz_sqrt(&raw(root)->num, &raw(x)->num);
  fmpz_sqrt(&raw(root)->den, &raw(x)->den);
  return root;
}

/// √x to a relative error of 2^-bits at most, x > 0.
Rational near_root(const Rational& x, ulong bits) {
  // √(n / d) = √(n d) / d, with enough bits behind the point.
  Rational product;
  fmpz_mul(&raw(product)->num, &raw(x)->num, &raw(x)->den);
  fmpz_mul_2exp(&raw(product)->num, &raw(product)->num, 2 * bits);
  Rational root;
  fmpz_sqrt(&raw(root)->num, &raw(product)->num);
  fmpq_div_2exp(raw(root), raw(root), bits);
  fmpq_div_fmpz(raw(root), raw(root), &raw(x)->den);
  return root;
}

Fault interval_fault(const Rational& begin, const Rational& end) {
  return {FaultCode::not_increasing,
          "the interval [" + to_text(begin) + ", " + to_text(end) +
              "] is empty; right would be begin < end",
          std::nullopt,
          "begin",
          begin.to_double(),
          end.to_double()};
}

/// a (x + y i).
RationalQuaternion times_complex(const RationalQuaternion& a, const Rational& x,
                                 const Rational& y) {
  return a * RationalQuaternion{x, y, {}, {}};
}

Quaternion<double> in_double(const RationalQuaternion& a) {
  return {a.w.to_double(), a.x.to_double(), a.y.to_double(), a.z.to_double()};
}
Vector3<double> in_double(const RationalVector& v) {
  return {v.x.to_double(), v.y.to_double(), v.z.to_double()};
}

/// x rounded to a multiple of 2^-bits.
Rational rounded(double x, long bits) {
  return rational_detail::rounded(*Rational::exactly(x), bits);
}

/// The freedom of a quadratic preimage in double between the directions, rounded.
std::optional<PreimageFreedom> rounded_freedom(const std::array<Quaternion<double>, 3>& a,
                                               const RationalQuaternion& first,
                                               const RationalQuaternion& last, long bits) {
  // a_0 = first z and a_2 = last w with complex z and w, to rounding; A z^-1 has factor 1 at begin.
  const Quaternion<double> p = in_double(first), q = in_double(last);
  const Quaternion<double> z = 1.0 / dot(p, p) * (conjugate(p) * a[0]);
  const Quaternion<double> inverse = 1.0 / (z.w * z.w + z.x * z.x) * Quaternion<double>{z.w, -z.x};
  const Quaternion<double> w = 1.0 / dot(q, q) * (conjugate(q) * a[2] * inverse);
  const Quaternion<double> inner = a[1] * inverse;
  const auto finite = [](const Quaternion<double>& x) {
    return std::isfinite(x.w) && std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z);
  };
  if (!finite(w) || !finite(inner)) return std::nullopt;
  PreimageFreedom freedom{rounded(w.w, bits), rounded(w.x, bits), {}};
  if (freedom.factor_re.is_zero() && freedom.factor_im.is_zero()) return std::nullopt;
  freedom.inner.push_back({rounded(inner.w, bits), rounded(inner.x, bits), rounded(inner.y, bits),
                           rounded(inner.z, bits)});
  return freedom;
}

/// The preimage with this freedom, if the chord is inside its cone.
std::optional<ChosenPreimage> accepted(const HermiteEnds& ends, const PreimageFreedom& freedom) {
  auto a =
      preimage_between(ends.begin_direction, ends.end_direction, freedom, ends.begin, ends.end);
  if (!a) return std::nullopt;
  const Reduction reduced = *reduction(*a);
  // Where A has a real root its direction there is another one.
  if (!is_positive(reduced.content(), ends.begin, ends.end)) return std::nullopt;
  constexpr std::size_t few_rounds = 4;
  ConeTest cone =
      cone_test(indicatrix(reduced.reduced), ends.chord, ends.begin, ends.end, few_rounds);
  if (cone.outcome != ConeTest::Outcome::inside) return std::nullopt;
  return ChosenPreimage{std::move(*a), freedom, std::move(cone)};
}

/// True when λ of the least degree that has as many coefficients as there are conditions is
/// positive: near the quintic, whose own λ is 1, it is.
bool serves(const HermiteEnds& ends, const QuaternionPolynomial& a) {
  RationalHermiteData data{{}, ends.chord, {}, {}, ends.begin, ends.end};
  std::size_t conditions = 3;
  if (ends.begin_speed) {
    data.begin_derivative = *ends.begin_speed * ends.begin_direction;
    ++conditions;
  }
  if (ends.end_speed) {
    data.end_derivative = *ends.end_speed * ends.end_direction;
    ++conditions;
  }
  const auto e = static_cast<std::size_t>(degree(indicatrix(reduction(a)->reduced)));
  const auto curves = HermiteCurves::create(*solve(a, 1, e + conditions), std::move(data));
  if (!curves) return false;
  constexpr std::size_t few_rounds = 4;
  const auto answer = cusp_free_curve(*curves, {few_rounds, 0});
  return answer && answer->outcome == CuspFreeAnswer::Outcome::found;
}

/// Preimages of quintics through the data, for several speeds at the ends.
std::vector<std::array<Quaternion<double>, 3>> quintics(const HermiteEnds& ends) {
  const Vector3<double> chord = in_double(ends.chord);
  const double h = (ends.end - ends.begin).to_double();
  const double length = norm(chord);
  std::vector<std::array<Quaternion<double>, 3>> result;
  for (const double share : {1.0, 0.5, 2.0}) {
    const double own = (length > 0.0 ? length / h : 1.0) * share;
    const double first = ends.begin_speed ? ends.begin_speed->to_double() : own;
    const double last = ends.end_speed ? ends.end_speed->to_double() : own;
    const HermitePoint<1> from = {Vector3<double>{}, first * in_double(ends.begin_direction)};
    const HermitePoint<1> to = {chord, last * in_double(ends.end_direction)};
    const auto keep = [&](const Result<SpatialPhCurve<2>>& curve) {
      if (!curve) return;
      const auto& a = curve->preimage().coefficients();
      result.push_back({a[0], a[1], a[2]});
    };
    for (const HermiteChoice choice : {HermiteChoice::order_ten, HermiteChoice::order_six}) {
      keep(hermite_curve<1, double>(from, to, h, choice));
    }
    // Data that are planar but for their replaced directions: curves that leave the plane.
    for (const double theta : {0.5, -0.5, 1.0, -1.0}) {
      HermiteParameters<1> parameters;
      parameters.theta_middle = theta;
      keep(hermite_curve<1, double>(from, to, h, parameters));
    }
  }
  return result;
}

Rational largest_part(const RationalQuaternion& a) {
  Rational largest;
  for (std::size_t c = 0; c < 4; ++c) largest = std::max(largest, a[c].sign() < 0 ? -a[c] : a[c]);
  return largest;
}

/// Small whole inner coefficients: every combination of two units, in three sizes.
std::vector<RationalQuaternion> small_inner_coefficients() {
  std::vector<RationalQuaternion> units;
  for (std::size_t i = 0; i < 4; ++i) {
    for (const int sign : {1, -1}) {
      RationalQuaternion q;
      q[i] = sign;
      units.push_back(q);
    }
  }
  std::vector<RationalQuaternion> result;
  for (const int size : {1, 3, 9}) {
    for (std::size_t i = 0; i < units.size(); ++i) {
      for (std::size_t j = i; j < units.size(); ++j) {
        const RationalQuaternion sum = units[i] + units[j];
        if (sum != RationalQuaternion{}) result.push_back(Rational(size) * sum);
      }
    }
  }
  return result;
}

}  // namespace

Result<RationalDirection> rational_direction(const RationalVector& v, long bits) {
  constexpr long most_bits = 60;
  if (v == RationalVector{}) {
    return Fault{FaultCode::zero_speed,
                 "the zero vector has no direction; right would be any other vector", std::nullopt,
                 "direction", 0.0};
  }
  if (bits < 1 || bits > most_bits) {
    return Fault{FaultCode::outside_domain,
                 "a direction is found within 2^-1 to 2^-" + std::to_string(most_bits) +
                     "; got 2^-" + std::to_string(bits),
                 std::nullopt,
                 "bits",
                 static_cast<double>(bits),
                 static_cast<double>(most_bits)};
  }
  const Rational square = dot(v, v);
  if (auto length = exact_root(square)) {
    const RationalVector unit = Rational(1) / *length * v;
    return RationalDirection{unit, std::move(*length)};
  }
  RationalDirection result;
  result.exact = false;
  constexpr ulong root_bits = 64;
  result.length = near_root(square, root_bits);
  // The stereographic projection from the pole opposite to the largest coordinate: the others,
  // over the length and that coordinate. Its points are at most 1 in size, and its inverse turns a
  // step into twice as large a step at most.
  std::size_t axis = 0;
  const auto size = [](const Rational& x) { return x.sign() < 0 ? -x : x; };
  for (std::size_t c = 1; c < 3; ++c) {
    if (size(v[axis]) < size(v[c])) axis = c;
  }
  const Rational down = Rational(1) / (result.length + size(v[axis]));
  Rational sum;
  for (std::size_t c = 0; c < 3; ++c) {
    if (c == axis) continue;
    result.unit[c] = rational_detail::simplest_within(v[c] * down, bits + 2);
    sum += result.unit[c] * result.unit[c];
  }
  const Rational scale = Rational(1) / (Rational(1) + sum);
  for (std::size_t c = 0; c < 3; ++c) result.unit[c] *= Rational(2) * scale;
  result.unit[axis] = Rational(v[axis].sign()) * (Rational(1) - sum) * scale;
  const RationalVector beside = cross(result.unit, v);
  result.deviation = std::sqrt((dot(beside, beside) / square).to_double());
  return result;
}

RationalQuaternion direction_preimage(const RationalVector& unit) {
  if (unit == RationalVector{-1, 0, 0}) return {0, 0, 0, 1};
  RationalQuaternion a{0, unit.x + Rational(1), unit.y, unit.z};
  // Whole and coprime coordinates: times the common denominator, over the common factor.
  fmpz_t denominator, factor;
  fmpz_init_set_ui(denominator, 1);
  fmpz_init(factor);
  for (std::size_t c = 1; c < 4; ++c) fmpz_lcm(denominator, denominator, &raw(a[c])->den);
  for (std::size_t c = 1; c < 4; ++c) {
    fmpq_mul_fmpz(raw(a[c]), raw(a[c]), denominator);
    fmpz_gcd(factor, factor, &raw(a[c])->num);
  }
  for (std::size_t c = 1; c < 4; ++c) fmpq_div_fmpz(raw(a[c]), raw(a[c]), factor);
  fmpz_clear(denominator);
  fmpz_clear(factor);
  return a;
}

Result<QuaternionPolynomial> preimage_between(const RationalVector& begin_direction,
                                              const RationalVector& end_direction,
                                              const PreimageFreedom& freedom, const Rational& begin,
                                              const Rational& end) {
  if (end <= begin) return interval_fault(begin, end);
  if (freedom.factor_re.is_zero() && freedom.factor_im.is_zero()) {
    return Fault{FaultCode::outside_domain,
                 "the free factor at the end is 0; right would be any other complex number",
                 std::nullopt, "factor", 0.0};
  }
  std::vector<RationalQuaternion> points = {direction_preimage(begin_direction)};
  points.insert(points.end(), freedom.inner.begin(), freedom.inner.end());
  points.push_back(
      times_complex(direction_preimage(end_direction), freedom.factor_re, freedom.factor_im));
  // Σ C(n, k) u^k (1 - u)^(n-k) a_k with u = (t - begin) / (end - begin).
  const std::size_t n = points.size() - 1;
  const Rational scale = Rational(1) / (end - begin);
  const RationalPolynomial u{-begin * scale, scale}, rest = RationalPolynomial(1) - u;
  QuaternionPolynomial a;
  Rational binomial(1);
  for (std::size_t k = 0; k <= n; ++k) {
    const RationalPolynomial weight = RationalPolynomial(binomial) * u.power(k) * rest.power(n - k);
    for (std::size_t c = 0; c < 4; ++c) a[c] += weight * RationalPolynomial(points[k][c]);
    binomial *= Rational(static_cast<std::int64_t>(n - k), static_cast<std::int64_t>(k + 1));
  }
  return a;
}

Result<ChosenPreimage> chosen_preimage(const HermiteEnds& ends) {
  if (ends.end <= ends.begin) return interval_fault(ends.begin, ends.end);
  for (const auto* speed : {&ends.begin_speed, &ends.end_speed}) {
    if (*speed && (*speed)->sign() <= 0) {
      return Fault{FaultCode::zero_speed,
                   "a speed of " + to_text(**speed) + " at an end; right would be more than 0",
                   std::nullopt,
                   "speed",
                   (*speed)->to_double(),
                   0.0};
    }
  }
  if (!std::isfinite(norm(in_double(ends.chord)))) {
    return Fault{FaultCode::outside_domain,
                 "the chord " + to_text(ends.chord) +
                     " is beyond the range of doubles, in which A is chosen; right would be other "
                     "units, or an A of your own",
                 std::nullopt, "chord"};
  }
  const RationalQuaternion first = direction_preimage(ends.begin_direction);
  const RationalQuaternion last = direction_preimage(ends.end_direction);
  const auto candidates = quintics(ends);
  std::optional<ChosenPreimage> any;
  for (const long bits : {3L, 5L, 7L, 10L, 14L, 19L, 24L}) {
    for (const auto& a : candidates) {
      const auto freedom = rounded_freedom(a, first, last, bits);
      if (!freedom) continue;
      auto chosen = accepted(ends, *freedom);
      if (!chosen) continue;
      if (serves(ends, chosen->preimage)) return std::move(*chosen);
      if (!any) any = std::move(chosen);
    }
  }
  if (any) return std::move(*any);
  const Rational size = Rational(1, 2) * (largest_part(first) + largest_part(last));
  for (const RationalQuaternion& inner : small_inner_coefficients()) {
    for (const auto& [re, im] : {std::pair(1, 0), std::pair(0, 1), std::pair(-1, 0)}) {
      if (auto chosen = accepted(ends, {re, im, {size * inner}})) return std::move(*chosen);
    }
  }
  return Fault{FaultCode::no_interpolant,
               "no preimage of degree 2 with tangents " + to_text(ends.begin_direction) + " and " +
                   to_text(ends.end_direction) + " at the ends was found whose cone holds the " +
                   "chord " + to_text(ends.chord) + "; right would be an A of your own",
               std::nullopt, "A"};
}

}  // namespace hodograph
