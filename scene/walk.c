// SPDX-License-Identifier: MIT
// walk.c -- evaluating a block of a scene, item by item, in batches.
#include "scene/block.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Nested ranges may be empty inside: this bounds the time spent on finding that out.
#define MAX_ROUNDS 50000000

typedef struct
{
	Reader* reader;
	const Block* block;
	double indices[MAX_LOOPS];
	Item item;
	int depth; // loops whose index is set
	int64_t rounds;
	Batch* batch; // null while counting
	int64_t count, limit;
	const Place* place; // of the block, while counting
} Walk;

// "expression" is 3, must be ..., at i = 1, j = 2
static bool item_fail(Walk* walk, const Number* number, const char* text)
{
	char where[160] = "";
	for (int k = 0; k < walk->depth; ++k)
		snprintf(where + strlen(where), sizeof where - strlen(where), "%s%s = %.9g", k ? ", " : ", at ",
		         walk->block->loops[k].index, walk->indices[k]);
	snprintf(walk->reader->sentence, SENTENCE_SIZE, "%.180s: %s: \"%.60s\"%s%s", walk->reader->file, number->path,
	         number->text, text, where);
	return false;
}

static bool value_of(Walk* walk, const Number* number, double* value)
{
	if (!number->code)
	{
		*value = number->constant;
		return true;
	}
	const char* fault = expression_evaluate(number->code, &walk->item, value);
	char must[80], text[128];
	if (fault)
	{
		snprintf(text, sizeof text, ": %s", fault);
		return item_fail(walk, number, text);
	}
	fault = range_fault(number->range, *value, must, sizeof must);
	if (fault)
	{
		snprintf(text, sizeof text, " is %.9g, %s", *value, fault);
		return item_fail(walk, number, text);
	}
	return true;
}

static bool float_of(Walk* walk, const Number* number, float* value)
{
	double number_value;
	bool good = value_of(walk, number, &number_value);
	*value = (float)number_value;
	return good;
}

static bool pose_of(Walk* walk, const Number position[2], const Number* angle, scree_pose* pose)
{
	float radians;
	if (!float_of(walk, &position[0], &pose->position.x) || !float_of(walk, &position[1], &pose->position.y) ||
	    !float_of(walk, angle, &radians))
		return false;
	pose->rotation = radians == 0 ? (scree_rot){1, 0} : scree_rot_make(radians);
	return true;
}

static bool choice_of(Walk* walk, const Choice* choice, scree_attribute* attribute)
{
	double position = 0;
	if (choice->count > 1 && !value_of(walk, &choice->choose, &position))
		return false;
	*attribute = (scree_attribute){(uint32_t)choice->attributes[(int)position], 0};
	return true;
}

static bool body_of(Walk* walk, scree_body_def* body)
{
	const Block* b = walk->block;
	*body = scree_body_def_default();
	body->type = b->type;
	body->locks = b->locks;
	return pose_of(walk, b->position, &b->angle, &body->pose) &&
	       float_of(walk, &b->velocity[0], &body->velocity.linear.x) &&
	       float_of(walk, &b->velocity[1], &body->velocity.linear.y) &&
	       float_of(walk, &b->angular_velocity, &body->velocity.angular) &&
	       float_of(walk, &b->gravity_scale, &body->gravity_scale) &&
	       float_of(walk, &b->linear_damping, &body->linear_damping) &&
	       float_of(walk, &b->angular_damping, &body->angular_damping);
}

bool block_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body)
{
	const Churn* churn = &block->churn;
	Walk walk = {.reader = reader, .block = block};
	walk.item = (Item){.indices = walk.indices, .seed = reader->seed, .number = serial};
	return pose_of(&walk, churn->position, &churn->angle, &body->pose) &&
	       float_of(&walk, &churn->velocity[0], &body->velocity.linear.x) &&
	       float_of(&walk, &churn->velocity[1], &body->velocity.linear.y) &&
	       float_of(&walk, &churn->angular_velocity, &body->velocity.angular);
}

