// SPDX-License-Identifier: MIT
// kernels.cl -- the OpenCL program: the stages, and what only a device needs; cmake/embed.cmake inlines it.
#include "stages/program.h"
#include "opencl/primitives.cl"
#include "opencl/persistent.cl"
