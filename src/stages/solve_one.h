// SPDX-License-Identifier: MIT
// solve_one.h -- what the solver does for single items: bodies made ready for a step, contacts into constraints and back.
#ifndef SOLVE_ONE_H
#define SOLVE_ONE_H
#include "stages/body.h"
#include "stages/prepare.h"

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
INLINE float prepare_velocity(Body a, Body b, Vec r, ContactPoints points)
{
	Vec v = vec_sub(body_velocity_at(b, vec_add(r, points.offset)), body_velocity_at(a, r));
	return vec_dot(v, points.normal);
}

// m/s^2: with the longest gap and step it is still a float, and so is its square
#define MOST_FALL 1.0e18f

// What may bounce within the step, and how fast. What hardly moves will not in one step.
INLINE void prepare_bounce(const Pools* p, int i, ContactPoints points)
{
	float e = extra_at(p, restitution, i), fall = 0.0f, rebound1 = 0.0f, rebound2 = 0.0f;
	if (e > 0.0f)
	{
		int ia = constraint_at(p, body_a, i), ib = constraint_at(p, body_b, i);
		Body a = prepare_body(p, ia), b = prepare_body(p, ib);
		float v1 = prepare_velocity(a, b, points.anchor[0], points),
		      v2 = prepare_velocity(a, b, points.anchor[1], points);
		if (minimum(v1, v2) < -0.25f * p->step.restitution_threshold)
		{
			Vec fall_a = prepare_acceleration(p, ia, a), fall_b = prepare_acceleration(p, ib, b);
			fall = vec_dot(vec_sub(fall_b, fall_a), points.normal);
			fall = fall >= -MOST_FALL && fall <= MOST_FALL ? fall : 0.0f;
			rebound1 = prepare_rebound(&p->step, e, v1, fall, points.separation[0]);
			rebound2 = prepare_rebound(&p->step, e, v2, fall, points.separation[1]);
		}
	}
	extra_at(p, fall, i) = fall;
	extra_at(p, rebound1, i) = rebound1;
	extra_at(p, rebound2, i) = rebound2;
}

INLINE void prepare_extras(const Pools* p, int i, ContactPoints points)
{
	extra_at(p, total_impulse1, i) = 0.0f;
	extra_at(p, total_impulse2, i) = 0.0f;
	if (p->step.bounces)
		prepare_bounce(p, i, points);
}

// what may bounce, by the points that prepare left
STAGE(prepare_extra)
{
	if (p->constraint_contact[i] < 0)
		return;
	ContactPoints points;
	points.normal = vec(constraint_at(p, normal_x, i), constraint_at(p, normal_y, i));
	points.offset = vec(constraint_at(p, offset_x, i), constraint_at(p, offset_y, i));
	points.anchor[0] = vec(constraint_at(p, anchor1_x, i), constraint_at(p, anchor1_y, i));
	points.anchor[1] = vec(constraint_at(p, anchor2_x, i), constraint_at(p, anchor2_y, i));
	points.separation[0] = constraint_at(p, separation1, i);
	points.separation[1] = constraint_at(p, separation2, i);
	prepare_extras(p, i, points);
}

#endif
