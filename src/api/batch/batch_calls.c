// SPDX-License-Identifier: MIT
// batch_calls.c -- creates, steps, resets and hashes batches for the user.
#include "api/batch/batch_check.h"
#include "api/world/device_test.h"
#include "batch/channel_rows.h"
#include "platform/processor.h"
#include "step/bay_layout.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/record/api_calls.h"
#include "world/units/scale.h"
#include <stddef.h>
#include <string.h>

static const DefinitionType batch_definition = {
    sizeof(scree_batch_def), offsetof(scree_batch_def, timings) + sizeof(bool), "scree_batch_def_default"};

void scree_batch_def_default_sized(scree_batch_def* def, size_t size)
{
	scree_batch_def made = {.worlds = 1, .device = "cpu"};
	if (!def)
		return;
	write_result(def, size, &made, sizeof made);
	def->size = (uint32_t)size;
}

static scree_status check_templates(const char* function, const scree_batch_def* def)
{
	ArgumentPlace at = {function, "def", ALONE};
	if (def->template_count < 1)
		return refuse(SCREE_ERROR_INVALID, at, ".template_count", "is %d, must be at least 1", def->template_count);
	TRY(check_pointer(function, "def.templates", def->templates));
	for (int t = 0; t < def->template_count; ++t)
	{
		if (!def->templates[t])
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "def.templates", t}, "", "is null");
		TRY(world_check(def->templates[t], function));
	}
	for (int k = 0; def->template_of && k < def->worlds; ++k)
		if (def->template_of[k] < 0 || def->template_of[k] >= def->template_count)
			return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "def.template_of", k}, "",
			              "is %d, must be from 0 to %d", def->template_of[k], def->template_count - 1);
	return SCREE_OK;
}

static scree_status check_def(const char* function, const scree_batch_def* def)
{
	ArgumentPlace at = {function, "def", ALONE};
	if (def->worlds < 1 || def->worlds > MAX_ITEMS)
		return refuse(SCREE_ERROR_INVALID, at, ".worlds", "is %d, must be from 1 to %d", def->worlds, MAX_ITEMS);
	TRY(check_device(at, ".device", def->device));
	if (strcmp(def->device, "auto") == 0)
		return refuse(SCREE_ERROR_INVALID, at, ".device", "is \"auto\", which worlds of a batch cannot have yet");
	if (def->threads < 0 || def->threads > MAX_WORKERS)
		return refuse(SCREE_ERROR_INVALID, at, ".threads", "is %d, must be from 0 to %d", def->threads, MAX_WORKERS);
	TRY(check_lanes(at, ".lanes", def->lanes));
	if (def->contact_limit < 0 || def->contact_limit > MOST_BAY_ITEMS)
		return refuse(SCREE_ERROR_INVALID, at, ".contact_limit", "is %d, must be from 0 to %d", def->contact_limit,
		              MOST_BAY_ITEMS);
	if (!(def->device_timeout >= 0.0f))
		return refuse(SCREE_ERROR_INVALID, at, ".device_timeout", "is %s, must be from 0 to INFINITY",
		              decimal(def->device_timeout).text);
	return check_templates(function, def);
}

scree_status api_batch_create(const scree_batch_def* def, scree_batch** batch)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_create";
	TRY(check_pointer(function, "batch", batch));
	*batch = NULL;
	TRY(check_pointer(function, "def", def));
	TRY(check_definition((ArgumentPlace){function, "def", ALONE}, def, 0, &batch_definition));
	scree_batch_def local;
	def = definition_at(def, 0, &batch_definition, &local);
	TRY(check_def(function, def));
#ifndef SCREE_SMALL // a build for WebAssembly has no self test
	TRY(cpu_self_test(function));
#endif
	return batch_create(def, function, TEST_WORLDS, batch);
}

void scree_batch_destroy(scree_batch* batch)
{
	FLOAT_MODE_HERE;
	batch_destroy(batch);
}

