// SPDX-License-Identifier: MIT
// contact_loads.h -- what contacts press on each body, for the paint by force.
#ifndef CONTACT_LOADS_H
#define CONTACT_LOADS_H
#include "scree/scree.h"

// Adds up the normal impulses of the contacts of each body, as forces over a substep of so many seconds: forces[index], N, of count
// bodies, which are 0 before. A contact with what has no body counts for the body that it has.
void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count);

// A round number (1, 2 or 5 times a power of ten) that 99.5 % of the positive forces do not exceed. As long as the last one is
// above that, and at most four times too large, it stays: colors do not change from frame to frame. 0: none yet.
float loads_range(const float* forces, int count, float last);

#endif
