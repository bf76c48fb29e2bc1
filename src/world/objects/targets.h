// SPDX-License-Identifier: MIT
// targets.h -- poses of kinematic bodies at the end of the next step with dt above 0.
#ifndef TARGETS_H
#define TARGETS_H
#include "scree/scree.h"
#include "step/pipeline_state.h"

// Targets stay on the host until the step, because the velocity that moves a body to its target depends on dt.

// Reserves memory for more targets, after which target_put cannot fail.
scree_status targets_reserve(scree_world* world, const char* function, int more);

// Sets the target of a kinematic body: the pose of its origin.
void target_put(scree_world* world, int body, scree_pose pose);
void target_drop(scree_world* world, int body);

// Returns the commands of a step for bodies with targets, in world_scratch: before it, the velocity to the target;
// after it, the exact pose and velocity 0; if refused, velocity 0, and targets remain. Disabled bodies keep theirs.
scree_status targets_commands(scree_world* world, StepCommands* commands);

// Removes the targets of enabled bodies after a step.
void targets_arrived(scree_world* world);

#endif
