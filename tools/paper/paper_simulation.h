// SPDX-License-Identifier: MIT
// paper_simulation.h -- a scene whose steps the paper's pipeline takes.
#ifndef PAPER_SIMULATION_H
#define PAPER_SIMULATION_H
#include "cli/common/open_scene.h"
#include "cli/common/step_record.h"
#include "tools/paper/paper.h"

extern const char* const paper_stages[STAGE_COLUMNS]; // names of Record.stages

// Returns true if the pipeline can simulate a scene; else prints the reason.
bool paper_takes(const Scene* scene);

typedef struct
{
	Simulation simulation; // its world has the scene as it was when the pipeline began
	Paper* paper;          // in figures null for steps of Scree
} PaperSimulation;

// Opens a simulation of a scene on the device of the options, on the CPU without one. Returns an exit code after printing a
// sentence.
int paper_simulation_open(const Options* options, const Scene* scene, PaperSimulation* paper);
void paper_simulation_close(PaperSimulation* paper);

// Takes one step and records it.
scree_status paper_record_step(PaperSimulation* paper, Record* record);

#endif
