// SPDX-License-Identifier: MIT
// paper_player.h -- plays a scene with the pipeline of the paper.
#ifndef PAPER_PLAYER_H
#define PAPER_PLAYER_H
#include "cli/common/open_scene.h"
#include "cli/common/step_record.h"
#include "tools/paper/paper.h"

extern const char* const paper_stages[STAGE_TIMES]; // names of Record.stages

// Returns whether the pipeline can simulate a scene. If it cannot, prints the reason.
bool paper_takes(const Scene* scene);

typedef struct
{
	ScenePlayer player; // player whose world is in the state from which the paper's pipeline started
	Paper* paper;       // null: steps are taken by Scree (only in figures)
} PaperPlayer;

// Opens a player on options->device, or on the CPU if it is null. Returns an exit code; prints a message if it failed.
int paper_player_open(const Options* options, const Scene* scene, PaperPlayer* paper);
void paper_player_close(PaperPlayer* paper);

// Takes one step. Writes its counters and times to *record.
scree_status paper_record_step(PaperPlayer* paper, Record* record);

#endif
