// SPDX-License-Identifier: MIT
// peer_clock.c -- reads a clock that is never set back.
#include "peer_clock.h"
#include <time.h>

double clock_real(void)
{
	struct timespec now;
	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}
