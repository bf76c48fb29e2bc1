// SPDX-License-Identifier: MIT
// pipeline_soft.c -- the pipeline of libscree: the soft step solver.
#include "pipeline_soft.h"
#include <string.h>

// this pipeline needs no state besides the world
static int soft_open(const Options* options, Simulation* simulation)
{
	(void)options;
	simulation->state = NULL;
	return EXIT_GOOD;
}

static const char* soft_device(const Simulation* simulation) { return scree_world_get_device(simulation->world); }

static scree_status soft_step(Simulation* simulation, float dt, int substeps)
{
	return scree_world_step(simulation->world, dt, substeps);
}

static scree_status soft_hash(Simulation* simulation, uint64_t* hash)
{
	return scree_world_get_hash(simulation->world, hash);
}

static scree_status soft_counters(Simulation* simulation, scree_counters* counters)
{
	return scree_world_get_counters(simulation->world, counters);
}

static scree_status soft_timings(Simulation* simulation, float milliseconds[STAGE_COLUMNS])
{
	scree_timings t;
	scree_status status = scree_world_get_timings(simulation->world, &t);
	const float stages[STAGE_COLUMNS] = {t.transform, t.broad_phase, t.narrow_phase, t.color, t.solve, t.finalize};
	memcpy(milliseconds, stages, sizeof stages);
	return status;
}

static scree_status soft_poses(Simulation* simulation, const scree_body* bodies, scree_pose* poses, int count)
{
	return scree_bodies_get_poses(simulation->world, bodies, poses, count);
}

static void soft_close(Simulation* simulation) { simulation->state = NULL; }

const Pipeline soft_pipeline = {
    .stages = {"transform", "broad_phase", "narrow_phase", "color", "solve", "finalize"},
    .solve = 4,
    .device = soft_device,
    .open = soft_open,
    .step = soft_step,
    .hash = soft_hash,
    .counters = soft_counters,
    .timings = soft_timings,
    .poses = soft_poses,
    .close = soft_close,
};
