// SPDX-License-Identifier: MIT
#include "hodograph/frame/roll.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "roll_builder.hpp"

namespace hodograph {

using frame_detail::Fraction;
using frame_detail::RateSeries;
using frame_detail::Row;

static_assert(FrameRoll::piece_degree == frame_detail::series_degree + 1);

// ---- queries
// -------------------------------------------------------------------------------------

std::size_t FrameRoll::locate(double xi, double& u) const {
  if (!(knots_.front() <= xi && xi <= knots_.back())) {
    throw Error(Fault{FaultCode::outside_domain,
                      "path parameter xi " + to_text(xi) + " is outside [" +
                          to_text(knots_.front()) + ", " + to_text(knots_.back()) + "]",
                      std::nullopt, "path parameter xi", xi,
                      xi < knots_.front() ? knots_.front() : knots_.back()});
  }
  const std::size_t k = index_.find(knots_, xi);
  u = (xi - knots_[k]) / (knots_[k + 1] - knots_[k]);
  return k;
}

double FrameRoll::angle(std::size_t segment, double u) const {
  const Segment& s = segments_[segment];
  if (u == 0.0) return s.begin;
  if (u == 1.0) return s.end;
  if (s.first_piece == s.last_piece) return s.begin + u * (s.end - s.begin);
  const auto first = pieces_.begin() + static_cast<std::ptrdiff_t>(s.first_piece);
  const auto last = pieces_.begin() + static_cast<std::ptrdiff_t>(s.last_piece);
  const auto after = std::upper_bound(
      first + 1, last, u, [](double at, const Piece& piece) { return at < piece.begin; });
  const Piece& piece = *(after - 1);
  const double x = (u - piece.center) * piece.scale;
  double delta = 0.0;
  for (std::size_t k = piece_degree; k-- > 0;) delta = (delta + piece.coefficient[k]) * x;
  return piece.middle + delta;
}

double FrameRoll::angle(double xi) const {
  double u = 0.0;
  const std::size_t k = locate(xi, u);
  return angle(k, u);
}

void FrameRoll::derivatives(double xi, std::span<double> result) const {
  double u = 0.0;
  const std::size_t k = locate(xi, u);
  result[0] = angle(k, u);
  if (result.size() < 2) return;
  constexpr std::size_t most = 4;
  const std::size_t count = result.size() - 1;
  assert(count <= most);
  const Segment& s = segments_[k];
  std::array<double, most> p{}, q{};
  frame_detail::jet(s.numerator, u, std::span<double>(p).first(count));
  frame_detail::jet(s.denominator, u, std::span<double>(q).first(count));
  // (P/Q)^(r) = (P^(r) - Σ_j C(r,j) Q^(r-j) (P/Q)^(j))/Q, then the chain rule.
  double unit = 1.0 / (knots_[k + 1] - knots_[k]);
  const double step = unit;
  std::array<double, most> rate{};
  for (std::size_t r = 0; r < count; ++r) {
    double total = p[r];
    for (std::size_t j = 0; j < r; ++j) {
      total -= static_cast<double>(binomial(r, j)) * q[r - j] * rate[j];
    }
    rate[r] = total / q[0];
    result[r + 1] = rate[r] * unit;
    unit *= step;
  }
}

// ---- construction
// --------------------------------------------------------------------------------

RollBuilder::RollBuilder(const PreimageTable& path, RollKind kind) {
  roll_.kind_ = kind;
  roll_.knots_ = path.knots;
  roll_.index_ = IntervalIndex<double>(path.knots);
  roll_.segments_.reserve(path.segment_count());
}

void RollBuilder::append_linear(double begin, double end) {
  FrameRoll::Segment segment;
  segment.first_piece = segment.last_piece = roll_.pieces_.size();
  segment.begin = begin;
  segment.end = end;
  segment.numerator = {end - begin};
  segment.denominator = {1.0};
  largest_angle_ = std::max({largest_angle_, std::abs(begin), std::abs(end)});
  roll_.segments_.push_back(std::move(segment));
}

namespace {

constexpr std::size_t size = FrameRoll::piece_degree + 1;

/// The power coefficients of T_k, even ones apart from odd ones: at [k/2][i] that of x^(2i) for
/// even k, of x^(2i+1) for odd k.
struct ChebyshevPowers {
  static constexpr std::size_t half = (size + 1) / 2;
  using Table = std::array<std::array<double, half>, half>;
  Table even{}, odd{};
  ChebyshevPowers() {
    std::array<std::array<double, size>, size> row{};
    row[0][0] = 1.0;
    row[1][1] = 1.0;
    for (std::size_t k = 2; k < size; ++k) {
      for (std::size_t i = 0; i < size; ++i) {
        row[k][i] = (i > 0 ? 2.0 * row[k - 1][i - 1] : 0.0) - row[k - 2][i];
      }
    }
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t i = k % 2; i <= k; i += 2)
        (k % 2 == 0 ? even : odd)[k / 2][i / 2] = row[k][i];
    }
  }
};

