// SPDX-License-Identifier: MIT
// pipeline.h -- the step, and other work that runs on the device between steps.
#ifndef PIPELINE_H
#define PIPELINE_H
#include "step/pipeline_state.h"

// Gives the pools their initial capacity for bodies and contacts, 0 for the default. The caller owns the backend.
scree_status pipeline_open(Pipeline* pipeline, Backend* backend, int bodies, int contacts);
void pipeline_close(Pipeline* pipeline);

// Replaces the backend after the pools were moved to another device.
void pipeline_move(Pipeline* pipeline, Backend* backend);

// Executes one step; the user's changes are on the device. On failure sets Pipeline.started if it has changed data.
scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request);

#endif
