// SPDX-License-Identifier: MIT
// The rotation-minimising frames for the instruction set "avx2": 4 doubles a register
// (cmake/BatchKernels.cmake gives the flags).
#define HODOGRAPH_KERNEL_ISA avx2
#define HODOGRAPH_KERNEL_LANES 4
#include "minimising_kernels.hpp"
