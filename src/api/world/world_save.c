// SPDX-License-Identifier: MIT
// world_save.c -- saves a world in the memory of its device, and loads it again.
#include "platform/processor.h"
#include "world/check.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/save/saves.h"

static scree_status check_save(const char* function, int save)
{
	if (save < 0 || save >= SCREE_SAVES)
		return fail(SCREE_ERROR_INVALID, "%s: save is %d, must be from 0 to %d", function, save, SCREE_SAVES - 1);
	return SCREE_OK;
}

static scree_status check_number(scree_world* world, const char* function, int save)
{
	TRY(world_check(world, function));
	return check_save(function, save);
}

scree_status api_world_save(scree_world* world, int save)
{
	FLOAT_MODE_HERE;
	TRY(check_number(world, "scree_world_save", save));
	return world_save(world, "scree_world_save", save);
}

scree_status api_world_load(scree_world* world, int save)
{
	FLOAT_MODE_HERE;
	TRY(check_number(world, "scree_world_load", save));
	return world_load(world, "scree_world_load", save, false);
}

scree_status api_world_discard(scree_world* world, int save)
{
	FLOAT_MODE_HERE;
	TRY(check_number(world, "scree_world_discard", save));
	world_discard(world, save);
	return SCREE_OK;
}

scree_status api_world_get_save_bytes(const scree_world* world, int save, uint64_t* bytes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_save_bytes";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "bytes", bytes));
	TRY(check_save(function, save));
	*bytes = world_save_bytes(world, save);
	return SCREE_OK;
}
