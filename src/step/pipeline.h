// SPDX-License-Identifier: MIT
// pipeline.h -- the step, and what else is run on the device between steps.
#ifndef PIPELINE_H
#define PIPELINE_H
#include "step/pipeline_state.h"

// Gives the pools of a backend their first sizes: room for so many bodies and contacts, 0 for the default. The backend stays
// the caller's.
scree_status pipeline_open(Pipeline* pipeline, Backend* backend, int bodies, int contacts);
void pipeline_close(Pipeline* pipeline);

// The pools were moved to another device.
void pipeline_move(Pipeline* pipeline, Backend* backend);

// One step. The user's changes are on the device. On failure Pipeline.begun tells whether the step had changed the device.
scree_status pipeline_step(Pipeline* pipeline, const StepRequest* request);

// The hash of all simulated state, of so many slots.
scree_status pipeline_hash(Pipeline* pipeline, int bodies, int collidables, uint64_t* hash);

// Updates the pool render_row for so many slots of collidables; with shared, in the memory that OpenGL draws from.
scree_status pipeline_render(Pipeline* pipeline, int collidables, bool shared);

// Updates the pool joint_state for slots first to first + count - 1 of joints. The user's changes are on the device.
scree_status pipeline_report_joints(Pipeline* pipeline, int first, int count);

// Collects the touching contacts of a body in the pool listed, with what they did in the last step if details are kept, and sets
// *count to their number. The user's changes are on the device.
scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count);

#endif
