// SPDX-License-Identifier: MIT
// active.h -- lists the groups of bodies, collidables and contacts that a step visits, in a world that sleeps.
//
// A group is GROUP_ITEMS adjacent items. It is active, or it rests. A step visits only the items of active groups. A
// visit to an item of a group that rests would change nothing: the item sleeps, or is static and was not changed by the
// user. A change ends the rest at once: the group is appended to the list of active groups. A group rests after
// GROUP_VISITS searches of islands that found no live item in it (groups.h), so that at least one step has visited it
// since its last change. Lists are sorted after groups were appended or left out. The order matters only for contacts:
// their layout by color begins with the order of the list, so that list is sorted before the layout.
#ifndef ACTIVE_H
#define ACTIVE_H
#include "dialect/dialect.h"
#include "pools/pools.h"

#define GROUP_VISITS 2 // state of a group after a change

// Returns the states of the groups of a kind: the number of searches of islands until a group rests; 0 if it rests.
INLINE GLOBAL int* group_states(const Pools* p, int kind)
{
	return kind == GROUPS_OF_BODIES        ? p->body_group_state
	       : kind == GROUPS_OF_COLLIDABLES ? p->collidable_group_state
	                                       : p->contact_group_state;
}

// Returns the list of the active groups of a kind. Counters.active_items has its length.
INLINE GLOBAL int* groups_of(const Pools* p, int kind)
{
	return kind == GROUPS_OF_BODIES        ? p->body_groups
	       : kind == GROUPS_OF_COLLIDABLES ? p->collidable_groups
	                                       : p->contact_groups;
}

// Returns number i of the items of active groups.
INLINE int listed_item(const Pools* p, int kind, int i)
{
	return groups_of(p, kind)[i >> GROUP_BITS] << GROUP_BITS | (i & (GROUP_ITEMS - 1));
}

// Returns the item that a kernel visits as number i. In a world that does not sleep, kernels visit all items.
INLINE int active_item(const Pools* p, int kind, int i) { return p->step.sleep ? listed_item(p, kind, i) : i; }

// Ends the rest of the group of an item. If several work-items do this at once, the one whose atomic maximum replaces 0
// appends the group to the list.
INLINE void active_touch(const Pools* p, int kind, int item)
{
	int group = item >> GROUP_BITS;
	GLOBAL int* state = group_states(p, kind) + group;
	if (read_shared(state) >= GROUP_VISITS || atomic_max_int(state, GROUP_VISITS) != 0)
		return;
	int place = atomic_add_int(&p->counters->active_items[kind], GROUP_ITEMS) >> GROUP_BITS;
	groups_of(p, kind)[place] = group;
	raise_int(&p->counters->relist[kind], 0x7fffffff);
}

// Ends the rest of the groups of a body and of its collidables.
INLINE void active_touch_body(const Pools* p, int i)
{
	active_touch(p, GROUPS_OF_BODIES, i);
	for (int k = p->continuous_body[i].first; k > 0; k = p->next_collidable[k - 1])
		active_touch(p, GROUPS_OF_COLLIDABLES, k - 1);
}

#endif
