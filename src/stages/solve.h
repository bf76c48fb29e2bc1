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
#include "stages/finite.h"

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

// Whether a point that is to bounce has not met yet.
INLINE Int pair_waits(Real s, Real old, Real rebound)
{
	return (s > splat(0.0f)) & (rebound > splat(0.0f)) & (old == splat(0.0f));
}

// One point's push along the normal, s apart. Returns the new accumulated impulse, which never pulls. What is to bounce
// (rebound) and did not meet within this substep keeps its speed when it is relaxed, or it would bounce before it is there,
// or not at all.
INLINE Real pair_normal(Pair* c, int k, Real s, Real mass, Real old, const Step* step, int soft, Real rebound)
{
	Int fixed = (c->a.inv_mass == splat(0.0f)) | (c->b.inv_mass == splat(0.0f));
	PairGoal goal = pair_goal(s, fixed, step, soft);
	Real change = -mass * (goal.mass_scale * pair_approach(*c, k, c->n) + goal.bias) - goal.impulse_scale * old;
	Real impulse = push_of(old + change);
	if (step->bounces && !soft)
		impulse = choose(impulse, splat(0.0f), pair_waits(s, old, rebound));
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->n));
	return impulse;
}

// One point's friction: Coulomb's cone with the normal impulse of the pass before.
INLINE Real pair_tangent(Pair* c, int k, Real mass, Real speed, Real limit, Real old)
{
	Real impulse = grip_of(old - mass * (pair_approach(*c, k, c->t) + speed), limit);
	body_push(&c->a, c->ra[k], &c->b, c->rb[k], vec_scale(impulse - old, c->t));
	return impulse;
}

// Rolling resistance: a torque against the relative spin, limited by the load times a lever; by the load without its
// bias, or a fast roller, whose load is uneven within a step, would stop too early.
INLINE void pair_roll(const Pools* p, int i, Pair* c, Real weight)
{
	Real inertia = c->a.inv_inertia + c->b.inv_inertia;
	Real mass = choose(splat(0.0f), 1.0f / inertia, inertia > splat(0.0f));
	Real limit = minimum(load(&extra_at(p, rolling, i), 0) * weight, splat(MOST_IMPULSE));
	Real old = load(&extra_at(p, rolling_impulse, i), 0);
	Real impulse = grip_of(old - mass * (c->b.w - c->a.w), limit);
	c->a.w = c->a.w - c->a.inv_inertia * (impulse - old);
	c->b.w = c->b.w + c->b.inv_inertia * (impulse - old);
	store(&extra_at(p, rolling_impulse, i), 0, impulse);
}

// the impulses of all substeps
INLINE void pair_total(const Pools* p, int i, Real normal1, Real normal2)
{
	store(&extra_at(p, total_impulse1, i), 0, load(&extra_at(p, total_impulse1, i), 0) + normal1);
	store(&extra_at(p, total_impulse2, i), 0, load(&extra_at(p, total_impulse2, i), 0) + normal2);
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

// The impulses that give two points what they lack (m/s) at once. What one does to the other is cross; without it 1/mass
// is what it resists. Two points that are nearly one are one.
INLINE void pair_joint(const Pair* c, Real mass1, Real mass2, Real lack1, Real lack2, Real* impulse1, Real* impulse2)
{
	Real cross = c->a.inv_mass + c->b.inv_mass +
	             c->a.inv_inertia * vec_cross(c->ra[0], c->n) * vec_cross(c->ra[1], c->n) +
	             c->b.inv_inertia * vec_cross(c->rb[0], c->n) * vec_cross(c->rb[1], c->n);
	Real share = 1.0f - cross * mass1 * cross * mass2;
	Int one = share < splat(0.001f);
	*impulse1 = choose(mass1 * (lack1 - cross * mass2 * lack2) / share, mass1 * lack1, one);
	*impulse2 = choose(mass2 * (lack2 - cross * mass1 * lack1) / share, splat(0.0f), one);
}

// Two points that will bounce are slowed down at once. One after the other they would turn what lands flat, and friction
// would make of that a speed along the surface.
INLINE void pair_meet(const Pools* p, int i, Pair* c, Real gap1, Real gap2, Real mass1, Real mass2, Real* normal1,
                      Real* normal2)
{
	Real zero = splat(0.0f), delta1, delta2;
	Real lack1 = -(pair_approach(*c, 0, c->n) + maximum(gap1, zero) * p->step.inv_h),
	     lack2 = -(pair_approach(*c, 1, c->n) + maximum(gap2, zero) * p->step.inv_h);
	pair_joint(c, mass1, mass2, lack1, lack2, &delta1, &delta2);
	Int meet = (load(&extra_at(p, rebound1, i), 0) > zero) & (load(&extra_at(p, rebound2, i), 0) > zero);
	Real new1 = *normal1 + delta1, new2 = *normal2 + delta2;

	// where one pushes alone, one after the other is right
	meet = meet & ((new1 < zero) == (new2 < zero));
	new1 = choose(*normal1, push_of(new1), meet);
	new2 = choose(*normal2, push_of(new2), meet);
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_scale(new1 - *normal1, c->n));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_scale(new2 - *normal2, c->n));
	*normal1 = new1;
	*normal2 = new2;
}

