// SPDX-License-Identifier: MIT
// evaluate.c -- computes the items of a block: bodies and collidables as scree.h defines them.
#include "scene/evaluate.h"
#include "scene/block_items.h"
#include <stdlib.h>

static bool choice_of(const Items* items, const Choice* choice, scree_attribute* attribute)
{
	double position = 0;
	if (choice->count > 1 && !items_value(items, &choice->choose, &position))
		return false;
	*attribute = (scree_attribute){(uint32_t)choice->attributes[(int)position], 0};
	return true;
}

static bool filter_of(const Items* items, const Part* part, scree_filter* filter)
{
	double group;
	*filter = part->filter;
	if (!items_value(items, &part->group, &group))
		return false;
	filter->group = (int32_t)group;
	return true;
}

static bool bits_of(const Items* items, const Number* number, uint32_t* bits)
{
	double value;
	if (!items_value(items, number, &value))
		return false;
	*bits = (uint32_t)value;
	return true;
}

static bool body_of(const Items* items, const Block* b, scree_body_def* body)
{
	*body = scree_body_def_default();
	body->type = b->type;
	body->locks = b->locks;
	body->disabled = b->disabled;
	return items_pose(items, b->position, &b->angle, &body->pose) &&
	       items_vec(items, b->velocity, &body->velocity.linear) &&
	       items_float(items, &b->angular_velocity, &body->velocity.angular) &&
	       items_float(items, &b->gravity_scale, &body->gravity_scale) &&
	       items_float(items, &b->linear_damping, &body->linear_damping) &&
	       items_float(items, &b->angular_damping, &body->angular_damping);
}

bool evaluate_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body)
{
	const Churn* churn = &block->churn;
	Items items;
	items_open(&items, reader, serial);
	return items_pose(&items, churn->position, &churn->angle, &body->pose) &&
	       items_vec(&items, churn->velocity, &body->velocity.linear) &&
	       items_float(&items, &churn->angular_velocity, &body->velocity.angular);
}

static bool flush(Batch* batch)
{
	bool good = batch->count == 0 || !batch->full || batch->full(batch->context, batch);
	batch->count = 0;
	return good;
}

static bool add_item(Items* items, void* context)
{
	Batch* batch = context;
	const Block* block = batch->block;
	if (batch->count == batch->capacity && !flush(batch))
		return false;
	int index = batch->count++;
	if (block->bodies)
	{
		scree_body_def* body = &batch->bodies[index];
		if (!body_of(items, block, body))
			return false;
		if (block->parts.simple)
			return filter_of(items, &block->parts.list[0], &body->filter) &&
			       bits_of(items, &block->parts.list[0].reports, &body->reports) &&
			       bits_of(items, &block->parts.list[0].sensor, &body->sensor) &&
			       choice_of(items, &block->parts.list[0].choice, &body->attribute);
	}
	for (int k = 0; k < block->parts.count; ++k)
	{
		const Part* part = &block->parts.list[k];
		scree_collidable_def* def = &batch->parts[(size_t)index * (size_t)block->parts.count + (size_t)k];
		*def = scree_collidable_def_default();
		if (!filter_of(items, part, &def->filter) || !bits_of(items, &part->reports, &def->reports) ||
		    !bits_of(items, &part->sensor, &def->sensor) || !choice_of(items, &part->choice, &def->attribute) ||
		    !items_pose(items, part->position, &part->angle, &def->pose))
			return false;
	}
	return true;
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
	good = good && items_run(reader, &block->loops, add_item, &batch) && flush(&batch);
	free(batch.bodies);
	free(batch.parts);
	return good;
}
