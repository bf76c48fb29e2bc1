// SPDX-License-Identifier: MIT
// counters.c -- counters and timings of the last step.
#include "world/definition.h"
#include "world/failure.h"
#include "world/pool_read.h"
#include "world/world.h"

scree_status scree_world_get_counters_sized(scree_world* world, scree_counters* counters, size_t size)
{
	const char* function = "scree_world_get_counters";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "counters", counters));
	// the end of a step changes some counters after the host has read them
	TRY(world_read(world, POOL_counters, 0, 1, &world->pipeline.counters));
	const Pipeline* pipeline = &world->pipeline;
	const Counters* c = &pipeline->counters;
	scree_counters now = {.bodies = world->bodies.alive,
	                      .dynamic_bodies = world->dynamic_bodies,
	                      .collidables = world->collidables.alive,
	                      .attributes = world->attribute_slots.alive,
	                      .contacts = c->alive - c->released,
	                      .touching = c->touching,
	                      .spokes = c->layout[CONSTRAINT_CONTACT].count[COLORS],
	                      .moved = c->moved,
	                      .new_contacts = c->created,
	                      .grown = pipeline->grown,
	                      .nonfinite = c->nonfinite,
	                      .held = c->held,
	                      .penetration = bits_float(c->penetration),
	                      .steps = pipeline->steps,
	                      .device_bytes = world->backend->bytes,
	                      .joint_gap = bits_float(c->joint_gap)};
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

scree_status scree_world_get_timings_sized(scree_world* world, scree_timings* timings, size_t size)
{
	const char* function = "scree_world_get_timings";
	TRY(world_check(world, function));
	TRY(check_pointer(function, "timings", timings));
	scree_timings now = {0};
	const double* boxes = world->pipeline.boxes;
	if (world->def.timings)
		now = (scree_timings){.step = (float)world->pipeline.milliseconds,
		                      .transform = (float)boxes[BOX_transform],
		                      .broad_phase = (float)boxes[BOX_broad_phase],
		                      .narrow_phase = (float)boxes[BOX_narrow_phase],
		                      .color = (float)boxes[BOX_color],
		                      .solve = (float)boxes[BOX_solve],
		                      .finalize = (float)boxes[BOX_finalize],
		                      .queries = (float)world->pipeline.query_milliseconds};
	write_result(timings, size, &now, sizeof now);
	return SCREE_OK;
}
