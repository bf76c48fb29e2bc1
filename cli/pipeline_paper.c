// SPDX-License-Identifier: MIT
// pipeline_paper.c -- the pipeline of the paper, tools/paper/paper.h.
#include "pipeline_paper.h"
#include "library_error.h"
#include "scene/churn.h"
#include "tools/paper/paper.h"
#include <stdlib.h>

typedef struct
{
	Paper* paper;
	scree_body* bodies; // of the scene, by rising index; the pipeline has the same order
	scree_pose* poses;
	int count;
} State;

static int paper_open(const Options* options, Simulation* simulation)
{
	int count;
	if (scene_churns(simulation->scene))
	{
		fprintf(stderr, "scree: %s changes bodies between steps, which the pipeline paper cannot\n",
		        simulation->scene->name);
		return EXIT_BAD;
	}
	if (simulation->scene->field_count > 0 || simulation->scene->blast_count > 0)
	{
		fprintf(stderr, "scree: %s has fields or explosions, which the pipeline paper does not know\n",
		        simulation->scene->name);
		return EXIT_BAD;
	}
	if (simulation->scene->joint_count > 0)
	{
		fprintf(stderr, "scree: %s has joints, which the pipeline paper does not know\n", simulation->scene->name);
		return EXIT_BAD;
	}
	if (simulation->scene->character_count > 0)
	{
		fprintf(stderr, "scree: %s has characters, which need queries; the pipeline paper has none\n",
		        simulation->scene->name);
		return EXIT_BAD;
	}
	if (simulation->scene->fan_count > 0)
	{
		fprintf(stderr, "scree: %s casts rays, which the pipeline paper cannot\n", simulation->scene->name);
		return EXIT_BAD;
	}
	scree_status status = scree_world_get_bodies(simulation->world, NULL, 0, &count);
	if (status != SCREE_OK)
		return report(status);
	State* state = simulation->state = calloc(1, sizeof *state);
	if (state)
	{
		state->count = count;
		state->bodies = calloc((size_t)count + 1, sizeof *state->bodies);
		state->poses = calloc((size_t)count + 1, sizeof *state->poses);
	}
	if (!state || !state->bodies || !state->poses)
	{
		fprintf(stderr, "scree: out of memory for %d bodies\n", count);
		return EXIT_FAILED;
	}
	status = scree_world_get_bodies(simulation->world, state->bodies, count, &count);
	if (status == SCREE_OK)
	{
		// the world stays on the device that took its warm-up steps
		const char* device = options->warm_device ? options->device : scree_world_get_device(simulation->world);
		status = paper_create(simulation->world, device, options->allow_unequal_bits, &state->paper);
	}
	return report(status);
}

static const char* device_of(const Simulation* simulation)
{
	const State* state = simulation->state;
	return paper_device(state->paper);
}

static void paper_close(Simulation* simulation)
{
	State* state = simulation->state;
	if (state)
	{
		paper_destroy(state->paper);
		free(state->bodies);
		free(state->poses);
	}
	free(state);
	simulation->state = NULL;
}

// the paper has no substeps
static scree_status take_step(Simulation* simulation, float dt, int substeps)
{
	State* state = simulation->state;
	(void)substeps;
	return paper_step(state->paper, dt);
}

static scree_status read_hash(Simulation* simulation, uint64_t* hash)
{
	State* state = simulation->state;
	*hash = paper_hash(state->paper);
	return SCREE_OK;
}

static scree_status read_counters(Simulation* simulation, scree_counters* counters)
{
	State* state = simulation->state;
	PaperCounters c = paper_counters(state->paper);
	scree_status status = scree_world_get_counters(simulation->world, counters);
	counters->contacts = counters->touching = c.contacts;
	counters->penetration = c.penetration;
	counters->steps = c.steps;
	return status;
}

static scree_status read_timings(Simulation* simulation, float milliseconds[STAGE_COLUMNS])
{
	State* state = simulation->state;
	PaperTimings t = paper_timings(state->paper);
	const double stages[STAGE_COLUMNS] = {t.to_device, t.integrate, t.transform, t.detect, t.from_device, t.resolve};
	for (int k = 0; k < STAGE_COLUMNS; ++k)
		milliseconds[k] = (float)stages[k];
	return SCREE_OK;
}

static int by_index(const void* left, const void* right)
{
	const scree_body *a = left, *b = right;
	return (a->index > b->index) - (a->index < b->index);
}

static scree_status read_poses(Simulation* simulation, const scree_body* bodies, scree_pose* poses, int count)
{
	State* state = simulation->state;
	scree_status status = paper_poses(state->paper, state->poses, state->count);
	for (int k = 0; k < count && status == SCREE_OK; ++k)
	{
		// the body exists, because the command line destroys none
		const scree_body* found =
		    bsearch(&bodies[k], state->bodies, (size_t)state->count, sizeof *state->bodies, by_index);
		poses[k] = state->poses[found - state->bodies];
	}
	return status;
}

const Pipeline paper_pipeline = {
    .stages = {"to_device", "integrate", "transform", "detect", "from_device", "resolve"},
    .solve = -1,
    .one_thread = true,
    .device = device_of,
    .open = paper_open,
    .step = take_step,
    .hash = read_hash,
    .counters = read_counters,
    .timings = read_timings,
    .poses = read_poses,
    .close = paper_close,
};
