// SPDX-License-Identifier: MIT
#include "hodograph/frame/minimising_frames.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>

#include "hodograph/foundation/accuracy.hpp"
#include "hodograph/frame/roll.hpp"
#include "hodograph/frame/rolled_frames.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"
#include "minimising_group.hpp"
#include "roll_chain.hpp"

namespace hodograph {

namespace frame_detail {

#define HODOGRAPH_DECLARE_KERNEL(isa)                                                 \
  namespace isa {                                                                     \
  const MinimisingKernels* minimising_kernels(std::size_t degree, std::size_t nodes); \
  }
HODOGRAPH_DECLARE_KERNEL(baseline)
#if defined(HODOGRAPH_X86_KERNELS)
HODOGRAPH_DECLARE_KERNEL(avx2)
HODOGRAPH_DECLARE_KERNEL(avx512)
#endif
#undef HODOGRAPH_DECLARE_KERNEL

namespace {

using FindKernels = const MinimisingKernels* (*)(std::size_t degree, std::size_t nodes);

FindKernels choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  const std::string_view isa = batch_detail::kernel_instruction_set();
  if (isa == "avx512") return avx512::minimising_kernels;
  if (isa == "avx2") return avx2::minimising_kernels;
#endif
  return baseline::minimising_kernels;
}

/// The kernels for a preimage of this degree and series within `share` radians a segment: a series
/// costs as its length, and takes the fewer pieces the longer it is.
const MinimisingKernels* find_kernels(std::size_t degree, double share) {
  static const FindKernels find = choose();
  constexpr double fine = 0x1.0p-34;  // not a tolerance: where both cost the same

  return find(degree, share >= fine ? 12 : 16);
}

Row<Quaternion<double>> row_of(const PreimageRows& path, std::size_t k) {
  const Quaternion<double>* first = path.row(path.path, k);
  return {first, first + path.degree + 1};
}

/// By how much the ERF jumps between the preimages at a knot; nothing where the tangent breaks or
/// the path stands still (the roll itself says so).
std::optional<double> turn_between(const PreimageRows& path, std::size_t before,
                                   std::size_t after) {
  const Quaternion<double>& last = path.row(path.path, before)[path.degree];
  const Quaternion<double>& first = path.row(path.path, after)[0];
  const Quaternion<double> q = conjugate(first) * last;
  // What is this small is rounding, whatever the sizes of the other coefficients (knot_turn).
  const double negligible = accuracy::join_error<double>() * std::abs(q.w);
  if (q.w != 0.0 && std::abs(q.x) <= negligible && std::abs(q.y) <= negligible &&
      std::abs(q.z) <= negligible) {
    return 0.0;
  }
  const auto a = row_of(path, before), b = row_of(path, after);
  if (!(largest_component(a.back()) > 0.0) || !(largest_component(b.front()) > 0.0)) {
    return std::nullopt;
  }
  const KnotTurn turn = knot_turn(a, b);
  if (turn.breaks) return std::nullopt;
  return turn.roll;
}

/// Squares of lengths on one segment.
struct Sizes {
  double most = 0.0, least = 0.0, step = 0.0;  ///< of |A_i|, of |A_(i+1) - A_i|
};

Sizes sizes_of(const Quaternion<double>* a, std::size_t degree) {
  Sizes result;
  result.most = result.least = dot(a[0], a[0]);
  for (std::size_t i = 1; i <= degree; ++i) {
    const double here = dot(a[i], a[i]);
    const Quaternion<double> step = a[i] - a[i - 1];
    result.most = std::max(result.most, here);
    result.least = std::min(result.least, here);
    result.step = std::max(result.step, dot(step, step));
  }
  return result;
}

class InOneGo {
 public:
  InOneGo(const PreimageRows& path, const MinimisingKernels& kernels, double accuracy, double share,
          std::span<const double> xi, double begin)
      : path_(path), kernels_(kernels), accuracy_(accuracy), share_(share), xi_(xi), theta_(begin) {
    // A series of N terms on half-length r misses by about ρ^-N where the nearest zero of σ is
    // r (ρ - 1/ρ)/2 away.
    const double rho =
        std::max(least_rho, std::pow(share_, -1.0 / static_cast<double>(kernels.nodes)));
    reach_ = 0.5 * (rho - 1.0 / rho);
    fewest_ = std::max<std::size_t>(1, kernels.lanes / (path.knots.size() - 1));
  }

