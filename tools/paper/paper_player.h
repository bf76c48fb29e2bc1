// SPDX-License-Identifier: MIT
// paper_player.h -- a scene whose steps the paper's pipeline takes.
#ifndef PAPER_PLAYER_H
#define PAPER_PLAYER_H
#include "cli/common/open_scene.h"
#include "cli/common/step_record.h"
#include "tools/paper/paper.h"

extern const char* const paper_stages[STAGE_TIMES]; // names of Record.stages

// Returns true if the pipeline can simulate a scene; else prints the reason.
bool paper_takes(const Scene* scene);

typedef struct
{
	ScenePlayer player; // its world has the scene as it was when the pipeline began
	Paper* paper;       // in figures null for steps of Scree
} PaperPlayer;

// Opens a player on the device of the options, on the CPU without one. Returns an exit code after printing a
// sentence.
int paper_player_open(const Options* options, const Scene* scene, PaperPlayer* paper);
void paper_player_close(PaperPlayer* paper);

// Takes one step and records it.
scree_status paper_record_step(PaperPlayer* paper, Record* record);

#endif
