// SPDX-License-Identifier: MIT
// wake.h -- wakes marked islands; ends the constraints of bodies that fell asleep, begins those of bodies that woke.
//
// Commands, the narrow phase and the kernels below mark islands. All bodies of a marked island wake in the same step,
// before the coloring, so that their constraints are solved in that step.
#ifndef WAKE_H
#define WAKE_H
#include "constraints/joint_asleep.h"
#include "stages/color/joint_edges.h"
#include "stages/sleep/groups.h"

// Kernels that mark islands do nothing in a step that is refused or repeated, because the marks are a part of the state.
//
// Marks the islands of sleeping bodies that touch a static or kinematic collidable that moves or was changed.
KERNEL(contact_wake)
{
	Word flags = p->contact_flags[i];
	if (p->counters->stalled || i >= p->counters->live || !(flags & CONTACT_ASLEEP))
		return;
	Int2 pair = p->pair[i];
	if ((p->collidable_flags[pair.x] | p->collidable_flags[pair.y]) & COLLIDABLE_SHIFTED)
		island_wake_both(p, p->contact_bodies[i]);
}

// Returns whether a static or kinematic body moves, or was moved by the user.
INLINE int support_moves(const Pools* p, int i)
{
	return body_still(p, i) == STILL_MOVED || (!body_can_move(p, i) && body_is_moving(p, i));
}

// Marks the island of a sleeping body that is joined to a static or kinematic body that moves. A joint that was disabled since
// its bodies fell asleep keeps its flag, and marks nothing.
KERNEL(joint_wake)
{
	int flags = p->joint_flags[i];
	if (p->counters->stalled || !(flags & JOINT_ASLEEP) || !joint_wanted(flags))
		return;
	Int2 bodies = make_int2(p->joint_data[i].body_a, p->joint_data[i].body_b);
	if (support_moves(p, bodies.x) || support_moves(p, bodies.y))
		island_wake_both(p, bodies);
}

#ifndef SCREE_NO_BATCHES
// Item: a live bay. Decides whether the step searches the islands of the world. argument: Pipeline.steps; -1 in a step
// that searches none.
KERNEL(bay_sleep)
{
	GLOBAL BayState* state = p->bay_state + i;
	GLOBAL Counters* c = p->counters;
	int due = p->argument >= 0 && (p->argument + state->steps) % SLEEP_STEPS == 0;
	if (c->stalled)
		return;
	state->searches = p->argument >= 0 && (state->settles || (due && (state->drowsy || state->joined_islands)));
	if (state->searches)
		raise_int(&c->bays_search, 1);
	if (state->settles || state->joined_islands)
		raise_int(&c->bays_settle, 1);
	if (p->argument < 0)
		return;
	bay_set_ratio(p, state); // joint_rescale runs before bay_begin
	if (due || state->settles)
		state->drowsy = state->joined_islands = 0;
	state->settles = 0;
}
#endif

// Decides which of the kernels below run. argument: SEARCH_NEVER, SEARCH_DROWSY, SEARCH_NOW or, in a batch, SEARCH_BAYS.
KERNEL(sleep_begin)
{
	GLOBAL Counters* c = p->counters;
	int search = p->argument == SEARCH_NOW || (p->argument && (c->drowsy | c->joined_islands));
	int all = p->argument == SEARCH_NOW || c->joined_islands;
	if (BATCHED(p))
	{
		search = c->bays_search;
		all = c->joined_islands = c->bays_settle;
		c->bays_search = c->bays_settle = 0;
	}
	c->searching = 0;
	c->search_bodies = 0;
	c->search_contacts = 0;
	c->waking = 0;
	c->marked = 0;
	c->settling = 0;
	if (c->stalled)
		return;
	c->touched = 0;
	c->marked = c->woken;
	c->settling = c->woken;
	c->waking = search && !BATCHED(p) ? 0 : c->woken;
	c->search_all = all || c->woken;
	if (search)
	{
		c->searching = 0x7fffffff;
		c->search_bodies = c->search_all ? 0x7fffffff : c->active_items[GROUPS_OF_BODIES];
		c->search_contacts = c->search_all ? 0x7fffffff : c->active_items[GROUPS_OF_CONTACTS];
	}
	c->woken = 0;
	if (p->argument && !BATCHED(p))
	{
		c->drowsy = 0;
		c->joined_islands = 0;
	}
	(void)i;
}

// Wakes the bodies of marked islands, in a step that does not search for islands; island_end does it in the others.
KERNEL(body_wake)
{
	if (body_mark(p, i) && !(BATCHED(p) && bay_searches(p, i)))
	{
		body_rise(p, i);
		active_touch_body(p, i);
	}
}

// Begins the constraint of a contact whose bodies woke. It has the color that it kept, or gets one later in the step.
// Colors of an island stay free of conflicts: no constraint of its bodies begins while they sleep. Returns the edge if it
// must be listed, else EDGE_NONE.
INLINE int contact_rise(const Pools* p, int i, Int2 bodies)
{
	int edge = edge_of(CONSTRAINT_CONTACT, i), color = p->contact_color[i];
	edge_enter(p, edge, bodies);
	if (color == COLOR_NONE)
		return edge;
	p->contact_color[i] = color == COLOR_WANTED ? COLOR_NONE : COLOR_KEPT(color);
	return EDGE_NONE;
}

