// SPDX-License-Identifier: MIT
// solve_runs.h -- builds a whole solve, from velocities and constraints to final poses, as a list of runs. A backend
// may choose a form with fewer launches; every form has the order of constraints/schedule.h.
#ifndef SOLVE_RUNS_H
#define SOLVE_RUNS_H
#include "backend/run_list.h"
#include <stdbool.h>

typedef struct
{
	int bodies, collidables; // numbers of slots, up to the last one in use
	int substeps;
	bool rare[CONSTRAINT_KINDS]; // the kind uses its rare rows
	bool bounces;                // as in Step
	bool unlocked;               // some body with joints may have no collidable, and therefore no leaf in a tree
	int chains, chain_places;    // number of items of a pass over chains; number of places in chains and branches
	int carried;  // first item of a pass over chains that has heavy chains between light bodies; such items come last
	int branches; // number of items of a pass over branches; they follow the items of chains
	bool batch;   // the pools contain the worlds of a batch
	bool wide;    // they are finalized in lanes
	bool taut;    // joints may pull so hard that bodies need larger inertias for the step
	const Counters* counters; // counters on the host; they contain the layout of the constraints
	int places; // 0; or the number of places for which the solve has room, which finds a new layout in the counters of the device
	int visited; // counter of the bodies that the solve visits; or NO_COUNT: all
	int bound;   // counter that is 0 if the layout is out of date, so that the device skips the solve; or NO_COUNT
} Solve;

// Returns the number of places of spokes, including padding.
static inline int layout_spokes(const Counters* c)
{
	return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] - c->layout[CONSTRAINT_CONTACT].begin[COLORS];
}

// Returns the number of constraints, including padding, of the colors before `color`, summed over all kinds.
static inline int solve_first(const Solve* solve, int color)
{
	int sum = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		sum += solve->counters->layout[kind].begin[color];
	return sum;
}

static inline int solve_constraints(const Solve* solve) { return solve_first(solve, COLORS + 1); }

// Returns the number of items of a kernel over bodies, rounded up to a multiple of MAX_LANES.
int solve_bodies(const Solve* solve);
int solve_runs_most(int substeps);

// solve_taut, after the kernel solve_begin: raises inertias of bodies with taut joints. solve_slack: restores them.
void solve_taut(const Solve* solve, RunList* list);
void solve_slack(const Solve* solve, RunList* list);

// Adds the runs of a solve to a list that has capacity for them.
void solve_list(const Solve* solve, RunList* list);

#endif
