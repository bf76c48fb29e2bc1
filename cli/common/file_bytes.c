// SPDX-License-Identifier: MIT
// file_bytes.c -- reads and writes whole files.
#include "file_bytes.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

static int refuse(const Options* options, const char* path, const char* verb, int code)
{
	fprintf(stderr, "%s %s: cannot %s %s: %s\n", program_name, options->name, verb, path, strerror(errno));
	return code;
}

// Reads until the end, so that pipes can be read too. Returns false on failure.
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

int file_read(const Options* options, const char* path, FileBytes* to)
{
	*to = (FileBytes){NULL, 0};
	FILE* file = fopen(path, "rb");
	if (!file)
		return refuse(options, path, "read", EXIT_BAD);
	int code = read_all(file, to) ? EXIT_GOOD : refuse(options, path, "read", EXIT_BAD);
	fclose(file);
	if (code != EXIT_GOOD)
		free(to->bytes);
	return code;
}

int file_write(const Options* options, const char* path, const void* bytes, size_t size)
{
	FILE* file = fopen(path, "wb");
	if (!file)
		return refuse(options, path, "write", EXIT_FAILED);
	bool written = fwrite(bytes, 1, size, file) == size;
	int error = errno;
	if (fclose(file) == 0 && written)
		return EXIT_GOOD;
	errno = written ? errno : error;
	return refuse(options, path, "write", EXIT_FAILED);
}
