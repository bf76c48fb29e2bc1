// SPDX-License-Identifier: MIT
// one_process.c -- runs programs in the calling process, on systems without fork; processes.c runs several processes.
//
// A program that crashes ends the run, and one that hangs is not stopped.
#include "programs/farm.h"
#include "tools/common/clock.h"

int farm_run(const Options* o)
{
	Options alone = *o;
	alone.jobs = 1;
	Desk desk = {0};
	double begin = seconds_now();
	farm_work(&alone, 0, &desk);
	return farm_print_counts(o, &desk, seconds_now() - begin);
}
