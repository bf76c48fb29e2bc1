// SPDX-License-Identifier: MIT
// library_error.c -- prints error messages of the library on the command line.
#include "library_error.h"

static int code_of(scree_status status)
{
	return status == SCREE_OK ? EXIT_GOOD : status == SCREE_ERROR_INVALID ? EXIT_BAD : EXIT_FAILED;
}

int report(scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "%s: %s\n", program_name, scree_error());
	return code_of(status);
}

int report_file(const char* path, scree_status status)
{
	if (status != SCREE_OK)
		fprintf(stderr, "%s: %s: %s\n", program_name, path, scree_error());
	return code_of(status);
}
