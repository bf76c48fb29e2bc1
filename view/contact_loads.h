// SPDX-License-Identifier: MIT
// contact_loads.h -- sums the contact forces of each body, for the paint that colors bodies by force.
#ifndef CONTACT_LOADS_H
#define CONTACT_LOADS_H
#include "scree/scree.h"

// Adds the normal force of each contact, N, to the entries of `forces` of its two bodies, by body index. Skips bodies
// with an index of at least `count`. The force is the impulse divided by `substep`, the duration of a substep, s. The
// caller has set `forces` to 0.
void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count);

// Returns the upper end of a range of forces, N; the range must include 99.5 % of the positive forces. last: result of
// the previous call; 0 at the first call. If `last` is 1 to 4 times as large as needed, returns it, so that colors do
// not change from frame to frame. Otherwise returns the next 1, 2 or 5 times a power of ten. If no force is positive,
// returns `last`, or 1 if `last` is 0.
float loads_range(const float* forces, int count, float last);

#endif
