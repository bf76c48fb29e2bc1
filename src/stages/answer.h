// SPDX-License-Identifier: MIT
// answer.h -- what a spoke answers: the impulses that satisfy it while its hub keeps a velocity and nothing else pushes its
// light end.
//
// docs/solver.md has the formulas.
#ifndef ANSWER_H
#define ANSWER_H
#include "constraints/kinds.h"
#include "stages/spoke.h"

// A spoke answers as if its light end had this part of the hub's inverse mass more. Without it a light end that cannot move
// would be infinitely stiff. The solution is the same, for only changes of impulses meet it.
#define HUB_YIELD 0.1f

// The same of restitution, which is asked once: no later pass makes good what this holds back.
#define BOUNCE_YIELD 0.001f

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
	float mass, inertia;         // the same; an inertia of 0 does not turn
	float gyration;              // m^2, inertia over mass
	float most;                  // what a spoke may add to a sum: with all of them it is a float
	float from[3];               // velocity when the block began
	float free[3];               // the same without impulses beyond their limits
	float now[3];
	Body whole; // as the passes hold it
} Hub;

// Sums of the answers: 0 to 2 impulse on the hub (x, y, angular), 3 to 8 how it changes with the hub's velocity (xx, xy, yy, xw,
// yw, ww), 9 and 10 slope and bend of the energy along the answers.
#define HUB_SUMS 11

// 1/kg: what an impulse moves less than this does not move; its inverse is a float
#define LEAST_RESISTS 1.0e-37f

// m/s, rad/s: what is faster is solved no more
#define HUB_SPEED 1.0e12f

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
	return (load_int(&contact_row(p, body_b, i), 0) ^ h->body) == 0;
}

INLINE Int spoke_light(const Pools* p, const Hub* h, int i)
{
	return load_int(&contact_row(p, body_a, i), 0) ^ load_int(&contact_row(p, body_b, i), 0) ^ h->body;
}

// what the blocks of a pass need of the light end
INLINE void spoke_begin(const Pools* p, const Hub* h, int i, Body light)
{
	Contact u;
	contact_load(p, i, PASS_BIAS, &u);
	Int turned = spoke_turned(p, h, i);
	Body a = body_choose(h->whole, light, turned), b = body_choose(light, h->whole, turned);
	contact_ready(&a, &b, &u);
	int k = spoke_of(p, i);
	store(&spoke_at(p, vx, k), 0, light.v.x);
	store(&spoke_at(p, vy, k), 0, light.v.y);
	store(&spoke_at(p, w, k), 0, light.w);
	store(&spoke_at(p, inv_mass, k), 0, light.inv_mass);
	store(&spoke_at(p, inv_inertia, k), 0, light.inv_inertia);
	store(&spoke_at(p, gap1, k), 0, u.gap1);
	store(&spoke_at(p, gap2, k), 0, u.gap2);
}

