// SPDX-License-Identifier: MIT
// dispatch.h -- passes run lists and commands to the backend.
#ifndef DISPATCH_H
#define DISPATCH_H
#include "step/pipeline_state.h"

// Executes the runs in Pipeline.list, and empties the list.
scree_status pipeline_run(Pipeline* pipeline, const Step* step);

// Applies `commands`, which is one of all->begin, all->end and all->undo. Each has all->count commands.
scree_status apply_commands(Pipeline* pipeline, const Step* step, const StepCommands* all, const Command* commands);

#endif
