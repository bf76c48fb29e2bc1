// SPDX-License-Identifier: MIT
// recording_file.c -- checks whether a file is a recording.
#include "tools/common/recording_file.h"
#include <stdio.h>
#include <string.h>

bool recording_file(const char* path)
{
	const char ending[] = ".rec", begin[] = "Screc";
	size_t length = strlen(path), ended = sizeof ending - 1;
	char bytes[sizeof begin - 1];
	if (length > ended && strcmp(path + length - ended, ending) == 0)
		return true;
	FILE* file = fopen(path, "rb");
	if (!file)
		return false;
	bool same = fread(bytes, sizeof bytes, 1, file) == 1 && memcmp(bytes, begin, sizeof bytes) == 0;
	fclose(file);
	return same;
}
