// SPDX-License-Identifier: MIT
// saved_bodies.h -- packs the state of bodies that steps change into a save, and unpacks it.
#ifndef SAVED_BODIES_H
#define SAVED_BODIES_H
#include "stages/read/moved_bodies.h"
#include "stages/save/saved_words.h"

// Words of a body: pose, rounding errors, velocity, motion in the step, then these.
#define SAVED_STILL  12 // time at rest; the place of the rest of the body, if it has one
#define SAVED_COLORS 13 // lower half of the colors
#define SAVED_COUNTS 14 // numbers of contacts, and flags

// Bits of the word SAVED_COUNTS: lowest bits of each number. A number that does not fit is in the rest.
#define SAVED_OTHER       8
#define SAVED_STATIC      16
#define SAVED_KINEMATIC   24
#define SAVED_REPORTED    0x40000000u // the user has read the present pose
#define SAVED_BODY_RESTED 0x80000000u // the body has words in the rest

// Lists the values of a body that are mostly as predicted. counts: word SAVED_COUNTS; origin: pose as the user may have
// read it; high: upper half of the colors. Sleep comes first, because the predictions of other values depend on it.
#define SAVED_BODY_VALUES(INT, NUMBER)                                   \
	INT(p->sleep[i], 0)                                                  \
	NUMBER(p->motion[i].free_x, p->sleep[i] == 0 && moves ? 1.0f : 0.0f) \
	NUMBER(p->motion[i].free_y, p->sleep[i] == 0 && moves ? 1.0f : 0.0f) \
	NUMBER(p->motion[i].fx, 0.0f)                                        \
	NUMBER(p->motion[i].fy, 0.0f)                                        \
	NUMBER(p->motion[i].torque, 0.0f)                                    \
	INT(p->touching[i], (int)(counts & 255u))                            \
	INT(p->other_contacts[i], (int)(counts >> SAVED_OTHER & 255u))       \
	INT(p->fixed_contacts[i], saved_fixed(counts))                       \
	INT(p->static_contact[i], 0)                                         \
	INT(high, 0)                                                         \
	INT(p->belts[i], 0)                                                  \
	INT(p->press[i].way[0], 0)                                           \
	INT(p->press[i].way[1], 0)                                           \
	INT(p->press[i].depth, 0)                                            \
	INT(p->press[i].speed, 0)                                            \
	INT(p->press[i].left, 0)                                             \
	INT(p->press[i].tight, 0)                                            \
	INT(p->wake[i], 0)                                                   \
	INT(p->hub[i], 0)                                                    \
	INT(p->hub_colors[i], 0)                                             \
	INT(p->hub_keys[i].x, 0)                                             \
	INT(p->hub_keys[i].y, 0)                                             \
	INT(p->claim0[i], 0)                                                 \
	INT(p->claim1[i], 0)                                                 \
	NUMBER(p->reported_pose[i].x, origin.x)                              \
	NUMBER(p->reported_pose[i].y, origin.y)                              \
	NUMBER(p->reported_pose[i].z, origin.z)                              \
	NUMBER(p->reported_pose[i].w, origin.w)                              \
	INT(p->reported_sleep[i], 0)

// Returns the item of the pool fixed_contacts.
INLINE int saved_fixed(Word counts)
{
	return (int)(counts >> SAVED_STATIC & 255u) + (int)(counts >> SAVED_KINEMATIC & 63u) * KINEMATIC_CONTACT;
}

INLINE Float4 saved_origin(const Pools* p, int i, Word counts)
{
	return counts & SAVED_REPORTED ? reported_origin(p, i) : make_float4(0.0f, 0.0f, 0.0f, 0.0f);
}

KERNEL(save_body)
{
	GLOBAL Word* row = saved_row(p, bodies, i);
	size_t by = saved_by(p, bodies);
	Float4 pose = p->pose[i];
	Float2 low = p->pose_low[i];
	BodyState body = p->body[i];
	Word high = (Word)(p->color_mask[i] >> 32);
	int moves = body.inv_mass > 0.0f;
	Word counts = ((Word)p->touching[i] & 255u) | ((Word)p->other_contacts[i] & 255u) << SAVED_OTHER |
	              ((Word)STATIC_CONTACTS(p->fixed_contacts[i]) & 255u) << SAVED_STATIC |
	              (KINEMATIC_CONTACTS(p->fixed_contacts[i]) & 63u) << SAVED_KINEMATIC;
	if (p->reported_pose[i].z != 0.0f || p->reported_pose[i].w != 0.0f)
		counts |= SAVED_REPORTED;
	Float4 origin = saved_origin(p, i, counts);
	row[0] = float_word(pose.x);
	row[by] = float_word(pose.y);
	row[2 * by] = float_word(pose.z);
	row[3 * by] = float_word(pose.w);
	row[4 * by] = float_word(low.x);
	row[5 * by] = float_word(low.y);
	row[6 * by] = float_word(body.vx);
	row[7 * by] = float_word(body.vy);
	row[8 * by] = float_word(body.w);
	row[9 * by] = float_word(body.dx);
	row[10 * by] = float_word(body.dy);
	row[11 * by] = float_word(body.da);
	row[SAVED_STILL * by] = float_word(p->still[i]);
	row[SAVED_COLORS * by] = (Word)p->color_mask[i];
	Word mask = 0;
	int bit = 0;
	SAVED_BODY_VALUES(SAVED_DIFFERS_INT, SAVED_DIFFERS_NUMBER)
	if (mask != 0)
	{
		counts |= SAVED_BODY_RESTED;
		GLOBAL Word* rest = saved_rest(p, i, mask, float_word(p->still[i]), row + SAVED_STILL * by);
		bit = 0;
		if (rest)
		{
			SAVED_BODY_VALUES(SAVED_PUT_INT, SAVED_PUT_NUMBER)
		}
	}
	row[SAVED_COUNTS * by] = counts;
}

// Clears the speeds before the last step. The next step stores them again before it reads them.
INLINE void press_forget(const Pools* p, int i)
{
	p->press[i].before = 0.0f;
	p->press[i].spun = 0.0f;
}

KERNEL(load_body)
{
	const GLOBAL Word* row = saved_row(p, bodies, i);
	size_t by = saved_by(p, bodies);
	Word counts = row[SAVED_COUNTS * by], mask, still = row[SAVED_STILL * by];
	const GLOBAL Word* rest = saved_open(p, (counts & SAVED_BODY_RESTED) != 0, &still, &mask);
	p->pose[i] = make_float4(bits_float((int)row[0]), bits_float((int)row[by]), bits_float((int)row[2 * by]),
	                         bits_float((int)row[3 * by]));
	p->pose_low[i] = make_float2(bits_float((int)row[4 * by]), bits_float((int)row[5 * by]));
	GLOBAL BodyState* body = p->body + i;
	body->vx = bits_float((int)row[6 * by]);
	body->vy = bits_float((int)row[7 * by]);
	body->w = bits_float((int)row[8 * by]);
	body->dx = bits_float((int)row[9 * by]);
	body->dy = bits_float((int)row[10 * by]);
	body->da = bits_float((int)row[11 * by]);
	p->still[i] = bits_float((int)still);
	int bit = 0, moves = body->inv_mass > 0.0f;
	Word high;
	Float4 origin = saved_origin(p, i, counts);
	SAVED_BODY_VALUES(SAVED_TAKE_INT, SAVED_TAKE_NUMBER)
	press_forget(p, i);
	p->color_mask[i] = (Word64)row[SAVED_COLORS * by] | (Word64)high << 32;
}

#endif
