// SPDX-License-Identifier: MIT
// state_readback.h -- the world hash, rows for drawing, and reports of joints and contacts, on request between steps.
#ifndef STATE_READBACK_H
#define STATE_READBACK_H
#include "step/pipeline_state.h"

scree_status pipeline_hash(Pipeline* pipeline, int bodies, int collidables, uint64_t* hash);

// Updates the pool render_row for this number of collidable slots; with shared, in the memory that OpenGL reads.
scree_status pipeline_render(Pipeline* pipeline, int collidables, bool shared);

// Updates joint_state for slots first to first + count - 1 of joints, after the upload of the user's changes.
scree_status pipeline_report_joints(Pipeline* pipeline, int first, int count);

// Collects the touching contacts of a body in contact_report, after the upload of the user's changes; sets *count.
scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count);

#endif
