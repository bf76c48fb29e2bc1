// SPDX-License-Identifier: MIT
// saved_collidables.h -- packs the state of collidables that steps change into a save, and unpacks it.
//
// The world pose of a collidable is that at the start of the last step. It follows from the pose of its body and from the
// body's motion in the step, except for rounding. So only the differences are saved, in units in the last place.
#ifndef SAVED_COLLIDABLES_H
#define SAVED_COLLIDABLES_H
#include "dialect/vec.h"
#include "stages/save/saved_words.h"

// Words of a collidable: its enlarged box, then two words. The first word of the box is the place of the rest, if there
// is one. Bits of the two words: differences of cos, sin, x, y of the pose (8 bits each, the first word); of the arm (7 bits
// each), then flags.
#define SAVED_DIFFERENCES       4
#define SAVED_TRAITS            5
#define SAVED_ARM_MASK          127u
#define SAVED_LOW_FLAGS         14 // COLLIDABLE_NEW_BOX, COLLIDABLE_FAST, COLLIDABLE_MOVING, and bits of small collidables
#define SAVED_LOW_FLAGS_MASK    0x1fffu
#define SAVED_CHANGED           27          // COLLIDABLE_CHANGED and COLLIDABLE_SHIFTED
#define SAVED_AT_REST           0x20000000u // the world pose follows from the present pose of the body
#define SAVED_COLLIDABLE_RESTED 0x40000000u // the collidable has words in the rest

// Lists the values of a collidable that are mostly as predicted. shape: predicted world shape.
#define SAVED_COLLIDABLE_VALUES(INT, NUMBER)           \
	INT(p->collidable_flags[i], saved_flags(traits))   \
	NUMBER(p->old_box[i].x, box.x)                     \
	NUMBER(p->old_box[i].y, box.y)                     \
	NUMBER(p->old_box[i].z, box.z)                     \
	NUMBER(p->old_box[i].w, box.w)                     \
	NUMBER(p->world_shape[i].x, shape.x)               \
	NUMBER(p->world_shape[i].y, shape.y)               \
	NUMBER(p->world_shape[i].c, shape.c)               \
	NUMBER(p->world_shape[i].s, shape.s)               \
	NUMBER(p->world_shape[i].center_x, shape.center_x) \
	NUMBER(p->world_shape[i].center_y, shape.center_y) \
	INT(p->world_shape[i].attribute, shape.attribute)  \
	INT(p->world_shape[i].body, shape.body)

INLINE int saved_flags(Word traits)
{
	return (int)(traits >> SAVED_LOW_FLAGS & SAVED_LOW_FLAGS_MASK) |
	       (int)(traits >> SAVED_CHANGED & 3u) * COLLIDABLE_CHANGED;
}

INLINE Word saved_flags_bits(int flags)
{
	return ((Word)flags & SAVED_LOW_FLAGS_MASK) << SAVED_LOW_FLAGS | ((Word)flags / COLLIDABLE_CHANGED & 3u)
	                                                                     << SAVED_CHANGED;
}

// Takes the lowest bits of *bits as a difference in units in the last place, and returns the number with it. put: the
// difference to `wanted` replaces these bits first, if it fits.
OUT_OF_LINE float saved_near(float expected, float wanted, int put, Word bits, Word* all, int at)
{
	Word middle = (bits + 1u) >> 1;
	if (put)
	{
		Word difference = float_word(wanted) - float_word(expected) + middle;
		*all |= (difference <= bits ? difference : middle) << at;
	}
	return bits_float((int)(float_word(expected) + (*all >> at & bits) - middle));
}

