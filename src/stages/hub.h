// SPDX-License-Identifier: MIT
// hub.h -- hubs, bodies with many contacts: each is solved together with all of its contacts, exactly.
//
// This work is based on:
// Richard Tonge, Feodor Benevolenski, Andrey Voroshilov, Mass Splitting for Jitter-Free Parallel Rigid Body Simulation, 2012:
// a body that several hubs push at once is split into parts.
//
// A contact of a hub is a spoke; the body at its other end is the light end. For a given velocity of the hub each spoke has
// an answer of its own: the impulses that satisfy it, if nothing else pushes its light end. Sums of the answers, and of how
// they change with the hub's velocity, leave three equations for the hub, which Newton's method solves. docs/solver.md has
// the formulas.
#ifndef HUB_H
#define HUB_H
#include "stages/solve.h"
#include "stages/spoke.h"

// Sums over spokes have a fixed order, whoever adds: HUB_COLUMNS of them, each over every HUB_COLUMNS-th spoke, then by halves.
// As many as a group of a GPU has work-items, so that all of them take part.
#define HUB_COLUMNS 256
#define HUB_SUMS    11

// Newton's method has found the hub's velocity when a round changes it by less than this part.
#define HUB_ROUNDS 2
#define HUB_CLOSE  1.0e-5f

// A spoke answers as if its light end were lighter by this part of the hub's mass. Without it a light end that cannot move
// would be infinitely stiff; the solution is the same, for only changes of impulses are met with it. With 0.01 Newton's
// method needs more rounds.
#define HUB_YIELD 0.1f

// what is solved
#define HUB_NORMAL   0 // pushes, without softness
#define HUB_SOFT     1 // pushes that also push overlap out
#define HUB_BOUNCE   2 // restitution
#define HUB_FRICTION 3
#define HUB_ROLL     4 // rolling resistance

typedef struct // a hub at work
{
	int body, first, count;      // its spokes, padding included
	float inv_mass, inv_inertia; // of its part
	float from[3];               // velocity when the block began
	float free[3];               // the same without impulses beyond their limits
	float now[3];
	Body whole; // as the passes hold it
} Hub;

typedef struct // of the answers
{
	Real push[3];      // impulse on the hub: x, y, angular
	Real stiffness[6]; // how it changes with the hub's velocity: xx, xy, yy, xw, yw, ww
	Real slope, bend;  // of the energy along the answers
} HubSum;

typedef struct // of a spoke: how impulses of 1 at its points act
{
	Vec n;                 // on the hub along n, on the light end against it
	Real hub[2], light[2]; // arms
	Real mass, inertia;    // inverse, of the light end's part
	Real whole_mass, whole_inertia;
	Vec v; // of the light end
	Real w;
} SpokeArms;

// ---------------------------------------------------------------------------------------------------------------
// spokes
// ---------------------------------------------------------------------------------------------------------------

INLINE Body body_choose(Body a, Body b, Int c)
{
	Body r;
	r.v = vec(choose(a.v.x, b.v.x, c), choose(a.v.y, b.v.y, c));
	r.w = choose(a.w, b.w, c);
	r.inv_mass = choose(a.inv_mass, b.inv_mass, c);
	r.d = vec(choose(a.d.x, b.d.x, c), choose(a.d.y, b.d.y, c));
	r.da = choose(a.da, b.da, c);
	r.inv_inertia = choose(a.inv_inertia, b.inv_inertia, c);
	r.sine = choose(a.sine, b.sine, c);
	r.versine = choose(a.versine, b.versine, c);
	return r;
}

// Whether the hub is body b.
INLINE Int spoke_turned(const Pools* p, const Hub* h, int i)
{
	return (load_int(&constraint_at(p, body_b, i), 0) ^ h->body) == 0;
}

INLINE Int spoke_light(const Pools* p, const Hub* h, int i)
{
	return load_int(&constraint_at(p, body_a, i), 0) ^ load_int(&constraint_at(p, body_b, i), 0) ^ h->body;
}

