// SPDX-License-Identifier: MIT
// dispatch.h -- passes lists of runs, and the solve, to the backend.
#ifndef DISPATCH_H
#define DISPATCH_H
#include "step/pipeline_state.h"

// Executes the listed runs, and empties the list.
scree_status pipeline_run(Pipeline* pipeline, const Step* step);

// Finds the bodies that are neighbors of several hubs. The host must have the layout of the constraints.
scree_status pipeline_split(Pipeline* pipeline, const Step* step, int bodies);

// Adds the runs of presses, which use the velocities at the start of the step. may_wait: the layout of the constraints
// may change before they run; then they do nothing.
void press_list(RunList* list, const Counters* c, int bodies, bool may_wait);

// Executes solve and finalize. bound is a counter that is 0 if the layout of the constraints is not that of the
// counters that the host has, or NO_COUNT.
scree_status pipeline_solve(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound);

#endif
