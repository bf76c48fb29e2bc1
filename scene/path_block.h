// SPDX-License-Identifier: MIT
// path_block.h -- reads the paths of a scene: lists of points by name.
#ifndef PATH_BLOCK_H
#define PATH_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

struct ScenePath
{
	char name[NAME_SIZE];
	scree_path_def def; // points and their number are not set
	scree_vec* points;  // m
	int count, capacity;
};

// Reads the member "paths", if the scene has one.
bool paths_read(Reader* reader, const json_t* root, Scene* scene);
void paths_free(Scene* scene);

// Creates a path in a world. *made gets the handle; may be null.
scree_status path_build(const ScenePath* path, scree_world* world, scree_path* made);

#endif
