// SPDX-License-Identifier: MIT
// joint_pass.h -- executes a pass over a joint: a part that depends on positions only, then one that needs velocities.
#ifndef JOINT_PASS_H
#define JOINT_PASS_H
#include "constraints/bay_gravity.h"
#include "constraints/contact_constraint.h"
#include "constraints/coupling.h"
#include "constraints/joint_locks.h"
#include "constraints/path_constraint.h"

#define JOINT_CARRIES 1.5f // maximum factor by which the bound of a joint's warm start grows from step to step

// Minimum of the bound of a joint's warm start, in units of START_SHARE; 5 is all of max_speed and max_spin. When a
// ragdoll lands, impulses that balance each other hold its limbs, but a single one of them would spin a hand faster
// than a fifth of max_spin. With a smaller minimum, a joint opens again after the impact.
#define JOINT_BLOW 5.0f

// Sets impulses of the locks that are not felt to 0; for heavy bodies.
OUT_OF_LINE void joint_hold_felt(const JointPose* c, Real impulse[3])
{
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		impulse[k] = joint_felt(impulse[k], joint_yield(c, k));
}

// Adds x to the impulses of the locks, clears the impulses of other coordinates, and applies the changes. turns: lanes
// with a lock of the angle.
INLINE void joint_hold(const Step* step, Joint* u, JointPose* c, const Real x[3], Int turns)
{
	Real old[3] = {u->impulse_along, u->impulse_across, u->impulse_angle}, now[3];
	UNROLL
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		now[k] = bounded_impulse(old[k] + x[k]);
	if (step->heavy)
		joint_hold_felt(c, now);
	u->impulse_along = only(now[0], joint_has(u, JOINT_LOCKED(0)));
	u->impulse_across = only(now[1], joint_has(u, JOINT_LOCKED(1)));
	u->impulse_angle = only(now[2], turns);
	joint_give(u, c,
	           joint_impulse(c, u->impulse_along - old[0], u->impulse_across - old[1], u->impulse_angle - old[2]));
}

typedef struct // kg m^2: inertia that the pull of a joint adds to its bodies in an implicit integration
{
	Real a, b;
} JointPull;

// Returns the pull of a joint; 0 unless rigid locks hold both translations. push: N s, impulse on body b.
INLINE JointPull joint_pull(const Pools* p, const Joint* u, const JointPose* c, Vec push)
{
	Int holds = joint_upright(u);
	JointPull pull;
	pull.a = only(-p->step.h * vec_dot(c->arm_a, push), holds);
	pull.b = only(p->step.h * vec_dot(c->arm_b, push), holds);
	return pull;
}

// Share of a body's inertia: if a joint's pull exceeds it, taut.h sums all pulls at each body in the next step.
#define JOINT_TAUT 0.25f

// Sets Counters.taut if the pull of a joint exceeds this share. i: place of the joint.
INLINE void joint_tautens(const Pools* p, int i, const Joint* u, const JointPose* c, Vec push)
{
	JointPull pull = joint_pull(p, u, c, push);
	Real most = maximum(pull.a * c->a.inv_inertia, pull.b * c->b.inv_inertia);
	Word lanes = lane_bits(most > splat(JOINT_TAUT));
	if (lanes)
		raise_int(&p->counters->taut, 1);
	for (int k = 0; BATCHED(p) && lanes >> k != 0; ++k)
		if (lanes >> k & 1)
			raise_int(&bay_of_joint(p, p->joint_place_slot[i + k])->taut, 1);
}

