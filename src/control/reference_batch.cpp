// SPDX-License-Identifier: MIT
// Many places of a path at once.
#include <algorithm>
#include <cassert>
#include <cstdint>
#include <string_view>

#include "hodograph/path/detail/batch_kernels.hpp"
#include "reference_jet.hpp"

namespace hodograph {
namespace control_detail {

#define HODOGRAPH_DECLARE_KERNELS(isa)         \
  namespace isa {                              \
  const ReferenceKernels& reference_kernels(); \
  }
HODOGRAPH_DECLARE_KERNELS(baseline)
#if defined(HODOGRAPH_X86_KERNELS)
HODOGRAPH_DECLARE_KERNELS(avx2)
HODOGRAPH_DECLARE_KERNELS(avx512)
#endif
#undef HODOGRAPH_DECLARE_KERNELS

namespace {

const ReferenceKernels& choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  const std::string_view isa = batch_detail::kernel_instruction_set();
  if (isa == "avx512") return avx512::reference_kernels();
  if (isa == "avx2") return avx2::reference_kernels();
#endif
  return baseline::reference_kernels();
}

}  // namespace

const ReferenceKernels& reference_kernels() {
  static const ReferenceKernels& chosen = choose();
  return chosen;
}

}  // namespace control_detail

template <class A>
void ReferencePath<A>::at(std::span<const double> progress,
                          std::span<ReferenceJet<A>> result) const {
  assert(result.size() == progress.size());
  constexpr std::size_t numbers = control_detail::jet_numbers<point_t<A>::dimension>;
  static_assert(sizeof(ReferenceJet<A>) == numbers * sizeof(double));
  constexpr std::size_t run = 256;
  std::array<std::int64_t, run> segment;
  std::array<double, run> x, inverse;
  const auto& kernels = control_detail::reference_kernels();
  const auto kernel = A::dimension == 2 ? kernels.plane : kernels.space;
  std::size_t near = 0;
  for (std::size_t first = 0; first < progress.size(); first += run) {
    const std::size_t count = std::min(run, progress.size() - first);
    for (std::size_t i = 0; i < count; ++i) {
      const Place place = locate(progress[first + i], near);
      near = place.segment;
      segment[i] = static_cast<std::int64_t>(near);
      x[i] = place.x;
      inverse[i] = place.inverse;
    }
    kernel({preimages_.data(), integrals_.data(), degree_, progress_by_},
           {segment.data(), x.data(), inverse.data(), count},
           reinterpret_cast<double*>(result.data() + first));
  }
}

template void ReferencePath<Complex<double>>::at(std::span<const double>,
                                                 std::span<ReferenceJet<Complex<double>>>) const;
template void ReferencePath<Quaternion<double>>::at(
    std::span<const double>, std::span<ReferenceJet<Quaternion<double>>>) const;

}  // namespace hodograph
