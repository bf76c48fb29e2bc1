// SPDX-License-Identifier: MIT
// world_snapshot.c -- writes, restores, clones and compares worlds.
#include "platform/processor.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/recovery/recovery.h"
#include "world/snapshot/compare.h"
#include "world/snapshot/restore.h"
#include "world/snapshot/snapshot.h"

scree_status api_world_snapshot(scree_world* world, const void** bytes, size_t* size)
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

scree_status api_world_restore(scree_world* world, const void* bytes, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_restore";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "bytes", bytes));
	return snapshot_restore(world, function, bytes, size);
}

scree_status api_world_create_from(const scree_world_def* def, const void* bytes, size_t size, scree_world** world)
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
		status = recovery_begin(made, function);
	if (status == SCREE_OK)
		*world = made;
	else
		scree_world_destroy(made);
	return status;
}

scree_status api_world_clone(scree_world* world, const scree_world_def* def, scree_world** clone)
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

scree_status api_snapshots_compare_sized(const void* a, size_t size_a, const void* b, size_t size_b,
                                         scree_difference* differences, size_t size, int capacity, int* count)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_snapshots_compare";
	TRY(check_pointer(function, "a", a));
	TRY(check_pointer(function, "b", b));
	TRY(check_list(function, "differences", differences, capacity, count));
	return snapshots_compare(function, a, size_a, b, size_b, differences, size, capacity, count);
}
