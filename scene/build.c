// SPDX-License-Identifier: MIT
// build.c -- creates the bodies and collidables of a scene in a world.
#include "scene/build.h"
#include "scene/attributes.h"
#include "scene/evaluate.h"
#include <stdlib.h>

typedef struct
{
	scree_world* world;
	const scree_attribute* attributes; // handles, by position in Scene.attributes
	scree_body* bodies;                // handles of a batch
	scree_status status;
} Build;

static bool build_batch(void* context, const void* items)
{
	Build* build = context;
	const Batch* batch = items;
	const Block* block = batch->block;
	int parts = batch->parts ? batch->count * block->parts.count : 0;
	for (int k = 0; batch->bodies && block->parts.simple && k < batch->count; ++k)
		batch->bodies[k].attribute = build->attributes[batch->bodies[k].attribute.index];
	for (int k = 0; k < parts; ++k)
		batch->parts[k].attribute = build->attributes[batch->parts[k].attribute.index];

	build->status = SCREE_OK;
	if (batch->bodies)
	{
		scree_body* handles = parts > 0 ? build->bodies : NULL;
		build->status = scree_bodies_create(build->world, batch->bodies, batch->count, handles);
		for (int k = 0; k < parts; ++k)
			batch->parts[k].body = build->bodies[k / block->parts.count];
	}
	if (build->status == SCREE_OK && parts > 0)
		build->status = scree_collidables_create(build->world, batch->parts, parts, NULL);
	return build->status == SCREE_OK;
}

scree_status scene_build(const Scene* scene, scree_world* world)
{
	char sentence[SENTENCE_SIZE];
	Reader* reader = calloc(1, sizeof(Reader));
	scree_attribute* attributes = calloc((size_t)scene->attribute_count, sizeof(scree_attribute));
	Build build = {world, attributes, malloc(BATCH_SIZE * sizeof(scree_body)), SCREE_ERROR_OUT_OF_MEMORY};
	if (!reader || !attributes || !build.bodies)
		goto done;
	reader->sentence = sentence;
	reader->seed = scene->seed;

	build.status = SCREE_OK;
	for (int k = 0; k < scene->attribute_count && build.status == SCREE_OK; ++k)
		build.status = scree_attribute_create(world, &scene->attributes[k].def, &attributes[k]);
	for (int k = 0; k < scene->block_count && build.status == SCREE_OK; ++k)
	{
		// all numbers were checked when the scene was read, so that only memory can be short, here or in the world
		if (!evaluate_block(reader, &scene->blocks[k], build_batch, &build) && build.status == SCREE_OK)
			build.status = SCREE_ERROR_OUT_OF_MEMORY;
	}
done:
	free(build.bodies);
	free(attributes);
	free(reader);
	return build.status;
}
