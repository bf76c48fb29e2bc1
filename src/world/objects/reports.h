// SPDX-License-Identifier: MIT
// reports.h -- keeps the number of reporting collidables, names of destroyed collidables, and events of the last step.
#ifndef REPORTS_H
#define REPORTS_H
#include "world/world.h"

// Reserves memory for names of collidables destroyed later, if there is or was a sensor or a reporting collidable.
scree_status reports_reserve(scree_world* world, const char* function);

// Stores the name of a collidable that is about to be destroyed, unless it was created after the last step.
void reports_depart(scree_world* world, int index);

// Prepares later steps for contact approval if a collidable requires it. reports: its SCREE_REPORT_* bits.
void reports_note(scree_world* world, uint32_t reports);
uint64_t allowed_hash(const scree_world* world);

// Discards the events of the last step. Must be called when the next step begins.
void reports_forget(scree_world* world);

// Discards the user's approvals after a step has used them. Must be called after each successful step.
void reports_stepped(scree_world* world);

// Reads the events of the last step, unless they were read already. Must be called before later changes are uploaded.
scree_status reports_fetch(scree_world* world);

// Returns the name of the collidable that had a slot in the last step. If `before` is true, prefers one that was
// destroyed between the last two steps. Sets *destroyed to whether the returned collidable has been destroyed.
CollidableName reports_name(const scree_world* world, int index, bool before, int* destroyed);

void reports_close(scree_world* world);

#endif
