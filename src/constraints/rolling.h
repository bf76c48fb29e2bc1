// SPDX-License-Identifier: MIT
// rolling.h -- computes normal, arms and gaps of a round contact, which follow the motion of its bodies.
//
// A contact point lies at a corner of one core, and on an edge or at a corner of the other. Corner, edge and the
// poses of the bodies are the complete state, so no stored point of a surface lags behind a roller.
//
// The forces of a step act along the normal while the bodies move on. Let k, the stiffness of a roller, be its load
// divided by mass and radius. If the normal is computed for the time s of the step, from 0 to 1, a step of N substeps
// multiplies position and velocity by a matrix with the determinant 1 + ((N - 1) / (2 N) - s) k dt^2: at s = 0 the
// roller gains energy, at s = 1 it loses some. Therefore the poses at the end of the step are used. If k dt^2 is too
// large, as for a small body under a heap, the contact points are a mean of points that follow the bodies and held
// points (contact_points.h).
#ifndef ROLLING_H
#define ROLLING_H
#include "constraints/contact_points.h"
#include "constraints/sweep_closing.h"

// Maximum of k dt^2 up to which a contact follows its bodies fully; small, because bodies have several contacts.
#define ROLLING_STIFFNESS 0.3f

// Rolling resistance: maximum distance of the load ahead of the center, in units of the reach. It is a coefficient of
// 1e-4, a tenth of that of steel. Below this limit, the resistance removes the share ROLLING_TURN of the relative
// rotation in each step; with a smaller share, bodies would creep down slopes that are too slight for rolling.
#define ROLLING_LEVER 1.0e-4f
#define ROLLING_TURN  0.3f
#define ROLLING_LIGHT 0.003f // minimum of k dt^2 in the resistance; it limits how hard lightly loaded bodies are braked

// Maximum that is added to ROLLING_LEVER, for a stiff contact whose points are held: its points are sometimes
// recomputed, which makes the body swing.
#define ROLLING_STIFF_LEVER 0.05f

typedef struct // motion of a body until the end of the step; positions are relative to the origin of collidable a
{
	Vec center, then; // center of mass, now and at the end of the step, m
	Vec turn;         // cos, sin of the angle
	Real angle;       // rad: turn of the body
	Vec axes;         // rotation of its collidable now
	Vec origin;       // origin of its collidable now, m
} Rolling;

INLINE Rolling rolling_of(Vec origin, const Real world_shape[8], Advance advance)
{
	Rolling r;
	r.origin = origin;
	r.axes = vec(world_shape[2], world_shape[3]);
	r.center = vec_add(origin, vec(world_shape[4], world_shape[5]));
	r.then = vec_add(r.center, advance.path);
	r.turn = vec_rotation(advance.turn);
	r.angle = advance.turn;
	return r;
}

// Returns the arm from the center of mass to a point of the collidable, as it will be at the end of the step.
INLINE Vec rolling_arm(Rolling r, Vec place)
{
	return vec_turn(r.turn, vec_add(vec_sub(r.origin, r.center), vec_turn(r.axes, place)));
}

// Returns the displacement that the solver computes for the point at an arm.
INLINE Vec rolling_moves(Rolling r, Vec arm) { return vec_add(vec_sub(r.then, r.center), vec_spin(r.angle, arm)); }

// Returns the corner that a feature names; `point`, which is less exact, if the feature names none or `wanted` is 0.
INLINE Vec rolling_corner(const GLOBAL Attribute* shapes, Int shape, Int name, Vec point, Int wanted)
{
	Int vertex = shape * (int)(sizeof(Attribute) / sizeof(float)) + 2 * (name & (MAX_CORNERS - 1));
	const GLOBAL float* vertices = (const GLOBAL float*)shapes->vertices;
	return vec_blend(point, vec(gather(vertices, vertex), gather(vertices, vertex + 1)), wanted & (name < MAX_CORNERS));
}

