// SPDX-License-Identifier: MIT
// joint_pass.h -- a pass over a joint: its locks, solved together, and what every kind of constraint has.
#ifndef JOINT_PASS_H
#define JOINT_PASS_H
#include "constraints/contact.h"
#include "constraints/joint_drive.h"

// share of a coordinate's own yield that remains, at least, when others are held: below it is rounding
#define JOINT_LEAST_YIELD 1.0e-6f

// A symmetric 3 x 3 system, by L D L^T. A coordinate that is not locked has a row of the identity.
INLINE void joint_solve(const Real yield[3], Real k01, Real k02, Real k12, Real floor, const Int locked[3],
                        const Real goal[3], Real x[3])
{
	Real zero = splat(0.0f), one = splat(1.0f);
	Real d0 = choose(one, yield[0], locked[0]);
	k01 = choose(zero, k01, locked[0] & locked[1]);
	k02 = choose(zero, k02, locked[0] & locked[2]);
	k12 = choose(zero, k12, locked[1] & locked[2]);
	Real l01 = k01 / d0, l02 = k02 / d0;

	// in exact arithmetic two translations yield no less than the masses alone
	Real d1 = choose(one, maximum(yield[1] - l01 * k01, floor), locked[1]);
	Real rest = k12 - l01 * k02, l12 = rest / d1;
	Real d2 = choose(one, maximum((yield[2] - l02 * k02) - l12 * rest, splat(JOINT_LEAST_YIELD) * yield[2]), locked[2]);
	Real y0 = choose(zero, goal[0], locked[0]);
	Real y1 = choose(zero, goal[1], locked[1]) - l01 * y0;
	Real y2 = (choose(zero, goal[2], locked[2]) - l02 * y0) - l12 * y1;
	x[2] = y2 / d2;
	x[1] = y1 / d1 - l12 * x[2];
	x[0] = (y0 / d0 - l01 * x[1]) - l02 * x[2];
}

// The share of the yield between coordinates i and j by which it grows: rigid locks are soft together, whatever their axes.
// Each by itself, two that pull at a long arm aslant of both axes would give way along the arm by the yield of the lever.
INLINE Real joint_soft_pair(const Joint* u, const Real softness[3], int i, int j)
{
	return choose(softness[i], splat(0.0f), joint_has(u, JOINT_SOFT(i) | JOINT_SOFT(j)));
}

// The locks: in the biased pass as soft as each is, in the relaxing pass rigid, but for those that are springs.
INLINE void joint_hold(const Pools* p, int soft, Joint* u, JointPose* c)
{
	Real zero = splat(0.0f), ia = c->a.inv_inertia, ib = c->b.inv_inertia, most = splat(p->step.max_speed);
	Real old[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	Real rate[3] = {u->rate_along, u->rate_across, u->rate_angle};
	Real softness[3] = {u->soft_along, u->soft_across, u->soft_angle};
	Real error[3] = {c->value[0] - u->length, c->value[1], c->value[2]};
	Real yield[3], softer[3], goal[3], x[3];
	Int locked[3];
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Int yields = soft ? joint_has(u, JOINT_LOCKED(k)) : joint_has(u, JOINT_SOFT(k));
		Real own = joint_yield(c, k);
		softness[k] = choose(zero, softness[k], yields);
		softer[k] = softness[k] * own;
		// one as soft as nothing must not spoil the others
		locked[k] = joint_has(u, JOINT_LOCKED(k)) & (own > zero) & (softer[k] <= splat(MOST_FLOAT));
		goal[k] = joint_speed(c, k) + within(choose(zero, rate[k], yields) * error[k], most);
		yield[k] = own + softer[k];
	}
	Real k01 = ia * c->lever_a[0] * c->lever_a[1] + ib * c->lever_b[0] * c->lever_b[1];
	Real k02 = ia * c->lever_a[0] + ib * c->lever_b[0], k12 = ia * c->lever_a[1] + ib * c->lever_b[1];
	Real softer01 = joint_soft_pair(u, softness, 0, 1) * k01, softer02 = joint_soft_pair(u, softness, 0, 2) * k02,
	     softer12 = joint_soft_pair(u, softness, 1, 2) * k12;
	goal[0] = -(goal[0] + (softer[0] * old[0] + softer01 * old[1] + softer02 * old[2]));
	goal[1] = -(goal[1] + (softer01 * old[0] + softer[1] * old[1] + softer12 * old[2]));
	goal[2] = -(goal[2] + (softer02 * old[0] + softer12 * old[1] + softer[2] * old[2]));
	joint_solve(yield, k01 + softer01, k02 + softer02, k12 + softer12, c->mass, locked, goal, x);
	u->impulse_along = choose(zero, hold_of(old[0] + x[0]), locked[0]);
	u->impulse_across = choose(zero, hold_of(old[1] + x[1]), locked[1]);
	u->impulse_angle = choose(zero, hold_of(old[2] + x[2]), locked[2]);
	joint_give(u, c,
	           joint_impulse(c, u->impulse_along - old[0], u->impulse_across - old[1], u->impulse_angle - old[2]));
}

