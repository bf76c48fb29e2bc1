// SPDX-License-Identifier: MIT
// item_check.h -- checks items of pools that come from bytes of a user: of a snapshot, or of the state of a world of a batch.
#ifndef ITEM_CHECK_H
#define ITEM_CHECK_H
#include "world/snapshot/columns.h"

typedef struct // numbers of items in use
{
	int bodies, collidables, attributes, contacts, joints;
	int padded_bodies; // bodies with the padding behind them that is stored too
	Word unused;       // CONTACT_* flags that no contact may have
} ItemCounts;

// Each function fails with SCREE_ERROR_INVALID if an item of a pool is out of range. index: the subject of the message.
// pools: items by PoolId, null for a pool that the bytes do not contain.

// Checks that all numbers of pools of floats are within limits: kernels convert some of them to integers.
scree_status floats_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools);

// Checks the collidables, bodies, flags and features of contacts, without their colors and places.
scree_status contacts_check(const ChunkIndex* index, const ItemCounts* counts, void* const* pools);

static inline bool in_range(int x, int least, int end) { return x >= least && x < end; }

// Returns whether two floats are the cosine and the sine of an angle.
static inline bool is_turn(float c, float s)
{
	float error = c * c + s * s - 1.0f;
	return error < 1e-3f && error > -1e-3f;
}

#endif
