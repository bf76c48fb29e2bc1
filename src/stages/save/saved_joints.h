// SPDX-License-Identifier: MIT
// saved_joints.h -- packs the state of joints that steps change into a save, and unpacks it.
//
// The kept rows of a joint are at its place, or at its slot if the joint has no place. So a save first copies the rows of a
// place to the slot, as a new layout does. All other rows of a place are prepared in each step.
#ifndef SAVED_JOINTS_H
#define SAVED_JOINTS_H
#include "constraints/constraint_kinds.h"
#include "constraints/joint_one.h"
#include "stages/save/saved_words.h"

// Words of a joint: the place, or that of the rest if there is one; traits; the kept values of JointKept.
#define SAVED_JOINT_TRAITS 1
#define SAVED_JOINT_KEPT   2

// Bits of the traits: the color plus SAVED_COLOR_ZERO (8 bits), then JOINT_* bits, then these bits.
#define SAVED_COLOR_ZERO   128
#define SAVED_JOINT_FLAGS  8
#define SAVED_FLAGS_MASK   0xffffu
#define SAVED_JOINT_RESTED 0x40000000u // the joint has words in the rest
#define SAVED_JOINT_PLACED 0x80000000u // the joint has a place

#define SAVED_RARE_VALUES ((int)(sizeof(JointRareKept) / sizeof(float)))

// Lists the values of a joint that are mostly as predicted, apart from its rare rows and its event.
#define SAVED_JOINT_VALUES(INT)                                                              \
	INT(p->joint_flags[i], (int)(traits >> SAVED_JOINT_FLAGS & SAVED_FLAGS_MASK))            \
	INT(p->joint_color[i], (int)(traits & 255u) - SAVED_COLOR_ZERO)                          \
	INT(p->joint_bodies[i].x, p->joint_color[i] == COLOR_NONE ? 0 : p->joint_data[i].body_a) \
	INT(p->joint_bodies[i].y, p->joint_color[i] == COLOR_NONE ? 0 : p->joint_data[i].body_b)

INLINE int saved_joint_places(const Pools* p) { return p->counters->layout[CONSTRAINT_JOINT].begin[COLORS + 1]; }

// Returns whether a joint has a place. The slot of a joint that was destroyed may contain an old place.
INLINE int saved_joint_placed(const Pools* p, int i)
{
	int place = p->joint_place[i];
	return place >= 0 && place < saved_joint_places(p) && p->joint_place_slot[place] == i;
}

#define SAVED_PUT_KEPT(name, gate, life, inert, read, written) \
	ROW_IF_KEPT_##life(row[by * word++] = float_word(kept->name);)
#define SAVED_TAKE_KEPT(name, gate, life, inert, read, written) \
	ROW_IF_KEPT_##life(kept->name = bits_float((int)row[by * word++]);)

KERNEL(save_joint)
{
	GLOBAL Word* row = saved_row(p, joints, i);
	size_t by = saved_by(p, joints), word = SAVED_JOINT_KEPT;
	const GLOBAL JointKept* kept = p->joint_kept + i;
	const GLOBAL Word* rare = (const GLOBAL Word*)(p->joint_rare_kept + i);
	const GLOBAL Word* event = (const GLOBAL Word*)(p->joint_event + i);
	int placed = saved_joint_placed(p, i), listed = i < p->counters->joint_events, bit = 0;
	if (placed)
		joint_keep(p, i, p->joint_place[i]);
	Word place = (Word)p->joint_place[i], mask = 0;
	Word traits = ((Word)(p->joint_color[i] + SAVED_COLOR_ZERO) & 255u) |
	              ((Word)p->joint_flags[i] & SAVED_FLAGS_MASK) << SAVED_JOINT_FLAGS |
	              (placed ? SAVED_JOINT_PLACED : 0u);
	SAVED_JOINT_VALUES(SAVED_DIFFERS_INT)
	for (int k = 0; k < SAVED_RARE_VALUES; ++k)
		mask |= (Word)(rare[k] != 0) << bit++;
	for (int k = 0; k < 4; ++k)
		mask |= (Word)(listed && event[k] != 0) << bit++;
	row[0] = place;
	JOINT_ROWS(SAVED_PUT_KEPT)
	if (mask != 0)
	{
		traits |= SAVED_JOINT_RESTED;
		GLOBAL Word* rest = saved_rest(p, i, mask, place, row);
		bit = 0;
		if (rest)
		{
			SAVED_JOINT_VALUES(SAVED_PUT_INT)
			for (int k = 0; k < SAVED_RARE_VALUES + 4; ++k)
				if (mask >> bit++ & 1u)
					*rest++ = k < SAVED_RARE_VALUES ? rare[k] : event[k - SAVED_RARE_VALUES];
		}
	}
	row[SAVED_JOINT_TRAITS * by] = traits;
}

// Clears a place, before load_joint fills those with a joint.
KERNEL(load_joint_place) { joint_pad(p, i); }

KERNEL(load_joint)
{
	const GLOBAL Word* row = saved_row(p, joints, i);
	size_t by = saved_by(p, joints), word = SAVED_JOINT_KEPT;
	GLOBAL JointKept* kept = p->joint_kept + i;
	GLOBAL Word* rare = (GLOBAL Word*)(p->joint_rare_kept + i);
	GLOBAL Word* event = (GLOBAL Word*)(p->joint_event + i);
	Word place = row[0], traits = row[SAVED_JOINT_TRAITS * by], mask;
	const GLOBAL Word* rest = saved_open(p, (traits & SAVED_JOINT_RESTED) != 0, &place, &mask);
	int bit = 0;
	SAVED_JOINT_VALUES(SAVED_TAKE_INT)
	for (int k = 0; k < SAVED_RARE_VALUES; ++k)
		rare[k] = mask >> bit++ & 1u ? *rest++ : 0u;
	for (int k = 0; k < 4; ++k)
		event[k] = mask >> bit++ & 1u ? *rest++ : 0u;
	JOINT_ROWS(SAVED_TAKE_KEPT)
	p->joint_place[i] = (int)place;
	if (!(traits & SAVED_JOINT_PLACED))
		return;
	joint_put_back(p, i, (int)place);
	p->joint_place_slot[place] = i;
	joint_row(p, body_a, place) = p->joint_bodies[i].x;
	joint_row(p, body_b, place) = p->joint_bodies[i].y;
}

#endif
