// SPDX-License-Identifier: MIT
// pipelines.h -- a simulation and the functions of its pipeline.
#ifndef PIPELINES_H
#define PIPELINES_H
#include "options.h"
#include "scene/character_motion.h"
#include "scene/scan.h"

typedef struct Simulation Simulation;

#define STAGE_COLUMNS 6

typedef struct // the functions of a pipeline; they do what the functions of scree.h with the same names do
{
	const char* stages[STAGE_COLUMNS]; // in the order of the step; timings has one time for each
	int solve;                         // index in stages of the one whose traffic is counted; -1 for none
	bool one_thread;                   // uses one thread and one lane on the CPU
	const char* (*device)(const Simulation* simulation); // name of the device that it runs on
	// prepares the state from the world. Returns an exit code after printing a sentence; the caller closes it also on failure
	int (*open)(const Options* options, Simulation* simulation);
	scree_status (*step)(Simulation* simulation, float dt, int substeps);
	scree_status (*hash)(Simulation* simulation, uint64_t* hash);
	scree_status (*counters)(Simulation* simulation, scree_counters* counters);
	scree_status (*timings)(Simulation* simulation, float milliseconds[STAGE_COLUMNS]);
	scree_status (*poses)(Simulation* simulation, const scree_body* bodies, scree_pose* poses, int count);
	void (*close)(Simulation* simulation); // frees the state, not the world
} Pipeline;

struct Simulation
{
	const Pipeline* pipeline;
	scree_world* world;       // with the scene in it; the pipeline of the paper copies bodies and attributes from it
	double opening, building; // s: that making the world took, and then making its bodies
	int64_t steps;            // so far
	void* state;              // of the pipeline
	const Scene* scene;
	Scan scan;        // of the rays of the scene
	Walkers walkers;  // its characters
	ScanSum answered; // by them so far
};

#endif
