// SPDX-License-Identifier: MIT
// sensors.h -- sensors: the collidables that visit them, and the visits that began and ended in the last step.
#ifndef SENSORS_H
#define SENSORS_H
#include "world/world.h"

// Records that a collidable was created, changed or removed; before and after are its sensor bits.
void sensors_note(scree_world* world, uint32_t before, uint32_t after);

// Discards the visits that began and ended. Called before a step.
void sensors_forget(scree_world* world);

// Finds the visits on the device, and which of them began and ended. Called after a step.
scree_status sensors_update(scree_world* world, const char* function);

// Returns the number of visits to a sensor at the end of the last step, from *first on in Sensors.visits.
int sensors_visits(const scree_world* world, int sensor, int* first);
void sensors_close(scree_world* world);

#endif
