// SPDX-License-Identifier: MIT
// joint_state.h -- finds the events of joints that exceeded their thresholds in the last step.
#ifndef JOINT_STATE_H
#define JOINT_STATE_H
#include "world/world.h"

// Reads the events of joints that still exist, sorted by the slot of the joint. *rows is in world_scratch.
scree_status joint_events_find(scree_world* world, const char* function, JointEvent** rows, int* count);
scree_joint_event joint_event_result(const scree_world* world, const JointEvent* row);

#endif
