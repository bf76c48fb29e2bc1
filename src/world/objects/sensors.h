// SPDX-License-Identifier: MIT
// sensors.h -- finds the visits to sensors, and lists the visits that began and ended in the last step.
#ifndef SENSORS_H
#define SENSORS_H
#include "world/world.h"

// Records a change of the sensor bits of a collidable from `before` to `after`; 0 while the collidable does not exist.
void sensors_note(scree_world* world, uint32_t before, uint32_t after);

// Discards the lists of visits that began and ended. Must be called before each step.
void sensors_forget(scree_world* world);

// Finds the visits on the device, and lists the visits that began and ended. Must be called after successful steps.
scree_status sensors_update(scree_world* world, const char* function);

// Returns the number of visits to a sensor at the end of the last step. *first: set to the first one in Sensors.visits.
int sensors_visits(const scree_world* world, int sensor, int* first);

// Replaces the visits at the end of the last step. visits: sorted by sensor, then by visitor; their times are found
// again, from the poses at the start and the end of the last step. The user's changes must be uploaded.
scree_status sensors_set(scree_world* world, const char* function, const Visit* visits, int count);

void sensors_close(scree_world* world);

#endif
