// SPDX-License-Identifier: MIT
// solve.c -- finds the runs of a whole solve in a list, and the form in which they are fastest.
#include "opencl/opencl.h"
#include <stdlib.h>

// Up to this many constraints a relay is faster than tiles.
#define RELAY_CONSTRAINTS 1000000

static int solve_find(const Run* runs, int count, Solve* solve)
{
	*solve = (Solve){.passes = 1, .bound = runs->count}; // of all runs alike
	if (runs[0].stage != STAGE_solve_begin)
		return 0;
	for (int k = 0; k < count; ++k)
		switch (runs[k].stage)
		{
		case STAGE_cleanse:
			solve->cleanse = 1;
			break;
		case STAGE_prepare:
			solve->constraints = runs[k].end;
			break;
		case STAGE_overflow_key:
			solve->overflow = true;
			break;
		case STAGE_warm_start:
			if (solve->color_count++ == 0)
				solve->colors = &runs[k];
			break;
		case STAGE_integrate_velocity:
			++solve->substeps;
			break;
		case STAGE_bounce:
			solve->passes = 2;
			break;
		case STAGE_finalize:
			solve->bodies = runs[k].end;
			solve->passes += 2 * solve->substeps;
			solve->length = k + 1;
			return solve->length;
		}
	return 0;
}

int solve_length(OpenCl* d, const Run* runs, int count)
{
	Solve solve;
	if (d->relay_groups == 0 || !solve_find(runs, count, &solve))
		return 0;
	// the overflow set needs sums over many constraints
	return solve.overflow ? 0 : solve.length;
}

scree_status solve_run(OpenCl* d, const Run* runs, int count)
{
	Solve solve;
	solve_find(runs, count, &solve);
	d->box = BOX_solve;
	bool tiles = solve.constraints > RELAY_CONSTRAINTS;
	const char* forced = getenv("SCREE_TILES");
	if (forced)
		tiles = *forced == '1';
	TRY(tiles ? tiles_run(d, &solve) : relay_run(d, &solve));
	return relay_end(d, &solve);
}
