// SPDX-License-Identifier: MIT
// solve.h -- one pass of soft sequential impulses over the constraints of one color, and the passes over bodies between.
//
// This work is based on:
// Erin Catto, Soft Constraints, GDC 2011: bias rate, mass and impulse scale of a constraint with a frequency.
// Miles Macklin et al., Small Steps in Physics Simulation, 2019: substeps instead of iterations.
// Erin Catto, Solver2D, 2024: a biased and a relaxing pass per substep ("soft step").
//
// Warm starting takes no pass over the contacts. Anchors and normals are constant within a step, so that the velocity
// which all contacts together gave a body in one substep is what they would give it again: velocity after the relaxing
// pass less the velocity before any impulse (the pool base). integrate_velocity adds it to the next substep.
#ifndef SOLVE_H
#define SOLVE_H
#include "stages/body.h"

typedef struct // the part of a constraint that all passes share
{
	Int ia, ib;
	Body a, b;
	Vec n, t;         // normal from a to b; tangent
	Vec ra[2], rb[2]; // anchors from the centers of mass
} Pair;

// all but the bodies
INLINE void pair_arms(const Pools* p, int i, Pair* c)
{
	c->n = vec(load(&constraint_at(p, normal_x, i), 0), load(&constraint_at(p, normal_y, i), 0));
	c->t = vec(c->n.y, -c->n.x);
	Vec offset = vec(load(&constraint_at(p, offset_x, i), 0), load(&constraint_at(p, offset_y, i), 0));
	c->ra[0] = vec(load(&constraint_at(p, anchor1_x, i), 0), load(&constraint_at(p, anchor1_y, i), 0));
	c->ra[1] = vec(load(&constraint_at(p, anchor2_x, i), 0), load(&constraint_at(p, anchor2_y, i), 0));
	c->rb[0] = vec_add(c->ra[0], offset);
	c->rb[1] = vec_add(c->ra[1], offset);
}

INLINE Pair pair_load(const Pools* p, int i)
{
	Pair c;
	c.ia = load_int(&constraint_at(p, body_a, i), 0);
	c.ib = load_int(&constraint_at(p, body_b, i), 0);
	c.a = body_gather(p, c.ia);
	c.b = body_gather(p, c.ib);
	pair_arms(p, i, &c);
	return c;
}

INLINE void pair_store(const Pools* p, Pair c)
{
	body_scatter(p, c.ia, c.a);
	body_scatter(p, c.ib, c.b);
}

// normal velocity at point k
INLINE Real pair_approach(Pair c, int k, Vec n)
{
	return vec_dot(vec_sub(body_velocity_at(c.b, c.rb[k]), body_velocity_at(c.a, c.ra[k])), n);
}

// how far the bodies are apart at point k, now
INLINE Real pair_gap(const Pair* c, int k, Real separation)
{
	Vec moved = vec_sub(body_displacement(c->b, c->rb[k]), body_displacement(c->a, c->ra[k]));
	return separation + vec_dot(moved, c->n);
}

INLINE Real pair_mass(const Pair* c, int k, Vec n) { return body_effective_mass(c->a, c->ra[k], c->b, c->rb[k], n); }

typedef struct // of a point's push: what it adds to the normal velocity, and how soft it is
{
	Real bias, mass_scale, impulse_scale;
} PairGoal;

// Of a point s apart. With soft null the overlap is left alone: what bodies gained by being pushed out is taken from them
// again. Contacts with what is fixed, cannot move, are stiffer, so that nothing sinks into the ground.
INLINE PairGoal pair_goal(Real s, Int fixed, const Step* step, int soft)
{
	Int apart = s > splat(0.0f);

	// speculative: no push before the gap closes within the substep
	Real bias = choose(splat(0.0f), s * step->inv_h, apart);
	Real mass_scale = splat(1.0f), impulse_scale = splat(0.0f);
	if (soft)
	{
		Real rate = choose(splat(step->soft.mass_scale * step->soft.bias_rate),
		                   splat(step->stiff.mass_scale * step->stiff.bias_rate), fixed);
		bias = choose(maximum(rate * s, splat(-step->push_speed)), bias, apart);
		mass_scale =
		    choose(choose(splat(step->soft.mass_scale), splat(step->stiff.mass_scale), fixed), mass_scale, apart);
		impulse_scale = choose(choose(splat(step->soft.impulse_scale), splat(step->stiff.impulse_scale), fixed),
		                       impulse_scale, apart);
	}
	PairGoal goal;
	goal.bias = bias;
	goal.mass_scale = mass_scale;
	goal.impulse_scale = impulse_scale;
	return goal;
}

// One point's push along the normal, s apart. Returns the new accumulated impulse, which never pulls.
INLINE Real pair_normal(Pair* c, int k, Real s, Real mass, Real old, const Step* step, int soft)
{
	Int fixed = (c->a.inv_mass == splat(0.0f)) | (c->b.inv_mass == splat(0.0f));
	PairGoal goal = pair_goal(s, fixed, step, soft);
	Real change = -mass * (goal.mass_scale * pair_approach(*c, k, c->n) + goal.bias) - goal.impulse_scale * old;
	Real impulse = maximum(old + change, splat(0.0f));
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->n));
	return impulse;
}