  /// The bound; nothing where this is not the way.
  std::optional<double> run(std::span<Frame3<double>> frames) {
    at_.xi = xi_.data();
    at_.frames = &frames[0].e1.x;
    if (!enter(0)) return std::nullopt;
    while (point_ < xi_.size()) {
      fill();
      if (used_ == 0) return std::nullopt;
      kernels_.expand(lanes_, group_);
      if (!settle()) return std::nullopt;
      if (at_.used > 0) kernels_.frames(group_, at_);
    }
    const double bound = carried_ + local_ + query_rounding * epsilon<double>() +
                         4.0 * epsilon<double>() * largest_angle_;
    return bound <= accuracy_ ? std::optional(bound) : std::nullopt;
  }

 private:
  static constexpr double least_rho = 1.5;
  /// Fewer are too few for some of the random preimages tried, more than most need.
  static constexpr double pieces_a_reach = 0.35;
  static constexpr std::size_t most_pieces = std::size_t{1} << 20;
  /// Of x, of the polynomial in it (both times the rate over a piece, below π/2), and of the axes.
  static constexpr double query_rounding = 16.0;

  struct Place {
    std::size_t segment = 0, piece = 0, pieces = 1;
    double size = 0.0;
  };

  /// Goes to the start of a segment.
  bool enter(std::size_t k) {
    const Sizes sizes = sizes_of(path_.row(path_.path, k), path_.degree);
    constexpr double largest = 0x1.0p+400;   // not a tolerance: squares of sizes
    constexpr double smallest = 0x1.0p-400;  // not a tolerance: whose products are in range
    if (!(sizes.most <= largest && sizes.least >= smallest)) return false;
    const double ratio = static_cast<double>(path_.degree) * std::sqrt(sizes.step / sizes.least);
    const double wanted = std::ceil(pieces_a_reach * reach_ * ratio);
    if (!(wanted < static_cast<double>(most_pieces))) return false;
    next_ = {k, 0, std::max(fewest_, static_cast<std::size_t>(wanted)), sizes.most};
    return true;
  }

  /// The next pieces, one a lane.
  void fill() {
    used_ = 0;
    while (used_ < kernels_.lanes && next_.segment + 1 < path_.knots.size()) {
      const double pieces = static_cast<double>(next_.pieces);
      places_[used_] = next_;
      lanes_.preimage[used_] = &path_.row(path_.path, next_.segment)->w;
      lanes_.middle[used_] = (static_cast<double>(next_.piece) + 0.5) / pieces;
      lanes_.half[used_] = 0.5 / pieces;
      lanes_.size[used_] = next_.size;
      ++used_;
      if (++next_.piece < next_.pieces) continue;
      const std::size_t k = next_.segment + 1;
      if (k + 1 == path_.knots.size()) {
        next_.segment = k;
      } else if (!enter(k)) {
        next_.segment = path_.knots.size();
        broken_ = true;
      }
    }
    if (broken_) used_ = 0;
    for (std::size_t l = used_; l < kernels_.lanes && used_ > 0; ++l) {
      lanes_.preimage[l] = lanes_.preimage[0];
      lanes_.middle[l] = lanes_.middle[0];
      lanes_.half[l] = lanes_.half[0];
      lanes_.size[l] = lanes_.size[0];
    }
  }

  /// Takes the pieces whose series are good enough up to the first that is not, which is halved.
  bool settle() {
    constexpr double most_turn = 0.25 * std::numbers::pi;
    at_.used = 0;
    for (std::size_t l = 0; l < used_; ++l) {
      const Place& place = places_[l];
      const double pieces = static_cast<double>(place.pieces);
      if (!(group_.truncation[l] <= share_ / pieces && group_.turn[l] <= most_turn)) {
        next_ = place;
        next_.piece *= 2;
        next_.pieces *= 2;
        return next_.pieces < most_pieces;
      }
      const double knot = path_.knots[place.segment];
      const double end_knot = path_.knots[place.segment + 1], step = end_knot - knot;
      if (place.piece == 0 && place.segment > 0) {
        const auto turn = turn_between(path_, place.segment - 1, place.segment);
        if (!turn) return false;
        theta_ += *turn;
      }
      at_.angle[l] = theta_ - group_.begin[l];
      theta_ = at_.angle[l] + group_.end[l];
      largest_angle_ = std::max(largest_angle_, std::abs(theta_));
      carried_ += group_.truncation[l] + group_.carried[l] + epsilon<double>() * std::abs(theta_);
      local_ = std::max(local_, group_.local[l]);
      if (!(carried_ + local_ <= accuracy_)) return false;
      at_.center[l] = knot + step * lanes_.middle[l];
      at_.scale[l] = 2.0 * pieces / step;
      at_.first[l] = point_;
      const bool last = place.piece + 1 == place.pieces;
      if (last && place.segment + 2 == path_.knots.size()) {
        point_ = xi_.size();
      } else {
        skip_below(last ? end_knot : knot + step * (static_cast<double>(place.piece + 1) / pieces));
      }
      at_.count[l] = point_ - at_.first[l];
      at_.used = l + 1;
      if (point_ == xi_.size()) return true;
    }
    return true;
  }

