// SPDX-License-Identifier: MIT
// file_bytes.c -- reads and writes whole files, with error messages of the command line.
#include "file_bytes.h"
#include <errno.h>
#include <string.h>

static int refuse(const Options* options, const char* path, const char* verb, int code)
{
	fprintf(stderr, "%s %s: cannot %s %s: %s\n", program_name, options->name, verb, path, strerror(errno));
	return code;
}

int file_read(const Options* options, const char* path, FileBytes* to)
{
	return whole_file_read(path, to) ? EXIT_GOOD : refuse(options, path, "read", EXIT_BAD);
}

int file_write(const Options* options, const char* path, const void* bytes, size_t size)
{
	return whole_file_write(path, bytes, size) ? EXIT_GOOD : refuse(options, path, "write", EXIT_FAILED);
}
