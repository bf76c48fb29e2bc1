// SPDX-License-Identifier: MIT
// clock.c -- reads a clock, for all programs except the library.
#include "tools/common/clock.h"
#include <time.h>

double seconds_now(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