static bool flush(Walk* walk)
{
	Batch* batch = walk->batch;
	bool good = batch->count == 0 || !batch->full || batch->full(batch->context, batch);
	batch->count = 0;
	return good;
}

static bool add_item(Walk* walk)
{
	const Block* block = walk->block;
	Batch* batch = walk->batch;
	if (batch->count == batch->capacity && !flush(walk))
		return false;
	walk->item.number = (uint64_t)walk->count++;
	int place = batch->count++;
	if (block->bodies)
	{
		scree_body_def* body = &batch->bodies[place];
		if (!body_of(walk, body))
			return false;
		if (block->simple)
		{
			body->filter = block->parts[0].filter;
			return choice_of(walk, &block->parts[0].choice, &body->attribute);
		}
	}
	for (int k = 0; k < block->part_count; ++k)
	{
		const Part* part = &block->parts[k];
		scree_collidable_def* def = &batch->parts[(size_t)place * (size_t)block->part_count + (size_t)k];
		*def = scree_collidable_def_default();
		def->filter = part->filter;
		if (!choice_of(walk, &part->choice, &def->attribute) ||
		    !pose_of(walk, part->position, &part->angle, &def->pose))
			return false;
	}
	return true;
}

static bool walk_loops(Walk* walk, int depth)
{
	walk->depth = depth;
	if (depth == walk->block->loop_count)
	{
		if (walk->batch)
			return add_item(walk);
		++walk->count;
		return true;
	}
	const Loop* loop = &walk->block->loops[depth];
	double first, end;
	if (!value_of(walk, &loop->first, &first) || !value_of(walk, &loop->end, &end))
		return false;
	if (!walk->batch && depth == walk->block->loop_count - 1)
	{
		walk->count += end > first ? (int64_t)(end - first) : 0;
		if (walk->count > walk->limit)
			return reader_fail(walk->reader, walk->place, "%.9g or more items; a scene has at most %d",
			                   (double)walk->count, SCENE_MAX_BODIES);
		return true;
	}
	for (double index = first; index < end; ++index)
	{
		if (!walk->batch && ++walk->rounds > MAX_ROUNDS)
			return reader_fail(walk->reader, walk->place, "more than %d rounds of nested ranges", MAX_ROUNDS);
		walk->indices[depth] = index;
		if (!walk_loops(walk, depth + 1))
			return false;
	}
	walk->depth = depth;
	return true;
}

bool block_count(Reader* reader, const Place* place, Block* block, int64_t limit)
{
	Walk walk = {.reader = reader, .block = block, .limit = limit, .place = place};
	walk.item.indices = walk.indices;
	walk.item.seed = reader->seed;
	bool good = walk_loops(&walk, 0);
	block->count = walk.count;
	return good;
}

bool block_walk(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context)
{
	Batch batch = {.block = block, .full = full, .context = context, .capacity = BATCH_SIZE / block->part_count};
	if (block->count < batch.capacity)
		batch.capacity = (int)block->count;
	if (batch.capacity == 0)
		return true;
	size_t items = (size_t)batch.capacity;
	bool parts = !block->bodies || !block->simple;
	batch.bodies = block->bodies ? malloc(items * sizeof(scree_body_def)) : NULL;
	batch.parts = parts ? malloc(items * (size_t)block->part_count * sizeof(scree_collidable_def)) : NULL;
	bool good = (batch.bodies || !block->bodies) && (batch.parts || !parts);
	if (!good)
		reader_fail(reader, NULL, "out of memory");

	Walk walk = {.reader = reader, .block = block, .batch = &batch};
	walk.item.indices = walk.indices;
	walk.item.seed = reader->seed;
	good = good && walk_loops(&walk, 0) && flush(&walk);
	free(batch.bodies);
	free(batch.parts);
	return good;
}
