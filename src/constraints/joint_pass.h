// SPDX-License-Identifier: MIT
// joint_pass.h -- a pass over a joint: its locks, solved together, and what every kind of constraint has.
#ifndef JOINT_PASS_H
#define JOINT_PASS_H
#include "constraints/contact.h"
#include "constraints/coupling.h"
#include "constraints/joint_drive.h"
#include "constraints/path.h"

// share of a coordinate's own yield that remains, at least, when others are held: below it is rounding
#define JOINT_LEAST_YIELD 1.0e-6f

// m/s, rad/s: errors are corrected at most so fast in a chain. Frames that are far apart, because a body was
// teleported or a contact held it back, come together without a blow. Other joints correct distances at up to START_SHARE of
// max_speed: in the corner of a large net, which holds it all, a joint must follow its error.
#define JOINT_CORRECTION 10.0f

// By what factor the bound of the impulses with which a joint starts a step may grow from step to step.
#define JOINT_CARRIES 1.5f

// Times START_SHARE: the least that this bound is, all of max_speed and max_spin. The limbs of a ragdoll that lands are held by impulses
// that are balanced, but would each alone spin a hand by more than a fifth; with less of them a joint opens again after the blow.
#define JOINT_BLOW 5.0f

typedef struct // of the locks: yield x = goal
{
	Real yield[3], cross[3];     // diagonal; 01, 02, 12
	Real soft[3], soft_cross[3]; // their softness, which is a part of yield and cross
	Real goal[3];
	Int locked[3];
} JointSystem;

// How much softer a lock becomes that yields by own. One as soft as nothing must not overflow, and so spoil the others.
#define JOINT_NOTHING 1.0e12f

INLINE Real joint_softer(Real softness, Real own)
{
	Real softer = softness * own;
	return choose(softer, splat(JOINT_NOTHING) * own, softer > splat(1.0e30f));
}

// By which share of itself the yield between two coordinates grows. Rigid locks are soft together, whatever their axes: each by
// itself, two that pull at a long arm aslant of both axes would give way along the arm by the yield of the lever.
INLINE Real joint_soft_pair(const Joint* u, const Real softness[3], int i, int j)
{
	return choose(minimum(softness[i], softness[j]), splat(0.0f), joint_has(u, JOINT_SOFT(i) | JOINT_SOFT(j)));
}

// How soft locks are. In the relaxing pass those are rigid that are no springs; springs damp (joint_spring.h).
INLINE void joint_softnesses(const Pools* p, int i, int soft, const Joint* u, Real softness[3])
{
	Real zero = splat(0.0f);
	softness[0] = soft ? u->soft_along : zero;
	softness[1] = soft ? u->soft_across : zero;
	softness[2] = soft ? u->soft_angle : zero;
	if (soft || !p->step.springs || !lane_bits(joint_has(u, JOINT_SOFT(0) | JOINT_SOFT(1) | JOINT_SOFT(2))))
		return;
	softness[0] = choose(zero, load(&joint_rare(p, along_spring_relaxes, i), 0), joint_has(u, JOINT_SOFT(0)));
	softness[1] = choose(zero, load(&joint_rare(p, across_spring_relaxes, i), 0), joint_has(u, JOINT_SOFT(1)));
	softness[2] = choose(zero, load(&joint_rare(p, angle_spring_relaxes, i), 0), joint_has(u, JOINT_SOFT(2)));
}

// Rigid locks beside springs. The springs' pull on the locks is known, so the locks hold against it as if they did not yield:
// otherwise a spring on an arm would swing more slowly, and be damped by the locks. Only the rest of their impulses is soft:
//
//     K x = -(s + b C) / (1 + g) - g / (1 + g) K P      P: impulses of locks and springs
//
// Only where no other constraint holds the bodies: two such joints of a body would take turns in adding energy.
INLINE void joint_hold_springs(const Pools* p, int i, const Joint* u, const JointPose* c, const Real cross[3],
                               const Real softness[3], const Real speed[3], JointSystem* s)
{
	Real zero = splat(0.0f), one = splat(1.0f), pull[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	Real own[3], other[3];
	Int rigid[3], springs = load(&joint_rare(p, springs_alone, i), 0) > zero;
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		own[k] = joint_yield(c, k);
		rigid[k] = springs & s->locked[k] & (joint_has(u, JOINT_SOFT(k)) == 0);
		if (!joint_drives(p, u, k))
			continue;
		JointDrive d = joint_drive_load(p, i, k);
		pull[k] = choose(pull[k], joint_spring_left(&d), joint_has(u, JOINT_SPRING(k)));
	}
	other[0] = cross[0] * pull[1] + cross[1] * pull[2];
	other[1] = cross[0] * pull[0] + cross[2] * pull[2];
	other[2] = cross[1] * pull[0] + cross[2] * pull[1];
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Real answer = one / (one + softness[k]), kept = softness[k] * answer;
		s->goal[k] = choose(s->goal[k], -(answer * speed[k] + kept * (own[k] * pull[k] + other[k])), rigid[k]);
		s->yield[k] = choose(s->yield[k], own[k], rigid[k]);
	}
	s->cross[0] = choose(s->cross[0], choose(zero, cross[0], s->locked[0] & s->locked[1]), rigid[0] | rigid[1]);
	s->cross[1] = choose(s->cross[1], choose(zero, cross[1], s->locked[0] & s->locked[2]), rigid[0] | rigid[2]);
	s->cross[2] = choose(s->cross[2], choose(zero, cross[2], s->locked[1] & s->locked[2]), rigid[1] | rigid[2]);
}

