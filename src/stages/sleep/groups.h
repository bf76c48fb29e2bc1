// SPDX-License-Identifier: MIT
// groups.h -- finds the groups of items that may rest, and sorts the lists of active groups (active.h).
//
// An item is live if the next step may change it. In every SLEEP_STEPS-th step, group_sink, group_keep and group_check
// run over the items of active groups: the state of a group sinks by 1, and is GROUP_VISITS again if an item is live. A
// group whose state is 0 rests.
#ifndef GROUPS_H
#define GROUPS_H
#include "stages/edit/active.h"
#include "stages/sleep/island.h"

// Returns whether a body may move, or is the ground.
INLINE int body_is_live(const Pools* p, int i)
{
	if (body_can_move(p, i))
		return p->sleep[i] == 0 && p->stored_velocity[i].stored == 0.0f;
	return i == 0 || body_is_moving(p, i); // item 0 of some kernels also does work that is needed once per step
}

// Returns whether the pose, the box or the shape of a collidable may change, or changed in this step.
INLINE int collidable_is_live(const Pools* p, int i)
{
	int body = p->collidable_body[i];
	if (p->collidable_kind[i] == KIND_DEAD)
		return 0;
	if (body > 0 && body_is_live(p, body))
		return 1;
	return (p->collidable_flags[i] & (COLLIDABLE_NEW_BOX | COLLIDABLE_SHIFTED | COLLIDABLE_CHANGED)) != 0;
}

// Returns whether a contact may change: a collidable moves, or was moved in this step.
INLINE int contact_is_live(const Pools* p, int i)
{
	if (i >= p->counters->contacts || p->pair[i].x < 0)
		return 0;
	Int2 pair = p->pair[i], bodies = p->contact_bodies[i];
	int flags = p->collidable_flags[pair.x] | p->collidable_flags[pair.y];
	return (flags & (COLLIDABLE_NEW_BOX | COLLIDABLE_SHIFTED)) || (bodies.x > 0 && body_is_live(p, bodies.x)) ||
	       (bodies.y > 0 && body_is_live(p, bodies.y));
}

INLINE int group_item_is_live(const Pools* p, int kind, int i)
{
	return kind == GROUPS_OF_BODIES        ? body_is_live(p, i)
	       : kind == GROUPS_OF_COLLIDABLES ? collidable_is_live(p, i)
	                                       : contact_is_live(p, i);
}

// Returns whether contacts of a collidable may rest: all contacts of an awake body are in active groups.
INLINE int collidable_may_rest(const Pools* p, int i)
{
	int body = p->collidable_body[i];
	return p->collidable_kind[i] != KIND_DEAD && !(body > 0 && body_can_move(p, body) && body_is_live(p, body));
}

// Item: a key of touched.c, before an upload. Ends the rest of a group that the user changes. If contacts of a collidable
// that the user changes or destroys may rest, requests contact_touch, which finds them.
KERNEL(group_touch)
{
	int kind = (int)(p->key[i] >> 32), number = (int)(p->key[i] & (Word64)0xffffffffu);
	if (kind < GROUP_KINDS)
		active_touch(p, kind, number << GROUP_BITS);
	else if (collidable_may_rest(p, number))
		raise_int(&p->counters->touched, 0x7fffffff);
}

// Item: a group. Makes all groups of a kind active, and counts the free slots of groups of contacts. argument: the
// kind, and the number of bodies or collidables.
KERNEL(group_reset)
{
	int kind = RUN_LOW(p->argument);
	int items = kind == GROUPS_OF_CONTACTS ? p->counters->contacts : RUN_HIGH(p->argument);
	int groups = (items + GROUP_ITEMS - 1) >> GROUP_BITS;
	group_states(p, kind)[i] = i < groups ? GROUP_VISITS : 0;
	groups_of(p, kind)[i] = i;
	if (i == 0)
		p->counters->active_items[kind] = groups << GROUP_BITS;
	int first = i << GROUP_BITS, free = 0;
	for (int k = first; kind == GROUPS_OF_CONTACTS && k < first + GROUP_ITEMS && k < items; ++k)
		free += p->pair[k].x < 0;
	if (kind == GROUPS_OF_CONTACTS)
		p->contact_group_free[i] = free;
}

// Item: a contact. Ends the rest of its group if the contact may change, after changes by the user.
KERNEL(contact_touch)
{
	if (contact_is_live(p, i))
		active_touch(p, GROUPS_OF_CONTACTS, i);
}

// Item: an item of an active group. The first item of each group lowers its state, unless the step runs again because
// a pool was too small. argument: the kind.
KERNEL(group_sink)
{
	int kind = p->argument, item = listed_item(p, kind, i);
	if ((item & (GROUP_ITEMS - 1)) == 0 && !p->counters->stalled)
		--group_states(p, kind)[item >> GROUP_BITS];
}

// Item: an item of an active group. Keeps the group active if the item is live. argument: the kind.
KERNEL(group_keep)
{
	int kind = p->argument, item = listed_item(p, kind, i);
	if (group_item_is_live(p, kind, item))
		raise_int(group_states(p, kind) + (item >> GROUP_BITS), GROUP_VISITS);
}

// Item: an item of an active group. The first item of each group requests a new list if the group rests now. argument:
// the kind.
KERNEL(group_check)
{
	int kind = p->argument, item = listed_item(p, kind, i);
	if ((item & (GROUP_ITEMS - 1)) == 0 && group_states(p, kind)[item >> GROUP_BITS] == 0)
		raise_int(&p->counters->relist[kind], 0x7fffffff);
}

// Item: a group, or the end of the scan. Marks active groups. argument: the kind, and the number of groups.
KERNEL(group_mark) { p->scan[i] = i < RUN_HIGH(p->argument) && group_states(p, RUN_LOW(p->argument))[i] != 0; }

// The same items. Lists the active groups in ascending order after the scan, in which scan[i] is the number of active
// groups before group i.
KERNEL(group_order)
{
	int kind = RUN_LOW(p->argument);
	if (i == RUN_HIGH(p->argument))
		p->counters->active_items[kind] = p->scan[i] << GROUP_BITS;
	else if (group_states(p, kind)[i] != 0)
		groups_of(p, kind)[p->scan[i]] = i;
}

// Sets the number of bodies that a solve visits if the host launches it before it has read the counters. The number is
// 0 if the layout changed; the host then launches another solve. A solve that finds its constraints in the counters can
// use a new layout, if it has room for it and can solve all of its constraints.
KERNEL(solve_bound)
{
	GLOBAL Counters* c = p->counters;
	if (BATCHED(p) && p->step.bays.solve_places > 0)
	{
		int places = 0;
		for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
			places += c->layout[kind].begin[COLORS + 1];
		if ((c->changed && !c->arranged) || c->hubs > 0 || c->overflow > 0 || places > p->step.bays.solve_places)
			c->kept = 0;
	}
	c->kept_bodies = c->kept ? c->active_items[GROUPS_OF_BODIES] : 0;
	(void)i;
}

// Notes that a list is sorted. argument: the kind.
KERNEL(group_ordered)
{
	p->counters->relist[p->argument] = 0;
	(void)i;
}

#endif