// what the blocks of a pass need of the light end
INLINE void spoke_begin(const Pools* p, const Hub* h, int i, Body light)
{
	Pair c;
	pair_arms(p, i, &c);
	Int turned = spoke_turned(p, h, i);
	c.a = body_choose(h->whole, light, turned);
	c.b = body_choose(light, h->whole, turned);
	int k = spoke_of(p, i);
	store(&spoke_at(p, vx, k), 0, light.v.x);
	store(&spoke_at(p, vy, k), 0, light.v.y);
	store(&spoke_at(p, w, k), 0, light.w);
	store(&spoke_at(p, inv_mass, k), 0, light.inv_mass);
	store(&spoke_at(p, inv_inertia, k), 0, light.inv_inertia);
	store(&spoke_at(p, gap1, k), 0, pair_gap(&c, 0, load(&constraint_at(p, separation1, i), 0)));
	store(&spoke_at(p, gap2, k), 0, pair_gap(&c, 1, load(&constraint_at(p, separation2, i), 0)));
}

INLINE SpokeArms spoke_arms(const Pools* p, const Hub* h, int i, int what)
{
	Pair c;
	SpokeArms s;
	pair_arms(p, i, &c);
	Int turned = spoke_turned(p, h, i);
	Vec n = what == HUB_FRICTION ? c.t : c.n;
	s.n = vec(choose(-n.x, n.x, turned), choose(-n.y, n.y, turned));
	for (int k = 0; k < 2; ++k)
	{
		Real on_a = -vec_cross(c.ra[k], n), on_b = vec_cross(c.rb[k], n);
		s.hub[k] = choose(on_a, on_b, turned);
		s.light[k] = choose(on_b, on_a, turned);
	}
	if (what == HUB_ROLL)
	{
		// a torque, at one place
		s.n = vec(splat(0.0f), splat(0.0f));
		s.hub[0] = choose(splat(-1.0f), splat(1.0f), turned);
		s.light[0] = -s.hub[0];
		s.hub[1] = splat(0.0f);
		s.light[1] = splat(0.0f);
	}
	int m = spoke_of(p, i);
	Real parts = load(&spoke_at(p, parts, m), 0);
	s.whole_mass = load(&spoke_at(p, inv_mass, m), 0);
	s.whole_inertia = load(&spoke_at(p, inv_inertia, m), 0);
	s.mass = what == HUB_ROLL ? splat(0.0f) : parts * s.whole_mass;
	s.inertia = parts * s.whole_inertia;
	s.v = vec(load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0));
	s.w = load(&spoke_at(p, w, m), 0);
	return s;
}

// Impulses at both points change the light end's velocity.
INLINE void spoke_push(const Pools* p, int i, SpokeArms s, Real impulse1, Real impulse2)
{
	int m = spoke_of(p, i);
	Real both = s.mass * (impulse1 + impulse2);
	store(&spoke_at(p, vx, m), 0, s.v.x - both * s.n.x);
	store(&spoke_at(p, vy, m), 0, s.v.y - both * s.n.y);
	store(&spoke_at(p, w, m), 0, s.w + s.inertia * (s.light[0] * impulse1 + s.light[1] * impulse2));
}

INLINE void spoke_impulses(const Pools* p, int i, int what, Real old[2])
{
	if (what == HUB_ROLL)
	{
		old[0] = load(&extra_at(p, rolling_impulse, i), 0);
		old[1] = splat(0.0f);
		return;
	}
	old[0] = what == HUB_FRICTION ? load(&constraint_at(p, tangent_impulse1, i), 0)
	                              : load(&constraint_at(p, normal_impulse1, i), 0);
	old[1] = what == HUB_FRICTION ? load(&constraint_at(p, tangent_impulse2, i), 0)
	                              : load(&constraint_at(p, normal_impulse2, i), 0);
}

INLINE void spoke_keep(const Pools* p, int i, int what, Real impulse1, Real impulse2)
{
	if (what == HUB_ROLL)
	{
		store(&extra_at(p, rolling_impulse, i), 0, impulse1);
		return;
	}
	store(what == HUB_FRICTION ? &constraint_at(p, tangent_impulse1, i) : &constraint_at(p, normal_impulse1, i), 0,
	      impulse1);
	store(what == HUB_FRICTION ? &constraint_at(p, tangent_impulse2, i) : &constraint_at(p, normal_impulse2, i), 0,
	      impulse2);
}

