// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"
#include "stages/contact_points.h"

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

// the contact's points, where the passes stream them
STAGE(prepare)
{
	int slot = p->constraint_contact[i];
	if (slot < 0)
		return;
	Int2 pair = p->constraint_pair[i];
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	ContactPoints points = contact_points(a, b, p->contact_found[slot]);

	// anchors are from the centers of mass
	Vec center_a = vec(a.center_x, a.center_y), center_b = vec(b.x - a.x + b.center_x, b.y - a.y + b.center_y);
	Vec offset = vec_add(vec_sub(center_a, center_b), points.apart);
	Vec from_a = vec_add(center_a, vec_scale(0.5f, points.apart));
	Vec ra1 = vec_sub(points.point[0], from_a), ra2 = vec_sub(points.point[1], from_a);
	prepare_depth(p, points.separation[0]);
	prepare_depth(p, points.separation[1]);
	constraint_at(p, normal_x, i) = points.normal.x;
	constraint_at(p, normal_y, i) = points.normal.y;
	constraint_at(p, offset_x, i) = offset.x;
	constraint_at(p, offset_y, i) = offset.y;
	constraint_at(p, anchor1_x, i) = ra1.x;
	constraint_at(p, anchor1_y, i) = ra1.y;
	constraint_at(p, anchor2_x, i) = ra2.x;
	constraint_at(p, anchor2_y, i) = ra2.y;
	constraint_at(p, separation1, i) = points.separation[0];
	constraint_at(p, separation2, i) = points.separation[1];
	if (!p->step.extras)
		return;

	Body body_a = body_gather(p, constraint_at(p, body_a, i)), body_b = body_gather(p, constraint_at(p, body_b, i));
	extra_at(p, approach1, i) = prepare_approach(body_a, ra1, body_b, vec_add(ra1, offset), points.normal);
	extra_at(p, approach2, i) = prepare_approach(body_a, ra2, body_b, vec_add(ra2, offset), points.normal);
	extra_at(p, peak_impulse1, i) = 0.0f;
	extra_at(p, peak_impulse2, i) = 0.0f;
}

// an impulse fit to start the step with
INLINE float cleanse_bounded(float x) { return x >= -1.0e30f && x <= 1.0e30f ? x : 0.0f; }

// of a body that went out of bounds in the last step nothing must remain in its neighbors' constraints
STAGE(cleanse)
{
	constraint_at(p, normal_impulse1, i) = cleanse_bounded(constraint_at(p, normal_impulse1, i));
	constraint_at(p, normal_impulse2, i) = cleanse_bounded(constraint_at(p, normal_impulse2, i));
	constraint_at(p, tangent_impulse1, i) = cleanse_bounded(constraint_at(p, tangent_impulse1, i));
	constraint_at(p, tangent_impulse2, i) = cleanse_bounded(constraint_at(p, tangent_impulse2, i));
	extra_at(p, rolling_impulse, i) = cleanse_bounded(extra_at(p, rolling_impulse, i));
}

#endif
