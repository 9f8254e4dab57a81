// SPDX-License-Identifier: MIT
// Building timing laws from speeds, and evaluating them both ways.
#include "hodograph/path/timing_law.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

#include "hodograph/foundation/accuracy.hpp"

namespace hodograph {
namespace {

constexpr double ulp = std::numeric_limits<double>::epsilon();
/// Speeds, lengths and accelerations of these sizes have squares, quotients and sums in range.
constexpr double smallest_size = 1e-100;  // not a tolerance: the smallest number accepted
constexpr double largest_size = 1e100;
constexpr double rounded_up = 1.0 + 8.0 * ulp;  // more than the roundings of a quotient of sums

Fault number_fault(FaultCode code, const char* quantity, double value, double bound,
                   std::string sentence) {
  return {code, std::move(sentence), std::nullopt, quantity, value, bound};
}

/// The fault of a number that should be positive (or not negative) and of a usable size.
std::optional<Fault> size_fault(const char* quantity, double value, bool may_be_zero = false) {
  if (may_be_zero && value == 0.0) return std::nullopt;
  if (smallest_size <= value && value <= largest_size) return std::nullopt;
  const std::string name(quantity);
  if (!std::isfinite(value)) {
    return number_fault(FaultCode::not_finite, quantity, value, 0.0,
                        "the " + name + " must be a finite number; got " + to_text(value));
  }
  const bool small = value < smallest_size;
  return number_fault(FaultCode::outside_domain, quantity, value,
                      small ? smallest_size : largest_size,
                      "the " + name + " must be " + (may_be_zero ? "zero or " : "") +
                          "positive, between 1e-100 and 1e100; got " + to_text(value));
}

std::optional<Fault> time_fault(double start) {
  if (std::isfinite(start)) return std::nullopt;
  return number_fault(FaultCode::not_finite, "start_time", start, 0.0,
                      "the start time must be a finite number; got " + to_text(start));
}

std::optional<Fault> limits_fault(double length, const TrapezoidalSpeed& limits, double start) {
  if (auto fault = size_fault("length", length)) return fault;
  if (auto fault = size_fault("cruise_speed", limits.cruise_speed)) return fault;
  if (auto fault = size_fault("acceleration", limits.acceleration)) return fault;
  if (auto fault = size_fault("deceleration", limits.deceleration)) return fault;
  if (auto fault = size_fault("start_speed", limits.start_speed, true)) return fault;
  if (auto fault = size_fault("end_speed", limits.end_speed, true)) return fault;
  return time_fault(start);
}

}  // namespace

/// Collects pieces.
class TimingLawBuilder {
 public:
  explicit TimingLawBuilder(double start) { law_.start_ = start; }

  /// From speed v to speed w while covering `distance` > 0; v + w > 0.
  void cover(double distance, double v, double w) {
    if (distance > 0.0) add(2.0 * (distance / (v + w)), distance, v, w);
  }
  /// A stop.
  void wait(double duration) { add(duration, 0.0, 0.0, 0.0); }
  /// A piece of a given duration.
  void add(double duration, double distance, double v, double w) {
    const double first = v + w > 0.0 ? distance * (v / (v + w)) : 0.0;
    const double second = v + w > 0.0 ? distance * (w / (v + w)) : 0.0;
    // A law covers its length monotonically: a rounded sum never exceeds it.
    const double from = std::min(law_.length_, limit_);
    law_.length_ += distance;
    add(TimingLaw::Piece{time_, duration, from, first, second});
  }
  /// A piece as it is.
  void add(const TimingLaw::Piece& piece) {
    law_.pieces_.push_back(piece);
    add_time(piece.duration);
    const double speed = 2.0 * (std::max(piece.first, piece.second) / piece.duration);
    law_.most_speed_ = std::max(law_.most_speed_, speed * rounded_up);
    law_.most_acceleration_ =
        std::max(law_.most_acceleration_, law_.acceleration_bound(law_.pieces_.size() - 1));
  }

