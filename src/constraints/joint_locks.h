// SPDX-License-Identifier: MIT
// joint_locks.h -- solves the locks of a joint together, as a symmetric system of up to three equations.
#ifndef JOINT_LOCKS_H
#define JOINT_LOCKS_H
#include "constraints/joint_drive.h"

#define JOINT_LEAST_YIELD 1.0e-6f // minimum of JointFactors.d2 as a share of yield[2]; less is a rounding error

// m/s, rad/s: maximum speed at which errors are corrected in a chain. Frames that are far apart, because a body was
// teleported or a contact held it back, then come together without a blow. Other joints correct distances at up to
// START_SHARE of max_speed: the joint in the corner of a large net carries the whole net, and its error grows fast.
#define JOINT_CORRECTION 10.0f

typedef struct // equations of the locks: yield x = goal
{
	Real yield[3], cross[3];     // diagonal of the matrix; its elements 01, 02, 12
	Real soft[3], soft_cross[3]; // softness, already added to yield and cross
	Real softness[3];            // softness as a share of the coordinate's rigid yield (joint_yield)
	Real toward[3];              // m/s, rad/s: speeds at which errors are corrected
	Real back[3];                // m/s, rad/s: speeds at which locks give way to their impulses
	Real goal[3];
	Int locked[3];
} JointSystem;

// Softness in place of a nearly infinite one, as a multiple of the lock's yield: overflow would spoil the other locks.
#define JOINT_NOTHING 1.0e12f

INLINE Real joint_softer(Real softness, Real own)
{
	Real softer = softness * own;
	return blend(softer, splat(JOINT_NOTHING) * own, softer > splat(1.0e30f));
}

// Returns the softness of element ij of the matrix, as a fraction of the rigid element; 0 if lock i or j is soft. Two
// rigid locks use the smaller of their softnesses; otherwise both together would give way along a long arm that is
// oblique to their axes.
INLINE Real joint_soft_pair(const Joint* u, const Real softness[3], int i, int j)
{
	return blend(minimum(softness[i], softness[j]), splat(0.0f), joint_has(u, JOINT_SOFT(i) | JOINT_SOFT(j)));
}

// Computes the softness of locks. In the relax pass, soft locks damp (joint_spring.h) and other locks are rigid.
INLINE void joint_softnesses(const Pools* p, int i, int soft, const Joint* u, Real softness[3])
{
	Real zero = splat(0.0f);
	softness[0] = soft ? u->soft_along : zero;
	softness[1] = soft ? u->soft_across : zero;
	softness[2] = soft ? u->soft_angle : zero;
	if (soft || !p->step.springs || !lane_bits(joint_has(u, JOINT_SOFT(0) | JOINT_SOFT(1) | JOINT_SOFT(2))))
		return;
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		softness[k] = only(load(&joint_drive_row(p, k, spring_relaxes, i), 0), joint_has(u, JOINT_SOFT(k)));
}

INLINE Int joint_springs_alone(const Pools* p, int i)
{
	return load(&joint_rare(p, springs_alone, i), 0) > splat(0.0f);
}

// Replaces the equations of the rigid locks in joints that have springs, if no other constraint holds the bodies: two
// such joints of a body would alternately add energy. Locks do not yield to the pull of the springs, which is already
// computed; otherwise springs would swing more slowly, and arms would be damped. Only the rest is soft:
//     K x = -(s + b C) / (1 + g) - g / (1 + g) K P      K: rigid yields; x: impulses of this pass; s: speeds
//     b C: speeds of correction; g: softness; P: earlier impulses of locks and springs
INLINE void joint_hold_springs(const Pools* p, int i, const Joint* u, const JointPose* c, const Real speed[3],
                               JointSystem* s)
{
	Real one = splat(1.0f), pull[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	Real own[3], other[3], cross[3];
	Int rigid[3], springs = joint_springs_alone(p, i);
	joint_crosses(c, cross);
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		own[k] = joint_yield(c, k);
		rigid[k] = springs & s->locked[k] & (joint_has(u, JOINT_SOFT(k)) == 0);
		if (!joint_drives(p, u, k))
			continue;
		JointDrive d = joint_drive_load(p, i, k);
		pull[k] = blend(pull[k], joint_spring_left(&d), joint_has(u, JOINT_SPRING(k)));
	}
	other[0] = cross[0] * pull[1] + cross[1] * pull[2];
	other[1] = cross[0] * pull[0] + cross[2] * pull[2];
	other[2] = cross[1] * pull[0] + cross[2] * pull[1];
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Real answer = quotient(one, one + s->softness[k]), kept = s->softness[k] * answer;
		s->goal[k] = blend(s->goal[k], -flush_tiny(answer * speed[k] + kept * (own[k] * pull[k] + other[k])), rigid[k]);
		s->yield[k] = blend(s->yield[k], own[k], rigid[k]);
	}
	s->cross[0] = blend(s->cross[0], only(cross[0], s->locked[0] & s->locked[1]), rigid[0] | rigid[1]);
	s->cross[1] = blend(s->cross[1], only(cross[1], s->locked[0] & s->locked[2]), rigid[0] | rigid[2]);
	s->cross[2] = blend(s->cross[2], only(cross[2], s->locked[1] & s->locked[2]), rigid[1] | rigid[2]);
}

