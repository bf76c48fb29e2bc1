// SPDX-License-Identifier: MIT
// scree_world.h -- lists and definitions of the bodies of a Scree world, and the errors of Scree.
#ifndef SCREE_WORLD_H
#define SCREE_WORLD_H
#include "engine.h"

// Lists the handles of all bodies, or joints; the caller frees them. Returns null after printing that memory is short.
scree_body* list_bodies(const scree_world* world, int* count);
scree_joint* list_joints(const scree_world* world, int* count);

// Reads a body as a definition, whose index is that of the handle. Local poses go into the shapes. Returns false after printing a
// sentence. The caller frees body->parts, also then.
bool read_body(scree_world* world, scree_body handle, EngineBody* body);

// Whether the status is SCREE_OK; if not, prints scree_error().
bool report_status(scree_status status);

#endif
