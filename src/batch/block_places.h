// SPDX-License-Identifier: MIT
// block_places.h -- moves worlds of a block to other bays: pauses, resumes and resets them.
#ifndef BLOCK_PLACES_H
#define BLOCK_PLACES_H
#include "batch/block_state.h"

// Allocates the lists of places. Each world has the live bay of its row.
scree_status block_places_open(Block* block);
void block_places_close(Block* block);

// Sets the flags of the next step that a world needs which begins to run.
void block_pend(Block* block, const Pending* pending);

// Puts worlds back to their templates, if none is paused. mask: as in scree_batch_reset. Sets *count to their number; they
// are the first ones of Block.copies and Block.rows.
scree_status block_restore(Block* block, const uint8_t* mask, int* count);

// Pauses, resumes and resets worlds, as Block.plan says. The running worlds are then in the first bays.
scree_status block_arrange(Block* block);

// Executes the first `count` copies in Block.copies. contacts: maximum number of contacts with a color of the worlds that come to live
// bays.
scree_status block_copy(Block* block, int count, int contacts);

#endif
