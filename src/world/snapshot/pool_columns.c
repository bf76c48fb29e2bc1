// SPDX-License-Identifier: MIT
// pool_columns.c -- lists the columns of the pools that a snapshot contains. Pools are those that outlive a step, without
// those that follow from other data. Their columns are the words of an item, named by their offsets. In pools of rows,
// each row is a column. Rows that every step prepares are left out, except those of contacts that the user may read after
// the step.
#include "world/snapshot/pool_columns.h"
#include "constraints/constraint_kinds.h"
#include "platform/error.h"
#include <stdio.h>
#include <string.h>

#define SAVED_KEPT(x)   x
#define SAVED_PLACED(x) x
#define SAVED_PREPARED(x)
#define ROW_COLUMN(type, row)                                    {#row, offsetof(struct type, row), sizeof MEMBER_OF(struct type, row), 1, COLUMN_ZERO},
#define ROW_CONTACT(name, gate, life, inert, read, written)      SAVED_##life(ROW_COLUMN(ContactRows, name))
#define ROW_CONTACT_RARE(name, gate, life, inert, read, written) SAVED_##life(ROW_COLUMN(ContactRareRows, name))
#define ROW_JOINT(name, gate, life, inert, read, written)        SAVED_##life(ROW_COLUMN(JointRows, name))
#define ROW_JOINT_RARE(name, gate, life, inert, read, written)   SAVED_##life(ROW_COLUMN(JointRareRows, name))

static const Column contact_rows[] = {ROW_COLUMN(ContactRows, body_a) ROW_COLUMN(ContactRows, body_b)
                                          CONTACT_ROWS(ROW_CONTACT)};
static const Column contact_rare_rows[] = {CONTACT_RARE_ROWS(ROW_CONTACT_RARE) ROW_COLUMN(
    ContactRareRows, total_impulse1) ROW_COLUMN(ContactRareRows, total_impulse2) ROW_COLUMN(ContactRareRows, approach1)
                                               ROW_COLUMN(ContactRareRows, approach2)};
static const Column joint_rows[] = {ROW_COLUMN(JointRows, body_a) ROW_COLUMN(JointRows, body_b) JOINT_ROWS(ROW_JOINT)};
static const Column joint_rare_rows[] = {JOINT_RARE_ROWS(ROW_JOINT_RARE)};

typedef struct
{
	PoolId pool;
	const Column* columns;
	int count;
} RowColumns;

#define ROWS(name)                                              \
	{                                                           \
		POOL_##name, name, (int)(sizeof(name) / sizeof *(name)) \
	}
static const RowColumns rows_of[] = {ROWS(contact_rows), ROWS(contact_rare_rows), ROWS(joint_rows),
                                     ROWS(joint_rare_rows)};

static const Column leaf_column[] = {{"each", 0, sizeof(int), 1, COLUMN_EACH}};
const ColumnTable leaf_tables[2] = {COLUMN_TABLE("leaves0", leaf_column), COLUMN_TABLE("leaves1", leaf_column)};

// Returns whether a pool follows from other data of a snapshot: counters are saved by name, samples of paths with the
// paths, and the other pools follow from the data on the host. Saves are no part of a snapshot.
static bool follows(PoolId pool)
{
	switch (pool_info[pool].per)
	{
	case PER_CHAIN:
	case PER_BRANCH:
	case PER_BODY_GROUP:
	case PER_COLLIDABLE_GROUP:
	case PER_CONTACT_GROUP:
	case PER_PATH_SAMPLE:
	case PER_ONE:
	case PER_LEAF:
	case PER_SAVED:
		return true;
	default:
		return pool_info[pool].role > STANDING;
	}
}

bool pool_columns(PoolId pool, PoolColumns* columns)
{
	if (follows(pool))
		return false;
	ColumnTable* table = &columns->table;
	snprintf(columns->prefix, sizeof columns->prefix, "pool.%s", pool_info[pool].name);
	table->prefix = columns->prefix;
	for (size_t k = 0; k < sizeof rows_of / sizeof *rows_of; ++k)
		if (rows_of[k].pool == pool)
		{
			table->columns = rows_of[k].columns;
			table->count = rows_of[k].count;
			return true;
		}
	table->columns = columns->columns;
	table->count = columns_of_words((int)pool_info[pool].bytes, columns->columns);
	if (pool == POOL_pair || pool == POOL_contact_place_slot || pool == POOL_joint_place_slot || pool == POOL_joined ||
	    pool == POOL_excluded || pool == POOL_joint_flags)
		columns->columns[0].kind = COLUMN_EACH;
	return true;
}

#define ROW_INERT(name, gate, life, inert, read, written) \
	for (int lane = 0; lane < MAX_LANES; ++lane)          \
		rows->name[lane] = inert;

void pool_inert(PoolId pool, void* items, int count)
{
	for (int k = 0; k < count; ++k)
		switch (pool)
		{
		case POOL_contact_rows:
		{
			struct ContactRows* rows = (struct ContactRows*)items + k;
			CONTACT_ROWS(ROW_INERT)
			break;
		}
		case POOL_contact_rare_rows:
		{
			struct ContactRareRows* rows = (struct ContactRareRows*)items + k;
			CONTACT_RARE_ROWS(ROW_INERT)
			break;
		}
		default:
			return;
		}
}
