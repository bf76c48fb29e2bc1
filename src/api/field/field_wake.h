// SPDX-License-Identifier: MIT
// field_wake.h -- wakes the bodies in the region of a field that the user changes.
#ifndef FIELD_WAKE_H
#define FIELD_WAKE_H
#include "world/world.h"

// Wakes the bodies in the region of a field, or all bodies if it has none. Called before and after each change.
scree_status field_wake(scree_world* world, int index);

#endif
