// SPDX-License-Identifier: MIT
// Private to control/: what a path is at one place, from its preimage there; on doubles, and on
// several places at once in wide registers.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "hodograph/control/reference_path.hpp"

namespace hodograph::control_detail {

/// Every segment's polynomials as powers of x in [-1, 1]: rows of four numbers, n + 1 of the
/// preimage and 2n + 2 of (position, arc length from the segment's start); in the plane the last
/// two, or the last one, are zero.
inline constexpr std::size_t row = 4;

/// Where a place is: its segment, x there, and dx/dξ.
struct ReferencePlaces {
  const std::int64_t* segment;
  const double* x;
  const double* inverse;
  std::size_t count;
};
struct ReferencePolynomials {
  const double* preimages;
  const double* integrals;
  std::size_t degree;
  ProgressBy progress_by;
};

/// The numbers of a ReferenceJet, in the order in which it holds them.
template <std::size_t dimension>
inline constexpr std::size_t jet_numbers = dimension == 2 ? 24 : 48;

/// Everything from A, A', A'', A''' and the position; S = A::Scalar may be a pack of doubles.
template <class A>
ReferenceJet<A> reference_jet(const PreimageJet<A, 3>& jet, const point_t<A>& position,
                              ProgressBy progress_by) {
  using S = typename A::Scalar;
  using Rates = std::array<rate_t<A>, 2>;
  const frame_t<A> first = euler_rodrigues_frame(jet);
  if (progress_by == ProgressBy::arc_length) {
    const auto rate = body_rate_per_arc_length(jet);
    const auto frame = frame_derivatives(first, Rates{rate[0], rate[1]});
    return {{position, frame[0].e1, frame[1].e1}, frame, rate, {S(1.0), S(0.0), S(0.0)}};
  }
  const auto rate = body_rate_per_xi(jet);
  const auto hodographs = hodograph_derivatives(PreimageJet<A, 1>{jet[0], jet[1]});
  return {{position, hodographs[0], hodographs[1]},
          frame_derivatives(first, Rates{rate[0], rate[1]}),
          rate,
          speed_derivatives(PreimageJet<A, 2>{jet[0], jet[1], jet[2]})};
}

/// The jets of some places, jet_numbers each, with the bits of reference_jet on doubles.
using ReferenceKernel = void (*)(const ReferencePolynomials&, const ReferencePlaces&, double* jets);
struct ReferenceKernels {
  ReferenceKernel plane, space;
};
/// Those of this processor.
const ReferenceKernels& reference_kernels();

}  // namespace hodograph::control_detail