  /// Fast from speed v to w below `most` over `distance`: a trapezoid or a triangle.
  void cover_fast(double distance, double v, double most, double w, double a, double d) {
    double top = std::max({most, v, w});
    double rise = 0.5 * ((top - v) * ((top + v) / a)), fall = 0.5 * ((top - w) * ((top + w) / d));
    if (rise + fall > distance) {
      // top² = (2adL + d v² + a w²)/(a + d), as weights of a and d.
      const double share = d / (a + d), other = a / (a + d);
      const double square = 2.0 * a * share * distance + share * (v * v) + other * (w * w);
      top = std::min(top, std::max({std::sqrt(square), v, w}));
      rise = std::min(distance, 0.5 * ((top - v) * ((top + v) / a)));
      if (top == w) rise = distance;  // never slower at the end
      if (top == v && top != w) rise = 0.0;
      fall = distance - rise;
    }
    cover(rise, v, top);
    cover(distance - rise - fall, top, top);
    cover(fall, top, w);
  }

  TimingLaw finish(double length) {
    law_.length_ = length;
    law_.duration_ = time_;
    return std::move(law_);
  }
  void limit(double length) { limit_ = length; }
  double length() const { return law_.length_; }
  double time() const { return time_; }
  bool is_usable() const { return std::isfinite(time_) && time_ > 0.0; }