// Applies the impulses of the last step, reduced if they would change the velocities by more than an allowed share of
// max_speed and max_spin: an impact must not be repeated. The allowed share grows while a joint carries an impulse from
// step to step, because such an impulse is a load, as in the corner of a net, which carries the weight of all knots.
INLINE void joint_warm(const Pools* p, int i, Joint* u, JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	if (p->step.h_ratio != 1.0f) // the length of the substep has changed: forces stay the same, impulses do not
		joint_scale(p, i, u, h_ratio_of(p, i));
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	joint_tautens(p, i, u, c, j.push);
	Real most = splat(START_SHARE * p->step.max_speed), spin = splat(START_SHARE * p->step.max_spin);
	Real faster = c->mass * (absolute(j.push.x) + absolute(j.push.y));
	if (c->couples)
		faster = blend(faster,
		               c->a.inv_mass * (absolute(j.push_a.x) + absolute(j.push_a.y)) +
		                   c->b.inv_mass * (absolute(j.push.x) + absolute(j.push.y)),
		               c->coupled);
	Real spins = absolute(c->a.inv_inertia * j.angular_a) + absolute(c->b.inv_inertia * j.angular_b);
	Real shares = flush_tiny(maximum(quotient(faster, most), quotient(spins, spin)));
	Real allowed = maximum(splat(JOINT_BLOW), splat(JOINT_CARRIES) * u->carried);
	Int sound = (faster <= splat(MOST_FLOAT)) & (spins <= splat(MOST_FLOAT));
	Real part = only(blend(splat(1.0f), quotient(allowed, shares), shares > allowed), sound);
	u->carried = only(minimum(shares, allowed), sound);
	if (lane_bits(part < splat(1.0f)))
	{
		joint_scale(p, i, u, part);
		j.push = vec_blend(vec(splat(0.0f), splat(0.0f)), vec_scale(part, j.push), part > splat(0.0f));
		j.push_a = vec_blend(vec(splat(0.0f), splat(0.0f)), vec_scale(part, j.push_a), part > splat(0.0f));
		j.angular_a = only(part * j.angular_a, part > splat(0.0f));
		j.angular_b = only(part * j.angular_b, part > splat(0.0f));
	}
	joint_give(u, c, j);
}

// Returns the impulse that the rotation of a joint's arms since the last substep requires: the effect of the joint's
// impulses at the current arms, minus their effect at the arms of the last substep.
INLINE JointImpulse joint_turn_impulse(const Pools* p, int i, Joint* u, const JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	// stretched springs (`torn`) may have had other axes in the last pass
	if (p->step.springs)
	{
		Vec given = vec(u->given_x, u->given_y);
		u->impulse_along = blend(u->impulse_along, vec_dot(given, c->axis[0]), c->torn);
		u->impulse_across = blend(u->impulse_across, vec_dot(given, c->axis[1]), c->torn);
	}
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	j.push = vec_sub(j.push, vec(u->given_x, u->given_y));
	j.push_a = c->couples ? vec_blend(j.push, vec_sub(j.push_a, c->given_a), c->coupled) : j.push;
	j.angular_a = j.angular_a - u->given_a;
	j.angular_b = j.angular_b - u->given_b;
	return j;
}

INLINE void joint_turn(const Pools* p, int i, Joint* u, JointPose* c)
{
	JointImpulse j = joint_turn_impulse(p, i, u, c);
	joint_give(u, c, j);
}

INLINE void joint_peak(const Pools* p, int i, const Joint* u, const JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	joint_sums(p, i, u, sum);
	if (c->rails)
		sum[0] = blend(sum[0], sum[0] - c->bend * sum[2], c->railed);
	Real force = root(sum[0] * sum[0] + sum[1] * sum[1]), torque = absolute(sum[2]);
	if (p->step.couplings)
	{
		Int turns = coupling_turns(u);
		torque = blend(torque, absolute(sum[0]), turns);
		force = blend(force, splat(0.0f), turns);
	}
	store(&joint_rare(p, peak_force, i), 0, maximum(load(&joint_rare(p, peak_force, i), 0), force));
	store(&joint_rare(p, peak_torque, i), 0, maximum(load(&joint_rare(p, peak_torque, i), 0), torque));
}

// Functions that every kind of constraint must have; for joints they do nothing.

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

// Limit of the speed across a path, as a multiple of the speed that the path's curvature causes in a substep. A faster
// body is being pulled back to the path from afar.
#define JOINT_BENDS 8.0f

