// SPDX-License-Identifier: MIT
// scree_world.h -- lists of what a Scree world has, and the errors of Scree.
#ifndef SCREE_WORLD_H
#define SCREE_WORLD_H
#include "scree/scree.h"

// Lists the handles of all bodies, or joints; the caller frees them. Returns null after printing that memory is short.
scree_body* list_bodies(const scree_world* world, int* count);
scree_joint* list_joints(const scree_world* world, int* count);

// Whether the status is SCREE_OK; if not, prints scree_error().
bool report(scree_status status);

#endif
