// SPDX-License-Identifier: MIT
// whole_sleep.h -- wakes a whole world, or puts it to sleep.
#ifndef WHOLE_SLEEP_H
#define WHOLE_SLEEP_H
#include "world/world.h"

// Applies all earlier changes of the user, then wakes all bodies (true), or puts them to sleep in the next step
// (false). Does nothing in a world that does not sleep.
scree_status world_set_awake(scree_world* world, bool awake);

#endif
