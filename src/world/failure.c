// SPDX-License-Identifier: MIT
// failure.c -- records that a world is broken. A broken world can only be destroyed.
#include "world/failure.h"
#include "world/check.h"
#include "world/world.h"

scree_status world_check(const scree_world* world, const char* function)
{
	TRY(check_pointer(function, "world", world));
	if (world->broken)
		return fail(world->broken, "%s: %s; the world can only be destroyed", function,
		            world->broken == SCREE_ERROR_DEVICE_FAILED
		                ? "the device of this world has failed"
		                : "a step of this world failed because memory was exhausted");
	return SCREE_OK;
}

scree_status world_note(scree_world* world, scree_status status)
{
	if (status == SCREE_ERROR_DEVICE_FAILED)
		world->broken = status;
	return status;
}
