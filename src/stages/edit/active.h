// SPDX-License-Identifier: MIT
// active.h -- lists the groups of bodies, collidables and contacts that a step visits, in a world that sleeps.
//
// A group is GROUP_ITEMS adjacent items. A step skips a group whose items cannot change: they sleep, or are static and
// were not changed by the user. A change ends the rest of a group at once: the group is appended to the list. A group
// is skipped after two searches of islands in which no item of it was live, so that at least one step has visited it
// since its last change. The list is sorted then; the result of a step does not depend on its order.
#ifndef ACTIVE_H
#define ACTIVE_H
#include "dialect/dialect.h"
#include "pools/pools.h"

#define GROUP_VISITS 2 // value of a group's state after a change

INLINE GLOBAL int* group_states(const Pools* p, int kind)
{
	return kind == GROUPS_OF_BODIES        ? p->body_group_state
	       : kind == GROUPS_OF_COLLIDABLES ? p->collidable_group_state
	                                       : p->contact_group_state;
}

INLINE GLOBAL int* groups_of(const Pools* p, int kind)
{
	return kind == GROUPS_OF_BODIES        ? p->body_groups
	       : kind == GROUPS_OF_COLLIDABLES ? p->collidable_groups
	                                       : p->contact_groups;
}

// Returns the item that a kernel visits as number i. In a world that does not sleep, kernels visit all items.
INLINE int listed_item(const Pools* p, int kind, int i)
{
	return groups_of(p, kind)[i >> GROUP_BITS] << GROUP_BITS | (i & (GROUP_ITEMS - 1));
}

INLINE int active_item(const Pools* p, int kind, int i) { return p->step.sleep ? listed_item(p, kind, i) : i; }

// Ends the rest of the group of an item. Returns whether the group was skipped until now.
INLINE int active_touch(const Pools* p, int kind, int item)
{
	int group = item >> GROUP_BITS;
	GLOBAL int* state = group_states(p, kind) + group;
	if (read_shared(state) >= GROUP_VISITS || atomic_max_int(state, GROUP_VISITS) != 0)
		return 0;
	int place = atomic_add_int(&p->counters->active_items[kind], GROUP_ITEMS) >> GROUP_BITS;
	groups_of(p, kind)[place] = group;
	raise_int(&p->counters->relist[kind], 0x7fffffff);
	return 1;
}

// Likewise for a body and its collidables.
INLINE void active_touch_body(const Pools* p, int i)
{
	active_touch(p, GROUPS_OF_BODIES, i);
	for (int k = p->continuous_body[i].first; k > 0; k = p->next_collidable[k - 1])
		active_touch(p, GROUPS_OF_COLLIDABLES, k - 1);
}

#endif