scree_status api_batch_set_templates(scree_batch* batch, const int32_t* template_of)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_set_templates";
	TRY(batch_check(batch, function));
	TRY(check_pointer(function, "template_of", template_of));
	if (!batch->next_of)
		return fail(SCREE_ERROR_INVALID, "%s: the batch was created without scree_batch_def.other_templates", function);
	for (int k = 0; k < batch->worlds; ++k)
	{
		ArgumentPlace at = {function, "template_of", k};
		if (template_of[k] < 0 || template_of[k] >= batch->template_count)
			return refuse(SCREE_ERROR_INVALID, at, "", "is %d, must be from 0 to %d", template_of[k],
			              batch->template_count - 1);
		if (!template_fits(batch->templates + template_of[k], batch->templates + batch->template_of[k]))
			return refuse(SCREE_ERROR_INVALID, at, "", "is %d, whose tuning is not that of template %d", template_of[k],
			              batch->template_of[k]);
	}
	memcpy(batch->next_of, template_of, sizeof(int) * (size_t)batch->worlds);
	return SCREE_OK;
}

typedef struct // rows of inputs to check
{
	const char* function;
	const ChannelSet* set;
	int list;
	const uint8_t* mask; // as in channels_check
} InputCheck;

#define CHECKED_ALONE 65536 // number of values that one thread checks in less time than it takes to wake others

// Checks as many rows as the block has worlds, in the order of the user.
static scree_status check_block(Block* block, const void* context)
{
	const InputCheck* check = context;
	return channels_check(check->set, check->function, check->set->memory, block->first, block->worlds, check->mask);
}

static scree_status check_rows(scree_batch* batch, const InputCheck* check)
{
	const ChannelSet* set = check->set;
	if ((int64_t)set->columns * batch->worlds > CHECKED_ALONE)
		return batch_each(batch, check_block, check);
	return channels_check(set, check->function, set->memory, 0, batch->worlds, check->mask);
}

static scree_status check_masses(Block* block, const void* context)
{
	const InputCheck* check = context;
	return block_check_masses(block, check->list, check->mask, check->function);
}

static scree_status check_shared(Block* block, const void* context)
{
	return block_check_shared(block, ((const InputCheck*)context)->function);
}

static scree_status check_inputs(scree_batch* batch, const char* function, int list, const uint8_t* mask)
{
	InputCheck check = {function, batch->sets + list, list, mask};
	if (check.set->shared)
		return batch_note_device(batch, batch_each(batch, check_shared, &check));
	if (check.set->columns > 0)
		TRY(check_rows(batch, &check));
	return check.set->masses ? batch_each(batch, check_masses, &check) : SCREE_OK;
}

typedef struct
{
	float dt;
	int substeps, steps;
} StepWork;

static scree_status step_block(Block* block, const void* context)
{
	const StepWork* step = context;
	return block_step(block, step->dt, step->substeps, step->steps);
}

// Logs the first world that was paused because of its contacts. Counters tell of the others.
static void warn_crowded(scree_batch* batch, const char* function)
{
	for (int k = 0; k < batch->block_count && !batch->warned; ++k)
	{
		const Block* block = batch->blocks + k;
		batch->warned = block->crowded > 0;
		if (batch->warned)
			log_sentence(
			    SCREE_LOG_WARNING,
			    "%s: world %d was paused, because it would have more than %d contacts; there is no warning for "
			    "further worlds, but scree_batch_counters.crowded",
			    function, block_world(block, block->first_crowded), block->pipeline.bay_limit);
	}
}

