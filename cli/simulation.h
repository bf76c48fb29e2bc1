// SPDX-License-Identifier: MIT
// simulation.h -- simulates a scene with one of the pipelines.
#ifndef SIMULATION_H
#define SIMULATION_H
#include "pipelines.h"

const Pipeline* choose_pipeline(PipelineChoice choice);

// Loads the scene that the user named. Returns null after printing a sentence.
Scene* open_scene(const Options* options, const char* name);

// Makes a world of the scene, takes the warm-up steps of the options with the soft pipeline, and then opens the pipeline of
// the options. Returns an exit code after printing a sentence.
int simulation_open(const Options* options, const Scene* scene, bool timings, Simulation* simulation);
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
