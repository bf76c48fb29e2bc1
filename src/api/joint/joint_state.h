// SPDX-License-Identifier: MIT
// joint_state.h -- joints above their thresholds in the last step.
#ifndef JOINT_STATE_H
#define JOINT_STATE_H
#include "world/world.h"

// Their rows, in the world's temporary memory, by index, without joints that were destroyed since.
scree_status joint_events_find(scree_world* world, const char* function, JointEvent** rows, int* count);
scree_joint_event joint_event_result(const scree_world* world, const JointEvent* row);

#endif