/// The antiderivative of a series by u as a polynomial in x, 0 at x = 0.
std::array<double, size> antiderivative(const RateSeries& rate) {
  static const ChebyshevPowers powers;
  constexpr std::size_t half = ChebyshevPowers::half;
  // ∫ T_k = T_(k+1)/(2(k+1)) - T_(k-1)/(2(k-1)), ∫ T_0 = T_1, ∫ T_1 = T_2/4.
  std::array<double, size + 2> c{};
  for (std::size_t k = 0; k < rate.c.size(); ++k) c[k] = rate.c[k];
  const double scale = 0.5 * (rate.end - rate.begin);
  std::array<double, half> even{}, odd{};
  for (std::size_t k = size; k-- > 1;) {
    const double t = k == 1 ? scale * (c[0] - 0.5 * c[2])
                            : scale * (c[k - 1] - c[k + 1]) / (2.0 * static_cast<double>(k));
    auto& sum = k % 2 == 0 ? even : odd;
    const auto& row = (k % 2 == 0 ? powers.even : powers.odd)[k / 2];
    for (std::size_t i = 0; i < half; ++i) sum[i] += t * row[i];
  }
  std::array<double, size> power{};
  for (std::size_t k = 1; k < size; ++k) power[k] = (k % 2 == 0 ? even : odd)[k / 2];
  return power;
}

double polynomial(const std::array<double, size>& power, double x) {
  double value = 0.0;
  for (std::size_t k = size; k-- > 1;) value = (value + power[k]) * x;
  return value;
}

}  // namespace