// What holds impulses: friction and rolling resistance have a limit, and of restitution some points have no part.
INLINE void spoke_limits(const Pools* p, int i, int what, Real limit[2])
{
	Real normal[2];
	if (what == HUB_FRICTION || what == HUB_ROLL)
		spoke_impulses(p, i, HUB_NORMAL, normal);
	if (what == HUB_FRICTION)
	{
		Real friction = load(&constraint_at(p, friction, i), 0);
		limit[0] = friction * normal[0];
		limit[1] = friction * normal[1];
	}
	else if (what == HUB_ROLL)
	{
		limit[0] = load(&extra_at(p, rolling, i), 0) * (normal[0] + normal[1]);
		limit[1] = splat(0.0f);
	}
}

// The velocity that a spoke wants at point k, and by how much more than its bodies' mass an impulse is resisted.
INLINE void spoke_wants(const Pools* p, const Hub* h, int i, int what, const SpokeArms* s, int k, Real* bias,
                        Real* soft)
{
	*bias = splat(0.0f);
	*soft = splat(0.0f);
	if (what == HUB_FRICTION && p->step.extras)
		*bias = load(&extra_at(p, tangent_speed, i), 0);
	if (what == HUB_BOUNCE)
		*bias = load(&extra_at(p, restitution, i), 0) *
		        (k ? load(&extra_at(p, approach2, i), 0) : load(&extra_at(p, approach1, i), 0));
	if (what != HUB_NORMAL && what != HUB_SOFT)
		return;
	int m = spoke_of(p, i);
	Real gap = k ? load(&spoke_at(p, gap2, m), 0) : load(&spoke_at(p, gap1, m), 0);
	PairGoal goal = pair_goal(gap, s->whole_mass == splat(0.0f), &p->step, what == HUB_SOFT);
	Real resists = h->whole.inv_mass + s->whole_mass + h->whole.inv_inertia * s->hub[k] * s->hub[k] +
	               s->whole_inertia * s->light[k] * s->light[k];
	*bias = goal.bias / goal.mass_scale;
	*soft = resists * goal.impulse_scale / goal.mass_scale;
}

// whether a point takes part in restitution
INLINE Int spoke_bounces(const Pools* p, int i, int k)
{
	return pair_hit(load(&extra_at(p, restitution, i), 0),
	                k ? load(&extra_at(p, approach2, i), 0) : load(&extra_at(p, approach1, i), 0),
	                k ? load(&extra_at(p, peak_impulse2, i), 0) : load(&extra_at(p, peak_impulse1, i), 0),
	                p->step.restitution_threshold);
}

// ---------------------------------------------------------------------------------------------------------------
// a block: one kind of impulse of all spokes
// ---------------------------------------------------------------------------------------------------------------

