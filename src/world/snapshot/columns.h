// SPDX-License-Identifier: MIT
// columns.h -- writes and reads arrays of structs as columns: a chunk for each member of the struct.
#ifndef COLUMNS_H
#define COLUMNS_H
#include "world/snapshot/chunks.h"

#define COLUMN_MOST 128 // maximum number of columns of a table

typedef enum
{
	COLUMN_ZERO,    // values are 0 if the chunk is missing
	COLUMN_NONE,    // an index, -1 if the chunk is missing
	COLUMN_TRUTH,   // a bool
	COLUMN_COUNT,   // an int from 0 to COUNT_MOST
	COLUMN_COUNTER, // a counter of the device: as COLUMN_COUNT, or INT_MAX
	COLUMN_STEP,    // a number of steps in 64 bits, from -1 to STEP_MOST
	COLUMN_EACH,    // all values are stored, also if they are equal, so that a small file cannot demand much memory
} ColumnKind;

// Limits far above any count. The library adds small numbers to counts, and subtracts them from each other.
#define COUNT_MOST (1 << 30)
#define STEP_MOST  ((int64_t)1 << 62)

typedef struct // a member of a struct; small numbers, because these tables are a part of what a page downloads
{
	const char* name; // null: the member is named by its offset
	uint16_t offset, bytes;
	uint16_t count; // number of values: above 1 for an array in a struct of which there is only one
	uint16_t kind;  // ColumnKind
} Column;

// A column of a member; bools and 64-bit numbers of steps are found by their type. COLUMN_COUNTS: ints are of another kind.
// clang-format off
#define COLUMN_AS(kind, type, member, value, count) \
	{#member, offsetof(type, member), sizeof(value), count, kind}
#define MEMBER_OF(type, member) (((type*)0)->member)
#define COLUMN_COUNTS(type, member, kind)                                                                     \
	COLUMN_AS(_Generic(MEMBER_OF(type, member), bool: COLUMN_TRUTH, int64_t: COLUMN_STEP, int: kind, default: \
	                   COLUMN_ZERO), type, member, MEMBER_OF(type, member), 1)
#define COLUMN(type, member) COLUMN_COUNTS(type, member, COLUMN_ZERO)
// clang-format on
#define COLUMN_INDEX(type, member) COLUMN_AS(COLUMN_NONE, type, member, MEMBER_OF(type, member), 1)
#define COLUMN_ALL(type, member)   COLUMN_AS(COLUMN_EACH, type, member, MEMBER_OF(type, member), 1)
#define COLUMN_ARRAY(type, member) \
	COLUMN_AS(COLUMN_COUNT, type, member, int, sizeof MEMBER_OF(type, member) / sizeof(int))

typedef struct // columns of a struct
{
	const char* prefix; // prefix of the names of the chunks
	const Column* columns;
	int count;
} ColumnTable;

#define COLUMN_TABLE(prefix, columns)                               \
	{                                                               \
		prefix, columns, (int)(sizeof(columns) / sizeof *(columns)) \
	}

// Sets `columns` to the words of four bytes of a struct, named by their offsets. Returns their number.
int columns_of_words(int bytes, Column columns[COLUMN_MOST]);

// Writes the columns of `count` structs. A column whose values are all the default is not written.
void columns_write(ChunkWriter* writer, const ColumnTable* table, const void* items, size_t stride, int count);

// Fails unless the chunks of the columns have the values of `count` structs. To be called before memory is allocated.
scree_status columns_check(const ChunkIndex* index, const ColumnTable* table, int count);

// Reads the columns of `count` structs, which columns_check has checked; values of missing chunks are set to the default.
void columns_read(const ChunkIndex* index, const ColumnTable* table, void* items, size_t stride, int count);

// Fails with SCREE_ERROR_INVALID and a sentence about the snapshot.
scree_status snapshot_refuse(const ChunkIndex* index, const char* format, ...);

// Fails with SCREE_ERROR_INVALID and a sentence that names item k of a kind, and the condition that it does not meet.
scree_status snapshot_refuse_item(const ChunkIndex* index, const char* kind, int k, const char* condition);

// The texts of the conditions would add 2 kB to the npm package.
#ifdef SCREE_SMALL
#define CONDITION_TEXT(condition) ""
#else
#define CONDITION_TEXT(condition) ": !(" #condition ")"
#endif

// Fails with a sentence that names item k of a kind, unless `condition` is true. A variable `index` names the snapshot.
#define CHECK_ITEM(condition, kind, k)                                                     \
	do                                                                                     \
	{                                                                                      \
		if (!(condition))                                                                  \
			return snapshot_refuse_item(index, kind, (int)(k), CONDITION_TEXT(condition)); \
	} while (0)

#endif
