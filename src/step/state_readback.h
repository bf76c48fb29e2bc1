// SPDX-License-Identifier: MIT
// state_readback.h -- the world hash, rows for drawing, and reports of joints and contacts, on request between steps.
#ifndef STATE_READBACK_H
#define STATE_READBACK_H
#include "step/pipeline_state.h"

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
