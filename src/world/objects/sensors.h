// SPDX-License-Identifier: MIT
// sensors.h -- sensors: which collidables are, what visits them, and which visits began and ended in the last step.
#ifndef SENSORS_H
#define SENSORS_H
#include "world/world.h"

// A collidable was made, changed or removed, with these bits before and after.
void sensors_note(scree_world* world, uint32_t before, uint32_t after);

// Before a step: what began and ended is forgotten.
void sensors_forget(scree_world* world);

// After a step: asks the device what visited the sensors, and finds what began and ended.
scree_status sensors_update(scree_world* world, const char* function);

// The visits of a sensor at the end of the last step: *first among Sensors.visits, and how many.
int sensors_visits(const scree_world* world, int sensor, int* first);
void sensors_close(scree_world* world);

#endif
