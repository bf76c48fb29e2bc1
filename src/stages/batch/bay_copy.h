// SPDX-License-Identifier: MIT
// bay_copy.h -- copies worlds of a batch from bay to bay: resets and pauses of worlds, without the host.
//
// A bay that is stepped is live. The constraints of its contacts and joints have rows, at places that the layout by color
// assigns. A bay that is never stepped is spare: its constraints have no places, their kept values are at their slots, and
// its items contain indices within the bay. A constraint that comes to a live bay gets a place behind those of the layout,
// and the next step makes a new layout.
#ifndef BAY_COPY_H
#define BAY_COPY_H
#include "constraints/joint_one.h"
#include "stages/color/color.h"
#include "stages/edit/active.h"

typedef struct // a copy, and the differences of indices in its bays
{
	int from, to;                  // items
	int body, collidable, contact; // to add to indices
	int live;                      // 1 if the bay of `to` is live
} BayCopy;

// Returns copy number n, for item k of a kind whose bays have `size` items.
INLINE BayCopy bay_copy(const Pools* p, int n, int k, int size)
{
	const Bays* bays = &p->step.bays;
	Int2 copy = p->bay_copy[n];
	int from = copy.x < bays->worlds ? copy.x : 0, to = copy.y < bays->worlds ? copy.y : 0;
	BayCopy c;
	c.from = bay_item(bays->worlds, copy.x, k, size);
	c.to = bay_item(bays->worlds, copy.y, k, size);
	c.body = (to - from) * bays->bodies;
	c.collidable = (to - from) * bays->collidables;
	c.contact = (to - from) * (1 << bays->contact_bits);
	c.live = copy.y < bays->worlds;
	return c;
}

// Copies the values of the world of copy n. A world that leaves the live bays takes along that joints have changed, and its
// number of steps; one that enters them runs, so it is not crowded. argument: Pipeline.steps.
INLINE void bay_copy_values(const Pools* p, int n, int live)
{
	Int2 copy = p->bay_copy[n];
	BayState state = p->bay_state[copy.x];
	Bay bay = p->bay[copy.x];
	bay.world = p->bay_row[n];
	if (live && state.joints_dirty)
		raise_int(&p->counters->joints_dirty, 0x7fffffff);
	if (live && p->step.belts)
		raise_int(&p->counters->belts, 1); // the belt of a contact may have changed just before the world was saved
	if (live != (copy.x < p->step.bays.worlds))
		state.steps += live ? -p->argument : p->argument;
	if (live && state.woken)
		raise_int(&p->counters->woken, 0x7fffffff);
	state.woken = live ? 0 : state.woken || p->counters->woken != 0;
	if (live)
		state.crowded = 0;
	else if (p->counters->joints_dirty)
		state.joints_dirty = 1;
	p->bay_state[copy.y] = state;
	p->bay[copy.y] = bay;
	if (bay.world >= 0)
		p->world_bay[bay.world] = copy.y;
}

// In the following functions all loads come before the first store, because a work-item of a GPU waits for each load behind a store.
//
// Copies body i of all copies.
INLINE void bay_copy_body(const Pools* p, int i)
{
	const Bays* bays = &p->step.bays;
	int n = bay_of_body(p, i);
	BayCopy c = bay_copy(p, n, i - n * bays->bodies, bays->bodies);
	int hub = p->hub[c.to]; // entry of the list of hubs, not a value of the body; its keys belong to the layout too
	Int2 hub_keys = p->hub_keys[c.to];
	int first = p->continuous_body[c.from].first, static_contact = p->static_contact[c.from];
	item_move(p, PER_BODY, c.to, c.from);
	p->hub[c.to] = hub;
	p->hub_keys[c.to] = hub_keys;
	if (i == n * bays->bodies)
		bay_copy_values(p, n, c.live);
	if (first > 0)
		p->continuous_body[c.to].first = first + c.collidable;
	if (c.live && p->step.sleep)
		active_touch(p, GROUPS_OF_BODIES, c.to);
	p->static_contact[c.to] =
	    static_contact + c.contact; // also of a body without such a contact; its value is compared with the pair
	body_stand(p, c.to);
}

