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

// Number of values of a collidable that are mostly as predicted: flags, old box, world shape.
#define SAVED_SHAPE_VALUES 13

INLINE void saved_list(Int flags, const Real box[4], const Real shape[8], Int values[SAVED_SHAPE_VALUES])
{
	values[0] = flags;
	for (int k = 0; k < 4; ++k)
		values[1 + k] = real_bits(box[k]);
	for (int k = 0; k < 8; ++k)
		values[5 + k] = real_bits(shape[k]);
}

INLINE Int saved_flags(Int traits)
{
	return (traits >> SAVED_LOW_FLAGS & (int)SAVED_LOW_FLAGS_MASK) | (traits >> SAVED_CHANGED & 3) * COLLIDABLE_CHANGED;
}

INLINE Int saved_flags_bits(Int flags)
{
	Int changed = (flags & (COLLIDABLE_CHANGED | COLLIDABLE_SHIFTED)) * ((1 << SAVED_CHANGED) / COLLIDABLE_CHANGED);
	return (flags & (int)SAVED_LOW_FLAGS_MASK) * (1 << SAVED_LOW_FLAGS) | changed;
}

// Takes the lowest bits of *all >> at as a difference in units in the last place, and returns the number with it. bits:
// mask of the difference. now: if not null, the difference to now[k] sets these bits first, if it fits.
INLINE Real saved_near(Real expected, const Real* now, int k, Word bits, Int* all, int at)
{
	Word middle = (bits + 1u) >> 1;
	Words from = (Words)real_bits(expected) - middle;
	if (now)
	{
		Words difference = (Words)real_bits(now[k]) - from;
		Int fits = (Int)((difference & ~bits) == 0);
		*all = *all | shifted(blend_int((*all & 0) + (int)middle, (Int)difference, fits), at);
	}
	return bits_real((Int)(from + (Words)(*all >> at & (int)bits)));
}

// Sets `shape` to the world shapes that follow from the two words of a row. there: lanes with a collidable. now: if not
// null, the bits of the differences are first set to those of these world shapes.
OUT_OF_LINE void saved_shape(const Pools* p, int i, Int there, const Real* now, Int* differences, Int* traits,
                             Real shape[8])
{
	Real own[4], pose[4], state[8];
	Vec middle;
	Int body = load_int(p->collidable_body, i), zero = body & 0, has = there & (body >= 0);
	body = blend_int(zero, body, has);
	load_rows4((GLOBAL float*)p->collidable_pose, i, own);
	gather_rows4((GLOBAL float*)p->pose, body, pose);
	gather_fixed_rows8((GLOBAL float*)p->body, body, state);
	gather_pairs((const GLOBAL float*)p->local_center, body, &middle.x, &middle.y);
	Int rests = (*traits & (int)SAVED_AT_REST) != 0, turns = (state[6] != splat(0.0f)) & (rests == 0);
	Vec before = vec(pose[2], pose[3]), position = vec(pose[0], pose[1]);
	position = vec_blend(vec_sub(position, vec(state[4], state[5])), position, rests);
	if (lane_bits(turns))
		before = vec_blend(before, vec_turn_back(vec_rotation(state[6]), before), turns);
	Vec turn = vec_turn(before, vec(own[2], own[3]));
	Int first = zero, second = zero; // bits of the differences
	if (!now)
	{
		first = *differences;
		second = *traits;
	}
	turn.x = saved_near(turn.x, now, 2, 255u, &first, 0);
	turn.y = saved_near(turn.y, now, 3, 255u, &first, 8);
	// the body may turn as the collidable does
	before = vec_blend(before, turn, (own[2] == splat(1.0f)) & (own[3] == splat(0.0f)));
	Vec center = vec_neg(vec_turn(before, vec(own[0] - middle.x, own[1] - middle.y)));
	center.x = saved_near(center.x, now, 4, SAVED_ARM_MASK, &second, 0);
	center.y = saved_near(center.y, now, 5, SAVED_ARM_MASK, &second, 7);
	position = vec_sub(position, center);
	position.x = saved_near(position.x, now, 0, 255u, &first, 16);
	position.y = saved_near(position.y, now, 1, 255u, &first, 24);
	if (now)
	{
		*differences = blend_int(zero, first, has);
		*traits = *traits | blend_int(zero, second, has);
	}
	shape[0] = blend(own[0], position.x, has);
	shape[1] = blend(own[1], position.y, has);
	shape[2] = blend(own[2], turn.x, has);
	shape[3] = blend(own[3], turn.y, has);
	shape[4] = only(center.x, has);
	shape[5] = only(center.y, has);
	shape[6] = bits_real(load_int(p->collidable_attribute, i));
	shape[7] = bits_real(body);
}

// Returns whether the next step stores the old box again before it reads it.
INLINE Int saved_renews(Int flags) { return (flags & COLLIDABLE_NEW_BOX) != 0; }

