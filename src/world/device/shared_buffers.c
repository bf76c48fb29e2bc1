// SPDX-License-Identifier: MIT
// shared_buffers.c -- lets a world share memory of its device with other programs.
#include "world/device/shared_buffers.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/world.h"

void world_unshare(scree_world* world)
{
	for (int use = 0; use < SHARED_USES; ++use)
	{
		if (world->shared[use] > 0)
			world_note(world, world->backend->f->share(world->backend, (SharedUse)use, NULL));
		world->shared[use] = 0;
	}
}

scree_status world_share(scree_world* world, const char* function, const char* what, SharedUse use,
                         const SharedMemory* memory)
{
	TRY(world_check(world, function));
	Backend* b = world->backend;
	if (world->def.length_unit != 0.0f)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: memory is shared in metres, and scree_world_def.length_unit is %s",
		            function, decimal(world->def.length_unit).text);
	if (memory->how == SCREE_SHARING_MEMORY && memory->file < 0)
		return fail(SCREE_ERROR_INVALID, "%s: file_descriptor is %d, must not be negative", function, memory->file);
	if (memory->bytes < SHARED_LEAST)
		return fail(SCREE_ERROR_INVALID, "%s: bytes is %zu, must be at least %d", function, memory->bytes,
		            SHARED_LEAST);
	if (b->sharing != memory->how)
		return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: the %s of a world on %s are %s", function, what, b->name,
		            scree_sharing_name(b->sharing));
	TRY(world_note(world, b->f->share(b, use, memory)));
	world->shared[use] = memory->bytes;
	return SCREE_OK;
}
