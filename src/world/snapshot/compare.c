// SPDX-License-Identifier: MIT
// compare.c -- finds the columns in which two snapshots differ.
#include "world/snapshot/compare.h"
#include "platform/error.h"
#include "world/definition.h"
#include "world/snapshot/host_columns.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define WORD 4 // bytes of a larger value that a difference contains

static bool is_column(const ColumnTable* table, const Column* column, const char* name)
{
	char full[CHUNK_NAME + 1];
	snprintf(full, sizeof full, "%s.%s", table->prefix, column->name);
	return strcmp(full, name) == 0;
}

static const struct
{
	const char* pool;
	const char* words[20];
} named[] = {
#define POOL_WORDS(pool, ...) {#pool, {__VA_ARGS__}},
#include "pools/pool_words.def"
};

// Writes the name of a word of a pool's items, such as "cos" for column "pool.pose+8". Other columns have no such name.
static void name_word(scree_difference* d)
{
	char pool[CHUNK_NAME + 1];
	int offset;
	if (sscanf(d->column, "pool.%63[a-z_]+%d", pool, &offset) != 2)
		return;
	for (size_t k = 0; k < sizeof named / sizeof *named; ++k)
		if (strcmp(named[k].pool, pool) == 0 && offset >= 0 && offset < 80 && named[k].words[offset / 4])
			snprintf(d->word, sizeof d->word, "%s", named[k].words[offset / 4]);
}

// Returns the byte that the values of a missing chunk consist of.
static int missing_byte(const char* name)
{
	for (int t = 0; t < HOST_TABLES; ++t)
		for (int c = 0; c < host_columns[t].table.count; ++c)
			if (is_column(&host_columns[t].table, host_columns[t].table.columns + c, name))
				return host_columns[t].table.columns[c].kind == COLUMN_NONE ? 0xff : 0;
	return 0;
}

// Returns a byte of value k; chunk null: the chunk is missing.
static uint8_t byte_of(const Chunk* chunk, int missing, int k, int byte)
{
	if (!chunk)
		return (uint8_t)missing;
	if (k >= chunk->count || byte >= chunk->bytes)
		return 0;
	return chunk->first[(size_t)(chunk->equal ? 0 : k) * (size_t)chunk->bytes + (size_t)byte];
}

// Returns the first byte in which value k differs, or -1.
static int first_byte(const Chunk* a, const Chunk* b, int missing, int k, int bytes)
{
	for (int byte = 0; byte < bytes; ++byte)
		if (byte_of(a, missing, k, byte) != byte_of(b, missing, k, byte))
			return byte;
	return -1;
}

static uint64_t word_of(const Chunk* chunk, int missing, int k, int byte, int bytes)
{
	uint64_t word = 0;
	for (int i = 0; i < bytes; ++i)
		word |= (uint64_t)byte_of(chunk, missing, k, byte + i) << 8 * i;
	return word;
}

// Returns whether two chunks have the same bytes in the file; most columns do.
static bool same_bytes(const Chunk* a, const Chunk* b)
{
	return a && b && a->bytes == b->bytes && a->count == b->count && a->equal == b->equal &&
	       memcmp(a->first, b->first, (size_t)a->bytes * (size_t)(a->equal ? a->count > 0 : a->count)) == 0;
}

// Compares a column. Returns whether it differs. Values beyond the end of the shorter column differ.
static bool compare(const Chunk* a, const Chunk* b, scree_difference* d)
{
	const Chunk* known = a ? a : b;
	if (same_bytes(a, b))
		return false;
	snprintf(d->column, sizeof d->column, "%.*s", known->name_length, known->name);
	name_word(d);
	int missing = missing_byte(d->column), bytes = a && a->bytes > known->bytes ? a->bytes : known->bytes;
	bytes = b && b->bytes > bytes ? b->bytes : bytes;
	d->count_a = a ? a->count : known->count;
	d->count_b = b ? b->count : known->count;
	int count = d->count_a > d->count_b ? d->count_a : d->count_b, shorter = d->count_a + d->count_b - count;
	for (int k = 0; k < count; ++k)
	{
		int byte = first_byte(a, b, missing, k, bytes);
		if (byte < 0 && k < shorter)
			continue;
		if (d->items++ > 0)
			continue;
		d->item = k;
		d->bytes = bytes <= (int)sizeof d->value_a ? bytes : WORD;
		d->offset = byte < 0 || bytes <= (int)sizeof d->value_a ? 0 : byte / WORD * WORD;
		d->value_a = word_of(a, missing, k, d->offset, d->bytes);
		d->value_b = word_of(b, missing, k, d->offset, d->bytes);
	}
	return d->items > 0;
}

typedef struct
{
	const Chunk *chunk, *other; // other: chunk of the same name in the other snapshot, or null
	bool second;                // the chunk is that of snapshot b, and a has none of this name
} Both;

// Orders chunks by their places, those of snapshot b at the end.
static int by_place(const void* x, const void* y)
{
	const Both *a = x, *b = y;
	if (a->second != b->second)
		return a->second ? 1 : -1;
	return a->chunk->name < b->chunk->name ? -1 : a->chunk->name > b->chunk->name;
}

static int list_chunks(const ChunkIndex* a, const ChunkIndex* b, bool second, Both* list)
{
	int count = 0;
	for (uint32_t k = 0; k < a->size; ++k)
	{
		const Chunk* chunk = a->chunks + k;
		char name[CHUNK_NAME + 1];
		snprintf(name, sizeof name, "%.*s", chunk->name_length, chunk->name_length > 0 ? chunk->name : "");
		if (!*name)
			continue;
		const Chunk* other = chunk_find(b, name);
		if (!second || !other)
			list[count++] = (Both){chunk, other, second};
	}
	return count;
}

static scree_status compare_all(const ChunkIndex* a, const ChunkIndex* b, void* differences, size_t stride,
                                int capacity, int* count)
{
	Both* list = scree_allocate(((size_t)a->size + b->size) * sizeof *list);
	if (!list)
		return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory to compare snapshots", a->function);
	int chunks = list_chunks(a, b, false, list);
	chunks += list_chunks(b, a, true, list + chunks);
	qsort(list, (size_t)chunks, sizeof *list, by_place);
	*count = 0;
	for (int k = 0; k < chunks; ++k)
	{
		scree_difference d = {0};
		const Both* both = list + k;
		if (!compare(both->second ? NULL : both->chunk, both->second ? both->chunk : both->other, &d))
			continue;
		if (*count < capacity)
			write_result((char*)differences + stride * (size_t)*count, stride, &d, sizeof d);
		++*count;
	}
	scree_release(list);
	return SCREE_OK;
}

scree_status snapshots_compare(const char* function, const void* a, size_t size_a, const void* b, size_t size_b,
                               void* differences, size_t stride, int capacity, int* count)
{
	ChunkIndex first, second;
	TRY(chunks_open(&first, function, a, size_a));
	scree_status status = chunks_open(&second, function, b, size_b);
	if (status == SCREE_OK)
	{
		status = compare_all(&first, &second, differences, stride, capacity, count);
		chunks_close(&second);
	}
	chunks_close(&first);
	return status;
}
