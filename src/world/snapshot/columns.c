// SPDX-License-Identifier: MIT
// columns.c -- writes and reads arrays of structs as columns.
#include "world/snapshot/columns.h"
#include "platform/error.h"
#include <limits.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#define BLOCK 256 // number of structs whose columns are copied one after the other, while the structs are in the cache

int columns_of_words(int bytes, Column columns[COLUMN_MOST])
{
	ASSERT(bytes % 4 == 0 && bytes / 4 <= COLUMN_MOST);
	for (int k = 0; k < bytes / 4; ++k)
		columns[k] = (Column){.offset = (uint16_t)(4 * k), .bytes = 4, .count = 1};
	return bytes / 4;
}

static void name_column(const ColumnTable* table, const Column* column, char name[CHUNK_NAME + 1])
{
	if (column->name)
		snprintf(name, CHUNK_NAME + 1, "%s.%s", table->prefix, column->name);
	else
		snprintf(name, CHUNK_NAME + 1, "%s+%d", table->prefix, column->offset);
}

static int smaller(int a, int b) { return a < b ? a : b; }

static const char* value_at(const void* items, size_t stride, const Column* column, int k)
{
	return (const char*)items + column->offset +
	       (column->count > 1 ? (size_t)column->bytes * (size_t)k : stride * (size_t)k);
}

static bool is_default(const Column* column, const char* value)
{
	for (int k = 0; k < column->bytes; ++k)
		if (value[k] != (column->kind == COLUMN_NONE ? -1 : 0))
			return false;
	return true;
}

static bool all_equal(const void* items, size_t stride, const Column* column, int begin, int end)
{
	const char* first = value_at(items, stride, column, 0);
	for (int k = begin; k < end; ++k)
		if (memcmp(first, value_at(items, stride, column, k), (size_t)column->bytes) != 0)
			return false;
	return true;
}

static int values_of(const Column* column, int count) { return column->count > 1 ? column->count * count : count; }

// Copies values begin to end - 1 between structs and the values of a chunk.
static void take_values(uint8_t* to, const void* items, size_t stride, const Column* column, int begin, int end)
{
	if (column->bytes == 4)
		for (int k = begin; k < end; ++k)
			memcpy(to + 4 * (size_t)k, value_at(items, stride, column, k), 4);
	else
		for (int k = begin; k < end; ++k)
			memcpy(to + (size_t)column->bytes * (size_t)k, value_at(items, stride, column, k), (size_t)column->bytes);
}

static void put_values(const Chunk* chunk, void* items, size_t stride, const Column* column, int begin, int end)
{
	size_t step = chunk->equal ? 0 : (size_t)column->bytes;
	if (column->bytes == 4)
		for (int k = begin; k < end; ++k)
			memcpy((char*)value_at(items, stride, column, k), chunk->first + step * (size_t)k, 4);
	else
		for (int k = begin; k < end; ++k)
			memcpy((char*)value_at(items, stride, column, k), chunk->first + step * (size_t)k, (size_t)column->bytes);
}

void columns_write(ChunkWriter* writer, const ColumnTable* table, const void* items, size_t stride, int count)
{
	bool varies[COLUMN_MOST] = {false};
	uint8_t* values[COLUMN_MOST] = {NULL};
	size_t at[COLUMN_MOST];
	ASSERT(table->count <= COLUMN_MOST);
	for (int first = 0; first < count; first += BLOCK)
		for (int c = 0; c < table->count; ++c)
		{
			const Column* column = table->columns + c;
			int end = column->count > 1 ? values_of(column, count) : smaller(first + BLOCK, count);
			varies[c] = varies[c] || column->kind == COLUMN_EACH || !all_equal(items, stride, column, first, end);
		}
	for (int c = 0; c < table->count; ++c)
	{
		const Column* column = table->columns + c;
		char name[CHUNK_NAME + 1];
		int all = values_of(column, count);
		if (count == 0 || (!varies[c] && is_default(column, value_at(items, stride, column, 0))))
			continue;
		name_column(table, column, name);
		values[c] = chunk_add(writer, name, column->bytes, all, varies[c] ? all : 1);
		if (!values[c])
			return;
		at[c] = (size_t)(values[c] - writer->bytes); // a later chunk may move the memory
		if (!varies[c])
			memcpy(values[c], value_at(items, stride, column, 0), (size_t)column->bytes);
	}
	for (int first = 0; first < count; first += BLOCK)
		for (int c = 0; c < table->count; ++c)
		{
			const Column* column = table->columns + c;
			int end = column->count > 1 ? values_of(column, count) : smaller(first + BLOCK, count);
			if (values[c] && varies[c])
				take_values(writer->bytes + at[c], items, stride, column, first, end);
		}
}

