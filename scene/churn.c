// SPDX-License-Identifier: MIT
// churn.c -- changes bodies of a scene between steps: moves some, replaces some by new bodies, and pushes some by
// explosions.
//
// The changed bodies and their new places depend only on the number of the step, so no state is kept between steps. All
// replaced bodies are destroyed before the first new body is created, and a world uses the lowest free slots first. So
// each new body gets the slot of the old one, and the bodies of a scene stay in the order of the file.
#include "scene/churn.h"
#include "scene/attribute_block.h"
#include "scene/evaluate.h"
#include "scene/field_block.h"
#include <stdlib.h>

static int64_t common_divisor(int64_t a, int64_t b)
{
	while (b != 0)
	{
		int64_t rest = a % b;
		a = b;
		b = rest;
	}
	return a;
}

// Returns the distance, in the order of the file, from one changed body to the next. The distance has no common divisor
// with `count`, so that every body is changed before any is changed a second time. It is about 0.618 times `count`
// (golden section), so that two consecutive changes are far apart.
static int64_t stride_of(int64_t count)
{
	int64_t stride = (int64_t)(0.6180339887 * (double)count) + 1;
	while (common_divisor(stride, count) != 1)
		++stride;
	return stride;
}

static int compare_changes(const void* a, const void* b)
{
	const SceneChange *x = a, *y = b;
	return x->replaced != y->replaced ? x->replaced - y->replaced : (x->item > y->item) - (x->item < y->item);
}

// Computes the changes of one block. first: index of its first body in the scene.
static bool block_changes(Reader* reader, const Block* block, int first, int64_t step, SceneChange* changes)
{
	const Churn* churn = &block->churn;
	int turns = churn->moved + churn->replaced;
	int64_t stride = stride_of(block->count), turn = step % block->count * turns;
	for (int k = 0; k < turns; ++k)
	{
		int64_t place = (turn + k) % block->count * stride % block->count;
		SceneChange* change = changes + k;
		*change = (SceneChange){.item = first + (int)place, .replaced = k >= churn->moved};
		if (change->replaced)
			change->body = churn->items[place];
		if (!evaluate_churn(reader, block, (uint64_t)step * (uint64_t)turns + (uint64_t)k, &change->body))
			return false;
	}
	qsort(changes, (size_t)turns, sizeof *changes, compare_changes);
	return true;
}

bool scene_churns(const Scene* scene)
{
	bool found = false;
	for (int k = 0; k < scene->block_count; ++k)
		found = found || scene->blocks[k].churn.moved + scene->blocks[k].churn.replaced > 0;
	return found;
}

int scene_changes(const Scene* scene, int64_t step, SceneChange** changes)
{
	char sentence[SENTENCE_SIZE];
	int count = 0, first = 0;
	for (int k = 0; k < scene->block_count; ++k)
		count += scene->blocks[k].churn.moved + scene->blocks[k].churn.replaced;
	Reader* reader = calloc(1, sizeof(Reader));
	*changes = calloc((size_t)count + 1, sizeof **changes);
	bool good = reader && *changes;
	if (good)
	{
		reader->sentence = sentence;
		reader->seed = scene->seed;
	}
	count = 0;
	for (int k = 0; k < scene->block_count && good; ++k)
	{
		const Block* block = scene->blocks + k;
		int turns = block->churn.moved + block->churn.replaced;
		good = turns == 0 || block_changes(reader, block, first, step, *changes + count);
		count += turns;
		first += block->bodies ? (int)block->count : 0;
	}
	free(reader);
	if (good)
		return count;
	free(*changes);
	*changes = NULL;
	return -1;
}

typedef struct // arrays for the changes of a step, in the layout that the functions of scree.h use
{
	scree_body* bodies; // all bodies of the world
	scree_attribute* attributes;
	scree_body* some;
	scree_pose* poses;
	scree_velocity* velocities;
	scree_body_def* defs;
} Arrays;

static bool open_arrays(Arrays* arrays, int bodies, int attributes, int changes)
{
	arrays->bodies = calloc((size_t)bodies + 1, sizeof *arrays->bodies);
	arrays->attributes = calloc((size_t)attributes + 1, sizeof *arrays->attributes);
	arrays->some = calloc((size_t)changes + 1, sizeof *arrays->some);
	arrays->poses = calloc((size_t)changes + 1, sizeof *arrays->poses);
	arrays->velocities = calloc((size_t)changes + 1, sizeof *arrays->velocities);
	arrays->defs = calloc((size_t)changes + 1, sizeof *arrays->defs);
	return arrays->bodies && arrays->attributes && arrays->some && arrays->poses && arrays->velocities && arrays->defs;
}

static void close_arrays(Arrays* arrays)
{
	free(arrays->bodies);
	free(arrays->attributes);
	free(arrays->some);
	free(arrays->poses);
	free(arrays->velocities);
	free(arrays->defs);
}

// Applies the replacements if `replaced` is true, otherwise the moves.
static scree_status apply(scree_world* world, Arrays* arrays, const SceneChange* changes, int count, bool replaced)
{
	int chosen = 0;
	for (int k = 0; k < count; ++k)
	{
		if (changes[k].replaced != replaced)
			continue;
		const scree_body_def* body = &changes[k].body;
		arrays->some[chosen] = arrays->bodies[changes[k].item];
		arrays->poses[chosen] = body->pose;
		arrays->velocities[chosen] = body->velocity;
		arrays->defs[chosen] = *body;
		arrays->defs[chosen].attribute = arrays->attributes[body->attribute.index];
		++chosen;
	}
	if (chosen == 0)
		return SCREE_OK;
	scree_status status = replaced ? scree_bodies_destroy(world, arrays->some, chosen)
	                               : scree_bodies_set_poses(world, arrays->some, arrays->poses, chosen);
	if (status != SCREE_OK)
		return status;
	return replaced ? scree_bodies_create(world, arrays->defs, chosen, NULL)
	                : scree_bodies_set_velocities(world, arrays->some, arrays->velocities, chosen);
}

scree_status scene_churn(const Scene* scene, scree_world* world, int64_t step)
{
	if (!scene_churns(scene))
		return blasts_fire(scene, world, step);
	SceneChange* changes;
	int count = scene_changes(scene, step, &changes), bodies = 0;
	Arrays arrays = {0};
	scree_status status = scree_world_get_bodies(world, NULL, 0, &bodies);
	if (status == SCREE_OK && (count < 0 || !open_arrays(&arrays, bodies, scene->attribute_count, count)))
		status = SCREE_ERROR_OUT_OF_MEMORY;
	if (status == SCREE_OK)
		status = scree_world_get_bodies(world, arrays.bodies, bodies, &bodies);
	// equal definitions share one attribute, so this returns the handles that the bodies already use
	for (int k = 0; k < scene->attribute_count && status == SCREE_OK; ++k)
		status = scree_attribute_create(world, &scene->attributes[k].def, &arrays.attributes[k]);
	if (status == SCREE_OK)
		status = apply(world, &arrays, changes, count, false);
	if (status == SCREE_OK)
		status = apply(world, &arrays, changes, count, true);
	close_arrays(&arrays);
	free(changes);
	return status == SCREE_OK ? blasts_fire(scene, world, step) : status;
}