bool RollBuilder::append(SegmentRoll segment, double begin) {
  constexpr double most_turn = std::numbers::pi / 4.0;
  const bool by_argument = !segment.argument.empty();
  const auto argument_at = [&](double u) {
    const Complex<double> w = frame_detail::value(segment.argument, u);
    return std::atan2(w.im, w.re);
  };
  // The error of an argument: that of w evaluated, over |w|, and the rounding of atan2.
  double largest = 0.0;
  for (const auto& w : segment.argument) largest = std::max(largest, std::hypot(w.re, w.im));
  const auto argument_error = [&](double u) {
    const Complex<double> w = frame_detail::value(segment.argument, u);
    const double roundings = 4.0 + 3.0 * static_cast<double>(segment.argument.size());
    return std::abs(segment.factor) * roundings * epsilon<double>() *
           (1.0 + largest / std::hypot(w.re, w.im));
  };

  FrameRoll::Segment result;
  result.first_piece = roll_.pieces_.size();
  result.begin = begin;
  double theta = begin, offset = 0.0, internal = 0.0, sharpest = 0.0;
  if (by_argument) offset = begin - segment.factor * argument_at(0.0);
  // θ by the argument that is nearest to what the series say.
  const auto settled = [&](double u, double by_series) {
    if (segment.factor == 0.0) return by_series;
    const double principal = argument_at(u);
    const double turns =
        std::round(((by_series - offset) / segment.factor - principal) / (2.0 * std::numbers::pi));
    return segment.factor * (principal + 2.0 * std::numbers::pi * turns) + offset;
  };

  double low = 0.0;
  segment.flips.push_back(1.0);
  for (const double high : segment.flips) {
    const Fraction<double> part{frame_detail::restricted(segment.rate.numerator, low, high),
                                frame_detail::restricted(segment.rate.denominator, low, high)};
    const double length = high - low;
    if (!(length > 0.0)) continue;
    const bool done = frame_detail::expand(
        part,
        [&](const RateSeries& rate) {
          RateSeries local = rate;
          local.begin = low + length * rate.begin;
          local.end = rate.end == 1.0 ? high : low + length * rate.end;
          // The series is by u of the part: a rate a unit of it.
          for (double& c : local.c) c /= length;
          const auto power = antiderivative(local);
          double turn = 0.0;
          for (const double c : power) turn += std::abs(c);
          if (!(turn <= most_turn)) return false;
          FrameRoll::Piece piece;
          piece.begin = local.begin;
          piece.center = 0.5 * (local.begin + local.end);
          piece.scale = 2.0 / (local.end - local.begin);
          std::copy(power.begin() + 1, power.end(), piece.coefficient.begin());
          piece.middle = theta - polynomial(power, -1.0);
          const double error = (rate.end - rate.begin) * rate.error;
          if (by_argument) {
            piece.middle = settled(piece.center, piece.middle);
            sharpest = std::max(sharpest, 0.5 * error + argument_error(piece.center));
          }
          theta = piece.middle + polynomial(power, 1.0);
          internal += error + 2.0 * epsilon<double>() * std::abs(theta);
          largest_angle_ = std::max(largest_angle_, std::abs(theta));
          roll_.pieces_.push_back(piece);
          return true;
        },
        segment.tolerance);
    if (!done) return false;
    if (by_argument) theta = settled(high, theta);
    if (high < 1.0) {
      theta -= std::numbers::pi;
      offset -= std::numbers::pi;
    }
    low = high;
  }

  result.last_piece = roll_.pieces_.size();
  result.end = theta;
  result.method = RollMethod::quadrature;
  if (by_argument) {
    result.method = RollMethod::argument;
    roll_.error_bound_ =
        std::max(roll_.error_bound_, accumulated_ + sharpest + argument_error(0.0));
    accumulated_ += argument_error(0.0) + argument_error(1.0);
  } else {
    roll_.error_bound_ = std::max(roll_.error_bound_, accumulated_ + internal);
    if (segment.change) {
      result.method = RollMethod::partial_fractions;
      result.end = begin + segment.change->value;
      internal = segment.change->error + epsilon<double>() * std::abs(result.end);
    }
    accumulated_ += internal;
  }
  result.numerator = std::move(segment.rate.numerator);
  result.denominator = std::move(segment.rate.denominator);
  roll_.segments_.push_back(std::move(result));
  return true;
}

FrameRoll RollBuilder::finish() && {
  // A query adds the rounding of x, whose effect is at most |θ'| over the piece, of the polynomial,
  // and of its sum with the middle.
  constexpr double roundings = 4.0 * static_cast<double>(FrameRoll::piece_degree);
  roll_.error_bound_ += epsilon<double>() * (roll_.pieces_.empty() ? 0.0 : roundings) +
                        2.0 * epsilon<double>() * largest_angle_;
  return std::move(roll_);
}

Fault RollBuilder::zero_speed(std::size_t segment, const char* what) {
  return {FaultCode::zero_speed,
          "the speed of segment " + std::to_string(segment) +
              " comes to zero within rounding, where " + what + "; it needs a regular path",
          segment,
          "speed",
          0.0,
          std::nullopt};
}

FrameRoll FrameRoll::linear(const PreimageTable& path, double begin, double rate) {
  const bool turns = rate != 0.0 || begin != 0.0;
  RollBuilder builder(path, turns ? RollKind::linear : RollKind::none);
  const double first = path.knots.front();
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    builder.append_linear(begin + rate * (path.knots[k] - first),
                          begin + rate * (path.knots[k + 1] - first));
  }
  builder.linear_rate() = rate;
  return std::move(builder).finish();
}

}  // namespace hodograph
