// SPDX-License-Identifier: MIT
// saves.h -- keeps saves of a world in the memory of its device, to which it goes back many times a second.
#ifndef SAVES_H
#define SAVES_H
#include "scree/scree.h"

// Saves a world as save `number`, or loads this save. reports: true if the list of moved bodies goes back too.
scree_status world_save(scree_world* world, const char* function, int number);
scree_status world_load(scree_world* world, const char* function, int number, bool reports);

// Returns the bytes of device memory that a save has, without those of its structure; 0 if it was not made.
uint64_t world_save_bytes(const scree_world* world, int number);

// Gives up a save and its memory. Has no effect if it was not made.
void world_discard(scree_world* world, int number);
void saves_close(scree_world* world);

#endif
