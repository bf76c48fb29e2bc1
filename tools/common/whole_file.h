// SPDX-License-Identifier: MIT
// whole_file.h -- reads and writes whole files.
#ifndef WHOLE_FILE_H
#define WHOLE_FILE_H
#include <stdbool.h>
#include <stddef.h>

typedef struct
{
	void* bytes;
	size_t size;
} FileBytes;

// Reads a file or a pipe until its end. The caller frees the bytes. On failure returns false; errno has the reason, and *to is empty.
bool whole_file_read(const char* path, FileBytes* to);

// Writes a file. On failure returns false; errno has the reason.
bool whole_file_write(const char* path, const void* bytes, size_t size);

// Likewise, but leaves the old file as it was on failure: writes a file with the ending .part, which then replaces the other.
// A device or a pipe is written directly.
bool whole_file_replace(const char* path, const void* bytes, size_t size);

#endif
