// SPDX-License-Identifier: MIT
// kernels.cl -- the OpenCL program: the stages, and what only a device needs; cmake/embed.cmake inlines it.
#include "stages/program.h"
#include "opencl/primitives.cl"
// only for devices whose groups run together: they are the larger part of what there is to compile
#ifdef TOGETHER
#include "opencl/persistent.cl"
#include "opencl/forms/registers.cl"
#include "opencl/forms/relay.cl"
#include "opencl/forms/relay_hub.cl"
#include "opencl/forms/tiles.cl"
#include "opencl/forms/tile_pass.cl"
#endif
