// SPDX-License-Identifier: MIT
// upload.c -- uploads the user's changes: long sequences of rows first, then commands.
#include "world/upload/upload.h"
#include "platform/error.h"
#include "platform/zones.h"
#include "step/reserve.h"
#include "world/chain/chains.h"
#include "world/device/auto.h"
#include "world/device/idle.h"
#include "world/device/touched.h"
#include "world/failure.h"
#include "world/memory.h"
#include "world/objects/exclusions.h"
#include "world/objects/fields.h"
#include "world/objects/joints.h"
#include "world/objects/mass.h"
#include "world/objects/materials.h"
#include "world/objects/paths.h"
#include "world/objects/reports.h"
#include "world/structure.h"
#include "world/upload/edit_order.h"
#include "world/upload/upload_commands.h"
#include "world/upload/upload_rows.h"
#include "world/world.h"

typedef struct // memory that an upload needs
{
	int body_rows, collidable_rows; // number of rows in the longest sequence with at least LONG_RUN rows, else 0
	int commands;                   // upper bound of the number of commands
} Demand;

static Demand demand_of(const scree_world* world)
{
	const Edits* p = &world->edits;
	Demand demand = {.commands = p->command_count};
	for (int k = 0, end; k < p->body_count; k = end)
	{
		end = body_run(p, k);
		if (end - k < LONG_RUN)
			demand.commands += BODY_COMMANDS * (end - k);
		else
			demand.body_rows = end - k > demand.body_rows ? end - k : demand.body_rows;
	}
	for (int k = 0, end; k < p->collidable_count; k = end)
	{
		end = collidable_run(world, k);
		if (end - k < LONG_RUN)
			demand.commands += COLLIDABLE_COMMANDS * (end - k);
		else
			demand.collidable_rows = end - k > demand.collidable_rows ? end - k : demand.collidable_rows;
	}
	return demand;
}

static size_t larger(size_t a, size_t b) { return a > b ? a : b; }

static scree_status reserve(scree_world* world, const Demand* demand, char** memory)
{
	TRY(pipeline_reserve(&world->pipeline, PER_ATTRIBUTE, world->attribute_slots.used));
	TRY(pipeline_reserve(&world->pipeline, PER_BODY, world->bodies.used));
	TRY(pipeline_reserve(&world->pipeline, PER_COLLIDABLE, world->collidables.used));
	TRY(pipeline_reserve(&world->pipeline, PER_COMMAND, demand->commands + 1));
	if (world->edits.path_count > 0)
		TRY(pipeline_reserve(&world->pipeline, PER_PATH_SAMPLE, world->sample_end));
	if (world->edits.joint_count > 0)
	{
		TRY(pipeline_reserve(&world->pipeline, PER_JOINT, world->joints.used + 1));
		TRY(pipeline_reserve(&world->pipeline, PER_JOINT_EDIT, world->edits.joint_count));
	}
	size_t bytes = (size_t)world->edits.attribute_count * sizeof(Attribute);
	bytes = larger(bytes, (size_t)world->edits.joint_count * sizeof(JointEdit));
	bytes = larger(bytes, (size_t)demand->body_rows * largest_row(PER_BODY));
	bytes = larger(bytes, (size_t)demand->collidable_rows * largest_row(PER_COLLIDABLE));
	bytes = larger(bytes, (size_t)demand->commands * (2 * sizeof(Command) + sizeof(int)) + sizeof(int));
	*memory = world_scratch(world, bytes);
	if (!*memory)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "no memory to upload %zu bytes of changes", bytes);
	return SCREE_OK;
}

// Returns whether any edit creates, destroys or moves a body or a collidable, so that boxes may jump.
static bool places(const Edits* p)
{
	bool found = p->body_count + p->collidable_count > 0;
	for (int k = 0; k < p->command_count && !found; ++k)
		found = p->commands[k].kind == COMMAND_POSE || p->commands[k].kind == COMMAND_PLACE;
	return found;
}

static scree_status upload_long_runs(scree_world* world, char* memory)
{
	const Edits* p = &world->edits;
	for (int k = 0, end; k < p->body_count; k = end)
	{
		end = body_run(p, k);
		if (end - k >= LONG_RUN)
			TRY(upload_bodies(world, k, end, memory));
	}
	for (int k = 0, end; k < p->collidable_count; k = end)
	{
		end = collidable_run(world, k);
		if (end - k >= LONG_RUN)
			TRY(upload_collidables(world, k, end, memory));
	}
	return SCREE_OK;
}

static void clear(scree_world* world)
{
	Edits* p = &world->edits;
	for (int k = 0; k < p->body_count; ++k)
		world->host_bodies[p->bodies[k].index].waiting.row = 0;
	for (int k = 0; k < p->collidable_count; ++k)
		world->host_collidables[p->collidables[k].index].waiting.row = 0;
	for (int k = 0; k < p->attribute_count; ++k)
		world->host_attributes[p->attributes[k]].waiting = false;
	for (int k = 0; k < p->joint_count; ++k)
	{
		HostJoint* host = world->host_joints + p->joints[k];
		host->waiting = host->restarts = host->rechained = host->created = host->seeks = host->counts = false;
	}
	for (int k = 0; k < p->path_count; ++k)
		world->host_paths[p->paths[k]].waiting = false;
	p->body_count = p->collidable_count = p->command_count = 0;
	p->attribute_count = p->joint_count = p->path_count = 0;
}

static bool no_edits(const Edits* p)
{
	return p->body_count + p->collidable_count + p->command_count == 0 &&
	       p->attribute_count + p->joint_count + p->path_count == 0;
}

static scree_status upload_all(scree_world* world, bool steps)
{
	if (steps)
		TRY(chains_update(world)); // adds an edit for each joint whose spot changed
	structure_note(world);
	TRY(upload_fields(world));
	TRY(upload_materials(world));
	TRY(upload_exclusions(world));
	if (no_edits(&world->edits))
		return SCREE_OK;
	idle_note(world);
	TRY(edits_sort(world));
	Demand demand = demand_of(world);
	char* memory;
	TRY(touched_collect(world));
	TRY(reserve(world, &demand, &memory)); // reserves all memory first, so that a failure leaves the device unchanged
	world->pipeline.jumps |= places(&world->edits);
	TRY(touched_upload(world));
	TRY(upload_attributes(world, memory));
	TRY(upload_long_runs(world, memory));
	TRY(upload_commands(world, demand.commands, memory));
	TRY(upload_paths(world));
	TRY(upload_joints(world, memory));
	clear(world);
	return SCREE_OK;
}

static scree_status upload(scree_world* world, bool steps)
{
	mass_settle(world);
	bool chains = steps && world->chains_stale;
	if (no_edits(&world->edits) && !chains && !world->materials.waiting && !world->exclusions.waiting &&
	    !world->fields.stale)
		return SCREE_OK;
	world->pipeline.edited = true;
	TRY(reports_fetch(world)); // reads the events first, because an upload may change the items to which they refer
	world->pipeline.trees[0].seen = false;
	ZONE_BEGIN(zone, "scree: upload");
	double begin = auto_clock();
	scree_status status = world_note(world, upload_all(world, steps));
	auto_count(world, begin);
	ZONE_END(zone);
	return status;
}

scree_status world_upload(scree_world* world) { return upload(world, false); }
scree_status world_upload_to_step(scree_world* world) { return upload(world, true); }
