// SPDX-License-Identifier: MIT
// joint_report.h -- computes coordinates and forces of joints at the current poses, for the user. No step reads them.
#ifndef JOINT_REPORT_H
#define JOINT_REPORT_H
#include "constraints/joint_asleep.h"
#include "constraints/joint_one.h"

// Returns the place of a joint; -1 before its first step, because its slot may contain the place of a destroyed joint.
INLINE int joint_report_place(const Pools* p, int i)
{
	return p->joint_flags[i] & JOINT_RESTARTS ? -1 : p->joint_place[i];
}

// 1/s: Returns the substeps per second of the last step of joint i's world.
INLINE float joint_rate(const Pools* p, int i)
{
	if (!BATCHED(p))
		return p->step.inv_h;
	float substep = p->bay_state[i >> p->step.bays.joint_bits].substep;
	return substep > 0.0f ? quotient(1.0f, substep) : 0.0f;
}

// Computes force (N) and torque (N m) of a joint from its impulses in the last substep. A joint without a constraint
// keeps force and torque 0, unless its bodies sleep. axis: direction of the first coordinate. off: deviation of the
// first two coordinates from the targets of their locks. bend, 1/m: curvature of a path.
INLINE void joint_report_force(const Pools* p, int i, int modes, Vec axis, Vec off, float bend, JointState* state)
{
	int place = joint_report_place(p, i), asleep = p->joint_flags[i] & JOINT_ASLEEP;
	if (place < 0 && !asleep)
		return;
	Joint u;
	float sum[JOINT_COORDINATES], rate = joint_rate(p, i);
	if (!asleep)
		joint_load(p, place, PASS_RELAX, &u);

	// modes are those of the user's data: forms of the solve that keep joints in registers do not write the row `modes`
	u.modes = (float)modes;
	if (asleep)
		joint_sums_asleep(p, i, modes, sum);
	else
		joint_sums(p, place, &u, sum);
	Body a = body_gather(p, p->joint_data[i].body_a);
	if (joint_upright(&u) || joint_torn(p, &u, &a, off))
		axis = vec(1.0f, 0.0f);
	if (modes & JOINT_RAILED)
		sum[0] = sum[0] - bend * sum[2];
	state->force_x = rate * (sum[0] * axis.x - sum[1] * axis.y);
	state->force_y = rate * (sum[0] * axis.y + sum[1] * axis.x);
	state->torque = rate * (coupling_turns(&u) ? sum[0] : sum[2]);
}

// Computes the speed, m/s or rad/s, of the measure on one side of a coupling. Returns the direction of this measure,
// along which a force acts on the body; (0, 0) for an angle.
INLINE Vec joint_report_side(const Pools* p, int i, int side, const CouplingMeasure* m, float* speed)
{
	BodyState now = p->body[side ? p->joint_data[i].body_b : p->joint_data[i].body_a];
	int modes = (int)p->joint_data[i].modes, slides = modes & JOINT_SLIDES(side), hoists = modes & JOINT_HOISTS(side);
	Vec direction = joint_line(slides ? m->line : vec(0.0f, 0.0f), m->line, hoists != 0);
	Vec at = vec_add(vec(now.vx, now.vy), vec_spin(now.w, m->arm));
	*speed = number_of(slides || hoists ? vec_dot(at, direction) : now.w);
	return direction;
}

// Writes the coordinate of a coupling, and the measures of its sides a and b in place of the other two coordinates.
INLINE void joint_report_coupling(const Pools* p, int i, JointState* state)
{
	int modes = (int)p->joint_data[i].modes;
	float ratio = p->joint_data[i].gear_ratio, speeds[2];
	CouplingCount count = coupling_count_last(p, i);
	CouplingState now = coupling_state(p, i, &count);
	joint_report_side(p, i, 0, now.sides, speeds);
	Vec direction = joint_report_side(p, i, 1, now.sides + 1, speeds + 1);
	float far_a = modes & JOINT_HOISTS(0) ? now.sides[0].value : 0.0f;
	float far_b = modes & JOINT_HOISTS(1) ? now.sides[1].value : 0.0f;
	state->value[0] = now.value + (far_b + ratio * far_a);
	state->value[1] = now.sides[0].value;
	state->value[2] = now.sides[1].value;
	state->speed[0] = number_of(speeds[1] + ratio * speeds[0]);
	state->speed[1] = speeds[0];
	state->speed[2] = speeds[1];
	joint_report_force(p, i, modes, direction, vec(0.0f, 0.0f), 0.0f, state);
}

