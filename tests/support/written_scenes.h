// SPDX-License-Identifier: MIT
// written_scenes.h -- writes worlds as scenes, loads them again, and compares both worlds.
#ifndef WRITTEN_SCENES_H
#define WRITTEN_SCENES_H
#include "scree/scree_scene.h"
#include "support/checks.h"

// Writes a world as the text of a scene, which the caller frees with scree_scene_free_text.
char* write_scene(scree_world* world, const scree_scene_info* info, size_t* size);

// Loads a scene from its text, in a world with one thread.
scree_scene* load_written(const char* text, size_t size, const char* device);

// Fails unless the hashes of two worlds are equal, and names the data in which they differ. what: beginning of the message.
void check_same_hash(const char* what, scree_world* a, scree_world* b);

// Checks that a world, written, loaded and written again, has the same text at most after some rounds.
void check_same_text(const char* what, scree_world* world, const scree_scene_info* info, int rounds);

#endif
