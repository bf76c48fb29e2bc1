// SPDX-License-Identifier: MIT
// detect.h -- the first half of a step: from the changed bodies to colored contacts.
#ifndef DETECT_H
#define DETECT_H
#include "step/pipeline_state.h"

#define DETECT_RUNS_MOST (4 * MAX_ROUNDS + 8 * CONSTRAINT_KINDS + 128) // runs in the longest list

// Executes the stages from boxes to colored contacts. Sets *solved if the rest of the step was executed as well.
scree_status pipeline_detect(Pipeline* pipeline, Step* step, const StepRequest* request, bool* solved);

#endif
