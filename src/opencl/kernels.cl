// SPDX-License-Identifier: MIT
// kernels.cl -- the OpenCL program: the stages, and the kernels that only a device has; cmake/embed.cmake inlines it.
#include "stages/all_stages.h"
#include "opencl/primitives.cl"

// Stages for worlds that have no small bodies, belts and segments, or no rules. They use fewer registers, so more work-items are resident.
// On an H100 the narrow phase of a million bodies in motion takes 1.83 ms with its own kernel, and 2.25 ms without.
KERNEL_FUNCTION(narrow_phase_plain, narrow_phase, (pools.step.small = pools.step.belts = pools.step.segments = 0), SPREAD_NOT)

// Work-items per item, a power of two, as there is room.
INLINE int spread_warp(int items)
{
	int spread = 1;
	while (spread < 32 && 2 * spread * items <= (int)get_global_size(0))
		spread *= 2;
	return spread;
}
KERNEL_FUNCTION(continuous_plain, continuous, (pools.step.rules = pools.step.asks = pools.step.material_pairs = 0), spread_warp)
// Only for devices that keep several work-groups resident at once: these kernels take most of the compile time. Not for a CPU: it would
// compile the first one for minutes; tests emulate it.
#ifdef PERSISTENT
#include "opencl/persistent.cl"
#endif
#ifdef RESIDENT
#include "opencl/forms/registers.cl"
#include "opencl/forms/relay.cl"
#include "opencl/forms/relay_hub.cl"
#include "opencl/forms/tiles.cl"
#include "opencl/forms/tile_pass.cl"
#endif
