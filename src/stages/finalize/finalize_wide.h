// SPDX-License-Identifier: MIT
// finalize_wide.h -- finalizes several bodies of a batch at once, and lists those that need the kernel for one body.
//
// The operations are those of finalize.h and pose.h, in the same order, so the bits are equal. Listed are bodies that may
// be pressed, may meet something on their path, or have a state that is not finite.
#ifndef FINALIZE_WIDE_H
#define FINALIZE_WIDE_H
#include "constraints/sweep_closing.h"
#include "stages/geometry/pose_sum.h"

INLINE void finalize_list(const Pools* p, int i)
{
	p->moved_bodies[atomic_add_int(&p->counters->listed_bodies, 1)] = i;
}

// Returns the bodies that the kernel for one body must finalize. b: rows of the pool body; v, w: their velocities.
INLINE Int finalize_rare(const Pools* p, int i, const Real* b, Vec v, Real w)
{
	Real zero = splat(0.0f), data[4];
	Int moves = b[3] > zero;
	Int rare = (0.0f * v.x + 0.0f * v.y + 0.0f * w + 0.0f * b[4] + 0.0f * b[5] + 0.0f * b[6] == zero) == 0;
	if (p->counters->presses != 0)
		rare = rare | moves;
	Real far = absolute(b[4]) + absolute(b[5]), swing = absolute(b[6]);
	Int wanted = moves & (far + swing * p->step.continuous_reach > splat(p->step.continuous_way));
	if (!lane_bits(wanted))
		return rare;
	load_rows4((GLOBAL float*)p->continuous_body, i, data);
	return rare | (wanted & (far + swing * data[3] > data[2]));
}

// Item: LANES bodies of a batch, from body i on, in which no body sleeps.
WIDE_KERNEL(finalize_wide)
{
	Real b[8], m[8], pose[4], low_x, low_y, lack_x, lack_y;
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	load_rows4((GLOBAL float*)p->pose, i, pose);
	gather_pairs((const GLOBAL float*)p->pose_low, indices(i), &low_x, &low_y);
	Vec v = vec(m[6] * b[0], m[7] * b[1]);
	Real w = b[2], da = b[6];
	Int rare = finalize_rare(p, i, b, v, w), done = rare == 0;

	Vec turn = vec(pose[2], pose[3]), turned = vec_turn(vec_rotation(da), turn);
	turned = vec_scale(unit_factor(vec_dot(turned, turned)), turned);
	turn = vec_blend(turn, turned, da != splat(0.0f));
	Real x = pose_sum(pose[0], b[4] + low_x, &lack_x), y = pose_sum(pose[1], b[5] + low_y, &lack_y);
	Real moved[4] = {x, y, turn.x, turn.y};
	v = vec_flush_tiny(sweep_velocity(&p->step, v));
	Real now[4] = {v.x, v.y, flush_tiny(within(w, splat(p->step.max_spin))), b[3]};
	scatter_rows4((GLOBAL float*)p->start_pose, indices(i), pose, done);
	scatter_rows4((GLOBAL float*)p->pose, indices(i), moved, done);
	scatter_rows4of8((GLOBAL float*)p->body, indices(i), now, done);
	Int forced = done & ((real_bits(m[0]) | real_bits(m[1]) | real_bits(m[2])) != 0);
	if (lane_bits(forced))
	{
		Real rest[4] = {splat(0.0f), splat(0.0f), splat(0.0f), m[3]};
		scatter_rows4of8((GLOBAL float*)p->motion, indices(i), rest, forced);
	}
	Word listed = lane_bits(rare);
	for (int k = 0; k < LANES; ++k)
	{
		if (listed >> k & 1)
			finalize_list(p, i + k);
		else
			p->pose_low[i + k] = make_float2(lane(lack_x, k), lane(lack_y, k));
	}
}

#endif
