// SPDX-License-Identifier: MIT
// contact_loads.h -- sums of contact forces for each body, for the paint by force.
#ifndef CONTACT_LOADS_H
#define CONTACT_LOADS_H
#include "scree/scree.h"

// Adds up the normal impulses of each body's contacts, as forces over a substep (s): forces[index], N, for count
// bodies; the caller sets them to 0 before. In a contact with a collidable without a body only the other body gets the
// force.
void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count);

// Returns a round number (1, 2 or 5 times a power of ten) that 99.5 % of the positive forces do not exceed, N. If last
// is large enough, and at most four times too large, it returns last, so that colors do not change from frame to frame.
// last is 0 at first.
float loads_range(const float* forces, int count, float last);

#endif