// Starts the step with the impulses of the last one, unless they would make the bodies faster than a share of max_speed.
INLINE void joint_warm(const Pools* p, int i, Joint* u, JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	Real most = splat(START_SHARE * p->step.max_speed), spin = splat(START_SHARE * p->step.max_spin);
	Real faster = c->mass * (absolute(j.push.x) + absolute(j.push.y));
	Real spins = absolute(c->a.inv_inertia * j.angular_a) + absolute(c->b.inv_inertia * j.angular_b);
	Real part =
	    minimum(choose(splat(1.0f), most / faster, faster > most), choose(splat(1.0f), spin / spins, spins > spin));
	part = choose(splat(0.0f), part, (faster <= splat(MOST_FLOAT)) & (spins <= splat(MOST_FLOAT)));
	if (lane_bits(part < splat(1.0f)))
	{
		joint_scale(p, i, u, part);
		j.push = vec_choose(vec(splat(0.0f), splat(0.0f)), vec_scale(part, j.push), part > splat(0.0f));
		j.angular_a = choose(splat(0.0f), part * j.angular_a, part > splat(0.0f));
		j.angular_b = choose(splat(0.0f), part * j.angular_b, part > splat(0.0f));
	}
	joint_give(u, c, j);
}

// Gives the bodies what the arms' turn since the last substep changed of the impulses' worth.
INLINE void joint_turn(const Pools* p, int i, Joint* u, JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	j.push = vec_sub(j.push, vec(u->given_x, u->given_y));
	j.angular_a = j.angular_a - u->given_a;
	j.angular_b = j.angular_b - u->given_b;
	joint_give(u, c, j);
}

// The largest force and torque of all substeps, for thresholds and the user.
INLINE void joint_peak(const Pools* p, int i, const Joint* u)
{
	Real sum[JOINT_COORDINATES];
	joint_sums(p, i, u, sum);
	Real force = root(sum[0] * sum[0] + sum[1] * sum[1]), torque = absolute(sum[2]);
	store(&joint_rare(p, peak_force, i), 0, maximum(load(&joint_rare(p, peak_force, i), 0), force));
	store(&joint_rare(p, peak_torque, i), 0, maximum(load(&joint_rare(p, peak_torque, i), 0), torque));
}

// ---------------------------------------------------------------------------------------------------------------
// what every kind of constraint has
// ---------------------------------------------------------------------------------------------------------------

INLINE void joint_derive(int passes, const Body* a, const Body* b, Joint* u)
{
	(void)passes;
	(void)a;
	(void)b;
	(void)u;
}

INLINE void joint_start(const Step* step, Joint* u)
{
	(void)step;
	(void)u;
}

INLINE void joint_ready(const Body* a, const Body* b, Joint* u)
{
	(void)a;
	(void)b;
	(void)u;
}

INLINE void joint_pass(const Pools* p, int pass, int i, int held, Joint* u, Body* a, Body* b)
{
	(void)held;
	if (pass == PASS_BOUNCE)
		return;
	JointPose c = joint_pose(u, a, b);
	if (pass == PASS_WARM_START)
		joint_warm(p, i, u, &c);
	else
	{
		if (pass == PASS_BIAS)
			joint_turn(p, i, u, &c);
		for (int k = 0; k < JOINT_COORDINATES; ++k)
			if (joint_drives(p, u, k))
				joint_drive(p, i, k, pass == PASS_BIAS, u, &c);
		joint_hold(p, pass == PASS_BIAS, u, &c);
		if (pass == PASS_RELAX && p->step.drives)
			joint_peak(p, i, u);
	}
	*a = c.a;
	*b = c.b;
}

#endif
