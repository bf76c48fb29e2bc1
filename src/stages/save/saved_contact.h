// SPDX-License-Identifier: MIT
// saved_contact.h -- packs the contacts of a world into a save, and unpacks them; saved_places.h has their impulses.
//
// Most contacts have two points and a place, or neither points nor impulses, and no value that differs from its
// prediction, except the pose of a manifold without points and the motion up to which it is kept. The kernels of this file
// process these, several at once; those of saved_contacts.h the others.
#ifndef SAVED_CONTACT_H
#define SAVED_CONTACT_H
#include "stages/save/saved_codes.h"
#include "stages/save/saved_prediction.h"
#include "stages/save/saved_words.h"

// Words of a contact: the pair, with bits of the code above the indices. The first word is the place of the rest, if there
// is one. Flags and pose of a contact that has a place are saved there (saved_places.h).
#define SAVED_PAIR_MASK ((1u << SAVED_PAIR_BITS) - 1u)
// The lower 8 bits of the code are above the first index, the upper 3 above the second one; CONTACT_FIXED has two of these
// bits if save_contact packs a contact without points, which needs no code. Then follow these bits.
#define SAVED_FREE           0x08000000u // the slot is free
#define SAVED_PLACED         0x10000000u // the contact has a place
#define SAVED_AHEAD          0x20000000u // the manifold is predicted
#define SAVED_CONTACT_RESTED 0x40000000u // the contact has words in the rest
#define SAVED_ODD            0x80000000u // save_contact has left the contact out

// Returns whether contacts have neither points nor impulses. m: manifold.
OUT_OF_LINE Int saved_is_empty(const Pools* p, int i, const Real m[16])
{
	Real kept[4], none = splat(NO_POINT);
	Int feature1, feature2, zero = indices(i) & 0;
	load_rows4((GLOBAL float*)p->contact_kept, i, kept);
	load_int2(p->contact_feature, i, &feature1, &feature2);
	Int bits = load_int((GLOBAL int*)p->contact_rare_kept, i) | real_bits(m[0]) | real_bits(m[1]);
	UNROLL
	for (int k = 0; k < 4; ++k)
		bits = bits | real_bits(kept[k]) | real_bits(m[4 + k]);
	return (bits == zero) & saved_same(m[2], none) & saved_same(m[3], none) & (feature1 == -1) & (feature2 == -1) &
	       (load_int(p->contact_place, i) < 0) & (load_int(p->contact_color, i) == COLOR_NONE);
}

// Appends tests of contacts from i on to the rest, each after the word of the row that becomes its place.
INLINE Int saved_tests(const Pools* p, int i, Int word, const Real test[SAVED_TEST], Word lanes)
{
	int count = 0;
	for (Word left = lanes; left != 0; left &= left - 1)
		count += 1 + SAVED_TEST;
	int place = saved_reserve(p, i, count);
	if (place < 0)
		return word;
	// the bound is redundant; without it gcc 12 unrolls the loop beyond the vector with SSE4.1, and stops with an internal error
	for (int k = 0; k < LANES && lanes >> k != 0; ++k)
		if (lanes >> k & 1)
		{
			GLOBAL int* rest = (GLOBAL int*)saved_words(p) + p->step.saved.rest + place;
			*rest++ = lane(word, k);
			for (int v = 0; v < SAVED_TEST; ++v)
				*rest++ = float_bits(lane(test[v], k));
			lane(word, k) = place;
			place += 1 + SAVED_TEST;
		}
	return word;
}

