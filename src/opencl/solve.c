// SPDX-License-Identifier: MIT
// solve.c -- finds the runs of a whole solve in a list, and the form in which they are fastest.
#include "error.h"
#include "opencl/opencl.h"
#include <stdlib.h>
#include <string.h>

// Up to this many constraints a relay is faster than tiles.
#define RELAY_CONSTRAINTS 1000000

// groups of guard a compute unit: its items are few as a rule, and more groups would only find that out
#define GUARD_GROUPS 4

// arguments of solve_end behind the step
enum
{
	END_BODIES = ARGUMENT_STEP + 1,
	END_SUBSTEPS,
	END_PASSES,
	END_BOUND
};

static int solve_find(const Run* runs, int count, Solve* solve)
{
	*solve = (Solve){.passes = 1, .bound = runs->count}; // of all runs alike but that of guard
	if (runs[0].stage != STAGE_solve_begin)
		return 0;
	for (int k = 0; k < count; ++k)
		switch (runs[k].stage)
		{
		case STAGE_prepare:
			solve->constraints = runs[k].end;
			break;
		case STAGE_hub:
			// a run a turn
			if ((runs[k].argument & 255) == HUB_WARM_START)
				solve->hubs += runs[k].end;
			if ((runs[k].argument & 255) == HUB_REBOUND)
				solve->passes = 2;
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
			break;
		case STAGE_guard:
			solve->guard = &runs[k];
			solve->length = k + 1;
			return solve->length;
		}
	return 0;
}

void solve_open(OpenCl* d)
{
	const char* forced = getenv("SCREE_SOLVER");
	d->solver = SOLVER_ANY;
	if (forced && strcmp(forced, "relay") == 0)
		d->solver = SOLVER_RELAY;
	if (forced && strcmp(forced, "tiles") == 0)
		d->solver = SOLVER_TILES;
}

bool solve_plain(const OpenCl* d) { return !d->step.extras && !d->step.bounces && !d->step.round; }

static bool relayed(const OpenCl* d, const Solve* solve)
{
	return d->solver == SOLVER_RELAY || (d->solver == SOLVER_ANY && solve->constraints <= RELAY_CONSTRAINTS);
}

int solve_length(OpenCl* d, const Run* runs, int count)
{
	Solve solve;
	if (d->relay.groups == 0 || d->solver == SOLVER_NONE || !solve_find(runs, count, &solve))
		return 0;
	bool relay = relayed(d, &solve);
	// a hub's spokes lie in many tiles
	if (!relay && solve.hubs > 0)
		return 0;
	if (!relay && d->solver != SOLVER_TILES && !tiles_pay(d, &solve))
		return 0;
	scree_status status = relay ? relay_reserve(d, &solve) : tiles_reserve(d, &solve);
	if (status == SCREE_OK)
		return solve.length;
	// launches need no room
	log_sentence(SCREE_LOG_WARNING, "%s: %s; the solver is slower without.", d->backend->name, scree_error());
	d->solver = SOLVER_NONE;
	return 0;
}

// Moves what no constraint pushes, and finalizes all bodies; then those that go far.
static scree_status solve_end(OpenCl* d, const Solve* solve)
{
	cl_kernel kernel = d->solve_end.kernel;
	TRY(kernel_step(d, &d->solve_end));
	TRY(CALL(SetKernelArg, kernel, END_BODIES, sizeof(cl_int), &solve->bodies));
	TRY(CALL(SetKernelArg, kernel, END_SUBSTEPS, sizeof(cl_int), &solve->substeps));
	TRY(CALL(SetKernelArg, kernel, END_PASSES, sizeof(cl_int), &solve->passes));
	TRY(CALL(SetKernelArg, kernel, END_BOUND, sizeof(cl_int), &solve->bound));
	size_t group = d->solve_end.group;
	d->box = BOX_finalize;
	TRY(launch(d, kernel, groups_of(solve->bodies, group) * group, group));
	return stage_run_within(d, solve->guard, GUARD_GROUPS);
}

scree_status solve_run(OpenCl* d, const Run* runs, int count)
{
	Solve solve;
	solve_find(runs, count, &solve);
	d->box = BOX_solve;
	TRY(relayed(d, &solve) ? relay_run(d, &solve) : tiles_run(d, &solve));
	return solve_end(d, &solve);
}
