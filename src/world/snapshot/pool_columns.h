// SPDX-License-Identifier: MIT
// pool_columns.h -- declares the columns of the pools that a snapshot contains.
#ifndef POOL_COLUMNS_H
#define POOL_COLUMNS_H
#include "backend/tables.h"
#include "world/snapshot/columns.h"

typedef struct // the columns of a pool; the table refers to this memory
{
	ColumnTable table;
	Column columns[COLUMN_MOST];
	char prefix[CHUNK_NAME];
} PoolColumns;

// Returns whether a snapshot contains a pool. Sets its columns if so.
bool pool_columns(PoolId pool, PoolColumns* columns);

extern const ColumnTable leaf_tables[2]; // the column of the leaves of each tree

// Sets the rows of a pool that a snapshot does not contain to the values that they have where there is no constraint.
void pool_inert(PoolId pool, void* items, int count);

#endif
