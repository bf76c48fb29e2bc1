// SPDX-License-Identifier: MIT
// prepare.h -- the points of contacts for the step, to where the passes stream them.
#ifndef PREPARE_H
#define PREPARE_H
#include "stages/rolling.h"

// the deepest overlap seen, for the user's counters
INLINE void prepare_depth(const Pools* p, Real separation)
{
	Word deeper = lane_bits(separation < splat(-bits_float(read_shared(&p->counters->penetration))));
	for (int k = 0; deeper >> k != 0; ++k)
		if (deeper >> k & 1)
			atomic_max_int(&p->counters->penetration, float_bits(-lane(separation, k)));
}

// What the passes need of the points of constraint i. Padding, which has no slot, stays inert.
INLINE ContactPoints prepare_points(const Pools* p, int i, Int slot)
{
	Int there = slot >= 0, ia, ib;
	load_int2(p->constraint_pair, i, &ia, &ib);
	slot = slot & ~(slot >> 31);
	Real a[8], b[8], found[16];
	gather_fixed_rows8((GLOBAL float*)p->placed, ia, a);
	gather_fixed_rows8((GLOBAL float*)p->placed, ib, b);
	gather_fixed_rows8((GLOBAL float*)p->contact_found, 2 * slot, found);
	gather_fixed_rows8((GLOBAL float*)p->contact_found, 2 * slot + 1, found + 8);
	Int flags = there & 0, rolls = flags;
	if (p->step.round)
	{
		flags = gather_int((const GLOBAL int*)p->contact_flags, slot);
		rolls = there & ((flags & (int)FOUND_ROLLS) != 0);
	}
	ContactPoints points;
	if (LANES > 1 || !lane_bits(rolls))
		points = contact_points_held(a, b, found);
	if (lane_bits(rolls))
	{
		Int feature[2];
		feature[0] = gather_int((const GLOBAL int*)p->contact_feature, 2 * slot);
		feature[1] = gather_int((const GLOBAL int*)p->contact_feature, 2 * slot + 1);
		ContactPoints rolling =
		    rolling_step(p, a, b, found, flags, feature, load(&constraint_at(p, normal_impulse1, i), 0),
		                 load(&constraint_at(p, normal_impulse2, i), 0));
		points = LANES > 1 ? contact_points_choose(points, rolling, rolls) : rolling;
	}
	Vec zero = vec(splat(0.0f), splat(0.0f));
	points.normal = vec_choose(zero, points.normal, there);
	points.offset = vec_choose(zero, points.offset, there);
	for (int k = 0; k < 2; ++k)
	{
		points.anchor[k] = vec_choose(zero, points.anchor[k], there);
		points.separation[k] = choose(splat(NO_POINT), points.separation[k], there);
	}
	prepare_depth(p, minimum(points.separation[0], points.separation[1]));
	return points;
}

// so many constraints before they are prepared, what they gather is fetched
#define PREPARE_SOON 32

WIDE_STAGE(prepare)
{
	int soon = FETCHES && p->step.collidables >= FETCH_COLLIDABLES ? i + PREPARE_SOON + LANES : 0;
	for (int k = i + PREPARE_SOON; k < soon && k < p->counters->color_begin[COLORS + 1]; ++k)
	{
		int slot = p->constraint_contact[k];
		Int2 pair = p->constraint_pair[k];
		fetch_soon(p->contact_found + (slot & ~(slot >> 31)));
		fetch_soon(p->placed + pair.x);
		fetch_soon(p->placed + pair.y);
	}
	ContactPoints points = prepare_points(p, i, load_int(p->constraint_contact, i));
	store(&constraint_at(p, normal_x, i), 0, points.normal.x);
	store(&constraint_at(p, normal_y, i), 0, points.normal.y);
	store(&constraint_at(p, offset_x, i), 0, points.offset.x);
	store(&constraint_at(p, offset_y, i), 0, points.offset.y);
	store(&constraint_at(p, anchor1_x, i), 0, points.anchor[0].x);
	store(&constraint_at(p, anchor1_y, i), 0, points.anchor[0].y);
	store(&constraint_at(p, anchor2_x, i), 0, points.anchor[1].x);
	store(&constraint_at(p, anchor2_y, i), 0, points.anchor[1].y);
	store(&constraint_at(p, separation1, i), 0, points.separation[0]);
	store(&constraint_at(p, separation2, i), 0, points.separation[1]);
}

#endif
