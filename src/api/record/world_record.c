// SPDX-License-Identifier: MIT
// world_record.c -- begins and ends the recording of a world.
#include "platform/processor.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/record/recorder.h"
#include "world/world.h"

void scree_record_def_default_sized(scree_record_def* def, size_t size)
{
	const scree_record_def made = {.size = (uint32_t)size, .hash_interval = 60};
	write_result(def, size, &made, sizeof made);
}

scree_status api_world_record(scree_world* world, const scree_record_def* def)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_record";
	ArgumentPlace at = {function, "def", ALONE};
	scree_record_def local, standard = scree_record_def_default();
	TRY(world_check(world, function));
	def = def ? def : &standard;
	TRY(check_definition(at, def, 0, &record_definition));
	def = definition_at(def, 0, &record_definition, &local);
	if (def->hash_interval < 0)
		return refuse(SCREE_ERROR_INVALID, at, ".hash_interval", "is %d, must be at least 0", def->hash_interval);
	Recorder* before = world->recorders.own;
	if (before && !before->ended)
		return fail(SCREE_ERROR_INVALID, "%s: world is already recorded; scree_world_end_recording ends a recording",
		            function);
#ifdef SCREE_SMALL
	return fail(SCREE_ERROR_NOT_SUPPORTED, "%s: this build repeats recordings, but makes none", function);
#else
	Recorder* made;
	TRY(recorder_open(world, function, def->path, def->hash_interval, &made));
	recorder_free(before);
	world->recorders.own = made;
	return SCREE_OK;
#endif
}

scree_status api_world_end_recording(scree_world* world)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_end_recording";
	TRY(check_pointer(function, "world", world));
	if (!world->recorders.own || world->recorders.own->ended)
		return fail(SCREE_ERROR_INVALID, "%s: world is not recorded", function);
	return recorder_end(world, world->recorders.own, function, true);
}

scree_status api_world_get_recording(const scree_world* world, const void** bytes, size_t* size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_recording";
	TRY(check_pointer(function, "world", world));
	TRY(check_pointer(function, "bytes", bytes));
	TRY(check_pointer(function, "size", size));
	const Recorder* recorder = world->recorders.own;
	if (!recorder || recorder->path)
		return fail(SCREE_ERROR_INVALID, "%s: world has no recording in memory", function);
	*bytes = recorder->written.bytes;
	*size = recorder->written.used;
	return SCREE_OK;
}
