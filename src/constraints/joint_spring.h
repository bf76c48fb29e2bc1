// SPDX-License-Identifier: MIT
// joint_spring.h -- computes springs and soft locks of a joint; substeps solve the differential equation exactly.
//
// A coordinate C with the speed v, a frequency o (rad/s) and a damping ratio z obeys C" + 2 z o C' + o^2 C = 0. Over a
// time h, C and v change by a matrix with two eigenvalues e^(h l), l being the roots of l^2 + 2 z o l + o^2 = 0. D is
// the product of the eigenvalues, T their sum. A substep of length h is
//
//     bias       v2 = keeps v - A C / h
//     motion     C := C + h v2
//     relax      v := (1 - relaxes) v2
//
// It has the same eigenvalues if A = 1 - T + D and keeps (1 - relaxes) = D. With keeps = A / (h o)^2, a load F on a
// mass m rests at C = F / (m o^2). So undamped springs swing for ever, and overdamped ones creep correctly.
#ifndef JOINT_SPRING_H
#define JOINT_SPRING_H
#include "constraints/joint_constraint.h"

#define TURN 6.28318531f

#define JOINT_STIFFEST 0.25f // maximum frequency of a spring or lock as a share of the substep rate; stiffer ones shake
// Two bounds of (o h)^2; o h is the angle, in rad, by which an oscillation advances in a substep. A spring below both
// has exactly the given damping. SPRING_FREE is the square at a twelfth of the substep rate. SPRING_SHARED is divided
// by `beside` of joint_spring_of, which keeps the sum over a body's springs below 2^2, the limit of stability. Stiffer
// springs are damped by at least SPRING_CALMS times the excess of (o h)^2 over the smaller bound; otherwise 2 springs
// at a quarter of the substep rate between the same bodies, or 15 at a twelfth, would add energy.
#define SPRING_FREE   0.274155678f
#define SPRING_SHARED 3.2f
#define SPRING_CALMS  0.75f
// Minimum damping ratio of springs between bodies with other constraints, divided by the cube of the angle per substep:
// 0.06 at 20 Hz and 4 substeps, 0.0009 at 5 Hz. Rigid locks of other joints answer springs only in the next pass, which
// adds energy: without damping, arms in a row, welded with 20 Hz, gained 17 % in a second.
#define SPRING_AMONG        0.4f
#define SPRING_LEAST        1.0e-20f // square of the angle per substep below which a spring counts as absent
#define SPRING_LEAST_YIELD  1.0e-6f  // minimum of joint_share_free; smaller results are rounding errors
#define SPRING_LEAST_ANSWER 1.0e-6f  // minimum of 1 - keeps, by which the equations of a soft lock divide

// Returns 1 - e^-x for x >= 0: a series for x / 256, then eight doublings of x. Above 64, the result is 1.
INLINE Real spring_lost(Real x)
{
	Real y = minimum(x, splat(64.0f)) * splat(1.0f / 256.0f), one = splat(1.0f);
	Real lost = y * (one - y * splat(1.0f / 2.0f) *
	                           (one - y * splat(1.0f / 3.0f) *
	                                      (one - y * splat(1.0f / 4.0f) *
	                                                 (one - y * splat(1.0f / 5.0f) * (one - y * splat(1.0f / 6.0f))))));
	for (int k = 0; k < 8; ++k)
		lost = lost * (2.0f - lost);
	return lost;
}

// Returns 2 - 2 cos(sqrt(q)) for q from 0 to (pi / 2)^2, by its series.
INLINE Real spring_versine(Real q)
{
	Real one = splat(1.0f);
	return q * (one - q * splat(1.0f / 12.0f) *
	                      (one - q * splat(1.0f / 30.0f) *
	                                 (one - q * splat(1.0f / 56.0f) * (one - q * splat(1.0f / 90.0f)))));
}

typedef struct
{
	Real keeps, pull, relaxes; // coefficients of the substep at the head of this file; pull is A there
} JointSpring;

