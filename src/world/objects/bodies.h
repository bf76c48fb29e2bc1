// SPDX-License-Identifier: MIT
// bodies.h -- values that depend on the type and the locks of a body.
#ifndef BODIES_H
#define BODIES_H
#include "world/world.h"

// Returns the velocity without its locked components; 0 for a static body.
scree_velocity body_velocity_allowed(const HostBody* host, scree_velocity velocity);

// Sends gravity scale, damping (both 0 unless dynamic) and locks. The caller has reserved memory for one command.
void body_send_motion(scree_world* world, int index);

// Inserts leaves for all collidables of a body into the trees. On failure some may be inserted already.
scree_status body_insert_leaves(scree_world* world, const HostBody* host);
void body_remove_leaves(scree_world* world, const HostBody* host);

#endif
