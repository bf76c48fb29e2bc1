// SPDX-License-Identifier: MIT
// material_block.h -- reads the surface values of pairs of materials in a scene.
#ifndef MATERIAL_BLOCK_H
#define MATERIAL_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

struct SceneMaterials
{
	int a, b;
	scree_material_pair pair;
};

// Reads the member "materials", if the scene has one.
bool materials_read(Reader* reader, const json_t* root, Scene* scene);

#endif