// Returns the coefficients of a spring. hertz, ratio: frequency and damping ratio of the joint without its locks.
// share: the yield while the rigid locks hold, divided by the yield without locks. beside: largest number of
// constraints of a body of the joint, times the number of springs of the joint. alone: above 0 in lanes whose bodies
// have no other constraints.
INLINE JointSpring joint_spring_of(const Pools* p, Real hertz, Real ratio, Real share, Real beside, Real alone)
{
	Real zero = splat(0.0f), one = splat(1.0f);
	Real own = splat(TURN) * (p->step.h * minimum(hertz, splat(JOINT_STIFFEST * p->step.inv_h)));
	Real angle = own * root(share), square = angle * angle;
	Int acts = square > splat(SPRING_LEAST);
	Real least = blend(splat(SPRING_AMONG) * own * own * own * own * share, zero, alone > zero);
	square = blend(one, square, acts);
	Real free = minimum(splat(SPRING_FREE), quotient(SPRING_SHARED, beside));
	Real decay = maximum(maximum(ratio * own * share, least), splat(SPRING_CALMS) * (square - free));
	Real rest = (angle - decay) * (angle + decay);
	Int over = rest < zero;

	// underdamped: the eigenvalues are e^-decay, rotated by the root of `rest` in both directions
	Real lost = spring_lost(decay), left = one - lost;
	Real circular = lost * lost + left * spring_versine(blend(rest, zero, over));
	// overdamped: two real decays; the slow one is a quotient, because a difference of near numbers is inexact
	Real fast = decay + root(only(-rest, over));
	Real slow = quotient(square, blend(one, fast, over));
	Real pull = blend(circular, spring_lost(slow) * spring_lost(fast), over);

	Real product = left * left, keeps = minimum(maximum(quotient(pull, square), product), one);
	JointSpring s;
	s.keeps = blend(one, keeps, acts);
	s.pull = only(pull, acts);
	s.relaxes = only(maximum(one - quotient(product, keeps), zero), acts);
	return s;
}

// Computes elements 01, 02 and 12 of the yield matrix: the speed of one coordinate that a unit impulse along another
// causes, in 1/kg for 01, and in 1/(kg m) for 02 and 12.
INLINE void joint_crosses(const JointPose* c, Real cross[3])
{
	Real ia = c->a.inv_inertia, ib = c->b.inv_inertia;
	cross[0] = flush_element(ia * c->lever_a[0] * c->lever_a[1] + ib * c->lever_b[0] * c->lever_b[1]);
	cross[1] = joint_yield_turning(c, JOINT_ALONG);
	cross[2] = joint_yield_turning(c, JOINT_ACROSS);
	if (!c->rails)
		return;
	cross[1] = blend(cross[1], cross[1] - c->bend * joint_yield(c, JOINT_ALONG), c->railed);
	cross[2] = blend(cross[2], cross[2] - c->bend * cross[0], c->railed);
}

INLINE Int joint_rigid(const Joint* u, const JointPose* c, int k)
{
	return joint_has(u, JOINT_LOCKED(k)) & (joint_has(u, JOINT_SOFT(k)) == 0) & (joint_yield(c, k) > splat(0.0f));
}

// Returns the yield of coordinate k while rigid locks hold, as a share of its yield without locks: a Schur complement.
INLINE Real joint_share_free(const Joint* u, const JointPose* c, int k)
{
	Real zero = splat(0.0f), one = splat(1.0f), cross[3];
	int i = k == 0 ? 1 : 0, j = k == JOINT_ANGLE ? 1 : JOINT_ANGLE;
	joint_crosses(c, cross);
	Int first = joint_rigid(u, c, i), second = joint_rigid(u, c, j);
	Real ki = only(cross[k + i - 1], first), kj = only(cross[k + j - 1], second);
	Real ij = only(cross[i + j - 1], first & second);
	Real ii = blend(one, joint_yield(c, i), first), jj = blend(one, joint_yield(c, j), second);
	Real own = joint_yield(c, k), l = quotient(ij, ii);
	Real rest = maximum(jj - l * ij, splat(SPRING_LEAST_YIELD) * jj), kept = kj - l * ki;
	Real yield = (own - ki * quotient(ki, ii)) - kept * quotient(kept, rest);
	Int sound = (own > zero) & (yield <= own);
	return blend(one, maximum(quotient(yield, blend(one, own, sound)), splat(SPRING_LEAST_YIELD)), sound);
}

#endif
