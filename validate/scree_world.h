// SPDX-License-Identifier: MIT
// scree_world.h -- reads the bodies and joints of a Scree world, and prints the errors of Scree.
#ifndef SCREE_WORLD_H
#define SCREE_WORLD_H
#include "engine.h"

// Both functions return the handles of all bodies (list_bodies) or of all joints (list_joints), and set *count to their
// number. The caller frees the list. If memory is short, they print a message and return null.
scree_body* list_bodies(const scree_world* world, int* count);
scree_joint* list_joints(const scree_world* world, int* count);

// Reads the definition of a body, and sets body->index to the index of its handle. Shapes are transformed by the local
// poses of their collidables. Returns false after printing a message. The caller frees body->parts, also after a
// failure.
bool read_body(scree_world* world, scree_body handle, EngineBody* body);

// Returns whether the status is SCREE_OK. If it is not, prints scree_error().
bool report_status(scree_status status);

#endif
