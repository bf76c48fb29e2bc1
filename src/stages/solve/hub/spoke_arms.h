// SPDX-License-Identifier: MIT
// spoke_arms.h -- loads and stores impulses of a spoke, and computes their effects on hub and neighbor.
#ifndef SPOKE_ARMS_H
#define SPOKE_ARMS_H
#include "constraints/constraint_kinds.h"
#include "stages/color/spoke.h"

// kinds of blocks
#define HUB_NORMAL   0 // normal impulses without softness
#define HUB_SOFT     1 // soft normal impulses, which push overlap out
#define HUB_BOUNCE   2 // restitution
#define HUB_FRICTION 3
#define HUB_ROLL     4 // rolling resistance

typedef struct // hub while it is solved
{
	int body, first, count;      // body of the hub; range of its spokes, padding included
	float inv_mass, inv_inertia; // inverse mass and inertia of the hub's part
	float mass, inertia;         // mass and inertia of the hub's part; a hub of inertia 0 does not rotate
	float gyration;              // m^2: inertia over mass
	float most;                  // limit of a spoke's contribution to a sum, so that the sum over all spokes is finite
	float from[3];               // velocity at the start of the block: x, y, angular
	float free[3];               // the same, after impulses beyond their limits were removed
	float now[3];
	Body whole; // hub as one body, not split into parts
} Hub;

typedef struct // effects of unit impulses at the points of a spoke
{
	Vec n;                    // direction of the impulse on the hub; opposite to that of the impulse on the neighbor
	Real hub[2], neighbor[2]; // angular impulses on hub and neighbor per unit of impulse, at each point
	Real mass, inertia;       // inverse mass and inertia of the neighbor's part
	Real whole_mass, whole_inertia;
	Vec v; // velocity of the neighbor
	Real w;
} SpokeArms;

INLINE Body body_blend(Body a, Body b, Int c)
{
	Body r;
	r.v = vec(blend(a.v.x, b.v.x, c), blend(a.v.y, b.v.y, c));
	r.w = blend(a.w, b.w, c);
	r.inv_mass = blend(a.inv_mass, b.inv_mass, c);
	r.d = vec(blend(a.d.x, b.d.x, c), blend(a.d.y, b.d.y, c));
	r.da = blend(a.da, b.da, c);
	r.inv_inertia = blend(a.inv_inertia, b.inv_inertia, c);
	r.sine = blend(a.sine, b.sine, c);
	r.versine = blend(a.versine, b.versine, c);
	return r;
}

// Returns whether the hub is body b of contact i.
INLINE Int spoke_turned(const Pools* p, const Hub* h, int i)
{
	return (load_int(&contact_row(p, body_b, i), 0) ^ h->body) == 0;
}

INLINE Int spoke_neighbor(const Pools* p, const Hub* h, int i)
{
	return load_int(&contact_row(p, body_a, i), 0) ^ load_int(&contact_row(p, body_b, i), 0) ^ h->body;
}

// Stores the state of the neighbor and the gaps of the spoke, which the blocks of a pass use.
INLINE void spoke_begin(const Pools* p, const Hub* h, int i, Body neighbor)
{
	Contact u;
	contact_load(p, i, PASS_BIAS, &u);
	Int turned = spoke_turned(p, h, i);
	Body a = body_blend(h->whole, neighbor, turned), b = body_blend(neighbor, h->whole, turned);
	ContactReady ready;
	contact_ready(p, PASS_BIAS, i, &a, &b, &u, &ready);
	int k = spoke_of(p, i);
	store(&spoke_at(p, vx, k), 0, neighbor.v.x);
	store(&spoke_at(p, vy, k), 0, neighbor.v.y);
	store(&spoke_at(p, w, k), 0, neighbor.w);
	store(&spoke_at(p, inv_mass, k), 0, neighbor.inv_mass);
	store(&spoke_at(p, inv_inertia, k), 0, neighbor.inv_inertia);
	store(&spoke_at(p, gap1, k), 0, ready.gap[0]);
	store(&spoke_at(p, gap2, k), 0, ready.gap[1]);
}

