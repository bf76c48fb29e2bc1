// SPDX-License-Identifier: MIT
// solve_stage.h -- executes the solve, and the work that follows the solve at the end of a step.
#ifndef SOLVE_STAGE_H
#define SOLVE_STAGE_H
#include "step/pipeline_state.h"

// Executes solve and finalize. bound: NO_COUNT, or the counter that the device sets to 0 if the layout has changed.
scree_status solve_start(Pipeline* pipeline, const Step* step, const StepRequest* request, int bound);

// Returns whether the solve can begin before the host has read a new layout of the constraints. Sets Step.bays.solve_places.
bool solve_finds_layout(Pipeline* pipeline, Step* step, const StepRequest* request);

// Executes the solve unless `solved` is set; then stops bodies with pending contacts, and moves kinematic bodies to
// their targets. With dt 0, only measures overlaps.
scree_status solve_finish(Pipeline* pipeline, const Step* step, const StepRequest* request, bool solved);

#endif
