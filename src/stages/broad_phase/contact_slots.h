// SPDX-License-Identifier: MIT
// contact_slots.h -- puts new pairs, in the order of their keys, into the lowest free slots of the contact pool.
//
// Slots determine priorities in coloring and the order of a readback, so they must not depend on the device.
#ifndef CONTACT_SLOTS_H
#define CONTACT_SLOTS_H
#include "constraints/contact_one.h"
#include "dialect/finite.h"
#include "pools/bays.h"
#include "stages/color/joint_edges.h"
#include "stages/edit/pool_item.h"
#include "stages/rules/apart.h"

// Checks the contact limit, which is equal on all devices, and the capacity for new pairs, which depends on the device.
KERNEL(contact_admit)
{
	GLOBAL Counters* c = p->counters;
	c->over_limit = c->alive + c->pairs > p->step.contact_limit;
	c->stalled = c->over_limit || c->pairs > p->step.pair_capacity;
	c->sort_pairs = c->stalled ? 0 : c->pairs;
	if (c->stalled)
		c->kept = 0;
	int slots = p->step.sleep ? (c->contacts + GROUP_ITEMS - 1) >> GROUP_BITS : c->contacts;
	c->search = c->sort_pairs > 0 ? slots + 1 : 0;
	if (BATCHED(p))
		c->crowded = 0;
	c->dead = 0;
	(void)i;
}

KERNEL(contact_mark_free) { p->scan[i] = i < p->counters->contacts && p->pair[i].x < 0; }

// Lists the free slots after the scan, in which scan[i] is the number of free slots before slot i.
KERNEL(contact_list_free)
{
	if (i < p->counters->contacts && p->pair[i].x < 0)
		p->free_slot[p->scan[i]] = i;
}

// Item: a group of slots. In a world that sleeps, the scan contains the numbers of free slots of groups, so that groups
// without free slots are not visited.
KERNEL(contact_mark_group) { p->scan[i] = i < p->counters->search - 1 ? p->contact_group_free[i] : 0; }

KERNEL(contact_list_group)
{
	if (i >= p->counters->search - 1 || p->contact_group_free[i] == 0)
		return;
	int place = p->scan[i], first = i << GROUP_BITS;
	for (int k = first; k < first + GROUP_ITEMS && k < p->counters->contacts; ++k)
		if (p->pair[k].x < 0)
			p->free_slot[place++] = k;
}

#ifndef SCREE_NO_BATCHES
// Returns the bay of a new pair.
INLINE int contact_bay(const Pools* p, int i) { return bay_of_collidable(p, (int)(p->key[i] >> p->step.key_bits)); }

// Item: a new pair, in a batch. For the first pair of a world, lists the lowest free slots of its bay, in ascending order,
// for all pairs of the world. If the bay has too few slots, or the world gets more contacts than its limit, stores the
// number of its contacts. argument: maximum number of contacts of a world.
KERNEL(contact_list_bay)
{
	int bits = p->step.bays.contact_bits, world = contact_bay(p, i), begin = world << bits, end = (world + 1) << bits;
	if (i > 0 && contact_bay(p, i - 1) == world)
		return;
	int slot = begin, pairs = 0;
	for (int k = i; k < p->counters->sort_pairs && contact_bay(p, k) == world; ++k, ++pairs)
	{
		while (slot < end && p->pair[slot].x >= 0)
			++slot;
		if (slot < end && k < p->step.contact_capacity) // a pair beyond the capacity is that of a step with a full bay
			p->free_slot[k] = slot;
		slot += slot < end;
	}
	if (slot < end && 1 << bits <= p->argument)
		return;
	int contacts = pairs;
	for (slot = begin; slot < end; ++slot)
		contacts += p->pair[slot].x >= 0;
	if (contacts <= 1 << bits && contacts <= p->argument)
		return;
	raise_int(&p->counters->crowded, contacts);
	if (contacts > p->argument)
		p->bay_state[world].crowded = contacts;
}
#endif

// Checks the capacity for contacts; adds the new contacts to the numbers of slots in use and of contacts.
KERNEL(contact_reserve)
{
	GLOBAL Counters* c = p->counters;
	if (BATCHED(p))
		c->dead = c->sort_pairs;
	else
		c->dead = c->search > 0 ? p->scan[c->search - 1] : 0;
	int beyond = c->sort_pairs > c->dead ? c->sort_pairs - c->dead : 0;
	c->needed = c->contacts + beyond;
	// one slot more than the contacts need, for the end of the scan
	if (c->needed + 1 > p->step.contact_capacity || (BATCHED(p) && c->crowded))
	{
		c->stalled = 1;
		c->kept = 0;
	}
	c->created = c->stalled ? 0 : c->sort_pairs;
	if (c->created > 0 && c->needed > c->contacts)
		c->contacts = c->needed;
	c->alive = c->alive + c->created;
	c->live = c->stalled ? 0 : c->contacts;
	(void)i;
}

// Moves contacts so that n contacts fill the first n slots. Contacts in later slots move to the free ones of these n
// slots, both in ascending order. No slot is both a source and a destination.
KERNEL(contact_pack)
{
	const GLOBAL Counters* c = p->counters;
	int alive = c->alive - c->released;
	if (i < alive || p->pair[i].x < 0)
		return;
	int to = p->free_slot[(i - alive) - (p->scan[i] - p->scan[alive])], constraint = p->contact_place[i];
	item_move(p, PER_CONTACT, to, i);
	if (constraint >= 0)
		p->contact_place_slot[constraint] = to;
	p->pair[i] = make_int2(-1, -1);
}

