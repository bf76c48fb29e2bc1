// SPDX-License-Identifier: MIT
// schedule.h -- defines the order of a solve: its passes over the constraints, and the motion of bodies between them.
//     warm start; in each substep accelerate, bias, move, relax; then the restitution pass, if something can bounce
// Passes are numbered from 0. The CPU, all forms of OpenCL and the estimate of memory traffic use this file.
#ifndef SCHEDULE_H
#define SCHEDULE_H
#include "dialect/dialect.h"

#define PASS_WARM_START 0 // applies the impulses of the last step
#define PASS_BIAS       1 // pushes overlaps apart
#define PASS_RELAX      2 // removes the velocity that the bias pass added
#define PASS_BOUNCE     3 // restitution pass: fast points bounce
#define PASS_KINDS      4

// Motion of a body before a pass.
#define BODY_STAYS       0
#define BODY_ACCELERATES 1
#define BODY_MOVES       2

INLINE int schedule_passes(int substeps, int bounces) { return 1 + 2 * substeps + (bounces != 0); }

INLINE int schedule_pass(int substeps, int q)
{
	return q == 0 ? PASS_WARM_START : q > 2 * substeps ? PASS_BOUNCE : q & 1 ? PASS_BIAS : PASS_RELAX;
}

INLINE int schedule_before(int substeps, int q)
{
	return q == 0 || q > 2 * substeps ? BODY_STAYS : q & 1 ? BODY_ACCELERATES : BODY_MOVES;
}

// Returns whether bodies accelerate for the first time before pass q.
INLINE int schedule_first(int q) { return q == 1; }

// Returns the latest pass up to q that follows directly after a motion of the bodies; 0 if there was no motion yet.
INLINE int schedule_moved(int q) { return q & ~1; }

#endif