// Computes frame A of a joint on a path, at the nearest point of the path. Returns that point.
INLINE PathFoot joint_report_foot(const Pools* p, int i, JointFrame* a)
{
	PathCount count = path_count_last(p, i);
	PathFoot foot = path_follow(p, i, &count);
	*a = joint_frame(p, i, JOINT_AT_FRAME(0), p->joint_data[i].body_a, foot.point);
	a->turn = vec_turn(a->turn, foot.tangent);
	return foot;
}

// Computes the state of joint i. forces: 0 to leave force and torque at 0.
INLINE JointState joint_state_now(const Pools* p, int i, int forces)
{
	JointState now, *state = &now;
	int ia = p->joint_data[i].body_a, ib = p->joint_data[i].body_b, modes = (int)p->joint_data[i].modes;
	JointFrame a = joint_frame(p, i, JOINT_AT_FRAME(0), ia, vec(0.0f, 0.0f));
	JointFrame b = joint_frame(p, i, JOINT_AT_FRAME(1), ib, vec(0.0f, 0.0f));
	float along = 0.0f, bend = 0.0f;
	if (modes & JOINT_RAILED)
	{
		PathFoot foot = joint_report_foot(p, i, &a);
		along = foot.along;
		bend = foot.bend;
	}
	Vec d = joint_gap(&a, &b), axis = joint_line(a.turn, d, (modes & JOINT_RADIAL) != 0);
	Vec across = vec(-axis.y, axis.x);
	BodyState va = p->body[ia], vb = p->body[ib];
	Vec at_a = vec_add(vec(va.vx, va.vy), vec_spin(va.w, vec_add(a.arm, d)));
	Vec at_b = vec_add(vec(vb.vx, vb.vy), vec_spin(vb.w, b.arm)), apart = vec_sub(at_b, at_a);

	// the angle includes all turns: it continues the count of the last step
	state->value[0] = along + vec_dot(d, axis);
	state->value[1] = vec_dot(d, across);
	state->value[2] = joint_turned(&a, &b, joint_turned_last(p, i));

	// speeds of the coordinates; 0 in place of NaN, which appears if the user's calls have made a velocity infinite
	state->speed[0] = number_of(vec_dot(apart, axis));
	state->speed[1] = number_of(vec_dot(apart, across));
	state->speed[2] = number_of(modes & JOINT_RAILED ? vb.w - va.w - bend * vec_dot(apart, axis) : vb.w - va.w);
	state->force_x = 0.0f;
	state->force_y = 0.0f;
	state->torque = 0.0f;
	state->broken = (p->joint_flags[i] & JOINT_BROKEN) != 0;
	state->unused[0] = state->unused[1] = 0.0f;
	if (modes & JOINT_COUPLED)
		joint_report_coupling(p, i, state);
	else if (forces)
	{
		const GLOBAL JointLock* lock = p->joint_data[i].lock;
		Vec off = vec(state->value[0] - lock[0].target, state->value[1] - lock[1].target);
		joint_report_force(p, i, modes, axis, off, bend, state);
	}
	for (int k = 0; k < 3; ++k)
	{
		state->value[k] = flush_tiny(state->value[k]);
		state->speed[k] = flush_tiny(state->speed[k]);
	}
	state->force_x = flush_tiny(state->force_x);
	state->force_y = flush_tiny(state->force_y);
	state->torque = flush_tiny(state->torque);
	return now;
}

KERNEL(joint_report)
{
	if (joint_in_use(p, i)) // the data of a free slot may name anything
		p->joint_state[i] = joint_state_now(p, i, 1);
}

#endif