INLINE SpokeArms spoke_arms(const Pools* p, const Hub* h, int i, int what)
{
	Contact u;
	SpokeArms s;
	contact_load(p, i, PREPARE_BOUNCE, &u);
	ContactArms c = pair_of(&u, &h->whole, &h->whole);
	Int turned = spoke_turned(p, h, i);
	Vec n = what == HUB_FRICTION ? c.t : c.n;
	s.n = vec(blend(-n.x, n.x, turned), blend(-n.y, n.y, turned));
	for (int k = 0; k < 2; ++k)
	{
		Real on_a = -vec_cross(c.ra[k], n), on_b = vec_cross(c.rb[k], n);
		s.hub[k] = blend(on_a, on_b, turned);
		s.neighbor[k] = blend(on_b, on_a, turned);
	}
	if (what == HUB_ROLL)
	{
		// rolling resistance is a torque, stored as the impulse at the first point
		s.n = vec(splat(0.0f), splat(0.0f));
		s.hub[0] = blend(splat(-1.0f), splat(1.0f), turned);
		s.neighbor[0] = -s.hub[0];
		s.hub[1] = splat(0.0f);
		s.neighbor[1] = splat(0.0f);
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

// Returns whether a spoke may add x to a sum; 0 if x is NaN.
INLINE Int spoke_adds(const Hub* h, Real x) { return (x >= splat(-h->most)) & (x <= splat(h->most)); }

// Computes `push`, the impulse of a spoke on the hub. Returns whether all terms and the energy are within h->most.
INLINE Int spoke_sum(const Hub* h, const SpokeArms* s, const Real impulse[2], Real push[3])
{
	Real both = impulse[0] + impulse[1];
	push[0] = s->n.x * both;
	push[1] = s->n.y * both;
	push[2] = s->hub[0] * impulse[0] + s->hub[1] * impulse[1];
	Int adds = spoke_adds(h, push[0]) & spoke_adds(h, push[1]) & spoke_adds(h, push[2]);
	for (int k = 0; k < 2; ++k)
		adds = adds & spoke_adds(h, impulse[k]) &
		       spoke_adds(h, (s->mass + s->inertia * s->neighbor[k] * s->neighbor[k]) * impulse[k] * impulse[k]);
	return adds;
}

// Applies impulses at both points to the neighbor.
INLINE void spoke_push(const Pools* p, int i, SpokeArms s, Real impulse1, Real impulse2)
{
	int m = spoke_of(p, i);
	Real both = s.mass * (impulse1 + impulse2);
	store(&spoke_at(p, vx, m), 0, s.v.x - both * s.n.x);
	store(&spoke_at(p, vy, m), 0, s.v.y - both * s.n.y);
	store(&spoke_at(p, w, m), 0, s.w + s.inertia * (s.neighbor[0] * impulse1 + s.neighbor[1] * impulse2));
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

// Adds the impulses of a bounce to the total impulses. A point that bounces separates, so its normal impulse is cleared
// and does not warm start the next step.
INLINE void spoke_keep_bounce(const Pools* p, int i, Real impulse1, Real impulse2)
{
	int m = spoke_of(p, i);
	Real zero = splat(0.0f), normal1 = load(&contact_row(p, normal_impulse1, i), 0),
	     normal2 = load(&contact_row(p, normal_impulse2, i), 0);
	pair_total(p, i, impulse1, impulse2);
	store(&contact_row(p, normal_impulse1, i), 0, blend(normal1, zero, load(&spoke_at(p, limit1, m), 0) > zero));
	store(&contact_row(p, normal_impulse2, i), 0, blend(normal2, zero, load(&spoke_at(p, limit2, m), 0) > zero));
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

#endif
