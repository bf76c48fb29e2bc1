// SPDX-License-Identifier: MIT
// spoke.h -- which bodies are hubs, whose spoke a contact is, and where the spokes of a hub lie.
//
// A body with more than HUB_CONTACTS constraints, joints among them, becomes a hub: all of its contacts become spokes, and stay
// spokes as long as they touch. This is a hysteresis: a number of contacts that varies does not switch the layout back and
// forth.
//
// So does a body on belts that run against each other. Its friction is the difference of what they carry, and of two contacts that are
// solved one after the other the first takes every change of the load; it is shared only as impulses leak, within 0.2 s. A hub's
// contacts share it at once, as springs do. With that delay a body on two belts swings more and more, until it is as fast as they are.
#ifndef SPOKE_H
#define SPOKE_H
#include "pools/pools.h"

// Whether a body has contacts with belts that run against each other, from its item of the pool belts.
INLINE int hub_belts(int belts) { return (belts & (BELT_BACK - 1)) != 0 && belts / BELT_BACK != 0; }

// The number of constraints of a body; more than HUB_CONTACTS for a hub.
INLINE int hub_load(const Pools* p, int body)
{
	return p->touching[body] + (p->step.belts && hub_belts(p->belts[body]) ? HUB_CONTACTS : 0);
}

INLINE int hub_crowded(const Pools* p, int body)
{
	return hub_load(p, body) > HUB_CONTACTS && p->body[body].inv_mass > 0.0f;
}

// Whether a contact without a color becomes a spoke.
INLINE int hub_wants(const Pools* p, Int2 bodies) { return hub_crowded(p, bodies.x) || hub_crowded(p, bodies.y); }

// The hub of a spoke: the end with more contacts. If both have many, the lighter one, because heavy bodies on either
// side of it may crush it: a hub is solved exactly.
INLINE int hub_owner(const Pools* p, Int2 bodies)
{
	int a = bodies.x, b = bodies.y, touching_a = hub_load(p, a), touching_b = hub_load(p, b);
	float mass_a = p->body[a].inv_mass, mass_b = p->body[b].inv_mass;
	if (!(mass_a > 0.0f && mass_b > 0.0f))
		return mass_a > 0.0f ? a : b;
	if (touching_a > HUB_CONTACTS && touching_b > HUB_CONTACTS && mass_a != mass_b)
		return mass_a > mass_b ? a : b;
	if (touching_a != touching_b)
		return touching_a > touching_b ? a : b;
	return a < b ? a : b;
}

typedef struct
{
	int body, first, count; // its spokes among the constraints, padding included
} HubSpan;

// Each hub begins at a block of its own. One block is left free per hub before it, so that no sum over these is needed.
INLINE int hub_first(const Pools* p, int n, int key)
{
	const GLOBAL Counters* c = p->counters;
	int before = (key - c->layout[CONSTRAINT_CONTACT].first[COLORS] + MAX_LANES - 1) / MAX_LANES;
	return c->layout[CONSTRAINT_CONTACT].begin[COLORS] + MAX_LANES * (before + n);
}

// The places of the spokes of hub number n.
INLINE HubSpan hub_span_of(const Pools* p, int n)
{
	HubSpan span;
	span.body = p->hub[n];
	Int2 keys = p->hub_keys[span.body];
	span.first = hub_first(p, n, keys.x);
	span.count = (keys.y - keys.x + MAX_LANES - 1) / MAX_LANES * MAX_LANES;
	return span;
}

// The turn of a pass in which hub number n is solved.
INLINE int hub_color(int n) { return n % HUB_COLORS; }

// Places of spokes, padding included.
INLINE int spoke_places(const Pools* p)
{
	return p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] -
	       p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS];
}

// The number of constraint i among the spokes.
INLINE int spoke_of(const Pools* p, int i) { return i - p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS]; }

#endif
