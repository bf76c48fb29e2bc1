// SPDX-License-Identifier: MIT
// state_readback.h -- computes the world hash, render rows, and reports of joints and contacts, between steps.
#ifndef STATE_READBACK_H
#define STATE_READBACK_H
#include "step/pipeline_state.h"

scree_status pipeline_hash(Pipeline* pipeline, bool sleep, int bodies, int collidables, uint64_t* hash);

// Writes the poses of all bodies at a fraction of the last step (from 0 to 1) to the pool base.
scree_status pipeline_interpolate(Pipeline* pipeline, int bodies, float alpha);

// Updates the pool render_row or, if `shared` is set, the memory that OpenGL reads. collidables: number of slots;
// interpolated: the bodies are at the poses of pipeline_interpolate.
scree_status pipeline_render(Pipeline* pipeline, int collidables, bool interpolated, bool shared);

// Updates the pool joint_state for `count` slots from `first` on. The user's changes must already be uploaded.
scree_status pipeline_report_joints(Pipeline* pipeline, int first, int count);

// Updates the pool island for `count` bodies from `first` on: 1 for a body that sleeps and is not marked to wake, else
// 0.
scree_status pipeline_report_sleep(Pipeline* pipeline, int first, int count);

// Counts the bodies that sleep and are not marked to wake, and the touching contacts that have no constraint because a
// body sleeps.
scree_status pipeline_count_sleep(Pipeline* pipeline, int bodies, int* asleep, int* touching);

// Lists the touching contacts of a body in the pool contact_report; sets *count. The user's changes must be uploaded.
scree_status pipeline_list_contacts(Pipeline* pipeline, int body, bool details, int* count);

#endif
