// SPDX-License-Identifier: MIT
#include "hodograph/frame/rolled_frames.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <string_view>

#include "hodograph/frame/adapted_frame.hpp"
#include "hodograph/frame/detail/rolled_piece.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"
#include "rows.hpp"
#include "segment_rates.hpp"

namespace hodograph {

static_assert(frame_detail::rolled_degree == FrameRoll::piece_degree);

namespace {
constexpr std::size_t most_degree = maximum_dynamic_degree;

/// How many of the first numbers lie in [low, high), or in [low, high] where closed.
std::size_t run_inside(std::span<const double> x, double low, double high, bool closed) {
  const auto inside = [&](double at) {
    return static_cast<unsigned>(low <= at) &
           (closed ? static_cast<unsigned>(at <= high) : static_cast<unsigned>(at < high));
  };
  // Without a branch for each number where all of a block are inside.
  constexpr std::size_t block = 16;
  std::size_t count = 0;
  for (; count + block <= x.size(); count += block) {
    unsigned all = 1;
    for (std::size_t j = 0; j < block; ++j) all &= inside(x[count + j]);
    if (all == 0) break;
  }
  while (count < x.size() && inside(x[count]) != 0) ++count;
  return count;
}

}  // namespace

namespace frame_detail {

#define HODOGRAPH_DECLARE_KERNEL(isa) \
  namespace isa {                     \
  RolledKernel rolled_kernel();       \
  }
HODOGRAPH_DECLARE_KERNEL(baseline)
#if defined(HODOGRAPH_X86_KERNELS)
HODOGRAPH_DECLARE_KERNEL(avx2)
HODOGRAPH_DECLARE_KERNEL(avx512)
#endif
#undef HODOGRAPH_DECLARE_KERNEL

namespace {

RolledKernel choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  const std::string_view isa = batch_detail::kernel_instruction_set();
  if (isa == "avx512") return avx512::rolled_kernel();
  if (isa == "avx2") return avx2::rolled_kernel();
#endif
  return baseline::rolled_kernel();
}

RolledKernel rolled_kernel() {
  static const RolledKernel chosen = choose();
  return chosen;
}

}  // namespace
}  // namespace frame_detail

void RolledFrames::add_piece(const std::vector<Quaternion<double>>& preimage, double u_begin,
                             double u_end, double knot, double step, const FrameRoll::Piece* from) {
  frame_detail::RolledPiece piece;
  Quaternion<double> rotor{1.0, 0.0, 0.0, 0.0};
  piece.xi = knot + step * (0.5 * (u_begin + u_end));
  piece.scale = 2.0 / (step * (u_end - u_begin));
  if (from != nullptr) {
    rotor = {std::cos(0.5 * from->middle), std::sin(0.5 * from->middle), 0.0, 0.0};
    std::transform(from->coefficient.begin(), from->coefficient.end(), piece.half_roll,
                   [](double c) { return 0.5 * c; });
  }
  pieces_.push_back(piece);
  starts_.push_back(knot + step * u_begin);

  // Powers of x about the middle: C(n,k) 2^-k times the k-th difference of the points that n - k
  // steps of de Casteljau's algorithm leave there.
  std::array<Quaternion<double>, most_degree + 1> point, difference;
  const double v = u_begin > 0.0 ? u_begin / u_end : 0.0;
  for (std::size_t i = 0; i <= degree_; ++i) point[i] = preimage[i];
  if (u_end < 1.0) {
    for (std::size_t r = 1; r <= degree_; ++r) {
      for (std::size_t i = degree_; i >= r; --i) {
        point[i] = (1.0 - u_end) * point[i - 1] + u_end * point[i];
      }
    }
  }
  if (v > 0.0) {
    for (std::size_t r = 1; r <= degree_; ++r) {
      for (std::size_t i = 0; i + r <= degree_; ++i) {
        point[i] = (1.0 - v) * point[i] + v * point[i + 1];
      }
    }
  }
  const std::size_t first = preimages_.size();
  preimages_.resize(first + 4 * (degree_ + 1));
  double factor = 1.0;
  for (std::size_t k = 1; k <= degree_; ++k) {
    factor *= 0.5 * static_cast<double>(degree_ - k + 1) / static_cast<double>(k);
  }
  for (std::size_t k = degree_ + 1; k-- > 0;) {
    std::copy_n(point.begin(), k + 1, difference.begin());
    for (std::size_t r = k; r > 0; --r) {
      for (std::size_t i = 0; i < r; ++i) difference[i] = difference[i + 1] - difference[i];
    }
    const Quaternion<double> turned = (factor * difference[0]) * rotor;
    for (std::size_t c = 0; c < 4; ++c) preimages_[first + 4 * k + c] = turned[c];
    if (k > 0) {
      factor *= 2.0 * static_cast<double>(k) / static_cast<double>(degree_ - k + 1);
      for (std::size_t i = 0; i < k; ++i) point[i] = 0.5 * (point[i] + point[i + 1]);
    }
  }
}

