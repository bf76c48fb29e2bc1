// SPDX-License-Identifier: MIT
// simulation.c -- simulates a scene with one of the pipelines.
#include "simulation.h"
#include "library_error.h"
#include "pipeline_paper.h"
#include "pipeline_soft.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "scene/find.h"
#include "scene/load.h"
#include <time.h>

const Pipeline* choose_pipeline(PipelineChoice choice)
{
	return choice == PIPELINE_PAPER ? &paper_pipeline : &soft_pipeline;
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
	scree_status status = scene_churn(simulation->scene, simulation->world, simulation->steps);
	return status == SCREE_OK ? walk_step(&simulation->walkers, simulation->world, simulation->steps, 0) : status;
}

scree_status simulation_advance(Simulation* simulation)
{
	const Scene* scene = simulation->scene;
	++simulation->steps;
	return simulation->pipeline->step(simulation, scene->dt, scene->substeps);
}

scree_status simulation_step(Simulation* simulation)
{
	scree_status status = simulation_change(simulation);
	return status == SCREE_OK ? simulation_advance(simulation) : status;
}

scree_status simulation_scan(Simulation* simulation, float* milliseconds)
{
	*milliseconds = 0;
	if (simulation->scene->fan_count == 0)
		return SCREE_OK;
	scree_status status = scan_aim(&simulation->scan, simulation->world, NULL, 0);
	double start = seconds_now();
	if (status == SCREE_OK)
		status = scan_cast(&simulation->scan, simulation->world);
	*milliseconds = (float)(1000 * (seconds_now() - start));
	if (status == SCREE_OK)
		scan_add(&simulation->scan, &simulation->answered);
	return status;
}

// Takes the warm-up steps with the soft pipeline, then moves the world to the device of the pipeline that follows. A pipeline
// with one thread copies what it needs from a world on any device.
static scree_status warm_up(const Options* options, Simulation* simulation)
{
	const Scene* scene = simulation->scene;
	scree_status status = SCREE_OK;
	for (int step = 0; step < options->warm_up && status == SCREE_OK; ++step)
		status = scree_world_step(simulation->world, scene->dt, scene->substeps);
	if (status == SCREE_OK && options->warm_device && !simulation->pipeline->one_thread)
		status = scree_world_move(simulation->world, options->device);
	return status;
}

int simulation_open(const Options* options, const Scene* scene, bool timings, Simulation* simulation)
{
	scree_world_def def = scene->world;
	*simulation = (Simulation){.scene = scene, .pipeline = choose_pipeline(options->pipeline)};
	bool alone = simulation->pipeline->one_thread && options->warm_up == 0;
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
	if (status == SCREE_OK && scene->fan_count > 0)
		status = scan_open(&simulation->scan, scene, simulation->world);
	if (status == SCREE_OK)
		status = walk_open(&simulation->walkers, scene, simulation->world);
	int code = status == SCREE_OK ? simulation->pipeline->open(options, simulation) : report(status);
	if (code != EXIT_GOOD)
		simulation_close(simulation);
	return code;
}

void simulation_close(Simulation* simulation)
{
	simulation->pipeline->close(simulation);
	scan_close(&simulation->scan);
	walk_close(&simulation->walkers);
	scree_world_destroy(simulation->world);
	*simulation = (Simulation){0};
}

double seconds_now(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
