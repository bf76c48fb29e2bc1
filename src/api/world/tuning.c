// SPDX-License-Identifier: MIT
// tuning.c -- reads the definition of a world; reads and sets its tuning.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/tuning_members.h"
#include "world/upload/whole_sleep.h"
#include "world/world.h"
#include <string.h>

scree_status api_world_get_def_sized(const scree_world* world, scree_world_def* def, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_def";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "def", def));
	scree_world_def now = world->def;
	const scree_world_def made = scree_world_def_default();
	now.size = (uint32_t)size;
	now.device = made.device;
	now.opengl = made.opengl;
	now.tasks = made.tasks;
	write_result(def, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status api_world_get_tuning_sized(const scree_world* world, scree_tuning* tuning, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_tuning";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "tuning", tuning));
	scree_tuning now = tuning_of(&world->def);
	now.size = (uint32_t)size;
	write_result(tuning, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status api_world_set_tuning(scree_world* world, const scree_tuning* tuning)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_set_tuning";
	ArgumentPlace at = {function, "tuning", ALONE};
	TRY(world_check(world, function));
	TRY(check_pointer(function, "tuning", tuning));
	TRY(check_definition(at, tuning, 0, &tuning_definition));
	scree_tuning local;
	tuning = definition_at(tuning, 0, &tuning_definition, &local);
	TRY(check_tuning(at, tuning));
	scree_world_def wanted = world->def;
	tuning_copy(&wanted, tuning);
	if (memcmp(&wanted, &world->def, sizeof wanted) == 0)
		return SCREE_OK; // so that a call in each step keeps no body awake
	TRY(world_set_awake(world, true));
	world->pipeline.sleeps |=
	    world->def.sleep; // bodies that were created asleep since the last step wake in the next one
	world->def = wanted;
	return SCREE_OK;
}