  /// Goes to the first parameter that is not below the end of a piece: in growing steps, then by
  /// halves.
  void skip_below(double end) {
    std::size_t step = 1, low = point_;
    while (low < xi_.size() && xi_[low] < end) {
      point_ = low + 1;
      low += step;
      step *= 2;
    }
    const auto from = xi_.begin() + static_cast<std::ptrdiff_t>(point_);
    const auto to = xi_.begin() + static_cast<std::ptrdiff_t>(std::min(low, xi_.size()));
    point_ = static_cast<std::size_t>(std::lower_bound(from, to, end) - xi_.begin());
  }

  const PreimageRows& path_;
  const MinimisingKernels& kernels_;
  double accuracy_, share_, reach_ = 1.0;
  std::size_t fewest_ = 1;
  std::span<const double> xi_;
  std::size_t point_ = 0;  ///< the first parameter that has no frame yet
  double theta_, carried_ = 0.0, local_ = 0.0, largest_angle_ = 0.0;
  Place next_, places_[most_lanes];
  std::size_t used_ = 0;
  bool broken_ = false;
  PieceLanes lanes_{};
  PieceGroup group_;
  FrameLanes at_{};
};

/// Whether the parameters ascend within [low, high].
bool ascend_inside(std::span<const double> xi, double low, double high) {
  if (!(low <= xi.front() && xi.back() <= high)) return false;
  unsigned all = 1;
  for (std::size_t i = 1; i < xi.size(); ++i) all &= static_cast<unsigned>(xi[i - 1] <= xi[i]);
  return all != 0;
}

}  // namespace
}  // namespace frame_detail

Result<double> rotation_minimising_frames(const PreimageRows& path, double accuracy,
                                          std::span<const double> xi,
                                          std::span<Frame3<double>> frames, double begin) {
  using namespace frame_detail;
  if (xi.size() != frames.size()) {
    return Fault{FaultCode::mismatched_size,
                 "frames at " + std::to_string(xi.size()) + " parameters need as many; got " +
                     std::to_string(frames.size()),
                 std::nullopt,
                 "frames",
                 static_cast<double>(frames.size()),
                 static_cast<double>(xi.size())};
  }
  const double low = path.knots.front(), high = path.knots.back();
  if (!xi.empty() && accuracy > 0.0 && std::isfinite(accuracy) && std::isfinite(begin) &&
      ascend_inside(xi, low, high)) {
    const std::size_t segments = path.knots.size() - 1;
    const double share = 0.5 * accuracy / static_cast<double>(segments);  // and half for rounding
    const MinimisingKernels* kernels = find_kernels(path.degree, share);
    const bool closes = !path.closed || turn_between(path, segments - 1, 0).has_value();
    if (kernels != nullptr && closes) {
      InOneGo way(path, *kernels, accuracy, share, xi, begin);
      if (const auto bound = way.run(frames)) return *bound;
    }
  }
  for (std::size_t i = 0; i < xi.size(); ++i) {
    if (low <= xi[i] && xi[i] <= high) continue;
    return Fault{FaultCode::outside_domain,
                 "path parameter xi " + to_text(xi[i]) + " is outside [" + to_text(low) + ", " +
                     to_text(high) + "]",
                 i,
                 "path parameter xi",
                 xi[i],
                 xi[i] < low ? low : high};
  }
  const PreimageTable table(path);
  const auto roll = rotation_minimising_roll_within(table, accuracy, begin);
  if (!roll) return roll.fault();
  try {
    RolledFrames(table, *roll).at(xi, frames);
  } catch (const Error& error) {
    return error.fault();
  }
  return roll->error_bound();
}

Result<double> rotation_minimising_frames(const PreimageTable& path, double accuracy,
                                          std::span<const double> xi,
                                          std::span<Frame3<double>> frames, double begin) {
  const PreimageRows rows{path.degree, path.closed, path.knots, &path,
                          [](const void* from, std::size_t segment) {
                            const auto& table = *static_cast<const PreimageTable*>(from);
                            return &table.coefficients[segment * (table.degree + 1)];
                          }};
  return rotation_minimising_frames(rows, accuracy, xi, frames, begin);
}

}  // namespace hodograph
