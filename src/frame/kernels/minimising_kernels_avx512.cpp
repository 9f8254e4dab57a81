// SPDX-License-Identifier: MIT
// The rotation-minimising frames for the instruction set "avx512": 8 doubles a register
// (cmake/BatchKernels.cmake gives the flags).
#define HODOGRAPH_KERNEL_ISA avx512
#define HODOGRAPH_KERNEL_LANES 8
#include "minimising_kernels.hpp"
