// SPDX-License-Identifier: MIT
// whole_file.c -- reads and writes whole files.
#define _GNU_SOURCE // declares realpath; ignored on other systems
#include "tools/common/whole_file.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

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

// Returns whether a file is one that has an end. A device such as /dev/zero has none.
static bool has_end(FILE* file)
{
	struct stat status;
	if (fstat(fileno(file), &status) != 0 || !S_ISCHR(status.st_mode))
		return true;
	errno = EINVAL;
	return false;
}

bool whole_file_read(const char* path, FileBytes* to)
{
	*to = (FileBytes){NULL, 0};
	FILE* file = fopen(path, "rb");
	if (!file)
		return false;
	bool good = has_end(file) && read_all(file, to);
	int error = errno;
	fclose(file);
	if (!good)
	{
		free(to->bytes);
		*to = (FileBytes){NULL, 0};
	}
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

// Returns the path of a file without symbolic links, which the caller frees, or null. A file that does not exist yet has its own.
static char* plain_path(const char* path)
{
#ifndef _WIN32
	char* plain = realpath(path, NULL);
	if (plain || errno != ENOENT)
		return plain;
#endif
	return strdup(path);
}

bool whole_file_replace(const char* path, const void* bytes, size_t size)
{
	struct stat found;
	bool there = stat(path, &found) == 0;
	if (there && !S_ISREG(found.st_mode))
		return whole_file_write(path, bytes, size);
	if (there && access(path, W_OK) != 0)
		return false;
	char* plain = plain_path(path);
	char* part = plain ? malloc(strlen(plain) + sizeof ".part") : NULL;
	bool good = part != NULL;
	if (good)
	{
		strcat(strcpy(part, plain), ".part");
		good = whole_file_write(part, bytes, size);
#ifdef _WIN32
		if (good && there)
			remove(plain); // rename refuses a name that exists
#endif
		good = good && rename(part, plain) == 0;
		int reason = errno;
		if (!good)
			remove(part);
		errno = reason;
	}
	free(part);
	free(plain);
	return good;
}