// The problem of a spoke, laid down for as long as it is asked. Impulses beyond their limits are taken back at once, for no
// solution may keep them; taken is the sum of what that does to the hub.
INLINE void spoke_pose(const Pools* p, const Hub* h, int i, int what, Real taken[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	Real old[2], limit[2] = {splat(0.0f), splat(0.0f)}, mass[2], slope[2];
	spoke_impulses(p, i, what, old);
	int limited = what == HUB_FRICTION || what == HUB_ROLL, m = spoke_of(p, i);
	if (limited)
	{
		spoke_limits(p, i, what, limit);
		Real beyond[2];
		for (int k = 0; k < 2; ++k)
		{
			Real held = minimum(maximum(old[k], -limit[k]), limit[k]);
			beyond[k] = held - old[k];
			old[k] = held;
		}
		spoke_push(p, i, s, beyond[0], beyond[1]);
		s.v = vec(load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0));
		s.w = load(&spoke_at(p, w, m), 0);
		taken[0] += s.n.x * (beyond[0] + beyond[1]);
		taken[1] += s.n.y * (beyond[0] + beyond[1]);
		taken[2] += s.hub[0] * beyond[0] + s.hub[1] * beyond[1];
	}

	Real cross = s.mass + s.inertia * s.light[0] * s.light[1];
	for (int k = 0; k < 2; ++k)
	{
		Real bias, soft;
		spoke_wants(p, h, i, what, &s, k, &bias, &soft);
		Real hub_mass = what == HUB_ROLL ? splat(0.0f) : splat(h->inv_mass);
		// a little more than the mass itself, so that two points in one place have an answer
		mass[k] = 1.0001f * (s.mass + s.inertia * s.light[k] * s.light[k]) +
		          HUB_YIELD * (hub_mass + h->inv_inertia * s.hub[k] * s.hub[k]) + soft;
		Real speed =
		    s.n.x * (h->from[0] - s.v.x) + s.n.y * (h->from[1] - s.v.y) + s.hub[k] * h->from[2] + s.light[k] * s.w;
		slope[k] = speed + bias + soft * old[k];
	}
	if (limited)
	{
		// points side by side resist together: each is as heavy as both
		Real together = choose(splat(0.0f), absolute(cross), (limit[0] > splat(0.0f)) & (limit[1] > splat(0.0f)));
		mass[0] += together;
		mass[1] += together;
		store(&spoke_at(p, limit1, m), 0, limit[0]);
		store(&spoke_at(p, limit2, m), 0, limit[1]);
	}
	if (what == HUB_BOUNCE)
	{
		Int hit1 = spoke_bounces(p, i, 0), hit2 = spoke_bounces(p, i, 1);
		store(&spoke_at(p, limit1, m), 0, choose(splat(0.0f), splat(1.0f), hit1));
		store(&spoke_at(p, limit2, m), 0, choose(splat(0.0f), splat(1.0f), hit2));
		cross = choose(splat(0.0f), cross, hit1 & hit2);
	}
	store(&spoke_at(p, push_x, m), 0, s.n.x);
	store(&spoke_at(p, push_y, m), 0, s.n.y);
	store(&spoke_at(p, arm1, m), 0, s.hub[0]);
	store(&spoke_at(p, arm2, m), 0, s.hub[1]);
	store(&spoke_at(p, slope1, m), 0, slope[0]);
	store(&spoke_at(p, slope2, m), 0, slope[1]);
	store(&spoke_at(p, mass1, m), 0, mass[0]);
	store(&spoke_at(p, mass2, m), 0, mass[1]);
	store(&spoke_at(p, cross, m), 0, cross);
	store(&spoke_at(p, inverse1, m), 0, choose(splat(0.0f), 1.0f / mass[0], mass[0] > splat(0.0f)));
	store(&spoke_at(p, inverse2, m), 0, choose(splat(0.0f), 1.0f / mass[1], mass[1] > splat(0.0f)));
	if (!limited)
		store(&spoke_at(p, inverse, m), 0, 1.0f / (mass[0] * mass[1] - cross * cross));
	store(&spoke_at(p, old1, m), 0, old[0]);
	store(&spoke_at(p, old2, m), 0, old[1]);
}