// Ends the constraint of slot i if one of its bodies fell asleep, and keeps its values at the slot; or begins it again
// if both are awake. Returns the edge if it must be listed, else EDGE_NONE. keeps: whether its color is kept too; begins:
// expression that begins the constraint and returns it.
#define SLEEP_EDGE(kind, bodies, flags, ASLEEP, keeps, begins) \
	int sleeps = p->sleep[bodies.x] | p->sleep[bodies.y];      \
	if (sleeps && p->kind##_color[i] >= 0)                     \
	{                                                          \
		if (p->kind##_place[i] >= 0)                           \
			kind##_keep(p, i, p->kind##_place[i]);             \
		kind##_leave(p, i, keeps);                             \
		p->kind##_flags[i] = flags | ASLEEP;                   \
	}                                                          \
	else if (!sleeps && flags & ASLEEP)                        \
	{                                                          \
		p->kind##_flags[i] = flags & ~ASLEEP;                  \
		return begins;                                         \
	}                                                          \
	return EDGE_NONE;

LIST_KERNEL(contact_sleep, began, began)
{
	Word flags = p->contact_flags[i];
	if (i >= p->counters->live || p->pair[i].x < 0)
		return EDGE_NONE;
	Int2 bodies = p->contact_bodies[i];
	if (contact_is_live(p, i))
		active_touch(p, GROUPS_OF_CONTACTS, i);
	int color = p->contact_color[i];
	if (color < COLOR_NONE && color != COLOR_WANTED && p->sleep[bodies.x] | p->sleep[bodies.y] &&
	    !edge_rests(p, bodies))
	{
		edge_free_color(p, bodies, COLOR_KEPT(color));
		p->contact_color[i] = COLOR_NONE;
	}
	SLEEP_EDGE(contact, bodies, flags, CONTACT_ASLEEP, 1, contact_rise(p, i, bodies))
}

LIST_KERNEL(joint_sleep, began, began)
{
	int flags = p->joint_flags[i];
	if (!(flags & JOINT_THERE))
		return EDGE_NONE;
	Int2 bodies = make_int2(p->joint_data[i].body_a, p->joint_data[i].body_b);
	// if joints were changed, joint_update begins all joints that have no constraint
	int begins = joint_wanted(flags) && p->counters->joints_dirty == 0;
	SLEEP_EDGE(joint, bodies, flags, JOINT_ASLEEP, 0, begins ? joint_begin(p, i) : EDGE_NONE)
}

// Item: a joint, in a step whose substeps have another length than those of the last step. Scales the impulses of
// sleeping joints, so that their forces stay the same; the warm start scales those of awake joints.
KERNEL(joint_rescale)
{
	if (!p->counters->stalled && p->joint_flags[i] & JOINT_ASLEEP)
		joint_scale_asleep(p, i, h_ratio_at(p, i));
}

// Wakes a body in the next step, for a call of the user between two steps, or puts it to sleep there.
INLINE void body_set_awake(const Pools* p, int i, int awake)
{
	float still = p->still[i];
	if (!body_takes_part(p, i))
		return;
	if (awake && p->sleep[i])
		island_wake(p, i, WAKE_USER);
	if (awake && (still == STILL_FORCED || still > 0.0f))
		p->still[i] = 0.0f;
	if (!awake && p->sleep_threshold[i] >= 0.0f)
		p->still[i] = STILL_FORCED;
}

// Item: a body. argument: 1 to wake, 0 to sleep.
KERNEL(set_awake) { body_set_awake(p, i, p->argument); }

#ifndef SCREE_NO_BATCHES
// Item: a body of the bay y of an entry of bay_copy. Wakes it.
KERNEL(bay_wake)
{
	const Bays* bays = &p->step.bays;
	int n = bay_of_body(p, i), bay = p->bay_copy[n].y;
	if (p->bay[bay].sleep_threshold < 0.0f)
		return;
	if (i == n * bays->bodies && bay >= bays->worlds) // the next step clears the counter that island_wake sets
		p->bay_state[bay].woken = 1;
	body_set_awake(p, bay_item(bays->worlds, bay, i - n * bays->bodies, bays->bodies), 1);
}
#endif

// Item: a body that the user destroys, before its row is cleared.
KERNEL(body_gone) { body_gone_wake(p, i); }

// Writes 1 to the pool island for a body that sleeps and is not marked to wake, else 0.
KERNEL(sleep_report) { p->island[i] = body_sleeps_on(p, i); }

// Item: a partial sum over the bodies and contacts i, i + HASH_SUMS, i + 2 HASH_SUMS and so on. Its lower 32 bits are
// the number of sleeping bodies, its upper 32 bits that of their touching contacts. argument: number of bodies.
KERNEL(sleep_count)
{
	Word64 sum = 0;
	for (int k = i; k < p->argument; k += HASH_SUMS)
		sum += (Word64)body_sleeps_on(p, k);
	for (int k = i; k < p->counters->contacts; k += HASH_SUMS)
		sum += (Word64)(p->pair[k].x >= 0 && p->contact_flags[k] & CONTACT_ASLEEP) << 32;
	p->hash[i] = sum;
}

// Clears the marks of islands, and of bodies that the user moved.
KERNEL(sleep_end)
{
	p->wake[i] = 0;
	if (p->still[i] == STILL_MOVED)
		p->still[i] = 0.0f;
}

#endif
