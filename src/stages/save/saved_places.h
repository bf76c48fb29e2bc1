// SPDX-License-Identifier: MIT
// saved_places.h -- packs impulses, flags and poses of contacts by their places into a save, and unpacks them.
#ifndef SAVED_PLACES_H
#define SAVED_PLACES_H
#include "stages/save/saved_contacts.h"

// Bits of the first word of a place.
#define SAVED_SLOT_MASK    ((1u << SAVED_SLOT_BITS) - 1u)
#define SAVED_PADDING      0x40000000u
#define SAVED_PLACE_RESTED 0x80000000u

// Lists the values of a place that are mostly 0.
#define SAVED_PLACE_VALUES(NUMBER)                    \
	NUMBER(contact_rare(p, rolling_impulse, i), 0.0f) \
	NUMBER(contact_rare(p, total_impulse1, i), 0.0f)  \
	NUMBER(contact_rare(p, total_impulse2, i), 0.0f)  \
	NUMBER(contact_rare(p, approach1, i), 0.0f)       \
	NUMBER(contact_rare(p, approach2, i), 0.0f)

KERNEL(save_place)
{
	GLOBAL Word* row = saved_row(p, places, i);
	size_t by = saved_by(p, places);
	int slot = p->contact_place_slot[i], bit = 0;
	if (slot < 0)
	{
		row[0] = SAVED_PADDING;
		row[SAVED_IMPULSES * by] = (Word)contact_row(p, body_b, i);
		return;
	}
	Word name = (Word)slot, mask = 0, first = float_word(contact_row(p, normal_impulse1, i));
	SAVED_PLACE_VALUES(SAVED_DIFFERS_NUMBER)
	row[SAVED_IMPULSES * by] = first;
	if (mask != 0)
	{
		name |= SAVED_PLACE_RESTED;
		GLOBAL Word* rest = saved_rest(p, i, mask, first, row + SAVED_IMPULSES * by);
		bit = 0;
		if (rest)
		{
			SAVED_PLACE_VALUES(SAVED_PUT_NUMBER)
		}
	}
	Float4 relative = p->contact_manifold[slot].relative, then = p->contact_manifold[slot].then;
	row[0] = name;
	row[(SAVED_IMPULSES + 1) * by] = float_word(contact_row(p, normal_impulse2, i));
	row[(SAVED_IMPULSES + 2) * by] = float_word(contact_row(p, tangent_impulse1, i));
	row[(SAVED_IMPULSES + 3) * by] = float_word(contact_row(p, tangent_impulse2, i));
	row[SAVED_FLAGS * by] = p->contact_flags[slot];
	row[SAVED_POSE * by] = float_word(relative.x);
	row[(SAVED_POSE + 1) * by] = float_word(relative.y);
	row[(SAVED_POSE + 2) * by] = float_word(relative.z);
	row[(SAVED_POSE + 3) * by] = float_word(relative.w);
	row[(SAVED_POSE + 4) * by] = float_word(then.x);
	row[(SAVED_POSE + 5) * by] = float_word(then.y);
}

// Names the place of each contact that has one, before the contacts are unpacked.
KERNEL(load_place_name)
{
	Word name = *saved_row(p, places, i);
	if (!(name & SAVED_PADDING))
		p->contact_place[name & SAVED_SLOT_MASK] = i;
}

// Returns the color of a place: the last color that begins at this place or before it.
INLINE int saved_color(const Pools* p, int place)
{
	const GLOBAL KindLayout* layout = &p->counters->layout[CONSTRAINT_CONTACT];
	int color = 0;
	for (int step = (COLORS + 1) / 2; step > 0; step /= 2)
		color += layout->begin[color + step] <= place ? step : 0;
	return color;
}

// Unpacks a place, after all contacts.
KERNEL(load_place)
{
	const GLOBAL Word* row = saved_row(p, places, i);
	size_t by = saved_by(p, places);
	Word name = row[0], mask, first = row[SAVED_IMPULSES * by];
	if (name & SAVED_PADDING)
	{
		contact_pad(p, i);
		contact_row(p, body_b, i) = (int)first;
		p->contact_place_pair[i] = make_int2(0, 0);
		return;
	}
	const GLOBAL Word* rest = saved_open(p, (name & SAVED_PLACE_RESTED) != 0, &first, &mask);
	int slot = (int)(name & SAVED_SLOT_MASK), bit = 0;
	Int2 bodies = p->contact_bodies[slot];
	p->contact_color[slot] = saved_color(p, i);
	p->contact_place_slot[i] = slot;
	contact_row(p, body_a, i) = bodies.x;
	contact_row(p, body_b, i) = bodies.y;
	contact_set_place(p, slot, i);
	contact_row(p, normal_impulse1, i) = bits_float((int)first);
	contact_row(p, normal_impulse2, i) = bits_float((int)row[(SAVED_IMPULSES + 1) * by]);
	contact_row(p, tangent_impulse1, i) = bits_float((int)row[(SAVED_IMPULSES + 2) * by]);
	contact_row(p, tangent_impulse2, i) = bits_float((int)row[(SAVED_IMPULSES + 3) * by]);
	SAVED_PLACE_VALUES(SAVED_TAKE_NUMBER)
}

#endif