// One point's friction: Coulomb's cone with the normal impulse of the pass before.
INLINE Real pair_tangent(Pair* c, int k, Real mass, Real speed, Real limit, Real old)
{
	Real impulse = old - mass * (pair_approach(*c, k, c->t) + speed);
	impulse = minimum(maximum(impulse, -limit), limit);
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->t));
	return impulse;
}

// Rolling resistance: a torque against the relative spin, limited by the load times a lever; by the load without its
// bias, or a fast roller, whose load is uneven within a step, would stop too early.
INLINE void pair_roll(const Pools* p, int i, Pair* c, Real weight)
{
	Real inertia = c->a.inv_inertia + c->b.inv_inertia;
	Real mass = choose(splat(0.0f), 1.0f / inertia, inertia > splat(0.0f));
	Real limit = load(&extra_at(p, rolling, i), 0) * weight, old = load(&extra_at(p, rolling_impulse, i), 0);
	Real impulse = minimum(maximum(old - mass * (c->b.w - c->a.w), -limit), limit);
	c->a.w = c->a.w - c->a.inv_inertia * (impulse - old);
	c->b.w = c->b.w + c->b.inv_inertia * (impulse - old);
	store(&extra_at(p, rolling_impulse, i), 0, impulse);
}

// the largest impulses of any substep
INLINE void pair_peak(const Pools* p, int i, Real normal1, Real normal2)
{
	store(&extra_at(p, peak_impulse1, i), 0, maximum(load(&extra_at(p, peak_impulse1, i), 0), normal1));
	store(&extra_at(p, peak_impulse2, i), 0, maximum(load(&extra_at(p, peak_impulse2, i), 0), normal2));
}

// all impulses at once
INLINE void pair_push(const Pools* p, int i, Pair* c, Real normal1, Real normal2, Real tangent1, Real tangent2)
{
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_add(vec_scale(normal1, c->n), vec_scale(tangent1, c->t)));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_add(vec_scale(normal2, c->n), vec_scale(tangent2, c->t)));
	if (p->step.extras)
	{
		Real rolling = load(&extra_at(p, rolling_impulse, i), 0);
		c->a.w = c->a.w - c->a.inv_inertia * rolling;
		c->b.w = c->b.w + c->b.inv_inertia * rolling;
	}
}

// whether a point approached faster than the threshold and was pushed
INLINE Int pair_hit(Real restitution, Real approach, Real peak, float threshold)
{
	return (restitution > splat(0.0f)) & (approach < splat(-threshold)) & (peak > splat(0.0f));
}

// restitution of one point that hit (Newton's law of impact)
INLINE Real pair_bounce(Pair* c, int k, Real restitution, Real approach, Real peak, Real old, float threshold)
{
	Int hit = pair_hit(restitution, approach, peak, threshold);
	Real mass = body_effective_mass(c->a, c->ra[k], c->b, c->rb[k], c->n);
	Real impulse = maximum(old - mass * (pair_approach(*c, k, c->n) + restitution * approach), splat(0.0f));
	impulse = choose(old, impulse, hit);
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->n));
	return impulse;
}

// the impulses of the last step
INLINE void warm_start_pass(const Pools* p, int i, Pair* c)
{
	pair_push(p, i, c, load(&constraint_at(p, normal_impulse1, i), 0), load(&constraint_at(p, normal_impulse2, i), 0),
	          load(&constraint_at(p, tangent_impulse1, i), 0), load(&constraint_at(p, tangent_impulse2, i), 0));
}

INLINE void bias_pass(const Pools* p, int i, Pair* c)
{
	Real gap1 = pair_gap(c, 0, load(&constraint_at(p, separation1, i), 0));
	store(&constraint_at(p, normal_impulse1, i), 0,
	      pair_normal(c, 0, gap1, pair_mass(c, 0, c->n), load(&constraint_at(p, normal_impulse1, i), 0), &p->step, 1));
	Real gap2 = pair_gap(c, 1, load(&constraint_at(p, separation2, i), 0));
	store(&constraint_at(p, normal_impulse2, i), 0,
	      pair_normal(c, 1, gap2, pair_mass(c, 1, c->n), load(&constraint_at(p, normal_impulse2, i), 0), &p->step, 1));
}

