// SPDX-License-Identifier: MIT
// body_moved.c -- lists the bodies whose poses changed since the user last read the list.
#include "platform/processor.h"
#include "step/step_queries.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <stddef.h>
#include <string.h>

// Fills *moved. The caller has set all its bytes to 0, padding included, because programs send rows over networks.
static void moved_fill(const scree_world* world, const MovedBody* row, scree_moved_body* moved)
{
	int body = row->body & (MOVED_ASLEEP - 1);
	moved->body = body_handle(world, body);
	moved->user = world->host_bodies[body].user;
	moved->pose = world_body_pose(world, body, &row->pose);
	moved->asleep = (row->body & MOVED_ASLEEP) != 0;
	moved->velocity = (scree_velocity){{row->vx, row->vy}, row->w};
}

scree_status api_world_get_moved_bodies_sized(scree_world* world, scree_moved_bodies* list)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_moved_bodies";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "list", list));
	uint32_t least = offsetof(scree_moved_bodies, bodies) + sizeof list->bodies;
	if (list->size < least || list->size > MOST_SIZE || list->body_size > MOST_SIZE)
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "list", ALONE}, ".size",
		              "is %u, and that of a row %u: they were not set by %s", list->size, list->body_size, function);
	TRY(world_upload(world));
	int found = 0, count = 0;
	TRY(world_note(world, moved_count(&world->pipeline, world->bodies.used, &found)));
	MovedBody* rows = world_scratch(world, (size_t)found * sizeof *rows);
	size_t bytes = (size_t)found * list->body_size;
	if (bytes > INT32_MAX || (found > 0 && !rows))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d bodies", function, found);
	TRY(GROW(function, world->moved, world->moved_capacity, (int)bytes));
	TRY(world_note(world, moved_list(&world->pipeline, world->bodies.used, found)));
	if (found > 0)
		TRY(world_read(world, POOL_moved_row, 0, found, rows));
	for (int k = 0; k < found; ++k)
	{
		if (!slots_in_use(&world->bodies, rows[k].body & (MOVED_ASLEEP - 1)))
			continue;
		scree_moved_body row;
		memset(&row, 0, sizeof row);
		moved_fill(world, rows + k, &row);
		write_result(world->moved + list->body_size * (size_t)count++, list->body_size, &row, sizeof row);
	}
	scree_moved_bodies result = {.size = list->size,
	                             .body_size = list->body_size,
	                             .count = count,
	                             .bodies = (const scree_moved_body*)(const void*)world->moved};
	write_result(list, result.size, &result, sizeof result);
	return SCREE_OK;
}
