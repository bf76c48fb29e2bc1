// SPDX-License-Identifier: MIT
// layout_patch.h -- repairs the layout of the constraints of a batch on a CPU: most steps need no new layout.
//
// A new layout copies all constraints. In a batch that moves, a few constraints begin and end in each step. The places of
// those that ended become padding, and those that began take places of padding of their color. The order of constraints
// within a color changes no bit, because no two of them share a body that can move. Spokes, chains and joints without a
// color always need a new layout.
#ifndef LAYOUT_PATCH_H
#define LAYOUT_PATCH_H
#include "stages/color/color.h"

// Returns whether the layout of a kind can be repaired. left: number of edges without a color.
INLINE int patch_applies(const Pools* p, int kind, int left)
{
	const GLOBAL Counters* c = p->counters;
	if (!c->dirty[kind] || c->stalled || left != 0 || c->layout[kind].count[COLORS] > 0)
		return 0;
	if (kind == CONSTRAINT_CONTACT)
		return !c->entered && !c->copied_spokes && c->hubs == 0;
	return p->step.chain_places == 0 && c->overflow == 0;
}

// Ends the repair of a kind that has a place for each constraint.
INLINE void patch_end(const Pools* p, int kind, int constraints)
{
	GLOBAL Counters* c = p->counters;
	c->dirty[kind] = c->stale_layout[kind] = c->placed[kind] = 0;
	if (kind == CONSTRAINT_CONTACT)
		c->touching = constraints;
}

// Returns the first place of a color from `place` on that may be free. slots: slots of the places.
INLINE int patch_skip(const GLOBAL KindLayout* layout, const GLOBAL int* slots, int color, int place)
{
	int end = layout->begin[color] + layout->count[color];
	while (place < end && slots[place] >= 0)
		++place;
	return place;
}

// Makes the places of constraints that have ended padding.
#define PATCH_FREE(kind)                                                                                   \
	for (int color = 0; color < COLORS; ++color)                                                           \
		for (int k = 0, place = layout->begin[color]; k < layout->count[color]; ++k, ++place)              \
			if (p->kind##_place_slot[place] >= 0 && p->kind##_place[p->kind##_place_slot[place]] != place) \
				kind##_pad(p, place);

// Moves a constraint from its old place, -1 for none, to another one.
#define PATCH_MOVE(kind)                                     \
	if (old >= 0)                                            \
	{                                                        \
		kind##_keep(p, slot, old);                           \
		kind##_pad(p, old);                                  \
	}                                                        \
	p->kind##_place[slot] = place;                           \
	p->kind##_place_slot[place] = slot;                      \
	kind##_row(p, body_a, place) = p->kind##_bodies[slot].x; \
	kind##_row(p, body_b, place) = p->kind##_bodies[slot].y; \
	kind##_set_place(p, slot, place);                        \
	kind##_put_back(p, slot, place);

// Item: one. Repairs the layout of a kind. If some constraint gets no place, the kind stays marked as changed, and a new
// layout follows. argument: index in `uncolored` of the count after the last round.
#define CONSTRAINT_KIND(kind, Kind, KIND)                                              \
	KERNEL(kind##_patch)                                                               \
	{                                                                                  \
		GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_##KIND];           \
		int next[COLORS], constraints = 0, slots = p->counters->kind##s;               \
		if (!patch_applies(p, CONSTRAINT_##KIND, p->counters->uncolored[p->argument])) \
			return;                                                                    \
		PATCH_FREE(kind)                                                               \
		for (int color = 0; color < COLORS; ++color)                                   \
			next[color] = layout->begin[color];                                        \
		for (int slot = 0; slot < slots; ++slot)                                       \
		{                                                                              \
			int color = p->kind##_color[slot], old = p->kind##_place[slot];            \
			if (color < 0)                                                             \
				continue;                                                              \
			if (color >= COLORS)                                                       \
				return;                                                                \
			++constraints;                                                             \
			if (old >= layout->begin[color] && old < layout->begin[color + 1])         \
				continue;                                                              \
			int place = patch_skip(layout, p->kind##_place_slot, color, next[color]);  \
			if (place >= layout->begin[color + 1])                                     \
				return;                                                                \
			next[color] = place + 1;                                                   \
			if (place >= layout->begin[color] + layout->count[color])                  \
				layout->count[color] = place + 1 - layout->begin[color];               \
			PATCH_MOVE(kind)                                                           \
		}                                                                              \
		patch_end(p, CONSTRAINT_##KIND, constraints);                                  \
		(void)i;                                                                       \
	}
#include "pools/kinds.def"
#undef CONSTRAINT_KIND

#endif
