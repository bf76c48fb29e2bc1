// SPDX-License-Identifier: MIT
// contact_loads.h -- sums the contact forces of each body, for the paint by force.
#ifndef CONTACT_LOADS_H
#define CONTACT_LOADS_H
#include "scree/scree.h"

// Adds the normal force of each contact, N, to forces[index] of its bodies; bodies with an index of at least count are
// ignored. The force is the impulse divided by the duration of a substep, s. The caller has set forces to 0.
void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count);

// Returns last if it is at least as large as needed and at most four times too large, so that colors do not change from
// frame to frame. Otherwise returns a round number (1, 2 or 5 times a power of ten) that 99.5 % of the positive forces
// do not exceed, N. last is the result of the previous call; 0 at the first call.
float loads_range(const float* forces, int count, float last);

#endif
