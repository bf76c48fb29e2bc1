// SPDX-License-Identifier: MIT
// targets.h -- keeps the targets of kinematic bodies: poses at the end of the next step with dt above 0. They stay on
// the host until the step, because the velocity that moves a body to its target depends on dt.
#ifndef TARGETS_H
#define TARGETS_H
#include "scree/scree.h"
#include "step/pipeline_state.h"

// Reserves memory for more targets, so that target_put cannot fail.
scree_status targets_reserve(scree_world* world, const char* function, int more);

// Sets the target of a kinematic body. pose: target pose of the body's origin.
void target_put(scree_world* world, int body, scree_pose pose);
void target_drop(scree_world* world, int body);

// Returns the commands of a step for bodies with targets, in memory of world_scratch. Commands before the step set the
// velocity that leads to the target; commands after it set the exact pose and velocity 0. After a refused step, other
// commands set velocity 0, and the targets remain. Disabled bodies get no commands, and keep their targets.
scree_status targets_commands(scree_world* world, StepCommands* commands);

// Removes the targets of enabled bodies. Must be called after each successful step with dt above 0.
void targets_arrived(scree_world* world);

#endif