RolledFrames::RolledFrames(const PreimageTable& path, const FrameRoll& roll)
    : degree_(path.degree) {
  if (roll.knots() != path.knots) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "the roll was made for other knots than those of the path", std::nullopt,
                      "knots", static_cast<double>(roll.knots().size()),
                      static_cast<double>(path.knots.size())});
  }
  for (std::size_t k = 0; k < path.segment_count(); ++k) {
    const auto preimage = frame_detail::scaled_preimage(path, k).a;
    const auto pieces = roll.pieces(k);
    const double knot = path.knots[k], step = path.step(k);
    if (pieces.empty()) add_piece(preimage, 0.0, 1.0, knot, step, nullptr);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const double end = i + 1 < pieces.size() ? pieces[i + 1].begin : 1.0;
      add_piece(preimage, pieces[i].begin, end, knot, step, &pieces[i]);
    }
  }
  starts_.push_back(path.knots.back());
  index_ = IntervalIndex<double>(starts_);
  if (roll.kind() == RollKind::linear) {
    begin_angle_ = roll.angle_at_begin(0);
    rate_ = roll.linear_rate();
  }
}

Frame3<double> RolledFrames::at(double xi) const {
  Frame3<double> frame;
  at(std::span<const double>(&xi, 1), std::span<Frame3<double>>(&frame, 1));
  return frame;
}

void RolledFrames::at(std::span<const double> xi, std::span<Frame3<double>> frames) const {
  static_assert(sizeof(Frame3<double>) == 9 * sizeof(double));
  if (xi.size() != frames.size()) {
    throw Error(Fault{FaultCode::mismatched_size,
                      "frames at " + std::to_string(xi.size()) + " parameters need as many; got " +
                          std::to_string(frames.size()),
                      std::nullopt, "frames", static_cast<double>(frames.size()),
                      static_cast<double>(xi.size())});
  }
  if (run_inside(xi, starts_.front(), starts_.back(), true) < xi.size()) {
    std::size_t i = 0;
    while (starts_.front() <= xi[i] && xi[i] <= starts_.back()) ++i;
    throw Error(Fault{FaultCode::outside_domain,
                      "path parameter xi " + to_text(xi[i]) + " is outside [" +
                          to_text(starts_.front()) + ", " + to_text(starts_.back()) + "]",
                      i, "path parameter xi", xi[i],
                      xi[i] < starts_.front() ? starts_.front() : starts_.back()});
  }
  const auto kernel = frame_detail::rolled_kernel();
  for (std::size_t i = 0; i < xi.size();) {
    const std::size_t k = index_.find(starts_, xi[i]);
    const std::size_t end =
        i + 1 + run_inside(xi.subspan(i + 1), starts_[k], starts_[k + 1], false);
    if (!kernel(pieces_[k], degree_, &preimages_[4 * (degree_ + 1) * k], &xi[i], end - i,
                &frames[i].e1.x)) {
      throw Error(
          Fault{FaultCode::zero_speed,
                "the path stands still near xi = " + to_text(xi[i]) + ": no frame exists there", i,
                "speed", 0.0, std::nullopt});
    }
    i = end;
  }
  if (rate_ == 0.0 && begin_angle_ == 0.0) return;
  for (std::size_t i = 0; i < xi.size(); ++i) {
    frames[i] = rolled(frames[i], begin_angle_ + rate_ * (xi[i] - starts_.front()));
  }
}

}  // namespace hodograph
