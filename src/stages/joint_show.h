// SPDX-License-Identifier: MIT
// joint_show.h -- the coordinates and forces of joints at the current poses, for the user. No step reads them.
#ifndef JOINT_SHOW_H
#define JOINT_SHOW_H
#include "constraints/joint_one.h"
#include "constraints/kinds.h"

// The place of a joint; -1 for one that has not been in a step, though its slot has a place from an older one.
INLINE int joint_show_place(const Pools* p, int i)
{
	return p->joint_flags[i] & JOINT_RESTARTS ? -1 : p->joint_place[i];
}

// The impulses of the last substep along the axes, N s; 0 without a constraint.
INLINE void joint_show_force(const Pools* p, int i, int modes, Vec axis, GLOBAL JointState* state)
{
	int place = joint_show_place(p, i);
	if (place < 0)
		return;
	Joint u;
	float sum[JOINT_COORDINATES], rate = p->step.inv_h;
	joint_load(p, place, PASS_RELAX, &u);

	// forms that hold joints in registers leave the rows of the step as they are
	u.modes = (float)modes;
	joint_sums(p, place, &u, sum);
	if (joint_upright(&u))
		axis = vec(1.0f, 0.0f);
	state->force_x = rate * (sum[0] * axis.x - sum[1] * axis.y);
	state->force_y = rate * (sum[0] * axis.y + sum[1] * axis.x);
	state->torque = rate * sum[2];
}

STAGE(joint_show)
{
	GLOBAL JointState* state = p->joint_state + i;
	int ia = p->joint_data[i].body_a, ib = p->joint_data[i].body_b, modes = (int)p->joint_data[i].modes;
	JointFrame a = joint_frame(p, i, JOINT_AT_FRAME_A, ia, vec(0.0f, 0.0f));
	JointFrame b = joint_frame(p, i, JOINT_AT_FRAME_B, ib, vec(0.0f, 0.0f));
	Vec d = joint_gap(&a, &b), axis = joint_line(a.turn, d, (modes & JOINT_RADIAL) != 0);
	Vec across = vec(-axis.y, axis.x);
	BodyState va = p->body[ia], vb = p->body[ib];
	Vec at_a = vec_add(vec(va.vx, va.vy), vec_spin(va.w, vec_add(a.arm, d)));
	Vec at_b = vec_add(vec(vb.vx, vb.vy), vec_spin(vb.w, b.arm)), apart = vec_sub(at_b, at_a);

	// over all turns, where the last step left them
	int place = joint_show_place(p, i);
	state->value[0] = vec_dot(d, axis);
	state->value[1] = vec_dot(d, across);
	state->value[2] = joint_turned(&a, &b, place < 0 ? 0.0f : joint_row(p, turned, place));

	// a velocity that the user's calls made infinite may be no number along an axis
	state->speed[0] = number_of(vec_dot(apart, axis));
	state->speed[1] = number_of(vec_dot(apart, across));
	state->speed[2] = number_of(vb.w - va.w);
	state->force_x = 0.0f;
	state->force_y = 0.0f;
	state->torque = 0.0f;
	state->broken = (p->joint_flags[i] & JOINT_BROKEN) != 0;
	joint_show_force(p, i, modes, axis, state);
}

#endif
