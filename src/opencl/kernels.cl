// SPDX-License-Identifier: MIT
// kernels.cl -- contains the OpenCL program: stages, and kernels of OpenCL only. cmake/embed.cmake inlines includes.
#include "stages/all_stages.h"
#include "opencl/primitives.cl"

// Variants of kernels: narrow_phase_plain for worlds without small bodies, belts and segments; continuous_plain for
// worlds without rules. They use fewer registers, so more work-items are resident; docs/design/opencl.md has measurements.
KERNEL_FUNCTION(narrow_phase_plain, narrow_phase, (pools.step.small = pools.step.belts = pools.step.segments = 0), SPREAD_NOT)

// Returns the number of work-items per item: a power of two up to 32, for which the launch has enough work-items.
INLINE int spread_warp(int items)
{
	int spread = 1;
	while (spread < 32 && 2 * spread * items <= (int)get_global_size(0))
		spread *= 2;
	return spread;
}
KERNEL_FUNCTION(continuous_plain, continuous, (pools.step.rules = pools.step.asks = pools.step.material_pairs = 0), spread_warp)
// Kernels for devices that keep several work-groups resident at once; they take most of the compile time. Programs for
// a CPU do not contain the persistent kernel, which would compile for minutes there; tests emulate it.
#ifdef PERSISTENT
#include "opencl/persistent.cl"
#endif
#ifdef RESIDENT
#include "opencl/forms/registers.cl"
#include "opencl/forms/relay.cl"
#include "opencl/forms/relay_hub.cl"
#endif
// tiles exceed the 32 KiB of local memory that OpenCL 1.2 guarantees; some compilers reject a kernel that exceeds the device's
#if defined(RESIDENT) && defined(TILES)
#include "opencl/forms/tiles.cl"
#include "opencl/forms/tile_pass.cl"
#include "opencl/forms/bay_solve.cl"
#endif
