// SPDX-License-Identifier: MIT
// reports.h -- collidables that report events: their number, names of destroyed ones, and the events of the device.
#ifndef REPORTS_H
#define REPORTS_H
#include "world/world.h"

// Reserves memory for the names of collidables that are destroyed after the next step, if one has ever reported.
scree_status reports_reserve(scree_world* world, const char* function);

// Stores the name of a collidable that is about to be destroyed.
void reports_depart(scree_world* world, int index);

// Records that a collidable reports these events from now on.
void reports_note(scree_world* world, uint32_t reports);
uint64_t allowed_hash(const scree_world* world);

// Discards the events of the last step, because the next one begins.
void reports_forget(scree_world* world);

// Discards the approvals of the previous step, after a step.
void reports_stepped(scree_world* world);

// Reads the events of the last step, unless they were read already. Called before later changes are uploaded.
scree_status reports_fetch(scree_world* world);

// Returns the name of a collidable that took part in the last step; before: or in the one before, but not in the last.
CollidableName reports_name(const scree_world* world, int index, bool before, int* destroyed);

void reports_close(scree_world* world);

#endif
