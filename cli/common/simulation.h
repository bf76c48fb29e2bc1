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
	double opening, building; // s: that making the world took, and then making its bodies
	int64_t steps;            // so far
	Scan scan;                // rays of the scene
	ScanSum answered;         // sums of their answers so far
	Walkers walkers;          // its characters
} Simulation;

// Makes a world by a definition, and the scene in it. The caller closes it also on failure.
scree_status simulation_open(const Scene* scene, const scree_world_def* def, Simulation* simulation);
void simulation_close(Simulation* simulation);

// Changes the bodies as the scene does between steps, then takes a step.
scree_status simulation_step(Simulation* simulation);
// The two parts of simulation_step: the changes, and the step.
scree_status simulation_change(Simulation* simulation);
scree_status simulation_advance(Simulation* simulation);

// Casts the rays of the scene, if it has any, and adds the answers to Simulation.answered. milliseconds: from the call until the
// answers are on the host.
scree_status simulation_scan(Simulation* simulation, float* milliseconds);

// Seconds on a clock that only moves forward.
double seconds_now(void);

#endif
