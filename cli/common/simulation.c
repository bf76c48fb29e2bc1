// SPDX-License-Identifier: MIT
// simulation.c -- a world with a scene in it, step by step.
#include "simulation.h"
#include "scene/build.h"
#include "scene/churn.h"
#include "tools/common/clock.h"

scree_status simulation_open(const Scene* scene, const scree_world_def* def, Simulation* simulation)
{
	*simulation = (Simulation){.scene = scene};
	double begin = seconds_now();
	scree_status status = scree_world_create(def, &simulation->world);
	double opened = seconds_now();
	if (status == SCREE_OK)
		status = scene_build(scene, simulation->world);
	simulation->opening = opened - begin;
	simulation->building = seconds_now() - opened;
	if (status == SCREE_OK && scene->fan_count > 0)
		status = scan_open(&simulation->scan, scene, simulation->world);
	if (status == SCREE_OK)
		status = walk_open(&simulation->walkers, scene, simulation->world);
	return status;
}

void simulation_close(Simulation* simulation)
{
	scan_close(&simulation->scan);
	walk_close(&simulation->walkers);
	scree_world_destroy(simulation->world);
	*simulation = (Simulation){0};
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
	return scree_world_step(simulation->world, scene->dt, scene->substeps);
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
