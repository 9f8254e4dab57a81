// SPDX-License-Identifier: MIT
// Which Hermite kernels run on this processor.
#include <cstddef>
#include <string_view>
#include <type_traits>

#include "hodograph/construction/hermite.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"

namespace hodograph::hermite_detail {

#define HODOGRAPH_DECLARE_KERNELS(isa)                                                             \
  namespace isa {                                                                                  \
  void twist_free_run(const double* points, const double* steps, double square, std::size_t count, \
                      double* out);                                                                \
  }
HODOGRAPH_DECLARE_KERNELS(baseline)
#if defined(HODOGRAPH_X86_KERNELS)
HODOGRAPH_DECLARE_KERNELS(avx2)
HODOGRAPH_DECLARE_KERNELS(avx512)
#endif
#undef HODOGRAPH_DECLARE_KERNELS

namespace {

using Run = void (*)(const double*, const double*, double, std::size_t, double*);

Run choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  const std::string_view isa = batch_detail::kernel_instruction_set();
  if (isa == "avx512") return avx512::twist_free_run;
  if (isa == "avx2") return avx2::twist_free_run;
#endif
  return baseline::twist_free_run;
}

}  // namespace

void twist_free_segments(const HermitePoint<4>* points, const double* steps, double square,
                         std::size_t count, Segment<double, 4>* segments) {
  static const Run run = choose();
  static_assert(sizeof(HermitePoint<4>) == 15 * sizeof(double));
  static_assert(sizeof(Segment<double, 4>) == 40 * sizeof(double) &&
                std::is_trivially_copyable_v<Segment<double, 4>>);
  run(&points->front().x, steps, square, count, &segments->preimage[0].w);
}

}  // namespace hodograph::hermite_detail
