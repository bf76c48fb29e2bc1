// SPDX-License-Identifier: MIT
// dispatch.h -- passes run lists and commands to the backend.
#ifndef DISPATCH_H
#define DISPATCH_H
#include "step/pipeline_state.h"

// Executes the runs in Pipeline.list, and empties the list.
scree_status pipeline_run(Pipeline* pipeline, const Step* step);

// Applies `commands`, which is one of all->begin, all->end and all->undo. Each has all->count commands.
scree_status apply_commands(Pipeline* pipeline, const Step* step, const StepCommands* all, const Command* commands);

// Applies the targets among the inputs of a batch, before the step (CHANNEL_AIMS) or after it (CHANNEL_ARRIVES).
scree_status apply_targets(Pipeline* pipeline, const Step* step, const StepRequest* request, int part);

#endif
