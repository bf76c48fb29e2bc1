// SPDX-License-Identifier: MIT
// joint_prepare.h -- computes the rows of a joint for the step, from its data and the poses of its bodies.
#ifndef JOINT_PREPARE_H
#define JOINT_PREPARE_H
#include "constraints/angle.h"
#include "constraints/joint_spring.h"
#include "pools/bays.h"

// Reads four numbers of joint `slot`. place: offset in JointData, in units of four numbers.
INLINE void joint_quad(const Pools* p, Int slot, int place, Real out[4])
{
	gather_rows4((GLOBAL float*)p->joint_data, slot * JOINT_QUADS + place, out);
}

// Rounds a number, whose absolute value is below 2^22, to the nearest whole number.
INLINE Real joint_round(Real x) { return (x + splat(12582912.0f)) - splat(12582912.0f); }

#define JOINT_SOFTEST 1.0e30f // upper bound of a softness (1 / a2 below), which could be infinite
// Factor of the frequency that sets the softness of rigid locks in a chain; above 1, because chains are solved exactly.
// The rate of correction has no factor: at a higher rate a chain whips when its end is suddenly moved.
#define JOINT_CHAIN_STIFFER 4.0f

// Computes softness and rate of correction, 1/s, of a rigid lock or a limit (Catto, Soft Constraints, GDC 2011).
INLINE void joint_softness(const Pools* p, Real hertz, Real ratio, Real stiffer, Real* rate, Real* soft)
{
	Real omega = splat(TURN) * (stiffer * minimum(hertz, splat(JOINT_STIFFEST * p->step.inv_h)));
	Real a1 = 2.0f * ratio + p->step.h * omega, a2 = p->step.h * omega * a1;

	// a lock just above 0 Hz is so soft that it has no effect; at exactly 0 Hz it is rigid
	*rate = only(quotient(omega, a1), a2 > splat(0.0f));
	*soft = only(minimum(quotient(1.0f, a2), splat(JOINT_SOFTEST)), hertz > splat(0.0f));
}

// Computes rate and softness of the lock of coordinate k. joint_setup_spring replaces them for a soft lock.
INLINE void joint_lock(const Pools* p, const Real joint[4], int k, Int chained, Real* rate, Real* soft)
{
	Real chain_rate, chain_soft;
	joint_softness(p, joint[0], joint[1], splat(1.0f), rate, soft);
	joint_softness(p, joint[0], joint[1], splat(JOINT_CHAIN_STIFFER), &chain_rate, &chain_soft);
	*soft = blend(*soft, chain_soft, chained);

	// in a chain, angles do not yield: a welded beam does not sag. Translations do, to limit the pull of a tight bridge
	if (k == JOINT_ANGLE)
		*soft = blend(*soft, splat(0.0f), chained);
}

// Returns the lanes whose body is the ground of its world.
INLINE Int joint_ground(const Pools* p, Int body)
{
	if (!BATCHED(p))
		return body == 0;
	// the quotient, and so the number of the bay, may be off by one
	int size = p->step.bays.bodies;
	Int rest = body - whole(real_of(body) * p->step.bays.body_part) * size;
	return (rest == 0) | (rest == size) | (rest == -size);
}

typedef struct // pose of a frame in the world
{
	Vec arm, turn;      // arm from the center of mass; cos, sin
	Vec position, rest; // position of the center of mass, and its rounding error
} JointFrame;

// Returns a frame of a joint, moved by `offset` along the frame's axes. place: offset of the frame in JointData.
OUT_OF_LINE JointFrame joint_frame(const Pools* p, Int slot, int place, Int body, Vec offset)
{
	JointFrame end;
	Real placed[4], pose[4];
	joint_quad(p, slot, place, placed);
	gather_rows4((GLOBAL float*)p->pose, body, pose);
	const GLOBAL float *center = (const GLOBAL float*)p->local_center, *low = (const GLOBAL float*)p->pose_low;
	Vec own = vec(placed[0], placed[1]), frame = vec(placed[2], placed[3]), turn = vec(pose[2], pose[3]);
	own = vec_add(vec_sub(own, vec(gather(center, body * 2), gather(center, body * 2 + 1))), vec_turn(frame, offset));
	// a frame in the world is a position with a zero arm: an arm from the origin could be long, and rounding would make
	// the other body's arm less exact
	Int world = joint_ground(p, body);
	Vec zero = vec(splat(0.0f), splat(0.0f));
	end.arm = vec_blend(vec_turn(turn, own), zero, world);
	end.turn = vec_turn(turn, frame);
	end.position = vec_blend(vec(pose[0], pose[1]), own, world);
	end.rest = vec(gather(low, body * 2), gather(low, body * 2 + 1));
	return end;
}

