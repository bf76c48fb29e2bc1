// SPDX-License-Identifier: MIT
// failure.c -- records that a world is broken. A broken world can only be destroyed.
#include "world/failure.h"
#include "world/check.h"
#include "world/world.h"

scree_status world_check(const scree_world* world, const char* function)
{
	TRY(check_pointer(function, "world", world));
	if (world->drawing)
		return fail(SCREE_ERROR_INVALID, "%s: a function that draws for scree_world_draw must not use its world",
		            function);
	if (!world->broken)
		return SCREE_OK;
	bool device = world->broken == SCREE_ERROR_DEVICE_FAILED;
	const char* cause =
	    device ? "the device of this world has failed" : "a step of this world failed because memory was exhausted";
	if (world->recovery) // world_recovers has the consequence
		return fail(world->broken, "%s: %s", function, cause);
	return fail(world->broken, "%s: %s; the world can only be destroyed%s", function, cause,
	            device ? "; with scree_world_def.recovery_interval it would have gone on on the CPU" : "");
}

scree_status world_note(scree_world* world, scree_status status)
{
	if (status == SCREE_ERROR_DEVICE_FAILED)
		world->broken = status;
	return status;
}
