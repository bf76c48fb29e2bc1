// SPDX-License-Identifier: MIT
// attribute_block.h -- reads the attributes of a scene: shapes and surfaces by name.
#ifndef ATTRIBUTE_BLOCK_H
#define ATTRIBUTE_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

struct Attribute
{
	char name[NAME_SIZE];
	scree_attribute_def def;
};

// Reads "attributes" into Scene.attributes.
bool attributes_read(Reader* reader, const Location* location, const json_t* value, Scene* scene);

// Sets *found to the index of a name in Scene.attributes. Fails if no attribute has this name.
bool attributes_find(const Scene* scene, Reader* reader, const Location* location, const char* name, int* found);

#endif
