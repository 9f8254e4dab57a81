// SPDX-License-Identifier: MIT
// Which batch kernels run on this processor.
#include "hodograph/path/detail/batch_kernels.hpp"

namespace hodograph::batch_detail {

namespace baseline {
const Kernels* find(std::size_t dimension, std::size_t n);
}
#if defined(HODOGRAPH_X86_KERNELS)
namespace avx2 {
const Kernels* find(std::size_t dimension, std::size_t n);
}
namespace avx512 {
const Kernels* find(std::size_t dimension, std::size_t n);
}
#endif

namespace {

struct InstructionSet {
  const char* name;
  const Kernels* (*find)(std::size_t dimension, std::size_t n);
};

InstructionSet choose() {
#if defined(HODOGRAPH_X86_KERNELS)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl")) {
    return {"avx512", avx512::find};
  }
  if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) return {"avx2", avx2::find};
#endif
  return {"baseline", baseline::find};
}

const InstructionSet& instruction_set() {
  static const InstructionSet chosen = choose();
  return chosen;
}

}  // namespace

const Kernels* kernels_for(std::size_t dimension, std::size_t n) {
  return instruction_set().find(dimension, n);
}

const char* kernel_instruction_set() { return instruction_set().name; }

}  // namespace hodograph::batch_detail
