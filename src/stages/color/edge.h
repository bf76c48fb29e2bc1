// SPDX-License-Identifier: MIT
// edge.h -- begins, ends, counts and reads edges, which are constraints of any kind, for coloring, relay and tiles.
#ifndef EDGE_H
#define EDGE_H
#include "constraints/constraint_kinds.h"
#include "stages/color/spoke.h"

INLINE int edge_of(int kind, int slot) { return kind << EDGE_KIND | slot; }
INLINE int edge_kind(int edge) { return CONSTRAINT_KINDS == 1 ? 0 : edge >> EDGE_KIND; }
INLINE int edge_slot(int edge) { return CONSTRAINT_KINDS == 1 ? edge : edge & ((1 << EDGE_KIND) - 1); }

INLINE Int2 edge_bodies(const Pools* p, int edge)
{
	int slot = edge_slot(edge);
#define CONSTRAINT_KIND(kind, Kind, KIND)     \
	if (edge_kind(edge) == CONSTRAINT_##KIND) \
		return p->kind##_bodies[slot];
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return make_int2(0, 0);
}

// Requests a new layout of the constraints of a kind, because one of them begins or ends. The hubs of spokes depend on
// the numbers of joints too (hub_owner).
INLINE void edge_mark_dirty(const Pools* p, int kind)
{
	raise_int(&p->counters->changed, 1);
	raise_int(&p->counters->dirty[kind], 1);
	if (kind == CONSTRAINT_JOINT && layout_has_spokes(p->counters))
		raise_int(&p->counters->dirty[CONSTRAINT_CONTACT], 1);
}

// Returns the value that a contact with a tangent speed adds to the pool belts. Both bodies get the same value, because
// the belt runs in the same direction (forward or backward) for both.
INLINE int edge_belt(float speed) { return speed > 0.0f ? 1 : speed < 0.0f ? BELT_BACK : 0; }

INLINE int edge_belt_of(const Pools* p, int kind, int slot)
{
	return kind == CONSTRAINT_CONTACT && p->step.belts ? edge_belt(p->contact_surface[slot].w) : 0;
}

INLINE void edge_add_belt(const Pools* p, Int2 bodies, int belt)
{
	if (belt == 0)
		return;
	atomic_add_int(&p->belts[bodies.x], belt);
	atomic_add_int(&p->belts[bodies.y], belt);
}

// Counts a constraint that begins, for one of its bodies. If the body may now be a hub and has constraints with colors,
// requests the search for contacts of new hubs. It may find none, because other constraints end in the same step.
INLINE void edge_count(const Pools* p, int body, int belt)
{
	int over_limit = atomic_add_int(&p->touching[body], 1) >= HUB_CONTACTS;
	int opposed = belt != 0 && hub_belts(atomic_add_int(&p->belts[body], belt) + belt);
	if ((over_limit || opposed) && p->body[body].inv_mass > 0.0f && read_shared_word64(&p->color_mask[body]) != 0)
		raise_int(&p->counters->gathered, p->counters->contacts);
}

// Counts a constraint that begins.
INLINE void edge_enter(const Pools* p, int edge, Int2 bodies)
{
	int belt = edge_belt_of(p, edge_kind(edge), edge_slot(edge));
	edge_count(p, bodies.x, belt);
	edge_count(p, bodies.y, belt);
	edge_mark_dirty(p, edge_kind(edge));
}

// Counts a constraint that begins, and returns it. The caller, a LIST_KERNEL, lists it, so that it gets a color later in
// the step.
INLINE int edge_begin(const Pools* p, int edge, Int2 bodies)
{
	edge_enter(p, edge, bodies);
	return edge;
}

#define EDGE_NONE (-1) // no edge is listed

INLINE void edge_free_color(const Pools* p, Int2 bodies, int color)
{
	Word64 others = ~((Word64)1 << color);
	if (color >= COLORS)
		return;
	atomic_and_word64(&p->color_mask[bodies.x], others);
	atomic_and_word64(&p->color_mask[bodies.y], others);
}

// Returns whether all bodies of a contact that can move sleep. Only such a contact may keep a color while it has no
// constraint, because the relay counts the colors of awake bodies (src/opencl/forms/registers.cl). A body of one island
// may wake before the search that joins the island to another one that it touches.
INLINE int edge_rests(const Pools* p, Int2 bodies)
{
	return (p->sleep[bodies.x] || !(p->body[bodies.x].inv_mass > 0.0f)) &&
	       (p->sleep[bodies.y] || !(p->body[bodies.y].inv_mass > 0.0f));
}

// Ends the constraint of slot i of a kind, which has begun; its kept values stay. keeps: whether a color below COLORS is
// kept too.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                                         \
	INLINE void kind##_leave(const Pools* p, int i, int keeps)                                    \
	{                                                                                             \
		int color = p->kind##_color[i];                                                           \
		Int2 bodies = p->kind##_bodies[i];                                                        \
		keeps = keeps && color < COLORS;                                                          \
		if (!keeps)                                                                               \
			edge_free_color(p, bodies, color);                                                    \
		atomic_add_int(&p->touching[bodies.x], -1);                                               \
		atomic_add_int(&p->touching[bodies.y], -1);                                               \
		edge_add_belt(p, bodies, -edge_belt_of(p, CONSTRAINT_##KIND, i));                         \
		p->kind##_color[i] = keeps ? COLOR_KEPT(color) : COLOR_NONE;                              \
		p->kind##_place[i] = -1;                                                                  \
		atomic_add_int(&p->counters->ended, 1);                                                   \
		edge_mark_dirty(p, CONSTRAINT_##KIND);                                                    \
	}                                                                                             \
	/* Ends the constraint of slot i, if it has begun, or gives up the color that it has kept. */ \
	INLINE void kind##_end(const Pools* p, int i)                                                 \
	{                                                                                             \
		int color = p->kind##_color[i];                                                           \
		if (color == COLOR_NONE)                                                                  \
			return;                                                                               \
		if (color < 0)                                                                            \
		{                                                                                         \
			edge_free_color(p, p->kind##_bodies[i], COLOR_KEPT(color));                           \
			p->kind##_color[i] = COLOR_NONE;                                                      \
			return;                                                                               \
		}                                                                                         \
		kind##_leave(p, i, 0);                                                                    \
		kind##_forget(p, i);                                                                      \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

INLINE void edge_set_color(const Pools* p, int edge, int color)
{
	int slot = edge_slot(edge);
#define CONSTRAINT_KIND(kind, Kind, KIND)     \
	if (edge_kind(edge) == CONSTRAINT_##KIND) \
		p->kind##_color[slot] = color;
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
}

// Returns the slot of the constraint at a place of a kind, -1 for padding.
INLINE int edge_slot_at(const Pools* p, int kind, int place)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (kind == CONSTRAINT_##NAME)        \
		return p->name##_place_slot[place];
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return -1;
}

INLINE int edge_color(const Pools* p, int kind, int slot)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (kind == CONSTRAINT_##NAME)        \
		return p->name##_color[slot];
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return COLOR_NONE;
}

// Returns the bodies of the constraint at a place that is not padding.
INLINE Int2 edge_bodies_at(const Pools* p, int kind, int place)
{
#define CONSTRAINT_KIND(name, Name, NAME) \
	if (kind == CONSTRAINT_##NAME)        \
		return make_int2(name##_row(p, body_a, place), name##_row(p, body_b, place));
#include "pools/kinds.def"
#undef CONSTRAINT_KIND
	return make_int2(0, 0);
}

// Task of a pass: a constraint or padding, given by kind and place. Tasks are numbered by color, then kind, then place.
typedef struct
{
	int kind, place;
} KindPlace;

INLINE int task_first(const GLOBAL Counters* c, int color)
{
	int first = 0;
	for (int kind = 0; kind < CONSTRAINT_KINDS; ++kind)
		first += c->layout[kind].begin[color];
	return first;
}

INLINE KindPlace task_at(const Pools* p, int t)
{
	KindPlace task;
	task.kind = 0;
	task.place = t;
	if (CONSTRAINT_KINDS == 1 || !p->step.joints)
		return task;
	const GLOBAL Counters* c = p->counters;
	int low = 0, high = COLORS;
	while (low < high)
	{
		int middle = (low + high + 1) / 2;
		if (task_first(c, middle) <= t)
			low = middle;
		else
			high = middle - 1;
	}
	int left = t - task_first(c, low);
	for (task.kind = 0; task.kind < CONSTRAINT_KINDS - 1; ++task.kind)
	{
		int count = c->layout[task.kind].begin[low + 1] - c->layout[task.kind].begin[low];
		if (left < count)
			break;
		left -= count;
	}
	task.place = c->layout[task.kind].begin[low] + left;
	return task;
}

#endif