scree_status snapshot_refuse(const ChunkIndex* index, const char* format, ...)
{
	char sentence[256];
	va_list arguments;
	va_start(arguments, format);
	vsnprintf(sentence, sizeof sentence, format, arguments);
	va_end(arguments);
	return fail(SCREE_ERROR_INVALID, "%s: %s: %s", index->function, index->subject, sentence);
}

scree_status snapshot_refuse_item(const ChunkIndex* index, const char* kind, int k, const char* condition)
{
	return snapshot_refuse(index, "%s %d is not consistent%s", kind, k, condition);
}

// Returns whether a value is one that a column of this kind may have.
static bool is_allowed(ColumnKind kind, const uint8_t* value)
{
	int count;
	int64_t step;
	switch (kind)
	{
	case COLUMN_TRUTH:
		return *value <= 1;
	case COLUMN_COUNT:
	case COLUMN_COUNTER:
		memcpy(&count, value, sizeof count);
		return (count >= 0 && count <= COUNT_MOST) || (kind == COLUMN_COUNTER && count == INT_MAX);
	case COLUMN_STEP:
		memcpy(&step, value, sizeof step);
		return step >= -1 && step <= STEP_MOST;
	default:
		return true;
	}
}

static scree_status check_values(const ChunkIndex* index, const Column* column, const Chunk* chunk)
{
	for (int k = 0; k < (chunk->equal ? smaller(chunk->count, 1) : chunk->count); ++k)
		if (!is_allowed(column->kind, chunk->first + (size_t)k * (size_t)column->bytes))
			return snapshot_refuse(index, "value %d of chunk %.*s is out of range", k, chunk->name_length, chunk->name);
	return SCREE_OK;
}

scree_status columns_check(const ChunkIndex* index, const ColumnTable* table, int count)
{
	for (int c = 0; c < table->count; ++c)
	{
		const Column* column = table->columns + c;
		char name[CHUNK_NAME + 1];
		name_column(table, column, name);
		const Chunk* chunk = chunk_find(index, name);
		int all = values_of(column, count);
		if (chunk && (chunk->bytes != column->bytes || chunk->count != all))
			return snapshot_refuse(index, "chunk %s has %d values of %d bytes, must have %d of %d", name, chunk->count,
			                       chunk->bytes, all, column->bytes);
		if (column->kind == COLUMN_EACH && all > 0 && (!chunk || chunk->equal))
			return snapshot_refuse(index, "chunk %s does not store its %d values", name, all);
		if (chunk)
			TRY(check_values(index, column, chunk));
	}
	return SCREE_OK;
}

void columns_read(const ChunkIndex* index, const ColumnTable* table, void* items, size_t stride, int count)
{
	static const uint8_t ones[8] = {255, 255, 255, 255, 255, 255, 255, 255};
	const Chunk* chunks[COLUMN_MOST];
	for (int c = 0; c < table->count; ++c)
	{
		char name[CHUNK_NAME + 1];
		name_column(table, table->columns + c, name);
		chunks[c] = chunk_find(index, name);
	}
	for (int first = 0; first < count; first += BLOCK)
		for (int c = 0; c < table->count; ++c)
		{
			const Column* column = table->columns + c;
			int end = column->count > 1 ? values_of(column, count) : smaller(first + BLOCK, count);
			if (chunks[c])
				put_values(chunks[c], items, stride, column, first, end);
			else if (column->kind == COLUMN_NONE)
				put_values(&(Chunk){.first = ones, .equal = true}, items, stride, column, first, end);
			else
				for (int k = first; k < end; ++k)
					memset((char*)value_at(items, stride, column, k), 0, (size_t)column->bytes);
		}
}
