// SPDX-License-Identifier: MIT
// contact_points.h -- computes normal, arms and gaps of a contact for the step from a manifold that is held.
//
// A held manifold keeps its normal and its arms in the world while bodies turn and shift; only the gap follows them. So
// the forces of a leaning column still act straight down through it. A contact yields like a spring: with arms that
// follow the bodies, a column of more than 28 boxes would buckle (A. G. Greenhill, Determination of the greatest height
// consistent with stability that a vertical pole or mast can be made, 1881).
#ifndef CONTACT_POINTS_H
#define CONTACT_POINTS_H
#include "constraints/angle.h"
#include "dialect/vec.h"
#include "pools/pools.h"

typedef struct // the points of a contact, along world axes
{
	Vec normal;    // normal from collidable a to collidable b
	Vec point[2];  // m: points midway between the surfaces, relative to the origin of collidable a
	Vec anchor[2]; // m: arms from the center of mass of body a to the points; for a held manifold, the held arms
	Vec offset;    // m: from the center of mass of body b to that of a; anchor + offset is the anchor relative to b
	Real separation[2]; // m: negative for an overlap
} ContactPoints;

INLINE ContactPoints contact_points_blend(ContactPoints a, ContactPoints b, Int c)
{
	a.normal = vec_blend(a.normal, b.normal, c);
	a.offset = vec_blend(a.offset, b.offset, c);
	for (int k = 0; k < 2; ++k)
	{
		a.point[k] = vec_blend(a.point[k], b.point[k], c);
		a.anchor[k] = vec_blend(a.anchor[k], b.anchor[k], c);
		a.separation[k] = blend(a.separation[k], b.separation[k], c);
	}
	return a;
}

// Returns the displacement that the solver (body_shift) computes for the end of an arm, minus the true displacement, m.
// turn, angle: rotation of the body; arm: arm after this rotation.
INLINE Vec contact_points_predicted(Vec turn, Real angle, Vec arm)
{
	return vec_sub(vec_spin(angle, arm), vec_sub(arm, vec_turn_back(turn, arm)));
}

// Computes the points from rows of world_shape and from both rows of contact_manifold. At the poses of the manifold,
// the places of a point on both shapes coincide; their current distance along the normal is added to the separation.
// For a predicted manifold (future poses), the error of the solver (contact_points_predicted) is subtracted.
INLINE ContactPoints contact_points_held(const Real a[8], const Real b[8], const Real manifold[16])
{
	Vec axes_a = vec(a[2], a[3]), axes_b = vec(b[2], b[3]), from_a = vec(b[0] - a[0], b[1] - a[1]);
	Vec normal = vec(manifold[0], manifold[1]), shift = vec(manifold[8], manifold[9]),
	    turn = vec(manifold[10], manifold[11]), then_a = vec(manifold[12], manifold[13]);
	Vec then_b = vec_turn(then_a, turn);
	Vec turned_a = vec_turn_back(axes_a, then_a), turned_b = vec_turn_back(axes_b, then_b);
	Vec center_a = vec_turn(turned_a, vec(a[4], a[5])), center_b = vec_turn(turned_b, vec(b[4], b[5]));
	Int ahead = manifold[15] < splat(0.0f);
	// computed before the loop: inside it, gcc unrolls the loop too late to keep the points in registers
	Real angle_a = splat(0.0f), angle_b = angle_a;
	if (lane_bits(ahead))
	{
		angle_a = vec_angle(turned_a);
		angle_b = vec_angle(turned_b);
	}
	ContactPoints points;
	points.normal = vec_turn(then_a, normal);
	points.offset = vec_sub(center_a, vec_add(vec_turn(then_a, shift), center_b));
	for (int k = 0; k < 2; ++k)
	{
		Vec on_a = vec(manifold[4 + 2 * k], manifold[5 + 2 * k]);
		Vec at_a = vec_turn(axes_a, on_a);
		Vec at_b = vec_add(from_a, vec_turn(axes_b, vec_turn_back(turn, vec_sub(on_a, shift))));
		points.point[k] = vec_scale(splat(0.5f), vec_add(at_a, at_b));
		points.anchor[k] = vec_sub(vec_turn(then_a, on_a), center_a);
		Vec parted = vec_sub(at_b, at_a);
		if (lane_bits(ahead))
		{
			Vec arm_a = points.anchor[k], arm_b = vec_add(arm_a, points.offset);
			Vec less = vec_sub(parted, vec_sub(contact_points_predicted(turned_b, angle_b, arm_b),
			                                   contact_points_predicted(turned_a, angle_a, arm_a)));
			parted = vec_blend(parted, less, ahead);
		}
		points.separation[k] = manifold[2 + k] + vec_dot(points.normal, parted);
	}
	return points;
}

#endif
