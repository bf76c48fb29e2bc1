// SPDX-License-Identifier: MIT
// scree_world.h -- Scree worlds of scenes, and the errors of Scree.
#ifndef SCREE_WORLD_H
#define SCREE_WORLD_H
#include "scene/scene.h"

// Makes a world of the scene. Returns null after printing a sentence. threads 0: one a core.
scree_world* open_world(const Scene* scene, const char* device, int threads);

// Lists the handles of all bodies; the caller frees them. Returns null when memory is short.
scree_body* list_bodies(const scree_world* world, int* count);

// Whether the status is SCREE_OK; if not, prints scree_error().
bool report(scree_status status);

#endif