// Returns the points of a round contact at the end of the step. a, b: WorldShape rows; manifold: LocalManifold rows.
INLINE ContactPoints rolling_points(const GLOBAL Attribute* shapes, const Real a[8], const Real b[8],
                                    const Real manifold[16], Int flags, const Int feature[2], Advance advance_a,
                                    Advance advance_b)
{
	Int shape_a = real_bits(a[6]), shape_b = real_bits(b[6]);
	Real radius_a = sweep_shape(&shapes->radius, shape_a), radius_b = sweep_shape(&shapes->radius, shape_b);
	Vec zero = vec(splat(0.0f), splat(0.0f));
	Rolling ra = rolling_of(zero, a, advance_a), rb = rolling_of(vec(b[0] - a[0], b[1] - a[1]), b, advance_b);
	Vec normal = vec(manifold[0], manifold[1]), shift = vec(manifold[8], manifold[9]),
	    turn = vec(manifold[10], manifold[11]);
	Int corners = (flags & (int)MANIFOLD_CORNERS) != 0, turns_b = (flags & (int)MANIFOLD_TURNS_B) != 0;
	ContactPoints points;
	Vec now = vec_turn(ra.axes, normal); // current normal
	points.normal =
	    vec_blend(vec_turn(ra.turn, now), vec_turn(rb.turn, vec_turn(rb.axes, vec_turn_back(turn, normal))), turns_b);
	points.offset = vec_sub(ra.then, rb.then);
	for (int k = 0; k < 2; ++k)
	{
		Int corner_a = (flags & (int)(k ? MANIFOLD_CORNER2 : MANIFOLD_CORNER1)) != 0, by_a = corner_a | corners;
		Int missing = manifold[2 + k] == splat(NO_POINT);
		Real above = 0.5f * manifold[2 + k]; // m: half of the separation; the point is midway between the surfaces
		Vec place = vec(manifold[4 + 2 * k], manifold[5 + 2 * k]);
		Vec core_a = vec_sub(place, vec_scale(radius_a + above, normal));
		Vec core_b = vec_turn_back(turn, vec_sub(vec_add(place, vec_scale(radius_b + above, normal)), shift));
		core_a = rolling_corner(shapes, shape_a, feature[k] >> 8 & 255, core_a, by_a);
		core_b = rolling_corner(shapes, shape_b, feature[k] & 255, core_b, corner_a == 0);
		Vec arm_a = rolling_arm(ra, core_a), arm_b = rolling_arm(rb, core_b);
		Vec between = vec_sub(vec_sub(arm_b, arm_a), points.offset);
		if (k == 0)
		{
			// for two corners, the normal is the direction from a to b, if this is within 60 degrees of `now`
			Real square = vec_dot(between, between);
			Int apart = square >= splat(ABSORBS);
			Vec direction = vec_scale(quotient(1.0f, root(blend(splat(1.0f), square, apart))), between);
			direction = vec_blend(now, direction, apart & (vec_dot(direction, now) > splat(0.5f)));
			points.normal = vec_blend(points.normal, direction, corners);
		}
		Real gap = vec_dot(points.normal, between) - radius_a - radius_b;

		// anchors are computed from the center of the body that has the corner: the center of the other may be far away
		Vec from_a = vec_add(arm_a, vec_scale(radius_a + 0.5f * gap, points.normal));
		Vec from_b = vec_sub(vec_sub(arm_b, vec_scale(radius_b + 0.5f * gap, points.normal)), points.offset);
		arm_a = vec_blend(from_b, from_a, by_a);
		if (k == 1)
			arm_a = vec_blend(arm_a, points.anchor[0], missing);
		gap = blend(gap, splat(NO_POINT), missing);
		points.anchor[k] = arm_a;
		points.point[k] = vec_add(ra.then, arm_a);
		Vec parts = vec_sub(rolling_moves(rb, vec_add(arm_a, points.offset)), rolling_moves(ra, arm_a));
		points.separation[k] = gap - vec_dot(points.normal, parts);
	}
	return points;
}

INLINE Vec rolling_between(Vec a, Vec b, Real share) { return vec_add(a, vec_scale(share, vec_sub(b, a))); }

// Returns the points of a contact for the step; load1, load2: N s, normal impulses of the points in a substep. still: the
// held points, which the caller of a wide kernel has computed for other lanes; with one lane they are computed here.
INLINE ContactPoints rolling_step(const Pools* p, const Real a[8], const Real b[8], const Real manifold[16], Int flags,
                                  const Int feature[2], Real load1, Real load2, const ContactPoints* still)
{
	Real body_a[8], body_b[8];
	gather_fixed_rows8((GLOBAL float*)p->body, real_bits(a[7]), body_a);
	gather_fixed_rows8((GLOBAL float*)p->body, real_bits(b[7]), body_b);
	Advance advance_a = sweep_advance_of(&p->step, vec(body_a[0], body_a[1]), body_a[2]),
	        advance_b = sweep_advance_of(&p->step, vec(body_b[0], body_b[1]), body_b[2]);
	ContactPoints points = rolling_points(p->attribute, a, b, manifold, flags, feature, advance_a, advance_b);
	Real load = load1 + load2;
	Int loaded = load > splat(0.0f);
	if (!lane_bits(loaded))
		return points;

	// a body that rests on two points does not roll: the more equally they carry the load, the more the contact is held
	Real share = quotient(absolute(load1 - load2), load);
	Real reach =
	    minimum(sweep_shape(&p->attribute->reach, real_bits(a[6])), sweep_shape(&p->attribute->reach, real_bits(b[6])));
	Real mobility = body_a[3] + body_b[3] + reach * reach * (body_a[7] + body_b[7]);
	Real stiffness = quotient(p->step.dt * p->step.dt * p->step.inv_h * load * mobility, reach);
	Int stiff = stiffness > splat(ROLLING_STIFFNESS);
	Real follows = quotient(ROLLING_STIFFNESS, stiffness);
	share = blend(share, share * follows, stiff);

	// shift of the points along the tangent: the load opposes the relative rotation, but does not reverse it
	Real rate = quotient(ROLLING_TURN, maximum(stiffness, splat(ROLLING_LIGHT)));
	Real turn = (advance_b.turn - advance_a.turn) * rate;
	Real most = blend(splat(ROLLING_LEVER), ROLLING_LEVER + ROLLING_STIFF_LEVER * (1.0f - follows), stiff);
	Real lever = -reach * minimum(maximum(turn, -most), most);
	Vec along = vec_scale(lever, vec(points.normal.y, -points.normal.x));
	ContactPoints held = LANES > 1 ? *still : contact_points_held(a, b, manifold), both = points;
	both.normal = rolling_between(held.normal, points.normal, share);
	both.offset = rolling_between(held.offset, points.offset, share);
	for (int k = 0; k < 2; ++k)
	{
		both.anchor[k] = vec_add(rolling_between(held.anchor[k], points.anchor[k], share), along);
		both.separation[k] = held.separation[k] + share * (points.separation[k] - held.separation[k]);
	}
	return contact_points_blend(points, both, loaded);
}

#endif
