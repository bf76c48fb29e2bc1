// SPDX-License-Identifier: MIT
// lab_scree.c -- Scree as the engine of a lab.
#include "lab.h"
#include <stdio.h>
#include <stdlib.h>

typedef struct
{
	scree_world* world;
	scree_body* bodies; // by their index in the lab
	int count;
	scree_body* some; // handles of a batch
	int room;
} State;

static bool report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree validate: %s\n", scree_error());
	return status == SCREE_OK;
}

static void* open(const LabOptions* options, const LabDef* lab)
{
	State* state = calloc(1, sizeof(State));
	if (!state)
		return NULL;
	scree_world_def def = scree_default_world_def();
	def.gravity = lab->gravity;
	def.max_speed = lab->max_speed;
	def.device = options->device;
	def.threads = options->threads;
	def.lanes = options->lanes;
	def.allow_unequal_bits = options->allow_unequal_bits;
	if (report(scree_create_world(&def, &state->world)))
		return state;
	free(state);
	return NULL;
}

static void close(void* context)
{
	State* state = context;
	scree_destroy_world(state->world);
	free(state->bodies);
	free(state->some);
	free(state);
}

static bool create_one(State* state, const Lab* lab, int index)
{
	const LabBody* body = &lab->bodies[index];
	scree_body_def def = body->def;
	if (!report(scree_create_body(state->world, &def, &state->bodies[index])))
		return false;
	for (int k = 0; k < body->count; ++k)
	{
		const LabPart* part = &lab->parts[body->first + k];
		scree_collidable_def collidable = scree_default_collidable_def();
		collidable.body = state->bodies[index];
		collidable.filter = part->filter;
		if (!report(scree_create_attribute(state->world, &part->surface, &collidable.attribute)) ||
		    !report(scree_create_collidable(state->world, &collidable, NULL)))
			return false;
	}
	// the velocity of the center of mass, wherever that is now
	return report(scree_body_set_velocity(state->world, state->bodies[index], def.velocity));
}

static bool create(void* context, const Lab* lab, int first, int count)
{
	State* state = context;
	scree_body* bodies = realloc(state->bodies, (size_t)(first + count) * sizeof *bodies);
	if (!bodies)
		return false;
	state->bodies = bodies;
	state->count = first + count;
	for (int k = first; k < first + count; ++k)
	{
		if (!create_one(state, lab, k))
			return false;
	}
	return true;
}

static bool gather(State* state, const int* bodies, int count)
{
	if (count > state->room)
	{
		scree_body* some = realloc(state->some, (size_t)count * sizeof *some);
		if (!some)
			return false;
		state->some = some;
		state->room = count;
	}
	for (int k = 0; k < count; ++k)
		state->some[k] = state->bodies[bodies[k]];
	return true;
}

static bool replace(void* context, const Lab* lab, const int* bodies, int count)
{
	State* state = context;
	bool good = gather(state, bodies, count) && report(scree_destroy_bodies(state->world, state->some, count));
	for (int k = 0; k < count && good; ++k)
		good = create_one(state, lab, bodies[k]);
	return good;
}

static bool set_poses(void* context, const int* bodies, const scree_pose* poses, int count)
{
	State* state = context;
	return gather(state, bodies, count) && report(scree_set_poses(state->world, state->some, poses, count));
}

static bool set_velocity(void* context, int body, scree_velocity velocity)
{
	State* state = context;
	return report(scree_body_set_velocity(state->world, state->bodies[body], velocity));
}

static bool push(void* context, int body, scree_vec force)
{
	State* state = context;
	return report(scree_body_apply_force(state->world, state->bodies[body], force));
}

static bool step(void* context, float dt, int substeps, int* frozen)
{
	State* state = context;
	scree_counters counters;
	if (!report(scree_step(state->world, dt, substeps)) || !report(scree_get_counters(state->world, &counters)))
		return false;
	*frozen += counters.nonfinite;
	return true;
}

static bool read(void* context, scree_pose* poses, scree_velocity* velocities)
{
	State* state = context;
	return report(scree_get_poses(state->world, state->bodies, poses, state->count)) &&
	       report(scree_get_velocities(state->world, state->bodies, velocities, state->count));
}

static bool wait(void* context)
{
	State* state = context;
	return report(scree_wait(state->world));
}

static bool hash(void* context, uint64_t* hash)
{
	State* state = context;
	return report(scree_world_hash(state->world, hash));
}

static double bytes(void* context)
{
	State* state = context;
	scree_counters counters;
	return report(scree_get_counters(state->world, &counters)) ? (double)counters.device_bytes : 0.0;
}

bool scree_lab_counters(void* context, scree_counters* counters)
{
	State* state = context;
	return report(scree_get_counters(state->world, counters));
}

const LabEngine scree_lab = {"scree", open, create, replace, set_poses, set_velocity, push,
                             step,    read, wait,   hash,    bytes,     close};
