// SPDX-License-Identifier: MIT
#include "hodograph/planning/corner_sizes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "hodograph/foundation/accuracy.hpp"

namespace hodograph {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

Fault fault_at(FaultCode code, std::size_t index, const char* quantity, double value,
               std::optional<double> bound, std::string sentence) {
  return {code, std::move(sentence), index, quantity, value, bound};
}

std::optional<Fault> number_fault(double value, std::size_t index, const char* quantity) {
  if (std::isfinite(value) && value >= 0.0) return std::nullopt;
  return fault_at(FaultCode::outside_domain, index, quantity, value, 0.0,
                  "the " + std::string(quantity) + " " + std::to_string(index) +
                      " must be a number and not negative; got " + to_text(value));
}

std::optional<Fault> room_fault(std::span<const double> lines,
                                std::span<const CornerRoom> corners) {
  if (lines.size() != corners.size() + 1) {
    return Fault{FaultCode::mismatched_size,
                 std::to_string(corners.size()) + " corners stand between " +
                     std::to_string(corners.size() + 1) + " lines; got " +
                     std::to_string(lines.size()),
                 std::nullopt,
                 "lines",
                 static_cast<double>(lines.size()),
                 static_cast<double>(corners.size() + 1)};
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    if (auto fault = number_fault(lines[k], k, "length of line")) return fault;
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const CornerRoom& c = corners[k];
    for (const auto& [value, name] :
         {std::pair(c.least, "least leg of corner"), std::pair(c.most, "most leg of corner"),
          std::pair(c.saving, "saving of corner"), std::pair(c.peak_curvature, "peak of corner")}) {
      if (auto fault = number_fault(value, k, name)) return fault;
    }
    if (!(c.least <= c.most)) {
      return fault_at(FaultCode::no_interpolant, k, "leg", c.least, c.most,
                      "corner " + std::to_string(k) + " needs a leg of " + to_text(c.least) +
                          "; at most " + to_text(c.most) + " is allowed");
    }
  }
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const double needed =
        (k > 0 ? corners[k - 1].least : 0.0) + (k < corners.size() ? corners[k].least : 0.0);
    if (needed <= lines[k] * (1.0 + 2.0 * epsilon<double>())) continue;
    return fault_at(FaultCode::no_interpolant, k, "line", needed, lines[k],
                    "the corners at the ends of line " + std::to_string(k) + " need " +
                        to_text(needed) + " of it; it is " + to_text(lines[k]) + " long");
  }
  return std::nullopt;
}

/// Corner k may not use more than its neighbours' least legs leave.
std::vector<double> most_legs(std::span<const double> lines, std::span<const CornerRoom> corners) {
  std::vector<double> most(corners.size());
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double before = lines[k] - (k > 0 ? corners[k - 1].least : 0.0);
    const double after = lines[k + 1] - (k + 1 < corners.size() ? corners[k + 1].least : 0.0);
    most[k] = std::max(corners[k].least, std::min({corners[k].most, before, after}));
  }
  return most;
}

std::vector<double> smallest(std::span<const CornerRoom> corners) {
  std::vector<double> legs;
  for (const CornerRoom& c : corners) legs.push_back(c.least);
  return legs;
}

/// Raises all legs together; a step a full line or a corner at its most.
std::vector<double> largest(std::span<const double> lines, std::span<const CornerRoom> corners) {
  const std::size_t count = corners.size();
  std::vector<double> legs = smallest(corners);
  std::vector<double> rise(count);  // a unit of t; 0 where the corner stays
  for (std::size_t k = 0; k < count; ++k) rise[k] = corners[k].most - corners[k].least;
  const auto leg = [&](std::size_t k) { return k < count ? legs[k] : 0.0; };
  const auto rise_of = [&](std::size_t k) { return k < count ? rise[k] : 0.0; };
  // Line k lies between corners k - 1 and k; an unsigned -1 is no corner.
  double t = 0.0;
  for (;;) {
    double step = 1.0 - t;
    for (std::size_t k = 0; k <= count; ++k) {
      const double speed = rise_of(k - 1) + rise_of(k);
      if (speed > 0.0) step = std::min(step, (lines[k] - leg(k - 1) - leg(k)) / speed);
    }
    step = std::max(step, 0.0);
    t += step;
    std::vector<bool> stays(count, t >= 1.0);
    for (std::size_t k = 0; k <= count; ++k) {
      const double speed = rise_of(k - 1) + rise_of(k);
      if (!(speed > 0.0) || (lines[k] - leg(k - 1) - leg(k)) / speed > step) continue;
      if (k > 0) stays[k - 1] = true;
      if (k < count) stays[k] = true;
    }
    bool any = false;
    for (std::size_t k = 0; k < count; ++k) {
      legs[k] = std::min(corners[k].most, legs[k] + step * rise[k]);
      if (stays[k]) rise[k] = 0.0;
      any = any || rise[k] > 0.0;
    }
    if (!any) return legs;
  }
}

