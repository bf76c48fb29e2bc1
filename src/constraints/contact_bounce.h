// SPDX-License-Identifier: MIT
// contact_bounce.h -- computes the prepared rare rows of contacts: rebound speeds by restitution, and approach speeds.
#ifndef CONTACT_BOUNCE_H
#define CONTACT_BOUNCE_H
#include "constraints/contact_constraint.h"

// Returns a body at the start of the step, with speed and spin limited to max_speed and max_spin.
INLINE Body prepare_body(const Pools* p, Int index)
{
	Body b = body_gather(p, index);
	b.v = vec_flush_tiny(vec_limit(b.v, p->step.max_speed));
	b.w = within(b.w, splat(p->step.max_spin));
	return b;
}

typedef struct // both bodies at the start of the step; normal velocities of the points, m/s, negative if they approach
{
	Int ia, ib;
	ContactArms arms;
	Real speed[2];
} Approach;

INLINE Approach prepare_velocities(const Pools* p, int i, const Contact* u)
{
	Approach at;
	at.ia = load_int(&contact_row(p, body_a, i), 0);
	at.ib = load_int(&contact_row(p, body_b, i), 0);
	Body a = prepare_body(p, at.ia), b = prepare_body(p, at.ib);
	at.arms = pair_of(u, &a, &b);
	for (int k = 0; k < 2; ++k)
		at.speed[k] = flush_tiny(pair_approach(at.arms, k, at.arms.n));
	return at;
}

// m/s^2: Returns a body's acceleration by gravity and forces. Returns 0 if the body is slower than gravity makes it in
// a step, and another constraint may support it.
INLINE Vec prepare_acceleration(const Pools* p, Int body, Body b)
{
	Real row[8], zero = splat(0.0f);
	gather_rows8((GLOBAL float*)p->motion, body, row);
	Vec gravity = gravity_of(p, body);
	Real gained = flush_below(p->step.dt * p->step.dt * vec_dot(gravity, gravity), ABSORBS);
	Int supported = (vec_dot(b.v, b.v) < gained) & (gather_int(p->touching, body) > 1);
	Vec fall =
	    vec(row[6] * (row[3] * gravity.x + b.inv_mass * row[0]), row[7] * (row[3] * gravity.y + b.inv_mass * row[1]));
	return vec_blend(fall, vec(zero, zero), supported);
}

// m/s: Returns the rebound speed of a point by Newton's law of impact; 0 if it does not bounce. velocity: normal
// velocity, m/s, negative if the surfaces approach; fall: normal acceleration, m/s^2; gap: separation, m. With
// semi-implicit Euler, position and velocity of a falling body are half a substep apart. To conserve energy, the
// acceleration during half a substep is added to the velocity before the impact and subtracted after it (bounce_speed).
INLINE Real prepare_rebound(const Step* step, Real restitution, Real velocity, Real fall, Real gap)
{
	Real before = velocity + 0.5f * step->h * fall;
	Real square = before * before - 2.0f * fall * gap;
	Int bounces =
	    (before <= splat(-TINY)) & (square > splat(step->restitution_threshold * step->restitution_threshold));
	return only(flush_below(restitution * root(blend(splat(1.0f), square, bounces)), ROOT_ABSORBS), bounces);
}

// J: Returns the maximum energy of two bodies after a bounce: their relative kinetic energy at impact, with an upper
// bound of the gain by the fall within the step, and times e^2 if the restitution e is above 1.
INLINE Real prepare_energy(const ContactArms* c, Real e, const Real speed[2], Real rebound1, Real rebound2)
{
	Real zero = splat(0.0f), one = splat(1.0f), safe = blend(one, e, e > zero);
	Real meet1 = quotient(rebound1, safe), meet2 = quotient(rebound2, safe);
	Real more1 = only(meet1 * meet1 - speed[0] * speed[0], rebound1 > zero),
	     more2 = only(meet2 * meet2 - speed[1] * speed[1], rebound2 > zero);
	// restitution above 1 adds energy on purpose
	Real energy = (pair_energy(c) + pair_gained(c, more1, more2)) * maximum(one, e * e);
	return blend(splat(MOST_FLOAT), energy, energy <= splat(MOST_FLOAT));
}

#define MOST_FALL 1.0e18f // m/s^2: a larger normal acceleration counts as 0, so that squares of speeds stay finite

// Computes the rows of restitution. No point rebounds unless one approaches faster than restitution_threshold / 4.
INLINE void prepare_bounce(const Pools* p, int i, const Contact* u)
{
	Real e = load(&contact_rare(p, restitution, i), 0), zero = splat(0.0f), fall = zero, rebound1 = zero,
	     rebound2 = zero, energy = zero;
	Int elastic = e > zero;
	if (lane_bits(elastic))
	{
		Approach at = prepare_velocities(p, i, u);
		Int nears = elastic & (minimum(at.speed[0], at.speed[1]) < splat(-0.25f * p->step.restitution_threshold));
		if (lane_bits(nears))
		{
			Vec fall_a = prepare_acceleration(p, at.ia, at.arms.a), fall_b = prepare_acceleration(p, at.ib, at.arms.b);
			Real falls = vec_dot(vec_sub(fall_b, fall_a), at.arms.n);
			fall = only(falls, nears & (falls >= splat(-MOST_FALL)) & (falls <= splat(MOST_FALL)));
			rebound1 = only(prepare_rebound(&p->step, e, at.speed[0], fall, u->separation1), nears);
			rebound2 = only(prepare_rebound(&p->step, e, at.speed[1], fall, u->separation2), nears);
			energy = prepare_energy(&at.arms, e, at.speed, rebound1, rebound2);
		}
	}
	store(&contact_rare(p, fall, i), 0, fall);
	store(&contact_rare(p, energy, i), 0, energy);
	store(&contact_rare(p, rebound1, i), 0, rebound1);
	store(&contact_rare(p, rebound2, i), 0, rebound2);
}

// Stores the approach speeds of the points at the start of the step, m/s; 0 for points that do not approach.
INLINE void prepare_approach(const Pools* p, int i, const Contact* u)
{
	Approach at = prepare_velocities(p, i, u);
	Real zero = splat(0.0f), speed1 = -at.speed[0], speed2 = -at.speed[1];
	store(&contact_rare(p, approach1, i), 0, only(speed1, (speed1 > zero) & (speed1 <= splat(MOST_FLOAT))));
	store(&contact_rare(p, approach2, i), 0, only(speed2, (speed2 > zero) & (speed2 <= splat(MOST_FLOAT))));
}

// Computes the prepared rare rows. The rows of padding stay 0.
INLINE void contact_setup_rare(const Pools* p, int i, const Contact* u)
{
	store(&contact_rare(p, total_impulse1, i), 0, splat(0.0f));
	store(&contact_rare(p, total_impulse2, i), 0, splat(0.0f));
	if (p->step.details)
		prepare_approach(p, i, u);
	if (p->step.bounces)
		prepare_bounce(p, i, u);
}

#endif
