// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"
#include "stages/contact_points.h"
#include "stages/finite.h"

STAGE(solve_begin)
{
	GLOBAL BodyState* body = p->body + i;
	p->base[i] = make_float4(body->vx, body->vy, body->w, 0.0f);
	body->dx = 0.0f;
	body->dy = 0.0f;
	body->da = 0.0f;

	// the host has read what the last step's finalize counted
	if (i == 0)
	{
		p->counters->nonfinite = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
}

// A body as it comes to the step, within the limits.
INLINE Body prepare_body(const Pools* p, int index)
{
	Body b = body_gather(p, index);
	float spin = p->step.max_spin;
	b.v = vec_scale(vec_shrink(b.v, p->step.max_speed), b.v);
	b.w = within(b.w, spin);
	return b;
}

// normal velocity of a point before the step
INLINE float prepare_approach(Body a, Vec ra, Body b, Vec rb, Vec n)
{
	return vec_dot(vec_sub(body_velocity_at(b, rb), body_velocity_at(a, ra)), n);
}

// the deepest overlap seen, for the user's counters
INLINE void prepare_depth(const Pools* p, float separation)
{
	int depth = float_bits(-separation);
	if (separation < 0.0f && depth > read_shared(&p->counters->penetration))
		atomic_max_int(&p->counters->penetration, depth);
}

typedef struct
{
	Vec normal, offset;             // from a to b; m: center of a minus center of b
	Vec anchor1, anchor2;           // m: of the points, from the center of a
	float separation1, separation2; // m
} Prepared;

// what the passes need of the points of a contact
INLINE Prepared prepare_points(const Pools* p, Int2 pair, int slot)
{
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	ContactPoints points = contact_points(a, b, p->contact_found[slot]);

	// anchors are from the centers of mass
	Vec center_a = vec(a.center_x, a.center_y), center_b = vec(b.x - a.x + b.center_x, b.y - a.y + b.center_y);
	Vec from_a = vec_add(center_a, vec_scale(0.5f, points.apart));
	Prepared made;
	made.normal = points.normal;
	made.offset = vec_add(vec_sub(center_a, center_b), points.apart);
	made.anchor1 = vec_sub(points.point[0], from_a);
	made.anchor2 = vec_sub(points.point[1], from_a);
	made.separation1 = points.separation[0];
	made.separation2 = points.separation[1];
	prepare_depth(p, points.separation[0]);
	prepare_depth(p, points.separation[1]);
	return made;
}

// what bounces starts with the speed at which it came
INLINE void prepare_extras(const Pools* p, int i, Prepared made)
{
	Body a = prepare_body(p, constraint_at(p, body_a, i)), b = prepare_body(p, constraint_at(p, body_b, i));
	Vec ra1 = made.anchor1, ra2 = made.anchor2;
	extra_at(p, approach1, i) = prepare_approach(a, ra1, b, vec_add(ra1, made.offset), made.normal);
	extra_at(p, approach2, i) = prepare_approach(a, ra2, b, vec_add(ra2, made.offset), made.normal);
	extra_at(p, peak_impulse1, i) = 0.0f;
	extra_at(p, peak_impulse2, i) = 0.0f;
}

// the contact's points, where the passes stream them
STAGE(prepare)
{
	int slot = p->constraint_contact[i];
	if (slot < 0)
		return;
	Prepared made = prepare_points(p, p->constraint_pair[i], slot);
	constraint_at(p, normal_x, i) = made.normal.x;
	constraint_at(p, normal_y, i) = made.normal.y;
	constraint_at(p, offset_x, i) = made.offset.x;
	constraint_at(p, offset_y, i) = made.offset.y;
	constraint_at(p, anchor1_x, i) = made.anchor1.x;
	constraint_at(p, anchor1_y, i) = made.anchor1.y;
	constraint_at(p, anchor2_x, i) = made.anchor2.x;
	constraint_at(p, anchor2_y, i) = made.anchor2.y;
	constraint_at(p, separation1, i) = made.separation1;
	constraint_at(p, separation2, i) = made.separation2;
	if (p->step.extras)
		prepare_extras(p, i, made);
}

#endif
