// SPDX-License-Identifier: MIT
// evaluate.c -- computes the items of a block: bodies and collidables as scree.h defines them.
#include "scene/evaluate.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

// Inner loops may be empty, so that a count of items does not bound the time of the outer loops. This does.
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
	const Location* location; // of the block, while counting
} Evaluation;

// "expression" is 3, must be ..., at i = 1, j = 2
static bool item_fail(Evaluation* e, const Number* number, const char* text)
{
	char where[160] = "";
	for (int k = 0; k < e->depth; ++k)
		snprintf(where + strlen(where), sizeof where - strlen(where), "%s%s = %.9g", k ? ", " : ", at ",
		         e->block->loops[k].index, e->indices[k]);
	snprintf(e->reader->sentence, SENTENCE_SIZE, "%.180s: %s: \"%.60s\"%s%s", e->reader->file, number->path,
	         number->text, text, where);
	return false;
}

static bool value_of(Evaluation* e, const Number* number, double* value)
{
	if (!number->code)
	{
		*value = number->constant;
		return true;
	}
	const char* fault = expression_evaluate(number->code, &e->item, value);
	char must[80], text[128];
	if (fault)
	{
		snprintf(text, sizeof text, ": %s", fault);
		return item_fail(e, number, text);
	}
	fault = range_fault(number->range, *value, must, sizeof must);
	if (fault)
	{
		snprintf(text, sizeof text, " is %.9g, %s", *value, fault);
		return item_fail(e, number, text);
	}
	return true;
}

static bool float_of(Evaluation* e, const Number* number, float* value)
{
	double number_value;
	bool good = value_of(e, number, &number_value);
	*value = (float)number_value;
	return good;
}

static bool pose_of(Evaluation* e, const Number position[2], const Number* angle, scree_pose* pose)
{
	float radians;
	if (!float_of(e, &position[0], &pose->position.x) || !float_of(e, &position[1], &pose->position.y) ||
	    !float_of(e, angle, &radians))
		return false;
	pose->rotation = radians == 0 ? (scree_rot){1, 0} : scree_rot_make(radians);
	return true;
}

static bool choice_of(Evaluation* e, const Choice* choice, scree_attribute* attribute)
{
	double position = 0;
	if (choice->count > 1 && !value_of(e, &choice->choose, &position))
		return false;
	*attribute = (scree_attribute){(uint32_t)choice->attributes[(int)position], 0};
	return true;
}

static bool body_of(Evaluation* e, scree_body_def* body)
{
	const Block* b = e->block;
	*body = scree_body_def_default();
	body->type = b->type;
	body->locks = b->locks;
	body->disabled = b->disabled;
	return pose_of(e, b->position, &b->angle, &body->pose) && float_of(e, &b->velocity[0], &body->velocity.linear.x) &&
	       float_of(e, &b->velocity[1], &body->velocity.linear.y) &&
	       float_of(e, &b->angular_velocity, &body->velocity.angular) &&
	       float_of(e, &b->gravity_scale, &body->gravity_scale) &&
	       float_of(e, &b->linear_damping, &body->linear_damping) &&
	       float_of(e, &b->angular_damping, &body->angular_damping);
}

bool evaluate_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body)
{
	const Churn* churn = &block->churn;
	Evaluation e = {.reader = reader, .block = block};
	e.item = (Item){.indices = e.indices, .seed = reader->seed, .number = serial};
	return pose_of(&e, churn->position, &churn->angle, &body->pose) &&
	       float_of(&e, &churn->velocity[0], &body->velocity.linear.x) &&
	       float_of(&e, &churn->velocity[1], &body->velocity.linear.y) &&
	       float_of(&e, &churn->angular_velocity, &body->velocity.angular);
}

static bool flush(Evaluation* e)
{
	Batch* batch = e->batch;
	bool good = batch->count == 0 || !batch->full || batch->full(batch->context, batch);
	batch->count = 0;
	return good;
}

static bool add_item(Evaluation* e)
{
	const Block* block = e->block;
	Batch* batch = e->batch;
	if (batch->count == batch->capacity && !flush(e))
		return false;
	e->item.number = (uint64_t)e->count++;
	int index = batch->count++;
	if (block->bodies)
	{
		scree_body_def* body = &batch->bodies[index];
		if (!body_of(e, body))
			return false;
		if (block->parts.simple)
		{
			body->filter = block->parts.list[0].filter;
			return choice_of(e, &block->parts.list[0].choice, &body->attribute);
		}
	}
	for (int k = 0; k < block->parts.count; ++k)
	{
		const Part* part = &block->parts.list[k];
		scree_collidable_def* def = &batch->parts[(size_t)index * (size_t)block->parts.count + (size_t)k];
		*def = scree_collidable_def_default();
		def->filter = part->filter;
		if (!choice_of(e, &part->choice, &def->attribute) || !pose_of(e, part->position, &part->angle, &def->pose))
			return false;
	}
	return true;
}

static bool run_loops(Evaluation* e, int depth)
{
	e->depth = depth;
	if (depth == e->block->loop_count)
	{
		if (e->batch)
			return add_item(e);
		++e->count;
		return true;
	}
	const Loop* loop = &e->block->loops[depth];
	double first, end;
	if (!value_of(e, &loop->first, &first) || !value_of(e, &loop->end, &end))
		return false;
	if (!e->batch && depth == e->block->loop_count - 1)
	{
		e->count += end > first ? (int64_t)(end - first) : 0;
		if (e->count > e->limit)
			return reader_fail(e->reader, e->location, "%.9g or more items; a scene has at most %d", (double)e->count,
			                   SCENE_MAX_BODIES);
		return true;
	}
	for (double index = first; index < end; ++index)
	{
		if (!e->batch && ++e->rounds > MAX_ROUNDS)
			return reader_fail(e->reader, e->location, "more than %d rounds of nested ranges", MAX_ROUNDS);
		e->indices[depth] = index;
		if (!run_loops(e, depth + 1))
			return false;
	}
	e->depth = depth;
	return true;
}

bool evaluate_count(Reader* reader, const Location* location, Block* block, int64_t limit)
{
	Evaluation e = {.reader = reader, .block = block, .limit = limit, .location = location};
	e.item.indices = e.indices;
	e.item.seed = reader->seed;
	bool good = run_loops(&e, 0);
	block->count = e.count;
	return good;
}

bool evaluate_block(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context)
{
	Batch batch = {.block = block, .full = full, .context = context, .capacity = BATCH_SIZE / block->parts.count};
	if (block->count < batch.capacity)
		batch.capacity = (int)block->count;
	if (batch.capacity == 0)
		return true;
	size_t items = (size_t)batch.capacity;
	bool parts = !block->bodies || !block->parts.simple;
	batch.bodies = block->bodies ? malloc(items * sizeof(scree_body_def)) : NULL;
	batch.parts = parts ? malloc(items * (size_t)block->parts.count * sizeof(scree_collidable_def)) : NULL;
	bool good = (batch.bodies || !block->bodies) && (batch.parts || !parts);
	if (!good)
		reader_fail(reader, NULL, "out of memory");

	Evaluation e = {.reader = reader, .block = block, .batch = &batch};
	e.item.indices = e.indices;
	e.item.seed = reader->seed;
	good = good && run_loops(&e, 0) && flush(&e);
	free(batch.bodies);
	free(batch.parts);
	return good;
}
