// SPDX-License-Identifier: MIT
// contact_prepare.h -- computes the points of a contact for the step, from its manifold.
#ifndef CONTACT_PREPARE_H
#define CONTACT_PREPARE_H
#include "constraints/contact_constraint.h"
#include "constraints/rolling.h"
#include "pools/bays.h"

// Raises the deepest overlap of the world of each contact, in a batch.
INLINE void prepare_bay_depth(const Pools* p, Int slot, Real separation)
{
	GLOBAL int* depth = &p->bay_state->penetration;
	Int at = (slot >> p->step.bays.contact_bits) * BAY_WORDS;
	Word deeper = lane_bits(separation < -gather((const GLOBAL float*)depth, at));
	for (int k = 0; deeper >> k != 0; ++k)
		if (deeper >> k & 1)
			atomic_max_int(depth + lane(at, k), float_bits(-lane(separation, k)));
}

// Raises Counters.penetration, which the user can read: m, deepest overlap. slot: 0 for padding, which overlaps nothing.
INLINE void prepare_depth(const Pools* p, Int slot, Real separation)
{
	Word deeper = lane_bits(separation < splat(-bits_float(read_shared(&p->counters->penetration))));
	raise_lanes(&p->counters->penetration, -separation, deeper);
	if (BATCHED(p))
		prepare_bay_depth(p, slot, separation);
}

// Tests whether the overlap of a contact with the second collidable of its pair exceeds PRESS_START (static) or
// PRESS_FROM (other kinds). Then sets Counters.press[1] if this collidable is kinematic, or press[0] if it cannot move.
INLINE void prepare_press(const Pools* p, int i, Real separation)
{
	Word deep = p->step.presses ? lane_bits(separation < splat(-PRESS_FROM)) : 0;
	for (int k = 0; deep != 0; ++k, deep >>= 1)
	{
		int kind = deep & 1 ? p->collidable_kind[p->contact_place_pair[i + k].y] : KIND_DYNAMIC;
		float least = kind == KIND_STATIC ? PRESS_START : PRESS_FROM;
		if (kind != KIND_DYNAMIC && -lane(separation, k) > least)
		{
			raise_int(&p->counters->press[kind == KIND_KINEMATIC], 1);
			if (BATCHED(p))
				raise_int(&bay_of_contact(p, p->contact_place_slot[i + k])->press[kind == KIND_KINEMATIC], 1);
		}
	}
}

// Computes the points of constraint i for the passes. Padding, which has slot -1, gets no points.
INLINE ContactPoints prepare_points(const Pools* p, int i, Int slot)
{
	Int there = slot >= 0, ia, ib;
	load_int2(p->contact_place_pair, i, &ia, &ib);
	slot = slot & ~(slot >> 31);
	Real a[8], b[8], manifold[16];
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ia, a);
	gather_fixed_rows8((GLOBAL float*)p->world_shape, ib, b);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * slot, manifold);
	gather_fixed_rows8((GLOBAL float*)p->contact_manifold, 2 * slot + 1, manifold + 8);
	Int flags = there & 0, has_rolling = flags;
	if (p->step.round)
	{
		flags = gather_int((const GLOBAL int*)p->contact_flags, slot);
		has_rolling = there & ((flags & (int)MANIFOLD_ROLLS) != 0);
	}
	ContactPoints points;
	if (LANES > 1 || !lane_bits(has_rolling))
		points = contact_points_held(a, b, manifold);
	if (lane_bits(has_rolling))
	{
		Int feature[2];
		feature[0] = gather_int((const GLOBAL int*)p->contact_feature, 2 * slot);
		feature[1] = gather_int((const GLOBAL int*)p->contact_feature, 2 * slot + 1);
		ContactPoints rolling =
		    rolling_step(p, a, b, manifold, flags, feature, load(&contact_row(p, normal_impulse1, i), 0),
		                 load(&contact_row(p, normal_impulse2, i), 0), &points);
		points = LANES > 1 ? contact_points_blend(points, rolling, has_rolling) : rolling;
	}
	Vec zero = vec(splat(0.0f), splat(0.0f));
	points.normal = vec_blend(zero, points.normal, there);
	points.offset = vec_blend(zero, points.offset, there);
	for (int k = 0; k < 2; ++k)
	{
		points.anchor[k] = vec_blend(zero, points.anchor[k], there);
		points.separation[k] = blend(splat(NO_POINT), points.separation[k], there);
	}
	prepare_depth(p, slot, minimum(points.separation[0], points.separation[1]));
	prepare_press(p, i, minimum(points.separation[0], points.separation[1]));
	return points;
}

#define PREPARE_SOON 32 // number of constraints between the one being prepared and the one whose data is prefetched

INLINE void contact_prepare_fetch(const Pools* p, int i)
{
	int soon = FETCHES && p->step.collidables >= FETCH_COLLIDABLES ? i + PREPARE_SOON + LANES : 0;
	for (int k = i + PREPARE_SOON; k < soon && k < p->counters->layout[CONSTRAINT_CONTACT].begin[COLORS + 1]; ++k)
	{
		int slot = p->contact_place_slot[k];
		Int2 pair = p->contact_place_pair[k];
		fetch_soon(p->contact_manifold + (slot & ~(slot >> 31)));
		fetch_soon(p->world_shape + pair.x);
		fetch_soon(p->world_shape + pair.y);
	}
}

// Computes all prepared rows of constraint i, except the rare ones. slot is -1 for padding.
INLINE void contact_setup(const Pools* p, int i, Int slot, Contact* u)
{
	contact_prepare_fetch(p, i);
	ContactPoints points = prepare_points(p, i, slot);
	u->normal_x = points.normal.x;
	u->normal_y = points.normal.y;
	u->offset_x = points.offset.x;
	u->offset_y = points.offset.y;
	u->anchor1_x = points.anchor[0].x;
	u->anchor1_y = points.anchor[0].y;
	u->anchor2_x = points.anchor[1].x;
	u->anchor2_y = points.anchor[1].y;
	u->separation1 = points.separation[0];
	u->separation2 = points.separation[1];
}

#endif
