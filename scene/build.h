// SPDX-License-Identifier: MIT
// build.h -- creates the bodies, collidables, joints and fields of a scene in a world.
#ifndef BUILD_H
#define BUILD_H
#include "scene/scene.h"

// Creates everything in an empty world. On failure scree_error() has the reason, and the caller destroys the world.
scree_status scene_build(const Scene* scene, scree_world* world);

#endif
