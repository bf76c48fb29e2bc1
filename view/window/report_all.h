// SPDX-License-Identifier: MIT
// report_all.h -- lets all collidables of a world report touches and hits, so that the viewer can show them.
#ifndef REPORT_ALL_H
#define REPORT_ALL_H
#include "scree/scree.h"

// How many collidables of bodies report something of these bits.
scree_status reports_count(scree_world* world, uint32_t bits, int* count);

// From the next step on all collidables of bodies report touches and hits. That changes the hash of the world, not its motion.
scree_status reports_all(scree_world* world);

#endif
