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

// an inert constraint between the ground and itself
INLINE void prepare_padding(const Pools* p, int i)
{
	p->constraint_a[i] = 0;
	p->constraint_b[i] = 0;
	p->separation1[i] = NO_POINT;
	p->separation2[i] = NO_POINT;
	p->normal_impulse1[i] = 0.0f;
	p->normal_impulse2[i] = 0.0f;
	p->tangent_impulse1[i] = 0.0f;
	p->tangent_impulse2[i] = 0.0f;
	if (!p->step.extras)
		return;
	p->restitution[i] = 0.0f;
	p->rolling[i] = 0.0f;
	p->tangent_speed[i] = 0.0f;
	p->rolling_impulse[i] = 0.0f;
}

// the contact's points and impulses, where the passes stream them
STAGE(prepare)
{
	int slot = p->constraint_contact[i];
	if (slot < 0)
	{
		prepare_padding(p, i);
		return;
	}
	Int2 pair = p->pair[slot], bodies = p->contact_bodies[slot];
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	Float4 normal = p->contact_normal[slot], impulse = p->contact_impulse[slot], surface = p->contact_surface[slot];
	ContactPoints points = contact_points(a, b, normal, p->contact_on_a[slot], p->contact_on_b[slot]);

	// anchors are from the centers of mass
	Vec center_a = vec(a.center_x, a.center_y), center_b = vec(b.x - a.x + b.center_x, b.y - a.y + b.center_y);
	Vec offset = vec_sub(center_a, center_b);
	Vec ra1 = vec_sub(points.point[0], center_a), ra2 = vec_sub(points.point[1], center_a);
	float separation2 = (p->contact_flags[slot] & CONTACT_COUNT) == 2u ? points.separation[1] : NO_POINT;
	prepare_depth(p, points.separation[0]);
	prepare_depth(p, separation2);

	p->constraint_a[i] = bodies.x;
	p->constraint_b[i] = bodies.y;
	p->normal_x[i] = points.normal.x;
	p->normal_y[i] = points.normal.y;
	p->friction[i] = surface.x;
	p->offset_x[i] = offset.x;
	p->offset_y[i] = offset.y;
	p->anchor1_x[i] = ra1.x;
	p->anchor1_y[i] = ra1.y;
	p->anchor2_x[i] = ra2.x;
	p->anchor2_y[i] = ra2.y;
	p->separation1[i] = points.separation[0];
	p->separation2[i] = separation2;
	p->normal_impulse1[i] = impulse.x;
	p->normal_impulse2[i] = impulse.y;
	p->tangent_impulse1[i] = impulse.z;
	p->tangent_impulse2[i] = impulse.w;
	if (!p->step.extras)
		return;

	Body body_a = body_gather(p, bodies.x), body_b = body_gather(p, bodies.y);
	p->restitution[i] = surface.y;
	p->rolling[i] = surface.z;
	p->tangent_speed[i] = surface.w;
	p->rolling_impulse[i] = p->contact_rolling_impulse[slot];
	p->approach1[i] = prepare_approach(body_a, ra1, body_b, vec_add(ra1, offset), points.normal);
	p->approach2[i] = prepare_approach(body_a, ra2, body_b, vec_add(ra2, offset), points.normal);
	p->peak_impulse1[i] = 0.0f;
	p->peak_impulse2[i] = 0.0f;
}

// an impulse fit to start the next step with: of a body that went out of bounds nothing must remain
INLINE float store_bounded(float x) { return x >= -1.0e30f && x <= 1.0e30f ? x : 0.0f; }

// the impulses back to the contact, for the next step's warm start and for the user
STAGE(store)
{
	int slot = p->constraint_contact[i];
	if (slot < 0)
		return;
	p->contact_impulse[slot] =
	    make_float4(store_bounded(p->normal_impulse1[i]), store_bounded(p->normal_impulse2[i]),
	                store_bounded(p->tangent_impulse1[i]), store_bounded(p->tangent_impulse2[i]));
	if (p->step.extras)
		p->contact_rolling_impulse[slot] = store_bounded(p->rolling_impulse[i]);
}

#endif
