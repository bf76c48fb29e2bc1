// SPDX-License-Identifier: MIT
// controls.h -- applies forces to bodies of a scene while the user holds keys down in the viewer.
#ifndef CONTROLS_H
#define CONTROLS_H
#include "scene/reader.h"
#include "scene/scene.h"

// Reads the member "keys" of a scene whose blocks have been read.
bool controls_read(Reader* reader, const json_t* root, Scene* scene);

// Returns the keys that a scene uses: bit k for key k.
uint32_t controls_keys(const Scene* scene);

// Applies the forces of the pressed keys before a step. scene_build must have filled the world. Destroyed bodies are
// skipped.
scree_status controls_apply(const Scene* scene, scree_world* world, uint32_t down);

#endif
