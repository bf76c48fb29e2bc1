// SPDX-License-Identifier: MIT
// whole_file.c -- reads and writes whole files.
#include "tools/common/whole_file.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>

static bool read_all(FILE* file, FileBytes* to)
{
	size_t capacity = 0;
	for (;;)
	{
		if (to->size == capacity)
		{
			capacity = 2 * capacity + 65536;
			void* bytes = realloc(to->bytes, capacity);
			if (!bytes)
				return false;
			to->bytes = bytes;
		}
		size_t more = fread((char*)to->bytes + to->size, 1, capacity - to->size, file);
		to->size += more;
		if (more == 0)
			return !ferror(file);
	}
}

bool whole_file_read(const char* path, FileBytes* to)
{
	*to = (FileBytes){NULL, 0};
	FILE* file = fopen(path, "rb");
	if (!file)
		return false;
	bool good = read_all(file, to);
	int error = errno;
	fclose(file);
	if (!good)
		free(to->bytes);
	errno = error;
	return good;
}

bool whole_file_write(const char* path, const void* bytes, size_t size)
{
	FILE* file = fopen(path, "wb");
	if (!file)
		return false;
	bool written = fwrite(bytes, 1, size, file) == size;
	int error = errno;
	if (fclose(file) == 0 && written)
		return true;
	errno = written ? errno : error;
	return false;
}
