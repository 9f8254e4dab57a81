// SPDX-License-Identifier: MIT
#include "hodograph/frame/minimising_frames.hpp"

#include <algorithm>
#include <bit>
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

const MinimisingKernels* find_kernels(std::size_t degree, std::size_t nodes) {
  static const FindKernels find = choose();
  return find(degree, nodes);
}

Row<Quaternion<double>> row_of(const PreimageRows& path, std::size_t k) {
  const Quaternion<double>* first = path.row(path.path, k);
  return {first, first + path.degree + 1};
}

/// Whether the preimages at a knot are the same up to a factor and rounding.
bool go_on(const PreimageRows& path, std::size_t before, std::size_t after) {
  const Quaternion<double>& last = path.row(path.path, before)[path.degree];
  const Quaternion<double>& first = path.row(path.path, after)[0];
  const Quaternion<double> q = conjugate(first) * last;
  // What is this small is rounding, whatever the sizes of the other coefficients (knot_turn).
  const double negligible = accuracy::join_error<double>() * std::abs(q.w);
  return q.w != 0.0 && std::abs(q.x) <= negligible && std::abs(q.y) <= negligible &&
         std::abs(q.z) <= negligible;
}

/// Whether the path moves on both sides of a knot.
bool moves(const Row<Quaternion<double>>& before, const Row<Quaternion<double>>& after) {
  return largest_component(before.back()) > 0.0 && largest_component(after.front()) > 0.0;
}

/// Whether the tangent is continuous at a knot, and the path moves there.
bool join(const PreimageRows& path, std::size_t before, std::size_t after) {
  const auto a = row_of(path, before), b = row_of(path, after);
  return go_on(path, before, after) || (moves(a, b) && !tangent_breaks(a, b));
}