WIDE_KERNEL(save_contact)
{
	GLOBAL Word* row = saved_row(p, contacts, i);
	size_t by = saved_by(p, contacts);
	Int ia, ib, body_a, body_b, feature1, feature2;
	load_int2(p->pair, i, &ia, &ib);
	load_int2(p->contact_bodies, i, &body_a, &body_b);
	load_int2(p->contact_feature, i, &feature1, &feature2);
	Int there = (ia >= 0) & (indices(i) < p->counters->contacts), zero = ia & 0;
	if (SMALL_CODE) // the kernels of saved_contacts.h process all contacts, which saves 5 kB
	{
		store_int((GLOBAL int*)row + by, 0, blend_int(zero + (int)SAVED_FREE, zero + (int)SAVED_ODD, there));
		return;
	}
	ia = blend_int(zero, ia, there);
	ib = blend_int(zero, ib, there);
	Int a = gather_int(p->collidable_attribute, ia), b = gather_int(p->collidable_attribute, ib);
	Real m[16], surface[4], expected[4];
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * indices(i), m);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * indices(i) + 1, m + 8);
	load_rows4((GLOBAL float*)p->contact_surface, i, surface);
	SavedEdges e;
	saved_shapes(p, &e, a, b);
	saved_surface(e.at_a, e.at_b, expected);
	Int flags = load_int((const GLOBAL int*)p->contact_flags, i),
	    press = load_int((const GLOBAL int*)p->contact_press, i);
	Int ahead = saved_same(m[15], splat(-1.0f));

	// the edges follow from the features of the points; the normal is that of the reference edge, if it is in shape a
	e.edge = feature2 >> 8 & 7;
	Vec edge = saved_vec(p, a, e.edge + MAX_CORNERS);
	e.swap = (saved_same(edge.x, m[0]) & saved_same(edge.y, m[1])) == 0;
	e.edge = blend_int(e.edge, feature2 & 7, e.swap);
	e.other = blend_int(feature1, feature1 >> 8, e.swap) & 7;
	SavedEnds ends = saved_ends(p, e, vec(m[8], m[9]), vec(m[10], m[11]));
	Int common = there & (press == 0) & ((flags & (int)CONTACT_DETECTED) == 0) & (body_a == saved_body(p, ia)) &
	             (body_b == saved_body(p, ib)) & saved_same(m[14], e.at_a[TRAIT_REACH]);
	UNROLL
	for (int k = 0; k < 4; ++k)
		common = common & saved_same(surface[k], expected[k]);
	common = p->step.material_pairs > 0 ? zero : common;
	Int alike = common & (load_int(p->contact_place, i) >= 0) & ((flags & (int)CONTACT_COUNT) == 2);
	alike = alike & saved_same(m[0], ends.normal.x) & saved_same(m[1], ends.normal.y);
	alike = alike & (feature1 == ends.feature[0]) & (feature2 == ends.feature[1]);
	UNROLL
	for (int k = 0; k < 2; ++k)
		alike = alike & saved_same(m[2 + k], ends.separation[k]) & saved_same(m[4 + 2 * k], ends.point[k].x) &
		        saved_same(m[5 + 2 * k], ends.point[k].y);
	Int empty = common & ((flags & (int)CONTACT_COUNT) == 0);
	Int expects = saved_same(m[15], saved_limit(p, ia, ib, &e, empty, ahead));
	alike = alike & expects;
	if (lane_bits(empty))
	{
		empty = empty & saved_is_empty(p, i, m) & ((flags & ~(int)CONTACT_FIXED) == 0);
		Real test[SAVED_TEST];
		saved_pose(p, ia, ib, test);
		UNROLL
		for (int k = 0; k < 6; ++k)
			expects = expects & saved_same(test[k], m[8 + k]);
	}

	Int code = blend_int(zero, zero + (int)SAVED_SWAP, e.swap) | shifted(e.edge, SAVED_REFERENCE) |
	           (int)(SAVED_EDGES | SAVED_HIGH | SAVED_LOW);
	Int traits =
	    ib | shifted(e.other, SAVED_PAIR_BITS) | (int)SAVED_PLACED | blend_int(zero, zero + (int)SAVED_AHEAD, ahead);
	Int without = ib | blend_int(zero, zero + (int)SAVED_AHEAD, ahead) | (flags & (int)CONTACT_FIXED) |
	              blend_int(zero + (int)SAVED_CONTACT_RESTED, zero, expects);
	traits = blend_int(blend_int(zero + (int)SAVED_FREE, zero + (int)SAVED_ODD, there), traits, alike);
	traits = blend_int(traits, without, empty);
	Int first = ia | shifted(blend_int(code, zero + (int)SAVED_NO_POINTS, empty), SAVED_PAIR_BITS);
	Word tests = lane_bits(empty & (expects == 0));
	if (tests)
	{
		const Real test[SAVED_TEST] = {m[8], m[9], m[10], m[11], m[12], m[13], m[15]};
		first = saved_tests(p, i, first, test, tests);
	}
	store_int((GLOBAL int*)row, 0, first);
	store_int((GLOBAL int*)row + by, 0, traits);
}

// Writes the lanes where `wanted` is set.
INLINE void saved_put2(GLOBAL Int2* array, int i, Int x, Int y, Int wanted)
{
	Int old_x, old_y;
	load_int2(array, i, &old_x, &old_y);
	store_int2(array, i, blend_int(old_x, x, wanted), blend_int(old_y, y, wanted));
}