 private:
  void add_time(double duration) {  // Neumaier's summation: one rounding in all
    const double next = time_sum_ + duration;
    compensation_ +=
        time_sum_ < duration ? (duration - next) + time_sum_ : (time_sum_ - next) + duration;
    time_sum_ = next;
    time_ = std::max(time_, time_sum_ + compensation_);
  }
  TimingLaw law_;
  double time_ = 0.0, time_sum_ = 0.0, compensation_ = 0.0;
  double limit_ = std::numeric_limits<double>::infinity();
};

// ---- builders
// ------------------------------------------------------------------------------------

Result<TimingLaw> TimingLaw::constant_speed(double length, double speed, double start) {
  if (auto fault = size_fault("length", length)) return *std::move(fault);
  if (auto fault = size_fault("speed", speed)) return *std::move(fault);
  if (auto fault = time_fault(start)) return *std::move(fault);
  TimingLawBuilder builder(start);
  builder.cover(length, speed, speed);
  return builder.finish(length);
}

Result<TimingLaw> TimingLaw::between(double length, double start, double arrival) {
  if (auto fault = size_fault("length", length)) return *std::move(fault);
  if (auto fault = time_fault(start)) return *std::move(fault);
  const double duration = arrival - start;
  if (!(duration > 0.0)) {
    return number_fault(std::isfinite(arrival) ? FaultCode::not_increasing : FaultCode::not_finite,
                        "arrival_time", arrival, start,
                        "the arrival time must be after the start at " + to_text(start) + "; got " +
                            to_text(arrival));
  }
  if (auto fault = size_fault("duration", duration)) return *std::move(fault);
  TimingLawBuilder builder(start);
  builder.add(duration, length, 1.0, 1.0);
  return builder.finish(length);
}

Result<TimingLaw> TimingLaw::trapezoidal(double length, const TrapezoidalSpeed& limits,
                                         double start) {
  if (auto fault = limits_fault(length, limits, start)) return *std::move(fault);
  const double v = limits.start_speed, w = limits.end_speed;
  const std::pair<const char*, double> ends[] = {{"start_speed", v}, {"end_speed", w}};
  for (const auto& [name, speed] : ends) {
    if (speed > limits.cruise_speed) {
      return number_fault(FaultCode::outside_domain, name, speed, limits.cruise_speed,
                          "the " + std::string(name) + " " + to_text(speed) +
                              " exceeds the cruise speed " + to_text(limits.cruise_speed));
    }
  }
  const bool faster = w > v;
  const double rate = faster ? limits.acceleration : limits.deceleration;
  const double change = std::abs((w - v) * (w + v));
  const double needed = 0.5 * (change / rate);
  if (needed > length * rounded_up) {
    const char* name = faster ? "acceleration" : "deceleration";
    const double would_do = 0.5 * (change / length);
    return number_fault(FaultCode::no_interpolant, name, rate, would_do,
                        "a change from speed " + to_text(v) + " to " + to_text(w) +
                            " takes a length of " + to_text(needed) + " with " + name + " " +
                            to_text(rate) + "; got " + to_text(length) + ", for which it takes " +
                            name + " " + to_text(would_do));
  }
  TimingLawBuilder builder(start);
  builder.limit(length);
  builder.cover_fast(length, v, limits.cruise_speed, w, limits.acceleration, limits.deceleration);
  return builder.finish(length);
}

Result<TimingLaw> TimingLaw::under_limits(std::span<const double> arc_lengths,
                                          std::span<const double> most_speeds,
                                          const TrapezoidalSpeed& limits, double start) {
  const std::size_t count = most_speeds.size();
  if (count == 0 || arc_lengths.size() != count + 1) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(count) + " speed limits need " + std::to_string(count + 1) +
                     " arc lengths; got " + std::to_string(arc_lengths.size()),
                 std::nullopt,
                 "arc_lengths",
                 static_cast<double>(arc_lengths.size()),
                 static_cast<double>(count + 1)};
  }
  const double length = arc_lengths.back();
  if (auto fault = limits_fault(length, limits, start)) return *std::move(fault);
  for (std::size_t i = 0; i < count; ++i) {
    const bool begins = i > 0 || arc_lengths[0] == 0.0;
    if (!begins || !(arc_lengths[i] < arc_lengths[i + 1])) {
      return Fault{FaultCode::not_increasing,
                   "the arc lengths of speed limits must increase from 0; stretch " +
                       std::to_string(i) + " runs from " + to_text(arc_lengths[i]) + " to " +
                       to_text(arc_lengths[i + 1]),
                   i,
                   "arc_lengths",
                   arc_lengths[i],
                   std::nullopt};
    }
    if (!(most_speeds[i] >= smallest_size)) {
      return Fault{FaultCode::no_interpolant,
                   "the speed limit between arc lengths " + to_text(arc_lengths[i]) + " and " +
                       to_text(arc_lengths[i + 1]) + " is " + to_text(most_speeds[i]) +
                       ": nothing gets through; it must be positive",
                   i,
                   "most_speed",
                   most_speeds[i],
                   0.0};
    }
  }
  const double a = limits.acceleration, d = limits.deceleration;
  const auto most = [&](std::size_t i) { return std::min(most_speeds[i], limits.cruise_speed); };
  // The largest v at every breakpoint: both neighbours' limits, then what can still be braked from,
  // then what can be reached.
  std::vector<double> v(count + 1);
  v[0] = most(0);
  v[count] = std::min(most(count - 1), limits.end_speed);
  for (std::size_t i = 1; i < count; ++i) v[i] = std::min(most(i - 1), most(i));
  const auto end_fault = [&](const char* name, double wanted, double possible) {
    return number_fault(FaultCode::no_interpolant, name, wanted, possible,
                        "the " + std::string(name) + " " + to_text(wanted) +
                            " is above what the limits allow there: at most " + to_text(possible));
  };
  if (limits.end_speed > v[count]) return end_fault("end_speed", limits.end_speed, v[count]);
  const auto after = [&](std::size_t i, double speed, double rate) {
    return std::sqrt(speed * speed + 2.0 * rate * (arc_lengths[i + 1] - arc_lengths[i]));
  };
  for (std::size_t i = count; i-- > 0;) v[i] = std::min(v[i], after(i, v[i + 1], d));
  if (limits.start_speed > v[0] * rounded_up) {
    return end_fault("start_speed", limits.start_speed, v[0]);
  }
  v[0] = std::min(v[0], limits.start_speed);
  for (std::size_t i = 0; i < count; ++i) v[i + 1] = std::min(v[i + 1], after(i, v[i], a));
  if (limits.end_speed > v[count] * rounded_up) {
    return end_fault("end_speed", limits.end_speed, v[count]);
  }
  TimingLawBuilder builder(start);
  builder.limit(length);
  for (std::size_t i = 0; i < count; ++i) {
    builder.cover_fast(arc_lengths[i + 1] - arc_lengths[i], v[i], most(i), v[i + 1], a, d);
  }
  return builder.finish(length);
}

