// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"
#include "stages/finite.h"
#include "stages/prepare.h"
#include "stages/rolling.h"
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
		p->counters->held = 0;
		p->counters->first_nonfinite = 0x7fffffff;
	}
}

// A body as it comes to the step, within the limits.
INLINE Body prepare_body(const Pools* p, int index)
{
	Body b = body_gather(p, index);
	b.v = vec_scale(vec_shrink(b.v, p->step.max_speed), b.v);
	b.w = within(b.w, p->step.max_spin);
	return b;
}

typedef struct
{
	Vec normal, offset;             // from a to b; m: center of a minus center of b
	Vec anchor1, anchor2;           // m: of the points, from the center of a
	float separation1, separation2; // m
} Prepared;

INLINE ContactPoints prepare_rolling(const Pools* p, int i, int slot, Word flags)
{
	Int2 pair = p->constraint_pair[i];
	Placed a = p->placed[pair.x], b = p->placed[pair.y];
	return rolling_step(p, a, b, p->contact_found[slot], flags, p->contact_feature[slot],
	                    constraint_at(p, normal_impulse1, i), constraint_at(p, normal_impulse2, i),
	                    sweep_advance(p, a.body), sweep_advance(p, b.body));
}

// what the passes need of the points of constraint i
INLINE Prepared prepare_points(const Pools* p, int i, int slot)
{
	Word flags = p->contact_flags[slot];
	ContactPoints points;
	if (flags & FOUND_ROLLS)
		points = prepare_rolling(p, i, slot, flags);
	else
	{
		Int2 pair = p->constraint_pair[i];
		points = rolling_held(p->placed[pair.x], p->placed[pair.y], p->contact_found[slot]);
	}
	Prepared made;
	made.normal = points.normal;
	made.offset = points.offset;
	made.anchor1 = points.anchor[0];
	made.anchor2 = points.anchor[1];
	made.separation1 = points.separation[0];
	made.separation2 = points.separation[1];
	prepare_depth(p, minimum(made.separation1, made.separation2));
	return made;
}

// what prepare has left
INLINE Prepared prepare_read(const Pools* p, int i)
{
	Prepared made;
	made.normal = vec(constraint_at(p, normal_x, i), constraint_at(p, normal_y, i));
	made.offset = vec(constraint_at(p, offset_x, i), constraint_at(p, offset_y, i));
	made.anchor1 = vec(constraint_at(p, anchor1_x, i), constraint_at(p, anchor1_y, i));
	made.anchor2 = vec(constraint_at(p, anchor2_x, i), constraint_at(p, anchor2_y, i));
	made.separation1 = constraint_at(p, separation1, i);
	made.separation2 = constraint_at(p, separation2, i);
	return made;
}

// m/s^2: of a body by gravity and the user's forces. What is slower than gravity would make it within a step, and touches
// something else, is held up by that.
INLINE Vec prepare_acceleration(const Pools* p, int body, Body b)
{
	Motion motion = p->motion[body];
	Vec gravity = vec(p->step.gravity_x, p->step.gravity_y);
	float gained = p->step.dt * p->step.dt * vec_dot(gravity, gravity);
	if (vec_dot(b.v, b.v) < gained && p->touching[body] > 1)
		return vec(0.0f, 0.0f);
	return vec(motion.free_x * (motion.gravity_scale * gravity.x + b.inv_mass * motion.fx),
	           motion.free_y * (motion.gravity_scale * gravity.y + b.inv_mass * motion.fy));
}

// Newton's law of impact: how fast a point leaves that comes with a normal velocity (negative) and has a gap to go. A body
// that falls in substeps is at points of a parabola, on which its speed is that of a substep's middle: half of what a
// substep adds is put to the speed before, and taken from the speed after (bounce_speed). Between, energy is kept.
INLINE float prepare_rebound(const Step* step, float restitution, float velocity, float fall, float gap)
{
	float before = velocity + 0.5f * step->h * fall;
	float square = before * before - 2.0f * fall * gap, threshold = step->restitution_threshold;
	return before < 0.0f && square > threshold * threshold ? restitution * square_root(square) : 0.0f;
}

// m/s: normal velocity of a point, r from the center of a
INLINE float prepare_velocity(Body a, Body b, Vec r, Prepared made)
{
	Vec v = vec_sub(body_velocity_at(b, vec_add(r, made.offset)), body_velocity_at(a, r));
	return vec_dot(v, made.normal);
}

// What may bounce within the step, and how fast. What hardly moves will not in one step.
INLINE void prepare_bounce(const Pools* p, int i, Prepared made)
{
	float e = extra_at(p, restitution, i), fall = 0.0f, rebound1 = 0.0f, rebound2 = 0.0f;
	if (e > 0.0f)
	{
		int ia = constraint_at(p, body_a, i), ib = constraint_at(p, body_b, i);
		Body a = prepare_body(p, ia), b = prepare_body(p, ib);
		float v1 = prepare_velocity(a, b, made.anchor1, made), v2 = prepare_velocity(a, b, made.anchor2, made);
		if (minimum(v1, v2) < -0.25f * p->step.restitution_threshold)
		{
			Vec fall_a = prepare_acceleration(p, ia, a), fall_b = prepare_acceleration(p, ib, b);
			fall = number_of(vec_dot(vec_sub(fall_b, fall_a), made.normal));
			rebound1 = prepare_rebound(&p->step, e, v1, fall, made.separation1);
			rebound2 = prepare_rebound(&p->step, e, v2, fall, made.separation2);
		}
	}
	extra_at(p, fall, i) = fall;
	extra_at(p, rebound1, i) = rebound1;
	extra_at(p, rebound2, i) = rebound2;
}

INLINE void prepare_extras(const Pools* p, int i, Prepared made)
{
	extra_at(p, total_impulse1, i) = 0.0f;
	extra_at(p, total_impulse2, i) = 0.0f;
	if (p->step.bounces)
		prepare_bounce(p, i, made);
}

// What is round, and what may bounce.
STAGE(prepare_extra)
{
	int slot = p->constraint_contact[i];
	if (slot < 0)
		return;
	Word flags = p->step.round ? p->contact_flags[slot] : 0u;
	if (flags & FOUND_ROLLS)
	{
		ContactPoints points = prepare_rolling(p, i, slot, flags);
		constraint_at(p, normal_x, i) = points.normal.x;
		constraint_at(p, normal_y, i) = points.normal.y;
		constraint_at(p, offset_x, i) = points.offset.x;
		constraint_at(p, offset_y, i) = points.offset.y;
		constraint_at(p, anchor1_x, i) = points.anchor[0].x;
		constraint_at(p, anchor1_y, i) = points.anchor[0].y;
		constraint_at(p, anchor2_x, i) = points.anchor[1].x;
		constraint_at(p, anchor2_y, i) = points.anchor[1].y;
		constraint_at(p, separation1, i) = points.separation[0];
		constraint_at(p, separation2, i) = points.separation[1];
	}
	if (p->step.round)
		prepare_depth(p, minimum(constraint_at(p, separation1, i), constraint_at(p, separation2, i)));
	if (p->step.extras)
		prepare_extras(p, i, prepare_read(p, i));
}

#endif