KERNEL(contact_pack_end)
{
	p->counters->contacts = p->counters->alive - p->counters->released;
	(void)i;
}

INLINE float surface_larger(float a, float b) { return a < b ? b : a; }

// Returns friction, restitution, rolling lever (m) and tangent speed (m/s) of two attributes in any order. The
// friction is the geometric mean of both frictions, so ice stays slippery on anything.
INLINE Float4 contact_surface_of(const GLOBAL Attribute* sa, const GLOBAL Attribute* sb)
{
	float lever =
	    surface_larger(sa->rolling_resistance, sb->rolling_resistance) * surface_larger(sa->radius, sb->radius);
	float friction = square_root(sa->friction * sb->friction);
	return make_float4(friction < MOST_FRICTION ? friction : MOST_FRICTION,
	                   surface_larger(sa->restitution, sb->restitution), lever, sa->tangent_speed + sb->tangent_speed);
}

// Returns CONTACT_DETECTED or CONTACT_JOINED if the bodies of a pair do not respond to each other, otherwise 0. The
// result stays the same until the user changes a joint or an excluded pair, or a joint breaks.
INLINE Word contact_parts(const Pools* p, Int2 pair)
{
	int apart = apart_by(p, pair.x, pair.y, APART_DETECTED | APART_JOINED);
	return apart == APART_DETECTED ? CONTACT_DETECTED : apart ? CONTACT_JOINED : 0u;
}

KERNEL(contact_create)
{
	Word64 key = p->key[i];
	int a = (int)(key >> p->step.key_bits), b = (int)(key & (((Word64)1 << p->step.key_bits) - (Word64)1));
	// when no free slot is left, contacts take the slots after the last one in use
	int slot = i < p->counters->dead ? p->free_slot[i] : p->counters->contacts - p->counters->created + i;
	Int2 pair = apart_pair(p, a, b);
	a = pair.x;
	b = pair.y;
	int body_a = p->collidable_body[a], body_b = p->collidable_body[b];
	item_clear(p, PER_CONTACT, slot);
	if (p->step.sleep)
	{
		active_touch(p, GROUPS_OF_CONTACTS, slot);
		if (i < p->counters->dead)
			atomic_add_int(p->contact_group_free + (slot >> GROUP_BITS), -1);
	}
	p->pair[slot] = pair;
	Int2 bodies = make_int2(body_a < 0 ? bay_ground(p, a) : body_a, body_b < 0 ? bay_ground(p, b) : body_b);
	Word flags = CONTACT_FRESH | touch_reports(p, pair) | contact_parts(p, pair);
	int kind = p->collidable_kind[b];
	flags |= kind == KIND_STATIC ? CONTACT_STATIC : kind == KIND_KINEMATIC ? CONTACT_KINEMATIC : 0u;
	p->contact_bodies[slot] = bodies;
	p->contact_flags[slot] = flags;
	contact_count(p, bodies, flags, 1);
	if (flags & CONTACT_STATIC) // only read for bodies with one static contact
		write_shared_word((GLOBAL Word*)p->static_contact + bodies.x, (Word)slot);
	p->contact_color[slot] = COLOR_NONE;
	p->contact_feature[slot] = make_int2(-1, -1);
	p->contact_place[slot] = -1;
	p->contact_surface[slot] =
	    contact_surface_of(p->attribute + p->collidable_attribute[a], p->attribute + p->collidable_attribute[b]);
}

// Restarts contact i if a changed joint or exclusion now keeps its bodies from touching, or no longer does.
KERNEL(contact_join)
{
	Word flags = p->contact_flags[i];
	if (i >= p->counters->live || p->pair[i].x < 0)
		return;
	if (flags & CONTACT_DETECTED)
		return;
	Word joined = contact_parts(p, p->pair[i]);
	// A contact whose boxes parted is not restarted: the narrow phase will release it, and keeps fresh contacts.
	if ((flags & CONTACT_JOINED) == joined || box_parted(p, p->pair[i]))
		return;
	contact_anew(p, i, flags, joined | (flags & CONTACT_REPORTS));
}

// Updates surface (in slot and rows) and report bits of contact i after a change of attributes or reports.
KERNEL(contact_mix)
{
	Int2 pair = p->pair[i];
	if (pair.x < 0 || (BATCHED(p) && !bay_of_contact(p, i)->surfaces_used))
		return;
	Float4 surface = contact_surface_of(p->attribute + p->collidable_attribute[pair.x],
	                                    p->attribute + p->collidable_attribute[pair.y]);
	int c = p->contact_place[i];
	if (p->step.material_pairs > 0)
		surface = rule_surface(rule_materials(p, pair.x, pair.y), surface);
	int belt = edge_belt(surface.w) - edge_belt(p->contact_surface[i].w);
	if (p->contact_color[i] >= 0 && belt != 0)
	{
		edge_add_belt(p, p->contact_bodies[i], belt);
		raise_int(&p->counters->belts, 1);
	}
	p->contact_surface[i] = surface;
	p->contact_flags[i] = (p->contact_flags[i] & ~CONTACT_REPORTS) | touch_reports(p, pair);
	if (c < 0)
		return;
	contact_set_surface(p, c, surface);
}

#endif
