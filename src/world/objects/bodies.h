// SPDX-License-Identifier: MIT
// bodies.h -- computes values that depend on the type and the locks of a body.
#ifndef BODIES_H
#define BODIES_H
#include "world/world.h"

// Returns a velocity without the components that the body locks; 0 for a static body.
scree_velocity body_velocity_allowed(const HostBody* host, scree_velocity velocity);

// Records a command that sets gravity scale, damping and locks of a body. Gravity scale and damping are 0 unless the
// body is dynamic. The caller has reserved memory for one command.
void body_send_motion(scree_world* world, int index);

// Inserts leaves for all collidables of a body into the trees. On failure, some leaves may have been inserted.
scree_status body_insert_leaves(scree_world* world, const HostBody* host);
void body_remove_leaves(scree_world* world, const HostBody* host);

#endif
