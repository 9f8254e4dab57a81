// SPDX-License-Identifier: MIT
// Periodic rational frames of closed paths: θ = 2 arg w with a linear w.
#include "periodic_roll.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "hodograph/bernstein/roots.hpp"
#include "roll_builder.hpp"
#include "roll_chain.hpp"

namespace hodograph {

using frame_detail::Fraction;
using frame_detail::PeriodicTurn;
using frame_detail::Row;
using frame_detail::scaled_preimage;

namespace frame_detail {

Result<PeriodicTurn> closing_turn(const PreimageTable& path) {
  if (!path.closed) {
    return Fault{FaultCode::unsupported, "a periodic frame is for closed paths; this one is open",
                 std::nullopt,           "closed",
                 std::nullopt,           std::nullopt};
  }
  const auto turns = knot_turns(path);
  if (!turns) return turns.fault();
  for (std::size_t k = 0; k + 1 < turns->size(); ++k) {
    if ((*turns)[k].roll == 0.0) continue;
    return Fault{FaultCode::not_continuous,
                 "the Euler-Rodrigues frame jumps by " + to_text((*turns)[k].roll) +
                     " rad at knot " + std::to_string(k + 1) +
                     "; a periodic frame turns it smoothly and needs it continuous, a frame of "
                     "least twist does not",
                 k + 1,
                 "roll",
                 (*turns)[k].roll,
                 0.0};
  }
  return PeriodicTurn{1.0, turns->back().cosine, turns->back().sine};
}

std::optional<Fault> gamma_fault(const PeriodicTurn& turn) {
  const bool finite = std::isfinite(turn.gamma);
  if (finite && turn.gamma != 0.0 && (turn.sine != 0.0 || turn.gamma * turn.cosine > 0.0)) {
    return std::nullopt;
  }
  const bool wrong_sign = finite && turn.gamma != 0.0;
  return Fault{
      FaultCode::outside_domain,
      wrong_sign ? "with gamma " + to_text(turn.gamma) +
                       " the frame turns by any angle on the way, since the frame already closes; "
                       "gamma of the other sign is right"
                 : "gamma is a number other than 0; got " + to_text(turn.gamma),
      std::nullopt,
      "gamma",
      turn.gamma,
      0.0};
}

Row<Complex<double>> turn_on_segment(const PreimageTable& path, const PeriodicTurn& turn,
                                     std::size_t segment) {
  const double first = path.knots.front(), length = path.knots.back() - first;
  const auto tau = [&](std::size_t k) {
    return k + 1 == path.knots.size() ? 1.0 : (path.knots[k] - first) / length;
  };
  return {turn.at(tau(segment)), turn.at(tau(segment + 1))};
}

}  // namespace frame_detail

Result<FrameRoll> periodic_roll(const PreimageTable& path, double gamma) {
  auto turn = frame_detail::closing_turn(path);
  if (!turn) return turn.fault();
  turn->gamma = gamma;
  if (auto fault = frame_detail::gamma_fault(*turn)) return *std::move(fault);
  RollBuilder builder(path, RollKind::periodic);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    RollBuilder::SegmentRoll segment;
    segment.argument = frame_detail::turn_on_segment(path, *turn, k);
    segment.factor = 2.0;
    segment.rate = frame_detail::argument_rate(segment.argument, 2.0);
    // w goes straight from 1 to γ e^(-iψ), so that its principal argument is continuous.
    const Complex<double> w = segment.argument.front();
    if (!builder.append(std::move(segment), 2.0 * std::atan2(w.im, w.re))) {
      return RollBuilder::zero_speed(k, "the periodic frame may turn by any angle");
    }
  }
  builder.gamma() = gamma;
  builder.psi() = std::atan2(turn->sine, turn->cosine);
  return std::move(builder).finish();
}

Result<SmoothGammas> smooth_periodic_gammas(const PreimageTable& path) {
  const auto turn = frame_detail::closing_turn(path);
  if (!turn) return turn.fault();
  if (turn->sine == 0.0) {
    return Fault{FaultCode::no_interpolant,
                 "the Euler-Rodrigues frame of this path closes by itself (psi is a multiple of "
                 "pi): no gamma changes how smoothly",
                 std::nullopt,
                 "psi",
                 std::atan2(turn->sine, turn->cosine),
                 std::nullopt};
  }
  // χ₁/σ at the ends, times the speed at the start.
  const auto end_rate = [&](std::size_t k, bool last, double& speed, int& exponent) {
    const auto preimage = scaled_preimage(path, k);
    const auto rate = frame_detail::erf_rate(preimage.a);
    speed = last ? rate.denominator.back() : rate.denominator.front();
    exponent = preimage.exponent;
    return (last ? rate.numerator.back() : rate.numerator.front()) / (speed * path.step(k));
  };
  double first_speed = 0.0, last_speed = 0.0;
  int first_exponent = 0, last_exponent = 0;
  const double first = end_rate(0, false, first_speed, first_exponent);
  const double last = end_rate(path.segment_count() - 1, true, last_speed, last_exponent);
  const double ratio = std::ldexp(first_speed / last_speed, 2 * (first_exponent - last_exponent));
  const double half = 0.5 * (path.knots.back() - path.knots.front());
  // γ² sin ψ - γ d - ratio sin ψ = 0.
  const double d = half * (first - ratio * last), s = turn->sine;
  const double root = std::sqrt(d * d + 4.0 * s * s * ratio);
  const double q = 0.5 * (d < 0.0 ? d - root : d + root);
  const double one = q / s, other = -ratio * s / q;
  return SmoothGammas{std::min(one, other), std::max(one, other)};
}

