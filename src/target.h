// SPDX-License-Identifier: MIT
// target.h -- poses at which kinematic bodies are to be at the end of the next step that takes time.
//
// The speed that takes a body there depends on that step, so a target waits on the host until then.
#ifndef TARGET_H
#define TARGET_H
#include "pools/pools.h"
#include "scree/scree.h"

typedef struct
{
	int body;
	scree_pose pose; // of the origin
} Target;

// Forgets the target of a body, if it has one.
void target_drop(scree_world* world, int body);

// Before a step: bodies get the velocity that takes them to their targets. Those that are disabled keep theirs for later.
scree_status targets_begin(scree_world* world, const Step* step);
// After it: they are there and stand still; or, where the step was refused, they stand still and have their targets.
scree_status targets_end(scree_world* world, const Step* step, bool arrived);

#endif
