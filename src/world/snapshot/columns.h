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

typedef struct // a member of a struct
{
	const char* name; // null: the member is named by its offset
	ColumnKind kind;
	int offset, bytes;
	int count; // number of values: above 1 for an array in a struct of which there is only one
} Column;

// A column of a member; bools and 64-bit numbers of steps are found by their type. COLUMN_COUNTS: ints are of another kind.
// clang-format off
#define COLUMN_AS(kind, type, member, value, count) \
	{#member, kind, (int)offsetof(type, member), (int)sizeof(value), count}
#define MEMBER_OF(type, member) (((type*)0)->member)
#define COLUMN_COUNTS(type, member, kind)                                                                     \
	COLUMN_AS(_Generic(MEMBER_OF(type, member), bool: COLUMN_TRUTH, int64_t: COLUMN_STEP, int: kind, default: \
	                   COLUMN_ZERO), type, member, MEMBER_OF(type, member), 1)
#define COLUMN(type, member) COLUMN_COUNTS(type, member, COLUMN_ZERO)
// clang-format on
#define COLUMN_INDEX(type, member) COLUMN_AS(COLUMN_NONE, type, member, MEMBER_OF(type, member), 1)
#define COLUMN_ALL(type, member)   COLUMN_AS(COLUMN_EACH, type, member, MEMBER_OF(type, member), 1)
#define COLUMN_ARRAY(type, member) \
	COLUMN_AS(COLUMN_COUNT, type, member, int, (int)(sizeof MEMBER_OF(type, member) / sizeof(int)))

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

// Fails with a sentence that names item k of a kind, unless `condition` is true. A variable `index` names the snapshot.
#define CHECK_ITEM(condition, kind, k)                                                                   \
	do                                                                                                   \
	{                                                                                                    \
		if (!(condition))                                                                                \
			return snapshot_refuse(index, "%s %d is not consistent: !(%s)", kind, (int)(k), #condition); \
	} while (0)

#endif
