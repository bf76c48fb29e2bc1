// SPDX-License-Identifier: MIT
// controls.h -- what bodies of a scene do while the user holds keys down in the viewer.
#ifndef CONTROLS_H
#define CONTROLS_H
#include "scene/reader.h"
#include "scene/scene.h"

// Reads the member "keys" of a scene whose blocks have been read.
bool controls_read(Reader* reader, const json_t* root, Scene* scene);

// The keys that a scene asks for: bit k for key k.
uint32_t controls_keys(const Scene* scene);

// Before a step: applies what the keys do that are down. The world must have been built by scene_build. What was destroyed since is
// left alone.
scree_status controls_apply(const Scene* scene, scree_world* world, uint32_t down);

#endif
