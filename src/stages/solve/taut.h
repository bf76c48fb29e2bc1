// SPDX-License-Identifier: MIT
// taut.h -- computes the inertia that a body needs under the pull of its colored joints, as in a loaded net.
//
// A short body between two joints that pull at it is like a piece of a string: it swings faster than substeps can
// resolve, and the corner of a net opens. As in a chain (chain_stiff.h), its inertia for the step is that of an
// implicit integration of the pull, the sum of h (arm . pull), if that is larger. These kernels run only if the pull of
// a joint recently required more than JOINT_TAUT of an inertia (joint_tautens).
#ifndef TAUT_H
#define TAUT_H
#include "constraints/constraint_kinds.h"

// Adds the inertia that a pull requires, `pull`, to member da of a body. turn: sum of earlier joints, in member da.
INLINE void taut_add(const Pools* p, Int body, const Body* b, Real turn, Real pull)
{
	Real zero = splat(0.0f), row[4];
	row[0] = row[1] = zero;
	row[2] = turn + only(pull, absolute(pull) <= splat(MOST_FLOAT));
	row[3] = b->inv_inertia;
	scatter_rows4of8((GLOBAL float*)p->body + 4, body, row, b->inv_mass > zero);
}

WIDE_KERNEL(joint_taut)
{
	Int ia = load_int(&joint_row(p, body_a, i), 0), ib = load_int(&joint_row(p, body_b, i), 0);
	Joint u;
	JointPose c;
	joint_load(p, i, PASS_WARM_START, &u);
	c.a = body_gather(p, ia);
	c.b = body_gather(p, ib);
	Real turn_a = c.a.da, turn_b = c.b.da, sum[JOINT_COORDINATES];
	c.a.da = c.b.da = splat(0.0f);
	body_turn(&c.a);
	body_turn(&c.b);
	joint_pose(p, i, &u, &c);
	joint_sums(p, i, &u, sum);
	JointPull pull = joint_pull(p, &u, &c, joint_impulse(&c, sum[0], sum[1], splat(0.0f)).push);
	Real ratio = h_ratio_of(p, i);
	taut_add(p, ia, &c.a, turn_a, ratio * pull.a);
	taut_add(p, ib, &c.b, turn_b, ratio * pull.b);
}

#endif
