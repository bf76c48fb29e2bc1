// SPDX-License-Identifier: MIT
// rescue.c -- makes a world whole again on the CPU, after its device has failed. A new world on the CPU gets the kept state, and the
// calls since are repeated on it. It then takes the place of the broken world.
#include "world/recovery/rescue.h"
#include "platform/error.h"
#include "world/create.h"
#include "world/device/devices.h"
#include "world/record/repeat.h"

// Repeats the calls since the kept state. Their results need no comparison: handles depend on the host alone, and numbers of a
// device that fails may be wrong.
static scree_status repeat_records(scree_world* made, const char* function, const KeptState* kept,
                                   const FileLists* lists, CallArguments* arguments)
{
	ByteReader reader = {kept->calls.bytes, kept->calls.bytes + kept->calls.used};
	for (int k = 0; k < kept->count; ++k)
	{
		LogRecord record;
		log_again(&reader, &record);
		if (record.number == RECORD_MOVED)
		{
			scree_moved_bodies list;
			TRY(scree_world_get_moved_bodies(made, &list));
			continue;
		}
		TRY(call_read(function, lists, &record, arguments));
		TRY(call_repeat(made, arguments));
	}
	return SCREE_OK;
}

static scree_status repeat_calls(scree_world* made, const char* function, const KeptState* kept)
{
	if (kept->count == 0)
		return SCREE_OK;
	ChunkWriter written = {0};
	FileLists lists = {0};
	CallArguments arguments = {0};
	lists_write(&written);
	scree_status status = SCREE_OK;
	if (written.used == SIZE_MAX)
		status = fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to repeat %d calls", function, kept->count);
	else
		status = lists_read(function, &(ByteReader){written.bytes, written.bytes + written.used}, &lists);
	if (status == SCREE_OK)
		status = repeat_records(made, function, kept, &lists, &arguments);
	arguments_close(&arguments);
	lists_close(&lists);
	scree_release(written.bytes);
	return status;
}

// Makes the world on the CPU. It borrows the saves of the broken world; on failure it gives them back.
static scree_status remake(scree_world* world, const char* function, const KeptState* kept, scree_world** made)
{
	scree_world_def def = world->def;
	def.device = "cpu";
	Backend* cpu;
	TRY(device_open(&def, NULL, &cpu));
	scree_status status = world_create(&def, cpu, made);
	if (status != SCREE_OK)
	{
		cpu->f->close(cpu);
		return status;
	}
	(*made)->saves = world->saves;
	world->saves = (Saves){0};
	status = kept_state_bring(kept, function, *made);
	if (status == SCREE_OK)
		status = repeat_calls(*made, function, kept);
	if (status == SCREE_OK)
		return SCREE_OK;
	world->saves = (*made)->saves;
	(*made)->saves = (Saves){0};
	world_destroy(*made);
	return status;
}

#define EXCHANGE(type, a, b) \
	do                       \
	{                        \
		type other = (a);    \
		(a) = (b);           \
		(b) = other;         \
	} while (0)

// Exchanges two worlds, apart from what the user or the library has in hand: recordings, the snapshot, lists that calls returned.
static void exchange(scree_world* world, scree_world* made)
{
	const AutoDevice* a = &world->auto_device;
	if (a->on) // the world stays on the CPU
		made->auto_device = (AutoDevice){.on = true, .alone = true, .test = a->test};
	EXCHANGE(scree_world, *world, *made);
	EXCHANGE(ChunkWriter, world->snapshot, made->snapshot);
	EXCHANGE(Recorders, world->recorders, made->recorders);
	EXCHANGE(struct Recovery*, world->recovery, made->recovery);
	EXCHANGE(struct Readers*, world->readers, made->readers);
	EXCHANGE(char*, world->reports.rows, made->reports.rows);
	EXCHANGE(int, world->reports.rows_capacity, made->reports.rows_capacity);
	EXCHANGE(char*, world->moved, made->moved);
	EXCHANGE(int, world->moved_capacity, made->moved_capacity);
	EXCHANGE(UnitShapes, world->unit_shapes, made->unit_shapes);
	world->def.device = world->device;
	if (world->def.opengl)
		world->def.opengl = &world->opengl;
	if (world->def.tasks)
		world->def.tasks = &world->tasks;
}

scree_status world_rescue(scree_world* world, const char* function, const KeptState* kept)
{
	Sentence cause = sentence_keep();
	scree_world* made;
	scree_status status = remake(world, function, kept, &made);
	if (status != SCREE_OK)
	{
		Sentence why = sentence_keep();
		return fail(world->broken, "%.400s; the world cannot go on on the CPU: %.400s", cause.text, why.text);
	}
	log_sentence(SCREE_LOG_WARNING,
	             "%s: %s fails: %s; the world goes on on the CPU, with the state of step %lld and %d calls since",
	             function, world->device, cause.text, (long long)kept->step, kept->count);
	exchange(world, made);
	world_destroy(made);
	return SCREE_OK;
}
