// SPDX-License-Identifier: MIT
// field_block.h -- reads the fields of a scene and the explosions between its steps, and creates them in a world.
#ifndef FIELD_BLOCK_H
#define FIELD_BLOCK_H
#include "scene/reader.h"
#include "scene/scene.h"

#define MOST_FIELDS 100000 // maximum number of fields of a scene; also that of explosions

struct SceneField
{
	scree_field_def def; // without its body
	int block, index;    // position of the body's block in Scene.blocks, -1: no body; index of the body in that block
};

// Reads the members "fields" and "blasts", if the scene has them, after the blocks of bodies.
bool fields_read(Reader* reader, const json_t* root, Scene* scene);
bool blasts_read(Reader* reader, const json_t* root, Scene* scene);

// Creates a field in a world. body: carries the field; may be null.
scree_status field_build(const SceneField* field, scree_world* world, scree_body body);

// Sets off the explosions that the scene has before this step.
scree_status blasts_fire(const Scene* scene, scree_world* world, int64_t step);

#endif