INLINE void relax_pass(const Pools* p, int i, Pair* c)
{
	Real normal1 = load(&constraint_at(p, normal_impulse1, i), 0),
	     normal2 = load(&constraint_at(p, normal_impulse2, i), 0);
	Real speed = splat(0.0f);
	if (p->step.extras)
		speed = load(&extra_at(p, tangent_speed, i), 0);

	// friction first: keeping bodies apart matters more, so it has the last word
	Real friction = load(&constraint_at(p, friction, i), 0);
	store(&constraint_at(p, tangent_impulse1, i), 0,
	      pair_tangent(c, 0, pair_mass(c, 0, c->t), speed, friction * normal1,
	                   load(&constraint_at(p, tangent_impulse1, i), 0)));
	store(&constraint_at(p, tangent_impulse2, i), 0,
	      pair_tangent(c, 1, pair_mass(c, 1, c->t), speed, friction * normal2,
	                   load(&constraint_at(p, tangent_impulse2, i), 0)));

	Real gap1 = pair_gap(c, 0, load(&constraint_at(p, separation1, i), 0));
	normal1 = pair_normal(c, 0, gap1, pair_mass(c, 0, c->n), normal1, &p->step, 0);
	Real gap2 = pair_gap(c, 1, load(&constraint_at(p, separation2, i), 0));
	normal2 = pair_normal(c, 1, gap2, pair_mass(c, 1, c->n), normal2, &p->step, 0);
	store(&constraint_at(p, normal_impulse1, i), 0, normal1);
	store(&constraint_at(p, normal_impulse2, i), 0, normal2);
	if (p->step.extras)
	{
		pair_roll(p, i, c, normal1 + normal2);
		pair_peak(p, i, normal1, normal2);
	}
}

INLINE void bounce_pass(const Pools* p, int i, Pair* c)
{
	Real e = load(&extra_at(p, restitution, i), 0);
	float threshold = p->step.restitution_threshold;
	store(&constraint_at(p, normal_impulse1, i), 0,
	      pair_bounce(c, 0, e, load(&extra_at(p, approach1, i), 0), load(&extra_at(p, peak_impulse1, i), 0),
	                  load(&constraint_at(p, normal_impulse1, i), 0), threshold));
	store(&constraint_at(p, normal_impulse2, i), 0,
	      pair_bounce(c, 1, e, load(&extra_at(p, approach2, i), 0), load(&extra_at(p, peak_impulse2, i), 0),
	                  load(&constraint_at(p, normal_impulse2, i), 0), threshold));
}

// a pass over the constraints of one color
#define PASS(name)                \
	WIDE_STAGE(name)              \
	{                             \
		Pair c = pair_load(p, i); \
		name##_pass(p, i, &c);    \
		pair_store(p, c);         \
	}
PASS(warm_start)
PASS(bias)
PASS(relax)
PASS(bounce)

// Forces into velocity, and the contacts' share of the substep before as warm start. b is a row of the pool body, m of
// motion, base of base. In the first substep base still holds the velocity of the body alone, and the warm start has
// been added to it.
INLINE void body_accelerate(const Step* step, Real* b, const Real* m, Real* base, int first)
{
	Vec v = vec(b[0], b[1]), contacts = vec_sub(v, vec(base[0], base[1]));
	Real w = b[2], contacts_w = w - base[2];
	if (first)
	{
		v = vec(base[0], base[1]);
		w = base[2];
	}

	// implicit damping, semi-implicit Euler; a lock holds by taking the velocity away
	float h = step->h;
	Real linear = 1.0f / (1.0f + h * m[4]), angular = 1.0f / (1.0f + h * m[5]);
	v.x = m[6] * (linear * v.x + h * (step->gravity_x * m[3] + b[3] * m[0]));
	v.y = m[7] * (linear * v.y + h * (step->gravity_y * m[3] + b[3] * m[1]));
	w = angular * w + h * (b[7] * m[2]);
	base[0] = v.x;
	base[1] = v.y;
	base[2] = w;
	v.x = v.x + m[6] * contacts.x;
	v.y = v.y + m[7] * contacts.y;
	w = w + contacts_w;

	// what exceeds the limits is taken from the base as well, or the next substep would take it for the contacts' doing
	Real square = vec_dot(v, v);
	float limit = step->max_speed, spin = step->max_spin;
	Real scale = choose(splat(1.0f), limit / root(square), square > splat(limit * limit));
	v = vec_scale(scale, v);
	base[0] = scale * base[0];
	base[1] = scale * base[1];
	Real limited = minimum(maximum(w, splat(-spin)), splat(spin));
	base[2] = base[2] + (limited - w);
	w = limited;

	b[0] = v.x;
	b[1] = v.y;
	b[2] = w;
}

INLINE void body_move(const Step* step, Real* b, const Real* m)
{
	float h = step->h;
	b[4] = b[4] + h * (m[6] * b[0]);
	b[5] = b[5] + h * (m[7] * b[1]);
	b[6] = b[6] + h * b[2];
}

// argument is 1 in the first substep
WIDE_STAGE(integrate_velocity)
{
	Real b[8], m[8], base[4];
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	load_rows4((GLOBAL float*)p->base, i, base);
	body_accelerate(&p->step, b, m, base, p->argument);
	store_rows8((GLOBAL float*)p->body, i, b);
	store_rows4((GLOBAL float*)p->base, i, base);
}

WIDE_STAGE(integrate_position)
{
	Real b[8], m[8];
	load_rows8((GLOBAL float*)p->body, i, b);
	load_rows8((GLOBAL float*)p->motion, i, m);
	body_move(&p->step, b, m);
	store_rows8((GLOBAL float*)p->body, i, b);
}

#endif
