// SPDX-License-Identifier: MIT
// chunks.c -- writes and reads the chunks of a snapshot.
#include "world/snapshot/chunks.h"
#include "platform/error.h"
#include <stdlib.h>
#include <string.h>

#define FORMAT_VERSION 1 // increased when older libraries cannot read new snapshots
#define DIGEST_BYTES   8
#define CHUNK_FIXED    8 // bytes of a chunk beside its name and values

// Entries that a search visits. The table is at most half full, so names that are not chosen to collide need a few dozen.
#define MOST_PROBES 1024

static const char magic[8] = {'S', 'c', 'r', 'e', 'e', '\r', '\n', 26}; // text conversions damage the last three bytes

// Words of eight bytes, the last one filled with zeros, are mixed in one by one.
uint64_t chunks_digest(const uint8_t* bytes, size_t size)
{
	uint64_t digest = 0x9e3779b97f4a7c15u ^ (uint64_t)size;
	for (size_t at = 0; at < size; at += 8)
	{
		uint64_t word = 0;
		memcpy(&word, bytes + at, size - at < 8 ? size - at : 8);
		digest = (digest ^ word) * 0xbf58476d1ce4e5b9u;
		digest ^= digest >> 29;
	}
	return digest;
}

uint8_t* writer_append(ChunkWriter* writer, size_t more)
{
	if (writer->used == SIZE_MAX)
		return NULL;
	if (more > writer->capacity - writer->used)
	{
		size_t capacity =
		    2 * writer->capacity > writer->used + more ? 2 * writer->capacity : writer->used + more + 4096;
		uint8_t* bytes = scree_reallocate(writer->bytes, writer->used, capacity);
		if (!bytes)
		{
			writer->used = SIZE_MAX;
			return NULL;
		}
		writer->bytes = bytes;
		writer->capacity = capacity;
	}
	uint8_t* at = writer->bytes + writer->used;
	writer->used += more;
	return at;
}

void bytes_write(ChunkWriter* writer, const void* bytes, size_t size)
{
	uint8_t* at = writer_append(writer, size);
	if (at && size > 0)
		memcpy(at, bytes, size);
}

void header_write(ChunkWriter* writer, const char start[8], int version)
{
	const char* library = scree_version();
	const uint8_t numbers[2] = {(uint8_t)version, (uint8_t)strlen(library)};
	bytes_write(writer, start, sizeof magic);
	bytes_write(writer, numbers, sizeof numbers);
	bytes_write(writer, library, numbers[1]);
}

static scree_status no_memory(const char* function)
{
	return fail(SCREE_ERROR_OUT_OF_MEMORY, "%s: no memory for a snapshot", function);
}

scree_status chunks_begin(ChunkWriter* writer, const char* function)
{
	writer->used = 0;
	header_write(writer, magic, FORMAT_VERSION);
	return writer->used == SIZE_MAX ? no_memory(function) : SCREE_OK;
}

uint8_t* chunk_add(ChunkWriter* writer, const char* name, int bytes, int count, int stored)
{
	size_t length = strlen(name);
	ASSERT(length > 0 && length <= CHUNK_NAME);
	uint8_t* at = writer_append(writer, CHUNK_FIXED + length + (size_t)bytes * (size_t)stored);
	if (!at)
		return NULL;
	uint16_t bytes16 = (uint16_t)bytes;
	uint32_t count32 = (uint32_t)count;
	*at++ = (uint8_t)length;
	memcpy(at, name, length);
	at += length;
	*at++ = stored < count;
	memcpy(at, &bytes16, sizeof bytes16);
	memcpy(at + 2, &count32, sizeof count32);
	return at + 6;
}

scree_status chunks_end(ChunkWriter* writer, const char* function)
{
	uint8_t* at = writer_append(writer, 1 + DIGEST_BYTES);
	if (!at)
		return no_memory(function);
	*at = 0;
	uint64_t digest = chunks_digest(writer->bytes, writer->used - DIGEST_BYTES);
	memcpy(at + 1, &digest, sizeof digest);
	return SCREE_OK;
}

void chunks_continue(ChunkWriter* writer) { writer->used -= 1 + DIGEST_BYTES; }

static uint32_t hash_name(const char* name, int length)
{
	uint32_t hash = 2166136261u; // FNV-1a: Fowler, Noll, Vo, 1991
	for (int k = 0; k < length; ++k)
		hash = (hash ^ (uint8_t)name[k]) * 16777619u;
	return hash;
}

// Returns the entry of a name, or the empty entry to use for it; null after MOST_PROBES other entries.
static Chunk* entry_of(const ChunkIndex* index, const char* name, int length)
{
	uint32_t first = hash_name(name, length);
	for (uint32_t k = 0; k < MOST_PROBES; ++k)
	{
		Chunk* chunk = index->chunks + ((first + k) & (index->size - 1));
		if (chunk->name_length == 0 || (chunk->name_length == length && memcmp(chunk->name, name, (size_t)length) == 0))
			return chunk;
	}
	return NULL;
}

