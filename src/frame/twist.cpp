// SPDX-License-Identifier: MIT
#include "hodograph/frame/twist.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "periodic_roll.hpp"
#include "roll_builder.hpp"
#include "roll_integral.hpp"
#include "segment_rates.hpp"

namespace hodograph {

using frame_detail::Fraction;
using frame_detail::Row;
using frame_detail::scaled_preimage;

namespace {

Row<Complex<Enclosure>> enclosed(const Row<Complex<double>>& w) {
  Row<Complex<Enclosure>> result;
  for (const auto& c : w) result.push_back({Enclosure(c.re), Enclosure(c.im)});
  return result;
}

/// An enclosure of ∫ over [a, b] of [0, 1]; nothing where the denominator may vanish.
std::optional<Enclosure> integral_over(const Fraction<Enclosure>& f, double a, double b) {
  const Fraction<Enclosure> part{frame_detail::restricted(f.numerator, a, b),
                                 frame_detail::restricted(f.denominator, a, b)};
  Enclosure total(0.0);
  const bool done = frame_detail::expand(part, [&](const frame_detail::RateSeries& piece) {
    total = total + frame_detail::enclosed_integral(piece);
    return true;
  });
  if (!done) return std::nullopt;
  return (Enclosure(b) - Enclosure(a)) * total;
}

/// A bound of the integral of |f| over [a, b].
std::optional<double> size_over(const Fraction<Enclosure>& f, double a, double b) {
  double most = 0.0, least = std::numeric_limits<double>::infinity();
  for (const auto& c : frame_detail::restricted(f.numerator, a, b)) {
    most = std::max(most, c.magnitude());
  }
  for (const auto& c : frame_detail::restricted(f.denominator, a, b)) {
    least = std::min(least, c.lower());
  }
  if (!(least > 0.0)) return std::nullopt;
  return ((Enclosure(b) - Enclosure(a)) * Enclosure(most) / Enclosure(least)).upper();
}

/// Adds a segment's share; false where the speed may vanish.
bool add_share(FrameTwist& twist, const Fraction<Enclosure>& rate, double xi, double step) {
  const auto roots = isolated_roots(std::span<const Enclosure>(rate.numerator));
  if (!roots) return true;  // 0 everywhere
  const auto at = [&](double u) { return Enclosure(xi) + Enclosure(step) * Enclosure(u); };
  double from = 0.0;
  const auto go_to = [&](double to) {
    if (!(from < to)) return true;
    const auto share = integral_over(rate, from, to);
    if (!share) return false;
    twist.total = twist.total + *share;
    twist.absolute = twist.absolute + abs(*share);
    return true;
  };
  for (const auto& root : *roots) {
    if (!go_to(root.u.lower())) return false;
    from = root.u.upper();
    if (root.u.lower() < from) {
      const auto size = size_over(rate, root.u.lower(), from);
      if (!size) return false;
      twist.total = twist.total + Enclosure(-*size, *size);
      twist.absolute = twist.absolute + Enclosure(0.0, *size);
    }
    twist.inflections.push_back(
        {{at(root.u.lower()).lower(), at(root.u.upper()).upper()}, root.kind});
  }
  return go_to(1.0);
}

}  // namespace

Result<FrameTwist> frame_twist(const PreimageTable& path, const FrameRoll& roll) {
  if (roll.knots() != path.knots) {
    return Fault{FaultCode::mismatched_size,
                 "the roll was made for other knots than those of the path",
                 std::nullopt,
                 "knots",
                 static_cast<double>(roll.knots().size()),
                 static_cast<double>(path.knots.size())};
  }
  FrameTwist twist{Enclosure(0.0), Enclosure(0.0), {}};
  if (roll.kind() == RollKind::rotation_minimising) return twist;
  frame_detail::PeriodicTurn turn;
  if (roll.kind() == RollKind::periodic) {
    const auto closing = frame_detail::closing_turn(path);
    if (!closing) return closing.fault();
    turn = *closing;
    turn.gamma = roll.gamma();
  }
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto preimage = scaled_preimage(path, k);
    const double step = path.step(k);
    const auto erf = frame_detail::erf_rate(frame_detail::converted<Enclosure>(preimage.a));
    if (roll.kind() == RollKind::least_twist) {
      // ∫ k σ: the mean of the coefficients of σ times k h.
      Enclosure length(0.0);
      for (const auto& c : erf.denominator) length = length + c;
      length = length / Enclosure(static_cast<double>(erf.denominator.size()));
      const Enclosure unit(std::ldexp(1.0, preimage.exponent));
      const Enclosure share =
          Enclosure(roll.twist_rate()) * (((Enclosure(step) * length) * unit) * unit);
      twist.total = twist.total + share;
      twist.absolute = twist.absolute + abs(share);
      continue;
    }
    Fraction<Enclosure> rate = erf;
    if (roll.kind() == RollKind::linear) {
      const Enclosure even = Enclosure(roll.linear_rate()) * Enclosure(step);
      rate.numerator =
          frame_detail::sum(erf.numerator, frame_detail::scaled(even, erf.denominator));
    } else if (roll.kind() == RollKind::periodic) {
      const auto w = enclosed(frame_detail::turn_on_segment(path, turn, k));
      rate = frame_detail::sum(erf, frame_detail::argument_rate(w, Enclosure(2.0)));
    } else if (roll.kind() == RollKind::frenet) {
      const auto normal = frame_detail::normal_direction(preimage.a);
      if (normal.c.empty()) return RollBuilder::zero_speed(k, "there is no principal normal");
      rate =
          frame_detail::sum(erf, frame_detail::argument_rate(enclosed(normal.c), Enclosure(1.0)));
    }
    if (!add_share(twist, rate, path.knots[k], step)) {
      return RollBuilder::zero_speed(k, "the frame may turn by any angle");
    }
  }
  return twist;
}

std::optional<ClosedFormTwist> erf_twist_in_closed_form(const PreimageTable& path) {
  constexpr double half_of_the_digits = 0x1.0p-26;  // not a tolerance: half of the 52 binary digits
  ClosedFormTwist twist;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto rate = frame_detail::erf_rate(scaled_preimage(path, k).a);
    if (std::all_of(rate.numerator.begin(), rate.numerator.end(),
                    [](double c) { return c == 0.0; })) {
      continue;
    }
    const auto share =
        frame_detail::integral_by_partial_fractions(rate.numerator, rate.denominator);
    if (!share || !(share->error <= half_of_the_digits)) return std::nullopt;
    twist.value += share->value;
    twist.error += share->error + epsilon<double>() * std::abs(twist.value);
  }
  return twist;
}

}  // namespace hodograph
