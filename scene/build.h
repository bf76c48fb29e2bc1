// SPDX-License-Identifier: MIT
// build.h -- creates the bodies, collidables and joints of a scene in a world.
#ifndef BUILD_H
#define BUILD_H
#include "scene/scene.h"

// The world must be empty. On failure scree_error() says why, and the caller destroys the world.
scree_status scene_build(const Scene* scene, scree_world* world);

#endif
