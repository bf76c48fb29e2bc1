// SPDX-License-Identifier: MIT
// file_lists.h -- writes the types and calls of this library into a recording, and reads those of another version.
#ifndef FILE_LISTS_H
#define FILE_LISTS_H
#include "world/record/record_log.h"

// Writes the types and calls of this library.
void lists_write(ChunkWriter* writer);

typedef struct // a type of a file
{
	int id;                  // RecordedTypeId; -1: this library has no such type
	RecordedMember* members; // in the order of the file, with the offsets of this library
	int count;
	size_t bytes; // bytes of an item in the file
} FileType;

typedef struct // the types and calls of a file
{
	FileType* types;
	int* calls; // RecordedCallId of each call of the file; -1: this library has no such call, or it has other arguments
	int type_count, call_count;
	const FileType* by_id[RECORDED_TYPES]; // null: the file has no such type
} FileLists;

// Reads the types and calls of a file. Fails with SCREE_ERROR_INVALID if they are damaged, or if there is no memory.
scree_status lists_read(const char* function, ByteReader* reader, FileLists* lists);
void lists_close(FileLists* lists);

#endif
