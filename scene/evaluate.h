// SPDX-License-Identifier: MIT
// evaluate.h -- computes the items of a block: bodies and collidables as scree.h defines them.
#ifndef EVALUATE_H
#define EVALUATE_H
#include "scene/block.h"

#define BATCH_SIZE 65536 // maximum number of items or collidables of a batch; not less than MAX_PARTS

typedef struct // consecutive items; their attributes are positions in Scene.attributes, with generation 0
{
	int count, capacity;         // number of items
	scree_body_def* bodies;      // count, or null
	scree_collidable_def* parts; // count * Block.parts.count, or null
	const Block* block;
	bool (*full)(void* context, const void* batch); // receives the items; null to drop them
	void* context;
} Batch;

// Computes all items, batch by batch. Fails if a number of an item is out of range (only the first time, because the
// results are always the same), if memory is short, or if full returns false.
bool evaluate_block(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context);

// Computes the pose and the velocity that churn gives a body. serial counts the bodies that churn has changed.
bool evaluate_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body);

#endif
