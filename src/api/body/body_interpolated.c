// SPDX-License-Identifier: MIT
// body_interpolated.c -- reads the poses of all bodies between those before and after the last step, for drawing.
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include "world/world.h"

scree_status api_world_get_interpolated(scree_world* world, float alpha, scree_body* bodies, scree_pose* poses,
                                        int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_interpolated";
	TRY(world_check(world, function));
	TRY(check_real((ArgumentPlace){function, "alpha", ALONE}, "", alpha, 0.0f, 1.0f));
	TRY(check_list(function, "poses", poses, capacity, count));
	TRY(world_upload(world));
	int used = world->bodies.used, listed = 0;
	if (capacity > 0)
	{
		size_t bytes = (size_t)used * sizeof(Float4);
		Float4* rows = world_scratch(world, bytes);
		if (!rows)
			return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %zu bytes from the device", function, bytes);
		TRY(world_note(world, pipeline_interpolate(&world->pipeline, used, alpha)));
		TRY(world_note(world, world->backend->f->read(world->backend, POOL_base, 0, used, rows)));
		for (int k = 0; k < used && listed < capacity; ++k)
		{
			if (!slots_in_use(&world->bodies, k))
				continue;
			poses[listed] = world_body_pose(world, k, rows + k);
			if (bodies)
				bodies[listed] = body_handle(world, k);
			++listed;
		}
	}
	*count = world->bodies.alive;
	return SCREE_OK;
}
