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

// Computes the hash of all simulated state in the given numbers of slots.
scree_status pipeline_hash(Pipeline* pipeline, int bodies, int collidables, uint64_t* hash);

// Updates the pool render_row for the given number of collidable slots; with shared, in the memory from which OpenGL
// draws.
scree_status pipeline_render(Pipeline* pipeline, int collidables, bool shared);

// Updates the pool joint_state for slots first to first + count - 1 of joints. The user's changes must be on the
// device.
scree_status pipeline_report_joints(Pipeline* pipeline, int first, int count);

// Collects the touching contacts of a body in the pool contact_report, with details of the last step if these are kept,
// and sets *count to their number. The user's changes must be on the device.
scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count);

#endif
