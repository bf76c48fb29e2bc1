// SPDX-License-Identifier: MIT
// checks.c -- checks of statuses and numbers.
#include "support/checks.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool quick(void)
{
	const char* value = getenv("SCREE_QUICK");
	return value && strcmp(value, "1") == 0;
}

void skip_if_quick(void)
{
	if (!quick())
		return;
	print_message("skipped: long, and run by the release build\n");
	skip();
}

void check_ok(scree_status status, const char* call, const char* file, int line)
{
	if (status == SCREE_OK)
		return;
	print_error("%s\n%s: %s\n", call, scree_status_name(status), scree_error());
	_fail(file, line);
}

void check_near(double value, double expected, double tolerance, const char* what, const char* file, int line)
{
	if (fabs(value - expected) <= tolerance)
		return;
	print_error("%s is %.9g, must be %.9g within %.3g\n", what, value, expected, tolerance);
	_fail(file, line);
}

int memory_is_released(void** state)
{
	(void)state;
	return scree_memory() == 0 ? 0 : -1;
}
