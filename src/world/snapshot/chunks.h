// SPDX-License-Identifier: MIT
// chunks.h -- writes and reads the chunks of a snapshot: named columns of values. docs/design/snapshots.md has the format.
#ifndef CHUNKS_H
#define CHUNKS_H
#include "world/world.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#define CHUNK_NAME 63 // maximum length of the name of a chunk

typedef struct // a chunk of a snapshot that is being read
{
	const char* name;     // not terminated
	const uint8_t* first; // the first value
	int name_length;
	int bytes;  // bytes of a value
	int count;  // number of values
	bool equal; // all values are equal, and only one is stored
} Chunk;

typedef struct // the chunks of a snapshot, which lie in memory of the caller
{
	const char* function; // caller, for messages
	const char* subject;  // and the beginning of their sentences
	Chunk* chunks;        // hash table with open addressing; name_length 0: empty
	uint32_t size;        // number of entries, a power of two
} ChunkIndex;

// Returns the address of `more` new bytes at the end of a writer, or null. A writer without memory has `used` SIZE_MAX.
uint8_t* writer_append(ChunkWriter* writer, size_t more);
void bytes_write(ChunkWriter* writer, const void* bytes, size_t size);
// Writes the beginning of a file: the magic number, the version of its format, and the version of the library.
void header_write(ChunkWriter* writer, const char start[8], int version);
// Begins a snapshot with the header.
scree_status chunks_begin(ChunkWriter* writer, const char* function);
// Appends a chunk, and returns the address at which its values are to be written; null if there is no memory. stored:
// number of values that are stored.
uint8_t* chunk_add(ChunkWriter* writer, const char* name, int bytes, int count, int stored);
// Returns the digest of `size` bytes, the last eight bytes of a snapshot.
uint64_t chunks_digest(const uint8_t* bytes, size_t size);
// Ends a snapshot with the digest. Fails if memory was missing at any time.
scree_status chunks_end(ChunkWriter* writer, const char* function);
// Takes the end of a snapshot away, so that a program may append chunks of its own; readers skip chunks that they lack.
void chunks_continue(ChunkWriter* writer);

// Checks the header and the digest of a snapshot, and finds its chunks. Fails with SCREE_ERROR_INVALID otherwise.
scree_status chunks_open(ChunkIndex* index, const char* function, const void* bytes, size_t size);
void chunks_close(ChunkIndex* index);

// Returns a chunk, or null if there is none of this name.
const Chunk* chunk_find(const ChunkIndex* index, const char* name);

#endif