INLINE Vec joint_gap(const JointFrame* a, const JointFrame* b)
{
	return vec_add(vec_add(vec_sub(b->position, a->position), vec_sub(b->rest, a->rest)), vec_sub(b->arm, a->arm));
}

// Returns the angle from frame a to frame b over all turns; of the possible angles, the nearest to `last`.
INLINE Real joint_turned(const JointFrame* a, const JointFrame* b, Real last)
{
	Real angle = vec_angle(vec_turn_back(a->turn, b->turn));
	return angle + splat(TURN) * joint_round((last - angle) * splat(1.0f / TURN));
}

// Returns the frame of body a, moved by `offset`. In lanes with `railed`, it lies at the point of the path that
// joint_follow found instead, with its x axis along the tangent.
INLINE JointFrame joint_frame_railed(const Pools* p, int i, Int slot, Int body, Vec offset, Int railed)
{
	Vec foot = vec(load(&joint_rare(p, foot_x, i), 0), load(&joint_rare(p, foot_y, i), 0));
	Vec tangent = vec(load(&joint_rare(p, foot_cos, i), 0), load(&joint_rare(p, foot_sin, i), 0));
	JointFrame a = joint_frame(p, slot, JOINT_AT_FRAME(0), body, vec_blend(offset, foot, railed));
	a.turn = vec_blend(a.turn, vec_turn(a.turn, tangent), railed);
	return a;
}

// Raises the widest gap of the world of each joint, in a batch. square: m^2, the squares of gaps.
INLINE void joint_bay_gap(const Pools* p, Int slot, Real square)
{
	GLOBAL int* widest = &p->bay_state->joint_gap;
	Int at = (slot >> p->step.bays.joint_bits) * BAY_WORDS;
	Real most = gather((const GLOBAL float*)widest, at);
	Word wider = lane_bits((square > most * most) & (square <= splat(MOST_FLOAT)));
	if (!wider)
		return;
	Real gap = root(square);
	for (int k = 0; wider >> k != 0; ++k)
		if (wider >> k & 1)
			atomic_max_int(widest + lane(at, k), float_bits(lane(gap, k)));
}

// Raises Counters.joint_gap, which the user can read: m, largest error of rigid locks of translations. Couplings do not
// count. gap: m, vector between the anchors. slot: 0 for padding, which has no gap.
INLINE void joint_count_gap(const Pools* p, Int slot, const Joint* u, Vec gap)
{
	Vec axis = joint_line(vec(u->axis_x, u->axis_y), gap, joint_has(u, JOINT_RADIAL));
	Real off[2];
	off[0] = vec_dot(gap, axis) - u->length;
	off[1] = vec_cross(axis, gap);
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		Int counts = joint_has(u, JOINT_LOCKED(k)) & (joint_has(u, JOINT_SOFT(k) | JOINT_COUPLED) == 0);
		off[k] = only(off[k], counts & (absolute(off[k]) >= splat(TINY)));
	}
	Real square = off[0] * off[0] + off[1] * off[1];
	Real most = splat(bits_float(read_shared(&p->counters->joint_gap)));
	Word wider = lane_bits((square > most * most) & (square <= splat(MOST_FLOAT)));
	if (wider)
		raise_lanes(&p->counters->joint_gap, root(square), wider);
	if (BATCHED(p))
		joint_bay_gap(p, slot, square);
}