INLINE void pair_bias(const Pools* p, int i, Pair* c, Real gap1, Real gap2, Real mass1, Real mass2, Real* normal1,
                      Real* normal2)
{
	if (p->step.bounces)
		pair_meet(p, i, c, gap1, gap2, mass1, mass2, normal1, normal2);
	*normal1 = pair_normal(c, 0, gap1, mass1, *normal1, &p->step, 1, splat(0.0f));
	*normal2 = pair_normal(c, 1, gap2, mass2, *normal2, &p->step, 1, splat(0.0f));
}

// m/s: what a point that leaves the surface at some speed has where it is, a gap above
INLINE Real bounce_speed(const Step* step, Real rebound, Real fall, Real gap)
{
	return root(maximum(rebound * rebound + 2.0f * fall * gap, splat(0.0f))) - 0.5f * step->h * fall;
}

// Restitution of the points that were pushed. What bounces leaves, so that the next step must not begin with the impulse
// of this one.
INLINE void pair_bounce(const Pools* p, int i, Pair* c, Real gap1, Real gap2, Real mass1, Real mass2, Real* normal1,
                        Real* normal2)
{
	Real zero = splat(0.0f), fall = load(&extra_at(p, fall, i), 0);
	Real rebound1 = load(&extra_at(p, rebound1, i), 0), rebound2 = load(&extra_at(p, rebound2, i), 0);
	Real total1 = load(&extra_at(p, total_impulse1, i), 0), total2 = load(&extra_at(p, total_impulse2, i), 0);
	Int hit1 = (rebound1 > zero) & (total1 > zero), hit2 = (rebound2 > zero) & (total2 > zero);
	Real lack1 = bounce_speed(&p->step, rebound1, fall, gap1) - pair_approach(*c, 0, c->n);
	Real lack2 = bounce_speed(&p->step, rebound2, fall, gap2) - pair_approach(*c, 1, c->n);
	Real alone1 = choose(zero, push_of(mass1 * lack1), hit1);
	Real alone2 = choose(zero, push_of(mass2 * lack2), hit2);
	Real impulse1, impulse2;
	pair_joint(c, mass1, mass2, lack1, lack2, &impulse1, &impulse2);
	Int push1 = impulse1 > zero, push2 = impulse2 > zero;
	impulse1 = choose(alone1, push_of(impulse1), hit1 & hit2 & push2);
	impulse2 = choose(alone2, push_of(impulse2), hit1 & hit2 & push1);
	body_push(&c->a, c->ra[0], &c->b, c->rb[0], vec_scale(impulse1, c->n));
	body_push(&c->a, c->ra[1], &c->b, c->rb[1], vec_scale(impulse2, c->n));
	store(&extra_at(p, total_impulse1, i), 0, total1 + impulse1);
	store(&extra_at(p, total_impulse2, i), 0, total2 + impulse2);
	*normal1 = choose(*normal1, zero, hit1);
	*normal2 = choose(*normal2, zero, hit2);
}

// Of max_speed: what an impulse of the last step may give a point alone. In a jam between bodies that do not give way
// impulses add up from step to step, and what is let go at last would be shot out with all of them. Of 300 bodies at one
// point, in 20 runs, the fastest leaves with 104, 92 and 95 m/s with 0.25, 0.2 and 0.15 of 400.
#define START_SHARE 0.2f

INLINE Real pair_start(const Step* step, Real impulse, Real mass)
{
	return minimum(impulse, START_SHARE * step->max_speed * mass);
}

// the impulses of the last step
INLINE void warm_start_pass(const Pools* p, int i, Pair* c)
{
	Real normal1 = load(&constraint_at(p, normal_impulse1, i), 0),
	     normal2 = load(&constraint_at(p, normal_impulse2, i), 0);
	normal1 = pair_start(&p->step, normal1, pair_mass(c, 0, c->n));
	normal2 = pair_start(&p->step, normal2, pair_mass(c, 1, c->n));
	store(&constraint_at(p, normal_impulse1, i), 0, normal1);
	store(&constraint_at(p, normal_impulse2, i), 0, normal2);
	pair_push(p, i, c, normal1, normal2, load(&constraint_at(p, tangent_impulse1, i), 0),
	          load(&constraint_at(p, tangent_impulse2, i), 0));
}

