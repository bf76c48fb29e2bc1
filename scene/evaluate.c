// SPDX-License-Identifier: MIT
// evaluate.c -- computes the items of a block: bodies and collidables, as definitions of scree.h.
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

bool evaluate_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body)
{
	Churn churn = block->churn;
	Items items;
	items_open(&items, reader, serial);
	if (!items_store(&items, &block->churn_numbers, &churn))
		return false;
	body->pose = churn.pose;
	body->velocity = churn.velocity;
	body->asleep = false; // "asleep" is a state at the start; here a body gets another pose and velocity
	return true;
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
		*body = block->def;
		if (!items_store(items, &block->numbers, body))
			return false;
		if (block->massed)
		{
			batch->masses[index] = block->mass;
			if (!items_store(items, &block->mass_numbers, &batch->masses[index]))
				return false;
		}
		if (block->parts.simple)
			return choice_of(items, &block->parts.list[0].choice, &body->attribute);
	}
	for (int k = 0; k < block->parts.count; ++k)
	{
		const Part* part = &block->parts.list[k];
		scree_collidable_def* def = &batch->parts[(size_t)index * (size_t)block->parts.count + (size_t)k];
		*def = part->def;
		if (!items_store(items, &part->numbers, def) || !choice_of(items, &part->choice, &def->attribute))
			return false;
	}
	return true;
}

bool evaluate_block(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context)
{
	Batch batch = {.block = block, .full = full, .context = context, .capacity = BATCH_SIZE};
	batch.capacity /= block->parts.count > 0 ? block->parts.count : 1;
	if (block->count < batch.capacity)
		batch.capacity = (int)block->count;
	if (batch.capacity == 0)
		return true;
	size_t items = (size_t)batch.capacity;
	bool parts = block->parts.count > 0 && !(block->bodies && block->parts.simple);
	batch.bodies = block->bodies ? malloc(items * sizeof(scree_body_def)) : NULL;
	batch.masses = block->massed ? malloc(items * sizeof(scree_mass)) : NULL;
	batch.parts = parts ? malloc(items * (size_t)block->parts.count * sizeof(scree_collidable_def)) : NULL;
	bool good = (batch.bodies || !block->bodies) && (batch.parts || !parts) && (batch.masses || !block->massed);
	if (!good)
		reader_fail(reader, NULL, "out of memory");
	good = good && block_items_run(reader, &block->loops, add_item, &batch) && flush(&batch);
	free(batch.bodies);
	free(batch.masses);
	free(batch.parts);
	return good;
}
