// SPDX-License-Identifier: MIT
// diff_command.c -- scree diff, which compares two snapshots.
#include "cli/common/differences.h"
#include "cli/common/file_bytes.h"
#include "commands.h"
#include <stdio.h>
#include <stdlib.h>

int diff_command(const Options* options)
{
	FileBytes a, b;
	int code = file_read(options, options->arguments[0], &a);
	if (code != EXIT_GOOD)
		return code;
	code = file_read(options, options->arguments[1], &b);
	if (code == EXIT_GOOD)
	{
		code = print_differences(a.bytes, a.size, b.bytes, b.size);
		if (code == EXIT_GOOD)
			printf("equal\n");
		free(b.bytes);
	}
	free(a.bytes);
	return code;
}
