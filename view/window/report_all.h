// SPDX-License-Identifier: MIT
// report_all.h -- sets all collidables of a world to report touches and hits, so that the viewer can show them.
#ifndef REPORT_ALL_H
#define REPORT_ALL_H
#include "scree/scree.h"

// Counts the collidables of bodies that report at least one of these kinds of events.
scree_status reports_count(scree_world* world, uint32_t bits, int* count);

// Sets all collidables of bodies to report touches and hits, from the next step on. This changes the hash of the world,
// but not its motion.
scree_status reports_all(scree_world* world);

#endif
