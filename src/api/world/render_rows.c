// SPDX-License-Identifier: MIT
// render_rows.c -- copies the rows that a renderer draws to the host, or writes them to memory shared with OpenGL.
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/check.h"
#include "world/device/shared_buffers.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/recovery/recovery.h"
#include "world/upload/upload.h"
#include "world/world.h"

_Static_assert(sizeof(scree_render_row) == sizeof(WorldShape) &&
                   offsetof(scree_render_row, center) == offsetof(WorldShape, center_x) &&
                   offsetof(scree_render_row, attribute) == offsetof(WorldShape, attribute) &&
                   offsetof(scree_render_row, body) == offsetof(WorldShape, body),
               "users read the rows as the stage writes them");

const char* scree_sharing_name(scree_sharing sharing)
{
	switch (sharing)
	{
	case SCREE_SHARING_COPIED:
		return "copied";
	case SCREE_SHARING_MEMORY:
		return "shared through external memory";
	case SCREE_SHARING_OPENGL:
		return "shared with OpenGL";
	}
	return "unknown";
}

scree_sharing scree_world_get_sharing(const scree_world* world)
{
	return world ? world->backend->sharing : SCREE_SHARING_COPIED;
}

// Writes the rows, with bodies at a fraction of the last step; the fraction 1 stands for the current state.
static scree_status render(scree_world* world, float alpha, bool shared)
{
	bool interpolated = alpha < 1.0f;
	if (interpolated)
		TRY(world_note(world, pipeline_interpolate(&world->pipeline, world->bodies.used, alpha)));
	return world_note(world, pipeline_render(&world->pipeline, world->collidables.used, interpolated, shared));
}

static scree_status get_rows(scree_world* world, const char* function, float alpha, scree_render_row* rows,
                             int capacity, int* count)
{
	TRY(world_check(world, function));
	TRY(check_real((ArgumentPlace){function, "alpha", ALONE}, "", alpha, 0.0f, 1.0f));
	TRY(check_list(function, "rows", rows, capacity, count));
	TRY(world_upload(world));
	int used = world->collidables.used, wanted = used < capacity ? used : capacity;
	if (wanted > 0)
	{
		TRY(render(world, alpha, false));
		TRY(world_note(world, world->backend->f->read(world->backend, POOL_render_row, 0, wanted, rows)));
	}
	*count = used;
	return SCREE_OK;
}

scree_status api_world_get_render_rows(scree_world* world, scree_render_row* rows, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	return get_rows(world, "scree_world_get_render_rows", 1.0f, rows, capacity, count);
}

scree_status api_world_get_interpolated_rows(scree_world* world, float alpha, scree_render_row* rows, int capacity,
                                             int* count)
{
	FLOAT_MODE_HERE;
	return get_rows(world, "scree_world_get_interpolated_rows", alpha, rows, capacity, count);
}

scree_status api_world_share_memory(scree_world* world, int file_descriptor, size_t bytes)
{
	FLOAT_MODE_HERE;
	return world_share(world, "scree_world_share_memory", "rows", SHARED_ROWS,
	                   &(SharedMemory){.how = SCREE_SHARING_MEMORY, .file = file_descriptor, .bytes = bytes});
}

scree_status api_world_share_opengl(scree_world* world, uint32_t buffer, size_t bytes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_share_opengl";
	if (buffer == 0)
		return fail(SCREE_ERROR_INVALID, "%s: buffer is 0, not the name of a buffer object", function);
	return world_share(world, function, "rows", SHARED_ROWS,
	                   &(SharedMemory){.how = SCREE_SHARING_OPENGL, .buffer = buffer, .bytes = bytes});
}

void scree_world_unshare(scree_world* world)
{
	FLOAT_MODE_HERE;
	if (!world)
		return;
	world_unshare(world);
	world_recovers(world, "scree_world_unshare", world->broken);
}

static scree_status write_rows(scree_world* world, const char* function, float alpha, int* count)
{
	TRY(world_check(world, function));
	TRY(check_real((ArgumentPlace){function, "alpha", ALONE}, "", alpha, 0.0f, 1.0f));
	TRY(check_pointer(function, "count", count));
	if (world->shared[SHARED_ROWS] == 0)
		return fail(SCREE_ERROR_INVALID,
		            "%s: nothing is shared; scree_world_share_memory or scree_world_share_opengl comes first",
		            function);
	TRY(world_upload(world));
	*count = world->collidables.used;
	size_t room = world->shared[SHARED_ROWS] / sizeof(scree_render_row);
	if ((size_t)*count > room)
		return fail(SCREE_ERROR_INVALID, "%s: there are %d rows, and the shared memory has room for %zu", function,
		            *count, room);
	return *count > 0 ? render(world, alpha, true) : SCREE_OK;
}

scree_status api_world_write_render_rows(scree_world* world, int* count)
{
	FLOAT_MODE_HERE;
	return write_rows(world, "scree_world_write_render_rows", 1.0f, count);
}

scree_status api_world_write_interpolated_rows(scree_world* world, float alpha, int* count)
{
	FLOAT_MODE_HERE;
	return write_rows(world, "scree_world_write_interpolated_rows", alpha, count);
}