/// A concave function of x ≥ from, increasing up to where it is constant: its pieces by their
/// lengths, with falling positive slopes.
struct ConcaveGain {
  struct Piece {
    double length, slope;
  };
  double from = 0.0;
  std::vector<Piece> pieces{};
};

/// x is best along `pieces` up to `room`.
std::vector<double> least_length(std::span<const double> lines,
                                 std::span<const CornerRoom> corners) {
  const std::size_t count = corners.size();
  const std::vector<double> most = most_legs(lines, corners);
  // gain[k]: the most that corners k, k + 1, ... save, by the room that line k leaves to corner k.
  // Corner k takes x and leaves lines[k + 1] - x to the next.
  std::vector<ConcaveGain> gain(count + 1);
  for (std::size_t k = count; k-- > 0;) {
    const ConcaveGain& next = gain[k + 1];
    ConcaveGain& here = gain[k];
    here.from = corners[k].least;
    // As x grows from 0, the room left falls from lines[k + 1]: first through the constant part of
    // `next`, then its pieces from the last to the first.
    double at = lines[k + 1] - next.from;
    for (const auto& piece : next.pieces) at -= piece.length;
    std::vector<ConcaveGain::Piece> reversed{{std::max(at, 0.0), corners[k].saving}};
    double skip = std::max(-at, 0.0);  // room that is not there
    for (std::size_t i = next.pieces.size(); i-- > 0;) {
      const double length = next.pieces[i].length - skip;
      skip = std::max(-length, 0.0);
      if (length > 0.0) reversed.push_back({length, corners[k].saving - next.pieces[i].slope});
    }
    double x = 0.0;
    for (const auto& piece : reversed) {
      const double begin = std::max(x, here.from), end = std::min(x + piece.length, most[k]);
      x += piece.length;
      if (end > begin && piece.slope > 0.0) here.pieces.push_back({end - begin, piece.slope});
    }
  }
  std::vector<double> legs(count);
  double room = count > 0 ? lines[0] : 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    double best = gain[k].from;
    for (const auto& piece : gain[k].pieces) best += piece.length;
    legs[k] = std::max(corners[k].least, std::min({best, room, most[k]}));
    room = lines[k + 1] - legs[k];
  }
  return legs;
}

std::vector<double> least_peak_curvature(std::span<const double> lines,
                                         std::span<const CornerRoom> corners) {
  const std::vector<double> most = most_legs(lines, corners);
  double peak = 0.0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    if (corners[k].peak_curvature > 0.0) {
      peak = std::max(peak, most[k] > 0.0 ? corners[k].peak_curvature / most[k] : unbounded);
    }
    if (k > 0) {
      const double both = corners[k - 1].peak_curvature + corners[k].peak_curvature;
      if (both > 0.0) peak = std::max(peak, lines[k] > 0.0 ? both / lines[k] : unbounded);
    }
  }
  std::vector<double> legs = smallest(corners);
  if (!(peak > 0.0)) return legs;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    legs[k] = std::max(legs[k], std::min(most[k], corners[k].peak_curvature / peak));
  }
  return legs;
}

}  // namespace

Result<std::vector<double>> corner_sizes(std::span<const double> lines,
                                         std::span<const CornerRoom> corners, CornerAim aim) {
  if (auto fault = room_fault(lines, corners)) return *std::move(fault);
  switch (aim) {
    case CornerAim::smallest:
      return smallest(corners);
    case CornerAim::largest:
      return largest(lines, corners);
    case CornerAim::least_length:
      return least_length(lines, corners);
    case CornerAim::least_peak_curvature:
      return least_peak_curvature(lines, corners);
  }
  return smallest(corners);
}

}  // namespace hodograph
