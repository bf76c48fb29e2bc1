// SPDX-License-Identifier: MIT
// saved_contacts.h -- packs the contacts that saved_contact.h leaves out, and unpacks them.
//
// Some values of a contact are left over from earlier and never read again: all values of a free slot, and the kept
// impulses of a contact that has a place. Saves do not have these values; tidy.h clears them for snapshots.
#ifndef SAVED_CONTACTS_H
#define SAVED_CONTACTS_H
#include "stages/broad_phase/contact_slots.h"
#include "stages/save/saved_values.h"

// Packs a contact that save_contact has left out.
KERNEL(save_contact_odd)
{
	GLOBAL Word* row = saved_row(p, contacts, i);
	size_t by = saved_by(p, contacts);
	if (row[by] != SAVED_ODD)
		return;
	Int2 pair = p->pair[i];
	LocalManifold manifold = p->contact_manifold[i];
	int a = p->collidable_attribute[pair.x], b = p->collidable_attribute[pair.y];
	int placed = p->contact_place[i] >= 0, ahead = manifold.then.w == -1.0f;
	SavedTest t;
	t.flags = (int)p->contact_flags[i];
	t.relative = manifold.relative;
	t.axes = vec(manifold.then.x, manifold.then.y);
	SavedTest s = placed ? t : saved_test_expected(p, pair); // save_place saves those of a contact that has a place
	SavedContact c, e = saved_expected(p, pair, (Word)t.flags, ahead);
	c.color = placed ? COLOR_NONE : p->contact_color[i];
	c.bodies = p->contact_bodies[i];
	c.feature = p->contact_feature[i];
	for (int k = 0; k < 5; ++k)
		c.kept[k] = 0.0f;
	if (!placed)
	{
		ContactKept kept = p->contact_kept[i];
		c.kept[0] = kept.normal_impulse1;
		c.kept[1] = kept.normal_impulse2;
		c.kept[2] = kept.tangent_impulse1;
		c.kept[3] = kept.tangent_impulse2;
		c.kept[4] = p->contact_rare_kept[i].rolling_impulse;
	}
	c.normal = vec(manifold.normal.x, manifold.normal.y);
	c.on_a = manifold.on_a;
	c.separation1 = manifold.normal.z;
	c.separation2 = manifold.normal.w;
	c.reach = manifold.then.z;
	c.limit = manifold.then.w;
	c.press = (int)p->contact_press[i];
	c.surface = p->contact_surface[i];

	Frame f = saved_frame(t);
	Word code = 0, mask = 0;
	for (int k = 0;; ++k)
	{
		code = saved_code(p->attribute + a, p->attribute + b, (int)((Word)t.flags & CONTACT_COUNT), c.feature, c.normal,
		                  k);
		saved_set_manifold(&e, saved_manifold(p, a, b, f, code));
		if ((code & SAVED_WAY) == SAVED_NO_POINTS || saved_manifold_is(c, e))
			break;
	}
	int bit = 0;
	SAVED_TEST_VALUES(SAVED_DIFFERS_INT, SAVED_DIFFERS_NUMBER)
	SAVED_CONTACT_VALUES(SAVED_DIFFERS_INT, SAVED_DIFFERS_NUMBER)
	Word first = (Word)pair.x | code << SAVED_PAIR_BITS;
	Word traits =
	    SAVED_ODD | (code >> 8) << SAVED_PAIR_BITS | (placed ? SAVED_PLACED : 0u) | (ahead ? SAVED_AHEAD : 0u);
	row[0] = first;
	if (mask != 0)
	{
		traits |= SAVED_CONTACT_RESTED;
		GLOBAL Word* rest = saved_rest(p, i, mask, first, row);
		bit = 0;
		if (rest)
		{
			SAVED_TEST_VALUES(SAVED_PUT_INT, SAVED_PUT_NUMBER)
			SAVED_CONTACT_VALUES(SAVED_PUT_INT, SAVED_PUT_NUMBER)
		}
	}
	row[by] = (Word)pair.y | traits;
}

// Clears a free slot.
INLINE void contact_clear(const Pools* p, int i)
{
	item_clear(p, PER_CONTACT, i);
	p->pair[i] = make_int2(-1, -1);
	p->contact_color[i] = COLOR_NONE;
	p->contact_place[i] = -1;
}

// Unpacks a contact that save_contact has left out, or a free slot. contact_place has the place of the contact.
KERNEL(load_contact_odd)
{
	const GLOBAL Word* row = saved_row(p, contacts, i);
	Word first = row[0], traits = row[saved_by(p, contacts)], mask;
	if (i >= p->counters->contacts || !(traits & (SAVED_FREE | SAVED_ODD)))
		return;
	if (traits & SAVED_FREE)
	{
		contact_clear(p, i);
		return;
	}
	const GLOBAL Word* rest = saved_open(p, (traits & SAVED_CONTACT_RESTED) != 0, &first, &mask);
	Int2 pair = make_int2((int)(first & SAVED_PAIR_MASK), (int)(traits & SAVED_PAIR_MASK));
	Word code = first >> SAVED_PAIR_BITS | (traits >> SAVED_PAIR_BITS & 7u) << 8;
	int a = p->collidable_attribute[pair.x], b = p->collidable_attribute[pair.y];
	int placed = (traits & SAVED_PLACED) != 0, bit = 0;
	SavedTest t, s = placed ? saved_test_at(p, p->contact_place[i]) : saved_test_expected(p, pair);
	SAVED_TEST_VALUES(SAVED_TAKE_INT, SAVED_TAKE_NUMBER)
	SavedContact c, e = saved_expected(p, pair, (Word)t.flags, (traits & SAVED_AHEAD) != 0);
	saved_set_manifold(&e, saved_manifold(p, a, b, saved_frame(t), code));
	SAVED_CONTACT_VALUES(SAVED_TAKE_INT, SAVED_TAKE_NUMBER)

	LocalManifold manifold;
	manifold.normal = make_float4(c.normal.x, c.normal.y, c.separation1, c.separation2);
	manifold.on_a = c.on_a;
	manifold.relative = t.relative;
	manifold.then = make_float4(t.axes.x, t.axes.y, c.reach, c.limit);
	ContactKept kept;
	ContactRareKept rare_kept;
	kept.normal_impulse1 = c.kept[0];
	kept.normal_impulse2 = c.kept[1];
	kept.tangent_impulse1 = c.kept[2];
	kept.tangent_impulse2 = c.kept[3];
	rare_kept.rolling_impulse = c.kept[4];
	p->pair[i] = pair;
	p->contact_flags[i] = (Word)t.flags;
	p->contact_color[i] = c.color;
	p->contact_bodies[i] = c.bodies;
	if (!placed)
		p->contact_place[i] = -1;
	p->contact_kept[i] = kept;
	p->contact_rare_kept[i] = rare_kept;
	p->contact_feature[i] = c.feature;
	p->contact_manifold[i] = manifold;
	p->contact_press[i] = (Word)c.press;
	p->contact_surface[i] = c.surface;
}

#endif
