// SPDX-License-Identifier: MIT
// record_log.h -- writes and reads the records of a recording. docs/design/recording.md has the format.
#ifndef RECORD_LOG_H
#define RECORD_LOG_H
#include "world/record/call_list.h"
#include "world/snapshot/chunks.h"

enum // numbers of records; calls follow, in the order of the table in the file
{
	RECORD_END,      // the recording ended; without it the end of the file is cut off
	RECORD_LISTS,    // the types and calls of the library that wrote the file
	RECORD_SNAPSHOT, // a snapshot: the state at the beginning, or after a call that failed late
	RECORD_HASH,     // the world hash
	RECORD_FAILED,   // the call before it failed
	RECORD_CALLS = 16
};

typedef struct
{
	uint64_t number;
	const uint8_t* bytes;
	size_t size;
} LogRecord;

typedef struct // position in a recording that is being read; an error sets `at` to null
{
	const uint8_t *at, *end;
} ByteReader;

// Writes the header of a recording, and begins the chain of digests.
void log_begin(ChunkWriter* writer, uint64_t* chain);
// Appends a record with its digest, which depends on all records before it.
void log_add(ChunkWriter* writer, uint64_t* chain, uint64_t number, const void* bytes, size_t size);

// Checks the header, and moves the reader behind it. Fails with SCREE_ERROR_INVALID otherwise. version: receives the
// version of the library that wrote the file, with its length.
scree_status log_open(const char* function, ByteReader* reader, size_t size, uint64_t* chain, const char** version,
                      int* version_length);
// Reads the next record. Returns false and stays in place if the rest contains no whole record with the right digest.
bool log_next(ByteReader* reader, uint64_t* chain, LogRecord* record);
// Reads the next record without its digest, which log_next has checked before. Returns false if the rest contains no whole record.
bool log_again(ByteReader* reader, LogRecord* record);

// Numbers of seven bits per byte, the lowest first; the highest bit is set in all bytes but the last.
void number_write(ChunkWriter* writer, uint64_t number);
uint64_t number_read(ByteReader* reader); // 0 after an error

// Returns the address of the next bytes, or null after an error.
const uint8_t* bytes_read(ByteReader* reader, size_t size);

#endif
