// SPDX-License-Identifier: MIT
// kernels.cl -- the OpenCL program: the stages, and the kernels that only a device has; cmake/embed.cmake inlines it.
#include "stages/program.h"
#include "opencl/primitives.cl"
// Only for devices that keep several work-groups resident at once: these kernels take most of the compile time.
#ifdef RESIDENT
#include "opencl/persistent.cl"
#include "opencl/forms/registers.cl"
#include "opencl/forms/relay.cl"
#include "opencl/forms/relay_hub.cl"
#include "opencl/forms/tiles.cl"
#include "opencl/forms/tile_pass.cl"
#endif
