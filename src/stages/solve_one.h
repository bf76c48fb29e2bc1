// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"
#include "stages/sweep.h"

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

typedef struct
{
	Vec normal, offset;             // from a to b; m: center of a minus center of b
	Vec anchor1, anchor2;           // m: of the points, from the center of a
	float separation1, separation2; // m
} Prepared;

// what the passes need of the points of a contact
INLINE Prepared prepare_points(const Pools* p, Int2 pair, int slot, float load1, float load2)
{
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	Found found = p->contact_found[slot];
	ContactPoints points;
	if (float_bits(found.then.z) & FOUND_ROLLS)
		points = rolling_step(p, a, b, found, p->contact_feature[slot], load1, load2, sweep_advance(p, a.body),
		                      sweep_advance(p, b.body));
	else
		points = contact_points_held(a, b, found);
	Prepared made;
	made.normal = points.normal;
	made.offset = points.offset;
	made.anchor1 = points.anchor[0];
	made.anchor2 = points.anchor[1];
	made.separation1 = points.separation[0];
	made.separation2 = points.separation[1];
	prepare_depth(p, points.separation[0]);
	prepare_depth(p, points.separation[1]);
	return made;
}

// what bounces starts with the speed at which it came
INLINE void prepare_extras(const Pools* p, int i, Prepared made)
{
	Body a = body_gather(p, constraint_at(p, body_a, i)), b = body_gather(p, constraint_at(p, body_b, i));
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
	Prepared made = prepare_points(p, p->constraint_pair[i], slot, constraint_at(p, normal_impulse1, i),
	                               constraint_at(p, normal_impulse2, i));
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
