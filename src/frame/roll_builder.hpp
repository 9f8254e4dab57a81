// SPDX-License-Identifier: MIT
// Builds a roll segment by segment from the rate dθ/du and from what is known in closed form.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "hodograph/frame/roll.hpp"
#include "roll_integral.hpp"
#include "segment_rates.hpp"

namespace hodograph {

class RollBuilder {
 public:
  /// What is known of one segment.
  struct SegmentRoll {
    frame_detail::Fraction<double> rate;
    /// Where not empty: θ = factor · arg(argument) + const, with the continuous argument.
    frame_detail::Row<Complex<double>> argument{};
    double factor = 0.0;
    /// The change of θ over the segment, where it is known in closed form otherwise.
    std::optional<frame_detail::Estimated> change{};
    /// u where θ jumps by -π, ascending in (0, 1).
    std::vector<double> flips{};
    /// How far the series may be off over the segment, radians; 0: rounding.
    double tolerance = 0.0;
  };

  RollBuilder(const PreimageTable& path, RollKind kind);

  /// Appends a segment that starts with θ = begin. False where |Q| may vanish.
  bool append(SegmentRoll segment, double begin);
  /// Appends a segment where θ is linear.
  void append_linear(double begin, double end);
  /// θ at the end of what has been appended.
  double end() const { return roll_.segments_.back().end; }
  FrameRoll finish() &&;

  static Fault zero_speed(std::size_t segment, const char* what);
  static void set_twist_rate(FrameRoll& roll, double rate) { roll.twist_rate_ = rate; }

  double& gamma() { return roll_.gamma_; }
  double& psi() { return roll_.psi_; }
  double& linear_rate() { return roll_.linear_rate_; }
  std::vector<FrenetInflection>& inflections() { return roll_.inflections_; }

 private:
  FrameRoll roll_;
  double accumulated_ = 0.0;  ///< error at the last knot
  double largest_angle_ = 0.0;
};

}  // namespace hodograph
