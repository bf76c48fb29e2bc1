// SPDX-License-Identifier: MIT
// spoke.h -- finds hubs, and computes the hub of each spoke and the places of a hub's spokes.
//
// A body with more than HUB_CONTACTS constraints, including joints, becomes a hub. All of its contacts become spokes
// and remain spokes as long as they touch, so that a varying number of contacts does not switch the layout back and
// forth. A body on belts that run against each other becomes a hub too. Contacts that are solved one after the
// other share a change of the load too slowly, and the body would swing more and more (docs/design/hubs.md, Belts).
#ifndef SPOKE_H
#define SPOKE_H
#include "pools/bays.h"

// Returns whether a body touches belts that run against each other. belts: its item of the pool belts.
INLINE int hub_belts(int belts) { return (belts & (BELT_BACK - 1)) != 0 && belts / BELT_BACK != 0; }

// Returns the number of constraints of a body, plus HUB_CONTACTS if it is on belts that run against each other. A body
// with a result above HUB_CONTACTS is a hub.
INLINE int hub_load(const Pools* p, int body)
{
	return p->touching[body] + (p->step.belts && hub_belts(p->belts[body]) ? HUB_CONTACTS : 0);
}

INLINE int hub_crowded(const Pools* p, int body)
{
	return hub_load(p, body) > HUB_CONTACTS && p->body[body].inv_mass > 0.0f;
}

// Returns whether a contact without a color becomes a spoke, because one of its bodies is a hub.
INLINE int hub_wants(const Pools* p, Int2 bodies) { return hub_crowded(p, bodies.x) || hub_crowded(p, bodies.y); }

// Returns the hub of a spoke: the only body that can move; of two hubs with different masses, the lighter one, because
// heavy bodies may crush it and a hub is solved exactly; otherwise the body with more constraints.
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
	int body, first, count; // the hub; place of its first spoke; number of its places, with padding to whole blocks
} HubSpan;

// Returns the first place of the spokes of hub n, at the start of a block. Each hub has a spare block, so the place
// depends only on n and on `key`, the index of its first spoke among the sorted keys.
INLINE int hub_first(const Pools* p, int n, int key)
{
	const GLOBAL Counters* c = p->counters;
	int before = (key - c->layout[CONSTRAINT_CONTACT].first[COLORS] + MAX_LANES - 1) / MAX_LANES;
	return c->layout[CONSTRAINT_CONTACT].begin[COLORS] + MAX_LANES * (before + n);
}

INLINE HubSpan hub_span_of(const Pools* p, int n)
{
	HubSpan span;
	span.body = p->hub[n];
	Int2 keys = p->hub_keys[span.body];
	span.first = hub_first(p, n, keys.x);
	span.count = (keys.y - keys.x + MAX_LANES - 1) / MAX_LANES * MAX_LANES;
	return span;
}

// Returns the number of hubs, among the first `count`, whose bodies precede a body.
INLINE int hub_bound(const Pools* p, int count, int body)
{
	int low = 0, high = count;
	while (low < high)
	{
		int middle = low + (high - low) / 2;
		if (p->hub[middle] < body)
			low = middle + 1;
		else
			high = middle;
	}
	return low;
}

// Returns the number of hub n among those of its world.
INLINE int hub_alone(const Pools* p, int n)
{
	int body = p->hub[n];
	return BATCHED(p) ? n - hub_bound(p, n, body - bay_body(p, body)) : n;
}

INLINE int hub_color(const Pools* p, int n) { return hub_alone(p, n) % HUB_COLORS; }

// Returns the number of places of spokes, padding included.
INLINE int spoke_places(const Pools* p)
{
	return p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS + 1] -
	       p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS];
}

// Returns the index, among the spokes, of the contact at place i.
INLINE int spoke_of(const Pools* p, int i) { return i - p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS]; }

#endif
