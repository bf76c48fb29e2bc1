// SPDX-License-Identifier: MIT
// report_all.h -- sets all collidables of bodies to report touches and hits, so that the viewer can show these events.
#ifndef REPORT_ALL_H
#define REPORT_ALL_H
#include "scree/scree.h"

// Sets *count to the number of collidables of bodies that report at least one of the kinds of events in `bits`.
scree_status reports_count(scree_world* world, uint32_t bits, int* count);

// Sets all collidables of bodies to report touches and hits from the next step on. The hash of the world changes, but
// its motion does not.
scree_status reports_all(scree_world* world);

#endif
