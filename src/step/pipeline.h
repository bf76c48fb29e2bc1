// SPDX-License-Identifier: MIT
// pipeline.h -- the step, and other work that runs on the device between steps.
#ifndef PIPELINE_H
#define PIPELINE_H
#include "step/pipeline_state.h"

// Gives the pools of a backend their initial capacity for bodies and contacts, 0 for the default. The caller still owns
// the backend.
scree_status pipeline_open(Pipeline* pipeline, Backend* backend, int bodies, int contacts);
void pipeline_close(Pipeline* pipeline);

// Replaces the backend after the pools were moved to another device.
void pipeline_move(Pipeline* pipeline, Backend* backend);

// Executes one step. The user's changes must be on the device. On failure Pipeline.started is set if the step has
// changed data on the device.
scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request);

#endif
