// SPDX-License-Identifier: MIT
// dispatch.h -- passes lists of runs and the solve to the backend.
#ifndef DISPATCH_H
#define DISPATCH_H
#include "step/pipeline_state.h"

// Runs what has been listed, and empties the list.
scree_status pipeline_run(Pipeline* pipeline, const Step* step);

// Finds the bodies that are light ends of several spokes. The layout of the constraints is known.
scree_status pipeline_split(Pipeline* pipeline, const Step* step, int bodies);

// Adds the runs of presses, on velocities of the start of the step. may_wait: the layout of the constraints may change before they run;
// then they do nothing.
void press_list(RunList* list, const Counters* c, int bodies, bool may_wait);

// The solve and finalize. bound is a counter that is 0 when the layout of the constraints is not that of the counters that the
// host knows, or NO_COUNT.
scree_status pipeline_solve(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound);

#endif
