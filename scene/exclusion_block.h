// SPDX-License-Identifier: MIT
// exclusion_block.h -- reads the excluded pairs of bodies of a scene, and excludes them in a world.
#ifndef EXCLUSION_BLOCK_H
#define EXCLUSION_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

struct SceneExclusion // pair of bodies
{
	int blocks[2], indices[2]; // positions of their blocks in Scene.blocks; indices of the bodies in these blocks
};

// Reads the member "exclusions", if the scene has one, after the blocks of bodies.
bool exclusions_read(Reader* reader, const json_t* root, Scene* scene);

// Excludes the pairs in a world. of_block: the bodies of each block.
scree_status exclusions_build(const Scene* scene, scree_world* world, scree_body* const* of_block);

#endif
