// SPDX-License-Identifier: MIT
// prepare.h -- the points of contacts for the step, to where the passes stream them.
#ifndef PREPARE_H
#define PREPARE_H
#include "stages/contact_points.h"

// the deepest overlap seen, for the user's counters
INLINE void prepare_depth(const Pools* p, Real separation)
{
	Word deeper = lane_bits(separation < splat(bits_float(read_shared(&p->counters->penetration)) * -1.0f));
	for (int k = 0; deeper >> k != 0; ++k)
		if (deeper >> k & 1)
			atomic_max_int(&p->counters->penetration, float_bits(-lane(separation, k)));
}

// As if all were held and none bounced; prepare_extra sees to those that are not or do. Padding stays inert.
WIDE_STAGE(prepare)
{
	Int slot = load_int(p->constraint_contact, i), ia, ib;
	load_int2(p->constraint_pair, i, &ia, &ib);
	Int there = slot >= 0;
	slot = slot & ~(slot >> 31);
	Real a[8], b[8], found[16];
	gather_rows8((GLOBAL float*)p->placed, ia, a);
	gather_rows8((GLOBAL float*)p->placed, ib, b);
	gather_rows8((GLOBAL float*)p->contact_found, 2 * slot, found);
	gather_rows8((GLOBAL float*)p->contact_found, 2 * slot + 1, found + 8);
	ContactPoints points = contact_points_held(a, b, found);
	Real zero = splat(0.0f);
	Real separation1 = choose(splat(NO_POINT), points.separation[0], there),
	     separation2 = choose(splat(NO_POINT), points.separation[1], there);
	store(&constraint_at(p, normal_x, i), 0, choose(zero, points.normal.x, there));
	store(&constraint_at(p, normal_y, i), 0, choose(zero, points.normal.y, there));
	store(&constraint_at(p, offset_x, i), 0, choose(zero, points.offset.x, there));
	store(&constraint_at(p, offset_y, i), 0, choose(zero, points.offset.y, there));
	store(&constraint_at(p, anchor1_x, i), 0, choose(zero, points.anchor[0].x, there));
	store(&constraint_at(p, anchor1_y, i), 0, choose(zero, points.anchor[0].y, there));
	store(&constraint_at(p, anchor2_x, i), 0, choose(zero, points.anchor[1].x, there));
	store(&constraint_at(p, anchor2_y, i), 0, choose(zero, points.anchor[1].y, there));
	store(&constraint_at(p, separation1, i), 0, separation1);
	store(&constraint_at(p, separation2, i), 0, separation2);
	if (!p->step.round)
		prepare_depth(p, minimum(separation1, separation2));
}

#endif
