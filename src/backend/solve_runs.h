// SPDX-License-Identifier: MIT
// solve_runs.h -- a whole solve, from velocities and constraints to final poses: what it goes over, and the same as a list of runs.
//
// The pipeline gives a backend a solve as one thing, and the backend chooses the form: run by run, or in fewer launches. The
// order is that of constraints/schedule.h in every form.
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
	bool unlocked;               // some body with joints may have no collidables, and so no leaf in a tree
	int chains, chain_places;    // rows of joints that are solved together, and places in them
	int carried;                 // the first row that is heavy between light ends: from there on, to the last
	int branches;                // trees of joints that are solved together, behind the chains
	bool taut;                   // joints with a color may pull so hard that bodies get other inertias for the step
	const Counters* counters;    // with the layout of the constraints
	int bound; // counter that is 0 when that is not the layout after all, or NO_COUNT; then nothing may be done
} Solve;

// places of spokes, padding included
static inline int layout_spokes(const Counters* c)
{
	return c->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] - c->layout[CONSTRAINT_CONTACT].begin[COLORS];
}

// the first constraint of a color, in the order of colors and kinds, padding included
static inline int solve_first(const Solve* solve, int color)
{
	int sum = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		sum += solve->counters->layout[kind].begin[color];
	return sum;
}

// constraints of all kinds, padding included
static inline int solve_constraints(const Solve* solve) { return solve_first(solve, COLORS + 1); }

// items of a stage over bodies: whole blocks of lanes
int solve_bodies(const Solve* solve);

// most runs that a solve of so many substeps has
int solve_runs_most(int substeps);

// Adds the runs that set the inertias of a step in which joints are taut. solve_begin and solve_slack come before and after.
void solve_taut(const Solve* solve, RunList* list);
void solve_slack(const Solve* solve, RunList* list);

// Adds the runs of a solve to a list that has room for them.
void solve_list(const Solve* solve, RunList* list);

#endif