Result<TimingLaw> TimingLaw::from_speeds(std::span<const double> durations,
                                         std::span<const double> speeds, double length,
                                         double start) {
  if (durations.empty() || speeds.size() != durations.size() + 1) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(durations.size()) + " durations (at least one) need " +
                     std::to_string(durations.size() + 1) + " speeds; got " +
                     std::to_string(speeds.size()),
                 std::nullopt,
                 "speeds",
                 static_cast<double>(speeds.size()),
                 static_cast<double>(durations.size() + 1)};
  }
  if (auto fault = size_fault("length", length)) return *std::move(fault);
  if (auto fault = time_fault(start)) return *std::move(fault);
  for (std::size_t i = 0; i < speeds.size(); ++i) {
    auto fault = size_fault("speed", speeds[i], true);
    if (!fault && i < durations.size()) fault = size_fault("duration", durations[i]);
    if (fault) {
      fault->index = i;
      return *std::move(fault);
    }
  }
  TimingLawBuilder builder(start);
  builder.limit(length);
  for (std::size_t i = 0; i < durations.size(); ++i) {
    const double mean = 0.5 * (speeds[i] + speeds[i + 1]);
    builder.add(durations[i], mean * durations[i], speeds[i], speeds[i + 1]);
  }
  const double covered = builder.length();
  const double allowed =
      accuracy::join_error<double>() * static_cast<double>(durations.size()) * length;
  if (!(std::abs(covered - length) <= allowed)) {
    return number_fault(
        FaultCode::outside_domain, "length", covered, length,
        "the speeds cover a length of " + to_text(covered) + ", not the path's " + to_text(length));
  }
  return builder.finish(length);
}

Result<TimingLaw> TimingLaw::from_pieces(std::span<const Piece> pieces, double length,
                                         double start) {
  if (auto fault = size_fault("length", length)) return *std::move(fault);
  if (auto fault = time_fault(start)) return *std::move(fault);
  if (pieces.empty()) {
    return number_fault(FaultCode::too_few, "pieces", 0.0, 1.0,
                        "a timing law has at least one piece; got none");
  }
  TimingLawBuilder builder(start);
  const double allowed =
      accuracy::join_error<double>() * static_cast<double>(pieces.size()) * length;
  double end = 0.0;  // of the arc length so far
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Piece& piece = pieces[i];
    auto fault = size_fault("duration", piece.duration);
    for (const double distance : {piece.first, piece.second}) {
      if (!fault && !(distance >= 0.0 && distance <= largest_size)) {
        fault = number_fault(FaultCode::outside_domain, "piece", distance, 0.0,
                             "piece " + std::to_string(i) +
                                 " should cover distances that are not negative; got " +
                                 to_text(distance));
      }
    }
    if (!fault && !(piece.begin == builder.time() && piece.arc_length >= 0.0 &&
                    piece.arc_length <= length && std::abs(piece.arc_length - end) <= allowed)) {
      fault = number_fault(FaultCode::outside_domain, "piece", piece.begin, builder.time(),
                           "piece " + std::to_string(i) + " should begin at time " +
                               to_text(builder.time()) + " and arc length " + to_text(end) +
                               "; it begins at " + to_text(piece.begin) + " and " +
                               to_text(piece.arc_length));
    }
    if (fault) {
      fault->index = i;
      return *std::move(fault);
    }
    builder.add(piece);
    end = piece.arc_length + (piece.first + piece.second);
  }
  if (!(std::abs(end - length) <= allowed)) {
    return number_fault(
        FaultCode::outside_domain, "length", end, length,
        "the pieces cover a length of " + to_text(end) + ", not " + to_text(length));
  }
  return builder.finish(length);
}