// Keeps the speed of a bead along its path while the bead is pulled back to the path from afar. In a substep, the
// tangent turns by the angle h * bend * (speed along). Without this impulse, the speed along would grow by this angle
// times the speed across. The impulse is not warm started.
INLINE void joint_keep_along(const Pools* p, Joint* u, JointPose* c)
{
	Real zero = splat(0.0f), along = joint_speed_linear(c, JOINT_ALONG), across = joint_speed_linear(c, JOINT_ACROSS);
	Real turn = p->step.h * c->bend * along, yield = joint_yield_linear(c, JOINT_ALONG);
	Int pulled = c->railed & joint_has(u, JOINT_LOCKED(JOINT_ACROSS)) & (yield > zero) &
	             (absolute(across) > splat(JOINT_BENDS) * absolute(turn * along)) & (absolute(turn) < splat(1.0f));
	Real impulse = joint_bounded(&p->step, quotient(-(turn * across), blend(splat(1.0f), yield, pulled)), yield);
	joint_give_where(u, c, joint_impulse(c, only(impulse, pulled), zero, zero), pulled);
}

typedef struct // the part of a pass that depends on the positions of the bodies, and not on their velocities
{
	JointPose c; // its velocities are not used
	JointImpulse turned;
	JointSystem system; // equations of the locks, without goals
	JointFactors factors;
} JointReady;

INLINE void joint_posed(const Pools* p, int i, const Body* a, const Body* b, const Joint* u, JointPose* c)
{
	c->a = *a;
	c->b = *b;
	joint_pose(p, i, u, c);
	coupling_pose(p, i, u, c);
	path_pose(p, i, u, c);
}

INLINE void joint_ready_locks(const Pools* p, int pass, int i, const Joint* u, const JointPose* c, JointReady* ready)
{
	ready->system = joint_yields(p, i, pass == PASS_BIAS, 0, START_SHARE * p->step.max_speed, u, c);
	ready->factors = joint_factor(&ready->system, c->mass);
}

// Computes *ready, which is most of the work of a pass; a GPU does it while other constraints change the velocities.
INLINE void joint_ready(const Pools* p, int pass, int i, const Body* a, const Body* b, Joint* u, JointReady* ready)
{
	if (pass == PASS_BOUNCE)
		return;
	joint_posed(p, i, a, b, u, &ready->c);
	if (pass == PASS_BIAS)
		ready->turned = joint_turn_impulse(p, i, u, &ready->c);
	if (pass != PASS_WARM_START)
		joint_ready_locks(p, pass, i, u, &ready->c, ready);
}

// Solves the impulses of the locks, after those of the drives.
INLINE void joint_locks(const Pools* p, int pass, int i, JointReady* ready, Joint* u, JointPose* c)
{
	Real speed[JOINT_COORDINATES], x[JOINT_COORDINATES];
	joint_goals(pass == PASS_BIAS, c, &ready->system, speed);
	if (pass == PASS_BIAS && p->step.springs && lane_bits(joint_springs_alone(p, i)))
	{
		joint_hold_springs(p, i, u, c, speed, &ready->system);
		ready->factors = joint_factor(&ready->system, c->mass);
	}
	joint_solve(&ready->factors, ready->system.goal, x);
	joint_hold(&p->step, u, c, x, joint_has(u, JOINT_LOCKED(JOINT_ANGLE)));
}

// Executes a pass. held: result of joint_ready; if null, its parts are computed just before use, with fewer registers.
INLINE void joint_pass(const Pools* p, int pass, int i, const JointReady* held, Joint* u, Body* a, Body* b)
{
	if (pass == PASS_BOUNCE)
		return;
	JointReady ready;
	if (held)
		ready = *held;
	else
		joint_posed(p, i, a, b, u, &ready.c);
	JointPose c = ready.c;
	c.a = *a;
	c.b = *b;
	if (pass == PASS_WARM_START)
		joint_warm(p, i, u, &c);
	else
	{
		if (pass == PASS_BIAS)
			joint_give(u, &c, held ? ready.turned : joint_turn_impulse(p, i, u, &c));
		joint_drive_all(p, i, pass == PASS_BIAS, u, &c);
		if (!held)
			joint_ready_locks(p, pass, i, u, &c, &ready);
		joint_locks(p, pass, i, &ready, u, &c);
		if (pass == PASS_BIAS && c.rails)
			joint_keep_along(p, u, &c);
		if (pass == PASS_RELAX && p->step.has_drives)
			joint_peak(p, i, u, &c);
	}
	coupling_store(p, i, &c);
	*a = c.a;
	*b = c.b;
}

#endif
