// SPDX-License-Identifier: MIT
// contact_loads.h -- sums the contact forces of each body, for the paint by force.
#ifndef CONTACT_LOADS_H
#define CONTACT_LOADS_H
#include "scree/scree.h"

// Adds the normal force of each contact, N, to the entries of `forces` with the indices of its two bodies; skips bodies
// with an index of at least `count`. The force is the impulse divided by the duration of a substep, s. The caller has
// set `forces` to 0.
void loads_sum(const scree_contact* contacts, int contact_count, float substep, float* forces, int count);

// Returns the upper end of a range of forces, N. The range needed includes 99.5 % of the positive forces. last:
// result of the previous call; 0 at the first call. Returns `last` if it is 1 to 4 times as large as needed, or if no
// force is positive (then 1 if `last` is 0), so that colors do not change from frame to frame. Otherwise returns the
// next 1, 2 or 5 times a power of ten.
float loads_range(const float* forces, int count, float last);

#endif
