// SPDX-License-Identifier: MIT
// contact_points.h -- where the points of a contact are now, from the places on its two collidables where they were found.
#ifndef CONTACT_POINTS_H
#define CONTACT_POINTS_H
#include "pools/pools.h"
#include "stages/vec.h"

typedef struct // world axes
{
	Vec normal;          // from a to b
	Vec point[2];        // halfway between the surfaces, from the origin of collidable a, m
	float separation[2]; // m
} ContactPoints;

// The two places of a point were one when it was found. How far they have parted along the normal since is added to the
// separation: exact while nothing turns, and to the second order of a small turn.
INLINE ContactPoints contact_points(Placed a, Placed b, Found found)
{
	Float4 normal = found.normal, on_a = found.on_a, on_b = found.on_b;
	Vec turn_a = vec(a.c, a.s), turn_b = vec(b.c, b.s), from_a = vec(b.x - a.x, b.y - a.y);
	ContactPoints points;
	points.normal = vec_turn(turn_a, vec(normal.x, normal.y));
	Vec a0 = vec_turn(turn_a, vec(on_a.x, on_a.y)), b0 = vec_add(from_a, vec_turn(turn_b, vec(on_b.x, on_b.y)));
	Vec a1 = vec_turn(turn_a, vec(on_a.z, on_a.w)), b1 = vec_add(from_a, vec_turn(turn_b, vec(on_b.z, on_b.w)));
	points.point[0] = vec_scale(0.5f, vec_add(a0, b0));
	points.point[1] = vec_scale(0.5f, vec_add(a1, b1));
	points.separation[0] = normal.z + vec_dot(points.normal, vec_sub(b0, a0));
	points.separation[1] = normal.w + vec_dot(points.normal, vec_sub(b1, a1));
	return points;
}

#endif