// Copies collidable i of all copies.
INLINE void bay_copy_collidable(const Pools* p, int i)
{
	const Bays* bays = &p->step.bays;
	int n = bay_of_collidable(p, i);
	BayCopy c = bay_copy(p, n, i - n * bays->collidables, bays->collidables);
	int body = p->collidable_body[c.from], next = p->next_collidable[c.from], shape_body = p->world_shape[c.from].body;
	int differs = !box_equal(p->box[c.from], p->box[c.to]) || p->collidable_kind[c.from] != p->collidable_kind[c.to];
	item_move(p, PER_COLLIDABLE, c.to, c.from);
	if (body >= 0)
		p->collidable_body[c.to] = body + c.body;
	if (next > 0)
		p->next_collidable[c.to] = next + c.collidable;
	p->world_shape[c.to].body = shape_body + c.body;
	if (c.live && differs)
		raise_int(&p->counters->boxes_copied, 0x7fffffff);
	if (c.live && p->step.sleep)
		active_touch(p, GROUPS_OF_COLLIDABLES, c.to);
}

// Gives the constraint that was copied to slot `to` a place: that of the constraint before, if it had the same color, or
// one behind the layout. from_place, before: places of the source, and of the constraint before, or -1. color, color_before:
// colors of both. bodies: those of the copy. same: 1 if constraints of equal color may exchange places.
#define BAY_PLACE(kind, KIND, same)                                             \
	int place = -1;                                                             \
	if (from_place >= 0)                                                        \
		kind##_keep(p, c.to, from_place);                                       \
	if (c.live && color >= 0)                                                   \
	{                                                                           \
		place = place_before;                                                   \
		if (place < 0 || color != color_before || !(same))                      \
		{                                                                       \
			place = p->counters->layout[CONSTRAINT_##KIND].begin[COLORS + 1] +  \
			        atomic_add_int(&p->counters->placed[CONSTRAINT_##KIND], 1); \
			raise_int(&p->counters->stale_layout[CONSTRAINT_##KIND], 1);        \
		}                                                                       \
		p->kind##_place_slot[place] = c.to;                                     \
		kind##_row(p, body_a, place) = bodies.x;                                \
		kind##_row(p, body_b, place) = bodies.y;                                \
		kind##_set_place(p, c.to, place);                                       \
		kind##_put_back(p, from_place >= 0 ? c.to : c.from, place);             \
	}                                                                           \
	else if (place_before >= 0)                                                 \
		raise_int(&p->counters->stale_layout[CONSTRAINT_##KIND], 1);            \
	p->kind##_place[c.to] = place;

// Copies contact slot i of all copies.
INLINE void bay_copy_contact(const Pools* p, int i)
{
	const Bays* bays = &p->step.bays;
	int size = 1 << bays->contact_bits;
	BayCopy c = bay_copy(p, i >> bays->contact_bits, i & (size - 1), size);
	Int2 pair = p->pair[c.from], bodies = p->contact_bodies[c.from];
	int uses = pair.x >= 0, used = p->pair[c.to].x >= 0;
	if (!uses && !used) // most slots are free
		return;
	int color = uses ? p->contact_color[c.from] : COLOR_NONE, color_before = p->contact_color[c.to];
	int from_place = uses ? p->contact_place[c.from] : -1, place_before = p->contact_place[c.to];
	bodies = make_int2(bodies.x + c.body, bodies.y + c.body);
	item_move(p, PER_CONTACT, c.to, c.from);
	if (uses)
	{
		p->pair[c.to] = make_int2(pair.x + c.collidable, pair.y + c.collidable);
		p->contact_bodies[c.to] = bodies;
	}
	else
		p->contact_color[c.to] = COLOR_NONE;
	if (c.live && p->step.sleep)
		active_touch(p, GROUPS_OF_CONTACTS, c.to);
	if (c.live && uses != used)
		atomic_add_int(&p->counters->alive, uses - used);
	if (c.live && color == COLORS)
		raise_int(&p->counters->copied_spokes, 1);
	BAY_PLACE(contact, CONTACT, color_before < COLORS)
}

// Copies joint slot i of all copies. The spot in a chain is that of the bay, not of the world.
INLINE void bay_copy_joint(const Pools* p, int i)
{
	const Bays* bays = &p->step.bays;
	int size = 1 << bays->joint_bits;
	BayCopy c = bay_copy(p, i >> bays->joint_bits, i & (size - 1), size);
	int spot = p->joint_spot[c.to], color_before = p->joint_color[c.to], place_before = p->joint_place[c.to];
	int flags_before = p->joint_flags[c.to], flags = p->joint_flags[c.from];
	int color = p->joint_color[c.from], from_place = p->joint_place[c.from];
	Int2 bodies = p->joint_bodies[c.from];
	int a = p->joint_data[c.from].body_a + c.body, b = p->joint_data[c.from].body_b + c.body;
	int others = c.live && (p->joint_data[c.to].body_a != a || p->joint_data[c.to].body_b != b);
	bodies = make_int2(bodies.x + c.body, bodies.y + c.body);
	item_move(p, PER_JOINT, c.to, c.from);
	p->joint_spot[c.to] = spot;
	p->joint_bodies[c.to] = bodies;
	p->joint_data[c.to].body_a = a;
	p->joint_data[c.to].body_b = b;
	int changed = c.live ? (flags_before ^ flags) & ~JOINT_ASLEEP : 0;
	int acts = joint_wanted(flags) && !(flags & JOINT_ASLEEP);
	int begins = acts != (color != COLOR_NONE) || flags & (JOINT_NEW | JOINT_BEGINS_AGAIN);
	if (changed & (JOINT_THERE | JOINT_COLLIDES | JOINT_BROKEN) || others) // the pairs that joints keep apart
		raise_int(&p->counters->joints_dirty, 0x7fffffff);
	else if (c.live && (changed || begins))
		raise_int(&p->counters->joints_copied, 1);
	BAY_PLACE(joint, JOINT, color_before < COLORS || spot >= 0)
}

// Item: a joint slot, a body, a contact slot or a collidable of a copy, in this order, as bay_copy_items counts them: one run for all
// kinds, because a GPU takes as long for few items as one of them needs. argument: Pipeline.steps.
KERNEL(bay_copy_item)
{
	const Bays* bays = &p->step.bays;
	int joints = bays->copied_joints << bays->joint_bits, bodies = bays->copies * bays->bodies;
	int contacts = bays->copies << bays->contact_bits, collidables = bays->copies * bays->collidables, k = i;
	if (k < joints)
		bay_copy_joint(p, k);
	k -= bay_copy_whole(joints);
	if (k >= 0 && k < bodies)
		bay_copy_body(p, k);
	k -= bay_copy_whole(bodies);
	if (k >= 0 && k < contacts)
		bay_copy_contact(p, k);
	k -= bay_copy_whole(contacts);
	if (k >= 0 && k < collidables)
		bay_copy_collidable(p, k);
}

// Item: a contact slot, or a joint slot. Makes it free.
KERNEL(bay_clear_contact)
{
	p->pair[i] = make_int2(-1, -1);
	p->contact_color[i] = COLOR_NONE;
	p->contact_place[i] = -1;
}

KERNEL(bay_clear_joint)
{
	p->joint_color[i] = COLOR_NONE;
	p->joint_place[i] = -1;
}

// Item: a contact slot of a bay that is moved because bays get more slots. The list has the first slots of the bay, before
// and after. argument: binary logarithm of the number of slots before.
KERNEL(bay_move_contact)
{
	Int2 move = p->bay_copy[i >> p->argument];
	int k = i & ((1 << p->argument) - 1), from = move.x + k, to = move.y + k;
	if (from == to || p->pair[from].x < 0)
		return;
	item_move(p, PER_CONTACT, to, from);
	if (p->contact_place[to] >= 0)
		p->contact_place_slot[p->contact_place[to]] = to;
	p->pair[from] = make_int2(-1, -1);
	p->contact_flags[from] = 0;
	p->contact_color[from] = COLOR_NONE;
	p->contact_place[from] = -1;
}

// Item: one. Sets the numbers of slots of all live bays, and notes edits of the host. argument: bits of BAY_COUNT_*, and
// the number of live bays.
KERNEL(bay_count)
{
	GLOBAL Counters* c = p->counters;
	int edits = RUN_LOW(p->argument), live = RUN_HIGH(p->argument);
	c->contacts = live << p->step.bays.contact_bits;
	c->live = c->contacts;
	if (c->gathered) // the search for contacts of new hubs covers the new slots too
		c->gathered = c->contacts;
	c->joints = edits & BAY_COUNT_JOINTS ? live << p->step.bays.joint_bits : 0;
	if (edits & BAY_COUNT_SPOTS)
		c->joint_moved = c->joints_copied = 1;
	if (edits & BAY_COUNT_EXCLUDED)
		c->joints_dirty = 0x7fffffff;
	(void)i;
}

#endif
