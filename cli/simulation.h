// SPDX-License-Identifier: MIT
// simulation.h -- a scene set in motion by one of the pipelines.
#ifndef SIMULATION_H
#define SIMULATION_H
#include "options.h"

typedef struct Simulation Simulation;

#define STAGE_COLUMNS 6

typedef struct // what a pipeline must do; all as the functions of scree.h with the same names
{
	const char* stages[STAGE_COLUMNS];                   // that it is timed by, in the order of the step
	int solve;                                           // of stages, the one whose traffic is counted; -1 for none
	bool one_thread;                                     // on the CPU it uses one thread and one lane
	const char* (*device)(const Simulation* simulation); // that it runs on
	// from the world; returns an exit code, after printing what is wrong. Closed also then
	int (*open)(const Options* options, Simulation* simulation);
	scree_status (*step)(Simulation* simulation, float dt, int substeps);
	scree_status (*hash)(Simulation* simulation, uint64_t* hash);
	scree_status (*counters)(Simulation* simulation, scree_counters* counters);
	scree_status (*timings)(Simulation* simulation, float milliseconds[STAGE_COLUMNS]);
	scree_status (*poses)(Simulation* simulation, const scree_body* bodies, scree_pose* poses, int count);
	void (*close)(Simulation* simulation); // releases state; the world is not the pipeline's
} SimulationFunctions;
extern const SimulationFunctions paper_functions; // cli/paper.c

struct Simulation
{
	const SimulationFunctions* f;
	scree_world* world;       // with the scene in it; a pipeline of its own takes bodies and attributes from here
	double opening, building; // s: until the world was there, and until its bodies were
	int64_t steps;            // taken
	void* state;              // of the pipeline
	const Scene* scene;
};

// The one place where a pipeline is chosen.
const SimulationFunctions* pipeline_functions(PipelineChoice choice);

// Reads the scene named by the user. Returns null after printing what is wrong.
Scene* open_scene(const Options* options, const char* name);

// Makes a world, puts the scene into it and chooses the pipeline, which takes over from the soft one after the steps of
// warming up that the options ask for. Returns an exit code, after printing what is wrong.
int simulation_open(const Options* options, const Scene* scene, bool timings, Simulation* simulation);
void simulation_close(Simulation* simulation);

// Takes a step; before it, does what the scene does to its bodies between steps.
scree_status simulation_step(Simulation* simulation);
// The two halves: what users do between steps, and the step.
scree_status simulation_change(Simulation* simulation);
scree_status simulation_go(Simulation* simulation);

// Prints scree_error() and returns the exit code of a status.
int report(scree_status status);

// Seconds on a clock that only moves forward.
double seconds_now(void);

#endif
