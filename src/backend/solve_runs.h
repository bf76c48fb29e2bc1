// SPDX-License-Identifier: MIT
// solve_runs.h -- a whole solve, from velocities and constraints to final poses: its data, and its list of runs.
//
// The backend chooses the form: run by run, or in fewer launches, always in the order of constraints/schedule.h.
#ifndef SOLVE_RUNS_H
#define SOLVE_RUNS_H
#include "backend/run_list.h"
#include <stdbool.h>

typedef struct
{
	int bodies, collidables; // slots in use
	int substeps;
	bool rare[CONSTRAINT_KINDS]; // the kind uses its rare rows
	bool bounces;                // as in Step
	bool unlocked;               // some body with joints may have no collidables, and therefore no leaf in a tree
	int chains, chain_places;    // items of a pass over chains; spots of chains and branches
	int carried;                 // first item with a heavy chain between light bodies; all items after it have one too
	int branches;                // items of a pass over branches, which follow the chains
	bool taut;                   // colored joints may pull so hard that bodies need other inertias for the step
	const Counters* counters;    // counters, with the layout of the constraints
	int bound; // counter that is 0 if that layout is out of date, or NO_COUNT; if it is 0, nothing may be done
} Solve;

// Returns the number of places of spokes, including padding.
static inline int layout_spokes(const Counters* c)
{
	return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] - c->layout[CONSTRAINT_CONTACT].begin[COLORS];
}

// Returns the number of constraints before a color, in the order of colors and kinds, including padding.
static inline int solve_first(const Solve* solve, int color)
{
	int sum = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		sum += solve->counters->layout[kind].begin[color];
	return sum;
}

static inline int solve_constraints(const Solve* solve) { return solve_first(solve, COLORS + 1); }

// Returns the items of a kernel over bodies, rounded up to whole blocks of lanes.
int solve_bodies(const Solve* solve);
int solve_runs_most(int substeps);

// Add the runs that set other inertias for taut joints, after solve_begin, and that restore them after the passes.
void solve_taut(const Solve* solve, RunList* list);
void solve_slack(const Solve* solve, RunList* list);

// Adds the runs of a solve to a list that has capacity for them.
void solve_list(const Solve* solve, RunList* list);

#endif
