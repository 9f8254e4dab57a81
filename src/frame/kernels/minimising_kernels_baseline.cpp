// SPDX-License-Identifier: MIT
// The rotation-minimising frames for the instruction set "baseline": 2 doubles a register
// (cmake/BatchKernels.cmake gives the flags).
#define HODOGRAPH_KERNEL_ISA baseline
#define HODOGRAPH_KERNEL_LANES 2
#include "minimising_kernels.hpp"
