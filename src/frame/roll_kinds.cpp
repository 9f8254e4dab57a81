// SPDX-License-Identifier: MIT
// Rotation-minimising, Frenet and least-twist rolls.
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "roll_builder.hpp"
#include "roll_chain.hpp"

namespace hodograph {

using frame_detail::Fraction;
using frame_detail::knot_turn;
using frame_detail::Row;
using frame_detail::scaled_preimage;

namespace frame_detail {

bool stands_still(const Quaternion<double>& a) { return !(largest_component(a) > 0.0); }

Result<std::vector<KnotTurn>> knot_turns(const PreimageTable& path) {
  std::vector<KnotTurn> turns;
  Row<Quaternion<double>> before = scaled_preimage(path, 0).a, first = before;
  const std::size_t count = path.segment_count();
  const auto meet = [&](const Row<Quaternion<double>>& after, std::size_t knot,
                        const char* what) -> std::optional<Fault> {
    if (stands_still(before.back()) || stands_still(after.front())) {
      return Fault{
          FaultCode::zero_speed,
          "the path stands still at knot " + std::to_string(knot) + ": no frame exists there",
          knot,
          "speed",
          0.0,
          std::nullopt};
    }
    const KnotTurn turn = knot_turn(before, after);
    if (turn.breaks) {
      return Fault{FaultCode::not_continuous,
                   std::string(what) + " at an angle of " + to_text(turn.angle) + " rad; at most " +
                       to_text(turn.allowed) + " is rounding",
                   knot,
                   "tangent",
                   turn.angle,
                   turn.allowed};
    }
    turns.push_back(turn);
    return std::nullopt;
  };
  for (std::size_t k = 1; k < count; ++k) {
    auto after = scaled_preimage(path, k).a;
    const std::string what = "the segments meet at knot " + std::to_string(k);
    if (auto fault = meet(after, k, what.c_str())) return *std::move(fault);
    before = std::move(after);
  }
  if (path.closed) {
    if (auto fault = meet(first, 0, "the end of the closed path meets its start")) {
      return *std::move(fault);
    }
  }
  return turns;
}

Result<FrameRoll> chained_roll(const PreimageTable& path, RollKind kind, double begin,
                               const std::vector<KnotTurn>& turns, const EvenRate& even,
                               RollIntegration integration, double tolerance) {
  const double share = tolerance / static_cast<double>(path.segment_count());
  RollBuilder builder(path, kind);
  const ErfForms<double> forms(path.degree);
  double theta = begin;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const ScaledPreimage preimage = scaled_preimage(path, k);
    if (k > 0) theta = builder.end() + turns[k - 1].roll;
    Fraction<double> erf = forms.rate(preimage.a);
    RollBuilder::SegmentRoll segment;
    segment.tolerance = share;
    if (!even) {
      if (auto helical = helical_part(preimage.a)) {
        segment.argument = std::move(helical->w);
        segment.factor = -helical->factor;
      } else if (integration == RollIntegration::closed_form) {
        const auto closed = integral_by_partial_fractions(erf.numerator, erf.denominator);
        if (closed && closed->error <= closed_form_error * (1.0 + std::abs(closed->value))) {
          segment.change = Estimated{-closed->value, closed->error};
        }
      }
    }
    segment.rate.numerator = scaled(-1.0, std::move(erf.numerator));
    if (even) {
      segment.rate.numerator =
          sum(segment.rate.numerator,
              scaled(even(k, preimage), product(erf.denominator, erf.denominator)));
    }
    segment.rate.denominator = std::move(erf.denominator);
    if (!builder.append(std::move(segment), theta)) {
      return RollBuilder::zero_speed(k, "the frame may turn by any angle");
    }
  }
  return std::move(builder).finish();
}

std::optional<Fault> angle_fault(double angle, const char* quantity) {
  if (std::isfinite(angle)) return std::nullopt;
  return Fault{FaultCode::not_finite,
               "the roll to " + std::string(quantity) + " with is not a finite number",
               std::nullopt,
               quantity,
               angle,
               std::nullopt};
}

}  // namespace frame_detail

Result<FrameRoll> rotation_minimising_roll(const PreimageTable& path, double begin,
                                           RollIntegration integration) {
  if (auto fault = frame_detail::angle_fault(begin, "begin")) return *std::move(fault);
  const auto turns = frame_detail::knot_turns(path);
  if (!turns) return turns.fault();
  return frame_detail::chained_roll(path, RollKind::rotation_minimising, begin, *turns, {},
                                    integration);
}

