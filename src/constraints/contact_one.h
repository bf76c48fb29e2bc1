// SPDX-License-Identifier: MIT
// contact_one.h -- stages of contacts that take one contact at a time: restitution, approach speeds, rows that the layout sets.
#ifndef CONTACT_ONE_H
#define CONTACT_ONE_H
#include "constraints/contact.h"

// A body at the start of the step, with its speed within the limits.
INLINE Body prepare_body(const Pools* p, int index)
{
	Body b = body_gather(p, index);
	b.v = vec_scale(vec_shrink(b.v, p->step.max_speed), b.v);
	b.w = within(b.w, p->step.max_spin);
	return b;
}

// m/s^2: of a body by gravity and the user's forces. A body that is slower than gravity would make it in one step, and that
// touches something else, is assumed to be supported: 0.
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

// Newton's law of impact, m/s: the speed with which a point leaves that approaches with a normal velocity (negative) and is a
// gap away. Semi-implicit Euler puts a falling body on a parabola on which its velocity is that of the middle of a substep. So
// half of a substep's acceleration is added before the impact and subtracted after it (bounce_speed), which conserves energy.
INLINE float prepare_rebound(const Step* step, float restitution, float velocity, float fall, float gap)
{
	float before = velocity + 0.5f * step->h * fall;
	float square = before * before - 2.0f * fall * gap, threshold = step->restitution_threshold;
	return before < 0.0f && square > threshold * threshold ? restitution * square_root(square) : 0.0f;
}

// m/s^2: with the largest gap and step the square of a speed is still finite
#define MOST_FALL 1.0e18f

// Rebound speeds of the points that may bounce within the step. Points that hardly move are left out.
INLINE void prepare_bounce(const Pools* p, int i, const Contact* u)
{
	float e = contact_rare(p, restitution, i), fall = 0.0f, rebound1 = 0.0f, rebound2 = 0.0f;
	if (e > 0.0f)
	{
		int ia = contact_row(p, body_a, i), ib = contact_row(p, body_b, i);
		Body a = prepare_body(p, ia), b = prepare_body(p, ib);
		ContactArms c = pair_of(u, &a, &b);
		float v1 = pair_approach(c, 0, c.n), v2 = pair_approach(c, 1, c.n);
		if (minimum(v1, v2) < -0.25f * p->step.restitution_threshold)
		{
			Vec fall_a = prepare_acceleration(p, ia, a), fall_b = prepare_acceleration(p, ib, b);
			fall = vec_dot(vec_sub(fall_b, fall_a), c.n);
			fall = fall >= -MOST_FALL && fall <= MOST_FALL ? fall : 0.0f;
			rebound1 = prepare_rebound(&p->step, e, v1, fall, u->separation1);
			rebound2 = prepare_rebound(&p->step, e, v2, fall, u->separation2);
		}
	}
	contact_rare(p, fall, i) = fall;
	contact_rare(p, rebound1, i) = rebound1;
	contact_rare(p, rebound2, i) = rebound2;
}

// m/s: approach speeds of the points at the start of the step.
INLINE void prepare_approach(const Pools* p, int i, const Contact* u)
{
	Body a = prepare_body(p, contact_row(p, body_a, i)), b = prepare_body(p, contact_row(p, body_b, i));
	ContactArms c = pair_of(u, &a, &b);
	float speed1 = -pair_approach(c, 0, c.n), speed2 = -pair_approach(c, 1, c.n);
	contact_rare(p, approach1, i) = speed1 > 0.0f && speed1 <= MOST_FLOAT ? speed1 : 0.0f;
	contact_rare(p, approach2, i) = speed2 > 0.0f && speed2 <= MOST_FLOAT ? speed2 : 0.0f;
}

// The rare rows that are prepared.
INLINE void contact_setup_rare(const Pools* p, int i, const Contact* u)
{
	contact_rare(p, total_impulse1, i) = 0.0f;
	contact_rare(p, total_impulse2, i) = 0.0f;
	if (p->step.details)
		prepare_approach(p, i, u);
	if (p->step.bounces)
		prepare_bounce(p, i, u);
}

// Whether a slot holds a contact.
INLINE int contact_in_use(const Pools* p, int slot) { return p->pair[slot].x >= 0; }

// Rows that come from the surfaces of the two collidables.
INLINE void contact_set_surface(const Pools* p, int i, Float4 surface)
{
	contact_row(p, friction, i) = surface.x;
	contact_rare(p, restitution, i) = surface.y;
	contact_rare(p, rolling, i) = surface.z;
	contact_rare(p, tangent_speed, i) = surface.w;
}

// Rows that are valid until the next layout.
INLINE void contact_set_place(const Pools* p, int slot, int i)
{
	p->contact_place_pair[i] = p->pair[slot];
	contact_set_surface(p, i, p->contact_surface[slot]);
}

#endif