scree_status api_batch_step(scree_batch* batch, float dt, int substeps, int steps)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_step";
	TRY(batch_check(batch, function));
	TRY(check_step(function, dt, substeps));
	if (steps < 0)
		return refuse(SCREE_ERROR_INVALID, (ArgumentPlace){function, "steps", ALONE}, "", "is %d, must be at least 0",
		              steps);
	if (steps > 0)
		TRY(check_inputs(batch, function, CHANNELS_STEP, NULL));
	StepWork work = {dt, substeps, steps};
	double begin = batch->timings && steps > 0 ? processor_milliseconds() : 0.0;
	TRY(batch_note(batch, batch_each(batch, step_block, &work)));
	batch->backwards = !batch->backwards;
	if (batch->timings && steps > 0)
		batch->milliseconds = processor_milliseconds() - begin;
	warn_crowded(batch, function);
	return SCREE_OK;
}

static scree_status reset_block(Block* block, const void* context) { return block_reset(block, context); }

scree_status api_batch_reset(scree_batch* batch, const uint8_t* mask)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_reset";
	TRY(batch_check(batch, function));
	TRY(check_inputs(batch, function, CHANNELS_RESET, mask));
	return batch_note(batch, batch_each(batch, reset_block, mask));
}

typedef struct
{
	uint64_t* hashes;
} HashWork;

static scree_status hash_block(Block* block, const void* context)
{
	return block_hash(block, ((const HashWork*)context)->hashes);
}

scree_status api_batch_get_hashes(scree_batch* batch, uint64_t* hashes)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_get_hashes";
	TRY(batch_check(batch, function));
	TRY(check_pointer(function, "hashes", hashes));
	HashWork work = {hashes};
	return batch_note(batch, batch_each(batch, hash_block, &work));
}

static scree_status pause_block(Block* block, const void* context) { return block_pause(block, context); }

scree_status api_batch_pause(scree_batch* batch, const uint8_t* mask)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_pause";
	TRY(batch_check(batch, function));
	return batch_note(batch, batch_each(batch, pause_block, mask));
}

typedef struct
{
	BayCounters* counters;
} CountersWork;

static scree_status read_counters(Block* block, const void* context)
{
	return block_counters(block, ((const CountersWork*)context)->counters);
}

scree_status api_batch_get_counters_sized(scree_batch* batch, scree_batch_counters* counters, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_get_counters";
	TRY(batch_check(batch, function));
	TRY(check_pointer(function, "counters", counters));
	BayCounters* rows = scree_allocate(sizeof *rows * (size_t)batch->worlds);
	if (!rows)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for %d worlds", function, batch->worlds);
	CountersWork work = {rows};
	scree_status status = batch_note(batch, batch_each(batch, read_counters, &work));
	for (int k = 0; k < batch->worlds && status == SCREE_OK; ++k)
	{
		scree_batch_counters now = {.crowded = rows[k].crowded,
		                            .frozen_bodies = rows[k].nonfinite,
		                            .contacts = rows[k].contacts,
		                            .touching = rows[k].touching,
		                            .penetration = rows[k].penetration,
		                            .joint_gap = rows[k].joint_gap,
		                            .asleep_bodies = rows[k].asleep};
		float unit = batch->templates[batch->template_of[k]].world->def.length_unit;
		if (unit != 0.0f)
		{
			units_scale((double)unit, (char*)&now.penetration, 1, 1, TO_UNITS);
			units_scale((double)unit, (char*)&now.joint_gap, 1, 1, TO_UNITS);
		}
		write_result((char*)counters + size * (size_t)k, size, &now, sizeof now);
	}
	scree_release(rows);
	return status;
}

scree_status api_batch_get_timings_sized(scree_batch* batch, scree_timings* timings, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_batch_get_timings";
	TRY(batch_check(batch, function));
	TRY(check_pointer(function, "timings", timings));
	scree_timings now = {.step = (float)batch->milliseconds};
	for (int k = 0; k < batch->block_count && batch->timings; ++k)
	{
		const double* times = batch->blocks[k].pipeline.stage_times;
#define X(name) now.name += (float)times[STAGE_##name];
#include "stages/stages.def"
#undef X
	}
	write_result(timings, size, &now, sizeof now);
	return SCREE_OK;
}

int scree_batch_get_worlds(const scree_batch* batch) { return batch ? batch->worlds : 0; }
