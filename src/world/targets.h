// SPDX-License-Identifier: MIT
// targets.h -- poses at which kinematic bodies are to be at the end of the next step that takes time.
//
// The speed that takes a body there depends on that step, so a target waits on the host until then.
#ifndef TARGETS_H
#define TARGETS_H
#include "scree/scree.h"
#include "step/pipeline.h"

typedef struct
{
	int body;
	scree_pose pose; // of the origin
} Target;

// Forgets the target of a body, if it has one.
void target_drop(scree_world* world, int body);

// What a step does to bodies with targets: before it they get the velocity that takes them there, after it they are there and
// stand still; where it was refused they stand still and have their targets. Those that are disabled keep theirs for later. The
// commands are valid until the world's scratch memory is asked for again.
scree_status targets_commands(scree_world* world, StepCommands* commands);
// The step was taken.
void targets_arrived(scree_world* world);

#endif