// ---- evaluation
// ----------------------------------------------------------------------------------

namespace {

void require_inside(double x, double low, double high, const char* quantity) {
  if (low <= x && x <= high) return;
  throw Error(Fault{FaultCode::outside_domain,
                    std::string(quantity) + " " + to_text(x) + " is outside [" + to_text(low) +
                        ", " + to_text(high) + "]",
                    std::nullopt, quantity, x, x < low ? low : high});
}

}  // namespace

std::size_t TimingLaw::piece_at(double local_time) const {
  if (pieces_.size() == 1) return 0;
  const auto after =
      std::upper_bound(pieces_.begin() + 1, pieces_.end(), local_time,
                       [](double time, const Piece& piece) { return time < piece.begin; });
  return static_cast<std::size_t>(after - pieces_.begin()) - 1;
}

double TimingLaw::arc_length_within(std::size_t index, double local_time) const {
  const Piece& piece = pieces_[index];
  const double most = index + 1 < pieces_.size() ? pieces_[index + 1].arc_length : length_;
  const double u = (local_time - piece.begin) / piece.duration;
  if (!(u > 0.0)) return piece.arc_length;
  if (u >= 1.0) return most;
  const double both = piece.first + piece.second;
  const double covered = u * (2.0 * (1.0 - u) * piece.first + u * both);
  return std::min(piece.arc_length + covered, most);
}

double TimingLaw::acceleration_bound(std::size_t index) const {
  const Piece& piece = pieces_[index];
  // The difference is exact or rounded once; p and q themselves carry four roundings.
  const double change =
      std::abs(piece.second - piece.first) + 4.0 * ulp * (piece.first + piece.second);
  return rounded_up * 2.0 * ((change / piece.duration) / piece.duration);
}

double TimingLaw::arc_length_at(double t) const {
  require_inside(t, start_time(), end_time(), "time");
  const double local = t - start_;
  if (t == end_time()) return length_;
  return arc_length_within(piece_at(local), local);
}

double TimingLaw::speed_at(double t) const {
  require_inside(t, start_time(), end_time(), "time");
  const double local = t - start_;
  const Piece& piece = pieces_[piece_at(local)];
  const double u = std::min(1.0, (local - piece.begin) / piece.duration);
  return 2.0 * (piece.first * (1.0 - u) + piece.second * u) / piece.duration;
}

double TimingLaw::time_at(double s) const {
  require_inside(s, 0.0, length_, "arc length");
  if (s == 0.0) return start_;
  // The last piece that begins before s: the first time at which s is covered lies there.
  const auto after = std::lower_bound(
      pieces_.begin() + 1, pieces_.end(), s,
      [](const Piece& piece, double arc_length) { return piece.arc_length < arc_length; });
  const Piece& piece = *(after - 1);
  const double p = piece.first, q = piece.second;
  const double x = std::min(s - piece.arc_length, p + q);
  const double square = q >= p ? p * p + x * (q - p) : q * q + ((p + q) - x) * (p - q);
  const double divisor = p + std::sqrt(square);
  const double u = divisor > 0.0 ? std::min(1.0, x / divisor) : 0.0;
  const double local = std::min(piece.begin + u * piece.duration, duration_);
  return std::min(start_ + local, end_time());
}

double TimingLaw::arc_length_error() const {
  return ulp * (8.0 * length_ + 4.0 * (duration_ * most_speed_));
}

TimingLaw TimingLaw::delayed(double delay) const {
  TimingLaw result = *this;
  result.start_ += delay;
  return result;
}

}  // namespace hodograph
