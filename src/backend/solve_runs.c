// SPDX-License-Identifier: MIT
// solve_runs.c -- builds a whole solve as a list of runs, with one run per color in every pass.
#include "backend/solve_runs.h"
#include "backend/tables.h"
#include "constraints/schedule.h"

static int padded(int count) { return (count + MAX_LANES - 1) / MAX_LANES * MAX_LANES; }

int solve_bodies(const Solve* solve) { return padded(solve->bodies); }

int solve_runs_most(int substeps)
{
	// runs of a pass: 1 per color and kind, 2 per hub color, 2 for chains, 1 each for branches, overflow and bodies
	return schedule_passes(substeps, 1) * (COLORS * CONSTRAINT_KINDS + 2 * HUB_COLORS + 5) + 2 * CONSTRAINT_KINDS +
	       COLORS + 14;
}

// Adds a pass. A relax pass solves heavy chains between light bodies twice, before and after the colors. Before the
// colors, it removes the velocity by which the bias pass pulled their frames together. Otherwise contacts of the light
// bodies would stop this motion, and their impulses would remain and throw a landing cart up. Parts of bodies are
// merged if Counters.split is above 0. Without Solve.bound (NO_COUNT), only the device has its current value.
static void add_pass(RunList* list, const Solve* solve, int pass)
{
	const Counters* c = solve->counters;
	int bound = solve->bound, spokes = layout_spokes(c);
	for (int turn = 0; turn < HUB_COLORS && turn < c->hubs; ++turn)
	{
		runs_add(list, KERNEL_hub, 0, solve->batch ? c->hubs : (c->hubs - turn + HUB_COLORS - 1) / HUB_COLORS, bound,
		         RUN_PAIR(pass, turn));
		if (bound == NO_COUNT)
			runs_add(list, KERNEL_hub_merge, 0, spokes, COUNT(split), turn);
		else if (c->split > 0)
			runs_add(list, KERNEL_hub_merge, 0, spokes, bound, turn);
	}
	if (solve->carried < solve->chains && pass == PASS_RELAX)
		runs_add(list, KERNEL_chain, solve->carried, solve->chains, bound, pass);
	if (c->overflow > 0)
		runs_add(list, KERNEL_joint_overflow, 0, solve->batch ? c->overflow : 1, bound, pass);
	for (int color = 0; color < COLORS; ++color)
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		{
			int begin = c->layout[kind].begin[color], count = c->layout[kind].count[color];
			if (count > 0)
				runs_add(list, kind_info[kind].pass[pass], begin, begin + padded(count), bound, 0);
		}
	if (solve->chains > 0)
		runs_add(list, KERNEL_chain, 0, solve->chains, bound, pass);
	if (solve->branches > 0)
		runs_add(list, KERNEL_branch, solve->chains, solve->chains + solve->branches, bound, pass);
}

void solve_taut(const Solve* solve, RunList* list)
{
	const KindLayout* layout = &solve->counters->layout[CONSTRAINT_JOINT];
	runs_add(list, kind_info[CONSTRAINT_JOINT].prepare, 0, layout->begin[COLORS + 1], solve->bound, 0);
	for (int color = 0; color < COLORS; ++color)
		if (layout->count[color] > 0)
			runs_add(list, KERNEL_joint_taut, layout->begin[color], layout->begin[color] + padded(layout->count[color]),
			         solve->bound, 0);
	runs_add(list, KERNEL_body_taut, 0, solve_bodies(solve), solve->bound, 0);
}

void solve_slack(const Solve* solve, RunList* list)
{
	runs_add(list, KERNEL_body_slack, 0, solve_bodies(solve), solve->bound, 0);
}

void solve_list(const Solve* solve, RunList* list)
{
	int bound = solve->bound, bodies = solve_bodies(solve);
	// without colored joints nothing is raised, but body_taut also clears the counter; with sleep, only it visits body 0 in each step
	bool colored = solve->counters->layout[CONSTRAINT_JOINT].begin[COLORS] > 0, sleeps = solve->visited != bound;
	bool taut = solve->taut && (SMALL_CODE || colored || sleeps);
	runs_add(list, KERNEL_solve_begin, 0, bodies, solve->visited, solve->taut && !taut);
	if (taut)
		solve_taut(solve, list);
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
	{
		int constraints = solve->counters->layout[kind].begin[COLORS + 1];
		if (kind != CONSTRAINT_JOINT || !taut)
			runs_add(list, kind_info[kind].prepare, 0, constraints, bound, 0);
		if (solve->rare[kind])
			runs_add(list, kind_info[kind].prepare_rare, 0, constraints, bound, 0);
	}
	if (solve->chains > 0)
		runs_add(list, KERNEL_chain_begin, 0, solve->chains, bound, 0);
	if (solve->branches > 0)
		runs_add(list, KERNEL_branch_begin, solve->chains, solve->chains + solve->branches, bound, 0);
	for (int q = 0; q < schedule_passes(solve->substeps, solve->bounces); ++q)
	{
		int before = schedule_before(solve->substeps, q);
		if (before == BODY_ACCELERATES)
			runs_add(list, KERNEL_integrate_velocity, 0, bodies, solve->visited, schedule_first(q));
		if (before == BODY_MOVES)
			runs_add(list, KERNEL_integrate_position, 0, bodies, solve->visited, 0);
		add_pass(list, solve, schedule_pass(solve->substeps, q));
	}
	if (solve->chains > 0)
		runs_add(list, KERNEL_chain_end, 0, solve->chains, bound, 0);
	if (solve->branches > 0)
		runs_add(list, KERNEL_branch_end, solve->chains, solve->chains + solve->branches, bound, 0);
	if (taut)
		solve_slack(solve, list);
#ifndef SCREE_SMALL
	if (solve->wide)
	{
		runs_add(list, KERNEL_finalize_wide, 0, solve->bodies, bound, 0);
		runs_add(list, KERNEL_finalize, 0, solve->bodies, COUNT(listed_bodies), 1);
	}
	else
#endif
		runs_add(list, KERNEL_finalize, 0, solve->bodies, solve->visited, 0);
	runs_add(list, KERNEL_continuous, 0, solve->collidables, COUNT(continuous_items), 0);
	if (solve->rare[CONSTRAINT_JOINT])
		runs_add(list, KERNEL_joint_finalize, 0, solve->counters->layout[CONSTRAINT_JOINT].begin[COLORS + 1], bound, 0);
}
