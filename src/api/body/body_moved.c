// SPDX-License-Identifier: MIT
// body_moved.c -- the bodies whose poses the user does not know yet.
#include "step/step_queries.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/handles.h"
#include "world/pool_read.h"
#include "world/upload/upload.h"
#include "world/world.h"
#include <stddef.h>
#include <string.h>

// moved is zero, also between its members: programs send rows over networks.
static void moved_fill(const scree_world* world, const Told* row, scree_moved* moved)
{
	moved->body = body_handle(world, row->body);
	moved->user = world->host_bodies[row->body].user;
	moved->pose = world_body_pose(world, row->body, &row->pose);
	moved->velocity = (scree_velocity){{row->vx, row->vy}, row->w};
}

scree_status scree_world_get_moved_sized(scree_world* world, scree_moved_list* list)
{
	const char* function = "scree_world_get_moved";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "list", list));
	uint32_t least = offsetof(scree_moved_list, moved) + sizeof list->moved;
	if (list->size < least || list->size > MOST_SIZE || list->moved_size > MOST_SIZE)
		return refuse(SCREE_ERROR_INVALID, (Where){function, "list", ALONE}, ".size",
		              "is %u, and that of a row %u: they were not set by %s", list->size, list->moved_size, function);
	TRY(world_upload(world));
	int found = 0, count = 0;
	TRY(world_note(world, told_count(&world->pipeline, world->bodies.used, &found)));
	Told* rows = world_scratch(world, (size_t)found * sizeof *rows);
	size_t bytes = (size_t)found * list->moved_size;
	if (bytes > INT32_MAX || (found > 0 && !rows))
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d bodies", function, found);
	TRY(GROW(function, world->moved, world->moved_capacity, (int)bytes));
	TRY(world_note(world, told_list(&world->pipeline, world->bodies.used, found)));
	if (found > 0)
		TRY(world_read(world, POOL_told_row, 0, found, rows));
	for (int k = 0; k < found; ++k)
	{
		if (!slots_in_use(&world->bodies, rows[k].body))
			continue;
		scree_moved row;
		memset(&row, 0, sizeof row);
		moved_fill(world, rows + k, &row);
		write_result(world->moved + list->moved_size * (size_t)count++, list->moved_size, &row, sizeof row);
	}
	scree_moved_list result = {.size = list->size,
	                           .moved_size = list->moved_size,
	                           .count = count,
	                           .moved = (const scree_moved*)(const void*)world->moved};
	write_result(list, result.size, &result, sizeof result);
	return SCREE_OK;
}
