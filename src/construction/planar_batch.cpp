// SPDX-License-Identifier: MIT
// Which kernels of the planar constructions run on this processor.
#include <cstddef>
#include <string_view>

#include "hodograph/construction/detail/planar_solution.hpp"
#include "hodograph/path/detail/batch_kernels.hpp"

namespace hodograph::planar_detail {

using Run = void (*)(const double*, std::size_t, double*);
struct Kernels {
  Run hermite, prescribed_length;
  void (*one_prescribed_length)(const double*, double*);
  void (*turns)(const double*, double*);
};

#define HODOGRAPH_DECLARE_KERNELS(isa)                                          \
  namespace isa {                                                               \
  void hermite_run(const double* in, std::size_t count, double* out);           \
  void prescribed_length_run(const double* in, std::size_t count, double* out); \
  void one_prescribed_length_run(const double* in, double* out);                \
  void four_turns_run(const double* in, double* turns);                         \
  }
HODOGRAPH_DECLARE_KERNELS(baseline)
#if defined(HODOGRAPH_X86_KERNELS)
HODOGRAPH_DECLARE_KERNELS(avx2)
HODOGRAPH_DECLARE_KERNELS(avx512)
#endif
#undef HODOGRAPH_DECLARE_KERNELS

namespace {

#define HODOGRAPH_KERNELS_OF(isa)                                                 \
  {                                                                               \
    isa::hermite_run, isa::prescribed_length_run, isa::one_prescribed_length_run, \
        isa::four_turns_run                                                       \
  }

Kernels choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  const std::string_view isa = batch_detail::kernel_instruction_set();
  if (isa == "avx512") return HODOGRAPH_KERNELS_OF(avx512);
  if (isa == "avx2") return HODOGRAPH_KERNELS_OF(avx2);
#endif
  return HODOGRAPH_KERNELS_OF(baseline);
}

#undef HODOGRAPH_KERNELS_OF

const Kernels& kernels() {
  static const Kernels chosen = choose();
  return chosen;
}

}  // namespace

void solve_hermites(const double* in, std::size_t count, double* out) {
  kernels().hermite(in, count, out);
}
void solve_prescribed_lengths(const double* in, std::size_t count, double* out) {
  kernels().prescribed_length(in, count, out);
}
void solve_prescribed_length(const double* in, double* out) {
  kernels().one_prescribed_length(in, out);
}
void four_turns(const double* in, double* turns) { kernels().turns(in, turns); }

}  // namespace hodograph::planar_detail