namespace {

/// The absolute twist as a function of γ: the variation of θ_γ - θ_RMF.
class AbsoluteTwist {
 public:
  AbsoluteTwist(const PreimageTable& path, const FrameRoll& minimising, PeriodicTurn turn)
      : path_(&path), minimising_(&minimising), turn_(turn) {
    for (std::size_t k = 0; k < path.segment_count(); ++k) {
      erf_.push_back(frame_detail::erf_rate(scaled_preimage(path, k).a));
    }
  }

  struct Value {
    double twist = 0.0, slope = 0.0;  ///< slope: by γ
    bool one_sense = true;
  };
  Value at(double gamma) const {
    PeriodicTurn turn = turn_;
    turn.gamma = gamma;
    const double first = path_->knots.front(), length = path_->knots.back() - first;
    Value result;
    // θ_γ - θ_RMF, and its derivative by γ: 2 Im(τ e^(-iψ)/w).
    const auto angle = [&](double xi) {
      const Complex<double> w = turn.at((xi - first) / length);
      return 2.0 * std::atan2(w.im, w.re) - minimising_->angle(xi);
    };
    const auto slope = [&](double xi) {
      const double tau = (xi - first) / length;
      const Complex<double> w = turn.at(tau), e{tau * turn.cosine, -(tau * turn.sine)};
      return 2.0 * body_rate_form(w, e) / dot(w, w);
    };
    double at = first, theta = angle(at), change = slope(at), sense = 0.0;
    const auto go_to = [&](double xi) {
      const double next = angle(xi), next_change = slope(xi);
      const double sign = next < theta ? -1.0 : 1.0;
      if (sense != 0.0 && sign != sense) result.one_sense = false;
      sense = sign;
      result.twist += std::abs(next - theta);
      result.slope += sign * (next_change - change);
      theta = next;
      change = next_change;
    };
    for (std::size_t k = 0; k < path_->segment_count(); ++k) {
      const auto w = frame_detail::turn_on_segment(*path_, turn, k);
      const auto numerator =
          frame_detail::sum(erf_[k], frame_detail::argument_rate(w, 2.0)).numerator;
      Row<Enclosure> enclosed(numerator.begin(), numerator.end());
      const auto roots = isolated_roots(std::span<const Enclosure>(enclosed));
      if (roots) {
        for (const auto& root : *roots) {
          if (root.kind != RootKind::simple) continue;
          const double u = root.u.middle();
          if (0.0 < u && u < 1.0) go_to(path_->knots[k] + u * path_->step(k));
        }
      }
      if (k + 1 == path_->segment_count()) go_to(path_->knots.back());
    }
    return result;
  }

 private:
  const PreimageTable* path_;
  const FrameRoll* minimising_;
  PeriodicTurn turn_;
  std::vector<Fraction<double>> erf_;
};

}  // namespace

Result<LeastTwistGamma> least_twist_gamma(const PreimageTable& path) {
  const auto turn = frame_detail::closing_turn(path);
  if (!turn) return turn.fault();
  const auto minimising = rotation_minimising_roll(path);
  if (!minimising) return minimising.fault();
  const AbsoluteTwist twist(path, *minimising, *turn);

  constexpr int grid = 64;  // intervals a sign, ±1 in the middle
  constexpr double most = 100.0;
  std::optional<LeastTwistGamma> best;
  const auto offer = [&](double gamma, const AbsoluteTwist::Value& value) {
    const double distance = std::abs(std::log(std::abs(gamma)));
    const double rounding = 64.0 * epsilon<double>() * (1.0 + value.twist);
    const bool less = !best || value.twist < best->absolute_twist - rounding;
    const bool equal = !less && value.twist <= best->absolute_twist + rounding;
    if (less || (equal && value.one_sense && best->plateau &&
                 distance < std::abs(std::log(std::abs(best->gamma))))) {
      best = LeastTwistGamma{gamma, value.twist, value.one_sense};
    }
  };
  for (const double sign : {1.0, -1.0}) {
    PeriodicTurn tried = *turn;
    tried.gamma = sign;
    if (frame_detail::gamma_fault(tried)) continue;
    double before = 0.0;
    AbsoluteTwist::Value value_before;
    for (int i = 0; i <= grid; ++i) {
      const double gamma = sign * std::pow(most, 2.0 * i / static_cast<double>(grid) - 1.0);
      const auto value = twist.at(gamma);
      offer(gamma, value);
      if (i > 0) {
        double low = std::min(before, gamma), high = std::max(before, gamma);
        const double slope_low = before < gamma ? value_before.slope : value.slope;
        const double slope_high = before < gamma ? value.slope : value_before.slope;
        if (slope_low < 0.0 && slope_high > 0.0) {
          // The slope goes from negative to positive: bisection to rounding.
          constexpr int halvings = 60;
          for (int j = 0; j < halvings; ++j) {
            const double half = 0.5 * (low + high);
            if (!(low < half && half < high)) break;
            (twist.at(half).slope < 0.0 ? low : high) = half;
          }
          offer(low, twist.at(low));
        }
      }
      before = gamma;
      value_before = value;
    }
  }
  return *best;
}

}  // namespace hodograph
