// SPDX-License-Identifier: MIT
// clock.h -- milliseconds, to time what the world does.
#ifndef CLOCK_H
#define CLOCK_H
#include <time.h>

static inline double clock_milliseconds(void)
{
	struct timespec t;
	timespec_get(&t, TIME_UTC);
	return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

#endif
