// SPDX-License-Identifier: MIT
// contact_report_points.h -- computes the points of a contact at the start of the last step, as reported to the user.
#ifndef CONTACT_REPORT_POINTS_H
#define CONTACT_REPORT_POINTS_H
#include "constraints/rolling.h"

// Returns the color of a contact as reported: COLOR_NONE for one that sleeps.
INLINE int contact_report_color(int color) { return maximum(color, COLOR_NONE); }

// Computes the points at the current poses, relative to the origin of collidable a. a, b: WorldShape rows.
INLINE ContactPoints contact_report_points(const GLOBAL Attribute* shapes, const Real a[8], const Real b[8],
                                           const Real manifold[16], Word flags, Int2 features)
{
	const Advance rests = {{0.0f, 0.0f}, 0.0f};
	Int feature[2];
	feature[0] = features.x;
	feature[1] = features.y;
	if (flags & MANIFOLD_ROLLS)
		return rolling_points(shapes, a, b, manifold, (Int)flags, feature, rests, rests);
	return contact_points_held(a, b, manifold);
}

// Writes normal, points and separations to a report. x, y: m, origin of collidable a in the world.
INLINE void contact_report_place(ContactReport* row, const ContactPoints* at, Real x, Real y)
{
	row->normal_x = at->normal.x;
	row->normal_y = at->normal.y;
	row->point = make_float4(x + at->point[0].x, y + at->point[0].y, x + at->point[1].x, y + at->point[1].y);
	row->separation1 = at->separation[0];
	row->separation2 = at->separation[1];
}

#endif
