// SPDX-License-Identifier: MIT
// The parts of Ball that need not be inline, and its elementary functions.
#include "hodograph/certify/ball.hpp"

#include <array>
#include <limits>

namespace hodograph {

static_assert(sizeof(Ball) == sizeof(arb_struct), "arrays of balls are arrays of arb_struct");

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Function>
Ball image(const Ball& a, const Function& function) {
  Ball r;
  function(r.get(), a.get(), Ball::precision);
  return r;
}

Ball nothing_known() {
  Ball r;
  arb_indeterminate(r.get());
  return r;
}

}  // namespace

Ball::Ball(const Enclosure& x) : Ball() {
  if (!x.is_bounded()) {
    arb_indeterminate(value_);
    return;
  }
  // Both ends are doubles, exact in arf_t; the midpoint takes at most one rounding, which
  // arb_set_interval_arf adds to the radius.
  arf_t lower, upper;
  arf_init(lower);
  arf_init(upper);
  arf_set_d(lower, x.lower());
  arf_set_d(upper, x.upper());
  arb_set_interval_arf(value_, lower, upper, precision);
  arf_clear(lower);
  arf_clear(upper);
}

double Ball::radius() const {
  if (!arb_is_finite(value_)) return infinity;
  const double middle = midpoint();
  // The radius has 30 bits, so it is exact as a double in the normal range.
  const double own = mag_get_d(arb_radref(value_));
  if (!(own < infinity) || !(middle - middle == 0.0)) return infinity;
  // Below the normal range mag_get_d may round down to 0: one more smallest number covers it.
  const double rounding =
      (middle < 0.0 ? -middle : middle) * (0.5 * std::numeric_limits<double>::epsilon()) +
      std::numeric_limits<double>::denorm_min();
  return Enclosure::up(Enclosure::up(own) + Enclosure::up(rounding));
}

Ball sqrt(const Ball& a) { return image(a, arb_sqrt); }
Ball exp(const Ball& a) { return image(a, arb_exp); }
Ball log(const Ball& a) { return image(a, arb_log); }
Ball sin(const Ball& a) { return image(a, arb_sin); }
Ball cos(const Ball& a) { return image(a, arb_cos); }
Ball tan(const Ball& a) { return image(a, arb_tan); }
Ball sinh(const Ball& a) { return image(a, arb_sinh); }
Ball cosh(const Ball& a) { return image(a, arb_cosh); }
Ball tanh(const Ball& a) { return image(a, arb_tanh); }
Ball atan(const Ball& a) { return image(a, arb_atan); }
Ball asin(const Ball& a) { return image(a, arb_asin); }
Ball acos(const Ball& a) { return image(a, arb_acos); }

Ball atan2(const Ball& y, const Ball& x) {
  // Arb answers a ball on the cut by the whole range of angles: true for each member, but the
  // function jumps there and has no derivative.
  if (!arb_is_positive(x.get()) && arb_contains_zero(y.get())) return nothing_known();
  Ball r;
  arb_atan2(r.get(), y.get(), x.get(), Ball::precision);
  return r;
}

Ball abs(const Ball& a) {
  Ball r;
  arb_abs(r.get(), a.get());
  return r;
}

Ball pow(const Ball& a, int exponent) {
  const unsigned size =
      exponent < 0 ? 0u - static_cast<unsigned>(exponent) : static_cast<unsigned>(exponent);
  Ball r;
  arb_pow_ui(r.get(), a.get(), size, Ball::precision);
  return exponent < 0 ? Ball(1) / r : r;
}

Ball pow(const Ball& a, const Ball& exponent) { return exp(exponent * log(a)); }

Ball convolution(const Ball* a, const Ball* b, std::size_t k, std::size_t first, std::size_t last) {
  // Constants and linear functions are series that are mostly zeros.
  while (first <= last && (a[first].is_zero() || b[k - first].is_zero())) ++first;
  while (first < last && (a[last].is_zero() || b[k - last].is_zero())) --last;
  Ball r;
  if (first == last) {
    arb_mul(r.get(), a[first].get(), b[k - first].get(), Ball::precision);
  } else if (first < last) {
    arb_dot(r.get(), nullptr, 0, a[first].get(), 1, b[k - first].get(), -1,
            static_cast<slong>(last - first + 1), Ball::precision);
  }
  return r;
}

Ball divided_by_count(const Ball& a, std::size_t count) {
  static const auto reciprocals = [] {
    std::array<Ball, 16> table;
    for (std::size_t k = 1; k < table.size(); ++k) table[k] = Ball(1) / Ball(k);
    return table;
  }();
  if (count == 1) return a;
  return 1 < count && count < reciprocals.size() ? a * reciprocals[count] : a / Ball(count);
}

}  // namespace hodograph
