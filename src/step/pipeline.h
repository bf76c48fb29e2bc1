// SPDX-License-Identifier: MIT
// pipeline.h -- declares the step, and other work that runs on the device between steps.
#ifndef PIPELINE_H
#define PIPELINE_H
#include "step/pipeline_state.h"

// Gives pools their first capacities. bodies, contacts: expected numbers, 0 if unknown. The caller owns the backend.
scree_status pipeline_open(Pipeline* pipeline, Backend* backend, int bodies, int contacts);
void pipeline_close(Pipeline* pipeline);

// Replaces the backend. The caller has copied the pools to another device.
void pipeline_move(Pipeline* pipeline, Backend* backend);

// Executes a step. The user's changes must be uploaded. After a failure, Pipeline.started is set if any data changed.
scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request);

#endif