INLINE void bias_pass(const Pools* p, int i, Pair* c)
{
	Real normal1 = load(&constraint_at(p, normal_impulse1, i), 0),
	     normal2 = load(&constraint_at(p, normal_impulse2, i), 0);
	Real gap1 = pair_gap(c, 0, load(&constraint_at(p, separation1, i), 0));
	Real gap2 = pair_gap(c, 1, load(&constraint_at(p, separation2, i), 0));
	pair_bias(p, i, c, gap1, gap2, pair_mass(c, 0, c->n), pair_mass(c, 1, c->n), &normal1, &normal2);
	store(&constraint_at(p, normal_impulse1, i), 0, normal1);
	store(&constraint_at(p, normal_impulse2, i), 0, normal2);
}

INLINE void relax_pass(const Pools* p, int i, Pair* c)
{
	Real normal1 = load(&constraint_at(p, normal_impulse1, i), 0),
	     normal2 = load(&constraint_at(p, normal_impulse2, i), 0);
	Real speed = splat(0.0f), rebound1 = splat(0.0f), rebound2 = splat(0.0f);
	if (p->step.extras)
		speed = load(&extra_at(p, tangent_speed, i), 0);
	if (p->step.bounces)
	{
		rebound1 = load(&extra_at(p, rebound1, i), 0);
		rebound2 = load(&extra_at(p, rebound2, i), 0);
	}

	// friction first: keeping bodies apart matters more, so it has the last word
	Real friction = load(&constraint_at(p, friction, i), 0);
	store(&constraint_at(p, tangent_impulse1, i), 0,
	      pair_tangent(c, 0, pair_mass(c, 0, c->t), speed, friction * normal1,
	                   load(&constraint_at(p, tangent_impulse1, i), 0)));
	store(&constraint_at(p, tangent_impulse2, i), 0,
	      pair_tangent(c, 1, pair_mass(c, 1, c->t), speed, friction * normal2,
	                   load(&constraint_at(p, tangent_impulse2, i), 0)));

	Real gap1 = pair_gap(c, 0, load(&constraint_at(p, separation1, i), 0));
	normal1 = pair_normal(c, 0, gap1, pair_mass(c, 0, c->n), normal1, &p->step, 0, rebound1);
	Real gap2 = pair_gap(c, 1, load(&constraint_at(p, separation2, i), 0));
	normal2 = pair_normal(c, 1, gap2, pair_mass(c, 1, c->n), normal2, &p->step, 0, rebound2);
	store(&constraint_at(p, normal_impulse1, i), 0, normal1);
	store(&constraint_at(p, normal_impulse2, i), 0, normal2);
	if (p->step.extras)
	{
		pair_roll(p, i, c, normal1 + normal2);
		pair_total(p, i, normal1, normal2);
	}
}

INLINE void bounce_pass(const Pools* p, int i, Pair* c)
{
	Real normal1 = load(&constraint_at(p, normal_impulse1, i), 0),
	     normal2 = load(&constraint_at(p, normal_impulse2, i), 0);
	Real gap1 = pair_gap(c, 0, load(&constraint_at(p, separation1, i), 0));
	Real gap2 = pair_gap(c, 1, load(&constraint_at(p, separation2, i), 0));
	pair_bounce(p, i, c, gap1, gap2, pair_mass(c, 0, c->n), pair_mass(c, 1, c->n), &normal1, &normal2);
	store(&constraint_at(p, normal_impulse1, i), 0, normal1);
	store(&constraint_at(p, normal_impulse2, i), 0, normal2);
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

	// The limits hold for what the body does alone. The contacts' share must stay what their impulses make of it, or they
	// would take back what they have not given.
	v = vec_scale(vec_shrink(v, step->max_speed), v);
	w = within(no_infinity(w), splat(step->max_spin));
	base[0] = v.x;
	base[1] = v.y;
	base[2] = w;
	v.x = v.x + m[6] * contacts.x;
	v.y = v.y + m[7] * contacts.y;
	w = w + contacts_w;
	b[0] = v.x;
	b[1] = v.y;
	b[2] = w;
}

INLINE void body_move(const Step* step, Real* b, const Real* m)
{
	// within a substep impulses may exceed the limits. No way may: a turn beyond them could not be told from the other
	// way round, and a body would leap.
	float h = step->h;
	b[4] = b[4] + h * (m[6] * within(b[0], splat(step->max_speed)));
	b[5] = b[5] + h * (m[7] * within(b[1], splat(step->max_speed)));
	b[6] = b[6] + h * within(b[2], splat(step->max_spin));
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