INLINE SpokeArms spoke_arms(const Pools* p, const Hub* h, int i, int what)
{
	Contact u;
	SpokeArms s;
	contact_load(p, i, PREPARE_BOUNCE, &u);
	ContactArms c = pair_of(&u, &h->whole, &h->whole);
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

// Whether a spoke may add x to a sum. Not a number is not within.
INLINE Int spoke_adds(const Hub* h, Real x) { return (x >= splat(-h->most)) & (x <= splat(h->most)); }

// What impulses at both points add to the hub's sums; and whether that, and the velocity that they give the light end, is
// finite.
INLINE Int spoke_sum(const Hub* h, const SpokeArms* s, const Real impulse[2], Real push[3])
{
	Real both = impulse[0] + impulse[1];
	push[0] = s->n.x * both;
	push[1] = s->n.y * both;
	push[2] = s->hub[0] * impulse[0] + s->hub[1] * impulse[1];
	Int adds = spoke_adds(h, push[0]) & spoke_adds(h, push[1]) & spoke_adds(h, push[2]);
	for (int k = 0; k < 2; ++k)
		adds = adds & spoke_adds(h, impulse[k]) &
		       spoke_adds(h, (s->mass + s->inertia * s->light[k] * s->light[k]) * impulse[k] * impulse[k]);
	return adds;
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
	if (what == HUB_ROLL || what == HUB_BOUNCE)
	{
		old[0] = what == HUB_ROLL ? load(&contact_rare(p, rolling_impulse, i), 0) : splat(0.0f);
		old[1] = splat(0.0f);
		return;
	}
	old[0] = what == HUB_FRICTION ? load(&contact_row(p, tangent_impulse1, i), 0)
	                              : load(&contact_row(p, normal_impulse1, i), 0);
	old[1] = what == HUB_FRICTION ? load(&contact_row(p, tangent_impulse2, i), 0)
	                              : load(&contact_row(p, normal_impulse2, i), 0);
}

// What bounces leaves, so that the next step must not begin with the impulse of this one.
INLINE void spoke_keep_bounce(const Pools* p, int i, Real impulse1, Real impulse2)
{
	int m = spoke_of(p, i);
	Real zero = splat(0.0f), normal1 = load(&contact_row(p, normal_impulse1, i), 0),
	     normal2 = load(&contact_row(p, normal_impulse2, i), 0);
	pair_total(p, i, impulse1, impulse2);
	store(&contact_row(p, normal_impulse1, i), 0, choose(normal1, zero, load(&spoke_at(p, limit1, m), 0) > zero));
	store(&contact_row(p, normal_impulse2, i), 0, choose(normal2, zero, load(&spoke_at(p, limit2, m), 0) > zero));
}

INLINE void spoke_keep(const Pools* p, int i, int what, Real impulse1, Real impulse2)
{
	if (what == HUB_BOUNCE)
	{
		spoke_keep_bounce(p, i, impulse1, impulse2);
		return;
	}
	if (what == HUB_ROLL)
	{
		store(&contact_rare(p, rolling_impulse, i), 0, impulse1);
		return;
	}
	store(what == HUB_FRICTION ? &contact_row(p, tangent_impulse1, i) : &contact_row(p, normal_impulse1, i), 0,
	      impulse1);
	store(what == HUB_FRICTION ? &contact_row(p, tangent_impulse2, i) : &contact_row(p, normal_impulse2, i), 0,
	      impulse2);
}

// what friction and rolling resistance hold at most
INLINE void spoke_limits(const Pools* p, int i, int what, Real limit[2])
{
	Real normal[2];
	if (what == HUB_FRICTION || what == HUB_ROLL)
		spoke_impulses(p, i, HUB_NORMAL, normal);
	if (what == HUB_FRICTION)
	{
		Real friction = load(&contact_row(p, friction, i), 0);
		limit[0] = friction * normal[0];
		limit[1] = friction * normal[1];
	}
	else if (what == HUB_ROLL)
	{
		limit[0] = minimum(load(&contact_rare(p, rolling, i), 0) * (normal[0] + normal[1]), splat(MOST_IMPULSE));
		limit[1] = splat(0.0f);
	}
}

INLINE Real spoke_gap(const Pools* p, int i, int k)
{
	int m = spoke_of(p, i);
	return k ? load(&spoke_at(p, gap2, m), 0) : load(&spoke_at(p, gap1, m), 0);
}

INLINE Real spoke_rebound(const Pools* p, int i, int k)
{
	return k ? load(&contact_rare(p, rebound2, i), 0) : load(&contact_rare(p, rebound1, i), 0);
}

// 1/kg: the velocity that an impulse of 1 gives the whole of both bodies at point k, against each other
INLINE Real spoke_resists(const Hub* h, const SpokeArms* s, int k)
{
	return h->whole.inv_mass + s->whole_mass + h->whole.inv_inertia * s->hub[k] * s->hub[k] +
	       s->whole_inertia * s->light[k] * s->light[k];
}

// The velocity that a spoke wants at point k, and by how much more than its bodies' mass an impulse is resisted.
INLINE void spoke_wants(const Pools* p, const Hub* h, int i, int what, const SpokeArms* s, int k, Real* bias,
                        Real* soft)
{
	*bias = splat(0.0f);
	*soft = splat(0.0f);
	if (what == HUB_FRICTION && p->step.rolls)
		*bias = load(&contact_rare(p, tangent_speed, i), 0);
	if (what == HUB_FRICTION || what == HUB_ROLL)
		return;
	Real gap = spoke_gap(p, i, k);
	if (what == HUB_BOUNCE)
	{
		*bias = -bounce_speed(&p->step, spoke_rebound(p, i, k), load(&contact_rare(p, fall, i), 0), gap);
		return;
	}
	PairGoal goal = pair_goal(gap, s->whole_mass == splat(0.0f), &p->step, what == HUB_SOFT);
	*bias = goal.bias / goal.mass_scale;
	*soft = spoke_resists(h, s, k) * goal.impulse_scale / goal.mass_scale;
}

// Whether only some points take part in a block: in restitution those that were pushed, and in relaxing not those that are
// to bounce and have not met yet.
INLINE int spoke_chooses(const Pools* p, int what)
{
	return what == HUB_BOUNCE || (what == HUB_NORMAL && p->step.bounces);
}

// 1 where point k takes part, else 0
INLINE Real spoke_takes_part(const Pools* p, int i, int what, int k, Real old)
{
	Real zero = splat(0.0f), one = splat(1.0f), rebound = spoke_rebound(p, i, k);
	if (what == HUB_NORMAL)
		return choose(one, zero, pair_waits(spoke_gap(p, i, k), old, rebound));
	Real total = k ? load(&contact_rare(p, total_impulse2, i), 0) : load(&contact_rare(p, total_impulse1, i), 0);
	return choose(zero, one, (rebound > zero) & (total > zero));
}

// ---------------------------------------------------------------------------------------------------------------
// a block: one kind of impulse of all spokes
// ---------------------------------------------------------------------------------------------------------------

// m/s: at which the points of a spoke part
INLINE void spoke_speeds(const Hub* h, const SpokeArms* s, Real speed[2])
{
	for (int k = 0; k < 2; ++k)
		speed[k] = s->n.x * (h->from[0] - s->v.x) + s->n.y * (h->from[1] - s->v.y) + s->hub[k] * h->from[2] +
		           s->light[k] * s->w;
}

// The problem of a spoke, laid down for as long as it is asked. Impulses beyond their limits are taken back at once, for no
// solution may keep them, and so are those of a spoke whose velocity is no number or beyond HUB_SPEED, which has no other
// answer; taken is the sum of what that does to the hub.
INLINE void spoke_pose(const Pools* p, const Hub* h, int i, int what, Real taken[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	Real zero = splat(0.0f), most = splat(HUB_SPEED), limit[2] = {zero, zero};
	Real old[2], held[2], beyond[2], push[3], speed[2], mass[2], inverse[2], slope[2];
	spoke_impulses(p, i, what, old);
	spoke_speeds(h, &s, speed);
	Int well0 = absolute(speed[0]) <= most, well1 = absolute(speed[1]) <= most, well = well0 & well1;
	int limited = what == HUB_FRICTION || what == HUB_ROLL, m = spoke_of(p, i);
	spoke_limits(p, i, what, limit);
	for (int k = 0; k < 2; ++k)
	{
		limit[k] = choose(zero, limit[k], well);
		held[k] = choose(zero, limited ? grip_of(old[k], limit[k]) : old[k], well);
		beyond[k] = held[k] - old[k];
	}
	Int adds = spoke_sum(h, &s, beyond, push);
	for (int k = 0; k < 2; ++k)
	{
		beyond[k] = choose(zero, beyond[k], adds);
		old[k] = choose(old[k], held[k], adds);
	}
	for (int q = 0; q < 3; ++q)
		taken[q] += choose(zero, push[q], adds);
	spoke_push(p, i, s, beyond[0], beyond[1]);
	s.v = vec(load(&spoke_at(p, vx, m), 0), load(&spoke_at(p, vy, m), 0));
	s.w = load(&spoke_at(p, w, m), 0);

	Real cross = s.mass + s.inertia * s.light[0] * s.light[1];
	float yield = what == HUB_BOUNCE ? BOUNCE_YIELD : HUB_YIELD;
	spoke_speeds(h, &s, speed);
	for (int k = 0; k < 2; ++k)
	{
		Real bias, soft;
		spoke_wants(p, h, i, what, &s, k, &bias, &soft);
		Real hub_mass = what == HUB_ROLL ? zero : splat(h->inv_mass);
		// a little more than the mass itself, so that two points in one place have an answer
		mass[k] = 1.0001f * (s.mass + s.inertia * s.light[k] * s.light[k]) +
		          yield * (hub_mass + h->inv_inertia * s.hub[k] * s.hub[k]) + soft;
		slope[k] = speed[k] + bias + soft * old[k];
		well = well & (absolute(slope[k]) <= most) & (mass[k] <= splat(MOST_FLOAT));
	}
	cross = choose(zero, cross, well);
	for (int k = 0; k < 2; ++k)
	{
		mass[k] = choose(zero, mass[k], well);
		slope[k] = choose(zero, slope[k], well);
	}
	if (limited)
	{
		// points side by side resist together: each is as heavy as both
		Real together = choose(zero, absolute(cross), (limit[0] > zero) & (limit[1] > zero));
		mass[0] += together;
		mass[1] += together;
		store(&spoke_at(p, limit1, m), 0, limit[0]);
		store(&spoke_at(p, limit2, m), 0, limit[1]);
	}
	else if (spoke_chooses(p, what))
	{
		Real takes1 = spoke_takes_part(p, i, what, 0, old[0]), takes2 = spoke_takes_part(p, i, what, 1, old[1]);
		store(&spoke_at(p, limit1, m), 0, takes1);
		store(&spoke_at(p, limit2, m), 0, takes2);
		cross = takes1 * takes2 * cross;
	}
	for (int k = 0; k < 2; ++k)
		inverse[k] = choose(zero, 1.0f / mass[k], mass[k] > splat(LEAST_RESISTS));
	store(&spoke_at(p, push_x, m), 0, s.n.x);
	store(&spoke_at(p, push_y, m), 0, s.n.y);
	store(&spoke_at(p, arm1, m), 0, s.hub[0]);
	store(&spoke_at(p, arm2, m), 0, s.hub[1]);
	store(&spoke_at(p, slope1, m), 0, slope[0]);
	store(&spoke_at(p, slope2, m), 0, slope[1]);
	store(&spoke_at(p, mass1, m), 0, mass[0]);
	store(&spoke_at(p, mass2, m), 0, mass[1]);
	store(&spoke_at(p, cross, m), 0, cross);
	store(&spoke_at(p, inverse1, m), 0, inverse[0]);
	store(&spoke_at(p, inverse2, m), 0, inverse[1]);
	if (!limited)
		store(&spoke_at(p, inverse, m), 0, 1.0f / (1.0f - cross * inverse[0] * (cross * inverse[1])));
	store(&spoke_at(p, old1, m), 0, old[0]);
	store(&spoke_at(p, old2, m), 0, old[1]);
}

// The impulses of the last step, all at once.
INLINE void spoke_warm(const Pools* p, const Hub* h, int i, int what, Real push[3])
{
	SpokeArms s = spoke_arms(p, h, i, what);
	Real old[2];
	spoke_impulses(p, i, what, old);
	if (what == HUB_NORMAL)
	{
		for (int k = 0; k < 2; ++k)
		{
			Real resists =
			    h->inv_mass + s.mass + h->inv_inertia * s.hub[k] * s.hub[k] + s.inertia * s.light[k] * s.light[k];
			old[k] = pair_start(&p->step, old[k], choose(splat(0.0f), 1.0f / resists, resists > splat(0.0f)));
		}
	}
	Real one[3];
	Int adds = spoke_sum(h, &s, old, one);
	for (int k = 0; k < 2; ++k)
		old[k] = choose(splat(0.0f), old[k], adds);
	for (int q = 0; q < 3; ++q)
		push[q] += choose(splat(0.0f), one[q], adds);
	spoke_push(p, i, s, old[0], old[1]);
	spoke_keep(p, i, what, old[0], old[1]);
}

// No more than a share of them.
INLINE void spoke_scale(const Pools* p, const Hub* h, int i, int what, float share)
{
	Real old[2];
	spoke_impulses(p, i, what, old);
	Real now1 = share * old[0], now2 = share * old[1];
	spoke_push(p, i, spoke_arms(p, h, i, what), now1 - old[0], now2 - old[1]);
	spoke_keep(p, i, what, now1, now2);
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
	Real zero = splat(0.0f), inverse = load(&spoke_at(p, inverse, m), 0);
	Real single1 = load(&spoke_at(p, inverse1, m), 0), single2 = load(&spoke_at(p, inverse2, m), 0);
	Real own1 = inverse * single1, own2 = inverse * single2, cross = own1 * (single2 * load(&spoke_at(p, cross, m), 0));
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
INLINE void spoke_answer(const Pools* p, const Hub* h, int i, int what, Real sum[HUB_SUMS])
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
	if (spoke_chooses(p, what))
	{
		Real takes[2] = {load(&spoke_at(p, limit1, m), 0), load(&spoke_at(p, limit2, m), 0)};
		for (int k = 0; k < 2; ++k)
		{
			r.impulse[k] = choose(old[k], r.impulse[k], takes[k] > splat(0.0f));
			r.own[k] = takes[k] * r.own[k];
		}
		r.cross = takes[0] * takes[1] * r.cross;
	}

	Real change[2] = {r.impulse[0] - old[0], r.impulse[1] - old[1]}, both = change[0] + change[1];
	Real add[HUB_SUMS] = {x * both, y * both, arm[0] * change[0] + arm[1] * change[1]};
	Real stiff = r.own[0] + r.own[1] + 2.0f * r.cross;
	Real lever = r.own[0] * arm[0] + r.own[1] * arm[1] + r.cross * (arm[0] + arm[1]);
	add[3] = x * x * stiff;
	add[4] = x * y * stiff;
	add[5] = y * y * stiff;
	add[6] = x * lever;
	add[7] = y * lever;
	add[8] = r.own[0] * arm[0] * arm[0] + r.own[1] * arm[1] * arm[1] + 2.0f * r.cross * arm[0] * arm[1];
	Real freely = x * fx + y * fy;
	add[9] = change[0] * (slope[0] + (freely + arm[0] * fw)) + change[1] * (slope[1] + (freely + arm[1] * fw));
	Real bend[2] = {mass[0] * change[0] * change[0], mass[1] * change[1] * change[1]};
	add[10] = bend[0] + bend[1] + 2.0f * cross * change[0] * change[1];

	// what goes beyond a float, or has no answer, stays as it is
	Int finite0 = absolute(r.impulse[0]) <= splat(MOST_IMPULSE),
	    finite1 = absolute(r.impulse[1]) <= splat(MOST_IMPULSE);
	Int adds = finite0 & finite1 & spoke_adds(h, bend[0]) & spoke_adds(h, bend[1]);
	for (int q = 0; q < HUB_SUMS; ++q)
		adds = adds & spoke_adds(h, add[q]);
	for (int q = 0; q < HUB_SUMS; ++q)
		sum[q] += choose(splat(0.0f), add[q], adds);
	store(&spoke_at(p, new1, m), 0, choose(old[0], r.impulse[0], adds));
	store(&spoke_at(p, new2, m), 0, choose(old[1], r.impulse[1], adds));
}

// A spoke gives a part of its answer. A part of 1 may leave what rounding leaves.
INLINE void spoke_give(const Pools* p, const Hub* h, int i, int what, float part)
{
	int m = spoke_of(p, i), limited = what == HUB_FRICTION || what == HUB_ROLL;
	Real old[2] = {load(&spoke_at(p, old1, m), 0), load(&spoke_at(p, old2, m), 0)};
	Real now[2] = {old[0] + part * (load(&spoke_at(p, new1, m), 0) - old[0]),
	               old[1] + part * (load(&spoke_at(p, new2, m), 0) - old[1])};
	now[0] = limited ? grip_of(now[0], load(&spoke_at(p, limit1, m), 0)) : push_of(now[0]);
	now[1] = limited ? grip_of(now[1], load(&spoke_at(p, limit2, m), 0)) : push_of(now[1]);
	spoke_push(p, i, spoke_arms(p, h, i, what), now[0] - old[0], now[1] - old[1]);
	spoke_keep(p, i, what, now[0], now[1]);
}

#endif
