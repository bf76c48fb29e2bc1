// SPDX-License-Identifier: MIT
// resolve.h -- executes the fourth stage on the host: resolves contacts one by one, each time the most severe one.
#ifndef RESOLVE_H
#define RESOLVE_H
#include "tools/paper/paper_state.h"

// Sorts the contacts of the host by their pairs and resolves them. Writes the new poses and velocities of bodies.
scree_status paper_resolve(Paper* paper);

#endif
