// SPDX-License-Identifier: MIT
// open_input.c -- opens files to read.
#include "tools/common/open_input.h"
#include <errno.h>
#include <sys/stat.h>

FILE* open_input(const char* path)
{
	FILE* file = fopen(path, "r");
	if (!file)
	{
		// Windows refuses to open a folder, with EACCES
		int refused = errno;
		struct stat found;
		errno = stat(path, &found) == 0 && S_ISDIR(found.st_mode) ? EISDIR : refused;
		return NULL;
	}
	errno = 0;
	int first = fgetc(file), reason = errno;
	if (!ferror(file))
	{
		if (first != EOF)
			ungetc(first, file);
		return file;
	}
	fclose(file);
	errno = reason;
	return NULL;
}