// The impulses of the last step, all at once.
INLINE void spoke_warm(const Pools* p, const Hub* h, int i, int what, Real push[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	Real old[2];
	spoke_impulses(p, i, what, old);
	spoke_push(p, i, s, old[0], old[1]);
	push[0] += s.n.x * (old[0] + old[1]);
	push[1] += s.n.y * (old[0] + old[1]);
	push[2] += s.hub[0] * old[0] + s.hub[1] * old[1];
}

typedef struct // impulses, and how they change against the hub's velocity at each point
{
	Real impulse[2], own[2], cross;
} SpokeAnswer;

// Pushes that never pull: where both are positive they solve both equations, else one of them alone. want is what the
// points would do without any impulse.
INLINE SpokeAnswer spoke_push_apart(const Pools* p, int m, Real want1, Real want2)
{
	SpokeAnswer r;
	Real zero = splat(0.0f), inverse = load(&spoke_at(p, inverse, m), 0),
	     cross = inverse * load(&spoke_at(p, cross, m), 0);
	Real own1 = inverse * load(&spoke_at(p, mass2, m), 0), own2 = inverse * load(&spoke_at(p, mass1, m), 0);
	Real single1 = load(&spoke_at(p, inverse1, m), 0), single2 = load(&spoke_at(p, inverse2, m), 0);
	Real first = cross * want2 - own1 * want1, second = cross * want1 - own2 * want2;
	Int good1 = first >= zero, good2 = second >= zero, both = good1 & good2;
	Real alone1 = choose(maximum(-single1 * want1, zero), zero, good2);
	Real alone2 = choose(maximum(-single2 * want2, zero), zero, good1);
	r.impulse[0] = choose(alone1, first, both);
	r.impulse[1] = choose(alone2, second, both);
	r.own[0] = choose(choose(zero, single1, alone1 > zero), own1, both);
	r.own[1] = choose(choose(zero, single2, alone2 > zero), own2, both);
	r.cross = choose(zero, -cross, both);
	return r;
}

// Impulses within limits, each on its own.
INLINE SpokeAnswer spoke_hold(const Pools* p, int m, const Real slope[2], const Real old[2])
{
	SpokeAnswer r;
	Real zero = splat(0.0f);
	Real limit[2] = {load(&spoke_at(p, limit1, m), 0), load(&spoke_at(p, limit2, m), 0)};
	Real inverse[2] = {load(&spoke_at(p, inverse1, m), 0), load(&spoke_at(p, inverse2, m), 0)};
	for (int k = 0; k < 2; ++k)
	{
		Real wanted = old[k] - inverse[k] * slope[k];
		r.impulse[k] = minimum(maximum(wanted, -limit[k]), limit[k]);
		r.own[k] = choose(zero, inverse[k], (wanted == r.impulse[k]) & (limit[k] > zero));
	}
	r.cross = zero;
	return r;
}

// What a spoke answers to the hub's velocity.
INLINE void spoke_answer(const Pools* p, const Hub* h, int i, int what, HubSum* sum)
{
	int m = spoke_of(p, i);
	Real x = load(&spoke_at(p, push_x, m), 0), y = load(&spoke_at(p, push_y, m), 0);
	Real arm[2] = {load(&spoke_at(p, arm1, m), 0), load(&spoke_at(p, arm2, m), 0)};
	Real old[2] = {load(&spoke_at(p, old1, m), 0), load(&spoke_at(p, old2, m), 0)};
	Real mass[2] = {load(&spoke_at(p, mass1, m), 0), load(&spoke_at(p, mass2, m), 0)};
	Real slope[2] = {load(&spoke_at(p, slope1, m), 0), load(&spoke_at(p, slope2, m), 0)};
	Real cross = load(&spoke_at(p, cross, m), 0);
	float dx = h->now[0] - h->from[0], dy = h->now[1] - h->from[1], dw = h->now[2] - h->from[2];
	float fx = h->free[0] - h->from[0], fy = h->free[1] - h->from[1], fw = h->free[2] - h->from[2];
	Real faster = x * dx + y * dy, at[2] = {slope[0] + (faster + arm[0] * dw), slope[1] + (faster + arm[1] * dw)};

	SpokeAnswer r;
	if (what == HUB_FRICTION || what == HUB_ROLL)
		r = spoke_hold(p, m, at, old);
	else
		r = spoke_push_apart(p, m, at[0] - mass[0] * old[0] - cross * old[1],
		                     at[1] - mass[1] * old[1] - cross * old[0]);
	if (what == HUB_BOUNCE)
	{
		Real takes[2] = {load(&spoke_at(p, limit1, m), 0), load(&spoke_at(p, limit2, m), 0)};
		for (int k = 0; k < 2; ++k)
		{
			r.impulse[k] = choose(old[k], r.impulse[k], takes[k] > splat(0.0f));
			r.own[k] = takes[k] * r.own[k];
		}
		r.cross = takes[0] * takes[1] * r.cross;
	}
	store(&spoke_at(p, new1, m), 0, r.impulse[0]);
	store(&spoke_at(p, new2, m), 0, r.impulse[1]);

	Real change[2] = {r.impulse[0] - old[0], r.impulse[1] - old[1]}, both = change[0] + change[1];
	sum->push[0] += x * both;
	sum->push[1] += y * both;
	sum->push[2] += arm[0] * change[0] + arm[1] * change[1];
	Real stiff = r.own[0] + r.own[1] + 2.0f * r.cross;
	Real lever = r.own[0] * arm[0] + r.own[1] * arm[1] + r.cross * (arm[0] + arm[1]);
	sum->stiffness[0] += x * x * stiff;
	sum->stiffness[1] += x * y * stiff;
	sum->stiffness[2] += y * y * stiff;
	sum->stiffness[3] += x * lever;
	sum->stiffness[4] += y * lever;
	sum->stiffness[5] += r.own[0] * arm[0] * arm[0] + r.own[1] * arm[1] * arm[1] + 2.0f * r.cross * arm[0] * arm[1];
	Real freely = x * fx + y * fy;
	sum->slope += change[0] * (slope[0] + (freely + arm[0] * fw)) + change[1] * (slope[1] + (freely + arm[1] * fw));
	sum->bend +=
	    mass[0] * change[0] * change[0] + mass[1] * change[1] * change[1] + 2.0f * cross * change[0] * change[1];
}

// A spoke gives a part of its answer.
INLINE void spoke_give(const Pools* p, const Hub* h, int i, int what, float part)
{
	int m = spoke_of(p, i);
	Real old[2] = {load(&spoke_at(p, old1, m), 0), load(&spoke_at(p, old2, m), 0)};
	Real change1 = part * (load(&spoke_at(p, new1, m), 0) - old[0]),
	     change2 = part * (load(&spoke_at(p, new2, m), 0) - old[1]);
	spoke_push(p, i, spoke_arms(p, h, i, what), change1, change2);
	old[0] = old[0] + change1;
	old[1] = old[1] + change2;
	if (what != HUB_FRICTION && what != HUB_ROLL)
	{
		// a part of 1 may leave what rounding leaves
		old[0] = maximum(old[0], splat(0.0f));
		old[1] = maximum(old[1], splat(0.0f));
	}
	spoke_keep(p, i, what, old[0], old[1]);
}

// ---------------------------------------------------------------------------------------------------------------
// hubs
// ---------------------------------------------------------------------------------------------------------------

// Goes over the spokes k of hub h, in columns.
#define HUB_EACH_COLUMN(c, h) for (int c = group_lane(); c < HUB_COLUMNS && c < (h)->count; c += group_width())
#define HUB_EACH_OF(k, c, h)  for (int k = (h)->first + c; k < (h)->first + (h)->count; k += HUB_COLUMNS)

// Adds up the columns of the bench, by halves, for each of so many sums.
INLINE void hub_add_up(const Hub* h, int sums, BENCH float* bench)
{
	int used = h->count < HUB_COLUMNS ? h->count : HUB_COLUMNS;
	int span = HUB_COLUMNS / 2;
	while (span >= used)
		span /= 2;
	for (; span > 0; span /= 2)
	{
		group_meet();
		if (span >= LANES)
			for (int c = group_lane(); c < span && c + span < used; c += group_width())
				for (int q = 0; q < sums; ++q)
				{
					BENCH float* column = bench + q * HUB_COLUMNS + c;
					store(column, 0, load(column, 0) + load(column, span));
				}
		else
			for (int q = 0; q < sums; ++q)
				for (int c = 0; c < span; ++c)
					bench[q * HUB_COLUMNS + c] += bench[q * HUB_COLUMNS + c + span];
		used = span;
	}
	group_meet();
}

// Lays down the problems of all spokes, or the impulses of the last step where warm is set.
INLINE void hub_pose(const Pools* p, const Hub* h, int what, int warm, BENCH float* bench)
{
	HUB_EACH_COLUMN(c, h)
	{
		Real push[3] = {splat(0.0f), splat(0.0f), splat(0.0f)};
		HUB_EACH_OF(i, c, h)
		if (warm)
			spoke_warm(p, h, i, what, push);
		else
			spoke_pose(p, h, i, what, push);
		for (int q = 0; q < 3; ++q)
			store(bench + q * HUB_COLUMNS, c, push[q]);
	}
}

// All spokes answer to the hub's velocity.
INLINE void hub_ask(const Pools* p, const Hub* h, int what, BENCH float* bench)
{
	HUB_EACH_COLUMN(c, h)
	{
		HubSum part;
		Real zero = splat(0.0f);
		for (int q = 0; q < 3; ++q)
			part.push[q] = zero;
		for (int q = 0; q < 6; ++q)
			part.stiffness[q] = zero;
		part.slope = part.bend = zero;
		HUB_EACH_OF(i, c, h) spoke_answer(p, h, i, what, &part);
		for (int q = 0; q < 3; ++q)
			store(bench + q * HUB_COLUMNS, c, part.push[q]);
		for (int q = 0; q < 6; ++q)
			store(bench + (3 + q) * HUB_COLUMNS, c, part.stiffness[q]);
		store(bench + 9 * HUB_COLUMNS, c, part.slope);
		store(bench + 10 * HUB_COLUMNS, c, part.bend);
	}
}

INLINE float hub_mass(const Hub* h) { return 1.0f / h->inv_mass; }
INLINE float hub_inertia(const Hub* h) { return h->inv_inertia > 0.0f ? 1.0f / h->inv_inertia : 0.0f; }

// twice the kinetic energy of a velocity
INLINE float hub_energy(const Hub* h, const float v[3])
{
	return hub_mass(h) * (v[0] * v[0] + v[1] * v[1]) + hub_inertia(h) * v[2] * v[2];
}

// The step of Newton's method: (M + H) d = push - M (now - free), by L D L^T.
INLINE void hub_newton(const Hub* h, const float* sum, float d[3])
{
	float mass = hub_mass(h), inertia = hub_inertia(h);
	float xx = mass + sum[3], xy = sum[4], yy = mass + sum[5], xw = sum[6], yw = sum[7], ww = inertia + sum[8];
	float x = sum[0] - mass * (h->now[0] - h->free[0]), y = sum[1] - mass * (h->now[1] - h->free[1]),
	      w = sum[2] - inertia * (h->now[2] - h->free[2]);
	float yx = xy / xx, wx = xw / xx, second = yy - yx * xy, wy = (yw - yx * xw) / second;
	float third = ww - wx * xw - wy * wy * second;
	y = y - yx * x;
	w = w - wx * x - wy * y;
	// what cannot turn has no third equation
	d[2] = inertia > 0.0f ? w / third : 0.0f;
	d[1] = y / second - wy * d[2];
	d[0] = x / xx - yx * d[1] - wx * d[2];
}

// Whether the hub's velocity has been found: no round changes it much any more, against what it is or a substep of gravity.
INLINE int hub_found(const Step* step, const Hub* h, const float d[3])
{
	float fall[3] = {step->h * step->gravity_x, step->h * step->gravity_y, 0.0f};
	return !(hub_energy(h, d) > HUB_CLOSE * HUB_CLOSE * (hub_energy(h, h->now) + hub_energy(h, fall)));
}

// All spokes give the same part of their answers, the one that leaves least energy: all of it when the hub's velocity was
// found, and never so much that an unfinished search adds energy.
INLINE void hub_give(const Pools* p, Hub* h, int what, const float* sum)
{
	float bend = sum[10] + h->inv_mass * (sum[0] * sum[0] + sum[1] * sum[1]) + h->inv_inertia * sum[2] * sum[2];
	float part = bend > 0.0f ? -sum[9] / bend : 0.0f;
	part = part < 1.0f ? part : 1.0f;
	part = part > 0.0f ? part : 0.0f;
	HUB_EACH_COLUMN(c, h)
	HUB_EACH_OF(i, c, h) spoke_give(p, h, i, what, part);
	h->now[0] = h->free[0] + part * (h->inv_mass * sum[0]);
	h->now[1] = h->free[1] + part * (h->inv_mass * sum[1]);
	h->now[2] = h->free[2] + part * (h->inv_inertia * sum[2]);
}

// A block: impulses of one kind of all spokes, and the velocity that they leave the hub with. There is one place where sums
// are added up: each more takes a compiler of OpenCL for CPUs minutes.
INLINE void hub_block(const Pools* p, Hub* h, int what, int warm, BENCH float* bench)
{
	float sum[HUB_SUMS], d[3];
	for (int q = 0; q < 3; ++q)
		h->from[q] = h->free[q] = h->now[q];
	int found = 0;
	for (int round = -1; round <= (warm ? -1 : HUB_ROUNDS) && !found; ++round)
	{
		if (round < 0)
			hub_pose(p, h, what, warm, bench);
		else
			hub_ask(p, h, what, bench);
		int sums = round < 0 ? 3 : HUB_SUMS;
		hub_add_up(h, sums, bench);
		for (int q = 0; q < sums; ++q)
			sum[q] = bench[q * HUB_COLUMNS];
		group_meet();
		if (round < 0)
		{
			h->free[0] += h->inv_mass * sum[0];
			h->free[1] += h->inv_mass * sum[1];
			h->free[2] += h->inv_inertia * sum[2];
			for (int q = 0; q < 3; ++q)
				h->now[q] = h->free[q];
		}
		else if (round < HUB_ROUNDS)
		{
			hub_newton(h, sum, d);
			found = hub_found(&p->step, h, d);
			for (int q = 0; q < 3; ++q)
				h->now[q] = found ? h->now[q] : h->now[q] + d[q];
		}
	}
	if (!warm)
		hub_give(p, h, what, sum);
}

// The kind of block number k of a pass, -1 behind the last.
INLINE int hub_what(const Step* step, int pass, int k)
{
	// friction first, as in relax_pass; rolling resistance last, by the load that is left
	if (pass == HUB_WARM_START || pass == HUB_RELAX)
		return k == 0 ? HUB_FRICTION : k == 1 ? HUB_NORMAL : k == 2 && step->extras ? HUB_ROLL : -1;
	return k > 0 ? -1 : pass == HUB_BIAS ? HUB_SOFT : HUB_BOUNCE;
}

// A pass over the spokes of a hub whose light ends are known (spoke_begin).
INLINE void hub_work(const Pools* p, Hub* h, int pass, BENCH float* bench)
{
	for (int k = 0, what = 0; what >= 0; ++k)
	{
		what = hub_what(&p->step, pass, k);
		if (what >= 0)
			hub_block(p, h, what, pass == HUB_WARM_START, bench);
	}
	if (pass == HUB_RELAX && p->step.extras)
		HUB_EACH_COLUMN(c, h)
	HUB_EACH_OF(i, c, h)
	pair_peak(p, i, load(&constraint_at(p, normal_impulse1, i), 0), load(&constraint_at(p, normal_impulse2, i), 0));
}

// Hub number n, with its body as it is now.
INLINE Hub hub_begin(const Pools* p, int n, const float row[8])
{
	Hub h;
	HubSpan span = hub_span_of(p, n);
	float parts = spoke_at(p, hub_parts, spoke_of(p, span.first));
	h.body = span.body;
	h.first = span.first;
	h.count = span.count;
	h.inv_mass = parts * row[3];
	h.inv_inertia = parts * row[7];
	for (int q = 0; q < 3; ++q)
		h.now[q] = row[q];
	h.whole.v = vec(splat(row[0]), splat(row[1]));
	h.whole.w = splat(row[2]);
	h.whole.inv_mass = splat(row[3]);
	h.whole.d = vec(splat(row[4]), splat(row[5]));
	h.whole.da = splat(row[6]);
	h.whole.inv_inertia = splat(row[7]);
	body_turn(&h.whole);
	return h;
}

// A light end goes back where it came from. What is split into parts leaves the change of this one to hub_merge.
INLINE void spoke_end(const Pools* p, const Hub* h, int i)
{
	int m = spoke_of(p, i);
	Real row[4] = {load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0), load(&spoke_at(p, w, m), 0),
	               load(&spoke_at(p, inv_mass, m), 0)};
	Int whole = load(&spoke_at(p, parts, m), 0) == splat(1.0f);
	scatter_rows4of8((GLOBAL float*)p->body, spoke_light(p, h, i), row, whole & (row[3] > splat(0.0f)));
}

// A pass over hub n by a group, with bodies in their pool.
INLINE void hub_pass(const Pools* p, int n, int pass, BENCH float* bench)
{
	float row[8];
	read_row8((GLOBAL float*)p->body, hub_span_of(p, n).body, row);
	Hub h = hub_begin(p, n, row);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h) spoke_begin(p, &h, i, body_gather(p, spoke_light(p, &h, i)));
	hub_work(p, &h, pass, bench);
	HUB_EACH_COLUMN(c, &h)
	HUB_EACH_OF(i, c, &h) spoke_end(p, &h, i);
	if (group_lane() != 0)
		return;
	int m = spoke_of(p, h.first);
	spoke_at(p, hub_x, m) = h.now[0];
	spoke_at(p, hub_y, m) = h.now[1];
	spoke_at(p, hub_w, m) = h.now[2];
	if (spoke_at(p, hub_parts, m) == 1.0f)
	{
		p->body[h.body].vx = h.now[0];
		p->body[h.body].vy = h.now[1];
		p->body[h.body].w = h.now[2];
	}
}

// argument is the pass
GROUP_STAGE(hub) { hub_pass(p, i, p->argument, bench); }

#endif