Result<FrameRoll> rotation_minimising_roll_within(const PreimageTable& path, double accuracy,
                                                  double begin) {
  if (!(accuracy > 0.0)) {
    return Fault{FaultCode::outside_domain,
                 "the accuracy must be positive, in radians; got " + to_text(accuracy),
                 std::nullopt,
                 "accuracy",
                 accuracy,
                 0.0};
  }
  if (auto fault = frame_detail::angle_fault(begin, "begin")) return *std::move(fault);
  const auto turns = frame_detail::knot_turns(path);
  if (!turns) return turns.fault();
  constexpr double share = 0.5;  // the other half for rounding
  auto roll = frame_detail::chained_roll(path, RollKind::rotation_minimising, begin, *turns, {},
                                         RollIntegration::series, share * accuracy);
  if (roll && !(roll->error_bound() <= accuracy)) {
    return Fault{FaultCode::tolerance_not_reached,
                 "the roll is known within " + to_text(roll->error_bound()) +
                     " rad, no better than rounding allows; got the accuracy " + to_text(accuracy),
                 std::nullopt,
                 "accuracy",
                 accuracy,
                 roll->error_bound()};
  }
  return roll;
}

Result<FrameRoll> least_twist_roll(const PreimageTable& path, double begin,
                                   std::optional<double> end) {
  if (auto fault = frame_detail::angle_fault(begin, "begin")) return *std::move(fault);
  if (end) {
    if (auto fault = frame_detail::angle_fault(*end, "end")) return *std::move(fault);
    if (path.closed) {
      return Fault{FaultCode::unsupported,
                   "the frame of a closed path ends as it begins; a roll at the end is for open "
                   "paths",
                   std::nullopt,
                   "end",
                   *end,
                   std::nullopt};
    }
  }
  const auto turns = frame_detail::knot_turns(path);
  if (!turns) return turns.fault();
  auto minimising = frame_detail::chained_roll(path, RollKind::least_twist, begin, *turns, {},
                                               RollIntegration::series);
  if (!minimising || (!end && !path.closed)) return minimising;
  const double last = minimising->angle_at_end(path.segment_count() - 1);
  // On a closed path: by how much the frame has turned when it comes back.
  const double left_over = std::remainder(
      path.closed ? turns->back().roll + (last - begin) : last - *end, 2.0 * std::numbers::pi);

  // Lengths against the largest size of a preimage, so that their sum is in range.
  int exponent = 0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const int here = scaled_preimage(path, k).exponent;
    exponent = k == 0 ? here : std::max(exponent, here);
  }
  const auto unit = [&](const frame_detail::ScaledPreimage& preimage, std::size_t k) {
    return std::ldexp(path.step(k), 2 * (preimage.exponent - exponent));
  };
  double length = 0.0;
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto preimage = scaled_preimage(path, k);
    const Row<double> speed = frame_detail::erf_rate(preimage.a).denominator;
    double mean = 0.0;
    for (const double c : speed) mean += c / static_cast<double>(speed.size());
    length += mean * unit(preimage, k);
  }
  const double even = -left_over / length;
  auto result = frame_detail::chained_roll(
      path, RollKind::least_twist, begin, *turns,
      [&](std::size_t k, const frame_detail::ScaledPreimage& preimage) {
        return even * unit(preimage, k);
      },
      RollIntegration::series);
  if (!result) return result;
  RollBuilder::set_twist_rate(*result, std::ldexp(even, -2 * exponent));
  return result;
}

Result<FrameRoll> frenet_roll(const PreimageTable& path) {
  RollBuilder builder(path, RollKind::frenet);
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto preimage = scaled_preimage(path, k);
    auto normal = frame_detail::normal_direction(preimage.a);
    if (normal.c.empty()) {
      return Fault{FaultCode::outside_domain,
                   "segment " + std::to_string(k) +
                       " is straight within rounding: it has no principal normal; a "
                       "rotation-minimising frame exists there",
                   k,
                   "curvature",
                   0.0,
                   std::nullopt};
    }
    RollBuilder::SegmentRoll segment;
    segment.rate = frame_detail::argument_rate(normal.c, 1.0);
    segment.factor = 1.0;
    const Complex<double> first = normal.c.front();
    const double begin = std::atan2(first.im, first.re) +
                         std::numbers::pi * static_cast<double>(normal.flips.size());
    for (std::size_t i = 0; i < normal.flips.size(); ++i) {
      builder.inflections().push_back(
          {path.knots[k] + normal.flips[i] * path.step(k), normal.roundings[i] * path.step(k)});
    }
    segment.argument = std::move(normal.c);
    segment.flips = std::move(normal.flips);
    if (!builder.append(std::move(segment), begin)) {
      return RollBuilder::zero_speed(k, "the principal normal may turn by any angle");
    }
  }
  return std::move(builder).finish();
}

}  // namespace hodograph
