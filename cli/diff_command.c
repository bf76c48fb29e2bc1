// SPDX-License-Identifier: MIT
// diff_command.c -- scree diff, which compares two snapshots.
#include "cli/common/differences.h"
#include "cli/common/file_bytes.h"
#include "cli/common/library_error.h"
#include "commands.h"
#include <stdio.h>
#include <stdlib.h>

// Reads a snapshot, and checks it by a comparison with itself, so that a message names the file that is none.
static int read_snapshot(const Options* options, const char* path, FileBytes* file)
{
	int count, code = file_read(options, path, file);
	if (code != EXIT_GOOD)
		return code;
	return report_file(path,
	                   scree_snapshots_compare(file->bytes, file->size, file->bytes, file->size, NULL, 0, &count));
}

int diff_command(const Options* options)
{
	FileBytes files[2] = {{0}};
	int code = EXIT_GOOD;
	for (int k = 0; k < 2 && code == EXIT_GOOD; ++k)
		code = read_snapshot(options, options->arguments[k], files + k);
	if (code == EXIT_GOOD)
	{
		code = print_differences(files[0].bytes, files[0].size, files[1].bytes, files[1].size);
		if (code == EXIT_GOOD)
			printf("equal\n");
	}
	free(files[0].bytes);
	free(files[1].bytes);
	return code;
}