/// By how much the ERF jumps between the preimages at a knot; nothing where they do not join (the
/// roll itself says so).
std::optional<double> turn_between(const PreimageRows& path, std::size_t before,
                                   std::size_t after) {
  if (go_on(path, before, after)) return 0.0;
  const auto a = row_of(path, before), b = row_of(path, after);
  if (!moves(a, b)) return std::nullopt;
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

/// How many half-lengths of a piece away the nearest zero of σ should be for a series within
/// `share`: N terms miss by about ρ^-N where it is (ρ - 1/ρ)/2 of them away. A guess to start from.
double reach_of(std::size_t nodes, double share) {
  constexpr double least_rho = 1.5;
  const double rho = std::max(
      least_rho, std::exp2(-static_cast<double>(std::ilogb(share)) / static_cast<double>(nodes)));
  return 0.5 * (rho - 1.0 / rho);
}

/// Into how many pieces a segment should be cut, before it is made a power of two.
double pieces_wanted(const Sizes& sizes, std::size_t degree, double reach) {
  // Fewer are too few for some of the random preimages tried, more than most need.
  constexpr double pieces_a_reach = 0.35;
  return pieces_a_reach * reach * static_cast<double>(degree) * std::sqrt(sizes.step / sizes.least);
}

/// The kernels for a path and series within `share` radians a segment: long series, which take the
/// fewer pieces; short ones where the pieces fit into one register even so.
const MinimisingKernels* find_kernels(const PreimageRows& path, double share) {
  constexpr std::size_t few = 8;
  const std::size_t segments = path.knots.size() - 1;
  const MinimisingKernels* quick = find_kernels(path.degree, few);
  if (quick != nullptr && segments <= quick->lanes) {
    // Half of the room: a second register would cost more than the shorter series save.
    const double room = 0.5 * static_cast<double>(quick->lanes) / static_cast<double>(segments);
    const double reach = reach_of(few, share);
    bool enough = true;
    for (std::size_t k = 0; k < segments && enough; ++k) {
      const Sizes sizes = sizes_of(path.row(path.path, k), path.degree);
      enough = pieces_wanted(sizes, path.degree, reach) <= room;
    }
    if (enough) return quick;
  }
  return find_kernels(path.degree, most_nodes);
}

class InOneGo {
 public:
  InOneGo(const PreimageRows& path, const MinimisingKernels& kernels, double accuracy, double share,
          std::span<const double> xi, double begin)
      : path_(path),
        kernels_(kernels),
        accuracy_(accuracy),
        share_(share),
        reach_(reach_of(kernels.nodes, share)),
        fewest_(std::max<std::size_t>(1, kernels.lanes / (path.knots.size() - 1))),
        xi_(xi),
        theta_(begin) {}

  /// The bound; nothing where this is not the way.
  std::optional<double> run(std::span<Frame3<double>> frames) {
    at_.xi = xi_.data();
    at_.points = xi_.size();
    at_.frames = &frames[0].e1.x;
    if (!enter(0, next_)) return std::nullopt;
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
  static constexpr std::size_t most_pieces = std::size_t{1} << 20;
  /// Of x, of the polynomial in it (both times the rate over a piece, below π/2), and of the axes.
  static constexpr double query_rounding = 16.0;

  struct Place {
    std::size_t segment = 0, piece = 0, pieces = 1;
    double share = 1.0;  ///< 1/pieces
    double size = 0.0;
    void halve() {
      piece *= 2;
      pieces *= 2;
      share *= 0.5;
    }
  };

  /// The first piece of a segment.
  bool enter(std::size_t k, Place& first) const {
    const Sizes sizes = sizes_of(path_.row(path_.path, k), path_.degree);
    constexpr double largest = 0x1.0p+400;   // not a tolerance: squares of sizes
    constexpr double smallest = 0x1.0p-400;  // not a tolerance: whose products are in range
    if (!(sizes.most <= largest && sizes.least >= smallest)) return false;
    const double wanted = std::ceil(pieces_wanted(sizes, path_.degree, reach_));
    if (!(wanted < static_cast<double>(most_pieces))) return false;
    // A power of two: middles and half-lengths are exact, and pieces meet without a gap.
    const std::size_t pieces = std::bit_ceil(std::max(fewest_, static_cast<std::size_t>(wanted)));
    first = {k, 0, pieces, 1.0 / static_cast<double>(pieces), sizes.most};
    return true;
  }

  /// The next pieces, one a lane.
  void fill() {
    std::size_t used = 0;
    Place next = next_;
    while (used < kernels_.lanes && next.segment + 1 < path_.knots.size()) {
      const double* preimage = &path_.row(path_.path, next.segment)->w;
      for (; used < kernels_.lanes && next.piece < next.pieces; ++next.piece) {
        places_[used] = next;
        lanes_.preimage[used] = preimage;
        lanes_.middle[used] = (static_cast<double>(next.piece) + 0.5) * next.share;
        lanes_.half[used] = 0.5 * next.share;
        lanes_.size[used] = next.size;
        ++used;
      }
      if (next.piece < next.pieces) break;
      if (++next.segment + 1 < path_.knots.size() && !enter(next.segment, next)) {
        used = 0;
        break;
      }
    }
    for (std::size_t l = used; l < kernels_.lanes && used > 0; ++l) {
      lanes_.preimage[l] = lanes_.preimage[0];
      lanes_.middle[l] = lanes_.middle[0];
      lanes_.half[l] = lanes_.half[0];
      lanes_.size[l] = lanes_.size[0];
    }
    used_ = used;
    next_ = next;
  }

  /// Takes the pieces whose series are good enough up to the first that is not, which is halved.
  bool settle() {
    constexpr double most_turn = 0.25 * std::numbers::pi;
    at_.used = 0;
    for (std::size_t l = 0; l < used_; ++l) {
      const Place& place = places_[l];
      if (!(group_.truncation[l] <= share_ * place.share && group_.turn[l] <= most_turn)) {
        next_ = place;
        next_.halve();
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
      at_.scale[l] = 2.0 / (place.share * step);
      at_.first[l] = point_;
      const bool last = place.piece + 1 == place.pieces;
      if (last && place.segment + 2 == path_.knots.size()) {
        point_ = xi_.size();
      } else {
        skip_below(last ? end_knot
                        : knot + step * (static_cast<double>(place.piece + 1) * place.share));
      }
      at_.count[l] = point_ - at_.first[l];
      at_.used = l + 1;
      if (point_ == xi_.size()) return true;
    }
    return true;
  }

  /// Goes to the first parameter that is not below the end of a piece: as many on as last time,
  /// from there in growing steps, then by halves.
  void skip_below(double end) {
    const std::size_t count = xi_.size(), first = point_;
    std::size_t low = first, high = std::min(first + last_count_, count), step = 1;
    if (high < count && xi_[high] < end) {
      low = high + 1;
      while (low + step <= count && xi_[low + step - 1] < end) {
        low += step;
        step *= 2;
      }
      high = std::min(low + step - 1, count);
    } else {
      while (high - first >= step && !(xi_[high - step] < end)) {
        high -= step;
        step *= 2;
      }
      if (high - first >= step) low = high - step + 1;
    }
    const auto from = xi_.begin() + static_cast<std::ptrdiff_t>(low);
    const auto to = xi_.begin() + static_cast<std::ptrdiff_t>(high);
    point_ = static_cast<std::size_t>(std::lower_bound(from, to, end) - xi_.begin());
    last_count_ = point_ - first;
  }

  const PreimageRows& path_;
  const MinimisingKernels& kernels_;
  double accuracy_, share_, reach_;
  std::size_t fewest_;
  std::span<const double> xi_;
  std::size_t point_ = 0, last_count_ = 0;  ///< the first parameter that has no frame yet
  double theta_, carried_ = 0.0, local_ = 0.0, largest_angle_ = 0.0;
  Place next_, places_[most_lanes];
  std::size_t used_ = 0;
  PieceLanes lanes_{};
  PieceGroup group_;
  FrameLanes at_{};
};

/// Whether the parameters ascend within [low, high].
bool ascend_inside(std::span<const double> xi, double low, double high,
                   const MinimisingKernels& kernels) {
  return low <= xi.front() && xi.back() <= high && kernels.ascend(xi.data(), xi.size());
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
  if (!xi.empty() && accuracy > 0.0 && std::isfinite(accuracy) && std::isfinite(begin)) {
    const std::size_t segments = path.knots.size() - 1;
    const double share = 0.5 * accuracy / static_cast<double>(segments);  // and half for rounding
    const MinimisingKernels* kernels = find_kernels(path, share);
    if (kernels != nullptr && ascend_inside(xi, low, high, *kernels) &&
        (!path.closed || join(path, segments - 1, 0))) {
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