// Sets Counters.press[1] if the anchors of a joint are more than PRESS_GAP apart and one of its bodies cannot move.
// Radial joints, couplings and joints on a path do not count. there: lanes with a joint.
INLINE void joint_press(const Pools* p, int i, const Joint* u, Int there, Vec gap)
{
	Int pulls = there & (joint_has(u, JOINT_RADIAL | JOINT_COUPLED | JOINT_RAILED) == 0);
	Word far = p->step.presses ? lane_bits(pulls & (vec_dot(gap, gap) > splat(PRESS_GAP * PRESS_GAP))) : 0;
	for (int k = 0; far != 0; ++k, far >>= 1)
		if (far & 1 && !(p->body[joint_row(p, body_a, i + k)].inv_mass > 0.0f &&
		                 p->body[joint_row(p, body_b, i + k)].inv_mass > 0.0f))
		{
			raise_int(&p->counters->press[1], 1);
			if (BATCHED(p))
				raise_int(&bay_of_joint(p, p->joint_place_slot[i + k])->press[1], 1);
		}
}

// Computes all prepared rows of joint i, except the rare ones. slot: -1 for padding.
INLINE void joint_setup(const Pools* p, int i, Int slot, Joint* u)
{
	Real zero = splat(0.0f), one = splat(1.0f), target[JOINT_COORDINATES];
	Int there = slot >= 0, ia = load_int(&joint_row(p, body_a, i), 0), ib = load_int(&joint_row(p, body_b, i), 0);
	slot = slot & ~(slot >> 31);
	Real head[4], joint[4];
	joint_quad(p, slot, JOINT_AT_MODES, head);
	joint_quad(p, slot, JOINT_AT_HERTZ, joint);
	u->modes = only(head[2], there);
	Int radial = joint_has(u, JOINT_RADIAL | JOINT_COUPLED);
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Real lock[4];
		joint_quad(p, slot, JOINT_AT_LOCK(k), lock);
		target[k] = only(lock[0], joint_has(u, JOINT_LOCKED(k)));
	}
	u->length = only(target[JOINT_ALONG], radial);

	// targets of locks move frame A, so that coordinates are measured from the targets
	Vec offset = vec(blend(target[JOINT_ALONG], zero, radial), target[JOINT_ACROSS]);
	Int railed = joint_has(u, JOINT_RAILED);
	Word rails = p->step.paths ? lane_bits(railed) : 0u;
	JointFrame a = rails ? joint_frame_railed(p, i, slot, ia, offset, railed)
	                     : joint_frame(p, slot, JOINT_AT_FRAME(0), ia, offset);
	JointFrame b = joint_frame(p, slot, JOINT_AT_FRAME(1), ib, vec(zero, zero));
	if (rails)
		u->length = blend(u->length, target[JOINT_ALONG] - load(&joint_rare(p, foot_along, i), 0), railed);
	Vec gap = joint_gap(&a, &b);
	Int upright = joint_upright(u);
	Vec axis = vec_blend(a.turn, vec(one, zero), upright);
	u->modes = u->modes + blend(splat((float)JOINT_TURNS), zero, upright | radial | (there == 0));
	u->axis_x = axis.x;
	u->axis_y = axis.y;
	u->arm_a_x = a.arm.x;
	u->arm_a_y = a.arm.y;
	u->arm_b_x = b.arm.x;
	u->arm_b_y = b.arm.y;
	u->gap_x = gap.x;
	u->gap_y = gap.y;
	joint_count_gap(p, slot, u, gap);
	joint_press(p, i, u, there, gap);

	u->turned = joint_turned(&a, &b, load(&joint_row(p, turned, i), 0));
	u->angle = u->turned - target[JOINT_ANGLE];
	Int chained = there & (gather_int((const GLOBAL int*)p->joint_spot, slot) >= 0);
	joint_lock(p, joint, JOINT_ALONG, chained, &u->rate_along, &u->soft_along);
	joint_lock(p, joint, JOINT_ACROSS, chained, &u->rate_across, &u->soft_across);
	joint_lock(p, joint, JOINT_ANGLE, chained, &u->rate_angle, &u->soft_angle);
	u->given_x = zero;
	u->given_y = zero;
	u->given_a = zero;
	u->given_b = zero;

	// tiles and relay keep joints in registers, and store only the rows that passes write
	store(&joint_row(p, turned, i), 0, u->turned);
}

#endif
