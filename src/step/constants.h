// SPDX-License-Identifier: MIT
// constants.h -- the constants of a step.
#ifndef CONSTANTS_H
#define CONSTANTS_H
#include "step/pipeline_state.h"

Step step_constants(const Pipeline* pipeline, const StepRequest* request);

// Sets the capacities of the constraints of each kind; called again when a pool has grown.
void step_places(Step* step, const Backend* b);

// Sends the kinematic bodies if there are few, and they differ from those sent last.
scree_status kinematics_upload(Pipeline* pipeline, const StepRequest* request);

#endif
