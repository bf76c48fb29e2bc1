// SPDX-License-Identifier: MIT
// moment_file.h -- writes and reads snapshots with parts of a program, as further chunks. It hides the library's own types, some of which have the
// names of types in view/.
#ifndef MOMENT_FILE_H
#define MOMENT_FILE_H
#include "scree/scree.h"

typedef struct
{
	const char* name;
	int unit;           // bytes of a value
	const void* values; // null: the file lacks this part, or it has another unit
	size_t bytes;       // size of all values
} FilePart;

// Writes a snapshot with parts; those without bytes are left out. *bytes is memory of the world, valid until its next snapshot.
scree_status moment_write(scree_world* world, const FilePart* parts, int count, const void** bytes, size_t* size);

// Checks the digest of a snapshot, and sets `values` and `bytes` of parts. Values lie in the given bytes, at any alignment.
scree_status moment_read(const void* bytes, size_t size, FilePart* parts, int count);

#endif
