// SPDX-License-Identifier: MIT
#include "segment_rates.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

#include "complex_roots.hpp"
#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/path/detail/enclosed_curve.hpp"
#include "hodograph/path/detail/preimage_turn.hpp"

namespace hodograph::frame_detail {

ScaledPreimage scaled_preimage(const PreimageTable& path, std::size_t segment) {
  const std::size_t count = path.degree + 1;
  const auto first = path.coefficients.begin() + static_cast<std::ptrdiff_t>(segment * count);
  ScaledPreimage result{{first, first + static_cast<std::ptrdiff_t>(count)}, 0};
  double largest = 0.0;
  for (const auto& a : result.a) largest = std::max(largest, largest_component(a));
  if (!(largest > 0.0)) return result;
  result.exponent = path_detail::exponent_of(largest);
  for (auto& a : result.a) {
    for (std::size_t i = 0; i < 4; ++i) a[i] = std::ldexp(a[i], -result.exponent);
  }
  return result;
}

namespace {

/// c/(u - a), the remainder left out. From the end that is farther from a.
Row<Complex<double>> without_root(const Row<Complex<double>>& c, double a) {
  const std::size_t m = c.size() - 1;
  Row<Complex<double>> scaled = power_coefficients(c), d(m);
  if (a > 0.5) {
    for (std::size_t k = 0; k < m; ++k) {
      const Complex<double> rest = k == 0 ? scaled[0] : scaled[k] - (1.0 - a) * d[k - 1];
      d[k] = (-1.0 / a) * rest;
    }
  } else {
    for (std::size_t k = m; k > 0; --k) {
      const Complex<double> rest = k == m ? scaled[m] : scaled[k] + a * d[k];
      d[k - 1] = (1.0 / (1.0 - a)) * rest;
    }
  }
  double binomial = 1.0;
  for (std::size_t k = 1; k < m; ++k) {
    binomial = binomial * static_cast<double>(m - k) / static_cast<double>(k);
    d[k] = (1.0 / binomial) * d[k];
  }
  return d;
}

double size(const Complex<double>& z) { return std::hypot(z.re, z.im); }

}  // namespace

NormalDirection normal_direction(const Row<Quaternion<double>>& a) {
  NormalDirection result;
  const auto v = turning(a, [](const auto& p, const auto& q) { return body_rate_form(p, q); });
  Row<Complex<double>> c;
  double largest = 0.0;
  for (const auto& x : v) c.push_back({x.z, -x.y});
  for (const auto& q : a) largest = std::max(largest, norm(q));
  const auto m = static_cast<double>(c.size() - 1);
  const double noise = (11.0 + 3.0 * m) * epsilon<double>() * largest * largest;
  if (std::all_of(c.begin(), c.end(), [&](const auto& x) { return size(x) <= noise; })) {
    return result;
  }

  // Candidates: the points of [0, 1] next to the roots of c, z = u/(1-u).
  Row<std::complex<double>> power;
  for (const auto& x : power_coefficients(c)) power.push_back({x.re, x.im});
  std::vector<double> zeros;
  if (const auto roots = complex_roots(power)) {
    zeros.assign(c.size() - 1 - roots->size(), 1.0);  // z infinite
    for (const auto& z : *roots) {
      const std::complex<double> u = z / (1.0 + z);
      const double near = std::isfinite(u.real()) ? std::clamp(u.real(), 0.0, 1.0) : 2.0;
      if (near <= 1.0 && size(value(c, near)) <= noise) zeros.push_back(near);
    }
  }
  std::sort(zeros.begin(), zeros.end());
  std::vector<double> inside;
  for (const double zero : zeros) {
    if (c.size() < 2) break;
    c = without_root(c, zero);
  }
  for (const double zero : zeros) {
    const double slope = size(value(c, zero));
    double others = 1.0;
    for (const double other : zeros) {
      if (other != zero) others *= std::abs(zero - other);
    }
    const double rounding = slope * others > 0.0 ? noise / (slope * others) : 1.0;
    if (zero <= rounding || 1.0 - zero <= rounding) continue;  // the limit at the end
    result.flips.push_back(zero);
    result.roundings.push_back(std::min(rounding, 1.0));
  }
  result.c = std::move(c);
  return result;
}

namespace {

path_detail::PreimageTurn<Quaternion<double>> turn_of(const Row<Quaternion<double>>& before,
                                                      const Row<Quaternion<double>>& after) {
  path_detail::PreimageTurn<Quaternion<double>> turn;
  const double end = largest_component(before.back()), begin = largest_component(after.front());
  turn.q = conjugate((1.0 / begin) * after.front()) * ((1.0 / end) * before.back());
  path_detail::set_sizes(turn);
  double last = 0.0, first = 0.0;
  for (const auto& a : before) last = std::max(last, largest_component(a));
  for (const auto& a : after) first = std::max(first, largest_component(a));
  turn.allowed = accuracy::join_error<double>() * (last / end + first / begin);
  return turn;
}

}  // namespace

bool tangent_breaks(const Row<Quaternion<double>>& before, const Row<Quaternion<double>>& after) {
  return turn_of(before, after).is_break();
}

KnotTurn knot_turn(const Row<Quaternion<double>>& before, const Row<Quaternion<double>>& after) {
  const auto turn = turn_of(before, after);
  KnotTurn result;
  result.breaks = turn.is_break();
  result.angle = turn.angle();
  result.allowed = 2.0 * turn.allowed;
  const double length = turn.along;
  result.cosine = turn.q.w / length;
  result.sine = turn.q.x / length;
  if (std::abs(result.sine) <= turn.allowed) {
    result.cosine = result.cosine < 0.0 ? -1.0 : 1.0;
    result.sine = 0.0;
  }
  const double sign = result.cosine < 0.0 ? -1.0 : 1.0;
  result.roll = 2.0 * std::atan2(sign * result.sine, sign * result.cosine);
  return result;
}

}  // namespace hodograph::frame_detail