// Returns the world shape of collidable i that follows from the two words of its row. put: first sets the bits of the
// differences to the world shape `now`.
OUT_OF_LINE WorldShape saved_shape(const Pools* p, int i, int put, WorldShape now, Word* differences, Word* traits)
{
	WorldShape shape;
	Float4 own = p->collidable_pose[i];
	int body = p->collidable_body[i];
	Vec position = vec(own.x, own.y), turn = vec(own.z, own.w), center = vec(0.0f, 0.0f);
	if (body >= 0)
	{
		Float4 pose = p->pose[body];
		Float2 middle = p->local_center[body];
		BodyState state = p->body[body];
		int rests = (*traits & SAVED_AT_REST) != 0;
		Vec before = vec(pose.z, pose.w);
		position = vec(pose.x, pose.y);
		if (!rests)
		{
			position = vec_sub(position, vec(state.dx, state.dy));
			if (state.da != 0.0f)
				before = vec_turn_back(vec_rotation(state.da), before);
		}
		turn = vec_turn(before, turn);
		turn.x = saved_near(turn.x, now.c, put, 255u, differences, 0);
		turn.y = saved_near(turn.y, now.s, put, 255u, differences, 8);
		if (own.z == 1.0f && own.w == 0.0f) // the body turns as the collidable does
			before = turn;
		center = vec_neg(vec_turn(before, vec(own.x - middle.x, own.y - middle.y)));
		center.x = saved_near(center.x, now.center_x, put, SAVED_ARM_MASK, traits, 0);
		center.y = saved_near(center.y, now.center_y, put, SAVED_ARM_MASK, traits, 7);
		position = vec_sub(position, center);
		position.x = saved_near(position.x, now.x, put, 255u, differences, 16);
		position.y = saved_near(position.y, now.y, put, 255u, differences, 24);
	}
	shape.x = position.x;
	shape.y = position.y;
	shape.c = turn.x;
	shape.s = turn.y;
	shape.center_x = center.x;
	shape.center_y = center.y;
	shape.attribute = p->collidable_attribute[i];
	shape.body = body >= 0 ? body : 0;
	return shape;
}

INLINE int saved_shape_is(WorldShape a, WorldShape b)
{
	return float_word(a.x) == float_word(b.x) && float_word(a.y) == float_word(b.y) &&
	       float_word(a.c) == float_word(b.c) && float_word(a.s) == float_word(b.s) &&
	       float_word(a.center_x) == float_word(b.center_x) && float_word(a.center_y) == float_word(b.center_y);
}

KERNEL(save_collidable)
{
	GLOBAL Word* row = saved_row(p, collidables, i);
	size_t by = saved_by(p, collidables);
	Float4 box = p->box[i];
	WorldShape now = p->world_shape[i], shape = now;
	Word differences = 0, traits = 0, mask = 0, flags = saved_flags_bits(p->collidable_flags[i]);
	for (int k = 0; k < 2; ++k)
	{
		differences = 0;
		traits = k == 0 ? flags : flags | SAVED_AT_REST;
		shape = saved_shape(p, i, 1, now, &differences, &traits);
		if (saved_shape_is(shape, now))
			break;
	}
	row[0] = float_word(box.x);
	row[by] = float_word(box.y);
	row[2 * by] = float_word(box.z);
	row[3 * by] = float_word(box.w);
	int bit = 0;
	SAVED_COLLIDABLE_VALUES(SAVED_DIFFERS_INT, SAVED_DIFFERS_NUMBER)
	if (mask != 0)
	{
		traits |= SAVED_COLLIDABLE_RESTED;
		GLOBAL Word* rest = saved_rest(p, mask, float_word(box.x), row);
		bit = 0;
		if (rest)
		{
			SAVED_COLLIDABLE_VALUES(SAVED_PUT_INT, SAVED_PUT_NUMBER)
		}
	}
	row[SAVED_DIFFERENCES * by] = differences;
	row[SAVED_TRAITS * by] = traits;
}

KERNEL(load_collidable)
{
	const GLOBAL Word* row = saved_row(p, collidables, i);
	size_t by = saved_by(p, collidables);
	Word differences = row[SAVED_DIFFERENCES * by], traits = row[SAVED_TRAITS * by], mask = 0, first = row[0];
	const GLOBAL Word* rest = row;
	if (traits & SAVED_COLLIDABLE_RESTED)
	{
		rest = saved_rest_at(p, first);
		mask = rest[0];
		first = rest[1];
		rest += 2;
	}
	Float4 box = make_float4(bits_float((int)first), bits_float((int)row[by]), bits_float((int)row[2 * by]),
	                         bits_float((int)row[3 * by]));
	p->box[i] = box;
	WorldShape shape = saved_shape(p, i, 0, p->world_shape[i], &differences, &traits);
	int bit = 0;
	SAVED_COLLIDABLE_VALUES(SAVED_TAKE_INT, SAVED_TAKE_NUMBER)
}

#endif