const Chunk* chunk_find(const ChunkIndex* index, const char* name)
{
	const Chunk* chunk = entry_of(index, name, (int)strlen(name));
	return chunk && chunk->name_length > 0 ? chunk : NULL;
}

static scree_status truncated(const char* function, size_t size)
{
	return fail(SCREE_ERROR_INVALID, "%s: the snapshot is damaged: a chunk ends behind its %zu bytes", function, size);
}

// Reads one chunk at *at. Sets name_length to 0 at the end of the chunks.
static scree_status read_chunk(const char* function, const uint8_t* bytes, size_t size, size_t* at, Chunk* chunk)
{
	size_t left = size - *at;
	if (left < 1)
		return truncated(function, size);
	size_t length = bytes[*at];
	chunk->name_length = (int)length;
	chunk->name = (const char*)bytes + *at + 1;
	if (length == 0)
	{
		++*at;
		return SCREE_OK;
	}
	if (length > CHUNK_NAME || left < CHUNK_FIXED + length)
		return truncated(function, size);
	const uint8_t* head = bytes + *at + 1 + length;
	uint16_t bytes16;
	uint32_t count32;
	memcpy(&bytes16, head + 1, sizeof bytes16);
	memcpy(&count32, head + 3, sizeof count32);
	chunk->equal = head[0] != 0;
	chunk->bytes = bytes16;
	chunk->count = (int)count32;
	chunk->first = head + 7;
	left -= CHUNK_FIXED + length;
	uint64_t stored = (uint64_t)bytes16 * (chunk->equal && count32 > 0 ? 1 : count32);
	if (count32 > INT32_MAX || stored > left)
		return truncated(function, size);
	*at += CHUNK_FIXED + length + (size_t)stored;
	return SCREE_OK;
}

static scree_status fill_index(ChunkIndex* index, const uint8_t* bytes, size_t begin, size_t size)
{
	int count = 0;
	Chunk chunk;
	for (size_t at = begin;;)
	{
		TRY(read_chunk(index->function, bytes, size, &at, &chunk));
		if (chunk.name_length == 0)
			break;
		++count;
	}
	for (index->size = 64; index->size < 2 * (uint32_t)count;)
		index->size *= 2;
	index->chunks = scree_allocate(index->size * sizeof *index->chunks);
	if (!index->chunks)
		return no_memory(index->function);
	for (size_t at = begin; count > 0; --count)
	{
		TRY(read_chunk(index->function, bytes, size, &at, &chunk));
		Chunk* entry = entry_of(index, chunk.name, chunk.name_length);
		if (!entry)
			return fail(SCREE_ERROR_INVALID,
			            "%s: the snapshot is damaged: the name of chunk %.*s collides with %d others", index->function,
			            chunk.name_length, chunk.name, MOST_PROBES);
		if (entry->name_length > 0)
			return fail(SCREE_ERROR_INVALID, "%s: the snapshot has two chunks %.*s", index->function, chunk.name_length,
			            chunk.name);
		*entry = chunk;
	}
	return SCREE_OK;
}

scree_status chunks_open(ChunkIndex* index, const char* function, const void* snapshot, size_t size)
{
	const uint8_t* bytes = snapshot;
	*index = (ChunkIndex){.function = function, .subject = "the snapshot is refused"};
	size_t head = sizeof magic + 2;
	if (size < head + 1 + DIGEST_BYTES || memcmp(bytes, magic, sizeof magic) != 0)
		return fail(SCREE_ERROR_INVALID, "%s: these %zu bytes are not a snapshot: they do not begin with \"Scree\"",
		            function, size);
	int version = bytes[sizeof magic];
	size_t begin = head + bytes[sizeof magic + 1], end = size - DIGEST_BYTES;
	if (begin >= end)
		return truncated(function, size);
	if (version > FORMAT_VERSION)
		return fail(SCREE_ERROR_INVALID,
		            "%s: the snapshot has format %d, of library version %.*s; this version, %s, reads formats up to %d",
		            function, version, bytes[sizeof magic + 1], (const char*)bytes + head, scree_version(),
		            FORMAT_VERSION);
	uint64_t digest;
	memcpy(&digest, bytes + end, sizeof digest);
	if (digest != chunks_digest(bytes, end))
		return fail(SCREE_ERROR_INVALID, "%s: the snapshot is damaged: its digest is not that of its %zu bytes",
		            function, size);
	return fill_index(index, bytes, begin, end);
}

void chunks_close(ChunkIndex* index)
{
	scree_release(index->chunks);
	index->chunks = NULL;
}