// Returns the equations of the locks without goals, which depend on velocities. Free coordinates have rows of the
// identity matrix. fastest: m/s, maximum speed at which rigid locks correct distances; soft locks have no maximum.
// chained: 1 for a joint of a chain.
OUT_OF_LINE JointSystem joint_yields(const Pools* p, int i, int soft, int chained, float fastest, const Joint* u,
                                     const JointPose* c)
{
	JointSystem s;
	Real zero = splat(0.0f), one = splat(1.0f), cross[3], *softness = s.softness, *softer = s.soft;
	Real most[3] = {splat(fastest), splat(fastest), splat(chained ? JOINT_CORRECTION : JOINT_TURNING)};
	Real impulse[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	Real rate[3] = {u->rate_along, u->rate_across, u->rate_angle};
	Real error[3] = {c->value[0] - u->length, c->value[1], c->value[2]};
	joint_softnesses(p, i, soft, u, softness);
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Real own = joint_yield(c, k), toward = rate[k] * error[k];
		s.locked[k] = joint_has(u, JOINT_LOCKED(k)) & (own > zero);
		softness[k] = only(softness[k], s.locked[k]);
		softer[k] = joint_softer(softness[k], own);
		s.toward[k] = blend(within(toward, most[k]), toward, joint_has(u, JOINT_SOFT(k)));
		s.yield[k] = blend(one, own + softer[k], s.locked[k]);
		s.goal[k] = zero;
	}
	joint_crosses(c, cross);
	Real softer01 = joint_soft_pair(u, softness, 0, 1) * cross[0],
	     softer02 = joint_soft_pair(u, softness, 0, 2) * cross[1],
	     softer12 = joint_soft_pair(u, softness, 1, 2) * cross[2];
	s.back[0] = softer[0] * impulse[0] + softer01 * impulse[1] + softer02 * impulse[2];
	s.back[1] = softer01 * impulse[0] + softer[1] * impulse[1] + softer12 * impulse[2];
	s.back[2] = softer02 * impulse[0] + softer12 * impulse[1] + softer[2] * impulse[2];
	s.soft_cross[0] = only(softer01, s.locked[0] & s.locked[1]);
	s.soft_cross[1] = only(softer02, s.locked[0] & s.locked[2]);
	s.soft_cross[2] = only(softer12, s.locked[1] & s.locked[2]);
	s.cross[0] = only(cross[0] + softer01, s.locked[0] & s.locked[1]);
	s.cross[1] = only(cross[1] + softer02, s.locked[0] & s.locked[2]);
	s.cross[2] = only(cross[2] + softer12, s.locked[1] & s.locked[2]);
	return s;
}

INLINE void joint_goals(int soft, const JointPose* c, JointSystem* s, Real speed[3])
{
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		speed[k] = joint_speed(c, k);
		if (soft)
			speed[k] = speed[k] + s->toward[k];
		Real goal = flush_tiny(soft ? speed[k] + s->back[k] : speed[k]);
		s->goal[k] = only(-goal, s->locked[k]);
	}
}

// Returns the equations of a joint of a chain, with goals.
INLINE JointSystem joint_system(const Pools* p, int i, int soft, float fastest, const Joint* u, const JointPose* c)
{
	JointSystem s = joint_yields(p, i, soft, 1, fastest, u, c);
	Real speed[3];
	joint_goals(soft, c, &s, speed);
	return s;
}

typedef struct // factors of the matrix of the equations: L D L^T
{
	Real first, l01, l02, d1, l12, d2;
} JointFactors;

// Factors the matrix. mass, 1/kg: sum of the inverse masses, a lower bound of d1 for two locked translations.
INLINE JointFactors joint_factor(const JointSystem* s, Real mass)
{
	JointFactors f;
	f.first = s->yield[0];
	f.l01 = flush_below(quotient(s->cross[0], s->yield[0]), ABSORBS);
	f.l02 = flush_below(quotient(s->cross[1], s->yield[0]), ABSORBS);
	f.d1 = blend(splat(1.0f), maximum(s->yield[1] - f.l01 * s->cross[0], mass), s->locked[1]);
	Real rest = s->cross[2] - f.l01 * s->cross[1];
	f.l12 = flush_below(quotient(rest, f.d1), ABSORBS);
	f.d2 = maximum((s->yield[2] - f.l02 * s->cross[1]) - f.l12 * rest, splat(JOINT_LEAST_YIELD) * s->yield[2]);
	return f;
}

INLINE void joint_solve(const JointFactors* f, const Real goal[3], Real x[3])
{
	Real y1 = flush_tiny(goal[1] - f->l01 * goal[0]);
	Real y2 = flush_tiny((goal[2] - f->l02 * goal[0]) - f->l12 * y1);
	x[2] = quotient(y2, f->d2);
	x[1] = quotient(y1, f->d1) - f->l12 * x[2];
	x[0] = (quotient(goal[0], f->first) - f->l01 * x[1]) - f->l02 * x[2];
}

#endif
