// SPDX-License-Identifier: MIT
// engine_scree.c -- Scree as an engine to be measured.
#include "engine_scree.h"
#include "scree_world.h"
#include <stdlib.h>

typedef struct
{
	const Setup* setup;
	scree_world* world;
	scree_body* bodies;
	int count;
} State;

static void close(void* context)
{
	State* state = context;
	scree_world_destroy(state->world);
	free(state->bodies);
	free(state);
}

static void* open(const Setup* setup, const EngineOptions* options)
{
	State* state = calloc(1, sizeof(State));
	if (!state)
		return NULL;
	state->setup = setup;
	state->world = setup_open(setup, options->device, options->threads);
	state->bodies = state->world ? list_bodies(state->world, &state->count) : NULL;
	if (state->bodies)
		return state;
	close(state);
	return NULL;
}

static bool change(void* context, int64_t step)
{
	State* state = context;
	if (!setup_change(state->setup, state->world, step))
		return false;
	free(state->bodies);
	state->bodies = list_bodies(state->world, &state->count);
	return state->bodies;
}

static bool step(void* context, float dt, int substeps)
{
	State* state = context;
	return report(scree_world_step(state->world, dt, substeps));
}

static bool wait(void* context)
{
	State* state = context;
	return report(scree_world_wait(state->world));
}

static bool poses(void* context, scree_pose* poses, int count)
{
	State* state = context;
	return report(scree_bodies_get_poses(state->world, state->bodies, poses, count));
}

static bool hash(void* context, uint64_t* hash)
{
	State* state = context;
	return report(scree_world_get_hash(state->world, hash));
}

const Engine scree_engine = {"scree", open, change, step, wait, poses, hash, close};
