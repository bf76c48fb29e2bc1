// SPDX-License-Identifier: MIT
// simulation.c -- a scene set in motion by one of the pipelines.
#include "simulation.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/find.h"
#include "scene/load.h"
#include <string.h>
#include <time.h>

// the world is all that this pipeline has
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

static const SimulationFunctions soft_functions = {
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

const SimulationFunctions* pipeline_functions(PipelineChoice choice)
{
	return choice == PIPELINE_PAPER ? &paper_functions : &soft_functions;
}

Scene* open_scene(const Options* options, const char* name)
{
	char path[SCENE_PATH], sentence[SCENE_SENTENCE];
	Scene* scene = NULL;
	if (scene_find(name, options->executable, path, sentence))
		scene = scene_load(path, options->settings, options->setting_count, sentence);
	if (!scene)
		fprintf(stderr, "scree: %s\n", sentence);
	return scene;
}

scree_status simulation_change(Simulation* simulation)
{
	return scene_churn(simulation->scene, simulation->world, simulation->steps);
}

scree_status simulation_go(Simulation* simulation)
{
	const Scene* scene = simulation->scene;
	++simulation->steps;
	return simulation->f->step(simulation, scene->dt, scene->substeps);
}

scree_status simulation_step(Simulation* simulation)
{
	scree_status status = simulation_change(simulation);
	return status == SCREE_OK ? simulation_go(simulation) : status;
}

int report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "scree: %s\n", scree_error());
	return status == SCREE_OK ? EXIT_GOOD : status == SCREE_ERROR_INVALID ? EXIT_BAD : EXIT_FAILED;
}

// Steps of the soft pipeline, whatever pipeline follows, and a move to where that one wants its world. A pipeline with
// one thread does not care: it takes from the world what it needs, wherever that is.
static scree_status warm_up(const Options* options, Simulation* simulation)
{
	const Scene* scene = simulation->scene;
	scree_status status = SCREE_OK;
	for (int step = 0; step < options->warm_up && status == SCREE_OK; ++step)
		status = scree_world_step(simulation->world, scene->dt, scene->substeps);
	if (status == SCREE_OK && options->warm_device && !simulation->f->one_thread)
		status = scree_world_move(simulation->world, options->device);
	return status;
}

int simulation_open(const Options* options, const Scene* scene, bool timings, Simulation* simulation)
{
	scree_world_def def = scene->world;
	*simulation = (Simulation){.scene = scene, .f = pipeline_functions(options->pipeline)};
	bool alone = simulation->f->one_thread && options->warm_up == 0;
	def.device = options->warm_device ? options->warm_device : options->device;
	def.threads = alone ? 1 : options->threads;
	def.lanes = alone ? 1 : options->lanes;
	def.allow_unequal_bits = options->allow_unequal_bits;
	def.timings = timings;
	def.opengl = options->opengl;
	double begin = seconds_now();
	scree_status status = scree_world_create(&def, &simulation->world);
	double opened = seconds_now();
	if (status == SCREE_OK)
		status = scene_build(scene, simulation->world);
	simulation->opening = opened - begin;
	simulation->building = seconds_now() - opened;
	if (status == SCREE_OK)
		status = warm_up(options, simulation);
	int code = status == SCREE_OK ? simulation->f->open(options, simulation) : report(status);
	if (code != EXIT_GOOD)
		simulation_close(simulation);
	return code;
}

void simulation_close(Simulation* simulation)
{
	simulation->f->close(simulation);
	scree_world_destroy(simulation->world);
	*simulation = (Simulation){0};
}

double seconds_now(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
