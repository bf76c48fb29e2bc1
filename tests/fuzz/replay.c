// SPDX-License-Identifier: MIT
// replay.c -- runs a fuzz target, built without libFuzzer, with each file of the folders in the arguments.
#include "fuzz/fuzz.h"
#include <dirent.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static void stop(const char* path, const char* reason)
{
	fprintf(stderr, "%s: %s\n", path, reason);
	exit(2);
}

static void run_file(const char* path)
{
	FILE* file = fopen(path, "rb");
	if (!file || fseek(file, 0, SEEK_END) != 0)
		stop(path, strerror(errno));
	long size = ftell(file);
	rewind(file);
	uint8_t* bytes = malloc(size > 0 ? (size_t)size : 1);
	if (!bytes || fread(bytes, 1, (size_t)size, file) != (size_t)size)
		stop(path, "cannot be read");
	fclose(file);
	fprintf(stderr, "%s\n", path); // the last line names the input of a crash
	LLVMFuzzerTestOneInput(bytes, (size_t)size);
	free(bytes);
}

// Runs the files of a folder. Returns their number.
static int run_folder(const char* path)
{
	DIR* folder = opendir(path);
	int count = 0;
	if (!folder)
		stop(path, strerror(errno));
	for (const struct dirent* entry; (entry = readdir(folder));)
	{
		char file[4096];
		if (entry->d_name[0] == '.')
			continue;
		snprintf(file, sizeof file, "%s/%s", path, entry->d_name);
		run_file(file);
		++count;
	}
	closedir(folder);
	return count;
}

int main(int count, char** paths)
{
	int files = 0;
	for (int k = 1; k < count; ++k)
	{
		struct stat found;
		if (stat(paths[k], &found) == 0 && S_ISDIR(found.st_mode))
			files += run_folder(paths[k]);
		else
		{
			run_file(paths[k]);
			++files;
		}
	}
	printf("%d files, of which %d are accepted\n", files, fuzz_accepted);
	// seeds of an older format test nothing; make_seeds.c writes new ones
	if (fuzz_accepted < (files + 1) / 2)
		stop(paths[0], "most files are refused");
	return 0;
}
