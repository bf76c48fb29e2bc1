// SPDX-License-Identifier: MIT
// contact_points.h -- where the points of a contact are now, from the places on its two collidables where they were found.
#ifndef CONTACT_POINTS_H
#define CONTACT_POINTS_H
#include "pools/pools.h"
#include "stages/vec.h"

typedef struct // world axes
{
	Vec normal;   // from a to b
	Vec point[2]; // halfway between the surfaces, from the origin of collidable a, m
	Vec apart;    // m: from the places on a to those on b, when bodies have yet to turn and go to where they were found
	float separation[2]; // m
} ContactPoints;

// The place at r from the center of mass of a body that has yet to turn: where it is when it has.
INLINE Vec contact_points_turned(Vec center, Vec turn, Vec place)
{
	return vec_add(center, vec_turn(turn, vec_sub(place, center)));
}

// Points of bodies that have yet to meet. Arms are those of the moment when they do, or else the impulse would not keep
// the angular momentum; then the two places of each point are as far apart as the bodies have to go. The solver turns
// arms by what bodies have turned since the step began: that much less is the separation.
INLINE void contact_points_ahead(ContactPoints* points, Placed a, Placed b, Found found, Vec a0, Vec b0, Vec a1, Vec b1)
{
	Vec turn_a = vec_rotation(found.relative.y), turn_b = vec_rotation(found.relative.z);
	Vec center_a = vec(a.center_x, a.center_y), center_b = vec(b.x - a.x + b.center_x, b.y - a.y + b.center_y);
	Vec at_a[2], at_b[2];
	Real separation[2] = {found.normal.z, found.normal.w};
	at_a[0] = contact_points_turned(center_a, turn_a, a0);
	at_a[1] = contact_points_turned(center_a, turn_a, a1);
	at_b[0] = contact_points_turned(center_b, turn_b, b0);
	at_b[1] = contact_points_turned(center_b, turn_b, b1);
	for (int k = 0; k < 2; ++k)
	{
		Vec more_a = vec_sub(contact_points_turned(center_a, turn_a, at_a[k]), at_a[k]);
		Vec more_b = vec_sub(contact_points_turned(center_b, turn_b, at_b[k]), at_b[k]);
		Vec to_go = vec_sub(vec_sub(at_b[k], at_a[k]), vec_sub(more_b, more_a));
		points->point[k] = vec_scale(0.5f, vec_add(at_a[k], at_b[k]));
		points->separation[k] = separation[k] + vec_dot(points->normal, to_go);
	}
	points->apart = vec_sub(at_b[0], at_a[0]);
}

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
	points.apart = vec(0.0f, 0.0f);
	if (found.relative.x == NO_POINT)
		contact_points_ahead(&points, a, b, found, a0, b0, a1, b1);
	return points;
}

#endif
