// SPDX-License-Identifier: MIT
// targets.h -- poses of kinematic bodies at the end of the next step that takes time.
#ifndef TARGETS_H
#define TARGETS_H
#include "scree/scree.h"
#include "step/pipeline_state.h"

// The velocity that takes a body to its target depends on dt, so the host keeps targets until the step.

// Room for so many more, after which target_put cannot fail.
scree_status targets_reserve(scree_world* world, const char* function, int more);

// Sets the target of a kinematic body: the pose of its origin.
void target_put(scree_world* world, int body, scree_pose pose);

// Removes the target of a body, if it has one.
void target_drop(scree_world* world, int body);

// The commands of a step for bodies with targets. Before the step they set the velocity that takes the body to its target;
// after it they set the exact pose and velocity 0. When the step is refused, velocities become 0 and targets stay. Disabled
// bodies keep their targets. The commands lie in world_scratch.
scree_status targets_commands(scree_world* world, StepCommands* commands);

// Removes the targets of enabled bodies after a step.
void targets_arrived(scree_world* world);

#endif
