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

// Returns the index of a name in Scene.attributes, -1 if no attribute has this name.
int attributes_find(const Scene* scene, const char* name);

#endif
