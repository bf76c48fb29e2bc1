// SPDX-License-Identifier: MIT
// counters.c -- returns counters and timings of the last step.
#include "platform/processor.h"
#include "step/state_readback.h"
#include "world/definition.h"
#include "world/failure.h"
#include "world/pool_read.h"
#include "world/record/api_calls.h"
#include "world/upload/upload.h"
#include "world/world.h"

scree_status api_world_get_counters_sized(scree_world* world, scree_counters* counters, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_counters";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "counters", counters));
	int asleep = 0, touching = 0;
	if (world->def.sleep)
	{
		TRY(world_upload(world));
		TRY(world_note(world, pipeline_count_sleep(&world->pipeline, world->bodies.used, &asleep, &touching)));
	}
	// the end of a step changes some counters after the host has read them
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	const Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	scree_counters now = {.bodies = world->bodies.alive,
	                      .dynamic_bodies = world->dynamic_bodies,
	                      .collidables = world->collidables.alive,
	                      .attributes = world->attribute_slots.alive,
	                      .contacts = c->alive - c->released,
	                      .touching = c->touching + touching,
	                      .spokes = c->layout[CONSTRAINT_CONTACT].count[COLORS],
	                      .updated_boxes = c->updated_boxes,
	                      .new_contacts = c->created,
	                      .reallocations = pipeline->grown,
	                      .frozen_bodies = c->nonfinite,
	                      .stopped_bodies = c->held,
	                      .penetration = bits_float(c->penetration),
	                      .steps = pipeline->steps,
	                      .device_bytes = world->backend->bytes,
	                      .joint_gap = bits_float(c->joint_gap),
	                      .asleep_bodies = asleep};
	for (int color = 0; color < COLORS; ++color)
	{
		bool used = false;
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
			used |= c->layout[kind].count[color] > 0;
		now.colors += used;
	}
	write_result(counters, size, &now, sizeof now);
	return SCREE_OK;
}

scree_status api_world_get_timings_sized(scree_world* world, scree_timings* timings, size_t size)
{
	FLOAT_MODE_HERE;
	const char* function = "scree_world_get_timings";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "timings", timings));
	scree_timings now = {0};
	const double* times = world->pipeline.stage_times;
	if (world->def.timings)
	{
		now.step = (float)world->pipeline.milliseconds;
		now.queries = (float)world->pipeline.query_milliseconds;
#define X(name) now.name = (float)times[STAGE_##name];
#include "stages/stages.def"
#undef X
	}
	write_result(timings, size, &now, sizeof now);
	return SCREE_OK;
}
