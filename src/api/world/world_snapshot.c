// SPDX-License-Identifier: MIT
// world_snapshot.c -- writes, restores and clones worlds.
#include "platform/processor.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/snapshot/restore.h"
#include "world/snapshot/snapshot.h"

scree_status scree_world_snapshot(scree_world* world, const void** bytes, size_t* size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_snapshot";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "bytes", bytes));
	TRY(check_pointer(function, "size", size));
	TRY(snapshot_write(world, function, &world->snapshot));
	*bytes = world->snapshot.bytes;
	*size = world->snapshot.used;
	return SCREE_OK;
}

scree_status scree_world_restore(scree_world* world, const void* bytes, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_restore";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "bytes", bytes));
	return snapshot_restore(world, function, bytes, size);
}

scree_status scree_world_create_from(const scree_world_def* def, const void* bytes, size_t size, scree_world** world)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_create_from";
	TRY(check_pointer(function, "world", world));
	*world = NULL;
	TRY(check_pointer(function, "bytes", bytes));
	scree_world* made;
	TRY(scree_world_create(def, &made));
	scree_status status = snapshot_restore(made, function, bytes, size);
	if (status == SCREE_OK)
		*world = made;
	else
		scree_world_destroy(made);
	return status;
}

scree_status scree_world_clone(scree_world* world, const scree_world_def* def, scree_world** clone)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_clone";
	TRY(check_pointer(function, "clone", clone));
	*clone = NULL;
	TRY(world_check(world, function));
	scree_world_def same = world->def;
	same.opengl = NULL; // memory is shared by one world
	if (world->auto_device.on)
		same.device = "auto";
	const void* bytes;
	size_t size;
	TRY(scree_world_snapshot(world, &bytes, &size));
	return scree_world_create_from(def ? def : &same, bytes, size, clone);
}
