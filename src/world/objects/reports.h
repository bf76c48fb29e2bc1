// SPDX-License-Identifier: MIT
// reports.h -- collidables that report events: how many there are, those destroyed, and what the device listed.
#ifndef REPORTS_H
#define REPORTS_H
#include "world/world.h"

// Room for the names of collidables that will be destroyed after the next step, if one has ever reported.
scree_status reports_reserve(scree_world* world, const char* function);

// A collidable is about to be destroyed.
void reports_depart(scree_world* world, int index);

// A collidable reports such things from now on.
void reports_note(scree_world* world, uint32_t reports);

// Of the answers that wait for the next step.
uint64_t allowed_hash(const scree_world* world);

// The next step begins: the events of the last one are void.
void reports_forget(scree_world* world);

// The step is done, and so are the answers to the one before.
void reports_stepped(scree_world* world);

// Reads the events of the last step, unless that was done. What the user changed since must not have been uploaded.
scree_status reports_fetch(scree_world* world);

// The name of a collidable that took part in the last step; before: or in the one before, but not in the last.
CollidableName reports_name(const scree_world* world, int index, bool before, int* destroyed);

void reports_close(scree_world* world);

#endif