WIDE_KERNEL(save_collidable)
{
	GLOBAL int* row = (GLOBAL int*)saved_row(p, collidables, i);
	size_t by = saved_by(p, collidables);
	Real box[4], old_box[4], now[8], shape[8];
	load_rows4((GLOBAL float*)p->box, i, box);
	load_rows4((GLOBAL float*)p->old_box, i, old_box);
	load_rows8((GLOBAL float*)p->world_shape, i, now);
	Int flags = load_int(p->collidable_flags, i), zero = flags & 0;
	Int there = indices(i) < p->step.saved.collidables.items;
	Int differences = zero, traits = saved_flags_bits(flags);
	saved_shape(p, i, there, now, &differences, &traits, shape);
	Int same = there;
	for (int k = 0; k < 6; ++k)
		same = same & (real_bits(shape[k]) == real_bits(now[k]));
	if (lane_bits(there & (same == 0)))
	{
		Int rest_differences = zero, rest_traits = saved_flags_bits(flags) | (int)SAVED_AT_REST;
		Real rest_shape[8];
		saved_shape(p, i, there, now, &rest_differences, &rest_traits, rest_shape);
		differences = blend_int(rest_differences, differences, same);
		traits = blend_int(rest_traits, traits, same);
		for (int k = 0; k < 6; ++k)
			shape[k] = blend(rest_shape[k], shape[k], same);
	}
	Int values[SAVED_SHAPE_VALUES], expected[SAVED_SHAPE_VALUES], mask = zero;
	saved_list(flags, old_box, now, values);
	saved_list(saved_flags(traits), box, shape, expected);
	for (int k = 0; k < 4; ++k)
		values[1 + k] = blend_int(values[1 + k], expected[1 + k], saved_renews(flags));
	for (int k = 0; k < SAVED_SHAPE_VALUES; ++k)
		mask = mask | blend_int(zero, zero + (1 << k), there & (values[k] != expected[k]));
	traits = traits | blend_int(zero, zero + (int)SAVED_COLLIDABLE_RESTED, mask != 0);
	for (int k = 0; k < 4; ++k)
		store((GLOBAL float*)row + k * by, 0, box[k]);
	store_int(row + SAVED_DIFFERENCES * by, 0, differences);
	store_int(row + SAVED_TRAITS * by, 0, traits);
	Word lanes = lane_bits(mask);
	for (int k = 0; lanes >> k != 0; ++k)
	{
		GLOBAL Word* rest = 0;
		if (lanes >> k & 1)
			rest = saved_rest(p, i + k, (Word)lane(mask, k), float_word(lane(box[0], k)), (GLOBAL Word*)row + k);
		for (int v = 0; v < SAVED_SHAPE_VALUES && rest; ++v)
			if (lane(mask, k) >> v & 1)
				*rest++ = (Word)lane(values[v], k);
	}
}

WIDE_KERNEL(load_collidable)
{
	const GLOBAL int* row = (const GLOBAL int*)saved_row(p, collidables, i);
	size_t by = saved_by(p, collidables);
	Int there = indices(i) < p->step.saved.collidables.items, place = load_int(row, 0);
	Int differences = load_int(row + SAVED_DIFFERENCES * by, 0), traits = load_int(row + SAVED_TRAITS * by, 0);
	Real box[4], shape[8];
	for (int k = 0; k < 4; ++k)
		box[k] = load((const GLOBAL float*)row + k * by, 0);
	Word rested = lane_bits(there & ((traits & (int)SAVED_COLLIDABLE_RESTED) != 0));
	for (int k = 0; rested >> k != 0; ++k)
		if (rested >> k & 1)
			lane(box[0], k) = bits_float((int)saved_rest_at(p, (Word)lane(place, k))[1]);
	saved_shape(p, i, there, 0, &differences, &traits, shape);
	Int values[SAVED_SHAPE_VALUES];
	saved_list(saved_flags(traits), box, shape, values);
	for (int k = 0; rested >> k != 0; ++k)
	{
		const GLOBAL Word* rest = saved_rest_at(p, (Word)lane(place, k));
		Word mask = rested >> k & 1 ? rest[0] : 0;
		rest += 2;
		for (int v = 0; mask >> v != 0; ++v)
			if (mask >> v & 1)
				lane(values[v], k) = (int)*rest++;
	}
	Real old_box[4];
	for (int k = 0; k < 4; ++k)
		old_box[k] = bits_real(values[1 + k]);
	for (int k = 0; k < 8; ++k)
		shape[k] = bits_real(values[5 + k]);
	scatter_rows4((GLOBAL float*)p->box, indices(i), box, there);
	scatter_rows4((GLOBAL float*)p->old_box, indices(i), old_box, there);
	scatter_rows4of8((GLOBAL float*)p->world_shape, indices(i), shape, there);
	scatter_rows4of8((GLOBAL float*)p->world_shape + 4, indices(i), shape + 4, there);
	saved_put(p->collidable_flags, i, values[0], there);
}

#endif
