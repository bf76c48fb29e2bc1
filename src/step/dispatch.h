// SPDX-License-Identifier: MIT
// dispatch.h -- passes lists of runs, and the commands of a step, to the backend.
#ifndef DISPATCH_H
#define DISPATCH_H
#include "step/pipeline_state.h"

// Executes the listed runs, and empties the list.
scree_status pipeline_run(Pipeline* pipeline, const Step* step);

// Applies commands, which are one of the three lists in all.
scree_status apply_commands(Pipeline* pipeline, const Step* step, const StepCommands* all, const Command* commands);

#endif
