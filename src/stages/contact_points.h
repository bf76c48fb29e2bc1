// SPDX-License-Identifier: MIT
// contact_points.h -- normal, arms and gaps of a contact for the step, from a manifold that is held as it was found.
//
// A manifold that is held keeps its normal and its arms in the world, whatever bodies have turned and shifted since; the
// gap alone follows them. So the forces of a column that leans a little go straight down through it as before, and it does
// not buckle. A contact gives way like a spring: with arms that follow, a column of more than 28 boxes would (A. G.
// Greenhill, Determination of the greatest height consistent with stability that a vertical pole or mast can be made,
// 1881).
#ifndef CONTACT_POINTS_H
#define CONTACT_POINTS_H
#include "pools/pools.h"
#include "stages/vec.h"

typedef struct // world axes
{
	Vec normal;          // from a to b
	Vec point[2];        // halfway between the surfaces, from the origin of collidable a, m
	Vec anchor[2];       // from the center of mass of a, m
	Vec offset;          // m: what an anchor from the center of mass of b has more
	float separation[2]; // m
} ContactPoints;

// how far a point at an arm from the center of mass goes when its body turns
INLINE Vec contact_points_swing(Vec turn, Vec arm) { return vec_sub(vec_turn(turn, arm), arm); }

// The two places of a point were one when it was found. How far they have parted along the normal since is added to the
// separation. The solver turns arms by what bodies turn in the step; where the poses are still to come, that much less
// is the separation.
INLINE ContactPoints contact_points_held(Placed a, Placed b, Found found)
{
	Vec axes_a = vec(a.c, a.s), axes_b = vec(b.c, b.s), from_a = vec(b.x - a.x, b.y - a.y);
	Vec then_a = vec(found.then.x, found.then.y), shift = vec(found.relative.x, found.relative.y),
	    turn = vec(found.relative.z, found.relative.w);
	Vec then_b = vec_turn(then_a, turn);
	Vec turned_a = vec_turn_back(axes_a, then_a), turned_b = vec_turn_back(axes_b, then_b);
	Vec center_a = vec_turn(turned_a, vec(a.center_x, a.center_y)),
	    center_b = vec_turn(turned_b, vec(b.center_x, b.center_y));
	int ahead = float_bits(found.then.z) & FOUND_AHEAD;
	Vec on_a[2];
	float separation[2] = {found.normal.z, found.normal.w};
	on_a[0] = vec(found.on_a.x, found.on_a.y);
	on_a[1] = vec(found.on_a.z, found.on_a.w);
	ContactPoints points;
	points.normal = vec_turn(then_a, vec(found.normal.x, found.normal.y));
	points.offset = vec_sub(center_a, vec_add(vec_turn(then_a, shift), center_b));
	for (int k = 0; k < 2; ++k)
	{
		Vec at_a = vec_turn(axes_a, on_a[k]);
		Vec at_b = vec_add(from_a, vec_turn(axes_b, vec_turn_back(turn, vec_sub(on_a[k], shift))));
		points.point[k] = vec_scale(0.5f, vec_add(at_a, at_b));
		points.anchor[k] = vec_sub(vec_turn(then_a, on_a[k]), center_a);
		Vec parted = vec_sub(at_b, at_a);
		if (ahead)
		{
			Vec arm_a = points.anchor[k], arm_b = vec_add(arm_a, points.offset);
			Vec arm_a_now = vec_turn_back(turned_a, arm_a), arm_b_now = vec_turn_back(turned_b, arm_b);
			Vec more_a = vec_sub(contact_points_swing(turned_a, arm_a), contact_points_swing(turned_a, arm_a_now));
			Vec more_b = vec_sub(contact_points_swing(turned_b, arm_b), contact_points_swing(turned_b, arm_b_now));
			parted = vec_sub(parted, vec_sub(more_b, more_a));
		}
		points.separation[k] = separation[k] + vec_dot(points.normal, parted);
	}
	return points;
}

#endif
