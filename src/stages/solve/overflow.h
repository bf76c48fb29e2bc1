// SPDX-License-Identifier: MIT
// overflow.h -- solves joints that have neither a chain nor a color, because a body has more joints than colors exist.
#ifndef OVERFLOW_H
#define OVERFLOW_H
#include "constraints/constraint_kinds.h"
#include "pools/bays.h"

// Runs a pass over the joint at place k. pass: a constant, so that the compiler omits the code of other passes.
INLINE void overflow_solve(const Pools* p, int k, int pass)
{
	int ia = joint_row(p, body_a, k), ib = joint_row(p, body_b, k);
	Body a = body_gather(p, ia), b = body_gather(p, ib);
	Joint u;
	joint_load(p, k, pass, &u);
	joint_pass(p, pass, k, 0, &u, &a, &b);
	joint_store(p, k, pass, &u);
	body_scatter(p, ia, a);
	body_scatter(p, ib, b);
}

INLINE int overflow_bay(const Pools* p, int k) { return p->joint_place_slot[k] >> p->step.bays.joint_bits; }

// Runs a pass over joints with neither chain nor color, in the order of slots, before the colors. Item: one; in a batch,
// such a joint, and the first of a world solves all of them. argument: the pass.
KERNEL(joint_overflow)
{
	const GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_JOINT];
	int first = layout->begin[COLORS] + p->step.chain_places, end = first + p->counters->overflow, batch = BATCHED(p);
	if (batch && i > 0 && overflow_bay(p, first + i - 1) == overflow_bay(p, first + i))
		return;
	for (int k = first + i; k < end && (!batch || overflow_bay(p, k) == overflow_bay(p, first + i)); ++k)
	{
		if (p->argument == PASS_WARM_START)
			overflow_solve(p, k, PASS_WARM_START);
		else if (p->argument == PASS_BIAS)
			overflow_solve(p, k, PASS_BIAS);
		else if (p->argument == PASS_RELAX)
			overflow_solve(p, k, PASS_RELAX);
	}
}

#endif
