// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"

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

// the contact's manifold and impulses, where the passes stream them
STAGE(prepare)
{
	int slot = p->constraint_contact[i];
	Int2 bodies = make_int2(0, 0);
	Float4 normal = make_float4(0.0f, 0.0f, NO_POINT, NO_POINT);
	Float4 anchor = make_float4(0.0f, 0.0f, 0.0f, 0.0f), impulse = anchor, surface = anchor;
	float rolling_impulse = 0.0f;
	if (slot >= 0)
	{
		bodies = p->contact_bodies[slot];
		normal = p->contact_normal[slot];
		anchor = p->contact_anchor[slot];
		impulse = p->contact_impulse[slot];
		surface = p->contact_surface[slot];
		rolling_impulse = p->contact_rolling_impulse[slot];
	}
	Float4 pose_a = p->pose[bodies.x], pose_b = p->pose[bodies.y];
	Vec offset = vec(pose_a.x - pose_b.x, pose_a.y - pose_b.y);

	p->constraint_a[i] = bodies.x;
	p->constraint_b[i] = bodies.y;
	p->normal_x[i] = normal.x;
	p->normal_y[i] = normal.y;
	p->friction[i] = surface.x;
	p->offset_x[i] = offset.x;
	p->offset_y[i] = offset.y;
	p->anchor1_x[i] = anchor.x;
	p->anchor1_y[i] = anchor.y;
	p->anchor2_x[i] = anchor.z;
	p->anchor2_y[i] = anchor.w;
	p->separation1[i] = normal.z;
	p->separation2[i] = normal.w;
	p->normal_impulse1[i] = impulse.x;
	p->normal_impulse2[i] = impulse.y;
	p->tangent_impulse1[i] = impulse.z;
	p->tangent_impulse2[i] = impulse.w;
	if (!p->step.extras)
		return;

	Body a = body_gather(p, bodies.x), b = body_gather(p, bodies.y);
	Vec n = vec(normal.x, normal.y), ra1 = vec(anchor.x, anchor.y), ra2 = vec(anchor.z, anchor.w);
	p->restitution[i] = surface.y;
	p->rolling[i] = surface.z;
	p->tangent_speed[i] = surface.w;
	p->rolling_impulse[i] = rolling_impulse;
	p->approach1[i] = prepare_approach(a, ra1, b, vec_add(ra1, offset), n);
	p->approach2[i] = prepare_approach(a, ra2, b, vec_add(ra2, offset), n);
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
	p->contact_impulse[slot] = make_float4(store_bounded(p->normal_impulse1[i]), store_bounded(p->normal_impulse2[i]),
		store_bounded(p->tangent_impulse1[i]), store_bounded(p->tangent_impulse2[i]));
	if (p->step.extras)
		p->contact_rolling_impulse[slot] = store_bounded(p->rolling_impulse[i]);
}

#endif
