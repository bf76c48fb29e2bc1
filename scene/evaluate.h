// SPDX-License-Identifier: MIT
// evaluate.h -- computes the items of a block: bodies and collidables, as definitions of scree.h.
#ifndef EVALUATE_H
#define EVALUATE_H
#include "scene/block.h"

#define BATCH_SIZE 65536 // maximum number of items or collidables of a batch; not less than MAX_PARTS

typedef struct // consecutive items of a block; their attributes are positions in Scene.attributes, with generation 0
{
	int count, capacity;         // number of items; maximum number
	scree_body_def* bodies;      // array of count bodies, or null
	scree_mass* masses;          // array of count masses; null unless Block.massed
	scree_collidable_def* parts; // array of count * Block.parts.count collidables, or null
	const Block* block;
	bool (*full)(void* context, const void* batch); // function that receives a full batch; null: the items are dropped
	void* context;
} Batch;

// Computes all items, batch by batch. Fails if a number of an item is out of range (this can happen only in the first
// call, because the results are always the same), if memory is short, or if full() returns false.
bool evaluate_block(Reader* reader, const Block* block, bool (*full)(void* context, const void* batch), void* context);

// Computes the pose and the velocity that churn gives to a body. serial: number of earlier changes of the block, for
// random().
bool evaluate_churn(Reader* reader, const Block* block, uint64_t serial, scree_body_def* body);

#endif