// The equations of the locks. A coordinate that is not locked has a row of the identity. Only rigid locks correct errors at a
// bounded speed: a spring pulls as it should. chained: other joints are solved together with this one.
INLINE JointSystem joint_system(const Pools* p, int i, int soft, int chained, float fastest, const Joint* u,
                                const JointPose* c)
{
	JointSystem s;
	Real zero = splat(0.0f), one = splat(1.0f), cross[3], softness[3], speed[3], softer[3];
	Real most[3] = {splat(fastest), splat(fastest), splat(chained ? JOINT_CORRECTION : JOINT_TURNING)};
	Real impulse[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	Real rate[3] = {u->rate_along, u->rate_across, u->rate_angle};
	Real error[3] = {c->value[0] - u->length, c->value[1], c->value[2]};
	joint_softnesses(p, i, soft, u, softness);
	for (int k = 0; k < JOINT_COORDINATES; ++k)
	{
		Real own = joint_yield(c, k), back = rate[k] * error[k];
		s.locked[k] = joint_has(u, JOINT_LOCKED(k)) & (own > zero);
		softness[k] = choose(zero, softness[k], s.locked[k]);
		softer[k] = joint_softer(softness[k], own);
		speed[k] = joint_speed(c, k);
		if (soft)
			speed[k] = speed[k] + choose(within(back, most[k]), back, joint_has(u, JOINT_SOFT(k)));
		s.yield[k] = choose(one, own + softer[k], s.locked[k]);
		s.soft[k] = softer[k];
	}
	joint_crosses(c, cross);
	Real softer01 = joint_soft_pair(u, softness, 0, 1) * cross[0],
	     softer02 = joint_soft_pair(u, softness, 0, 2) * cross[1],
	     softer12 = joint_soft_pair(u, softness, 1, 2) * cross[2];
	Real back[3] = {softer[0] * impulse[0] + softer01 * impulse[1] + softer02 * impulse[2],
	                softer01 * impulse[0] + softer[1] * impulse[1] + softer12 * impulse[2],
	                softer02 * impulse[0] + softer12 * impulse[1] + softer[2] * impulse[2]};
	for (int k = 0; k < JOINT_COORDINATES; ++k)
		s.goal[k] = choose(zero, -(soft ? speed[k] + back[k] : speed[k]), s.locked[k]);
	s.soft_cross[0] = choose(zero, softer01, s.locked[0] & s.locked[1]);
	s.soft_cross[1] = choose(zero, softer02, s.locked[0] & s.locked[2]);
	s.soft_cross[2] = choose(zero, softer12, s.locked[1] & s.locked[2]);
	s.cross[0] = choose(zero, cross[0] + softer01, s.locked[0] & s.locked[1]);
	s.cross[1] = choose(zero, cross[1] + softer02, s.locked[0] & s.locked[2]);
	s.cross[2] = choose(zero, cross[2] + softer12, s.locked[1] & s.locked[2]);
	if (soft && !chained && p->step.springs && lane_bits(joint_has(u, JOINT_SPRINGS)))
		joint_hold_springs(p, i, u, c, cross, softness, speed, &s);
	return s;
}

// Solves the equations, by L D L^T. mass: in exact arithmetic two translations yield no less than the masses alone.
INLINE void joint_solve(const JointSystem* s, Real mass, Real x[3])
{
	Real one = splat(1.0f), l01 = s->cross[0] / s->yield[0], l02 = s->cross[1] / s->yield[0];
	Real d1 = choose(one, maximum(s->yield[1] - l01 * s->cross[0], mass), s->locked[1]);
	Real rest = s->cross[2] - l01 * s->cross[1], l12 = rest / d1;
	Real d2 = maximum((s->yield[2] - l02 * s->cross[1]) - l12 * rest, splat(JOINT_LEAST_YIELD) * s->yield[2]);
	Real y1 = s->goal[1] - l01 * s->goal[0], y2 = (s->goal[2] - l02 * s->goal[0]) - l12 * y1;
	x[2] = y2 / d2;
	x[1] = y1 / d1 - l12 * x[2];
	x[0] = (s->goal[0] / s->yield[0] - l01 * x[1]) - l02 * x[2];
}

// Adds a solution to the impulses of the locks. What is not locked has none; turns: where the angle has one.
INLINE void joint_hold(Joint* u, JointPose* c, const Real x[3], Int turns)
{
	Real zero = splat(0.0f), old[3] = {u->impulse_along, u->impulse_across, u->impulse_angle};
	u->impulse_along = choose(zero, hold_of(old[0] + x[0]), joint_has(u, JOINT_LOCKED(0)));
	u->impulse_across = choose(zero, hold_of(old[1] + x[1]), joint_has(u, JOINT_LOCKED(1)));
	u->impulse_angle = choose(zero, hold_of(old[2] + x[2]), turns);
	joint_give(u, c,
	           joint_impulse(c, u->impulse_along - old[0], u->impulse_across - old[1], u->impulse_angle - old[2]));
}

typedef struct // kg m^2: what the pull of a joint adds to the inertia of its bodies in an implicit integration
{
	Real a, b;
} JointPull;

// Only of joints that hold both translations as rigid ones.
INLINE JointPull joint_pull(const Pools* p, const Joint* u, const JointPose* c, Vec push)
{
	Real zero = splat(0.0f);
	Int holds = joint_upright(u);
	JointPull pull;
	pull.a = choose(zero, -p->step.h * vec_dot(c->arm_a, push), holds);
	pull.b = choose(zero, p->step.h * vec_dot(c->arm_b, push), holds);
	return pull;
}

// From this share of its own inertia on, the pull of one joint lets the sums be computed (taut.h). A body has few joints.
#define JOINT_TAUT 0.25f

INLINE void joint_tautens(const Pools* p, const Joint* u, const JointPose* c, Vec push)
{
	JointPull pull = joint_pull(p, u, c, push);
	Real most = maximum(pull.a * c->a.inv_inertia, pull.b * c->b.inv_inertia);
	if (lane_bits(most > splat(JOINT_TAUT)))
		raise_int(&p->counters->taut, 1);
}

// Starts the step with the impulses of the last one, unless these alone would make the bodies faster than a share of max_speed: a
// blow is not given again. But what a joint has carried for some steps is a load, which the other joints of its bodies hold too: the
// corner of a net carries the weight of all its knots.
INLINE void joint_warm(const Pools* p, int i, Joint* u, JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	if (p->step.h_ratio != 1.0f) // the same forces
		joint_scale(p, i, u, splat(p->step.h_ratio));
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	joint_tautens(p, u, c, j.push);
	Real most = splat(START_SHARE * p->step.max_speed), spin = splat(START_SHARE * p->step.max_spin);
	Real faster = c->mass * (absolute(j.push.x) + absolute(j.push.y));
	if (c->couples)
		faster = choose(faster,
		                c->a.inv_mass * (absolute(j.push_a.x) + absolute(j.push_a.y)) +
		                    c->b.inv_mass * (absolute(j.push.x) + absolute(j.push.y)),
		                c->coupled);
	Real spins = absolute(c->a.inv_inertia * j.angular_a) + absolute(c->b.inv_inertia * j.angular_b);
	Real shares = maximum(faster / most, spins / spin);
	Real allowed = maximum(splat(JOINT_BLOW), splat(JOINT_CARRIES) * u->carried);
	Int sound = (faster <= splat(MOST_FLOAT)) & (spins <= splat(MOST_FLOAT));
	Real part = choose(splat(0.0f), choose(splat(1.0f), allowed / shares, shares > allowed), sound);
	u->carried = choose(splat(0.0f), minimum(shares, allowed), sound);
	if (lane_bits(part < splat(1.0f)))
	{
		joint_scale(p, i, u, part);
		j.push = vec_choose(vec(splat(0.0f), splat(0.0f)), vec_scale(part, j.push), part > splat(0.0f));
		j.push_a = vec_choose(vec(splat(0.0f), splat(0.0f)), vec_scale(part, j.push_a), part > splat(0.0f));
		j.angular_a = choose(splat(0.0f), part * j.angular_a, part > splat(0.0f));
		j.angular_b = choose(splat(0.0f), part * j.angular_b, part > splat(0.0f));
	}
	joint_give(u, c, j);
}

// Gives the bodies what the arms' turn since the last substep changed of the impulses' worth.
INLINE void joint_turn(const Pools* p, int i, Joint* u, JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	// the axes of the last pass may have been others
	if (p->step.springs)
	{
		Vec given = vec(u->given_x, u->given_y);
		u->impulse_along = choose(u->impulse_along, vec_dot(given, c->axis[0]), c->torn);
		u->impulse_across = choose(u->impulse_across, vec_dot(given, c->axis[1]), c->torn);
	}
	joint_sums(p, i, u, sum);
	JointImpulse j = joint_impulse(c, sum[0], sum[1], sum[2]);
	j.push = vec_sub(j.push, vec(u->given_x, u->given_y));
	j.push_a = c->couples ? vec_choose(j.push, vec_sub(j.push_a, c->given_a), c->coupled) : j.push;
	j.angular_a = j.angular_a - u->given_a;
	j.angular_b = j.angular_b - u->given_b;
	joint_give(u, c, j);
}

// The largest force and torque of all substeps, for thresholds and the user.
INLINE void joint_peak(const Pools* p, int i, const Joint* u, const JointPose* c)
{
	Real sum[JOINT_COORDINATES];
	joint_sums(p, i, u, sum);
	if (c->rails)
		sum[0] = choose(sum[0], sum[0] - c->bend * sum[2], c->railed);
	Real force = root(sum[0] * sum[0] + sum[1] * sum[1]), torque = absolute(sum[2]);
	if (p->step.couplings)
	{
		Int turns = coupling_turns(u);
		torque = choose(torque, absolute(sum[0]), turns);
		force = choose(force, splat(0.0f), turns);
	}
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

// m/s: a correction across a path up to so many times what the path's bend needs in a substep is none of a body placed elsewhere
#define JOINT_BENDS 8.0f

// A bead that is pulled back to its path from afar turns around the path's center, and would get faster as its circle shrinks. Where
// it is pulled faster than by a bend, its speed along stays: the axis along turns by bend h along in the substep, and takes with it
// so much of the speed across. The impulse is given once, and not as a part of those that are warm started.
INLINE void joint_keep_along(const Pools* p, Joint* u, JointPose* c)
{
	Real zero = splat(0.0f), along = joint_speed_linear(c, JOINT_ALONG), across = joint_speed_linear(c, JOINT_ACROSS);
	Real turn = p->step.h * c->bend * along, yield = joint_yield_linear(c, JOINT_ALONG);
	Int pulled = c->railed & joint_has(u, JOINT_LOCKED(JOINT_ACROSS)) & (yield > zero) &
	             (absolute(across) > splat(JOINT_BENDS) * absolute(turn * along)) & (absolute(turn) < splat(1.0f));
	Real impulse = hold_of(-(turn * across) / choose(splat(1.0f), yield, pulled));
	joint_give_where(u, c, joint_impulse(c, choose(zero, impulse, pulled), zero, zero), pulled);
}

INLINE void joint_pass(const Pools* p, int pass, int i, int held, Joint* u, Body* a, Body* b)
{
	(void)held;
	if (pass == PASS_BOUNCE)
		return;
	JointPose c;
	c.a = *a;
	c.b = *b;
	joint_pose(p, i, u, &c);
	coupling_pose(p, i, u, &c);
	path_pose(p, i, u, &c);
	if (pass == PASS_WARM_START)
		joint_warm(p, i, u, &c);
	else
	{
		if (pass == PASS_BIAS)
			joint_turn(p, i, u, &c);
		joint_drive_all(p, i, pass == PASS_BIAS, u, &c);
		JointSystem system = joint_system(p, i, pass == PASS_BIAS, 0, START_SHARE * p->step.max_speed, u, &c);
		Real x[3];
		joint_solve(&system, c.mass, x);
		joint_hold(u, &c, x, joint_has(u, JOINT_LOCKED(JOINT_ANGLE)));
		if (pass == PASS_BIAS && c.rails)
			joint_keep_along(p, u, &c);
		if (pass == PASS_RELAX && p->step.drives)
			joint_peak(p, i, u, &c);
	}
	coupling_store(p, i, &c);
	*a = c.a;
	*b = c.b;
}

#endif
