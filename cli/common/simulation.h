// SPDX-License-Identifier: MIT
// simulation.h -- a world with a scene in it, step by step.
#ifndef SIMULATION_H
#define SIMULATION_H
#include "scene/character_motion.h"
#include "scene/scan.h"

typedef struct
{
	const Scene* scene;
	scree_world* world;
	double opening, building; // s: duration of creating the world, and then of creating its bodies
	int64_t steps;            // number of steps so far
	Scan scan;                // rays of the scene
	ScanSum answered;         // sums of the results of the rays so far
	Walkers walkers;          // characters of the scene
} Simulation;

// Creates a world from a definition, and the scene in it. The caller closes the simulation also on failure.
scree_status simulation_open(const Scene* scene, const scree_world_def* def, Simulation* simulation);
void simulation_close(Simulation* simulation);

// Applies the changes of the scene between steps, then takes a step.
scree_status simulation_step(Simulation* simulation);
// Do the two parts of simulation_step: the changes, and the step.
scree_status simulation_change(Simulation* simulation);
scree_status simulation_advance(Simulation* simulation);

// Casts the rays of the scene, if it has any, and adds the results to Simulation.answered. milliseconds is the time
// from the call until the results are on the host.
scree_status simulation_scan(Simulation* simulation, float* milliseconds);

#endif
