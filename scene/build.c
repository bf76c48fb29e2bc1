// SPDX-License-Identifier: MIT
// build.c -- creates the bodies, collidables, joints and fields of a scene in a world.
#include "scene/build.h"
#include "scene/attribute_block.h"
#include "scene/evaluate.h"
#include "scene/evaluate_joints.h"
#include "scene/exclusion_block.h"
#include "scene/field_block.h"
#include "scene/material_block.h"
#include "scene/path_block.h"
#include <stdlib.h>

typedef struct
{
	scree_world* world;
	const scree_attribute* attributes; // handles in the order of Scene.attributes
	scree_path* paths;                 // handles in the order of Scene.paths
	scree_body* bodies;                // handles of the bodies of one batch
	scree_body* named;                 // handles of the bodies of all named blocks, block by block
	scree_body** of_block;             // first handle of each block, in `named`; null: the block has no name
	scree_body* next;                  // place in `named` for the next bodies of the block; null: no name
	scree_status status;
} Build;

// Sets the masses of a batch, and then the poses and velocities again: a mass or a collidable that moves the center of mass of a body
// that rotates changes its velocity, and a mass rounds its pose.
static scree_status build_masses(const Build* build, const Batch* batch, const scree_body* bodies)
{
	scree_status status = SCREE_OK;
	if (batch->block->massed)
		status = scree_bodies_set_masses(build->world, bodies, batch->masses, batch->count);
	for (int k = 0; k < batch->count && status == SCREE_OK; ++k)
	{
		const scree_body_def* body = &batch->bodies[k];
		bool turns = body->type == SCREE_BODY_DYNAMIC && body->velocity.angular != 0.0f;
		if (batch->block->massed)
			status = scree_body_set_pose(build->world, bodies[k], body->pose);
		if (status == SCREE_OK && batch->block->centered && turns)
			status = scree_body_set_velocity(build->world, bodies[k], body->velocity);
	}
	return status;
}

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
	scree_body* handles = NULL;
	if (batch->bodies)
	{
		handles = build->next ? build->next : parts > 0 || block->massed || block->centered ? build->bodies : NULL;
		build->status = scree_bodies_create(build->world, batch->bodies, batch->count, handles);
		for (int k = 0; k < parts; ++k)
			batch->parts[k].body = handles[k / block->parts.count];
		if (build->next)
			build->next += batch->count;
	}
	if (build->status == SCREE_OK && parts > 0)
		build->status = scree_collidables_create(build->world, batch->parts, parts, NULL);
	if (build->status == SCREE_OK && batch->bodies && (block->massed || block->centered))
		build->status = build_masses(build, batch, handles);
	return build->status == SCREE_OK;
}

static bool build_joints(void* context, const void* joints)
{
	Build* build = context;
	const JointBatch* batch = joints;
	const JointEnd* ends = batch->block->ends;
	for (int k = 0; k < batch->count; ++k)
	{
		if (ends[0].block >= 0)
			batch->defs[k].body_a = build->of_block[ends[0].block][batch->ends[k].a];
		if (ends[1].block >= 0)
			batch->defs[k].body_b = build->of_block[ends[1].block][batch->ends[k].b];
		if (batch->block->on >= 0)
			batch->defs[k].path = build->paths[batch->block->on];
	}
	build->status = scree_joints_create(build->world, batch->defs, batch->count, NULL);
	return build->status == SCREE_OK;
}

static bool open_build(Build* build, const Scene* scene)
{
	int64_t named = 0;
	for (int k = 0; k < scene->block_count; ++k)
		named += *scene->blocks[k].name ? scene->blocks[k].count : 0;
	build->bodies = malloc(BATCH_SIZE * sizeof(scree_body));
	build->named = malloc(((size_t)named + 1) * sizeof(scree_body));
	build->paths = calloc((size_t)scene->path_count + 1, sizeof(scree_path));
	build->of_block = calloc((size_t)scene->block_count + 1, sizeof(scree_body*));
	if (!build->bodies || !build->named || !build->of_block || !build->paths)
		return false;
	scree_body* next = build->named;
	for (int k = 0; k < scene->block_count; ++k)
	{
		if (!*scene->blocks[k].name)
			continue;
		build->of_block[k] = next;
		next += scene->blocks[k].count;
	}
	return true;
}

scree_status scene_build(const Scene* scene, scree_world* world)
{
	char sentence[SENTENCE_SIZE];
	Reader* reader = calloc(1, sizeof(Reader));
	scree_attribute* attributes = calloc((size_t)scene->attribute_count + 1, sizeof(scree_attribute));
	Build build = {.world = world, .attributes = attributes, .status = SCREE_ERROR_OUT_OF_MEMORY};
	if (!open_build(&build, scene) || !reader || !attributes)
		goto done;
	reader->sentence = sentence;
	reader->seed = scene->seed;

	build.status = SCREE_OK;
	for (int k = 0; k < scene->attribute_count && build.status == SCREE_OK; ++k)
		build.status = scree_attribute_create(world, &scene->attributes[k].def, &attributes[k]);
	for (int k = 0; k < scene->path_count && build.status == SCREE_OK; ++k)
		build.status = path_build(&scene->paths[k], world, &build.paths[k]);
	for (int k = 0; k < scene->material_count && build.status == SCREE_OK; ++k)
	{
		const SceneMaterials* m = scene->materials + k;
		build.status = scree_world_set_material_pair(world, m->a, m->b, &m->pair);
	}
	// all numbers were checked when the scene was read, so the only possible error is a lack of memory, in this
	// function or in the world
	for (int k = 0; k < scene->block_count && build.status == SCREE_OK; ++k)
	{
		build.next = build.of_block[k];
		if (!evaluate_block(reader, &scene->blocks[k], build_batch, &build) && build.status == SCREE_OK)
			build.status = SCREE_ERROR_OUT_OF_MEMORY;
	}
	for (int k = 0; k < scene->joint_block_count && build.status == SCREE_OK; ++k)
	{
		if (!evaluate_joints(reader, scene, &scene->joint_blocks[k], build_joints, &build) && build.status == SCREE_OK)
			build.status = SCREE_ERROR_OUT_OF_MEMORY;
	}
	if (build.status == SCREE_OK)
		build.status = exclusions_build(scene, world, build.of_block);
	for (int k = 0; k < scene->field_count && build.status == SCREE_OK; ++k)
	{
		const SceneField* field = &scene->fields[k];
		build.status =
		    field_build(field, world, field->block < 0 ? SCREE_NULL_BODY : build.of_block[field->block][field->index]);
	}
done:
	free(build.bodies);
	free(build.named);
	free(build.of_block);
	free(build.paths);
	free(attributes);
	free(reader);
	return build.status;
}