// Unpacks a contact, except for its impulses. contact_place has its place, if there is one.
WIDE_KERNEL(load_contact)
{
	const GLOBAL int* row = (const GLOBAL int*)saved_row(p, contacts, i);
	Int first = load_int(row, 0), traits = load_int(row + saved_by(p, contacts), 0);
	// a save of a GPU, whose work-items pack one contact each, does not have the rows that pad the last lanes
	Int alike = (indices(i) < p->step.saved.contacts.items) & ((traits & (int)(SAVED_FREE | SAVED_ODD)) == 0);
	Int placed = alike & ((traits & (int)SAVED_PLACED) != 0);
	if (SMALL_CODE || lane_bits(alike) == 0)
		return;
	Int zero = first & 0, empty = alike & (placed == 0), place = first;
	Int flags = traits & (int)CONTACT_FIXED;
	Word rested = lane_bits(alike & ((traits & (int)SAVED_CONTACT_RESTED) != 0));
	for (int k = 0; rested >> k != 0; ++k)
		if (rested >> k & 1)
			lane(first, k) = (int)*saved_rest_at(p, (Word)lane(place, k));
	Int ia = blend_int(zero, first & (int)SAVED_PAIR_MASK, alike);
	Int ib = blend_int(zero, traits & (int)SAVED_PAIR_MASK, alike), code = first >> SAVED_PAIR_BITS;
	Int a = gather_int(p->collidable_attribute, ia), b = gather_int(p->collidable_attribute, ib);
	Int body_a = saved_body(p, ia), body_b = saved_body(p, ib);
	Real m[16], surface[4];
	UNROLL
	for (int k = 0; k < 6; ++k)
		m[8 + k] = splat(0.0f);
	if (lane_bits(empty))
		saved_pose(p, ia, ib, m + 8);
	if (lane_bits(placed))
	{
		const GLOBAL int* at_place = (const GLOBAL int*)saved_row(p, places, 0);
		size_t by_place = saved_by(p, places);
		Int at = blend_int(zero, load_int(p->contact_place, i), placed);
		flags = blend_int(flags, gather_int(at_place + SAVED_FLAGS * by_place, at), placed);
		UNROLL
		for (int k = 0; k < 6; ++k)
			m[8 + k] = blend(m[8 + k], gather((const GLOBAL float*)at_place + (SAVED_POSE + k) * by_place, at), placed);
	}
	SavedEdges e;
	saved_shapes(p, &e, a, b);
	m[14] = e.at_a[TRAIT_REACH];
	m[15] = saved_limit(p, ia, ib, &e, empty, (traits & (int)SAVED_AHEAD) != 0);
	for (int k = 0; rested >> k != 0; ++k)
		for (int v = 0; v < SAVED_TEST && rested >> k & 1; ++v)
			lane(m[v < 6 ? 8 + v : 15], k) = bits_float((int)saved_rest_at(p, (Word)lane(place, k))[1 + v]);
	e.swap = (code & (int)SAVED_SWAP) != 0;
	e.edge = code >> SAVED_REFERENCE & 7;
	e.other = traits >> SAVED_PAIR_BITS & 7;
	SavedEnds ends = saved_ends(p, e, vec(m[8], m[9]), vec(m[10], m[11]));
	m[0] = only(ends.normal.x, empty == 0);
	m[1] = only(ends.normal.y, empty == 0);
	UNROLL
	for (int k = 0; k < 2; ++k)
	{
		m[2 + k] = blend(ends.separation[k], splat(NO_POINT), empty);
		m[4 + 2 * k] = only(ends.point[k].x, empty == 0);
		m[5 + 2 * k] = only(ends.point[k].y, empty == 0);
		ends.feature[k] = blend_int(ends.feature[k], zero - 1, empty);
	}
	saved_surface(e.at_a, e.at_b, surface);
	UNROLL
	for (int k = 0; k < 4; ++k)
		scatter_rows4of8((GLOBAL float*)p->contact_manifold + 4 * k, 2 * indices(i), m + 4 * k, alike);
	const Real none[4] = {splat(0.0f), splat(0.0f), splat(0.0f), splat(0.0f)};
	scatter_rows4((GLOBAL float*)p->contact_surface, indices(i), surface, alike);
	scatter_rows4((GLOBAL float*)p->contact_kept, indices(i), none, alike);
	saved_put((GLOBAL int*)p->contact_rare_kept, i, zero, alike);
	saved_put2(p->pair, i, ia, ib, alike);
	saved_put2(p->contact_bodies, i, body_a, body_b, alike);
	saved_put2(p->contact_feature, i, ends.feature[0], ends.feature[1], alike);
	saved_put((GLOBAL int*)p->contact_flags, i, flags, alike);
	saved_put((GLOBAL int*)p->contact_press, i, zero, alike);
	saved_put(p->contact_color, i, zero + COLOR_NONE, alike);
	saved_put(p->contact_place, i, zero - 1, empty);
}

#endif
