// SPDX-License-Identifier: MIT
// A path's functions at several places at once, for the instruction set "baseline": 2 doubles a
// register (cmake/BatchKernels.cmake gives the flags).
#define HODOGRAPH_KERNEL_ISA baseline
#define HODOGRAPH_KERNEL_LANES 2
#include "reference_kernels.hpp"
